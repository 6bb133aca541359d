#pragma once
// Findings of check_view().

#include "scenefile/base/code.h"

namespace scenefile {

inline constexpr Code placement_codes[] = {
    {"camera.inside-object", Severity::warning, "a camera inside an object",
     "It sees the object from inside, and anything outside only if the object is transparent. Move "
     "the camera out, or allow this code if the object is a room or a sky."},
    {"camera.nothing-in-view", Severity::warning, "no object in view",
     "Every object is behind the camera or outside its field of view, so the picture is black. The "
     "usual reason is a focus point given as look, which is a direction, or the reverse."},
    {"light.inside-object", Severity::note, "a light inside an object",
     "The object blocks the light: with shadows, nothing outside is lit by it. In JSON a light is "
     "at the origin of its group: put the light and the object in different groups."},
    {"light.misses", Severity::warning, "a light that points past everything",
     "No object is in the cone of the spotlight, or on the side to which the area light shines. "
     "direction is the direction in which the light travels."},
    {"material.energy", Severity::warning, "a material returns more light than it receives",
     "Reported for mode path, where surfaces light each other: diffuse, specular, reflective and "
     "transparent, each times its coefficient, are added, and where their sum is above 1 in a "
     "channel each bounce adds energy. The picture is too bright, and between such surfaces its "
     "light has no limit. It is drawn as written. Scale the colors down so that their sum is at "
     "most 1."},
    {"material.texture-without-uvs", Severity::warning,
     "a texture on a mesh without texture coordinates",
     "A texture is placed by the texture coordinates of the mesh: lines vt in the OBJ file, and "
     "faces whose corners are written v/vt or v/vt/vn. Without any, every point has the color of "
     "the lower left corner of the image. Export the mesh with its UVs."},
    {"scene.unlit", Severity::warning, "lights, but nothing is lit",
     "The picture shows ambient light only: the lights are inside objects or shine past "
     "everything, or the coefficients and colors leave neither a diffuse nor a specular part."},
};

template <CodeName name>
constexpr const Code& operator""_code() requires(code_index(placement_codes, name) <
                                                 std::size(placement_codes)) {
  constexpr std::size_t index = code_index(placement_codes, name);
  return placement_codes[index];
}

}  // namespace scenefile
