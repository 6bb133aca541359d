#pragma once
// Names of trees: who is declared, who is used, what that means at the end of the file. Internal to
// the room.

#include "scenefile/format/xml_context.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace scenefile {

class XmlReferences {
 public:
  /// A tree at the top of the file. False, after an error: the name is taken.
  bool declare(const XmlContext& context, std::string_view name, Location place);
  /// The node is an instance of the name. `is_tree`: said by an empty tree of that name, which may
  /// turn out to be just that.
  void use(Scene& scene, NodeId node, std::string_view name, Location place, bool is_tree);
  /// Where the name was first used before it was declared; unknown: nowhere.
  Location early_use(const std::string& name) const;
  /// What was used last by `from` is used by `to` instead.
  void move_last_use(NodeId from, NodeId to);
  /// Where a part of the file could not be read, which may declare what is used: turns uses of
  /// names that are not declared into empty nodes.
  void forget_unknown(Scene& scene) const;
  /// At the end of the file: finds what names mean that were not declared when they were used, and
  /// the root.
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
