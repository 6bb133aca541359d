// Packets of coherent rays, the frusta that bound them, and the objects that they may hit. No
// include guard: included once for each instruction set, after wide-inl.h.
//
// The rays of a packet mostly run along one axis. Intervals bound their slopes along the other two
// axes, and their origins; together they bound all rays at the distance of a box (compare Boulos et
// al., "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006).

#include "scenefile/trace/wavefront_memory.h"

namespace scenefile::SCENEFILE_LANES {

/// The main direction of the rays of a packet.
struct Heading {
  int main = 2;  ///< the axis; 0, 1, 2
  int side[2] = {0, 1};
  double sign = 1;      ///< sign of the directions along the main axis
  bool common = false;  ///< whether the rays are coherent enough
};

/// Bounds of the space that the rays of a packet may touch: coordinates along the main axis, times
/// its sign, and along the two others.
struct PacketFrustum {
  double origin_low[3];  ///< main, sides
  double origin_high[3];
  double slope_low[2];
  double slope_high[2];
  double reach;  ///< maximum extent along the main axis from the origin
};

inline PacketFrustum empty_frustum() {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {{far, far, far}, {-far, -far, -far}, {far, far}, {-far, -far}, 0};
}

inline void unite(PacketFrustum& a, const PacketFrustum& b) {
  for (int i = 0; i < 3; ++i) {
    a.origin_low[i] = std::min(a.origin_low[i], b.origin_low[i]);
    a.origin_high[i] = std::max(a.origin_high[i], b.origin_high[i]);
  }
  for (int i = 0; i < 2; ++i) {
    a.slope_low[i] = std::min(a.slope_low[i], b.slope_low[i]);
    a.slope_high[i] = std::max(a.slope_high[i], b.slope_high[i]);
  }
  a.reach = std::max(a.reach, b.reach);
}

inline F coordinate(const V3& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// A chunk of a wavefront to search.
struct Chunk {
  Rays rays;
  F length;  ///< of the rays
  M mask;    ///< active rays
};

inline PacketFrustum frustum_of(const Chunk& chunk, const Heading& heading) {
  // Exceeds the rounding errors of a ray.
  constexpr double slack = 1e-7;
  const F far = splat(std::numeric_limits<double>::infinity());
  const auto& [rays, length, mask] = chunk;
  if (none(mask)) {
    return empty_frustum();
  }
  PacketFrustum frustum;
  const M lanes_of_it = mask;
  const auto enclose = [&](F x, double& low, double& high) {
    low = min_of_lanes(select(lanes_of_it, x, far));
    high = greatest_lane(select(lanes_of_it, x, -far));
  };
  const F sign = splat(heading.sign);
  const F ahead = sign * coordinate(rays.direction, heading.main);
  enclose(sign * coordinate(rays.origin, heading.main), frustum.origin_low[0],
          frustum.origin_high[0]);
  for (int i = 0; i < 2; ++i) {
    enclose(coordinate(rays.origin, heading.side[i]), frustum.origin_low[1 + i],
            frustum.origin_high[1 + i]);
    enclose(coordinate(rays.direction, heading.side[i]) / ahead, frustum.slope_low[i],
            frustum.slope_high[i]);
    frustum.slope_low[i] -= slack * (1 + std::abs(frustum.slope_low[i]));
    frustum.slope_high[i] += slack * (1 + std::abs(frustum.slope_high[i]));
  }
  frustum.reach = (1 + slack) * greatest_lane(select(mask, length * ahead, splat(0)));
  return frustum;
}

/// The common heading of chunks `first` to `last` - 1; `chunk(c)` returns a chunk.
template <typename ChunkOf>
Heading heading_of(int first, int last, const ChunkOf& chunk) {
  V3 sum{splat(0), splat(0), splat(0)};
  for (int c = first; c < last; ++c) {
    const Chunk one = chunk(c);
    sum = sum + select(one.mask, one.rays.direction, V3{splat(0), splat(0), splat(0)});
  }
  const double sums[3] = {sum_of_lanes(sum.x), sum_of_lanes(sum.y), sum_of_lanes(sum.z)};
  Heading heading;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(sums[axis]) > std::abs(sums[heading.main])) {
      heading.main = axis;
    }
  }
  heading.side[0] = (heading.main + 1) % 3;
  heading.side[1] = (heading.main + 2) % 3;
  heading.sign = sums[heading.main] < 0 ? -1 : 1;
  constexpr double steepest = 0.2;  // minimum of a unit vector along the main axis
  M fine = !no_lanes();
  for (int c = first; c < last; ++c) {
    const Chunk one = chunk(c);
    const F ahead = splat(heading.sign) * coordinate(one.rays.direction, heading.main);
    fine = fine & ((!one.mask) | (ahead > splat(steepest)));
  }
  heading.common = every(fine);
  return heading;
}

/// Objects that a packet may hit, with their boxes.
struct Candidates {
  static constexpr int most = 64;
  int count = 0;
  std::uint32_t object[most + Bvh8Node::width];
  alignas(64) float min[3][most + Bvh8Node::width];
  alignas(64) float max[3][most + Bvh8Node::width];
};

// Which boxes starting at `at` the frustum may touch; `boxes` has the layout of Bvh8Node.
template <typename Boxes>
unsigned touched(const Boxes& boxes, int at, const PacketFrustum& frustum, const Heading& heading) {
  const bool forward = heading.sign > 0;
  const F low = load_floats(boxes.min[heading.main] + at);
  const F high = load_floats(boxes.max[heading.main] + at);
  const F near = max(splat(0), (forward ? low : -high) - splat(frustum.origin_high[0]));
  const F far = min(splat(frustum.reach), (forward ? high : -low) - splat(frustum.origin_low[0]));
  M meets = near <= far;
  for (int i = 0; i < 2; ++i) {
    const F slope_low = splat(frustum.slope_low[i]);
    const F slope_high = splat(frustum.slope_high[i]);
    const F min_side = splat(frustum.origin_low[1 + i]) + min(slope_low * near, slope_low * far);
    const F max_side = splat(frustum.origin_high[1 + i]) + max(slope_high * near, slope_high * far);
    meets = meets & (min_side <= load_floats(boxes.max[heading.side[i]] + at)) &
            (max_side >= load_floats(boxes.min[heading.side[i]] + at));
  }
  return bits(meets);
}

template <typename Boxes>
void add_candidate(const Boxes& boxes, int at, std::uint32_t object, Candidates& list) {
  const int i = list.count++;
  list.object[i] = object;
  for (int axis = 0; axis < 3; ++axis) {
    list.min[axis][i] = boxes.min[axis][at];
    list.max[axis][i] = boxes.max[axis][at];
  }
}

/// Candidates from the BVH; slightly more than `limit`, at most `most`, if there are too many.
inline void find_candidates(const PacketBvh& bvh, const PacketFrustum& frustum,
                            const Heading& heading, int limit, Candidates& list) {
  struct Entry {
    int level;
    std::uint32_t index;
  };
  std::array<Entry, 64> stack;  // seven for each of at most six levels
  int waiting = 0;
  stack[waiting++] = {bvh.levels() - 1, 0};
  list.count = 0;
  while (waiting > 0 && list.count <= limit) {
    const auto [level, index] = stack[--waiting];
    const Bvh8Node& node = bvh.node(level, index);
    for (int at = 0; at < Bvh8Node::width; at += lanes) {
      for (unsigned left = touched(node, at, frustum, heading); left != 0; left &= left - 1) {
        const int i = at + std::countr_zero(left);
        const std::uint32_t entry = Bvh8Node::width * index + static_cast<std::uint32_t>(i);
        if (level > 0) {
          stack[waiting++] = {level - 1, entry};
        } else {
          add_candidate(node, i, bvh.object(entry), list);
        }
      }
    }
  }
}

/// Candidates from a list.
inline void find_candidates(const Candidates& from, const PacketFrustum& frustum,
                            const Heading& heading, Candidates& list) {
  list.count = 0;
  for (int at = 0; at < from.count; at += lanes) {
    unsigned left = touched(from, at, frustum, heading);
    left &= from.count - at < lanes ? (1u << (from.count - at)) - 1 : ~0u;
    for (; left != 0; left &= left - 1) {
      const int i = at + std::countr_zero(left);
      add_candidate(from, i, from.object[i], list);
    }
  }
}

// Searches chunks `first` to `last` - 1, whose frusta are `frusta`, among the objects of `around`,
// or of the BVH.
template <typename Test, typename GiveUp>
void traverse_packets(const PacketBvh& bvh, const PacketFrustum* frusta, int first, int last,
                      const Heading& heading, const Candidates* around, const Test& test,
                      const GiveUp& give_up) {
  constexpr int parting = 4;
  constexpr int few = 2;    // tested by all chunks
  constexpr int many = 16;  // tested by one chunk
  const bool single = last - first == 1;
  const int limit = single ? many : Candidates::most;
  PacketFrustum whole = frusta[first];
  for (int c = first + 1; c < last; ++c) {
    unite(whole, frusta[c]);
  }
  Candidates list;
  if (around == nullptr) {
    find_candidates(bvh, whole, heading, limit, list);
  } else {
    find_candidates(*around, whole, heading, list);
  }
  const bool too_many = list.count > limit;
  if (single && too_many) {
    give_up(first);
    return;
  }
  if (single || list.count <= few) {
    for (int c = first; c < last; ++c) {
      test(c, list);
    }
    return;
  }
  // If many rays have too many candidates, single chunks usually have fewer.
  const int step = too_many ? 1 : std::max(1, (last - first) / parting);
  for (int c = first; c < last; c += step) {
    traverse_packets(bvh, frusta, c, std::min(last, c + step), heading, too_many ? nullptr : &list,
                     test, give_up);
  }
}

/// Calls test(c, candidates) for chunks `first` to `last` - 1 with the objects that their rays may
/// hit, or give_up(c) if there are too many or the rays are incoherent. `chunk(c)` returns the
/// rays.
template <typename ChunkOf, typename Test, typename GiveUp>
void traverse(const PacketBvh& bvh, int first, int last, const ChunkOf& chunk, const Test& test,
              const GiveUp& give_up) {
  const Heading heading = heading_of(first, last, chunk);
  if (heading.common) {
    std::array<PacketFrustum, queue_rays / lanes> frusta;
    for (int c = first; c < last; ++c) {
      frusta[c] = frustum_of(chunk(c), heading);
    }
    traverse_packets(bvh, frusta.data(), first, last, heading, nullptr, test, give_up);
    return;
  }
  if (last - first == 1) {
    give_up(first);
    return;
  }
  const int step = std::max(1, (last - first) / 4);
  for (int c = first; c < last; c += step) {
    traverse(bvh, c, std::min(last, c + step), chunk, test, give_up);
  }
}

}  // namespace scenefile::SCENEFILE_LANES
