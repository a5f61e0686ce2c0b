# cmake --install, and find_package(rtob) from the installed tree.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/rtob")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/rtobConfig.cmake.in" "${PROJECT_BINARY_DIR}/rtobConfig.cmake"
  INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/rtobConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(EXPORT rtob-targets NAMESPACE rtob:: DESTINATION ${package_dir})
install(
  FILES "${PROJECT_BINARY_DIR}/rtobConfig.cmake" "${PROJECT_BINARY_DIR}/rtobConfigVersion.cmake"
        "${CMAKE_CURRENT_LIST_DIR}/FindRtobMrpt.cmake" "${CMAKE_CURRENT_LIST_DIR}/FindRtobOpenCV.cmake"
  DESTINATION ${package_dir})
