# Finds GLM and defines glm::glm: its own CMake package, or else its headers alone, such as those
# that scripts/gpu-check carries to a machine without the package.
find_package(glm CONFIG QUIET)
if(NOT TARGET glm::glm)
  find_path(glm_INCLUDE_DIR glm/glm.hpp)
  mark_as_advanced(glm_INCLUDE_DIR)
  include(FindPackageHandleStandardArgs)
  find_package_handle_standard_args(glm REQUIRED_VARS glm_INCLUDE_DIR)
  if(glm_FOUND)
    add_library(glm::glm INTERFACE IMPORTED)
    target_include_directories(glm::glm INTERFACE ${glm_INCLUDE_DIR})
  endif()
endif()
