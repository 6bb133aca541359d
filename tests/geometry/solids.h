#pragma once
// Independent definitions of the shapes, which share no code with the library: a membership test,
// and parametric points on the faces.

#include "scenefile/geometry/shapes.h"

#include <random>
#include <vector>

namespace scenefile::test {

inline constexpr Shape analytic_shapes[] = {Shape::cube, Shape::cone, Shape::cylinder,
                                            Shape::sphere};

const char* name_of(Shape shape);

/// Negative inside, 0 on the surface, positive outside; not a distance, but within a factor of 3 of
/// the distance near the surface.
double implicit(Shape shape, const glm::dvec3& p);

std::vector<Face> faces_of(Shape shape);

/// A point of a face and its uv by the format's formulas; a, b in [0, 1).
struct FacePoint {
  glm::dvec3 point;
  glm::dvec2 uv;
};
FacePoint point_on(Shape shape, Face face, double a, double b);

/// A random point on any face.
struct RandomPoint {
  Face face;
  FacePoint at;
};
RandomPoint random_point(Shape shape, std::mt19937_64& random);

double uniform(std::mt19937_64& random, double low = 0, double high = 1);
glm::dvec3 random_direction(std::mt19937_64& random);

}  // namespace scenefile::test
