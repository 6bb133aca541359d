#include "scenefile/format/write_lights.h"

#include "scenefile/base/affine.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/scene/vocabulary.h"
#include "scenefile/scene/world_lights.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace scenefile {

namespace {

// A direction that gives exactly `wanted` when it is normalized again; for `wanted` itself, the
// result may differ by rounding.
glm::vec3 stable_direction(const Light& light, const RenderLight& wanted) {
  Light trial = light;
  const auto comes_out = [&](const glm::vec3& direction) {
    trial.direction = direction;
    const std::optional<RenderLight> ready = ready_light(trial, DAffine());
    return ready && ready->direction == wanted.direction;
  };
  if (comes_out(light.direction)) {
    return light.direction;
  }
  // Nearly always one of the first few lengths works.
  constexpr int lengths = 4096;
  for (int i = 0; i < lengths; ++i) {
    const glm::vec3 longer = wanted.direction * (1.0f + static_cast<float>(i) / lengths);
    if (comes_out(longer)) {
      return longer;
    }
  }
  return wanted.direction;
}

bool is_finite(const RenderLight& light) {
  const glm::vec3 sum = glm::abs(light.position) + glm::abs(light.half_u) + glm::abs(light.half_v);
  return std::isfinite(2 * (sum.x + sum.y + sum.z));
}

class WorldCopies {
 public:
  WorldCopies(const Scene& scene, const Limits& limits, Diagnostics& diagnostics)
      : scene_(scene), limits_(limits), diagnostics_(diagnostics) {}

  std::vector<Light> make() {
    world_lights(scene_, [this](const WorldLight& at) { return add(at); });
    if (moved_ != 0) {
      diagnostics_.report(write_light_moved, first_moved_,
                          fmt::format("{} light{} moved from groups to the top of the file", moved_,
                                      moved_ == 1 ? " is" : "s are"));
    }
    return std::move(lights_);
  }

 private:
  // Returns false if the limit is reached.
  bool add(const WorldLight& at) {
    const Light& light = scene_.nodes[at.node].lights[at.index];
    if (lights_.size() == limits_.lights) {
      diagnostics_.report(
          write_light_limit, light.location,
          fmt::format("the scene has more lights than the limit of {}", limits_.lights));
      return false;
    }
    const bool at_root = at.node == scene_.root;
    if (at_root && at.world_from_node == DAffine()) {
      lights_.push_back(light);
      return true;
    }
    const std::optional<RenderLight> ready = ready_light(light, at.world_from_node);
    if (!ready || !is_finite(*ready)) {
      diagnostics_.report(
          write_light_dark, light.location,
          fmt::format("the {} light lights nothing and is left out", word_of(light.type)));
      return true;
    }
    lights_.push_back(placed(light, *ready));
    if (!at_root) {
      first_moved_ = moved_ == 0 ? light.location : first_moved_;
      ++moved_;
    }
    return true;
  }

  Light placed(const Light& light, const RenderLight& ready) {
    Light result = light;
    if (light_uses(light.type, Field::position)) {
      result.position = ready.position;
    }
    if (light_uses(light.type, Field::direction)) {
      result.direction = stable_direction(light, ready);
    }
    if (has_rectangle(light.type)) {
      place_rectangle(result, light, ready);
    }
    return result;
  }

  void place_rectangle(Light& result, const Light& light, const RenderLight& wanted) {
    const auto same_sides = [&] {
      const std::optional<RenderLight> ready = ready_light(result, DAffine());
      return ready && alike(wanted, *ready);
    };
    if (same_sides()) {
      return;
    }
    result.width = static_cast<float>(2 * glm::length(glm::dvec3(wanted.half_u)));
    result.height = static_cast<float>(2 * glm::length(glm::dvec3(wanted.half_v)));
    if (!same_sides()) {
      diagnostics_.report(
          write_light_turned, light.location,
          "the area light is rotated or sheared by its group in a way that XML cannot express");
    }
  }

  const Scene& scene_;
  const Limits& limits_;
  Diagnostics& diagnostics_;
  std::vector<Light> lights_;
  std::size_t moved_ = 0;
  Location first_moved_;
};

}  // namespace

std::vector<Light> lights_in_world(const Scene& scene, const Limits& limits,
                                   Diagnostics& diagnostics) {
  return WorldCopies(scene, limits, diagnostics).make();
}

}  // namespace scenefile
