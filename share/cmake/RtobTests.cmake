# One GoogleTest program from all test_*.cpp of a folder.
include(GoogleTest)

# rtob_add_tests(rtob-core-tests FOLDER unit/core LINK targets... [DEFINITIONS NAME="value" ...]
#                [REAL_TIME])
# Nothing is added for a folder without tests. REAL_TIME: they judge times by the clock on the wall,
# so nothing runs beside them.
function(rtob_add_tests name)
  cmake_parse_arguments(arg "REAL_TIME" "FOLDER" "LINK;DEFINITIONS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${arg_FOLDER}/test_*.cpp")
  if(NOT sources)
    return()
  endif()
  add_executable(${name} ${sources})
  rtob_configure_target(${name})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests/support")
  target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gmock_main)
  # Listing the tests loads MRPT and OpenCV, which takes long on a busy machine or with sanitizers.
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 120
                       PROPERTIES TIMEOUT 300 RUN_SERIAL "${arg_REAL_TIME}")
endfunction()
