# The installed CMake package: find_package(scenefile).
include(CMakePackageConfigHelpers)
if(SCENEFILE_TRACE)
  get_directory_property(SCENEFILE_EMBREE_VERSION
    DIRECTORY ${PROJECT_SOURCE_DIR}/src/scenefile/trace DEFINITION embree_VERSION)
endif()
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/scenefile)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/scenefileConfig.cmake.in
  ${PROJECT_BINARY_DIR}/scenefileConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scenefileConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/scenefileConfig.cmake
  ${PROJECT_BINARY_DIR}/scenefileConfigVersion.cmake DESTINATION ${package_folder})
install(EXPORT scenefileTargets NAMESPACE scenefile:: DESTINATION ${package_folder})
