// Keeps what a wavefront computes, for explain.h; used where `recording` is true. No include guard:
// included once for each number of lanes, after shading_points-inl.h.

#include "scenefile/trace/ray_tree_recorder.h"

#include <optional>

namespace scenefile::SCENEFILE_LANES {

inline RayRecord started_ray(RayKind kind, int depth, const Ray& ray, double start) {
  RayRecord record;
  record.kind = kind;
  record.depth = depth;
  record.ray = ray;
  record.start = start;
  return record;
}

inline Ray ray_at(const RayQueue& rays, std::uint32_t r) {
  const int i = static_cast<int>(r);
  return {get(rays.origin, i), get(rays.direction, i)};
}

inline void record_camera_rays(const RayQueue& rays, RayTreeRecorder& recorder) {
  recorder.rays.clear();
  for (int i = 0; i < rays.count; ++i) {
    const auto r = static_cast<std::uint32_t>(i);
    recorder.rays.push_back(
        started_ray(RayKind::camera, rays.depth[i], ray_at(rays, r), rays.start[i]));
  }
}

/// A reflected or refracted ray, whose record has the index of its node.
inline void record_child(const Path& path, const Color& factor, std::uint32_t parent,
                         RayTreeRecorder& recorder) {
  const auto index = static_cast<std::uint32_t>(recorder.rays.size());
  RayRecord record = started_ray(path.kind, path.depth, path.ray, path.start);
  record.parent = parent;
  RayRecord& cause = recorder.rays[parent];
  record.weight = cause.weight * factor;
  (path.kind == RayKind::reflected ? cause.mirror : cause.glass).ray = index;
  recorder.rays.push_back(std::move(record));
}

inline std::optional<TextureRecord> texture_record(const WavefrontScene& scene,
                                                   const ShadingPoints& points,
                                                   const RecordedPoints& recorded, int k) {
  if (!recorded.textured[k]) {
    return std::nullopt;
  }
  const RenderMaterial& material = *points.material[k]->material;
  const Texture& texture = scene.tracer.assets.textures[material.texture.file];
  const glm::dvec2 uv(points.u[k], points.v[k]);
  return TextureRecord{material.texture.file, texel_at(texture, material.texture, uv),
                       lookup_nearest(texture, material.texture, uv), get(recorded.texture, k),
                       double(material.blend)};
}

/// The surfaces at the points. `lit`: they are going to be lit.
inline void record_met(const WavefrontScene& scene, const RayQueue& rays, const HitQueue& hits,
                       bool lit, const ShadingPoints& points, RayTreeRecorder& recorder) {
  const RecordedPoints& recorded = recorder.points;
  for (int k = 0; k < points.count; ++k) {
    const std::uint32_t r = points.ray[k];
    const Ray ray = ray_at(rays, r);
    const Hit hit = hit_of(scene, hits, r, ray);
    RayRecord& record = recorder.of(rays, r);
    SurfaceRecord& s = record.surface.emplace();
    s.object = object_at(scene.tracer, ray, rays.start[r], hit.source);
    s.shape = hit.shape;
    s.face = hit.face;
    s.mesh = hit.mesh;
    s.triangle = hit.triangle;
    s.material = hit.material;
    s.ray = ray;
    s.object_ray = {hit.object_from_world.point(ray.origin),
                    hit.object_from_world.vector(ray.direction)};
    s.t = points.t[k];
    s.position = get(points.position, k);
    s.object_position = hit.object_point;
    s.object_normal = get(recorded.object_normal, k);
    s.normal = get(points.normal, k);
    s.geometric = get(points.geometric, k);
    s.bumped = recorded.bumped[k];
    s.uv = {points.u[k], points.v[k]};
    s.has_uv = recorded.has_uv[k];
    if (lit) {
      s.texture = texture_record(scene, points, recorded, k);
      s.diffuse_color = get(points.diffuse, k);
      s.specular_color = get(points.specular, k);
      record.ambient = get(points.color, k);
    }
    if (scene.tracer.options.mode == Mode::ray) {
      record.mirror.factor = color_of(points.material[k]->mirror);
      record.glass.factor = color_of(points.material[k]->glass);
    }
  }
}

inline void record_local(const RayQueue& rays, const ShadingPoints& points,
                         RayTreeRecorder& recorder) {
  for (int k = 0; k < points.count; ++k) {
    recorder.of(rays, points.ray[k]).local = get(points.color, k);
  }
}

/// Points on walls of the objects that the rays are in, which are not lit.
inline void record_inner_walls(const WavefrontScene& scene, const RayQueue& rays,
                               const WavefrontMemory& memory, RayTreeRecorder& recorder) {
  record_met(scene, rays, memory.hits, false, memory.walls, recorder);
  for (int k = 0; k < memory.walls.count; ++k) {
    recorder.of(rays, memory.walls.ray[k]).inner_wall = true;
  }
}

/// Before the samples of a light.
inline void record_light(const RayQueue& rays, const ShadingPoints& points, std::uint32_t index,
                         bool shines, RayTreeRecorder& recorder) {
  for (int k = 0; k < points.count; ++k) {
    LightRecord& light = recorder.of(rays, points.ray[k]).lights.emplace_back();
    light.light = index;
    light.unlit = shines ? Unlit::out_of_reach : Unlit::in_this_mode;
    light.taken = 0;
  }
}

/// The fraction of light that shadows leave at point k.
inline Color left_of(const WavefrontScene& scene, const DirectLight& light, int k) {
  const bool blocked = (light.blocked[k / lanes] >> k % lanes & 1) != 0;
  return blocked ? Color(0) : scene.transmissive_shadows ? get(light.left, k) : Color(1);
}

/// A sample of a light at point k, which it reaches. `shadows`: shadow rays are traced.
inline LightSample light_sample(const WavefrontScene& scene, const RayQueue& rays,
                                const WavefrontMemory& memory, bool shadows, int k) {
  const ShadingPoints& points = memory.points;
  const DirectLight& light = memory.light;
  const RecordedLight& recorded = *light.recorded;
  LightSample sample;
  sample.to_light = get(light.to_light, k);
  sample.distance = recorded.distance[k];
  sample.attenuation = recorded.attenuation[k];
  sample.spot_factor = recorded.spot_factor[k];
  sample.color = light.share[k] * Color(scene.tracer.scene.lights[light.index].color);
  sample.n_dot_l = recorded.n_dot_l[k];
  sample.r_dot_v = recorded.r_dot_v[k];
  sample.diffuse = get(recorded.diffuse, k);
  sample.specular = get(recorded.specular, k);
  sample.contribution = get(recorded.contribution, k);
  sample.shadow_ray = shadows && (light.asks[k / lanes] >> k % lanes & 1) != 0;
  if (sample.shadow_ray) {
    sample.visibility = left_of(scene, light, k);
  }
  if (sample.visibility != Color(1)) {
    const std::uint32_t r = points.ray[k];
    const Hit hit = hit_of(scene, memory.hits, r, ray_at(rays, r));
    sample.blockers = blockers_of(scene.tracer, {get(points.position, k), sample.to_light},
                                  points.offset[k], light.end[k], hit);
  }
  return sample;
}

inline void record_light_sample(const WavefrontScene& scene, const RayQueue& rays,
                                WavefrontMemory& memory, bool shadows) {
  for (int k = 0; k < memory.points.count; ++k) {
    LightRecord& light = memory.recorder->of(rays, memory.points.ray[k]).lights.back();
    ++light.taken;
    if ((memory.light.recorded->arrives[k / lanes] >> k % lanes & 1) != 0) {
      light.unlit = Unlit::no;
      light.samples.push_back(light_sample(scene, rays, memory, shadows, k));
    }
  }
}

/// After the samples of a light.
inline void record_light_sums(const RayQueue& rays, const ShadingPoints& points,
                              const DirectLight& light, RayTreeRecorder& recorder) {
  for (int k = 0; k < points.count; ++k) {
    recorder.of(rays, points.ray[k]).lights.back().contribution =
        get(light.recorded->contribution, k);
  }
}

/// `too_many`: the ray may not cause those that would be followed.
inline void record_branches(BranchRecord mirror, BranchRecord glass, bool too_many,
                            RayRecord& record) {
  for (BranchRecord* const branch : {&mirror, &glass}) {
    if (too_many && branch->outcome == BranchOutcome::followed) {
      branch->outcome = BranchOutcome::too_many;
    }
  }
  record.mirror = mirror;
  record.glass = glass;
}

}  // namespace scenefile::SCENEFILE_LANES
