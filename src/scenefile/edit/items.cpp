// Finds the parts of a scene in the syntax of its text.

#include "scenefile/base/text.h"
#include "scenefile/edit/document.h"
#include "scenefile/edit/document_state.h"
#include "scenefile/format/xml_blocks.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace scenefile {

namespace {

constexpr FieldName transblock_names[] = {{transform_words[0], 0},
                                          {transform_words[1], 1},
                                          {transform_words[2], 2},
                                          {transform_words[3], 3},
                                          {"object", 4}};

class ItemFinder {
 public:
  explicit ItemFinder(Document::State& state)
      : state_(state), syntax_(state.syntax), scene_(state.scene), reader_(state) {}

  void find() {
    add_blocks();
    if (syntax_.xml) {
      find_xml();
    } else {
      find_json();
    }
  }

 private:
  ItemId add(ItemKind kind, std::string name, PartId element, PartId block, ItemId parent) {
    const auto id = static_cast<ItemId>(state_.items.size());
    SceneItem& item = state_.items.emplace_back();
    item.kind = kind;
    item.name = std::move(name);
    item.element = element;
    item.block = block;
    item.parent = parent;
    item.written = element != no_part || block != no_part;
    if (item.written) {
      item.range = syntax_[block != no_part ? block : element].range();
    }
    if (parent != no_item) {
      state_.items[parent].children.push_back(id);
    }
    return id;
  }

  void add_blocks() {
    add(ItemKind::globals, {}, syntax_.at(scene_.global.location), no_part, no_item);
    add(ItemKind::camera, {}, scene_.camera ? syntax_.at(scene_.camera->location) : no_part,
        no_part, no_item);
  }

  ItemId add_light(const Light& light, NodeId node, ItemId parent) {
    const ItemId id = add(ItemKind::light, std::string(word_of(light.type)),
                          syntax_.at(light.location), no_part, parent);
    state_.items[id].node = node;
    return id;
  }

  // XML.

  void find_xml() {
    for (NodeId id = 0; id < scene_.nodes.size(); ++id) {
      const Node& node = scene_.nodes[id];
      const PartId part = syntax_.at(node.location);
      if (!nodes_.emplace(part, id).second) {
        made_room_.emplace(part, id);
      }
      for (const Primitive& primitive : node.primitives) {
        primitives_.emplace(syntax_.at(primitive.location), &primitive);
      }
    }
    for (const Light& light : scene_.nodes[scene_.root].lights) {
      add_light(light, scene_.root, no_item);
    }
    for (const PartId part : syntax_[0].children) {
      const auto found = nodes_.find(part);
      if (found == nodes_.end()) {
        continue;
      }
      const NodeId node = found->second;
      const auto& masters = scene_.templates;
      const bool is_root = node == scene_.root;
      if (!is_root && std::find(masters.begin(), masters.end(), node) == masters.end()) {
        continue;  // its name is taken
      }
      const ItemId id =
          add(is_root ? ItemKind::root : ItemKind::master,
              is_root ? std::string() : scene_.nodes[node].name.str(), part, no_part, no_item);
      state_.items[id].node = node;
      fill_tree(id);
    }
  }

  void fill_tree(ItemId tree) {
    std::vector<ItemId> open{tree};
    while (!open.empty()) {
      const ItemId parent = open.back();
      open.pop_back();
      const PartId element = state_.items[parent].element;
      const std::size_t first = state_.items.size();
      for (const PartId child : syntax_[element].children) {
        if (const auto found = nodes_.find(child); found != nodes_.end()) {
          add_objects(child, found->second, parent);
        }
      }
      for (std::size_t i = state_.items.size(); i-- > first;) {
        if (state_.items[i].kind == ItemKind::group) {
          open.push_back(static_cast<ItemId>(i));
        }
      }
    }
  }

  // The objects of a transblock, or an object without one.
  void add_objects(PartId child, NodeId node, ItemId parent) {
    if (syntax_.name(child) == "object") {
      add_object(child, no_part, node, parent);
      return;
    }
    const std::vector<PartId> objects = objects_in(state_, reader_.context, child);
    for (const PartId object : objects) {
      const ItemId id = add_object(object, child, node, parent);
      if (objects.size() > 1) {
        state_.items[id].shared = true;
        state_.items[id].range = syntax_[object].range();
      }
    }
    if (objects.empty()) {
      const ItemId id = add(ItemKind::unread, {}, no_part, child, parent);
      state_.items[id].node = node;
    }
  }

  bool has_contents(PartId object) const {
    const auto& children = syntax_[object].children;
    return std::any_of(children.begin(), children.end(),
                       [&](PartId child) { return nodes_.contains(child); });
  }

  ItemId add_object(PartId object, PartId block, NodeId node, ItemId parent) {
    const ReadTag tag(state_, object);
    const std::optional<ObjectTag> read = read_object_tag(reader_.context, tag.tag);
    const std::string name = read ? std::string(read->name) : std::string();
    const auto own = nodes_.find(object);
    NodeId placed = own == nodes_.end() ? node : own->second;
    if (const auto moved = made_room_.find(block);
        placed == node && moved != made_room_.end() &&
        scene_.nodes[moved->second].instance_of == name) {
      placed = moved->second;
      made_room_.erase(moved);
    }
    const std::string& master = scene_.nodes[placed].instance_of;
    const bool tree = read && read->type == ObjectType::tree;
    const bool instance =
        (!master.empty() && name == master) ||
        (read && read->type == ObjectType::master && !name.empty() && name != "root");
    ItemKind kind = ItemKind::unread;
    std::string shown = name;
    if (const auto primitive = primitives_.find(object); primitive != primitives_.end()) {
      kind = ItemKind::primitive;
      shown = word_of(primitive->second->shape);
    } else if (instance && !(tree && has_contents(object))) {
      kind = ItemKind::instance;
    } else if (tree) {
      kind = ItemKind::group;
    }
    const ItemId id = add(kind, shown, object, block, parent);
    state_.items[id].node = placed;
    return id;
  }

  // JSON.

  void find_json() {
    for (const NodeId master : scene_.templates) {
      add_node(master, ItemKind::master, no_item);
    }
    add_node(scene_.root, ItemKind::root, no_item);
  }

  void add_node(NodeId top, ItemKind kind, ItemId parent) {
    struct Open {
      NodeId node;
      ItemKind kind;
      ItemId parent;
    };
    std::vector<Open> open{{top, kind, parent}};
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      const Node& node = scene_.nodes[next.node];
      const bool instance = !node.instance_of.empty();
      const ItemId id =
          add(instance ? ItemKind::instance : next.kind,
              next.kind == ItemKind::root ? std::string()
                                          : (instance ? node.instance_of : node.name).str(),
              syntax_.at(node.location), no_part, next.parent);
      state_.items[id].node = next.node;
      for (const Light& light : node.lights) {
        add_light(light, next.node, id);
      }
      for (const Primitive& primitive : node.primitives) {
        const ItemId child = add(ItemKind::primitive, std::string(word_of(primitive.shape)),
                                 syntax_.at(primitive.location), no_part, id);
        state_.items[child].node = next.node;
      }
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
        open.push_back({*child, ItemKind::group, id});
      }
    }
  }

  Document::State& state_;
  const Syntax& syntax_;
  const Scene& scene_;
  SilentReader reader_;
  std::unordered_map<PartId, NodeId> nodes_;
  /// By transblock: the node of an instance that other objects follow.
  std::unordered_map<PartId, NodeId> made_room_;
  std::unordered_map<PartId, const Primitive*> primitives_;
};

}  // namespace

std::string_view child_name(const Document::State& state, const XmlContext& context, PartId child) {
  constexpr FieldName top_names[] = {
      {"globaldata", 0}, {"cameradata", 1}, {"lightdata", 2}, {"object", 3}};
  const ReadTag tag(state, child);
  const bool top = state.syntax[child].parent == 0;
  const std::span<const FieldName> names =
      top ? std::span<const FieldName>(top_names) : std::span<const FieldName>(transblock_names);
  const std::optional<std::size_t> field =
      find_field(context, tag.tag, names, top ? "scenefile" : "transblock");
  return field ? names[*field].name : std::string_view();
}

std::vector<PartId> objects_in(const Document::State& state, const XmlContext& context,
                               PartId block) {
  std::vector<PartId> objects;
  for (const PartId child : state.syntax[block].children) {
    if (child_name(state, context, child) == "object") {
      objects.push_back(child);
      if (!state.options.compat_course) {
        break;
      }
    }
  }
  return objects;
}

void find_items(Document::State& state) {
  ItemFinder(state).find();
}

}  // namespace scenefile
