#pragma once
// The findings of check_view().

#include "scenefile/base/diagnostics.h"

#include <span>

namespace scenefile {

inline constexpr Code camera_inside_object{
    "camera.inside-object", Severity::warning, "a camera inside an object",
    "It sees the object from within, and through it only what is transparent. Move the camera "
    "out, or allow this if the object is a room or a sky."};
inline constexpr Code camera_nothing_in_view{
    "camera.nothing-in-view", Severity::warning, "no object in view",
    "Every object lies behind the camera or beside what it can see, so the picture is black. look "
    "is a direction and focus a point: one in place of the other is the usual reason."};
inline constexpr Code light_inside_object{
    "light.inside-object", Severity::note, "a light inside an object",
    "The object keeps its light in: nothing outside is lit by it where shadows are drawn. In JSON "
    "a "
    "light stands at the origin of its group: give light and object groups of their own."};
inline constexpr Code light_misses{
    "light.misses", Severity::warning, "a light that shines past everything",
    "No object lies in the cone of the spotlight, or on the side that the area light shines on. "
    "direction is the way that the light travels."};
inline constexpr Code scene_unlit{
    "scene.unlit", Severity::warning, "lights, but nothing is lit",
    "The picture shows ambient light only: the lights are inside objects or shine past everything, "
    "or the coefficients and colors leave neither a diffuse nor a specular part."};

/// All of the above, by name.
std::span<const Code* const> view_codes();

}  // namespace scenefile
