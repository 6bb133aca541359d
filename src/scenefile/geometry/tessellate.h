#pragma once

#include "scenefile/geometry/mesh.h"

namespace scenefile {

/// Triangles that approximate an analytic shape, with normals and uvs; every vertex lies on the
/// exact surface and agrees with surface_at(). `segments` (at least 3) divides round sides about
/// the y axis; the other direction follows from it. The cube ignores it. Not for meshes.
Mesh tessellate(Shape shape, int segments);

}  // namespace scenefile
