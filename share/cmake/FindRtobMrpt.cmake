# MRPT's modules under one set of names, mrpt::maps and so on. MRPT 2 has packages "mrpt-maps" with
# these targets; MRPT 3 has "mrpt_maps" with mrpt::mrpt_maps.
# Usage: find_package(RtobMrpt REQUIRED COMPONENTS maps slam)
include(FindPackageHandleStandardArgs)

foreach(module IN LISTS RtobMrpt_FIND_COMPONENTS)
  find_package(mrpt-${module} QUIET)
  if(NOT TARGET mrpt::${module})
    find_package(mrpt_${module} QUIET)
    if(TARGET mrpt::mrpt_${module})
      add_library(mrpt::${module} INTERFACE IMPORTED)
      target_link_libraries(mrpt::${module} INTERFACE mrpt::mrpt_${module})
    endif()
  endif()
  if(TARGET mrpt::${module})
    set(RtobMrpt_${module}_FOUND TRUE)
  endif()
endforeach()

find_package_handle_standard_args(RtobMrpt HANDLE_COMPONENTS
  REASON_FAILURE_MESSAGE "Debian's packages are libmrpt-<module>-dev")
