// What the rays of a wave hit. No guard: included once for each instruction set.

#include "scenefile/trace/wave_memory.h"

namespace scenefile::SCENEFILE_LANES {

inline V3 load3(const WaveVectors& v, int at) {
  return {load(v.x + at), load(v.y + at), load(v.z + at)};
}

inline void store3(const V3& v, WaveVectors& to, int at) {
  store(v.x, to.x + at);
  store(v.y, to.y + at);
  store(v.z, to.z + at);
}

/// A map in each lane.
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

/// A ray in each lane.
struct Rays {
  V3 origin, direction;
};

// By one lane after the other: rays that crossing() cannot take.
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

inline Crossing part_crossing(const Part& part, const Rays& rays, F t_min, F t_max, M active) {
  const Map map = splat_map(part.part_from_group);
  const Rays local{map.point(rays.origin), map.vector(rays.direction)};
  const F length2 = dot(local.direction, local.direction);
  const M usual = moderate(length2);
  if (any(active & !usual)) {
    return extreme_crossing(part.shape, local, t_min, t_max, active);
  }
  return crossing(part.shape, local.origin, local.direction, length2, t_min, t_max, active);
}

inline M finite_rays(const Rays& rays) {
  const V3 sum = rays.origin + rays.direction;
  return finite(sum.x + sum.y + sum.z);
}

/// The nearest hit of each lane so far.
struct Nearest {
  F t = splat(std::numeric_limits<double>::infinity());
  F face = splat(0);
  F part = splat(-1);
};

inline void test_nearest(const Part& part, int index, const Rays& rays, F t_min, M active,
                         Nearest& nearest) {
  const Crossing found = part_crossing(part, rays, t_min, above(nearest.t), active);
  if (none(found.hit)) {
    return;
  }
  // Of equal ones the last in the file, as improves() has it.
  const F number = splat(index);
  const M later = (nearest.part >= splat(0)) & (number > nearest.part);
  const M better = found.hit & ((found.t < nearest.t) | ((found.t == nearest.t) & later));
  nearest.t = select(better, found.t, nearest.t);
  nearest.face = select(better, found.face, nearest.face);
  nearest.part = select(better, number, nearest.part);
}

inline void find_by_lane(const WaveScene& scene, const WaveRays& rays, WaveHits& hits) {
  for (int i = 0; i < rays.count; ++i) {
    const Ray ray{{rays.origin.x[i], rays.origin.y[i], rays.origin.z[i]},
                  {rays.direction.x[i], rays.direction.y[i], rays.direction.z[i]}};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool hit = scene.tracer.accelerator.closest(ray, rays.start[i], infinity, hits.others[i]);
    hits.t[i] = hit ? hits.others[i].t : infinity;
    hits.face[i] = static_cast<int>(hits.others[i].face);
    hits.part[i] = -1;
  }
}

inline void find_hits(const WaveScene& scene, const WaveRays& rays, WaveHits& hits) {
  if (!scene.few_parts) {
    find_by_lane(scene, rays, hits);
    return;
  }
  const Parts& all = scene.tracer.accelerator.parts();
  const std::vector<Part>& parts = all.groups[all.root].parts;
  for (int at = 0; at < rays.count; at += lanes) {
    const Rays chunk{load3(rays.origin, at), load3(rays.direction, at)};
    const F t_min = load(rays.start + at);
    const M active = first_lanes(static_cast<std::size_t>(std::min(lanes, rays.count - at))) &
                     finite_rays(chunk);
    Nearest nearest;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      test_nearest(parts[i], static_cast<int>(i), chunk, t_min, active, nearest);
    }
    store(nearest.t, hits.t + at);
    store(nearest.face, hits.face + at);
    store(nearest.part, hits.part + at);
  }
}

inline void find_blocked_by_lane(const WaveScene& scene, const WavePoints& points, int at, F t_min,
                                 WaveLight& light) {
  alignas(64) double start[lanes];
  store(t_min, start);
  unsigned blocked = 0;
  for (int i = 0; i < lanes; ++i) {
    if ((light.asks[at / lanes] >> i & 1) == 0) {
      continue;
    }
    const int k = at + i;
    const Ray ray{{points.position.x[k], points.position.y[k], points.position.z[k]},
                  {light.to_light.x[k], light.to_light.y[k], light.to_light.z[k]}};
    const bool hit = scene.tracer.accelerator.occluded(ray, start[i], light.end[k]);
    blocked |= unsigned(hit) << i;
  }
  light.blocked[at / lanes] = static_cast<std::uint8_t>(blocked);
}

/// Which of the points that ask for light do not see it.
inline void find_blocked(const WaveScene& scene, const WavePoints& points, F t_min,
                         WaveLight& light) {
  const Parts& all = scene.tracer.accelerator.parts();
  for (int at = 0; at < points.count; at += lanes) {
    if (light.asks[at / lanes] == 0) {
      light.blocked[at / lanes] = 0;
      continue;
    }
    if (!scene.few_parts) {
      find_blocked_by_lane(scene, points, at, t_min, light);
      continue;
    }
    const Rays rays{load3(points.position, at), load3(light.to_light, at)};
    const M asking = of_bits(light.asks[at / lanes]) & finite_rays(rays);
    const F t_max = load(light.end + at);
    M blocked = no_lanes();
    for (const Part& part : all.groups[all.root].parts) {
      blocked = blocked | part_crossing(part, rays, t_min, t_max, asking & !blocked).hit;
      if (none(asking & !blocked)) {
        break;
      }
    }
    light.blocked[at / lanes] = static_cast<std::uint8_t>(bits(blocked));
  }
}

}  // namespace scenefile::SCENEFILE_LANES
