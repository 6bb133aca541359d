// What stands in a tree: transblocks, their transforms and their objects.

#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/large_scene.h"
#include "scenefile/format/xml_scene_builder.h"

#include <fmt/format.h>

#include <utility>

namespace scenefile {

namespace {

enum BlockField : std::size_t { b_translate, b_rotate, b_scale, b_matrix, b_object };
constexpr FieldName block_names[] = {{"translate", b_translate},
                                     {"rotate", b_rotate},
                                     {"scale", b_scale},
                                     {"matrix", b_matrix},
                                     {"object", b_object}};

}  // namespace

bool SceneBuilder::open_in_tree(const XmlTag& tag) {
  constexpr std::string_view transblock = "transblock";
  if (tag.name == transblock) {
    return open_transblock(tag);
  }
  if (!nearest_name(tag.name, {&transblock, 1}).empty()) {
    context_.report(xml_misspelt_transblock, tag,
                    fmt::format("{} was read as <transblock>", element_text(tag.name)));
    return open_transblock(tag);
  }
  if (tag.name != "object") {
    report_unknown_element(context_, tag, top().element);
    return false;
  }
  context_.report(
      xml_object_without_transblock, tag,
      "the object stands in a tree without a transblock around it; it was read as if one "
      "without transforms were there: put <transblock> and </transblock> around it");
  top().has_content = true;
  const std::size_t depth = frames_.size();
  push(Block::transblock, add_child_node(top().node, tag.location), tag.name);
  const bool opened = open_object(tag);
  if (opened) {
    frames_[depth].is_implicit = true;
  } else {
    frames_.pop_back();
  }
  return opened;
}

bool SceneBuilder::open_transblock(const XmlTag& tag) {
  expect_no_attributes(context_, tag);
  top().has_content = true;
  return push(Block::transblock, add_child_node(top().node, tag.location), tag.name);
}

bool SceneBuilder::open_in_transblock(const XmlTag& tag) {
  if (top().has_content && !context_.options.compat_course) {
    return ignore(
        xml_after_object, tag,
        fmt::format("{} is ignored, as all that follows the first object of a transblock; "
                    "--compat course uses it",
                    element_text(tag.name)));
  }
  if (tag.name == "transblock") {
    return ignore(xml_misplaced_element, tag,
                  "a transblock cannot stand right inside a transblock, so it was ignored; put it "
                  "into <object type=\"tree\">");
  }
  const std::optional<std::size_t> field = find_field(context_, tag, block_names, top().element);
  if (!field) {
    return false;
  }
  if (top().has_content) {
    context_.report(xml_after_object_used, tag,
                    fmt::format("{} follows the first object of a transblock; it was used all the "
                                "same",
                                element_text(tag.name)));
  }
  switch (static_cast<BlockField>(*field)) {
    case b_translate:
      return open_transform(tag, read_translate(context_, tag));
    case b_rotate:
      return open_transform(tag, read_rotate(context_, tag));
    case b_scale:
      return open_transform(tag, read_scale(context_, tag));
    case b_matrix:
      return open_matrix(tag);
    case b_object:
      return open_object(tag);
  }
  return false;
}

bool SceneBuilder::open_transform(const XmlTag& tag, std::optional<Transform> transform) {
  if (transform) {
    transforms_.push_back(*transform);
  }
  return open_leaf(tag, true);
}

bool SceneBuilder::open_matrix(const XmlTag& tag) {
  expect_no_attributes(context_, tag);
  matrix_ = {};
  matrix_.location = tag.location;
  return push(Block::matrix, 0, tag.name);
}

// In a transblock.
bool SceneBuilder::open_object(const XmlTag& tag) {
  const std::optional<ObjectTag> object = read_object_tag(context_, tag);
  make_room_for_object(top().node);
  top().has_content = true;
  if (!object) {
    return false;
  }
  switch (object->type) {
    case ObjectType::tree:
      return open_tree(tag, *object);
    case ObjectType::master:
      return open_instance(tag, *object);
    case ObjectType::primitive:
      return open_primitive(tag, *object);
  }
  return false;
}

bool SceneBuilder::open_tree(const XmlTag& tag, const ObjectTag& object) {
  if (object.name == "root") {
    context_.diagnostics.report(xml_reserved_root, Severity::warning, object.name_place,
                                "the name root belongs to the tree at the top of the file");
  }
  Node& node = scene_.nodes[top().node];
  if (node.name.empty()) {
    node.name = object.name;
  }
  push(Block::tree, top().node, tag.name);
  top().is_nested = true;
  top().name_place = object.name_place;
  return true;
}

bool SceneBuilder::open_instance(const XmlTag& tag, const ObjectTag& object) {
  if (object.name.empty()) {
    return ignore(xml_master_name, tag, "an instance needs the name of a master");
  }
  if (object.name == "root") {
    return ignore(xml_reserved_root, tag, "root cannot be a part of the scene; it is the scene");
  }
  Node& node = scene_.nodes[top().node];
  const bool is_used = !node.primitives.empty() || !node.children.empty();
  const NodeId id = is_used ? add_child_node(top().node, tag.location) : top().node;
  references_.use(scene_, id, object.name, object.name_place, false);
  return push(Block::instance, id, tag.name);
}

bool SceneBuilder::open_primitive(const XmlTag& tag, const ObjectTag& object) {
  const std::optional<Shape> shape = read_shape(context_, tag, object);
  if (!shape) {
    return false;
  }
  primitive_ = {top().node, {}, true};
  Primitive& primitive = scene_.nodes[top().node].primitives.emplace_back();
  primitive.shape = *shape;
  primitive.location = tag.location;
  if (*shape == Shape::mesh) {
    primitive.mesh_file = object.filename;
    scene_.field_places.push_back({tag.location, Field::mesh_file, object.filename_place});
  }
  return push(Block::primitive, top().node, tag.name);
}

NodeId SceneBuilder::add_node(Location location) {
  reserve_nodes(scene_.nodes, context_.places.progress());
  scene_.nodes.emplace_back().location = location;
  return static_cast<NodeId>(scene_.nodes.size() - 1);
}

NodeId SceneBuilder::add_child_node(NodeId parent, Location location) {
  const NodeId child = add_node(location);
  scene_.nodes[parent].children.push_back(child);
  return child;
}

// All transforms so far go to the node, in an array that is just large enough.
void SceneBuilder::flush_transforms(NodeId node) {
  std::vector<Transform>& all = scene_.nodes[node].transforms;
  if (all.empty()) {
    all.assign(transforms_.begin(), transforms_.end());
  } else {
    all.insert(all.end(), transforms_.begin(), transforms_.end());
  }
  transforms_.clear();
}

// An instance has no contents of its own: when another object comes, it moves into a child.
void SceneBuilder::make_room_for_object(NodeId node) {
  flush_transforms(node);
  if (scene_.nodes[node].instance_of.empty()) {
    return;
  }
  const NodeId child = add_child_node(node, scene_.nodes[node].location);
  scene_.nodes[child].instance_of = std::exchange(scene_.nodes[node].instance_of, {});
  references_.move_last_use(node, child);
}

void SceneBuilder::end_tree(const Frame& tree) {
  if (!tree.is_nested || tree.has_content) {
    return;
  }
  Node& node = scene_.nodes[tree.node];
  const bool is_used = !node.primitives.empty() || !node.children.empty();
  if (node.name.empty() || is_used) {
    context_.diagnostics.report(xml_empty_tree, tree.name_place, "the tree is empty");
    return;
  }
  const std::string name = std::exchange(node.name, {});
  references_.use(scene_, tree.node, name, tree.name_place, true);
}

void SceneBuilder::end_transblock(const Frame& block) {
  flush_transforms(block.node);
  if (!block.has_content) {
    context_.diagnostics.report(xml_transblock_without_object, scene_.nodes[block.node].location,
                                "the transblock has no object, so nothing is drawn for it");
  }
}

}  // namespace scenefile
