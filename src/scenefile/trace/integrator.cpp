#include "scenefile/trace/integrator.h"

#include "scenefile/trace/optics.h"
#include "scenefile/trace/sequence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Fine profile: light that can change the picture by less is not followed.
constexpr double min_weight = 1.0 / 1024;

// A ray and all that come of it are at most so many. Physical materials stay far below; the bound
// is for scenes whose mirrors and glass give back more than they get.
constexpr std::uint32_t rays_of_a_sample = 4096;

// The transparent object that a ray is in, and those around it.
struct Inside {
  const Hit* object = nullptr;
  const Inside* around = nullptr;
};

// A ray on its way.
struct Path {
  Ray ray;
  RayCone cone;
  SampleKey key;
  double start = 0;                         // smallest t of a hit
  int depth = 0;                            // reflections and refractions so far
  double weight = 1;                        // share of the pixel that the ray can still change
  std::uint32_t budget = rays_of_a_sample;  // rays that it may still become, itself included
  const Inside* inside = nullptr;
};

double largest(const Color& c) {
  return std::max({c.x, c.y, c.z});
}

class Integrator {
 public:
  Integrator(const Tracer& tracer, RayCounts& counts) : tracer_(tracer), counts_(counts) {}

  // Recursion ends at max_depth, which is at most 64.
  Color trace(Path path) {
    Hit hit;
    if (!find_surface(path, hit)) {
      return Color(0);
    }
    SurfacePoint point =
        surface_point(tracer_.scene, tracer_.assets, path.ray, hit, !tracer_.course());
    const double width = path.cone.width_at(hit.t);
    Color color = shade(tracer_, point, path.ray.direction, width, path.key, counts_);
    if (tracer_.options.mode == Mode::ray && path.depth < tracer_.options.max_depth) {
      color += follow(path, point);
    }
    return tracer_.course() ? glm::clamp(color, Color(0), Color(1)) : color;
  }

 private:
  // The surface that the ray lights up on. A ray inside a transparent object leaves it on the way,
  // bent or mirrored at its walls: those have no light of their own, and the whole passage counts
  // as one refraction.
  bool find_surface(Path& path, Hit& hit) {
    while (tracer_.accelerator.closest(path.ray, path.start, infinity, hit)) {
      if (path.inside == nullptr || !same_object(*path.inside->object, hit)) {
        return true;
      }
      pass_wall(path, hit);
      if (path.depth > tracer_.options.max_depth) {
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
    glm::dvec3 direction;
    if (refract_direction(path.ray.direction, normal, ior, direction)) {
      path.inside = path.inside->around;
      redirect(path, wall, direction, std::abs(ior - 1));
    } else {
      ++path.depth;
      redirect(path, wall, reflect_direction(path.ray.direction, normal), 2);
    }
  }

  // The shading normal on the side that the ray comes from; the geometric one where interpolation
  // has turned it to the other side.
  static glm::dvec3 inner_normal(const SurfacePoint& point, const glm::dvec3& direction) {
    const bool behind = glm::dot(point.geometric, direction) > 0;
    const glm::dvec3 normal = behind ? -point.normal : point.normal;
    const glm::dvec3 geometric = behind ? -point.geometric : point.geometric;
    return glm::dot(normal, direction) < 0 ? normal : geometric;
  }

  void redirect(Path& path, const SurfacePoint& point, const glm::dvec3& direction,
                double turning) const {
    if (!tracer_.course()) {
      path.cone = bent_cone(point, path.cone, point.hit.t, turning);
    }
    path.ray = {point.position, direction};
    path.start = tracer_.start_offset(point.position, point.hit.t);
  }

  Color follow(const Path& path, const SurfacePoint& point) {
    const Features& features = tracer_.options.features;
    const Color mirror = double(tracer_.scene.global.specular) * Color(point.material->reflective);
    const Color glass = tracer_.transparency(*point.material);
    const bool reflects = features.reflect && worth(path, mirror);
    const bool refracts = features.refract && worth(path, glass);
    const std::uint32_t children = std::uint32_t(reflects) + std::uint32_t(refracts);
    if (children == 0 || path.budget <= children) {
      return Color(0);
    }
    const std::uint32_t budget = (path.budget - 1) / children;
    Color sum(0);
    if (reflects) {
      const glm::dvec3 direction = reflect_direction(path.ray.direction, point.normal);
      Path next = child(path, mirror, budget, 1);
      redirect(next, point, direction, 2);
      sum += mirror * trace(next);
    }
    if (refracts) {
      const Inside inside{&point.hit, path.inside};
      sum += glass * trace(refracted(path, point, glass, budget, inside));
    }
    return sum;
  }

  bool worth(const Path& path, const Color& factor) const {
    if (tracer_.course()) {
      return factor != Color(0);
    }
    return path.weight * largest(factor) >= min_weight;
  }

  Path child(const Path& path, const Color& factor, std::uint32_t budget, std::uint32_t kind) {
    ++counts_.secondary;
    Path next = path;
    next.depth = path.depth + 1;
    next.weight = path.weight * largest(factor);
    next.budget = budget;
    next.key.light_samples = 1;
    next.key.pattern = mixed_bits(path.key.pattern, kind);
    return next;
  }

  // At total internal reflection the light that would have left is mirrored.
  Path refracted(const Path& path, const SurfacePoint& point, const Color& factor,
                 std::uint32_t budget, const Inside& inside) {
    const bool entering = glm::dot(point.geometric, path.ray.direction) < 0;
    const glm::dvec3 normal = inner_normal(point, path.ray.direction);
    const double ior = point.material->ior;
    const double eta = entering ? 1 / ior : ior;
    Path next = child(path, factor, budget, 2);
    glm::dvec3 direction;
    const bool through = refract_direction(path.ray.direction, normal, eta, direction);
    if (through) {
      redirect(next, point, direction, std::abs(eta - 1));
    } else {
      redirect(next, point, reflect_direction(path.ray.direction, normal), 2);
    }
    if (through == entering) {
      next.inside = &inside;
    }
    return next;
  }

  const Tracer& tracer_;
  RayCounts& counts_;
};

Color normal_color(const Tracer& tracer, const Ray& ray) {
  Hit hit;
  if (!tracer.accelerator.closest(ray, 0, infinity, hit)) {
    return Color(0);
  }
  const SurfacePoint point = surface_point(tracer.scene, tracer.assets, ray, hit, !tracer.course());
  return 0.5 * (point.normal + 1.0);
}

}  // namespace

Color trace_camera_ray(const Tracer& tracer, const Ray& ray, const RayCone& cone,
                       const SampleKey& key, RayCounts& counts) {
  ++counts.primary;
  if (tracer.options.mode == Mode::normals) {
    return normal_color(tracer, ray);
  }
  Path path;
  path.ray = ray;
  path.cone = cone;
  path.key = key;
  return Integrator(tracer, counts).trace(path);
}

}  // namespace scenefile
