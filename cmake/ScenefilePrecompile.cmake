# Precompiled headers, with the option SCENEFILE_PRECOMPILE: reading other libraries' headers is most of
# the time of compiling a source. Our own headers are never precompiled, so an edit of one rebuilds only
# what includes it. Sources still include what they use: the presets for sanitizers and portability build
# without this option.
#
# scenefile_precompile(TARGET KIND [HEADERS...]): the targets of one KIND share what the first of them
# makes, so they must be compiled alike. HEADERS: beside those that every kind has.
include_guard(GLOBAL)

set(SCENEFILE_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <limits> <map> <memory> <optional> <span>
  <string> <string_view> <unordered_map> <utility> <vector> <fmt/format.h> <glm/glm.hpp>)

function(scenefile_precompile target kind)
  if(NOT SCENEFILE_PRECOMPILE)
    return()
  endif()
  # What these headers depend on has to be the same everywhere.
  target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  # ccache asks for this.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  get_property(first GLOBAL PROPERTY scenefile_precompiled_${kind})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${SCENEFILE_COMMON_HEADERS} ${ARGN})
  set_property(GLOBAL PROPERTY scenefile_precompiled_${kind} ${target})
endfunction()
