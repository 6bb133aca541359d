#pragma once

#include "scenefile/geometry/mesh.h"

namespace scenefile {

/// Triangles that approximate an analytic shape, with normals and uvs: watertight, wound
/// counterclockwise seen from outside. `segments` (3 to 1024, clamped) divides round sides about
/// the y axis; the other direction follows from it. The cube ignores it. Not for meshes.
///
/// Every vertex lies on the exact surface and agrees with surface_at(), but for two places where
/// that has no one answer: at poles and apex each triangle carries the u (and on the cone the
/// normal) of its middle, and on the seam of round sides the triangles before it have u = 0, those
/// behind it u = 1.
Mesh tessellate(Shape shape, int segments);

}  // namespace scenefile
