#pragma once
// Reflection at boundaries.

#include <cmath>

namespace scenefile {

/// The fraction of unpolarized light that a smooth boundary between two clear media reflects, by
/// Fresnel's equations (Born and Wolf, Principles of Optics, 1.5.2). `cosine`: between ray and
/// normal; `eta`: the index of refraction on the side of the ray, divided by that on the other
/// side. 1 at total internal reflection.
inline double fresnel_reflectance(double cosine, double eta) {
  const double squared = 1 - eta * eta * (1 - cosine * cosine);
  if (squared <= 0) {
    return 1;
  }
  const double transmitted = std::sqrt(squared);
  const double s_polarized = (eta * cosine - transmitted) / (eta * cosine + transmitted);
  const double p_polarized = (cosine - eta * transmitted) / (cosine + eta * transmitted);
  return 0.5 * (s_polarized * s_polarized + p_polarized * p_polarized);
}

}  // namespace scenefile
