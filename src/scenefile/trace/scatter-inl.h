// Reflects and refracts the rays of a wavefront at the points that they hit, and sums up colors. No
// include guard: included once for each instruction set, after direct_light-inl.h.

#include "scenefile/trace/wavefront_memory.h"

namespace scenefile::SCENEFILE_LANES {

// The shading normal on the side of the incoming ray; the geometric normal if interpolation has
// turned it to the other side.
inline V3 facing_normal(const V3& normal, const V3& geometric, const V3& direction) {
  const M behind = dot(geometric, direction) > splat(0);
  const V3 turned = select(behind, -normal, normal);
  return select(dot(turned, direction) < splat(0), turned, select(behind, -geometric, geometric));
}

// The directions of the secondary rays of a chunk.
struct ScatteredRays {
  alignas(64) double mirrored[3][lanes];
  alignas(64) double refracted[3][lanes];
  alignas(64) double mirrored_derivatives[2][3][lanes];
  alignas(64) double refracted_derivatives[2][3][lanes];
  alignas(64) double cosine[lanes] = {};  // of the angle between ray and normal
  unsigned through = 0;                   // bits: refracted, not mirrored inside
  unsigned entering = 0;                  // bits: from the outside
  unsigned within = 0;                    // bits: the refracted ray is inside of the object
};

inline void store_rows(const Derivatives& derivatives, double (&to)[2][3][lanes]) {
  store_rows(derivatives.dx, to[0]);
  store_rows(derivatives.dy, to[1]);
}

inline Derivatives dn_at(const ShadingPoints& points, int at, const V3& wanted) {
  return on_side(load_derivatives(points.dn, at), load3(points.geometric, at), wanted);
}

// `inner`: the rays are inside of objects and hit their walls.
inline void find_mirrored(const WavefrontScene& scene, const RayQueue& rays,
                          const ShadingPoints& points, int at, bool inner,
                          ScatteredRays& scattered) {
  const V3 direction = load3(points.direction, at);
  const V3 normal = load3(points.normal, at);
  const V3 facing = inner ? facing_normal(normal, load3(points.geometric, at), direction) : normal;
  store_rows(mirrored(direction, facing), scattered.mirrored);
  if (scene.by_footprint) {
    store_rows(mirrored_derivatives(direction, facing,
                                    gather_derivatives(rays.d_direction, points.ray + at),
                                    dn_at(points, at, facing)),
               scattered.mirrored_derivatives);
  }
}

inline void find_refracted(const WavefrontScene& scene, const RayQueue& rays,
                           const ShadingPoints& points, int at, bool inner,
                           ScatteredRays& scattered) {
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
  store_rows(select(found.through, found.direction, mirrored(direction, facing)),
             scattered.refracted);
  if (scene.by_footprint) {
    const Derivatives before = gather_derivatives(rays.d_direction, points.ray + at);
    const Derivatives dn = dn_at(points, at, facing);
    const Derivatives through = refracted_derivatives(direction, facing, eta, before, dn);
    const Derivatives back = mirrored_derivatives(direction, facing, before, dn);
    store_rows(Derivatives{select(found.through, through.dx, back.dx),
                           select(found.through, through.dy, back.dy)},
               scattered.refracted_derivatives);
  }
  store(-dot(facing, direction), scattered.cosine);
  scattered.through = bits(found.through);
  scattered.entering = inner ? 0 : bits(entering);
  // For all lanes at once: with -O1, GCC 12 takes `entering` of a single lane for false when it
  // compares.
  scattered.within = ~(scattered.through ^ scattered.entering);
}

// The path of ray r.
inline Path path_of(const RayQueue& rays, std::uint32_t r) {
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

inline void push(const WavefrontScene& scene, const Path& path, std::uint32_t node,
                 RayQueue& rays) {
  const int i = rays.count++;
  put(path.ray.origin, rays.origin, i);
  put(path.ray.direction, rays.direction, i);
  rays.start[i] = path.start;
  rays.node[i] = node;
  rays.depth[i] = path.depth;
  rays.weight[i] = path.weight;
  if (scene.by_footprint) {
    put(path.differential.origin.dx, rays.d_origin.dx, i);
    put(path.differential.origin.dy, rays.d_origin.dy, i);
    put(path.differential.direction.dx, rays.d_direction.dx, i);
    put(path.differential.direction.dy, rays.d_direction.dy, i);
  }
  rays.key[i] = path.key;
  rays.budget[i] = path.budget;
  rays.inside[i] = path.inside;
}

// Continues the path of point k with a secondary ray.
inline void redirect(const WavefrontScene& scene, const ShadingPoints& points, int k, int lane,
                     const double (&direction)[3][lanes], const double (&d_direction)[2][3][lanes],
                     Path& path) {
  if (scene.by_footprint) {
    path.differential = {{get(points.dp.dx, k), get(points.dp.dy, k)},
                         {lane_of(d_direction[0], lane), lane_of(d_direction[1], lane)}};
  }
  path.ray = {get(points.position, k), lane_of(direction, lane)};
  path.start = points.offset[k];
}

// Adds the light of a reflected or refracted ray to its parent.
inline void arrive(WavefrontMemory& memory, std::uint32_t ray, const RayNode& child,
                   const Color& seen) {
  RayNode& node = memory.nodes[ray];
  const bool mirrored = child.kind == RayKind::reflected;
  (mirrored ? memory.links[ray].mirrored : memory.links[ray].refracted) = seen;
  (mirrored ? node.mirrored : node.refracted) = true;
  node.penumbra = node.penumbra || child.penumbra;
  node.surface_hash = extended_hash(node.surface_hash, child.surface_hash + (mirrored ? 1 : 2));
  node.bounces = std::max(node.bounces, child.bounces);
}

inline void add_child(const WavefrontScene& scene, WavefrontMemory& memory, RayQueue& rays,
                      const Path& path, const Color& factor, std::uint32_t parent,
                      RayCounts& counts) {
  ++counts.secondary;
  if (rays.count == queue_rays || memory.node_count == wavefront_nodes) {
    memory.full = true;
    return;
  }
  const auto index = static_cast<std::uint32_t>(memory.node_count++);
  RayNode& node = memory.nodes[index];
  node = {};
  memory.links[index].factor = factor;
  node.parent = parent;
  node.kind = path.kind;
  node.bounces = static_cast<std::uint8_t>(path.depth);
  push(scene, path, index, rays);
  if constexpr (recording) {
    record_child(path, factor, parent, *memory.recorder);
  }
}

// The object that the path enters at point k.
inline const Inside* enter(const WavefrontScene& scene, WavefrontMemory& memory,
                           const ShadingPoints& points, int k, const Path& path) {
  if (memory.inside_count == wavefront_insides) {
    memory.full = true;
    return path.inside;
  }
  const int i = memory.inside_count++;
  memory.inside_hits[i] = hit_of(scene, memory.hits, points.ray[k], path.ray);
  memory.insides[i] = {&memory.inside_hits[i], path.inside};
  return &memory.insides[i];
}

// The factors of reflected and refracted light.
struct Branches {
  Color mirror;
  Color glass;
};

inline Branches branches_of(const WavefrontScene& scene, const ShadingMaterial& material,
                            bool inner, double cosine, double eta) {
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
inline void scatter_point(const WavefrontScene& scene, WavefrontMemory& memory,
                          const RayQueue& from, RayQueue& to, const ShadingPoints& points,
                          bool inner, int k, int lane, const ScatteredRays& scattered,
                          RayCounts& counts) {
  const ShadingMaterial& material = *points.material[k];
  const std::uint32_t ray = points.ray[k];
  if (!material.mirrors && !material.refracts && !inner) {
    return;
  }
  const Features& features = scene.tracer.options.features;
  const int most = scene.tracer.options.max_depth;
  const bool entering = (scattered.entering >> lane & 1) != 0;
  const double eta = entering ? 1 / material.ior : material.ior;
  const auto [mirror, glass] = branches_of(scene, material, inner, scattered.cosine[lane], eta);
  const auto outcome = [&](bool feature, const Color& factor, int depth_behind) {
    if (!feature || factor == Color(0)) {
      return BranchOutcome::absent;
    }
    if (depth_behind > most) {
      return BranchOutcome::too_deep;
    }
    const bool worth = scene.course || from.weight[ray] * largest(factor) >= min_weight;
    return worth ? BranchOutcome::followed : BranchOutcome::too_faint;
  };
  // A passage counts as one refraction: leaving is free.
  const int depth_behind = from.depth[ray] + (inner ? 0 : 1);
  const BranchOutcome of_mirror = outcome(features.reflect || inner, mirror, from.depth[ray] + 1);
  const BranchOutcome of_glass = outcome(features.refract, glass, depth_behind);
  const bool mirrors = of_mirror == BranchOutcome::followed;
  const bool refracts = of_glass == BranchOutcome::followed;
  const std::uint32_t children = std::uint32_t(mirrors) + std::uint32_t(refracts);
  const bool too_many = from.budget[ray] <= children;
  if constexpr (recording) {
    record_branches({of_mirror, mirror}, {of_glass, glass}, too_many,
                    memory.recorder->of(from, ray));
  }
  if (children == 0 || too_many) {
    return;
  }
  const Path path = path_of(from, ray);
  const std::uint32_t budget = (path.budget - 1) / children;
  const std::uint32_t parent = from.node[ray];
  if (mirrors) {
    Path next = child_of(path, mirror, budget, RayKind::reflected);
    redirect(scene, points, k, lane, scattered.mirrored, scattered.mirrored_derivatives, next);
    add_child(scene, memory, to, next, mirror, parent, counts);
  }
  if (refracts) {
    Path next = child_of(path, glass, budget, RayKind::refracted);
    next.depth = depth_behind;
    if (inner) {
      next.inside = path.inside->around;
    } else if ((scattered.within >> lane & 1) != 0) {
      next.inside = enter(scene, memory, points, k, path);
    }
    redirect(scene, points, k, lane, scattered.refracted, scattered.refracted_derivatives, next);
    add_child(scene, memory, to, next, glass, parent, counts);
    if constexpr (recording) {
      memory.recorder->rays.back().total_reflection = (scattered.through >> lane & 1) == 0;
    }
  }
}

/// Adds the secondary rays of the points.
inline void scatter_points(const WavefrontScene& scene, WavefrontMemory& memory,
                           const RayQueue& from, RayQueue& to, const ShadingPoints& points,
                           bool inner, RayCounts& counts) {
  for (int at = 0; at < points.count; at += lanes) {
    const int end = std::min(points.count, at + lanes);
    const auto some = [&](bool ShadingMaterial::*has) {
      return std::any_of(points.material + at, points.material + end,
                         [&](const ShadingMaterial* m) { return m->*has; });
    };
    const bool refracts = inner || some(&ShadingMaterial::refracts);
    const bool mirrors = (scene.fresnel && refracts) || some(&ShadingMaterial::mirrors);
    ScatteredRays scattered;
    if (mirrors) {
      find_mirrored(scene, from, points, at, inner, scattered);
    }
    if (refracts) {
      find_refracted(scene, from, points, at, inner, scattered);
    }
    for (int k = at; k < end && (mirrors || refracts); ++k) {
      scatter_point(scene, memory, from, to, points, inner, k, k - at, scattered, counts);
    }
  }
}

// The ray of point k of the walls continues in `direction`.
inline void record_wall(const WavefrontScene& scene, const RayQueue& from, WavefrontMemory& memory,
                        int k, const glm::dvec3& direction, bool mirrored) {
  const ShadingPoints& walls = memory.walls;
  const std::uint32_t r = walls.ray[k];
  const Ray ray = ray_at(from, r);
  const Hit hit = hit_of(scene, memory.hits, r, ray);
  const V3 facing = facing_normal(splat3(get(walls.normal, k)), splat3(get(walls.geometric, k)),
                                  splat3(ray.direction));
  alignas(64) double normal[3][lanes];
  store_rows(facing, normal);
  memory.recorder->of(from, r).walls.push_back(
      {object_at(scene.tracer, ray, from.start[r], hit.source), walls.t[k], get(walls.position, k),
       lane_of(normal, 0), direction, mirrored});
}

inline void pass_wall(const WavefrontScene& scene, WavefrontMemory& memory, const RayQueue& from,
                      RayQueue& to, int k, int lane, const ScatteredRays& scattered,
                      RayCounts& counts) {
  const ShadingPoints& walls = memory.walls;
  const std::uint32_t ray = walls.ray[k];
  const bool through = (scattered.through >> lane & 1) != 0;
  ++counts.secondary;
  Path path = path_of(from, ray);
  redirect(scene, walls, k, lane, scattered.refracted, scattered.refracted_derivatives, path);
  if constexpr (recording) {
    record_wall(scene, from, memory, k, path.ray.direction, !through);
  }
  if (through) {
    path.inside = path.inside->around;
  } else if (++path.depth > scene.tracer.options.max_depth) {
    if constexpr (recording) {
      memory.recorder->of(from, ray).trapped = true;
    }
    return;
  }
  if (to.count == queue_rays) {
    memory.full = true;
    return;
  }
  push(scene, path, from.node[ray], to);
}

/// Continues rays inside of objects: each wall refracts or reflects them. With Fresnel's equations
/// a wall does both, and the ray ends there.
inline void pass_walls(const WavefrontScene& scene, WavefrontMemory& memory, const RayQueue& from,
                       RayQueue& to, RayCounts& counts) {
  const ShadingPoints& walls = memory.walls;
  if (scene.fresnel) {
    scatter_points(scene, memory, from, to, walls, true, counts);
    return;
  }
  for (int at = 0; at < walls.count; at += lanes) {
    ScatteredRays scattered;
    find_refracted(scene, from, walls, at, true, scattered);
    for (int k = at; k < std::min(walls.count, at + lanes); ++k) {
      pass_wall(scene, memory, from, to, k, k - at, scattered, counts);
    }
  }
}

/// Adds each ray's color to its parent, in reverse order.
inline void sum_up(const WavefrontScene& scene, WavefrontMemory& memory) {
  const bool clamps = scene.course && scene.tracer.options.mode != Mode::normals;
  for (int i = memory.node_count - 1; i >= 0; --i) {
    RayNode& node = memory.nodes[i];
    if (node.mirrored || node.refracted) {
      const RayLink& link = memory.links[i];
      node.color +=
          (node.mirrored ? link.mirrored : Color(0)) + (node.refracted ? link.refracted : Color(0));
    }
    if constexpr (recording) {
      memory.recorder->rays[static_cast<std::size_t>(i)].sum = node.color;
    }
    if (clamps) {
      node.color = glm::clamp(node.color, Color(0), Color(1));
    }
    if constexpr (recording) {
      memory.recorder->rays[static_cast<std::size_t>(i)].color = node.color;
    }
    if (node.parent != no_index) {
      arrive(memory, node.parent, node, memory.links[i].factor * node.color);
    }
  }
}

}  // namespace scenefile::SCENEFILE_LANES
