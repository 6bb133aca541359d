#include "scenefile/trace/flatten_instances.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace scenefile {

namespace {

// Duplicate instances at the same place have no effect, but rays would follow each: a template with
// ten equal instances, forty levels deep, would never end.
std::vector<FlattenEdge> distinct_edges(const RenderGroup& group) {
  using Key = std::array<std::uint32_t, 13>;
  std::vector<std::pair<Key, std::size_t>> keys;
  keys.reserve(group.instances.size());
  for (std::size_t i = 0; i < group.instances.size(); ++i) {
    const RenderInstance& instance = group.instances[i];
    static_assert(sizeof(Affine) == 12 * sizeof(float));
    Key key;
    std::memcpy(key.data(), &instance.group_from_instance, sizeof(Affine));
    key[12] = instance.group;
    keys.emplace_back(key, i);
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end(),
                         [](const auto& a, const auto& b) { return a.first == b.first; }),
             keys.end());
  std::sort(keys.begin(), keys.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<FlattenEdge> edges;
  edges.reserve(keys.size());
  for (const auto& [key, i] : keys) {
    const RenderInstance& instance = group.instances[i];
    edges.push_back({instance.group_from_instance, instance.group, instance.source, false});
  }
  return edges;
}

// Files can make these sums larger than any integer.
std::size_t add_saturating(std::size_t a, std::size_t b) {
  return b > std::numeric_limits<std::size_t>::max() - a ? std::numeric_limits<std::size_t>::max()
                                                         : a + b;
}

// Groups with at most this cost are copied wherever they are used.
constexpr std::size_t small_cost = 4;

class Planner {
 public:
  Planner(const RenderScene& scene, const FlattenLimits& limits, FlattenPlan& plan)
      : scene_(scene), limits_(limits), plan_(plan) {}

  void run() {
    const std::size_t count = scene_.groups.size();
    uses_.assign(count, 0);
    cost_.assign(count, 0);
    for (const RenderGroup& group : scene_.groups) {
      plan_.edges.push_back(distinct_edges(group));
      for (const FlattenEdge& edge : plan_.edges.back()) {
        ++uses_[edge.group];
      }
    }
    for (std::uint32_t g = 0; g < count; ++g) {
      flatten_into(g);
    }
    keep_what_is_used();
  }

 private:
  // Copying takes a step for each object and each group around it, so chains of templates with one
  // object each are not free.
  std::size_t copy_cost(const FlattenEdge& edge) const {
    return uses_[edge.group] == 1 || cost_[edge.group] <= small_cost ? 0 : cost_[edge.group];
  }

  void flatten_into(std::uint32_t g) {
    std::size_t whole = scene_.groups[g].primitives.size();
    std::size_t copied = 0;
    for (const FlattenEdge& edge : plan_.edges[g]) {
      whole = add_saturating(whole, add_saturating(cost_[edge.group], 1));
      copied = add_saturating(copied, copy_cost(edge));
    }
    const bool copy_shared =
        whole <= limits_.group_objects && copied <= limits_.copied_objects - copied_;
    copied_ += copy_shared ? copied : 0;
    cost_[g] = scene_.groups[g].primitives.size();
    for (FlattenEdge& edge : plan_.edges[g]) {
      edge.flattened = copy_shared || copy_cost(edge) == 0;
      cost_[g] += 1 + (edge.flattened ? cost_[edge.group] : 0);
    }
  }

  void keep_what_is_used() {
    const std::size_t count = scene_.groups.size();
    plan_.kept.assign(count, false);
    // How deep kept groups are nested below each group, not counting itself.
    std::vector<std::uint32_t> below(count, 0);
    for (std::uint32_t g = 0; g < count; ++g) {
      for (const FlattenEdge& edge : plan_.edges[g]) {
        below[g] = std::max(below[g], below[edge.group] + (edge.flattened ? 0 : 1));
      }
    }
    if (count == 0) {
      return;
    }
    plan_.kept[scene_.root] = true;
    plan_.nesting = below[scene_.root];
    mark_kept(scene_.root);
  }

  // Groups are also reached through flattened ones, whose references count as well.
  void mark_kept(std::uint32_t root) {
    std::vector<bool> reached(scene_.groups.size(), false);
    reached[root] = true;
    for (std::uint32_t g = root + 1; g-- > 0;) {
      if (!reached[g]) {
        continue;
      }
      for (const FlattenEdge& edge : plan_.edges[g]) {
        reached[edge.group] = true;
        plan_.kept[edge.group] = plan_.kept[edge.group] || !edge.flattened;
      }
    }
  }

  const RenderScene& scene_;
  const FlattenLimits& limits_;
  FlattenPlan& plan_;
  std::vector<std::size_t> uses_;  // by distinct instances
  std::vector<std::size_t> cost_;  // steps to list the objects of the group after flattening
  std::size_t copied_ = 0;
};

}  // namespace

FlattenPlan plan_flattening(const RenderScene& scene, const FlattenLimits& limits) {
  FlattenPlan plan;
  Planner(scene, limits, plan).run();
  return plan;
}

std::vector<FlatObject> flat_objects(const RenderScene& scene, const FlattenPlan& plan,
                                     std::uint32_t group, Instances instances) {
  struct Frame {
    std::uint32_t group;
    DAffine top_from_group;
    std::uint32_t source = 0;  // of the instance that led here
    std::size_t next_primitive = 0;
    std::size_t next_edge = 0;
  };
  std::vector<FlatObject> objects;
  std::vector<Frame> stack{{group, {}}};
  const auto name_last_object = [&] {
    if (instances == Instances::named) {
      for (std::size_t i = 1; i < stack.size(); ++i) {
        objects.back().instances.push_back(stack[i].source);
      }
    }
  };
  while (!stack.empty()) {
    Frame& frame = stack.back();
    const std::vector<RenderPrimitive>& primitives = scene.groups[frame.group].primitives;
    const std::vector<FlattenEdge>& edges = plan.edges[frame.group];
    const bool primitives_left = frame.next_primitive < primitives.size();
    const bool edges_left = frame.next_edge < edges.size();
    if (!primitives_left && !edges_left) {
      stack.pop_back();
    } else if (!edges_left || (primitives_left && primitives[frame.next_primitive].source <
                                                      edges[frame.next_edge].source)) {
      const RenderPrimitive& primitive = primitives[frame.next_primitive++];
      objects.push_back(
          {frame.top_from_group * DAffine(primitive.group_from_object), &primitive, no_index, {}});
      name_last_object();
    } else {
      const FlattenEdge& edge = edges[frame.next_edge++];
      const DAffine top_from_instance = frame.top_from_group * DAffine(edge.group_from_instance);
      if (edge.flattened) {
        stack.push_back({edge.group, top_from_instance, edge.source});
      } else {
        objects.push_back({top_from_instance, nullptr, edge.group, {}});
        name_last_object();
        if (instances == Instances::named) {
          objects.back().instances.push_back(edge.source);
        }
      }
    }
  }
  return objects;
}

}  // namespace scenefile
