# Debian packages, one for each component: `make packages`, or cpack in a build folder.
find_program(GZIP gzip)
if(NOT GZIP OR NOT SCENEFILE_APP OR NOT SCENEFILE_TRACE)
  return()
endif()

# Uses the author and the time of the commit, so that the same sources give the same packages.
function(of_commit format result)
  execute_process(COMMAND git -c safe.directory=* log -1 --format=${format} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE no_git)
  set(${result} "${answer}" PARENT_SCOPE)
endfunction()
set(SCENEFILE_MAINTAINER "" CACHE STRING "The maintainer of the packages, as \"Name <address>\"; empty: the author of the commit")
set(maintainer "${SCENEFILE_MAINTAINER}")
if(NOT maintainer)
  of_commit("%an <%ae>" maintainer)
endif()
if(NOT maintainer)
  set(maintainer "nobody in particular <root@localhost>")
endif()
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  of_commit(%ct epoch)
  if(epoch)
    set(ENV{SOURCE_DATE_EPOCH} ${epoch})
  endif()
endif()
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${PROJECT_SOURCE_DIR}/packages/changelog.in ${PROJECT_BINARY_DIR}/changelog @ONLY)
execute_process(COMMAND ${GZIP} -9nf ${PROJECT_BINARY_DIR}/changelog COMMAND_ERROR_IS_FATAL ANY)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME scenefile)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${maintainer}")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# scenefile_deb(COMPONENT PACKAGE DESCRIPTION [SECTION word] [DEPENDS packages] [RECOMMENDS packages] [SUGGESTS packages])
# The first line of DESCRIPTION is its title. Dependencies on linked libraries are found automatically.
set(CPACK_COMPONENTS_ALL "")
macro(scenefile_deb component package description)
  cmake_parse_arguments(DEB "" "SECTION" "DEPENDS;RECOMMENDS;SUGGESTS" ${ARGN})
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ON)
  if(DEB_SECTION)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${DEB_SECTION})
  endif()
  foreach(kind DEPENDS RECOMMENDS SUGGESTS)
    if(DEB_${kind})
      list(JOIN DEB_${kind} ", " CPACK_DEBIAN_${upper}_PACKAGE_${kind})
    endif()
  endforeach()
  # Debian wants these in each package; `make install` has LICENSE and CHANGELOG.md.
  install(FILES ${PROJECT_SOURCE_DIR}/packages/copyright ${PROJECT_BINARY_DIR}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

# Loaded by name; Debian 13 renamed the package.
set(archive_library "libarchive13t64 | libarchive13")

scenefile_deb(program scenefile
"check, explain, render and convert CS123 scene files
Scene files of Brown University's computer graphics courses (CS123, CSCI1230)
describe a camera, lights and a scene graph of simple shapes, in XML or JSON.
This program checks them and reports each mistake with its line, its column and
how to fix it, draws them by ray tracing or with OpenGL as the course's own
programs do, explains the color of a pixel, compares pictures, names the
mistake that explains a difference, grades the pictures of a class, and
converts scenes to and from glTF and Wavefront OBJ, and to POV-Ray."
  RECOMMENDS libegl1 libgl1-mesa-dri "${archive_library}" SUGGESTS scenefile-window)
# Pages link to LICENSE; Debian has one copy of its text for all packages.
file(CREATE_LINK copyright ${PROJECT_BINARY_DIR}/LICENSE SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/LICENSE TYPE DOC COMPONENT program EXCLUDE_FROM_ALL)

if(TARGET scenefile-window)
  scenefile_deb(window scenefile-window
"look at CS123 scene files in a window
The window of scenefile: move through a scene of Brown University's computer
graphics courses, select objects, ray trace it, compare it with a picture,
explain the color of a pixel, and see the scene change while its file is being
edited."
    RECOMMENDS libegl1 libgl1-mesa-dri fonts-dejavu-core)
  set(CPACK_COMPONENT_WINDOW_DEPENDS program)
endif()

scenefile_deb(library libscenefile-dev
"C++ library that reads, checks and renders CS123 scene files
Headers and static libraries of scenefile: scenes of Brown University's
computer graphics courses as plain data, readers and writers of XML and JSON,
diagnostics with their places, and a ray tracer. For CMake (find_package) and
pkg-config."
  SECTION libdevel
  DEPENDS libglm-dev libfmt-dev libexpat1-dev libpng-dev libjpeg-dev zlib1g-dev libisal-dev libopenexr-dev libtbb-dev libembree-dev)

if(TARGET scenefile_python)
  foreach(part MAJOR MINOR)
    get_directory_property(python_${part} DIRECTORY ${PROJECT_SOURCE_DIR}/python DEFINITION Python_VERSION_${part})
  endforeach()
  math(EXPR next_minor "${python_MINOR} + 1")
  scenefile_deb(python python3-scenefile
"read, edit, render and compare CS123 scene files (Python 3)
The module scenefile for Python reads, checks, edits and draws scenes of Brown
University's computer graphics courses. Pictures are NumPy arrays. It names the
mistake that explains a wrong picture, and grades a class."
    SECTION python
    DEPENDS "python3 (>= ${python_MAJOR}.${python_MINOR})"
      "python3 (<< ${python_MAJOR}.${next_minor})" python3-numpy
    RECOMMENDS "${archive_library}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/packages/python3-scenefile/postinst ${PROJECT_SOURCE_DIR}/packages/python3-scenefile/prerm)
endif()

include(CPack)
