#include "scenefile/path/bsdf.h"

#include "scenefile/trace/optics.h"
#include "scenefile/trace/sequence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using glm::dvec3;
using std::numbers::pi;

// The probabilities of the lobes.
struct LobeShares {
  double diffuse = 0;
  double glossy = 0;
  double mirror = 0;
  double glass = 0;
};

double sum_of(const Color& c) {
  return c.x + c.y + c.z;
}

LobeShares lobe_shares(const Bsdf& bsdf) {
  LobeShares s{sum_of(bsdf.diffuse), sum_of(bsdf.glossy), sum_of(bsdf.mirror), sum_of(bsdf.glass)};
  const double all = s.diffuse + s.glossy + s.mirror + s.glass;
  if (all > 0) {
    s = {s.diffuse / all, s.glossy / all, s.mirror / all, s.glass / all};
  }
  return s;
}

// From coordinates about the unit vector z (Duff et al., "Building an Orthonormal Basis,
// Revisited", 2017).
dvec3 turned(const dvec3& local, const dvec3& z) {
  const double sign = std::copysign(1.0, z.z);
  const double a = -1 / (sign + z.z);
  const double b = z.x * z.y * a;
  const dvec3 x(1 + sign * z.x * z.x * a, sign * b, -sign * z.x);
  const dvec3 y(b, sign + z.y * z.y * a, -z.y);
  return local.x * x + local.y * y + local.z * z;
}

// Density cos / pi.
dvec3 cosine_direction(const dvec3& normal, const glm::dvec2& point) {
  const glm::dvec2 disk = disk_of_square(point);
  return turned({disk.x, disk.y, std::sqrt(std::max(0.0, 1 - glm::dot(disk, disk)))}, normal);
}

// Density (n + 1) / 2 pi cos^n.
dvec3 power_direction(const dvec3& axis, double n, const glm::dvec2& point) {
  const double cosine = std::pow(1 - point.x, 1 / (n + 1));
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double angle = 2 * pi * point.y;
  return turned({sine * std::cos(angle), sine * std::sin(angle), cosine}, axis);
}

dvec3 mirrored_about(const dvec3& normal, const dvec3& to_eye) {
  return glm::normalize(2 * glm::dot(normal, to_eye) * normal - to_eye);
}

// The mirror direction. An interpolated normal may send it into the object; then the geometric one
// is used.
dvec3 mirror_direction(const Facing& facing) {
  const dvec3 mirrored = mirrored_about(facing.normal, facing.to_eye);
  return glm::dot(mirrored, facing.geometric) > 0 ? mirrored
                                                  : mirrored_about(facing.geometric, facing.to_eye);
}

BsdfValue value_of(const Bsdf& bsdf, const LobeShares& shares, const Facing& facing,
                   const dvec3& to_light) {
  const double cosine = glm::dot(facing.normal, to_light);
  BsdfValue value;
  const bool reflects = glm::dot(facing.geometric, to_light) > 0;
  if (shares.diffuse > 0 && cosine > 0) {
    value.density += shares.diffuse * cosine / pi;
    value.bsdf_cosine += cosine / pi * bsdf.diffuse;
  }
  if (shares.glossy > 0) {
    const double n = bsdf.shininess;
    const double along = glm::dot(mirrored_about(facing.normal, facing.to_eye), to_light);
    if (along > 0) {
      const double lobe = std::pow(along, n) / (2 * pi);
      value.density += shares.glossy * (n + 1) * lobe;
      value.bsdf_cosine += std::max(0.0, cosine) * (n + 2) * lobe * bsdf.glossy;
    }
  }
  if (!reflects) {
    value.bsdf_cosine = Color(0);
  }
  return value;
}

// Reflects or refracts, with the probabilities of Fresnel's equations; `choice` in [0, 1).
BsdfSample glass_sample(const Bsdf& bsdf, const Facing& facing, double choice) {
  const double eta = facing.outside ? 1 / bsdf.ior : bsdf.ior;
  const double cosine = glm::dot(facing.normal, facing.to_eye);
  const double reflected = fresnel_reflectance(cosine, eta);
  BsdfSample result;
  if (choice < reflected || reflected >= 1) {
    result.lobe = BsdfLobe::reflection;
    result.density = std::min(reflected, 1.0);
    result.to_light = mirror_direction(facing);
    result.bsdf_cosine = result.density * bsdf.glass;
    return result;
  }
  const double inside = std::sqrt(std::max(0.0, 1 - eta * eta * (1 - cosine * cosine)));
  const dvec3 through =
      glm::normalize((eta * cosine - inside) * facing.normal - eta * facing.to_eye);
  result.lobe = BsdfLobe::refraction;
  result.density = 1 - reflected;
  result.to_light = glm::dot(through, facing.geometric) < 0 ? through : -facing.to_eye;
  result.bsdf_cosine = result.density * bsdf.glass;
  return result;
}

}  // namespace

Facing facing_of(const dvec3& normal, const dvec3& outward, const dvec3& geometric,
                 const dvec3& to_eye) {
  Facing facing{normal, geometric, to_eye, true};
  // Where a file's normals point against the winding, they decide what is inside.
  if (glm::dot(geometric, outward) < 0) {
    facing.geometric = -geometric;
  }
  if (glm::dot(facing.geometric, to_eye) < 0) {
    facing = {-facing.normal, -facing.geometric, to_eye, false};
  }
  if (glm::dot(facing.normal, to_eye) <= 0) {
    facing.normal = facing.geometric;
  }
  return facing;
}

BsdfValue evaluate(const Bsdf& bsdf, const Facing& facing, const dvec3& to_light) {
  return value_of(bsdf, lobe_shares(bsdf), facing, to_light);
}

bool is_rough(const Bsdf& bsdf) {
  return sum_of(bsdf.diffuse) + sum_of(bsdf.glossy) > 0;
}

BsdfSample sample(const Bsdf& bsdf, const Facing& facing, double lobe, const glm::dvec2& point) {
  const LobeShares shares = lobe_shares(bsdf);
  BsdfSample result;
  if (lobe < shares.diffuse + shares.glossy) {
    const bool diffuse = lobe < shares.diffuse;
    result.lobe = diffuse ? BsdfLobe::diffuse : BsdfLobe::glossy;
    result.to_light = diffuse ? cosine_direction(facing.normal, point)
                              : power_direction(mirrored_about(facing.normal, facing.to_eye),
                                                bsdf.shininess, point);
    const BsdfValue value = value_of(bsdf, shares, facing, result.to_light);
    result.bsdf_cosine = value.bsdf_cosine;
    result.density = value.density;
    if (value.density > 0) {
      result.weight = value.bsdf_cosine / value.density;
    }
    return result;
  }
  lobe -= shares.diffuse + shares.glossy;
  if (lobe < shares.mirror) {
    result.lobe = BsdfLobe::mirror;
    result.to_light = mirror_direction(facing);
    result.bsdf_cosine = bsdf.mirror;
    result.density = shares.mirror;
    result.weight = bsdf.mirror / shares.mirror;
  } else if (shares.glass > 0) {
    result = glass_sample(bsdf, facing, (lobe - shares.mirror) / shares.glass);
    result.density *= shares.glass;
    result.weight = bsdf.glass / shares.glass;
  }
  return result;
}

BsdfSample sample_uniformly(const Bsdf& bsdf, const Facing& facing, double lobe,
                            const glm::dvec2& point) {
  BsdfSample result = sample(bsdf, facing, lobe, point);
  if (result.lobe == BsdfLobe::none || result.specular()) {
    return result;
  }
  // The probability of a rough lobe stays.
  const LobeShares shares = lobe_shares(bsdf);
  result.to_light = power_direction(facing.normal, 0, point);
  result.density = (shares.diffuse + shares.glossy) / (2 * pi);
  result.bsdf_cosine = value_of(bsdf, shares, facing, result.to_light).bsdf_cosine;
  result.weight = result.bsdf_cosine / result.density;
  return result;
}

}  // namespace scenefile
