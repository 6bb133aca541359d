#pragma once
// How a surface scatters light: a sum of four lobes. Sampling, evaluation and density agree; the
// tests compare them.

#include "scenefile/trace/color.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace scenefile {

/// Factors of the lobes. All of them are 0 for a black surface.
struct Bsdf {
  Color diffuse{0};      ///< Lambert: diffuse / pi
  Color glossy{0};       ///< Phong: glossy (n + 2) / 2 pi cos^n, about the mirror direction
  double shininess = 1;  ///< that n, at least 0
  Color mirror{0};       ///< of light from the mirror direction
  Color glass{0};        ///< of light reflected and refracted by a boundary, by Fresnel's equations
  double ior = 1;        ///< index of refraction of the inside; that of the outside is 1
};

/// A point of a surface as seen by a path. Vectors have unit length; both normals are on the side
/// of `to_eye`.
struct Facing {
  glm::dvec3 normal{0, 1, 0};     ///< for shading
  glm::dvec3 geometric{0, 1, 0};  ///< separates reflection from refraction
  glm::dvec3 to_eye{0, 1, 0};     ///< where the path came from
  bool outside = true;            ///< `to_eye` is outside of the object
};

/// Orients the normals of a surface. `normal`: for shading; `outward`: the same without a bump map;
/// `geometric` may be on either side.
Facing facing_of(const glm::dvec3& normal, const glm::dvec3& outward, const glm::dvec3& geometric,
                 const glm::dvec3& to_eye);

/// The value for a direction, of the lobes that have one: diffuse and glossy.
struct BsdfValue {
  Color bsdf_cosine{0};  ///< BSDF times cosine
  double density = 0;    ///< of sample() for this direction, per solid angle
};
BsdfValue evaluate(const Bsdf& bsdf, const Facing& facing, const glm::dvec3& to_light);

/// Whether evaluate() can be other than 0.
bool is_rough(const Bsdf& bsdf);

/// A lobe, for glass also the direction.
enum class BsdfLobe : std::uint8_t { none, diffuse, glossy, mirror, reflection, refraction };

struct BsdfSample {
  glm::dvec3 to_light{0};          ///< unit length
  Color weight{0};                 ///< bsdf_cosine / density; 0: the path ends
  BsdfLobe lobe = BsdfLobe::none;  ///< that was chosen for the direction
  /// Mirrors and glass have only one direction or two.
  bool specular() const { return lobe >= BsdfLobe::mirror; }
  Color bsdf_cosine{0};  ///< BSDF of all rough lobes times cosine; specular: the factor
  double density = 0;    ///< rough: of all of them, per solid angle; specular: the probability
};

/// A random direction. `lobe` and `point` are uniform in [0, 1).
BsdfSample sample(const Bsdf& bsdf, const Facing& facing, double lobe, const glm::dvec2& point);

/// The same, but uniform over the hemisphere where a direction can be, as in simple programs.
BsdfSample sample_uniformly(const Bsdf& bsdf, const Facing& facing, double lobe,
                            const glm::dvec2& point);

}  // namespace scenefile
