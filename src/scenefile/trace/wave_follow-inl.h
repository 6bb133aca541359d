// Follows the rays of a wave through reflections and refractions, and sums up colors. No include
// guard: included once for each instruction set, after wave_light-inl.h.

#include "scenefile/trace/wave_memory.h"

namespace scenefile::SCENEFILE_LANES {

// The shading normal on the side of the incoming ray; the geometric normal if interpolation has
// turned it to the other side.
inline V3 facing_normal(const V3& normal, const V3& geometric, const V3& direction) {
  const M behind = dot(geometric, direction) > splat(0);
  const V3 turned = select(behind, -normal, normal);
  return select(dot(turned, direction) < splat(0), turned, select(behind, -geometric, geometric));
}

// The directions of the secondary rays of a chunk.
struct Onward {
  alignas(64) double mirrored[3][lanes];
  alignas(64) double refracted[3][lanes];
  alignas(64) double mirrored_steps[2][3][lanes];
  alignas(64) double refracted_steps[2][3][lanes];
  alignas(64) double cosine[lanes] = {};  // of the angle between ray and normal
  unsigned through = 0;                   // bits: refracted, not mirrored inside
  unsigned entering = 0;                  // bits: from the outside
};

inline void store_rows(const Steps& steps, double (&to)[2][3][lanes]) {
  store_rows(steps.x, to[0]);
  store_rows(steps.y, to[1]);
}

inline Steps turns_at(const WavePoints& points, int at, const V3& wanted) {
  return on_side(load_steps(points.turns, at), load3(points.geometric, at), wanted);
}

// `inner`: the rays are inside of objects and hit their walls.
inline void find_mirrored(const WaveScene& scene, const WaveRays& rays, const WavePoints& points,
                          int at, bool inner, Onward& onward) {
  const V3 direction = load3(points.direction, at);
  const V3 normal = load3(points.normal, at);
  const V3 facing = inner ? facing_normal(normal, load3(points.geometric, at), direction) : normal;
  store_rows(mirrored(direction, facing), onward.mirrored);
  if (scene.by_footprint) {
    store_rows(
        mirrored_steps(direction, facing, gather_steps(rays.direction_steps, points.ray + at),
                       turns_at(points, at, facing)),
        onward.mirrored_steps);
  }
}

inline void find_refracted(const WaveScene& scene, const WaveRays& rays, const WavePoints& points,
                           int at, bool inner, Onward& onward) {
  alignas(64) double iors[lanes];
  for (int i = 0; i < lanes; ++i) {
    iors[i] = points.material[at + i]->ior;
  }
  const V3 direction = load3(points.direction, at);
  const V3 geometric = load3(points.geometric, at);
  const V3 facing = facing_normal(load3(points.normal, at), geometric, direction);
  const M entering = dot(geometric, direction) < splat(0);
  const F ior = load(iors);
  const F eta = inner ? ior : select(entering, splat(1) / ior, ior);
  const Refracted found = refraction(direction, facing, eta);
  store_rows(select(found.through, found.direction, mirrored(direction, facing)), onward.refracted);
  if (scene.by_footprint) {
    const Steps before = gather_steps(rays.direction_steps, points.ray + at);
    const Steps turns = turns_at(points, at, facing);
    const Steps through = refracted_steps(direction, facing, eta, before, turns);
    const Steps back = mirrored_steps(direction, facing, before, turns);
    store_rows(
        Steps{select(found.through, through.x, back.x), select(found.through, through.y, back.y)},
        onward.refracted_steps);
  }
  store(-dot(facing, direction), onward.cosine);
  onward.through = bits(found.through);
  onward.entering = inner ? 0 : bits(entering);
}

// The path of ray r.
inline Path path_of(const WaveRays& rays, std::uint32_t r) {
  Path path;
  path.ray = {get(rays.origin, static_cast<int>(r)), get(rays.direction, static_cast<int>(r))};
  path.start = rays.start[r];
  path.depth = rays.depth[r];
  path.weight = rays.weight[r];
  path.key = rays.key[r];
  path.budget = rays.budget[r];
  path.inside = rays.inside[r];
  return path;
}

inline void push(const WaveScene& scene, const Path& path, std::uint32_t node, WaveRays& rays) {
  const int i = rays.count++;
  put(path.ray.origin, rays.origin, i);
  put(path.ray.direction, rays.direction, i);
  rays.start[i] = path.start;
  rays.node[i] = node;
  rays.depth[i] = path.depth;
  rays.weight[i] = path.weight;
  if (scene.by_footprint) {
    put(path.differential.origin.x, rays.origin_steps.x, i);
    put(path.differential.origin.y, rays.origin_steps.y, i);
    put(path.differential.direction.x, rays.direction_steps.x, i);
    put(path.differential.direction.y, rays.direction_steps.y, i);
  }
  rays.key[i] = path.key;
  rays.budget[i] = path.budget;
  rays.inside[i] = path.inside;
}

// Continues the path of point k with a secondary ray.
inline void redirect(const WaveScene& scene, const WavePoints& points, int k, int lane,
                     const double (&direction)[3][lanes], const double (&steps)[2][3][lanes],
                     Path& path) {
  if (scene.by_footprint) {
    path.differential = {{get(points.steps.x, k), get(points.steps.y, k)},
                         {lane_of(steps[0], lane), lane_of(steps[1], lane)}};
  }
  path.ray = {get(points.position, k), lane_of(direction, lane)};
  path.start = points.offset[k];
}

// Adds the light of a reflected or refracted ray to its parent.
inline void arrive(WaveMemory& memory, std::uint32_t ray, const WaveNode& child,
                   const Color& seen) {
  WaveNode& node = memory.nodes[ray];
  const bool mirrored = child.kind == RayKind::reflected;
  (mirrored ? memory.links[ray].mirrored : memory.links[ray].refracted) = seen;
  (mirrored ? node.mirrored : node.refracted) = true;
  node.penumbra = node.penumbra || child.penumbra;
  node.signature = extended_signature(node.signature, child.signature + (mirrored ? 1 : 2));
  node.bounces = std::max(node.bounces, child.bounces);
}

inline void add_child(const WaveScene& scene, WaveMemory& memory, WaveRays& rays, const Path& path,
                      const Color& factor, std::uint32_t parent, RayCounts& counts) {
  ++counts.secondary;
  if (rays.count == wave_rays || memory.node_count == wave_nodes) {
    memory.full = true;
    return;
  }
  const auto index = static_cast<std::uint32_t>(memory.node_count++);
  WaveNode& node = memory.nodes[index];
  node = {};
  memory.links[index].factor = factor;
  node.parent = parent;
  node.kind = path.kind;
  node.bounces = static_cast<std::uint8_t>(path.depth);
  push(scene, path, index, rays);
  if constexpr (recording) {
    record_child(path, factor, parent, *memory.trail);
  }
}

// The object that the path enters at point k.
inline const Inside* enter(const WaveScene& scene, WaveMemory& memory, const WavePoints& points,
                           int k, const Path& path) {
  if (memory.inside_count == wave_insides) {
    memory.full = true;
    return path.inside;
  }
  const int i = memory.inside_count++;
  memory.objects[i] = hit_of(scene, memory.hits, points.ray[k], path.ray);
  memory.insides[i] = {&memory.objects[i], path.inside};
  return &memory.insides[i];
}

// The factors of reflected and refracted light.
struct Branches {
  Color mirror;
  Color glass;
};

inline Branches branches_of(const WaveScene& scene, const WaveMaterial& material, bool inner,
                            double cosine, double eta) {
  Branches result{color_of(material.mirror), color_of(material.glass)};
  if (inner) {
    result = {Color(0), Color(1)};
  }
  if (scene.fresnel) {
    const double share = fresnel_reflectance(cosine, eta);
    result.mirror += share * result.glass;
    result.glass *= 1 - share;
  }
  return result;
}

// `inner`: the point is on a wall of the object that its ray is in; both ways are followed.
inline void follow_point(const WaveScene& scene, WaveMemory& memory, const WaveRays& from,
                         WaveRays& to, const WavePoints& points, bool inner, int k, int lane,
                         const Onward& onward, RayCounts& counts) {
  const WaveMaterial& material = *points.material[k];
  const std::uint32_t ray = points.ray[k];
  if (!material.mirrors && !material.refracts && !inner) {
    return;
  }
  const Features& features = scene.tracer.options.features;
  const int most = scene.tracer.options.max_depth;
  const bool entering = (onward.entering >> lane & 1) != 0;
  const double eta = entering ? 1 / material.ior : material.ior;
  const auto [mirror, glass] = branches_of(scene, material, inner, onward.cosine[lane], eta);
  const auto fate = [&](bool feature, const Color& factor, int depth_behind) {
    if (!feature || factor == Color(0)) {
      return Fate::absent;
    }
    if (depth_behind > most) {
      return Fate::too_deep;
    }
    const bool worth = scene.course || from.weight[ray] * largest(factor) >= min_weight;
    return worth ? Fate::followed : Fate::too_faint;
  };
  // A passage counts as one refraction: leaving is free.
  const int depth_behind = from.depth[ray] + (inner ? 0 : 1);
  const Fate of_mirror = fate(features.reflect || inner, mirror, from.depth[ray] + 1);
  const Fate of_glass = fate(features.refract, glass, depth_behind);
  const bool mirrors = of_mirror == Fate::followed;
  const bool refracts = of_glass == Fate::followed;
  const std::uint32_t children = std::uint32_t(mirrors) + std::uint32_t(refracts);
  const bool too_many = from.budget[ray] <= children;
  if constexpr (recording) {
    record_branches({of_mirror, mirror}, {of_glass, glass}, too_many, memory.trail->of(from, ray));
  }
  if (children == 0 || too_many) {
    return;
  }
  const Path path = path_of(from, ray);
  const std::uint32_t budget = (path.budget - 1) / children;
  const std::uint32_t parent = from.node[ray];
  if (mirrors) {
    Path next = child_of(path, mirror, budget, RayKind::reflected);
    redirect(scene, points, k, lane, onward.mirrored, onward.mirrored_steps, next);
    add_child(scene, memory, to, next, mirror, parent, counts);
  }
  if (refracts) {
    const bool through = (onward.through >> lane & 1) != 0;
    Path next = child_of(path, glass, budget, RayKind::refracted);
    next.depth = depth_behind;
    if (inner) {
      next.inside = path.inside->around;
    } else if (through == entering) {
      next.inside = enter(scene, memory, points, k, path);
    }
    redirect(scene, points, k, lane, onward.refracted, onward.refracted_steps, next);
    add_child(scene, memory, to, next, glass, parent, counts);
    if constexpr (recording) {
      memory.trail->rays.back().total_reflection = !through;
    }
  }
}

/// Adds the secondary rays of the points.
inline void follow_points(const WaveScene& scene, WaveMemory& memory, const WaveRays& from,
                          WaveRays& to, const WavePoints& points, bool inner, RayCounts& counts) {
  for (int at = 0; at < points.count; at += lanes) {
    const int end = std::min(points.count, at + lanes);
    const auto some = [&](bool WaveMaterial::*has) {
      return std::any_of(points.material + at, points.material + end,
                         [&](const WaveMaterial* m) { return m->*has; });
    };
    const bool refracts = inner || some(&WaveMaterial::refracts);
    const bool mirrors = (scene.fresnel && refracts) || some(&WaveMaterial::mirrors);
    Onward onward;
    if (mirrors) {
      find_mirrored(scene, from, points, at, inner, onward);
    }
    if (refracts) {
      find_refracted(scene, from, points, at, inner, onward);
    }
    for (int k = at; k < end && (mirrors || refracts); ++k) {
      follow_point(scene, memory, from, to, points, inner, k, k - at, onward, counts);
    }
  }
}

// The ray of point k of the walls continues in `direction`.
inline void record_wall(const WaveScene& scene, const WaveRays& from, WaveMemory& memory, int k,
                        const glm::dvec3& direction, bool mirrored) {
  const WavePoints& walls = memory.walls;
  const std::uint32_t r = walls.ray[k];
  const Ray ray = ray_at(from, r);
  const Hit hit = hit_of(scene, memory.hits, r, ray);
  const V3 facing = facing_normal(splat3(get(walls.normal, k)), splat3(get(walls.geometric, k)),
                                  splat3(ray.direction));
  alignas(64) double normal[3][lanes];
  store_rows(facing, normal);
  memory.trail->of(from, r).walls.push_back(
      {object_at(scene.tracer, ray, from.start[r], hit.source), walls.t[k], get(walls.position, k),
       lane_of(normal, 0), direction, mirrored});
}

inline void pass_wall(const WaveScene& scene, WaveMemory& memory, const WaveRays& from,
                      WaveRays& to, int k, int lane, const Onward& onward, RayCounts& counts) {
  const WavePoints& walls = memory.walls;
  const std::uint32_t ray = walls.ray[k];
  const bool through = (onward.through >> lane & 1) != 0;
  ++counts.secondary;
  Path path = path_of(from, ray);
  redirect(scene, walls, k, lane, onward.refracted, onward.refracted_steps, path);
  if constexpr (recording) {
    record_wall(scene, from, memory, k, path.ray.direction, !through);
  }
  if (through) {
    path.inside = path.inside->around;
  } else if (++path.depth > scene.tracer.options.max_depth) {
    if constexpr (recording) {
      memory.trail->of(from, ray).trapped = true;
    }
    return;
  }
  if (to.count == wave_rays) {
    memory.full = true;
    return;
  }
  push(scene, path, from.node[ray], to);
}

/// Continues rays inside of objects: each wall refracts or reflects them. With Fresnel's equations
/// a wall does both, and the ray ends there.
inline void pass_walls(const WaveScene& scene, WaveMemory& memory, const WaveRays& from,
                       WaveRays& to, RayCounts& counts) {
  const WavePoints& walls = memory.walls;
  if (scene.fresnel) {
    follow_points(scene, memory, from, to, walls, true, counts);
    return;
  }
  for (int at = 0; at < walls.count; at += lanes) {
    Onward onward;
    find_refracted(scene, from, walls, at, true, onward);
    for (int k = at; k < std::min(walls.count, at + lanes); ++k) {
      pass_wall(scene, memory, from, to, k, k - at, onward, counts);
    }
  }
}

/// Adds each ray's color to its parent, in reverse order.
inline void sum_up(const WaveScene& scene, WaveMemory& memory) {
  const bool clamps = scene.course && scene.tracer.options.mode != Mode::normals;
  for (int i = memory.node_count - 1; i >= 0; --i) {
    WaveNode& node = memory.nodes[i];
    if (node.mirrored || node.refracted) {
      const WaveLink& link = memory.links[i];
      node.color +=
          (node.mirrored ? link.mirrored : Color(0)) + (node.refracted ? link.refracted : Color(0));
    }
    if constexpr (recording) {
      memory.trail->rays[static_cast<std::size_t>(i)].sum = node.color;
    }
    if (clamps) {
      node.color = glm::clamp(node.color, Color(0), Color(1));
    }
    if constexpr (recording) {
      memory.trail->rays[static_cast<std::size_t>(i)].color = node.color;
    }
    if (node.parent != no_index) {
      arrive(memory, node.parent, node, memory.links[i].factor * node.color);
    }
  }
}

}  // namespace scenefile::SCENEFILE_LANES
