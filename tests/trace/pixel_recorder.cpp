#include "trace/pixel_recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scenefile {

PixelRecorder::PixelRecorder(const Tracer& tracer, std::optional<std::uint32_t> shown)
    : tracer_(tracer), shown_(shown) {}

void PixelRecorder::begin_sample(const glm::dvec2& point, const glm::dvec2& lens) {
  in_full_ = shown_ == samples.size();
  SampleRecord& sample = samples.emplace_back();
  sample.point = point;
  sample.lens = lens;
}

void PixelRecorder::end_sample(const Color& color) {
  samples.back().color = color;
  in_full_ = false;
}

RayRecord* PixelRecorder::current() {
  return in_full_ && !stack_.empty() ? &rays[stack_.back()] : nullptr;
}

void PixelRecorder::begin_ray(RayKind kind, int depth, const Ray& ray, double start) {
  ++samples.back().rays;
  if (!in_full_) {
    return;
  }
  const auto index = static_cast<std::uint32_t>(rays.size());
  RayRecord record;
  record.kind = kind;
  record.depth = depth;
  record.ray = ray;
  record.start = start;
  record.total_reflection = std::exchange(total_reflection_, false);
  if (RayRecord* const parent = current(); parent != nullptr) {
    BranchRecord& branch = kind == RayKind::reflected ? parent->mirror : parent->glass;
    branch.ray = index;
    record.parent = stack_.back();
    record.weight = parent->weight * branch.factor;
  }
  rays.push_back(std::move(record));
  stack_.push_back(index);
}

void PixelRecorder::end_ray(const Color& color) {
  if (RayRecord* const ray = current(); ray != nullptr) {
    ray->color = color;
    stack_.pop_back();
  }
}

ObjectRef PixelRecorder::object_at(const Ray& ray, double start, const Hit& hit) const {
  const double infinity = std::numeric_limits<double>::infinity();
  return {hit.source, tracer_.accelerator.instances_of_closest(ray, start, infinity)};
}

void PixelRecorder::wall(const Ray& ray, double start, const SurfacePoint& point,
                         const glm::dvec3& normal, const glm::dvec3& direction, bool mirrored) {
  if (RayRecord* const record = current(); record != nullptr) {
    record->walls.push_back({object_at(ray, start, point.hit), point.hit.t, point.position, normal,
                             direction, mirrored});
  }
}

void PixelRecorder::trapped() {
  if (RayRecord* const record = current(); record != nullptr) {
    record->trapped = true;
  }
}

void PixelRecorder::met(const Ray& ray, double start, const SurfacePoint& point) {
  if (!samples.back().object.has_value() && samples.back().rays == 1) {
    samples.back().object = object_at(ray, start, point.hit);
  }
  RayRecord* const record = current();
  if (record == nullptr) {
    return;
  }
  met_ = point.hit;
  const DAffine& object_from_world = point.hit.object_from_world;
  SurfaceRecord& s = record->surface.emplace();
  s.object = object_at(ray, start, point.hit);
  s.shape = point.hit.shape;
  s.face = point.hit.face;
  s.mesh = point.hit.mesh;
  s.triangle = point.hit.triangle;
  s.material = point.hit.material;
  s.ray = ray;
  s.object_ray = {object_from_world.point(ray.origin), object_from_world.vector(ray.direction)};
  s.t = point.hit.t;
  s.position = point.position;
  s.object_position = point.hit.object_point;
  s.object_normal = point.object.normal;
  s.normal = point.normal;
  s.geometric = point.geometric;
  s.uv = point.object.uv;
  s.has_uv = point.has_uv;
}

void PixelRecorder::textured(const Texture& texture, const RenderMaterial& material,
                             const glm::dvec2& uv, const Color& color) {
  if (RayRecord* const record = current(); record != nullptr) {
    const glm::ivec2 texel = texel_at(texture, material.texture, uv);
    record->surface->texture = {material.texture.file, texel,
                                lookup_nearest(texture, material.texture, uv), color,
                                double(material.blend)};
  }
}

void PixelRecorder::surface(const SurfacePoint& bumped, const Color& ambient, const Color& diffuse,
                            const Color& specular) {
  if (RayRecord* const record = current(); record != nullptr) {
    SurfaceRecord& s = *record->surface;
    s.bumped = bumped.normal != s.normal;
    s.normal = bumped.normal;
    s.diffuse_color = diffuse;
    s.specular_color = specular;
    record->ambient = ambient;
  }
}

// Each object once, as it counts for the shadow; objects behind an opaque one do not count.
std::vector<Blocker> PixelRecorder::blockers(const Ray& ray, double start, double end) const {
  std::vector<Blocker> found;
  std::vector<Hit> hits;
  Hit hit;
  for (double from = start; found.size() < max_blockers; from = hit.t) {
    if (!tracer_.accelerator.closest(ray, from, end, hit)) {
      break;
    }
    const auto same = [&](const Hit& other) { return same_object(hit, other); };
    if (std::any_of(hits.begin(), hits.end(), same)) {
      continue;
    }
    hits.push_back(hit);
    const glm::i64vec3& density = tracer_.transmission.density(hit.material);
    found.push_back({object_at(ray, from, hit), hit.t, Transmission::factor(density), same(*met_)});
    if (Transmission::blocks(density)) {
      break;
    }
  }
  return found;
}

void PixelRecorder::shadow(const Ray& ray, double start, double end, const Color& left) {
  if (current() != nullptr) {
    pending_shadow_.shadow_ray = true;
    pending_shadow_.visibility = left;
    if (left != Color(1)) {
      pending_shadow_.blockers = blockers(ray, start, end);
    }
  }
}

void PixelRecorder::lit(const Illumination& light, double n_dot_l, double r_dot_v,
                        const Color& diffuse, const Color& specular, const Color& contribution) {
  if (current() == nullptr) {
    return;
  }
  LightSample sample = std::exchange(pending_shadow_, {});
  sample.to_light = light.to_light;
  sample.distance = light.distance;
  sample.attenuation = light.attenuation;
  sample.spot_factor = light.spot_factor;
  sample.color = light.color;
  sample.n_dot_l = n_dot_l;
  sample.r_dot_v = r_dot_v;
  sample.diffuse = diffuse;
  sample.specular = specular;
  sample.contribution = contribution;
  pending_samples_.push_back(std::move(sample));
}

void PixelRecorder::light(std::uint32_t index, std::uint32_t taken, const Color& contribution) {
  if (RayRecord* const record = current(); record != nullptr) {
    const Unlit unlit = pending_samples_.empty() ? Unlit::out_of_reach : Unlit::no;
    record->lights.push_back(
        {index, unlit, taken, std::exchange(pending_samples_, {}), contribution});
  }
}

void PixelRecorder::light_of_other_mode(std::uint32_t index) {
  if (RayRecord* const record = current(); record != nullptr) {
    record->lights.push_back({index, Unlit::in_this_mode, 0, {}, Color(0)});
  }
}

void PixelRecorder::inner_wall() {
  if (RayRecord* const record = current(); record != nullptr) {
    record->inner_wall = true;
  }
}

void PixelRecorder::shaded(const Color& local) {
  if (RayRecord* const record = current(); record != nullptr) {
    record->local = local;
  }
}

void PixelRecorder::branches(const BranchRecord& mirror, const BranchRecord& glass) {
  if (RayRecord* const record = current(); record != nullptr) {
    record->mirror = mirror;
    record->glass = glass;
  }
}

void PixelRecorder::summed(const Color& sum) {
  if (RayRecord* const record = current(); record != nullptr) {
    record->sum = sum;
  }
}

}  // namespace scenefile
