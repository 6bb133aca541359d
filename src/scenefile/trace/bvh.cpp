#include "scenefile/trace/bvh.h"

#include <algorithm>
#include <numeric>

namespace scenefile {

namespace {

constexpr std::size_t bins = 16;
constexpr std::uint32_t max_in_leaf = 4;

FloatBox empty_box() {
  constexpr float far = std::numeric_limits<float>::max();
  return {{far, far, far}, {-far, -far, -far}};
}

void grow(FloatBox& box, const FloatBox& other) {
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = std::min(box.min[axis], other.min[axis]);
    box.max[axis] = std::max(box.max[axis], other.max[axis]);
  }
}

double center(const FloatBox& box, int axis) {
  return 0.5 * (double{box.min[axis]} + double{box.max[axis]});
}

// Half of the surface area.
double area(const FloatBox& box) {
  const double x = double{box.max[0]} - double{box.min[0]};
  const double y = double{box.max[1]} - double{box.min[1]};
  const double z = double{box.max[2]} - double{box.min[2]};
  return x * y + y * z + z * x;
}

struct Bin {
  FloatBox box = empty_box();
  std::uint32_t count = 0;

  void add(const Bin& other) {
    grow(box, other.box);
    count += other.count;
  }
  double cost() const { return count == 0 ? 0 : area(box) * count; }
};

// An axis with bins over the centers of the boxes.
struct Cuts {
  int axis = 0;
  double low = 0;
  double high = 0;

  std::size_t bin_of(const FloatBox& box) const {
    const double share = (center(box, axis) - low) / (high - low);
    return std::min(static_cast<std::size_t>(share * bins), bins - 1);
  }
};

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  Cuts cuts;
  std::size_t bin = 0;  // first bin of the second half

  bool found() const { return std::isfinite(cost); }
};

}  // namespace

struct Bvh::Work {
  const std::vector<FloatBox>& boxes;

  FloatBox box(const std::uint32_t* first, const std::uint32_t* last) const {
    FloatBox whole = empty_box();
    for (const std::uint32_t* i = first; i < last; ++i) {
      grow(whole, boxes[*i]);
    }
    return whole;
  }

  // Returns false if all centers coincide.
  bool find_cuts(const std::uint32_t* first, const std::uint32_t* last, Cuts& cuts) const {
    cuts.low = std::numeric_limits<double>::infinity();
    cuts.high = -cuts.low;
    for (const std::uint32_t* i = first; i < last; ++i) {
      const double at = center(boxes[*i], cuts.axis);
      cuts.low = std::min(cuts.low, at);
      cuts.high = std::max(cuts.high, at);
    }
    return cuts.low < cuts.high;
  }

  void improve(const std::uint32_t* first, const std::uint32_t* last, const Cuts& cuts,
               Split& best) const {
    std::array<Bin, bins> all;
    for (const std::uint32_t* i = first; i < last; ++i) {
      Bin& bin = all[cuts.bin_of(boxes[*i])];
      grow(bin.box, boxes[*i]);
      ++bin.count;
    }
    std::array<double, bins> cost_after{};  // cost of this bin and all after it
    Bin sum;
    for (std::size_t b = bins; b-- > 1;) {
      sum.add(all[b]);
      cost_after[b] = sum.cost();
    }
    sum = {};
    for (std::size_t b = 1; b < bins; ++b) {
      sum.add(all[b - 1]);
      if (const double cost = sum.cost() + cost_after[b]; cost < best.cost) {
        best = {cost, cuts, b};
      }
    }
  }

  Split best_split(const std::uint32_t* first, const std::uint32_t* last) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (Cuts cuts{axis, 0, 0}; find_cuts(first, last, cuts)) {
        improve(first, last, cuts, best);
      }
    }
    return best;
  }

  // Partitions the items; returns the first of the second half.
  std::uint32_t* parted(std::uint32_t* first, std::uint32_t* last, bool by_cost) const {
    const Split best = by_cost ? best_split(first, last) : Split();
    if (best.found()) {
      std::uint32_t* const half = std::partition(
          first, last, [&](std::uint32_t i) { return best.cuts.bin_of(boxes[i]) < best.bin; });
      if (half != first && half != last) {
        return half;
      }
    }
    return first + (last - first) / 2;
  }
};

Bvh::Bvh(const std::vector<FloatBox>& boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0u);
  Work work{boxes};
  whole_ = work.box(items_.data(), items_.data() + items_.size());
  nodes_.reserve(boxes.size() / 2);
  root_ = make(work, 0, static_cast<std::uint32_t>(boxes.size()), 0);
}

Bvh::Child Bvh::make(Work& work, std::uint32_t first, std::uint32_t last, int level) {
  if (last - first <= max_in_leaf) {
    return {first, last - first};
  }
  std::uint32_t* const items = items_.data();
  const auto half = static_cast<std::uint32_t>(
      work.parted(items + first, items + last, level < max_levels) - items);
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(
      {{work.box(items + first, items + half), work.box(items + half, items + last)}, {}});
  const Child left = make(work, first, half, level + 1);
  const Child right = make(work, half, last, level + 1);
  nodes_[index].child[0] = left;
  nodes_[index].child[1] = right;
  return {index, 0};
}

}  // namespace scenefile
