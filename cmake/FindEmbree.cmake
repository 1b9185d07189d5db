# Finds Embree 3 or 4 and defines Embree::Embree.
#
# Debian 12 ships Embree 3 and Ubuntu 24.04 Embree 3 or 4; their own package files name the versions
# differently, so header and library are looked for directly. The imported target defines
# HAARLIGHT_EMBREE_VERSION as 3 or 4.
find_path(Embree_INCLUDE_DIR NAMES embree4/rtcore.h embree3/rtcore.h)
find_library(Embree_LIBRARY NAMES embree4 embree3)
if(Embree_LIBRARY MATCHES "embree4" AND EXISTS "${Embree_INCLUDE_DIR}/embree4/rtcore.h")
  set(Embree_VERSION 4)
elseif(EXISTS "${Embree_INCLUDE_DIR}/embree3/rtcore.h")
  set(Embree_VERSION 3)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Embree REQUIRED_VARS Embree_LIBRARY Embree_INCLUDE_DIR Embree_VERSION)
mark_as_advanced(Embree_INCLUDE_DIR Embree_LIBRARY)

if(Embree_FOUND AND NOT TARGET Embree::Embree)
  add_library(Embree::Embree UNKNOWN IMPORTED)
  set_target_properties(Embree::Embree PROPERTIES
    IMPORTED_LOCATION "${Embree_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Embree_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS "HAARLIGHT_EMBREE_VERSION=${Embree_VERSION}")
endif()
