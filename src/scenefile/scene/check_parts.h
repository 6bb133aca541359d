#pragma once
// The pieces of check(). Internal to scene.

#include "scenefile/base/components.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/field_places.h"
#include "scenefile/scene/node_path.h"
#include "scenefile/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

inline constexpr NodeId no_node = 0xffffffffu;

/// What a finding is about: a camera, a light, a primitive, a node.
struct Subject {
  std::string_view what;  ///< such as "sphere"
  Location location;
  NodeId node = no_node;
  FieldSet unread = {};  ///< findings must not depend on these
};

/// Adds findings with the place of their subject or field.
class Reporter {
 public:
  Reporter(const Scene& scene, Diagnostics& diagnostics)
      : scene_(scene), diagnostics_(diagnostics), places_(scene.field_places) {}

  /// A finding about the subject as a whole. If the subject has no place in a file, the message
  /// names its node.
  void report(const Code& code, const Subject& subject, std::string message);
  /// A finding about one field of the subject.
  void report(const Code& code, const Subject& subject, Field field, std::string message,
              std::optional<Correction> correction = {});

  /// Whether the file sets the field, rather than leaving it at its default.
  bool gives(const Subject& subject, Field field) {
    return places_.find(subject.location, field) != subject.location;
  }

  /// Returns whether the value is known and finite; reports one that is not finite.
  bool finite(const Subject& subject, Field field, std::string_view name, float value);
  bool finite(const Subject& subject, Field field, std::string_view name, const glm::vec3& value);

 private:
  void report_at(const Code& code, Location location, NodeId node, std::string message,
                 std::optional<Correction> correction = {});

  const Scene& scene_;
  Diagnostics& diagnostics_;
  FieldPlaces places_;
  std::optional<NodePaths> paths_;
};

/// "1 0.5 0".
std::string vector_text(const glm::vec3& v);
inline bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline float smallest(const glm::vec3& v) {
  return std::min({v.x, v.y, v.z});
}

void check_global(const Global& global, Reporter& reporter);
void check_camera(const Camera& camera, Reporter& reporter);
void check_light(const Light& light, NodeId node, Reporter& reporter);
void check_primitive(const Primitive& primitive, NodeId node, const Global& global,
                     Reporter& reporter);

/// Validates node indices, which the rest of the room does not trust.
void check_structure(const Scene& scene, Reporter& reporter);
/// Checks templates, what they contain, and the totals after instancing.
void check_templates(const Scene& scene, const Limits& limits, Reporter& reporter);
/// Checks each transform, and that their products can be drawn.
void check_transforms(const Scene& scene, Reporter& reporter);

}  // namespace scenefile
