# Finds doctest and defines doctest::doctest: its own CMake package, or else doctest/doctest.h and
# doctest/doctest.cmake as scripts/gpu-check carries them. Afterwards include(doctest) works.
find_package(doctest CONFIG QUIET)
if(NOT TARGET doctest::doctest)
  find_path(doctest_INCLUDE_DIR doctest/doctest.cmake)
  mark_as_advanced(doctest_INCLUDE_DIR)
  include(FindPackageHandleStandardArgs)
  find_package_handle_standard_args(doctest REQUIRED_VARS doctest_INCLUDE_DIR)
  if(doctest_FOUND)
    add_library(doctest::doctest INTERFACE IMPORTED)
    target_include_directories(doctest::doctest INTERFACE ${doctest_INCLUDE_DIR})
    list(APPEND CMAKE_MODULE_PATH ${doctest_INCLUDE_DIR}/doctest)
  endif()
endif()
