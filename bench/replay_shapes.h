#pragma once
// Embree with minimal code around it, for scenefile_bench_replay.

#include "scenefile/geometry/shapes.h"

#include <cstddef>
#include <vector>

namespace scenefile::bench {

struct RayRecord {
  float ox, oy, oz, near;
  float dx, dy, dz, far;
};

struct BareObject {
  Affine object_from_world;
  Bounds bounds;
  Shape shape;
};

class BareScene {
 public:
  /// Objects other than meshes.
  explicit BareScene(const std::vector<BareObject>& objects);
  ~BareScene();
  BareScene(const BareScene&) = delete;
  BareScene& operator=(const BareScene&) = delete;

  /// Traces the rays in packets of 1, 8 or 16.
  void ask(const RayRecord* rays, std::size_t count, int lanes, bool shadow) const;

 private:
  struct State;
  State* state_;
};

}  // namespace scenefile::bench
