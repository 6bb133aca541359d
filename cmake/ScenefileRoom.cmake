# scenefile_room(NAME SOURCES ... HEADERS ... [PUBLIC libs...] [PRIVATE libs...] [PROGRAM_ONLY])
# A room is one folder of src/scenefile and one static library target scenefile::NAME. HEADERS are the
# public headers, which are installed; others are internal to the room. PROGRAM_ONLY: not part of
# the installed library.
include_guard(GLOBAL)

add_library(scenefile_options INTERFACE)
target_compile_features(scenefile_options INTERFACE cxx_std_20)
target_compile_options(scenefile_options INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Werror=switch
  # Code for any number of lanes combines masks with &; with one lane they are bool.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>
  # These warnings would be about code from other sources of the same unit.
  $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-shadow>
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-subobject-linkage>
  # GCC collects garbage only above 512 MB: large units compile up to 8 % faster.
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>
  # No fused multiply-add, so that all compilers give the same bytes.
  -ffp-contract=off
  $<$<BOOL:${SCENEFILE_WERROR}>:-Werror>)

# Rooms whose speed matters more than their size in WebAssembly, which pages download.
set(SCENEFILE_FAST_ROOMS base geometry compare trace path noise mistakes grade)

# Rooms whose speed does not matter, because they print, or call others: all of their sources are COLD.
set(SCENEFILE_COLD_ROOMS edit explain export gradebook import io lsp verbs)

# Sources that include an "-inl.h" stay out of unity builds: such headers have no include guard, because
# they are compiled once for each instruction set.
function(scenefile_keep_apart)
  foreach(source IN LISTS ARGN)
    if(source MATCHES "\\.cpp$" AND EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${source}")
      file(STRINGS "${source}" found REGEX "^#include \".*-inl\\.h\"" LIMIT_COUNT 1)
      if(found)
        set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      endif()
    endif()
  endforeach()
endfunction()

# scenefile_cold(TARGET): for code whose speed does not matter; compiles it faster, and to less code.
function(scenefile_cold target)
  target_compile_options(${target} PRIVATE $<IF:$<BOOL:${EMSCRIPTEN}>,-Oz,$<$<CONFIG:Release>:-O1>>)
  scenefile_precompile(${target} cold)
endfunction()

# Adds rooms, unless they have been added. Each adds those that it uses.
function(scenefile_add_rooms)
  foreach(room IN LISTS ARGN)
    set(folder src/scenefile/${room})
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${folder}/CMakeLists.txt)
      message(FATAL_ERROR "There is no room \"${room}\"; ARCHITECTURE.md lists all rooms.")
    elseif(NOT TARGET scenefile::${room})
      add_subdirectory(${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/${folder})
    endif()
  endforeach()
endfunction()

function(scenefile_room name)
  cmake_parse_arguments(ROOM "PROGRAM_ONLY" "" "SOURCES;COLD;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  set(used ${ROOM_PUBLIC} ${ROOM_PRIVATE})
  list(FILTER used INCLUDE REGEX "^scenefile::")
  list(TRANSFORM used REPLACE "^scenefile::" "")
  scenefile_add_rooms(${used})
  set(target scenefile_${name})
  set(small FALSE)
  if(EMSCRIPTEN AND NOT name IN_LIST SCENEFILE_FAST_ROOMS)
    set(small TRUE)  # all of it
    list(APPEND ROOM_SOURCES ${ROOM_COLD})
    unset(ROOM_COLD)
  endif()
  add_library(${target} STATIC ${ROOM_SOURCES})
  set(parts ${target})
  if(ROOM_COLD)
    add_library(${target}_cold OBJECT ${ROOM_COLD})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_cold>)
    list(APPEND parts ${target}_cold)
  endif()
  add_library(scenefile::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  scenefile_keep_apart(${ROOM_SOURCES})
  foreach(part IN LISTS parts)
    set_target_properties(${part} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_EXTENSIONS OFF)
    target_include_directories(${part} PUBLIC
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_features(${part} PUBLIC cxx_std_20)
    target_link_libraries(${part} PUBLIC ${ROOM_PUBLIC} PRIVATE ${ROOM_PRIVATE}
      $<BUILD_INTERFACE:scenefile_options>)
    if(small OR NOT part STREQUAL target OR name IN_LIST SCENEFILE_COLD_ROOMS)
      scenefile_cold(${part})
    else()
      scenefile_precompile(${part} room)
    endif()
  endforeach()
  if(ROOM_PROGRAM_ONLY OR SCENEFILE_ROOMS)
    return()
  endif()
  install(TARGETS ${target} EXPORT scenefileTargets COMPONENT library)
  install(FILES ${ROOM_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scenefile/${name} COMPONENT library)
  set_property(GLOBAL APPEND PROPERTY scenefile_installed_rooms ${name})
  list(TRANSFORM ROOM_HEADERS PREPEND ${name}/)
  set_property(GLOBAL APPEND PROPERTY scenefile_installed_headers ${ROOM_HEADERS})
endfunction()
