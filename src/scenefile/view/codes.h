#pragma once
// The findings of drawing with OpenGL.

#include "scenefile/base/diagnostics.h"

namespace scenefile {

inline constexpr Code gl_copies_left_out{
    "gl.copies-left-out", Severity::warning, "more copies of templates than OpenGL is given",
    "Templates are copied out for OpenGL, so copies take memory and time; the smallest objects are "
    "not drawn, or where all have one size those at the end of the scene. The ray tracer (render "
    "without --engine gl) keeps copies as instances and draws all."};
inline constexpr Code gl_not_drawn{
    "gl.not-drawn", Severity::note, "what only the ray tracer draws",
    "OpenGL draws what the camera sees directly. Mirrors stay without their reflection, light goes "
    "straight through glass, and the lens is a pinhole; render without --engine gl has them."};
inline constexpr Code gl_shadows_left_out{
    "gl.shadows-left-out", Severity::warning, "more lights than OpenGL keeps shadows for",
    "Shadows are looked up in 96 images of the scene as its lights see it: one for a directional "
    "light or a spotlight, six for a point or area light. The lights at the end of the file that "
    "find no room shine without shadows; render without --engine gl has them all."};

}  // namespace scenefile
