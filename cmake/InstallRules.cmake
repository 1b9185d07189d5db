# Installs the program, the libraries, their headers (under include/haarlight) and a CMake package.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/haarlight)

install(TARGETS haarlight_core EXPORT haarlightTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
set_target_properties(haarlight_core PROPERTIES EXPORT_NAME core)
set(rooms base cube haar sh visibility material shexp engine solids shadow)
if(HAARLIGHT_APP)
  install(TARGETS haarlight_scene EXPORT haarlightTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set_target_properties(haarlight_scene PROPERTIES EXPORT_NAME scene)
  install(TARGETS haarlight RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  list(APPEND rooms image light mesh mesh_shadow hard_shadow motion spheres transfer scene render report)
endif()
foreach(room ${rooms})
  install(DIRECTORY src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/haarlight FILES_MATCHING PATTERN "*.h")
endforeach()

install(EXPORT haarlightTargets NAMESPACE haarlight:: DESTINATION ${package_folder})
configure_package_config_file(cmake/haarlightConfig.cmake.in haarlightConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(haarlightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/haarlightConfig.cmake
              ${PROJECT_BINARY_DIR}/haarlightConfigVersion.cmake cmake/FindEmbree.cmake
        DESTINATION ${package_folder})
