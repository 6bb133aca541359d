#pragma once
// Directions of mirrored and refracted light.

#include <glm/glm.hpp>

namespace scenefile {

/// Mirror image of a direction at a surface; the sign of the normal does not matter.
glm::dvec3 reflect_direction(const glm::dvec3& direction, const glm::dvec3& normal);

/// Snell's law for unit vectors: `normal` points against `direction`, `eta` is the index of
/// refraction where the ray comes from over that where it goes. Returns false at total internal
/// reflection.
bool refract_direction(const glm::dvec3& direction, const glm::dvec3& normal, double eta,
                       glm::dvec3& refracted);

/// Share of unpolarized light that a smooth boundary of two clear media mirrors, by Fresnel's
/// equations (Born and Wolf, Principles of Optics, 1.5.2): `cosine` of the angle between ray and
/// normal, `eta` as above. 1 at total internal reflection.
double fresnel_reflectance(double cosine, double eta);

}  // namespace scenefile
