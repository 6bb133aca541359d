// What becomes of the rays of a wave: mirrors, glass, and the way back. No guard: included once
// for each instruction set, behind wave_shade-inl.h.

#include "scenefile/trace/wave_memory.h"

namespace scenefile::SCENEFILE_LANES {

// The normal on the side that the ray comes from.
inline V3 facing_normal(const V3& normal, const V3& direction) {
  const V3 turned = select(dot(normal, direction) > splat(0), -normal, normal);
  return select(dot(turned, direction) < splat(0), turned, normal);
}

// The directions in which the rays of a chunk go on.
struct Onward {
  alignas(64) double mirrored[3][lanes];
  alignas(64) double refracted[3][lanes];
  unsigned through = 0;   // bits: refracted, not mirrored inside
  unsigned entering = 0;  // bits: from the outside
};

inline void store_rows(const V3& v, double (&to)[3][lanes]) {
  store(v.x, to[0]);
  store(v.y, to[1]);
  store(v.z, to[2]);
}

inline void find_mirrored(const WavePoints& points, int at, Onward& onward) {
  store_rows(mirrored(load3(points.direction, at), load3(points.normal, at)), onward.mirrored);
}

// `walls`: the rays are inside and meet the wall of what they are in.
inline void find_refracted(const WavePoints& points, int at, bool walls, Onward& onward) {
  alignas(64) double iors[lanes];
  for (int i = 0; i < lanes; ++i) {
    iors[i] = points.material[at + i]->ior;
  }
  const V3 direction = load3(points.direction, at);
  const V3 normal = load3(points.normal, at);
  const V3 facing = facing_normal(normal, direction);
  const M entering = dot(normal, direction) < splat(0);
  const F ior = load(iors);
  const F eta = walls ? ior : select(entering, splat(1) / ior, ior);
  const Refracted found = refraction(direction, facing, eta);
  store_rows(select(found.through, found.direction, mirrored(direction, facing)), onward.refracted);
  onward.through = bits(found.through);
  onward.entering = bits(entering);
}

inline glm::dvec3 lane_of(const double (&rows)[3][lanes], int lane) {
  return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

/// A ray that goes on.
struct Next {
  glm::dvec3 direction;
  std::uint32_t node = 0;
  int depth = 0;
  std::uint32_t budget = 0;
  const Inside* inside = nullptr;
};

inline void push(const WavePoints& points, int k, const Next& next, WaveRays& rays) {
  const int i = rays.count++;
  put(get(points.position, k), rays.origin, i);
  put(next.direction, rays.direction, i);
  rays.start[i] = 1e-3;
  rays.node[i] = next.node;
  rays.depth[i] = next.depth;
  rays.budget[i] = next.budget;
  rays.inside[i] = next.inside;
}

// Where there is no room, the ray is followed alone.
inline Color follow_alone(const WaveScene& scene, const WavePoints& points, int k, const Next& next,
                          RayCounts& counts) {
  Path path;
  path.ray = {get(points.position, k), next.direction};
  path.start = 1e-3;
  path.depth = next.depth;
  path.budget = next.budget;
  path.inside = next.inside;
  return trace_path(scene.tracer, path, counts);
}

inline bool has_room(const WaveMemory& memory, const WaveRays& rays) {
  return rays.count < wave_rays && memory.node_count < wave_nodes &&
         memory.inside_count < wave_insides;
}

inline void add_child(const WaveScene& scene, WaveMemory& memory, WaveRays& rays, int k, Next next,
                      RayKind kind, std::uint32_t parent, RayCounts& counts) {
  const WaveMaterial& material = *memory.points.material[k];
  const double* const f = kind == RayKind::reflected ? material.mirror : material.glass;
  const Color factor{f[0], f[1], f[2]};
  ++counts.secondary;
  if (!has_room(memory, rays)) {
    memory.nodes[parent].put(kind, factor * follow_alone(scene, memory.points, k, next, counts));
    return;
  }
  next.node = static_cast<std::uint32_t>(memory.node_count++);
  WaveNode& node = memory.nodes[next.node];
  node = {};
  node.factor = factor;
  node.parent = parent;
  node.kind = kind;
  push(memory.points, k, next, rays);
}

// What the ray that hit the point is in behind it.
inline void enter(const WaveScene& scene, const WaveHits& hits, std::uint32_t ray,
                  const Inside* around, Hit& object, Inside& inside) {
  if (hits.part[ray] < 0) {
    object = hits.others[ray];
  } else {
    const Parts& all = scene.tracer.accelerator.parts();
    const Part& part = all.groups[all.root].parts[static_cast<std::size_t>(hits.part[ray])];
    object.part = &part;
    object.object_from_world = DAffine(part.part_from_group);
  }
  inside = {&object, around};
}

inline void add_refracted(const WaveScene& scene, WaveMemory& memory, WaveRays& rays, int k,
                          Next next, bool enters, std::uint32_t parent, RayCounts& counts) {
  Hit object;
  Inside inside;
  if (enters) {
    const bool kept = has_room(memory, rays);
    const int i = kept ? memory.inside_count++ : 0;
    Inside& entered = kept ? memory.insides[i] : inside;
    enter(scene, memory.hits, memory.points.ray[k], next.inside, kept ? memory.objects[i] : object,
          entered);
    next.inside = &entered;
  }
  add_child(scene, memory, rays, k, next, RayKind::refracted, parent, counts);
}

inline void follow_point(const WaveScene& scene, WaveMemory& memory, const WaveRays& from,
                         WaveRays& to, int k, int lane, const Onward& onward, RayCounts& counts) {
  const WaveMaterial& material = *memory.points.material[k];
  const std::uint32_t ray = memory.points.ray[k];
  const std::uint32_t children = std::uint32_t(material.mirrors) + std::uint32_t(material.refracts);
  if (from.depth[ray] + 1 > scene.tracer.options.max_depth || children == 0 ||
      from.budget[ray] <= children) {
    return;
  }
  Next next{{}, 0, from.depth[ray] + 1, (from.budget[ray] - 1) / children, from.inside[ray]};
  const std::uint32_t parent = from.node[ray];
  if (material.mirrors) {
    next.direction = lane_of(onward.mirrored, lane);
    add_child(scene, memory, to, k, next, RayKind::reflected, parent, counts);
  }
  if (material.refracts) {
    next.direction = lane_of(onward.refracted, lane);
    const bool through = (onward.through >> lane & 1) != 0;
    const bool entering = (onward.entering >> lane & 1) != 0;
    add_refracted(scene, memory, to, k, next, through == entering, parent, counts);
  }
}

/// Sends the points' rays on.
inline void follow_points(const WaveScene& scene, WaveMemory& memory, const WaveRays& from,
                          WaveRays& to, RayCounts& counts) {
  const WavePoints& points = memory.points;
  for (int at = 0; at < points.count; at += lanes) {
    const int end = std::min(points.count, at + lanes);
    const auto some = [&](bool WaveMaterial::*has) {
      return std::any_of(points.material + at, points.material + end,
                         [&](const WaveMaterial* m) { return m->*has; });
    };
    const bool mirrors = some(&WaveMaterial::mirrors);
    const bool refracts = some(&WaveMaterial::refracts);
    Onward onward{};
    if (mirrors) {
      find_mirrored(points, at, onward);
    }
    if (refracts) {
      find_refracted(points, at, false, onward);
    }
    for (int k = at; k < end && (mirrors || refracts); ++k) {
      follow_point(scene, memory, from, to, k, k - at, onward, counts);
    }
  }
}

/// Sends rays inside of objects through their walls or back from them.
inline void pass_walls(const WaveScene& scene, WaveMemory& memory, const WaveRays& from,
                       WaveRays& to, RayCounts& counts) {
  const WavePoints& walls = memory.walls;
  for (int at = 0; at < walls.count; at += lanes) {
    Onward onward{};
    find_refracted(walls, at, true, onward);
    for (int k = at; k < std::min(walls.count, at + lanes); ++k) {
      const std::uint32_t ray = walls.ray[k];
      const bool through = (onward.through >> (k - at) & 1) != 0;
      ++counts.secondary;
      const Inside* const inside = from.inside[ray];
      const Next next{lane_of(onward.refracted, k - at), from.node[ray],
                      from.depth[ray] + (through ? 0 : 1), from.budget[ray],
                      through ? inside->around : inside};
      if (next.depth > scene.tracer.options.max_depth) {
        continue;
      }
      if (to.count == wave_rays) {
        memory.nodes[next.node].color = follow_alone(scene, walls, k, next, counts);
      } else {
        push(walls, k, next, to);
      }
    }
  }
}

/// Gives each ray's color to the one that it came of, the last first.
inline void sum_up(WaveMemory& memory) {
  for (int i = memory.node_count - 1; i >= 0; --i) {
    WaveNode& node = memory.nodes[i];
    node.color = glm::clamp(node.color + (node.mirrored + node.refracted), Color(0), Color(1));
    if (node.parent != no_index) {
      memory.nodes[node.parent].put(node.kind, node.factor * node.color);
    }
  }
}

}  // namespace scenefile::SCENEFILE_LANES
