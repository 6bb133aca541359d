# Precompiled headers, with the option SCENEFILE_PRECOMPILE: reading other libraries' headers is most of
# the time of compiling a source. Our own headers are never precompiled, so an edit of one rebuilds only
# what includes it. Sources still include what they use: the presets for portability, fuzzing and coverage
# build without this option.
#
# scenefile_precompile(TARGET KIND [HEADERS...]): the targets of a KIND share the precompiled header
# of the first, so they must have the same compile options. HEADERS: in addition to those of every
# kind.
include_guard(GLOBAL)

set(SCENEFILE_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <limits> <map> <memory> <optional> <span>
  <string> <string_view> <unordered_map> <utility> <vector> <fmt/format.h> <glm/glm.hpp>)

function(scenefile_precompile target kind)
  if(NOT SCENEFILE_PRECOMPILE)
    return()
  endif()
  # The compile definitions of these headers must be the same everywhere.
  target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  # ccache requires this.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  get_property(first GLOBAL PROPERTY scenefile_precompiled_${kind})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${SCENEFILE_COMMON_HEADERS} ${ARGN})
  set_property(GLOBAL PROPERTY scenefile_precompiled_${kind} ${target})
endfunction()
