#pragma once
// The shapes as the assignment Realtime tessellates them: by two parameters, deliberately coarse.
// For meshes that approximate the exact shapes, see tessellate.h.

#include "scenefile/base/realtime.h"
#include "scenefile/geometry/mesh.h"

namespace scenefile {

/// Watertight triangles with normals but no uvs, counterclockwise seen from outside. Vertices lie
/// on the exact surface and have its normal; at the tip of a cone, each wedge has the normal of its
/// middle. Empty for Shape::mesh.
///
/// Ring i of p1 of a sphere is at the angle pi i / p1 from the north pole; wedge j of p2 is at the
/// angle 2 pi j / p2 from the x axis toward -z. Each quad is split from its upper left to its lower
/// right corner, seen from outside. (Fitted to the course's pictures, docs/realtime.md.)
Mesh realtime_mesh(Shape shape, const TessellationParameters& parameters);

}  // namespace scenefile
