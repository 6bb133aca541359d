#include "scenefile/scene/check.h"

#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/scene/check_parts.h"
#include "scenefile/scene/codes.h"
#include "scenefile/scene/walk.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace scenefile {

namespace {

// Light ids, which should be distinct and in 0 to 7. If there are more than 8 lights (a separate
// finding), higher ids are unavoidable.
class LightIds {
 public:
  explicit LightIds(const Scene& scene) {
    std::size_t lights = 0;
    for (const Node& node : scene.nodes) {
      lights += node.lights.size();
    }
    highest_ = std::max<std::size_t>(highest_, lights == 0 ? 0 : lights - 1);
  }

  void check(const Light& light, NodeId node, Reporter& reporter) {
    if (!light.id) {
      return;
    }
    const Subject subject{"light", light.location, node};
    if (*light.id < 0 || static_cast<std::size_t>(*light.id) > highest_) {
      reporter.report("light.id-range"_code, subject, Field::id,
                      fmt::format("id {} of a light is not between 0 and 7", *light.id));
    }
    const auto [first, added] = first_.emplace(*light.id, light.location);
    if (!added) {
      const std::string where =
          first->second.known() ? fmt::format(" (line {})", first->second.line) : "";
      reporter.report("light.duplicate-id"_code, subject, Field::id,
                      fmt::format("id {} belongs to an earlier light{} too", *light.id, where));
    }
  }

 private:
  std::size_t highest_ = 7;
  std::map<int, Location> first_;
};

void check_contents(const Scene& scene, Reporter& reporter) {
  LightIds ids(scene);
  std::vector<bool> seen(scene.nodes.size());
  for (const NodeId head : tree_heads(scene)) {
    walk_nodes(scene, head, 0, seen, [&](NodeId id, int) {
      for (const Light& light : scene.nodes[id].lights) {
        check_light(light, id, reporter);
        ids.check(light, id, reporter);
      }
      for (const Primitive& primitive : scene.nodes[id].primitives) {
        check_primitive(primitive, id, scene.global, reporter);
      }
      return 0;
    });
  }
}

}  // namespace

void Reporter::report(const Code& code, const Subject& subject, std::string message) {
  report_at(code, subject.location, subject.node, std::move(message));
}

void Reporter::report(const Code& code, const Subject& subject, Field field, std::string message,
                      std::optional<Correction> correction) {
  report_at(code, places_.find(subject.location, field), subject.node, std::move(message),
            std::move(correction));
}

void Reporter::report_at(const Code& code, Location location, NodeId node, std::string message,
                         std::optional<Correction> correction) {
  if (scene_.incomplete && code.kind == CodeKind::absence) {
    return;
  }
  // Skip the path for findings that are not kept; there can be very many.
  if (!location.known() && node != no_node && diagnostics_.dropped(code) == 0) {
    if (!paths_) {
      paths_.emplace(scene_);
    }
    message += fmt::format(" (in {})", escaped(paths_->path(node), 200));
  }
  diagnostics_.report(code, location, std::move(message), std::move(correction));
}

bool Reporter::finite(const Subject& subject, Field field, std::string_view name, float value) {
  return finite(subject, field, name, glm::vec3(value));
}

bool Reporter::finite(const Subject& subject, Field field, std::string_view name,
                      const glm::vec3& value) {
  if (subject.unread.contains(field)) {
    return false;
  }
  if (scenefile::finite(value)) {
    return true;
  }
  report("scene.not-finite"_code, subject, field,
         fmt::format("{} of the {} is not a finite number", name, subject.what));
  return false;
}

std::string vector_text(const glm::vec3& v) {
  return fmt::format("{} {} {}", number_text(v.x), number_text(v.y), number_text(v.z));
}

void check(const Scene& scene, const Limits& limits, Diagnostics& diagnostics) {
  Reporter reporter(scene, diagnostics);
  check_structure(scene, reporter);
  check_global(scene.global, reporter);
  if (scene.camera) {
    check_camera(*scene.camera, reporter);
  }
  check_contents(scene, reporter);
  check_transforms(scene, reporter);
  check_templates(scene, limits, reporter);
}

}  // namespace scenefile
