#pragma once
// The shapes as solids: containment and extent.

#include "scenefile/base/affine.h"
#include "scenefile/geometry/mesh.h"
#include "scenefile/geometry/shapes.h"

#include <glm/glm.hpp>

namespace scenefile {

/// The support function: the largest dot product of `direction` with a point of the transformed
/// shape, up to rounding. Not for meshes.
double support(Shape shape, const DAffine& to_from_object, const glm::dvec3& direction);

/// Whether a point in object space is inside the solid and at least 1e-6 from its surface. Not for
/// meshes.
bool contains(Shape shape, const glm::dvec3& point);

/// The winding number of the mesh around the point, in the mesh's space: 1 inside a closed mesh
/// with counterclockwise corners seen from outside, -1 inside a mesh turned inside out, 0 outside,
/// and values in between for meshes with holes. Solid angles by van Oosterom and Strackee, IEEE
/// Transactions on Biomedical Engineering 30 (1983). Takes time linear in the number of triangles.
double winding_number(const Mesh& mesh, const glm::dvec3& point);

}  // namespace scenefile
