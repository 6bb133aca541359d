#pragma once
// The shapes as the assignment Realtime tessellates them: by two parameters, coarse on purpose.
// tessellate.h has the meshes that approximate the exact shapes.

#include "scenefile/geometry/mesh.h"

namespace scenefile {

/// The two sliders of the assignment. Values outside 1 to most_tessellation are clamped; a shape
/// that needs more takes its least value: 2 rings of a sphere, 3 wedges of a round shape.
struct TessellationParameters {
  int parameter1 = 5;  ///< rings of a sphere or cap, stacks of a cylinder or cone, tiles of a cube
  int parameter2 = 5;  ///< wedges about the y axis; cubes ignore it

  friend bool operator==(const TessellationParameters&, const TessellationParameters&) = default;
};

inline constexpr int most_tessellation = 1024;

/// Watertight triangles with normals and without uvs, wound counterclockwise seen from outside.
/// Vertices lie on the exact surface and have its normal; at the tip of a cone each wedge has the
/// normal of its middle. Empty for Shape::mesh.
///
/// Ring i of p1 of a sphere is at the angle pi i / p1 from the north pole, wedge j of p2 at the
/// angle 2 pi j / p2 from the x axis toward -z. Each quad is split from its upper left to its lower
/// right corner, seen from outside. (Fitted against the course's pictures, docs/realtime.md.)
Mesh realtime_mesh(Shape shape, const TessellationParameters& parameters);

}  // namespace scenefile
