// Finds what the rays of a wavefront hit. No include guard: included once for each instruction set,
// after packet_frustum-inl.h.

#include "scenefile/trace/wavefront_memory.h"

namespace scenefile::SCENEFILE_LANES {

/// An affine map in each lane.
struct Map {
  V3 x, y, z, offset;

  V3 vector(const V3& v) const {
    return {x.x * v.x + y.x * v.y + z.x * v.z, x.y * v.x + y.y * v.y + z.y * v.z,
            x.z * v.x + y.z * v.y + z.z * v.z};
  }
  V3 point(const V3& p) const { return vector(p) + offset; }
};

inline Map splat_map(const Affine& m) {
  return {splat3(m.linear[0]), splat3(m.linear[1]), splat3(m.linear[2]), splat3(m.offset)};
}

// Lane by lane, for rays outside the range of crossing().
inline Crossing extreme_crossing(Shape shape, const Rays& rays, F t_min, F t_max, M active) {
  alignas(64) double numbers[8][lanes];
  store(rays.origin.x, numbers[0]);
  store(rays.origin.y, numbers[1]);
  store(rays.origin.z, numbers[2]);
  store(rays.direction.x, numbers[3]);
  store(rays.direction.y, numbers[4]);
  store(rays.direction.z, numbers[5]);
  store(t_min, numbers[6]);
  store(t_max, numbers[7]);
  alignas(64) double t[lanes] = {};
  alignas(64) double face[lanes] = {};
  const unsigned wanted = bits(active);
  unsigned found = 0;
  for (int i = 0; i < lanes; ++i) {
    const Ray ray{{numbers[0][i], numbers[1][i], numbers[2][i]},
                  {numbers[3][i], numbers[4][i], numbers[5][i]}};
    ShapeHit hit;
    if ((wanted >> i & 1) != 0 && intersect(shape, ray, numbers[6][i], numbers[7][i], hit)) {
      found |= 1u << i;
      t[i] = hit.t;
      face[i] = static_cast<int>(hit.face);
    }
  }
  return {of_bits(found), load(t), load(face)};
}

inline Crossing object_crossing(const Object& object, const Rays& rays, F t_min, F t_max,
                                M active) {
  const Map map = splat_map(object.object_from_group);
  const Rays local{map.point(rays.origin), map.vector(rays.direction)};
  const F length2 = dot(local.direction, local.direction);
  const M usual = moderate(length2);
  if (any(active & !usual)) {
    return extreme_crossing(object.shape, local, t_min, t_max, active);
  }
  return crossing(object.shape, local.origin, local.direction, length2, t_min, t_max, active);
}

// Calls f(i, ray) for each active lane i.
template <typename OfLane>
void for_each_lane(const Rays& rays, M active, const OfLane& f) {
  alignas(64) double origin[3][lanes];
  alignas(64) double direction[3][lanes];
  store_rows(rays.origin, origin);
  store_rows(rays.direction, direction);
  for (unsigned rest = bits(active); rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    f(i, Ray{lane_of(origin, i), lane_of(direction, i)});
  }
}

/// The nearest hit of each lane so far.
struct Nearest {
  F t = splat(std::numeric_limits<double>::infinity());
  F face = splat(0);
  F object = splat(-1);
  M mesh = no_lanes();  ///< the hit is on a mesh, and in HitQueue::others
};

inline void test_nearest(const Object& object, int index, const Rays& rays, F t_min, M active,
                         Nearest& nearest) {
  const Crossing found = object_crossing(object, rays, t_min, next_up(nearest.t), active);
  if (none(found.hit)) {
    return;
  }
  // Among equal ones the last in the file wins, like in improves().
  const F number = splat(index);
  const M later = (nearest.object >= splat(0)) & (number > nearest.object);
  const M better = found.hit & ((found.t < nearest.t) | ((found.t == nearest.t) & later));
  nearest.t = select(better, found.t, nearest.t);
  nearest.face = select(better, found.face, nearest.face);
  nearest.object = select(better, number, nearest.object);
  nearest.mesh = nearest.mesh & !better;
}

// The same for a mesh; `others`: hits of the chunk's rays. Not inlined: meshes are rare, and the
// loop over shapes is faster without this code.
[[gnu::noinline]] inline void test_nearest_mesh(const Accelerator& accelerator, int index,
                                                const Rays& rays, F t_min, M active,
                                                Nearest& nearest, Hit* others) {
  alignas(64) double start[lanes];
  alignas(64) double t[lanes];
  alignas(64) double object[lanes];
  store(t_min, start);
  store(nearest.t, t);
  store(nearest.object, object);
  unsigned found = 0;
  for_each_lane(rays, active, [&](int i, const Ray& ray) {
    Hit hit;
    if (accelerator.closest_in(static_cast<std::uint32_t>(index), ray, start[i],
                               scenefile::next_up<std::int64_t>(t[i]), hit) &&
        (hit.t < t[i] || index > object[i])) {
      others[i] = hit;
      t[i] = hit.t;
      found |= 1u << i;
    }
  });
  const M better = of_bits(found);
  nearest.t = load(t);
  nearest.object = select(better, splat(index), nearest.object);
  nearest.mesh = nearest.mesh | better;
}

// Stores hits of shapes in the root group as such, so that they are shaded in lanes.
inline void put_hit(const std::vector<Object>& root, const Hit& hit, int i, HitQueue& hits) {
  const auto* const object = static_cast<const Object*>(hit.object);
  const bool of_root = object >= root.data() && object < root.data() + root.size() &&
                       object->kind == ObjectKind::shape;
  hits.t[i] = hit.t;
  hits.face[i] = static_cast<int>(hit.face);
  hits.object[i] = of_root ? static_cast<double>(object - root.data()) : -1;
}

inline void find_by_lane(const WavefrontScene& scene, const RayQueue& rays, int first, int last,
                         HitQueue& hits) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int i = first; i < last; ++i) {
    const Ray ray{{rays.origin.x[i], rays.origin.y[i], rays.origin.z[i]},
                  {rays.direction.x[i], rays.direction.y[i], rays.direction.z[i]}};
    if (scene.tracer.accelerator.closest_object(ray, rays.start[i], infinity, hits.others[i])) {
      put_hit(scene.root, hits.others[i], i, hits);
    } else {
      hits.t[i] = infinity;
    }
  }
}

inline Chunk ray_chunk(const RayQueue& rays, int at) {
  const Rays chunk{load3(rays.origin, at), load3(rays.direction, at)};
  const M active = present_lanes(at, rays.count) & finite_rays(chunk);
  return {chunk, splat(std::numeric_limits<double>::infinity()), active};
}

// Tests `count` objects; `object(i)` is the index of each.
template <typename ObjectOf>
void find_among(const WavefrontScene& scene, int count, const ObjectOf& object,
                const RayQueue& rays, int at, HitQueue& hits) {
  const Chunk chunk = ray_chunk(rays, at);
  const F t_min = load(rays.start + at);
  Nearest nearest;
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<int>(object(i));
    const Object& tested = scene.root[object(i)];
    if (tested.kind == ObjectKind::shape) {
      test_nearest(tested, index, chunk.rays, t_min, chunk.mask, nearest);
    } else {
      test_nearest_mesh(scene.tracer.accelerator, index, chunk.rays, t_min, chunk.mask, nearest,
                        &hits.others[at]);
    }
  }
  store(nearest.t, hits.t + at);
  store(nearest.face, hits.face + at);
  store(select(nearest.mesh, splat(-1), nearest.object), hits.object + at);
}

/// Finds the nearest hit of each ray of a generation. Single rays gain nothing from packets.
inline void find_hits(const WavefrontScene& scene, const RayQueue& rays, HitQueue& hits) {
  if constexpr (recording) {
    return find_by_lane(scene, rays, 0, rays.count, hits);
  }
  if (scene.tests_all_objects) {
    const auto count = static_cast<int>(scene.root.size());
    const auto each_object = [](int i) { return static_cast<std::uint32_t>(i); };
    for (int at = 0; at < rays.count; at += lanes) {
      find_among(scene, count, each_object, rays, at, hits);
    }
  } else if (scene.packet_bvh.empty() || hits.incoherent) {
    find_by_lane(scene, rays, 0, rays.count, hits);
  } else {
    int gave_up = 0;
    traverse(
        scene.packet_bvh, 0, (rays.count + lanes - 1) / lanes,
        [&](int c) { return ray_chunk(rays, c * lanes); },
        [&](int c, const Candidates& list) {
          find_among(
              scene, list.count, [&](int i) { return list.object[i]; }, rays, c * lanes, hits);
        },
        [&](int c) {
          ++gave_up;
          find_by_lane(scene, rays, c * lanes, std::min(rays.count, (c + 1) * lanes), hits);
        });
    hits.incoherent = 2 * gave_up * lanes > rays.count;
  }
}

// The shadow rays of a chunk, from the points to the light.
inline Chunk shadow_chunk(const ShadingPoints& points, const DirectLight& light, int at) {
  const Rays rays{load3(points.position, at), load3(light.to_light, at)};
  const M active = of_bits(light.asks[at / lanes]) & finite_rays(rays);
  return {rays, load(light.end + at), active};
}

// The same for the frustum of the packet: from the light, if it is a point, so that they have the
// same origin.
inline Chunk light_chunk(const WavefrontScene& scene, const ShadingPoints& points,
                         const DirectLight& light, int at) {
  Chunk chunk = shadow_chunk(points, light, at);
  if (scene.mesh_reach > 1) {
    chunk.length = chunk.length * splat(scene.mesh_reach);
  } else if (light.at_a_point) {
    chunk.rays = {splat3(light.from), -chunk.rays.direction};
  }
  return chunk;
}

// Shadow rays being tested against objects.
struct Shadows {
  const WavefrontScene& scene;
  const std::vector<Object>& objects;
  const Chunk& chunk;
  F start;
  M open;  // rays that are not blocked yet
  V3 density{splat(0), splat(0), splat(0)};

  M crossed(std::uint32_t index) const {
    if (objects[index].kind == ObjectKind::shape) {
      return object_crossing(objects[index], chunk.rays, start, chunk.length, open).hit;
    }
    return mesh_crossed(index);
  }

  [[gnu::noinline]] M mesh_crossed(std::uint32_t index) const {
    alignas(64) double from[lanes];
    alignas(64) double to[lanes];
    store(start, from);
    store(chunk.length, to);
    unsigned found = 0;
    for_each_lane(chunk.rays, open, [&](int i, const Ray& ray) {
      found |= unsigned(scene.tracer.accelerator.occluded_by(index, ray, from[i], to[i])) << i;
    });
    return of_bits(found);
  }

  // Tests an object; returns whether it occludes any ray.
  bool meet(std::uint32_t index) {
    const Object& object = objects[index];
    const M met = crossed(index);
    if (none(met)) {
      return false;
    }
    if (!scene.transmissive_shadows) {
      open = open & !met;
      return true;
    }
    const F black = splat(Transmission::black);
    density = select(met, density + splat_row(scene.materials[object.material].density), density);
    open = open & !((density.x >= black) & (density.y >= black) & (density.z >= black));
    return true;
  }
};

inline RecentBlockers& recent_blockers(DirectLight& light) {
  return light.recent[light.index % std::size(light.recent)];
}

// Tests recent occluders, all lanes at once.
inline void meet_recent(RecentBlockers& recent, Shadows& shadows) {
  for (std::uint32_t i = 0; i < RecentBlockers::most && any(shadows.open); ++i) {
    if (recent.object[i] != no_index && shadows.meet(recent.object[i])) {
      recent.rise(i);
    }
  }
}

inline void keep_blocker(const std::vector<Object>& root, const void* blocker,
                         RecentBlockers& recent) {
  const auto* const object = static_cast<const Object*>(blocker);
  if (object >= root.data() && object < root.data() + root.size() &&
      object->kind == ObjectKind::shape) {
    recent.add(static_cast<std::uint32_t>(object - root.data()));
  }
}

inline void find_blocked_by_lane(const WavefrontScene& scene, const ShadingPoints& points, int at,
                                 DirectLight& light) {
  if (light.asks[at / lanes] == 0) {
    return;
  }
  const Tracer& tracer = scene.tracer;
  const std::vector<Object>& root = scene.root;
  RecentBlockers& recent = recent_blockers(light);
  const Chunk chunk = shadow_chunk(points, light, at);
  Shadows shadows{scene, root, chunk, load(points.offset + at), chunk.mask};
  if constexpr (!recording) {
    meet_recent(recent, shadows);
  }
  unsigned blocked = bits(chunk.mask & !shadows.open);
  for (unsigned rest = light.asks[at / lanes] & ~blocked; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    const int k = at + i;
    const Ray ray{get(points.position, k), get(light.to_light, k)};
    const void* blocker = nullptr;
    const Color left = tracer.accelerator.transmittance(ray, points.offset[k], light.end[k],
                                                        tracer.transmission, &blocker);
    blocked |= unsigned(left == Color(0)) << i;
    keep_blocker(root, blocker, recent);
    if (scene.transmissive_shadows) {
      put(left, light.left, k);
    }
  }
  light.blocked[at / lanes] = static_cast<std::uint8_t>(blocked);
}

// Stores the remaining light if some passed through objects.
inline void put_left(const Shadows& shadows, int at, DirectLight& light) {
  const V3& d = shadows.density;
  store3(splat3(Color(1)), light.left, at);
  const M dimmed = shadows.open & (d.x + d.y + d.z > splat(0));
  if (none(dimmed)) {
    return;
  }
  alignas(64) double density[3][lanes];
  store_rows(d, density);
  for (unsigned rest = bits(dimmed); rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    put(Transmission::factor(glm::i64vec3(lane_of(density, i))), light.left, at + i);
  }
}

template <typename ObjectOf>
void find_blocked_among(const WavefrontScene& scene, int count, const ObjectOf& object,
                        const ShadingPoints& points, int at, DirectLight& light) {
  if (light.asks[at / lanes] == 0) {
    return;
  }
  const Chunk chunk = shadow_chunk(points, light, at);
  Shadows shadows{scene, scene.root, chunk, load(points.offset + at), chunk.mask};
  std::uint32_t& last = recent_blockers(light).last;
  const std::uint32_t first = last;
  if (first != no_index) {
    shadows.meet(first);
  }
  for (int i = 0; i < count && any(shadows.open); ++i) {
    if (object(i) != first && shadows.meet(object(i))) {
      last = object(i);
    }
  }
  light.blocked[at / lanes] = static_cast<std::uint8_t>(bits(chunk.mask & !shadows.open));
  if (scene.transmissive_shadows) {
    put_left(shadows, at, light);
  }
}

inline void find_all_blocked_by_lane(const WavefrontScene& scene, const ShadingPoints& points,
                                     DirectLight& light) {
  for (int at = 0; at < points.count; at += lanes) {
    find_blocked_by_lane(scene, points, at, light);
  }
}

/// Finds which of the active points are in shadow.
inline void find_blocked(const WavefrontScene& scene, const ShadingPoints& points,
                         DirectLight& light) {
  if constexpr (recording) {
    return find_all_blocked_by_lane(scene, points, light);
  }
  if (scene.tests_all_objects) {
    const auto count = static_cast<int>(scene.root.size());
    const auto each_object = [](int i) { return static_cast<std::uint32_t>(i); };
    for (int at = 0; at < points.count; at += lanes) {
      find_blocked_among(scene, count, each_object, points, at, light);
    }
  } else if (scene.packet_bvh.empty() || light.incoherent) {
    find_all_blocked_by_lane(scene, points, light);
  } else {
    int gave_up = 0;
    traverse(
        scene.packet_bvh, 0, (points.count + lanes - 1) / lanes,
        [&](int c) { return light_chunk(scene, points, light, c * lanes); },
        [&](int c, const Candidates& list) {
          find_blocked_among(
              scene, list.count, [&](int i) { return list.object[i]; }, points, c * lanes, light);
        },
        [&](int c) {
          ++gave_up;
          find_blocked_by_lane(scene, points, c * lanes, light);
        });
    light.incoherent = 2 * gave_up * lanes > points.count;
  }
}

}  // namespace scenefile::SCENEFILE_LANES
