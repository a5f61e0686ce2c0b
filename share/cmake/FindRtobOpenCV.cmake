# OpenCV's targets opencv_core, opencv_imgproc, ... also where only the single -dev packages are
# installed: Debian ships OpenCVConfig.cmake in libopencv-dev alone, which pulls in Qt, VTK and more.
# Usage: find_package(RtobOpenCV REQUIRED COMPONENTS core imgproc)
include(FindPackageHandleStandardArgs)

find_package(OpenCV QUIET COMPONENTS ${RtobOpenCV_FIND_COMPONENTS})
find_path(RtobOpenCV_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
mark_as_advanced(RtobOpenCV_INCLUDE_DIR)

foreach(module IN LISTS RtobOpenCV_FIND_COMPONENTS)
  if(NOT TARGET opencv_${module})
    find_library(RtobOpenCV_${module}_LIBRARY opencv_${module})
    mark_as_advanced(RtobOpenCV_${module}_LIBRARY)
    if(RtobOpenCV_${module}_LIBRARY)
      add_library(opencv_${module} UNKNOWN IMPORTED)
      set_target_properties(opencv_${module} PROPERTIES
        IMPORTED_LOCATION "${RtobOpenCV_${module}_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${RtobOpenCV_INCLUDE_DIR}")
      if(NOT module STREQUAL "core")
        target_link_libraries(opencv_${module} INTERFACE opencv_core)
      endif()
    endif()
  endif()
  if(TARGET opencv_${module})
    set(RtobOpenCV_${module}_FOUND TRUE)
  endif()
endforeach()

find_package_handle_standard_args(RtobOpenCV
  REQUIRED_VARS RtobOpenCV_INCLUDE_DIR HANDLE_COMPONENTS
  REASON_FAILURE_MESSAGE "Debian's packages are libopencv-<module>-dev")
