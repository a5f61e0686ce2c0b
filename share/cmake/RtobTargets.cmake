# How every library, program and test of the project is built: one function each.

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")

# Warnings, language level and sanitizers of one of our targets.
function(rtob_configure_target target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
    $<$<BOOL:${RTOB_WERROR}>:-Werror>
    # One SIMD level gives one result: the compiler must not fuse a*b+c where it likes.
    -ffp-contract=off
    $<$<CONFIG:Debug>:-D_DEBUG>)
  if(RTOB_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${RTOB_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all
                                             -D_GLIBCXX_ASSERTIONS
                                             # gcc 12 is wrong about std::string and std::regex so
                                             # compiled.
                                             $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
                                             $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(${target} PUBLIC -fsanitize=${RTOB_SANITIZE})
  endif()
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF
    POSITION_INDEPENDENT_CODE ON
    INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}:$ORIGIN")
endfunction()

# rtob_add_library(rtob-core [SHARED] SOURCES a.cpp ... [LINK targets...] [LINK_PRIVATE targets...])
# Headers are in include/rtob/<part>/; others link rtob::core.
function(rtob_add_library name)
  cmake_parse_arguments(arg "SHARED" "" "SOURCES;LINK;LINK_PRIVATE" ${ARGN})
  set(kind STATIC)
  if(arg_SHARED)
    set(kind SHARED)
  endif()
  string(REPLACE "rtob-" "" part ${name})
  add_library(${name} ${kind} ${arg_SOURCES})
  add_library(rtob::${part} ALIAS ${name})
  rtob_configure_target(${name})
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_LINK_PRIVATE})
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${part})
  install(TARGETS ${name} EXPORT rtob-targets)
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# rtob_add_program(target OUTPUT name SOURCES a.cpp ... LINK targets...)
function(rtob_add_program target)
  cmake_parse_arguments(arg "" "OUTPUT" "SOURCES;LINK" ${ARGN})
  add_executable(${target} ${arg_SOURCES})
  rtob_configure_target(${target})
  target_link_libraries(${target} PRIVATE ${arg_LINK})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${arg_OUTPUT})
  install(TARGETS ${target})
endfunction()
