#pragma once
// Properties of the shapes and types of lights of the format. Other code asks for a property, not
// for a type, so a new type only needs a case in these switches.

#include "scenefile/base/shape.h"

namespace scenefile {

/// Whether a part of the surface, Face::side (geometry/shapes.h), is curved. Meshes are flat
/// triangles.
constexpr bool has_curved_side(Shape shape) {
  switch (shape) {
    case Shape::cone:
    case Shape::cylinder:
    case Shape::sphere:
      return true;
    case Shape::cube:
    case Shape::mesh:
      return false;
  }
  return false;
}

/// Properties of a type of lights.
struct LightTraits {
  bool position = false;   ///< with attenuation; otherwise the light is infinitely far away
  bool direction = false;  ///< that it shines in
  bool cone = false;       ///< that limits where it shines
  bool rectangle = false;  ///< that emits from one side; otherwise the source is a point
};
constexpr LightTraits traits_of(LightType type) {
  switch (type) {
    case LightType::point:
      return {.position = true};
    case LightType::directional:
      return {.direction = true};
    case LightType::spot:
      return {.position = true, .direction = true, .cone = true};
    case LightType::area:
      return {.position = true, .direction = true, .rectangle = true};
  }
  return {};
}
constexpr bool has_position(LightType type) {
  return traits_of(type).position;
}
constexpr bool has_direction(LightType type) {
  return traits_of(type).direction;
}
constexpr bool has_cone(LightType type) {
  return traits_of(type).cone;
}
constexpr bool has_rectangle(LightType type) {
  return traits_of(type).rectangle;
}
/// Whether the course's project Intersect knows lights of the type; its program skips others.
constexpr bool is_in_intersect(LightType type) {
  switch (type) {
    case LightType::directional:
      return true;
    case LightType::point:
    case LightType::spot:
    case LightType::area:
      return false;
  }
  return false;
}
/// Whether the light comes from a single point at a finite distance.
constexpr bool is_at_a_point(LightType type) {
  return has_position(type) && !has_rectangle(type);
}

}  // namespace scenefile
