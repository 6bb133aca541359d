#pragma once
// Ray differentials, for filtering (fine profile). After Igehy, "Tracing Ray Differentials", 1999.

#include <glm/glm.hpp>

namespace scenefile {

/// Derivatives by x and y of the picture, for one step to the right and one step down; world units.
struct PixelDerivatives {
  glm::dvec3 dx{0};
  glm::dvec3 dy{0};
};

/// The differential of a ray.
struct RayDifferential {
  PixelDerivatives origin;
  PixelDerivatives direction;
};

}  // namespace scenefile
