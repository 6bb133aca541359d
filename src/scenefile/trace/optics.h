#pragma once
// Directions of reflected and refracted light.

#include <glm/glm.hpp>

namespace scenefile {

/// The reflected direction; the sign of the normal does not matter.
glm::dvec3 reflect_direction(const glm::dvec3& direction, const glm::dvec3& normal);

/// Snell's law for unit vectors: `normal` points against `direction`; `eta` is the ratio of the
/// indices of refraction, incident over transmitted side. Returns false at total internal
/// reflection.
bool refract_direction(const glm::dvec3& direction, const glm::dvec3& normal, double eta,
                       glm::dvec3& refracted);

/// The fraction of unpolarized light that a smooth boundary between two clear media reflects, by
/// Fresnel's equations (Born and Wolf, Principles of Optics, 1.5.2): `cosine` between ray and
/// normal, `eta` as above. 1 at total internal reflection.
double fresnel_reflectance(double cosine, double eta);

}  // namespace scenefile
