#include "trace/scalar_tracer.h"

#include "scenefile/base/components.h"
#include "trace/course_cell.h"
#include "trace/scalar_rays.h"
#include "trace/scalar_shade.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The factors of reflected and refracted light.
struct Branches {
  Color mirror{0};
  Color glass{0};
};

class Integrator {
 public:
  Integrator(const Tracer& tracer, ScalarCounts& counts) : tracer_(tracer), counts_(counts) {}

  // The recursion depth is at most max_depth, which is at most 64.
  Color trace(const Path& path) {
    Recorder* const recorder = counts_.recorder;
    if (recorder == nullptr) {
      return seen_by(path);
    }
    recorder->begin_ray(path.kind, path.depth, path.ray, path.start);
    const Color color = seen_by(path);
    recorder->end_ray(color);
    return color;
  }

 private:
  Color seen_by(Path path) {
    Hit hit;
    if (!find_surface(path, hit)) {
      return Color(0);
    }
    SurfacePoint point =
        surface_point(tracer_.scene, tracer_.assets, path.ray, hit, !tracer_.course());
    if (counts_.recorder != nullptr) {
      counts_.recorder->met(path.ray, path.start, point);
    }
    const PixelDerivatives dp = hit_derivatives(path.differential, path.ray.direction, point);
    const bool inner = leaves(path, hit);
    Color color =
        inner ? Color(0) : shade(tracer_, point, path.ray.direction, dp, path.key, counts_);
    if (counts_.recorder != nullptr) {
      if (inner) {
        counts_.recorder->inner_wall();
      }
      counts_.recorder->shaded(color);
    }
    if (tracer_.options.mode == Mode::ray) {
      color += follow(path, point, dp, inner);
    }
    if (counts_.recorder != nullptr) {
      counts_.recorder->summed(color);
    }
    return tracer_.course() ? glm::clamp(color, Color(0), Color(1)) : color;
  }

  // Whether the ray hits the wall of the object that it is inside of.
  static bool leaves(const Path& path, const Hit& hit) {
    return path.inside != nullptr && same_object(*path.inside->hit, hit);
  }

  // The surface to shade. A ray inside a transparent object is first refracted or reflected at the
  // object's walls, which are not shaded; the whole passage counts as one refraction. With
  // Fresnel's equations a wall does both, and the ray ends there.
  bool find_surface(Path& path, Hit& hit) {
    while (tracer_.accelerator.closest(path.ray, path.start, infinity, hit)) {
      if (!leaves(path, hit) || tracer_.options.fresnel) {
        return true;
      }
      pass_wall(path, hit);
      if (path.depth > tracer_.options.max_depth) {
        if (counts_.recorder != nullptr) {
          counts_.recorder->trapped();
        }
        return false;
      }
    }
    return false;
  }

  void pass_wall(Path& path, const Hit& hit) {
    const SurfacePoint wall =
        surface_point(tracer_.scene, tracer_.assets, path.ray, hit, !tracer_.course());
    const glm::dvec3 normal = inner_normal(wall, path.ray.direction);
    const double ior = wall.material->ior;
    ++counts_.secondary;
    const Ray arriving = path.ray;
    const double start = path.start;
    glm::dvec3 direction;
    const bool through = refract_direction(path.ray.direction, normal, ior, direction);
    const PixelDerivatives dp = hit_derivatives(path.differential, path.ray.direction, wall);
    if (through) {
      path.inside = path.inside->around;
      refract(path, wall, dp, normal, ior, direction);
    } else {
      ++path.depth;
      mirror(path, wall, dp, normal);
    }
    if (counts_.recorder != nullptr) {
      counts_.recorder->wall(arriving, start, wall, normal, path.ray.direction, !through);
    }
  }

  // The shading normal on the side of the incoming ray; the geometric normal if interpolation has
  // turned it to the other side.
  static glm::dvec3 inner_normal(const SurfacePoint& point, const glm::dvec3& direction) {
    const bool behind = glm::dot(point.geometric, direction) > 0;
    const glm::dvec3 normal = behind ? -point.normal : point.normal;
    const glm::dvec3 geometric = behind ? -point.geometric : point.geometric;
    return glm::dot(normal, direction) < 0 ? normal : geometric;
  }

  void mirror(Path& path, const SurfacePoint& point, const PixelDerivatives& dp,
              const glm::dvec3& normal) const {
    if (!tracer_.course()) {
      path.differential =
          mirrored_differential(path.differential, path.ray.direction, point, dp, normal);
    }
    redirect(path, point, reflect_direction(path.ray.direction, normal));
  }

  void refract(Path& path, const SurfacePoint& point, const PixelDerivatives& dp,
               const glm::dvec3& normal, double eta, const glm::dvec3& direction) const {
    if (!tracer_.course()) {
      path.differential =
          refracted_differential(path.differential, path.ray.direction, point, dp, normal, eta);
    }
    redirect(path, point, direction);
  }

  void redirect(Path& path, const SurfacePoint& point, const glm::dvec3& direction) const {
    path.ray = {point.position, direction};
    path.start = start_offset(tracer_, point.position, point.hit.t);
  }

  // `inner`: at a wall of the object that the ray is inside of.
  Branches branches(const Path& path, const SurfacePoint& point, bool inner) const {
    Branches result{double(tracer_.scene.global.specular) * Color(point.material->reflective),
                    tracer_.transparency(*point.material)};
    if (inner) {
      result = {Color(0), Color(1)};
    }
    if (tracer_.options.fresnel && tracer_.options.features.refract) {
      const glm::dvec3 normal = inner_normal(point, path.ray.direction);
      const double cosine = -glm::dot(normal, path.ray.direction);
      const double share = fresnel_reflectance(cosine, eta(path, point, inner));
      result.mirror += share * result.glass;
      result.glass *= 1 - share;
    }
    return result;
  }

  Color follow(const Path& path, const SurfacePoint& point, const PixelDerivatives& dp,
               bool inner) {
    const Features& features = tracer_.options.features;
    const auto [of_mirrors, glass] = branches(path, point, inner);
    // A passage counts as one refraction: leaving is free.
    const int depth_behind = path.depth + (inner ? 0 : 1);
    const BranchOutcome of_mirror =
        outcome_of(path, features.reflect || inner, of_mirrors, path.depth + 1);
    const BranchOutcome of_glass = outcome_of(path, features.refract, glass, depth_behind);
    const bool reflects = of_mirror == BranchOutcome::followed;
    const bool refracts = of_glass == BranchOutcome::followed;
    const std::uint32_t children = std::uint32_t(reflects) + std::uint32_t(refracts);
    const bool too_many = path.budget <= children;
    if (counts_.recorder != nullptr) {
      counts_.recorder->branches(
          {reflects && too_many ? BranchOutcome::too_many : of_mirror, of_mirrors},
          {refracts && too_many ? BranchOutcome::too_many : of_glass, glass});
    }
    if (children == 0 || too_many) {
      return Color(0);
    }
    const std::uint32_t budget = (path.budget - 1) / children;
    Color sum(0);
    if (reflects) {
      const glm::dvec3 normal = inner ? inner_normal(point, path.ray.direction) : point.normal;
      Path next = child(path, of_mirrors, budget, RayKind::reflected);
      mirror(next, point, dp, normal);
      sum += of_mirrors * trace(next);
    }
    if (refracts) {
      const Inside inside{&point.hit, path.inside};
      Path next = refracted(path, point, dp, glass, budget, inside, inner);
      next.depth = depth_behind;
      sum += glass * trace(next);
    }
    return sum;
  }

  BranchOutcome outcome_of(const Path& path, bool feature, const Color& factor,
                           int depth_behind) const {
    if (!feature || factor == Color(0)) {
      return BranchOutcome::absent;
    }
    if (depth_behind > tracer_.options.max_depth) {
      return BranchOutcome::too_deep;
    }
    const bool worth = tracer_.course() || path.weight * largest(factor) >= min_weight;
    return worth ? BranchOutcome::followed : BranchOutcome::too_faint;
  }

  Path child(const Path& path, const Color& factor, std::uint32_t budget, RayKind kind) {
    ++counts_.secondary;
    return child_of(path, factor, budget, kind);
  }

  static bool enters(const Path& path, const SurfacePoint& point, bool inner) {
    return !inner && glm::dot(point.geometric, path.ray.direction) < 0;
  }

  // The ratio of the indices of refraction: this side over the other side.
  static double eta(const Path& path, const SurfacePoint& point, bool inner) {
    const double ior = point.material->ior;
    return enters(path, point, inner) ? 1 / ior : ior;
  }

  // At total internal reflection, the ray is reflected instead.
  Path refracted(const Path& path, const SurfacePoint& point, const PixelDerivatives& dp,
                 const Color& factor, std::uint32_t budget, const Inside& inside, bool inner) {
    const bool entering = enters(path, point, inner);
    const glm::dvec3 normal = inner_normal(point, path.ray.direction);
    const double ratio = eta(path, point, inner);
    Path next = child(path, factor, budget, RayKind::refracted);
    glm::dvec3 direction;
    const bool through = refract_direction(path.ray.direction, normal, ratio, direction);
    if (through) {
      refract(next, point, dp, normal, ratio, direction);
    } else {
      mirror(next, point, dp, normal);
      if (counts_.recorder != nullptr) {
        counts_.recorder->total_reflection();
      }
    }
    if (inner) {
      next.inside = path.inside->around;
    } else if (through == entering) {
      next.inside = &inside;
    }
    return next;
  }

  const Tracer& tracer_;
  ScalarCounts& counts_;
};

Color normal_color(const Tracer& tracer, const Ray& ray, Recorder* recorder) {
  Hit hit;
  if (!tracer.accelerator.closest(ray, 0, infinity, hit)) {
    return Color(0);
  }
  const SurfacePoint point = surface_point(tracer.scene, tracer.assets, ray, hit, !tracer.course());
  if (recorder != nullptr) {
    recorder->met(ray, 0, point);
  }
  return 0.5 * (point.normal + 1.0);
}

// Normals mode: like any other ray, but without lighting.
Color trace_normal(const Tracer& tracer, const Ray& ray, Recorder* recorder) {
  if (recorder == nullptr) {
    return normal_color(tracer, ray, nullptr);
  }
  recorder->begin_ray(RayKind::camera, 0, ray, 0);
  const Color color = normal_color(tracer, ray, recorder);
  recorder->summed(color);
  recorder->end_ray(color);
  return color;
}

Color trace_camera_ray(const Tracer& tracer, const Ray& ray, const RayDifferential& differential,
                       const SampleKey& key, ScalarCounts& counts) {
  ++counts.primary;
  if (tracer.options.mode == Mode::normals) {
    return trace_normal(tracer, ray, counts.recorder);
  }
  Path path;
  path.ray = ray;
  path.differential = differential;
  path.key = key;
  return Integrator(tracer, counts).trace(path);
}

}  // namespace

Color trace_sample(const Tracer& tracer, const CameraRays& camera, const CameraSample& sample,
                   ScalarCounts& counts) {
  const Ray ray = camera.ray(sample.point, sample.lens);
  const RayDifferential differential =
      tracer.course() ? RayDifferential{}
                      : camera_differential(camera, sample.point, sample.lens, sample.width);
  if (counts.recorder == nullptr) {
    return trace_camera_ray(tracer, ray, differential, sample.key, counts);
  }
  counts.recorder->begin_sample(sample.point, sample.lens);
  const Color color = trace_camera_ray(tracer, ray, differential, sample.key, counts);
  counts.recorder->end_sample(color);
  return color;
}

namespace {

Color lens_pixel(const Tracer& tracer, const CameraRays& camera, const glm::dvec2& center,
                 ScalarCounts& counts) {
  Color sum(0);
  for (const auto& [u, v] : course::lens_points) {
    sum += trace_sample(tracer, camera, {center, {u, v}, {}, {}}, counts);
  }
  return sum / double(course::lens_points.size());
}

}  // namespace

Color course_pixel(const Tracer& tracer, const CameraRays& camera, int x, int y,
                   ScalarCounts& counts) {
  const glm::dvec2 corner(x, y);
  const auto color_at = [&](const glm::dvec2& point) {
    return trace_sample(tracer, camera, {point, {}, {}, {}}, counts);
  };
  if (camera.has_lens()) {
    return lens_pixel(tracer, camera, corner + 0.5, counts);
  }
  return tracer.options.features.super_sample ? course::cell(color_at, corner, 1, 1)
                                              : color_at(corner + 0.5);
}

void take_samples(const Tracer& tracer, const CameraRays& camera, const AdaptiveSampler& sampler,
                  int x, int y, std::uint16_t refinement, PixelSamples& samples,
                  ScalarCounts& counts) {
  do {
    for (const std::uint32_t count = sampler.next_count(samples.count); samples.count < count;) {
      const std::uint64_t penumbras = counts.penumbras;
      const Color color = trace_sample(tracer, camera, sampler.sample(x, y, samples.count), counts);
      samples.add(color, counts.penumbras != penumbras);
    }
  } while (!sampler.enough(samples, refinement));
}

}  // namespace scenefile
