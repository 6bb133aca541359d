#pragma once
// The shapes once more, by definitions that share nothing with the library: a membership test, and
// points on the faces by their parameters.

#include "scenefile/geometry/shapes.h"

#include <random>
#include <vector>

namespace scenefile::test {

inline constexpr Shape analytic_shapes[] = {Shape::cube, Shape::cone, Shape::cylinder,
                                            Shape::sphere};

const char* name_of(Shape shape);

/// Less than 0 inside, 0 on the surface, more outside; not a distance, but within a factor 3 of
/// one near the surface.
double implicit(Shape shape, const glm::dvec3& p);

std::vector<Face> faces_of(Shape shape);

/// A point of a face and the uv it must have by the format's formulas; a, b in [0, 1).
struct FacePoint {
  glm::dvec3 point;
  glm::dvec2 uv;
};
FacePoint point_on(Shape shape, Face face, double a, double b);

/// A point spread over all faces.
struct RandomPoint {
  Face face;
  FacePoint at;
};
RandomPoint random_point(Shape shape, std::mt19937_64& random);

double uniform(std::mt19937_64& random, double low = 0, double high = 1);
glm::dvec3 random_direction(std::mt19937_64& random);

}  // namespace scenefile::test
