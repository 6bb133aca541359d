#include "scenefile/path/path_kernel.h"

#include "scenefile/base/components.h"
#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/path/path_points.h"
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
// those between surfaces that absorb nothing end too. Against the throughput itself, its square
// root costs 15 to 30 % less time for the same error (bench/path), because longer paths carry much
// of the light; roulette after 1, 2, 5 or 8 bounces costs more.
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
  Path(const PathScene& scene, const PathPoints& points, RayCounts& counts, PathRecord* record)
      : scene_(scene), options_(scene.options), points_(points), counts_(counts), record_(record) {}

  Color follow(Ray ray) {
    double t_min = 0;
    for (int bounce = 0;; ++bounce) {
      bounce_ = bounce;
      Hit hit;
      ++(bounce == 0 ? counts_.primary : counts_.secondary);
      if (!scene_.tracer.accelerator.closest(ray, t_min, infinity, hit)) {
        if (record_ != nullptr) {
          record_->escaped = true;
          record_->last = ray;
        }
        break;
      }
      const PathPoint point = path_point(scene_, ray, hit);
      if (record_ != nullptr) {
        vertex_ = &record_->vertices.emplace_back();
        vertex_->ray = ray;
        vertex_->start = t_min;
        vertex_->ray_density = density_;
        vertex_->t = hit.t;
        vertex_->source = hit.source;
        vertex_->shape = hit.shape;
        vertex_->face = hit.face;
        vertex_->mesh = hit.mesh;
        vertex_->point = point;
        vertex_->throughput = throughput_;
        vertex_->first_light = static_cast<std::uint32_t>(record_->lights.size());
      }
      add(bounce, emitted(point, hit.t));
      if (last_ || (options_.max_depth > 0 && bounce >= options_.max_depth)) {
        end(last_ ? PathEnd::direct_only : PathEnd::max_depth);
        break;
      }
      if (is_rough(point.bsdf)) {
        add(bounce + 1, light_at(point));
      }
      const glm::dvec2 choice = use(PathUse::lobe);
      const auto scatter = scene_.uniform_directions ? sample_uniformly : sample;
      const BsdfSample next =
          scatter(scattering(point), point.facing, choice.x, use(PathUse::direction));
      if (vertex_ != nullptr) {
        vertex_->next = next;
      }
      throughput_ *= next.weight;
      if (throughput_ == Color(0)) {
        end(PathEnd::absorbed);
        break;
      }
      if (!goes_on(choice.y)) {
        end(PathEnd::roulette);
        break;
      }
      last_ = options_.direct_only && !next.specular();
      density_ = next.specular() ? infinity : next.density;
      ray = {point.position, next.to_light};
      t_min = point.offset;
    }
    const double most = largest(indirect_);
    const bool clamps = options_.clamp > 0 && most > options_.clamp;
    const double clamp = options_.clamp / most;
    const Color light = clamps ? direct_ + clamp * indirect_ : direct_ + indirect_;
    if (record_ != nullptr) {
      record_->direct = direct_;
      record_->indirect = indirect_;
      record_->clamp = clamps ? clamp : 1;
      record_->light = light;
    }
    return light;
  }

 private:
  glm::dvec2 use(PathUse use, int part = 0, int parts = 1, std::uint32_t index = 0) const {
    return points_(use, bounce_, part, parts, index);
  }

  // Shaded mirrors and glass scatter nothing else.
  Bsdf scattering(const PathPoint& point) const {
    Bsdf bsdf = point.bsdf;
    if ((scene_.shaded_mirrors || scene_.shaded_glass) && point.material != mesh_no_index &&
        bsdf.mirror + bsdf.glass != Color(0)) {
      bsdf.diffuse = bsdf.glossy = Color(0);
    }
    return bsdf;
  }

  bool course() const { return options_.convention == Convention::course; }
  // Light that falls off with the distance is only found by light samples.
  bool uses_mis() const { return options_.mis && !course(); }

  // Adds light that was reflected or refracted `times` times.
  void add(int times, const Color& light) {
    (times < 2 ? direct_ : indirect_) += throughput_ * light;
  }

  void end(PathEnd end) {
    if (vertex_ != nullptr) {
      vertex_->end = end;
    }
  }

  bool goes_on(double random) {
    double share = options_.continuation;
    if (share == 0) {
      if (bounce_ + 1 < first_roulette) {
        return true;
      }
      share = std::min(most_continuation, std::sqrt(largest(throughput_)));
    }
    throughput_ /= share;
    if (vertex_ != nullptr) {
      vertex_->continuation = share;
    }
    return random < share;
  }

  // Light samples find the same lamps, except after the camera, mirrors and glass.
  Color emitted(const PathPoint& point, double distance) const {
    double weight = 1;
    double by_lamps = 0;
    if (point.emission != Color(0) && density_ != infinity && options_.light_samples > 0 &&
        point.lamp_density > 0) {
      const double cosine = glm::dot(point.facing.geometric, point.facing.to_eye);
      by_lamps = options_.light_samples * point.lamp_density * distance * distance / cosine;
      weight = uses_mis() ? mis_weight(density_, by_lamps) : 0;
    }
    const Color light = weight * point.emission;
    if (vertex_ != nullptr) {
      vertex_->emission = light;
      vertex_->emission_weight = weight;
      vertex_->emission_density = by_lamps;
    }
    return light;
  }

  // What arrives from random points on lamps, and from the lights of the file: all of them, or
  // after the first bounce a random one.
  Color light_at(const PathPoint& point) const {
    Color sum(0);
    const int lamp_points = scene_.lamps.empty() ? 0 : options_.light_samples;
    for (int i = 0; i < lamp_points; ++i) {
      sum += arriving(lamp_light(point, i, lamp_points), point, opaque_);
    }
    const auto count = static_cast<std::uint32_t>(scene_.tracer.scene.lights.size());
    if (bounce_ > 0 && count > 1) {
      const double place = count * use(PathUse::light).x;
      add_light(std::min(static_cast<std::uint32_t>(place), count - 1), count, point, sum);
    } else {
      for (std::uint32_t i = 0; i < count; ++i) {
        add_light(i, 1, point, sum);
      }
    }
    if (vertex_ != nullptr) {
      vertex_->light = sum;
    }
    return sum;
  }

  // Point `i` of `count` on lamps.
  PathLight lamp_light(const PathPoint& point, int i, int count) const {
    LampPoint lamp = scene_.lamps.sample(use(PathUse::lamp, i, count));
    const dvec3 path = lamp.position - point.position;
    PathLight light;
    light.distance = glm::length(path);
    light.to_light = path / light.distance;
    const double cosine = -glm::dot(lamp.normal, light.to_light);
    if (!(cosine > 0)) {
      return light;
    }
    lamp = scene_.lamps.seen({point.position, light.to_light}, light.distance, lamp);
    const double falloff =
        course() ? light.distance * double(scene_.lamps.size()) : light.distance * light.distance;
    const BsdfValue value = evaluate(point.bsdf, point.facing, light.to_light);
    light.lamp_cosine = cosine;
    light.lamp = lamp.triangle;
    light.lamp_weights = lamp.weights;
    light.emission = lamp.emission;
    light.reflected = value.bsdf_cosine;
    light.density = count * lamp.density * falloff / cosine;
    light.bsdf_density = value.density;
    light.weight = uses_mis() ? mis_weight(light.density, value.density) : 1;
    return light;
  }

  // Adds the light of the file, which stands for `lights` lights.
  void add_light(std::uint32_t index, std::uint32_t lights, const PathPoint& point,
                 Color& sum) const {
    const RenderLight& light = scene_.tracer.scene.lights[index];
    const int count = has_rectangle(light.type) ? std::max(1, options_.light_samples) : 1;
    for (int i = 0; i < count; ++i) {
      PathLight here = scene_light(light, index, i, count, point);
      here.density = double(count) / lights;
      sum += arriving(here, point, scene_.transmission);
    }
  }

  // Point `i` of `count` on the light, by the lighting equation of mode ray.
  PathLight scene_light(const RenderLight& light, std::uint32_t index, int i, int count,
                        const PathPoint& point) const {
    const Facing& facing = point.facing;
    const glm::dvec2 on_light =
        has_rectangle(light.type) ? use(PathUse::area, i, count, index) : glm::dvec2(0.5);
    const one::Arriving here =
        one::arriving(light, one::splat3(point.position), on_light.x, on_light.y);
    PathLight result;
    result.light = index;
    result.to_light = {here.to_light.x, here.to_light.y, here.to_light.z};
    result.distance = here.distance;
    if (!here.arrives || glm::dot(facing.geometric, result.to_light) <= 0) {
      return result;
    }
    const double cosine = glm::dot(facing.normal, result.to_light);
    const double mirrored = one::mirrored_cosine(one::splat3(facing.normal), here.to_light, cosine,
                                                 one::splat3(facing.to_eye));
    result.emission = (here.attenuation * here.spot_factor) * Color(light.color);
    result.reflected =
        std::max(0.0, cosine) * point.bsdf.diffuse +
        (mirrored > 0 ? one::power(mirrored, point.bsdf.shininess, true) : 0.0) * point.bsdf.glossy;
    return result;
  }

  // What shadows leave of it.
  Color arriving(PathLight light, const PathPoint& point, const Transmission& transmission) const {
    light.unshadowed = light.weight / light.density * light.reflected * light.emission;
    if (light.unshadowed != Color(0)) {
      ++counts_.shadow;
      light.shadow_ray = true;
      light.visibility =
          scene_.tracer.accelerator.transmittance({point.position, light.to_light}, point.offset,
                                                  before_light * light.distance, transmission);
      light.contribution = light.visibility * light.unshadowed;
    }
    if (vertex_ != nullptr) {
      record_->lights.push_back(light);
      ++vertex_->lights;
    }
    return light.contribution;
  }

  const PathScene& scene_;
  const RenderOptions& options_;
  const PathPoints& points_;
  RayCounts& counts_;
  PathRecord* const record_;      // null: nothing is recorded
  PathVertex* vertex_ = nullptr;  // the current one, if it is recorded
  const Transmission opaque_{{}};
  std::uint32_t bounce_ = 0;
  bool last_ = false;
  double density_ = infinity;  // of the direction of the ray; infinity: no other is possible
  Color throughput_{1};
  Color direct_{0};
  Color indirect_{0};
};

}  // namespace

Color path_light(const PathScene& scene, int x, int y, std::uint32_t index, RayCounts& counts,
                 PathRecord* record) {
  const PathPoints points(x, y, scene.options.seed, index);
  const glm::dvec2 lens =
      scene.camera.has_lens() ? disk_of_square(points(PathUse::lens, 0)) : glm::dvec2(0);
  const glm::dvec2 point = glm::dvec2(x, y) + points(PathUse::pixel, 0);
  if (record != nullptr) {
    record->vertices.clear();
    record->lights.clear();
    record->escaped = false;
    record->point = point;
    record->lens = lens;
  }
  return Path(scene, points, counts, record).follow(scene.camera.ray(point, lens));
}

}  // namespace scenefile
