#pragma once
// Names of trees: declarations and uses, resolved at the end of the file. Internal to format.

#include "scenefile/format/xml_values.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace scenefile {

class XmlReferences {
 public:
  /// Declares a top-level tree. Returns false, after an error, if the name is taken.
  bool declare(const XmlContext& context, std::string_view name, Location place);
  /// Makes the node an instance of the name. `is_tree`: the use is an empty tree with that name,
  /// which may turn out to be just an empty tree.
  void use(Scene& scene, NodeId node, std::string_view name, Location place, bool is_tree);
  /// The first use of the name before its declaration; unknown if there is none.
  Location early_use(const std::string& name) const;
  /// Moves the last use from node `from` to node `to`.
  void move_last_use(NodeId from, NodeId to);
  /// If parts of the file could not be read, they may declare the missing names: turns uses of
  /// undeclared names into empty nodes.
  void forget_unknown(Scene& scene) const;
  /// Called at the end of the file: resolves uses of names that were declared later, and finds the
  /// root.
  void resolve(const XmlContext& context, Scene& scene, Location scenefile);

 private:
  struct Use {
    NodeId node;
    Location place;
    bool is_tree;
  };
  static void resolve_empty(const XmlContext& context, Scene& scene, const std::vector<Use>& uses);
  void resolve_nested(const XmlContext& context, Scene& scene, const std::vector<Use>& uses);
  void resolve_root(const XmlContext& context, Scene& scene, Location scenefile) const;

  std::unordered_map<std::string, Location> declared_;
  std::vector<Use> early_uses_;
  std::unordered_map<std::string, Location> first_early_uses_;
};

}  // namespace scenefile
