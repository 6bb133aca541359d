# The installed package of the library: find_package(scenefile), and pkg-config scenefile.
include(CMakePackageConfigHelpers)
if(SCENEFILE_TRACE AND SCENEFILE_EMBREE)
  get_directory_property(SCENEFILE_EMBREE_VERSION
    DIRECTORY ${PROJECT_SOURCE_DIR}/src/scenefile/trace DEFINITION embree_VERSION)
endif()
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/scenefile)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/scenefileConfig.cmake.in
  ${PROJECT_BINARY_DIR}/scenefileConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scenefileConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/scenefileConfig.cmake
  ${PROJECT_BINARY_DIR}/scenefileConfigVersion.cmake DESTINATION ${package_folder} COMPONENT library)
install(EXPORT scenefileTargets NAMESPACE scenefile:: DESTINATION ${package_folder} COMPONENT library)

# What scripts/library-reference shows.
get_property(headers GLOBAL PROPERTY scenefile_installed_headers)
list(JOIN headers "\n" headers)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/installed-headers.txt CONTENT "${headers}\n")

# Archives in link order: each comes before those that it uses. Libraries without a .pc file on some systems
# are listed by name.
get_property(rooms GLOBAL PROPERTY scenefile_installed_rooms)
list(REVERSE rooms)
list(TRANSFORM rooms PREPEND -lscenefile_ OUTPUT_VARIABLE libs)
set(requires glm fmt expat libpng libjpeg zlib)
if(SCENEFILE_ISAL)
  list(APPEND libs -lisal)
endif()
if(SCENEFILE_OPENEXR)
  list(APPEND requires OpenEXR)
endif()
if(SCENEFILE_TRACE AND SCENEFILE_EMBREE)
  string(REGEX MATCH "^[0-9]+" embree_major ${SCENEFILE_EMBREE_VERSION})
  list(APPEND libs -lembree${embree_major})
endif()
if(SCENEFILE_TRACE AND SCENEFILE_TBB)
  list(APPEND libs -ltbbmalloc)
  list(APPEND requires tbb)
endif()
list(JOIN libs " " libs)
list(JOIN requires ", " requires)
set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH prefix_from_pc /${pc_folder} /)
string(REGEX REPLACE "/$" "" prefix_from_pc "${prefix_from_pc}")
configure_file(${PROJECT_SOURCE_DIR}/packages/scenefile.pc.in ${PROJECT_BINARY_DIR}/scenefile.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/scenefile.pc DESTINATION ${pc_folder} COMPONENT library)
