#include "scenefile/trace/packet_bvh.h"

#include <algorithm>
#include <numeric>

namespace scenefile {

namespace {

float middle(const FloatBox& box, int axis) {
  return 0.5f * box.min[axis] + 0.5f * box.max[axis];
}

int longest_axis(const std::vector<FloatBox>& boxes, const std::uint32_t* first,
                 const std::uint32_t* last) {
  int best = 0;
  float longest = -1;
  for (int axis = 0; axis < 3; ++axis) {
    float low = Bvh8Node::far;
    float high = -Bvh8Node::far;
    for (const std::uint32_t* i = first; i < last; ++i) {
      low = std::min(low, middle(boxes[*i], axis));
      high = std::max(high, middle(boxes[*i], axis));
    }
    if (high - low > longest) {
      longest = high - low;
      best = axis;
    }
  }
  return best;
}

// Sorts nearby objects next to each other: splits along the longest axis, at whole nodes. The depth
// is logarithmic in the number of objects.
void sort_by_place(const std::vector<FloatBox>& boxes, std::uint32_t* first, std::uint32_t* last) {
  const auto count = static_cast<std::size_t>(last - first);
  std::size_t block = Bvh8Node::width;
  if (count <= block) {
    return;
  }
  while (block * Bvh8Node::width < count) {
    block *= Bvh8Node::width;
  }
  std::uint32_t* const half = first + std::max<std::size_t>(1, count / block / 2) * block;
  const int axis = longest_axis(boxes, first, last);
  std::nth_element(first, half, last, [&](std::uint32_t a, std::uint32_t b) {
    return middle(boxes[a], axis) < middle(boxes[b], axis);
  });
  sort_by_place(boxes, first, half);
  sort_by_place(boxes, half, last);
}

}  // namespace

Bvh8Node::Bvh8Node() {
  std::fill(&min[0][0], &min[0][0] + 3 * width, far);
  std::fill(&max[0][0], &max[0][0] + 3 * width, -far);
}

void Bvh8Node::put(int at, const FloatBox& box) {
  for (int axis = 0; axis < 3; ++axis) {
    min[axis][at] = box.min[axis];
    max[axis][at] = box.max[axis];
  }
}

FloatBox Bvh8Node::box() const {
  FloatBox result{};
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] = *std::min_element(min[axis], min[axis] + width);
    result.max[axis] = *std::max_element(max[axis], max[axis] + width);
  }
  return result;
}

PacketBvh::PacketBvh(const std::vector<FloatBox>& boxes) : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  sort_by_place(boxes, order_.data(), order_.data() + order_.size());
  std::vector<FloatBox> entries;
  entries.reserve(boxes.size());
  for (const std::uint32_t object : order_) {
    entries.push_back(boxes[object]);
  }
  do {
    std::vector<Bvh8Node>& level = levels_.emplace_back((entries.size() + 7) / Bvh8Node::width);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      level[i / Bvh8Node::width].put(static_cast<int>(i % Bvh8Node::width), entries[i]);
    }
    entries.clear();
    for (const Bvh8Node& node : level) {
      entries.push_back(node.box());
    }
  } while (entries.size() > 1);
}

}  // namespace scenefile
