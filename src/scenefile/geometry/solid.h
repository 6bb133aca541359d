#pragma once
// The shapes as solids: what is inside of them, and how far they reach.

#include "scenefile/base/affine.h"
#include "scenefile/geometry/mesh.h"
#include "scenefile/geometry/shapes.h"

#include <glm/glm.hpp>

namespace scenefile {

/// The largest dot product of `direction` with a point of the transformed shape (its support
/// function), to rounding. Not for meshes.
double support(Shape shape, const DAffine& to_from_object, const glm::dvec3& direction);

/// Whether a point in object space lies inside the solid and at least a millionth of a unit from
/// its surface. Not for meshes.
bool contains(Shape shape, const glm::dvec3& point);

/// How often the mesh winds around the point, in the mesh's space: 1 inside a closed mesh whose
/// corners run counterclockwise seen from outside, -1 inside one that is turned inside out, 0
/// outside, in between for meshes with holes. Solid angles by van Oosterom and Strackee, IEEE
/// Transactions on Biomedical Engineering 30 (1983). Takes time proportional to the triangles.
double winding_number(const Mesh& mesh, const glm::dvec3& point);

}  // namespace scenefile
