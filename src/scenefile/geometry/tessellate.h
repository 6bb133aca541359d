#pragma once

#include "scenefile/geometry/mesh.h"

namespace scenefile {

/// Triangles that approximate an analytic shape, with normals and uvs: watertight, counterclockwise
/// seen from outside. `segments` (clamped to 3 to 1024) divides round sides about the y axis; the
/// divisions in the other direction follow from it. The cube ignores it. Not for meshes.
///
/// Every vertex lies on the exact surface and agrees with surface_at(), except where the surface
/// has no unique answer. At poles and apex, each triangle has the u (and on the cone the normal) of
/// its middle. At the seam of round sides, triangles on one side have u = 0, those on the other u =
/// 1.
Mesh tessellate(Shape shape, int segments);

}  // namespace scenefile
