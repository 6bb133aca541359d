#pragma once
// A scene rearranged into what a format can say, with the same meaning. Forms of forms change
// nothing. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace scenefile {

/// XML: all lights at the root in world space, each with an id; root and templates hold children
/// and nothing else; a node holds one primitive, or children, or is an instance, and has a name
/// only with children; names are unique.
Scene xml_form(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

/// JSON: transforms in their order; lights at the origin of their node, without ids; the root holds
/// children and nothing else; instances have neither transforms nor names; a camera; no name of a
/// node is that of a template.
Scene json_form(const Scene& scene, Diagnostics& diagnostics);

// What both are made of.

/// The nodes that belong to the trees of the scene, each template behind those that it uses.
/// Instances lose what has no meaning in them.
Scene tidy_copy(const Scene& scene);

/// Gives the default to what has no effect on a light of its type; `keep_idle`: except what XML
/// files give to lights of all types.
void clear_unused(Light& light, bool keep_idle);

/// Moves what a node holds (its transforms too when `with_transforms`) into a new only child.
NodeId push_down(Scene& scene, NodeId node, bool with_transforms);

/// Puts new empty children in front of the others. Returns the first; the others follow it.
NodeId add_front_children(Scene& scene, NodeId node, std::size_t count);

/// Leaves out groups that hold nothing, not even lights, and says so. `lit` marks nodes that held
/// lights before; groups that are empty only without them are left out without a word. The root and
/// templates stay.
void drop_empty_groups(Scene& scene, std::vector<bool> lit, Diagnostics& diagnostics);

/// Names that are taken, and new ones that are not.
class NameTable {
 public:
  bool take(const std::string& name) { return taken_.insert(name).second; }
  bool is_taken(const std::string& name) const { return taken_.contains(name); }
  /// "chair-2" or so, and takes it.
  std::string make_free(const std::string& name);

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, std::size_t> last_number_;
};

}  // namespace scenefile
