#pragma once
// The shapes as the assignment Realtime tessellates them: by two parameters, deliberately coarse.
// For meshes that approximate the exact shapes, see tessellate.h.

#include "scenefile/geometry/mesh.h"

namespace scenefile {

/// The two sliders of the assignment. Values are clamped to 1 to most_tessellation, and further to
/// the minimum of each shape: 2 rings for a sphere, 3 wedges for a round shape.
struct TessellationParameters {
  int parameter1 = 5;  ///< rings of a sphere or cap, stacks of a cylinder or cone, tiles of a cube
  int parameter2 = 5;  ///< wedges about the y axis; not used by cubes

  friend bool operator==(const TessellationParameters&, const TessellationParameters&) = default;
};

inline constexpr int most_tessellation = 1024;

/// Watertight triangles with normals but no uvs, counterclockwise seen from outside. Vertices lie
/// on the exact surface and have its normal; at the tip of a cone, each wedge has the normal of its
/// middle. Empty for Shape::mesh.
///
/// Ring i of p1 of a sphere is at the angle pi i / p1 from the north pole; wedge j of p2 is at the
/// angle 2 pi j / p2 from the x axis toward -z. Each quad is split from its upper left to its lower
/// right corner, seen from outside. (Fitted to the course's pictures, docs/realtime.md.)
Mesh realtime_mesh(Shape shape, const TessellationParameters& parameters);

}  // namespace scenefile
