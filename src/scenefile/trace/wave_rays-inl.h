// Rays in lanes. No guard: included once for each instruction set, behind wide-inl.h.

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

/// A ray in each lane.
struct Rays {
  V3 origin, direction;
};

inline M finite_rays(const Rays& rays) {
  const V3 sum = rays.origin + rays.direction;
  return finite(sum.x + sum.y + sum.z);
}

/// Lanes that are there in a chunk which begins at `at` of `count`.
inline M present_lanes(int at, int count) {
  return first_lanes(static_cast<std::size_t>(std::clamp(count - at, 0, lanes)));
}

}  // namespace scenefile::SCENEFILE_LANES
