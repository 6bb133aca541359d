#pragma once
// Reflection at boundaries.

#include <glm/glm.hpp>

namespace scenefile {

/// The fraction of unpolarized light that a smooth boundary between two clear media reflects, by
/// Fresnel's equations (Born and Wolf, Principles of Optics, 1.5.2): `cosine` between ray and
/// normal, `eta` as above. 1 at total internal reflection.
double fresnel_reflectance(double cosine, double eta);

}  // namespace scenefile
