#pragma once
// Rearranges a scene into what a format can represent, with the same meaning. Idempotent. Internal
// to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace scenefile {

/// For XML: all lights are at the root in world space, each with an id. The root and templates
/// contain only children. A node has one primitive, or children, or is an instance, and has a name
/// only if it has children. Names are unique.
Scene xml_form(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

/// For JSON: transforms are in the fixed order; lights are at the origin of their node, without
/// ids. The root contains only children. Instances have neither transforms nor names. There is a
/// camera. No node has the name of a template.
Scene json_form(const Scene& scene, Diagnostics& diagnostics);

// Shared by both.

/// The nodes of the scene's trees, each template after those that it uses. Removes what has no
/// meaning in instances.
Scene tidy_copy(const Scene& scene);

/// Resets values that have no effect on a light of its type to their defaults; `keep_idle` keeps
/// those that XML files give to lights of all types.
void clear_unused(Light& light, bool keep_idle);

/// Moves the contents of a node (and its transforms, if `with_transforms`) into a new only child.
NodeId push_down(Scene& scene, NodeId node, bool with_transforms);

/// Inserts new empty children before the others. Returns the first; the others have consecutive
/// ids.
NodeId add_front_children(Scene& scene, NodeId node, std::size_t count);

/// Removes and reports groups that contain nothing, not even lights. `lit` marks nodes that
/// contained lights before; groups that are empty only without those are removed without a report.
/// Keeps the root and templates.
void drop_empty_groups(Scene& scene, std::vector<bool> lit, Diagnostics& diagnostics);

/// The set of names in use, and how to make new ones.
class NameTable {
 public:
  bool take(const std::string& name) { return taken_.insert(name).second; }
  bool is_taken(const std::string& name) const { return taken_.contains(name); }
  /// Makes an unused name, such as "chair-2", and takes it.
  std::string make_free(const std::string& name);

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, std::size_t> last_number_;
};

}  // namespace scenefile
