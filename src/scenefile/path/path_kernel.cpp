#include "scenefile/path/path_kernel.h"

#include "scenefile/base/components.h"
#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/trace/lighting-inl.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Shadow rays end short of the light by the precision of hits.
constexpr double before_light = 1 - 1e-9;

// Roulette by throughput starts after this many bounces, and never lets all paths go on, so that
// those between surfaces that absorb nothing end too.
constexpr int first_roulette = 3;
constexpr double most_continuation = 0.95;

// The power heuristic (Veach, 1997) for a sample with density `own`, where the other way of
// sampling has density `other`.
double mis_weight(double own, double other) {
  const double ratio = other / own;
  return 1 / (1 + ratio * ratio);
}

class Path {
 public:
  Path(const PathScene& scene, const PathPoints& points, RayCounts& counts)
      : scene_(scene), options_(scene.options), points_(points), counts_(counts) {}

  Color follow(Ray ray) {
    double t_min = 0;
    for (int bounce = 0;; ++bounce) {
      bounce_ = bounce;
      Hit hit;
      ++(bounce == 0 ? counts_.primary : counts_.secondary);
      if (!scene_.tracer.accelerator.closest(ray, t_min, infinity, hit)) {
        break;
      }
      const PathPoint point = path_point(scene_, ray, hit);
      add(bounce, emitted(point, hit.t));
      if (last_ || (options_.max_depth > 0 && bounce >= options_.max_depth)) {
        break;
      }
      if (is_rough(point.bsdf)) {
        add(bounce + 1, lamp_light(point) + scene_light(point));
      }
      const glm::dvec2 choice = use(PathUse::lobe);
      const BsdfSample next = sample(point.bsdf, point.facing, choice.x, use(PathUse::direction));
      throughput_ *= next.weight;
      if (throughput_ == Color(0) || !goes_on(choice.y)) {
        break;
      }
      last_ = options_.direct_only && !next.specular;
      density_ = next.specular ? infinity : next.density;
      ray = {point.position, next.to_light};
      t_min = point.offset;
    }
    const double most = largest(indirect_);
    return options_.clamp > 0 && most > options_.clamp ? direct_ + options_.clamp / most * indirect_
                                                       : direct_ + indirect_;
  }

 private:
  glm::dvec2 use(PathUse use, int part = 0, int parts = 1, std::uint32_t index = 0) const {
    return points_(use, bounce_, part, parts, index);
  }

  bool course() const { return options_.convention == Convention::course; }
  // Light that falls off with the distance is only found by light samples.
  bool uses_mis() const { return options_.mis && !course(); }

  // Adds light that was reflected or refracted `times` times.
  void add(int times, const Color& light) {
    (times < 2 ? direct_ : indirect_) += throughput_ * light;
  }

  bool goes_on(double random) {
    double share = options_.continuation;
    if (share == 0) {
      if (bounce_ + 1 < first_roulette) {
        return true;
      }
      share = std::min(most_continuation, largest(throughput_));
    }
    throughput_ /= share;
    return random < share;
  }

  // Light samples find the same lamps, except after the camera, mirrors and glass.
  Color emitted(const PathPoint& point, double distance) const {
    if (point.emission == Color(0) || density_ == infinity || options_.light_samples == 0 ||
        point.lamp_density == 0) {
      return point.emission;
    }
    const double cosine = glm::dot(point.facing.geometric, point.facing.to_eye);
    const double by_lamps =
        options_.light_samples * point.lamp_density * distance * distance / cosine;
    return uses_mis() ? mis_weight(density_, by_lamps) * point.emission : Color(0);
  }

  Color lamp_light(const PathPoint& point) const {
    const int count = scene_.lamps.empty() ? 0 : options_.light_samples;
    Color sum(0);
    for (int i = 0; i < count; ++i) {
      const LampPoint lamp = scene_.lamps.sample(use(PathUse::lamp, i, count));
      const dvec3 path = lamp.position - point.position;
      const double distance = glm::length(path);
      const dvec3 to_light = path / distance;
      const double cosine = -glm::dot(lamp.normal, to_light);
      if (!(cosine > 0)) {
        continue;
      }
      const BsdfValue value = evaluate(point.bsdf, point.facing, to_light);
      const double falloff =
          course() ? distance * double(scene_.lamps.size()) : distance * distance;
      const double density = count * lamp.density * falloff / cosine;
      const double weight = uses_mis() ? mis_weight(density, value.density) : 1;
      const Color light = weight / density * value.light * lamp.emission;
      if (light != Color(0)) {
        sum += arriving_share(point, to_light, distance, opaque_) * light;
      }
    }
    return sum;
  }

  // From the lights of the file: all of them, or after the first bounce a random one.
  Color scene_light(const PathPoint& point) const {
    const std::vector<RenderLight>& lights = scene_.tracer.scene.lights;
    const auto count = static_cast<std::uint32_t>(lights.size());
    if (bounce_ > 0 && count > 1) {
      const double place = count * use(PathUse::light).x;
      const std::uint32_t chosen = std::min(static_cast<std::uint32_t>(place), count - 1);
      return double(count) * light_from(lights[chosen], chosen, point);
    }
    Color sum(0);
    for (std::uint32_t i = 0; i < count; ++i) {
      sum += light_from(lights[i], i, point);
    }
    return sum;
  }

  // By the lighting equation of mode ray.
  Color light_from(const RenderLight& light, std::uint32_t index, const PathPoint& point) const {
    const Facing& facing = point.facing;
    const int count = has_rectangle(light.type) ? std::max(1, options_.light_samples) : 1;
    Color sum(0);
    for (int i = 0; i < count; ++i) {
      const glm::dvec2 on_light =
          has_rectangle(light.type) ? use(PathUse::area, i, count, index) : glm::dvec2(0.5);
      const one::Arriving here =
          one::arriving(light, one::splat3(point.position), on_light.x, on_light.y);
      const dvec3 to_light(here.to_light.x, here.to_light.y, here.to_light.z);
      if (!here.arrives || glm::dot(facing.geometric, to_light) <= 0) {
        continue;
      }
      const double cosine = glm::dot(facing.normal, to_light);
      const double mirrored = one::mirrored_cosine(one::splat3(facing.normal), here.to_light,
                                                   cosine, one::splat3(facing.to_eye));
      const Color reflected =
          std::max(0.0, cosine) * point.bsdf.diffuse +
          (mirrored > 0 ? one::power(mirrored, point.bsdf.shininess, true) : 0.0) *
              point.bsdf.glossy;
      if (reflected != Color(0)) {
        sum += arriving_share(point, to_light, here.distance, scene_.transmission) *
               (here.attenuation * here.spot_factor) * reflected;
      }
    }
    return Color(light.color) / double(count) * sum;
  }

  // What is left of light from this direction and distance.
  Color arriving_share(const PathPoint& point, const dvec3& to_light, double distance,
                       const Transmission& transmission) const {
    ++counts_.shadow;
    return scene_.tracer.accelerator.transmittance({point.position, to_light}, point.offset,
                                                   before_light * distance, transmission);
  }

  const PathScene& scene_;
  const RenderOptions& options_;
  const PathPoints& points_;
  RayCounts& counts_;
  const Transmission opaque_{{}};
  std::uint32_t bounce_ = 0;
  bool last_ = false;
  double density_ = infinity;  // of the direction of the ray; infinity: no other is possible
  Color throughput_{1};
  Color direct_{0};
  Color indirect_{0};
};

}  // namespace

Color path_light(const PathScene& scene, int x, int y, std::uint32_t index, RayCounts& counts) {
  const PathPoints points(x, y, scene.options.seed, index);
  const glm::dvec2 lens =
      scene.camera.has_lens() ? disk_of_square(points(PathUse::lens, 0)) : glm::dvec2(0);
  const Ray ray = scene.camera.ray(glm::dvec2(x, y) + points(PathUse::pixel, 0), lens);
  return Path(scene, points, counts).follow(ray);
}

}  // namespace scenefile
