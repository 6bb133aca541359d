#pragma once
// Findings of drawing with OpenGL.

#include "scenefile/base/code.h"

namespace scenefile {

inline constexpr Code view_codes[] = {
    {"gl.copies-left-out", Severity::warning, "more instances than OpenGL draws",
     "Templates are expanded for OpenGL, so instances take memory and time; the smallest objects "
     "are not drawn, or, if all have the same size, those at the end of the scene. The ray tracer "
     "(render without --engine gl) draws all of them."},
    {"gl.not-drawn", Severity::note, "effects that only the ray tracer draws",
     "OpenGL draws only what the camera sees directly. Mirrors have no reflection, light goes "
     "straight through glass, and the lens is a pinhole; render without --engine gl draws them."},
    {"gl.shadows-left-out", Severity::warning, "more lights than OpenGL draws shadows for",
     "There is room for 96 shadow maps: one for a directional light or a spotlight, six for a "
     "point light, 24 for an area light, or six if there are many. The remaining lights at the end "
     "of the file cast no shadows; render "
     "without --engine gl draws them all."},
};

template <CodeName name>
constexpr const Code& operator""_code() requires(code_index(view_codes, name) <
                                                 std::size(view_codes)) {
  constexpr std::size_t index = code_index(view_codes, name);
  return view_codes[index];
}

}  // namespace scenefile
