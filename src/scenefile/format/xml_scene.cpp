#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/reserve_nodes.h"
#include "scenefile/format/xml_blocks.h"
#include "scenefile/format/xml_fields.h"
#include "scenefile/format/xml_reader.h"
#include "scenefile/format/xml_references.h"
#include "scenefile/format/xml_values.h"
#include "scenefile/scene/scene.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

enum class Block : std::uint8_t {
  document,
  scenefile,
  globals,
  camera,
  light,
  tree,
  transblock,
  primitive,
  instance,
  matrix,
  leaf
};

/// An element while it is read.
struct Frame {
  Block block = Block::leaf;
  bool has_content = false;  ///< transblock: its object has come; tree: a transblock has
  bool is_implicit = false;  ///< transblock that is not in the file
  bool is_nested = false;    ///< tree inside a transblock
  NodeId node = 0;           ///< tree, transblock, primitive, instance
  std::string_view element;  ///< as written
  Location name_place;       ///< tree
};

/// Builds the scene while the file is read. Stores only the open elements, and the results of
/// closed ones.
class SceneBuilder final : public XmlHandler {
 public:
  explicit SceneBuilder(const XmlContext& context) : context_(context) { push(Block::document, 0); }

  bool start(const XmlTag& tag) override;
  void end() override;
  void text(std::string_view characters, Location location) override;

  /// Called at the end of the file, or where reading stopped.
  Scene finish(bool complete);

 private:
  bool open(const XmlTag& tag);
  bool open_document(const XmlTag& tag);
  bool open_top(const XmlTag& tag);
  bool open_globals(const XmlTag& tag);
  bool open_light(const XmlTag& tag);
  bool open_top_object(const XmlTag& tag);
  bool open_in_tree(const XmlTag& tag);
  bool open_transblock(const XmlTag& tag);
  bool open_in_transblock(const XmlTag& tag);
  bool open_transform(const XmlTag& tag, std::optional<Transform> transform);
  bool open_matrix(const XmlTag& tag);
  bool open_object(const XmlTag& tag);
  bool open_tree(const XmlTag& tag, const ObjectTag& object);
  bool open_instance(const XmlTag& tag, const ObjectTag& object);
  bool open_primitive(const XmlTag& tag, const ObjectTag& object);
  bool open_leaf(const XmlTag& tag, bool known);
  bool ignore(const Code& code, const XmlTag& tag, std::string message);

  bool push(Block block, NodeId node, std::string_view element = {});
  Frame& top() { return frames_.back(); }
  NodeId add_node(Location location);
  NodeId add_child_node(NodeId parent, Location location);
  void flush_transforms(NodeId node);
  void make_room_for_object(NodeId node);
  void end_tree(const Frame& tree);
  void end_transblock(const Frame& block);

  XmlContext context_;
  Scene scene_;
  XmlReferences references_;
  std::vector<Frame> frames_;
  std::size_t ignored_ = 0;  // depth inside a skipped element; 0: not inside one
  bool stopped_ = false;
  bool lost_tree_ = false;  // a top-level tree was lost after an error: its name may be used
  bool text_reported_ = false;
  Location scenefile_;

  // The blocks being read; none of them can be nested in itself.
  SeenFields globals_;
  CameraDraft camera_;
  LightDraft light_;
  PrimitiveDraft primitive_;
  MatrixDraft matrix_;
  std::vector<Transform> transforms_;  // of the innermost transblock, until its object is read
};

enum BlockField : std::size_t { b_translate, b_rotate, b_scale, b_matrix, b_object };
static_assert(b_object == transform_words.size());
constexpr FieldName block_names[] = {{transform_word<Translate>, b_translate},
                                     {transform_word<Rotate>, b_rotate},
                                     {transform_word<Scale>, b_scale},
                                     {transform_word<Matrix>, b_matrix},
                                     {"object", b_object}};

enum TopField : std::size_t { t_globals, t_camera, t_light, t_object };
constexpr FieldName top_names[] = {{"globaldata", t_globals},
                                   {"cameradata", t_camera},
                                   {"lightdata", t_light},
                                   {"object", t_object}};

bool SceneBuilder::start(const XmlTag& tag) {
  if (ignored_ != 0 || !open(tag)) {
    ++ignored_;
  }
  return !stopped_;
}

void SceneBuilder::end() {
  if (ignored_ != 0) {
    --ignored_;
    return;
  }
  if (top().block == Block::leaf) {
    frames_.pop_back();  // most elements; never directly in an implicit transblock
    return;
  }
  const Frame ended = top();
  frames_.pop_back();
  switch (ended.block) {
    case Block::camera:
      finish_camera(context_, camera_, scene_);
      break;
    case Block::light:
      finish_light(context_, light_, scene_);
      break;
    case Block::matrix:
      if (std::optional<Transform> matrix = finish_matrix(context_, matrix_)) {
        transforms_.push_back(*matrix);
      }
      break;
    case Block::tree:
      end_tree(ended);
      break;
    case Block::transblock:
      end_transblock(ended);
      break;
    case Block::primitive:
      finish_primitive(primitive_, scene_);
      break;
    case Block::document:
    case Block::scenefile:
    case Block::globals:
    case Block::instance:
    case Block::leaf:
      break;
  }
  if (top().is_implicit) {
    frames_.pop_back();
  }
}

void SceneBuilder::text(std::string_view characters, Location location) {
  if (text_reported_ || ignored_ != 0) {
    return;
  }
  text_reported_ = true;
  const std::string meant =
      top().block == Block::leaf ? as_attributes(top().element, characters) : std::string();
  context_.diagnostics.report(
      "xml.text"_code, location,
      fmt::format("the text {} has no effect; {}", quoted(characters),
                  !meant.empty() ? "write " + meant
                  : characters.find("/>") != std::string_view::npos
                      ? "is the < of an element missing?"
                      : "values are attributes, comments are written <!-- like this -->"));
}

Scene SceneBuilder::finish(bool complete) {
  const bool in_primitive = std::any_of(frames_.begin(), frames_.end(), [](const Frame& frame) {
    return frame.block == Block::primitive;
  });
  if (in_primitive) {
    scene_.nodes[primitive_.node].primitives.pop_back();
  }
  if (complete && !lost_tree_) {
    references_.resolve(context_, scene_, scenefile_);
  } else {
    references_.forget_unknown(scene_);
  }
  return std::move(scene_);
}

// Returns false to skip the element with its contents.
bool SceneBuilder::open(const XmlTag& tag) {
  switch (top().block) {
    case Block::document:
      return open_document(tag);
    case Block::scenefile:
      return open_top(tag);
    case Block::globals:
      return open_leaf(tag, read_global(context_, tag, globals_, scene_));
    case Block::camera:
      return open_leaf(tag, read_camera_part(context_, tag, camera_, scene_));
    case Block::light:
      return open_leaf(tag, read_light_part(context_, tag, light_, scene_));
    case Block::primitive:
      return open_leaf(tag, read_primitive_part(context_, tag, primitive_, scene_));
    case Block::matrix:
      read_matrix_child(context_, tag, matrix_);
      return open_leaf(tag, true);
    case Block::tree:
      return open_in_tree(tag);
    case Block::transblock:
      return open_in_transblock(tag);
    case Block::instance:
      return ignore("xml.instance-children"_code, tag,
                    fmt::format("{} inside an instance has no effect", element_text(tag.name)));
    case Block::leaf:
      report_unknown_element(context_, tag, top().element);
      return false;
  }
  return false;
}

bool SceneBuilder::open_document(const XmlTag& tag) {
  if (!equal_ignoring_case(tag.name, "scenefile")) {
    constexpr std::string_view scenefile = "scenefile";
    const std::string_view near = nearest_name(tag.name, {&scenefile, 1});
    context_.report("xml.root-element"_code, tag,
                    fmt::format("the file is not a scene: expected <scenefile>, found {}{}",
                                element_text(tag.name), did_you_mean(near, "<>")),
                    correction(tag.name, near));
    if (near.empty()) {
      stopped_ = true;
      return false;
    }
  } else if (tag.name != "scenefile") {
    context_.report("xml.name-case"_code, tag,
                    fmt::format("{} was read as <scenefile>", element_text(tag.name)),
                    correction(tag.name, "scenefile"));
  }
  for (const XmlAttribute& attribute : tag.attributes) {
    if (attribute.name == "xmlns") {
      context_.report("xml.unknown-attribute"_code, attribute,
                      "attribute xmlns of <scenefile> has no effect: the format has no namespace, "
                      "and validators reject one; remove it");
    }
    // Editors use xsi:noNamespaceSchemaLocation to find the schema.
    if (!attribute.name.starts_with("xml") && !attribute.name.starts_with("xsi:")) {
      report_unknown_attribute(context_, tag, attribute, {});
    }
  }
  scenefile_ = tag.location;
  return push(Block::scenefile, 0, tag.name);
}

bool SceneBuilder::open_top(const XmlTag& tag) {
  const std::optional<std::size_t> field = find_field(context_, tag, top_names, top().element);
  if (!field) {
    return false;
  }
  switch (static_cast<TopField>(*field)) {
    case t_globals:
      return open_globals(tag);
    case t_camera:
      expect_no_attributes(context_, tag);
      camera_ = {};
      camera_.camera.location = tag.location;
      return push(Block::camera, 0, tag.name);
    case t_light:
      return open_light(tag);
    case t_object:
      return open_top_object(tag);
  }
  return false;
}

bool SceneBuilder::open_globals(const XmlTag& tag) {
  expect_no_attributes(context_, tag);
  if (scene_.global.location.known()) {
    context_.report("xml.duplicate-element"_code, tag,
                    fmt::format("a second <globaldata>, after line {}; its values count",
                                scene_.global.location.line));
  }
  globals_ = {};
  scene_.global.location = tag.location;
  return push(Block::globals, 0, tag.name);
}

bool SceneBuilder::open_light(const XmlTag& tag) {
  const std::uint32_t limit = context_.options.limits.lights;
  if (scene_.nodes[scene_.root].lights.size() >= limit) {
    stopped_ = true;
    return ignore("xml.light-limit"_code, tag,
                  fmt::format("the scene has more lights than the limit of {}", limit));
  }
  light_ = begin_light(context_, tag);
  return push(Block::light, 0, tag.name);
}

bool SceneBuilder::open_top_object(const XmlTag& tag) {
  const std::optional<ObjectTag> object = read_object_tag(context_, tag);
  if (!object) {
    lost_tree_ = true;
    return false;
  }
  if (object->type != ObjectType::tree) {
    return ignore("xml.misplaced-element"_code, tag,
                  "only trees may be at the top level of the file: this object must be inside a "
                  "transblock of a tree; it was ignored");
  }
  if (object->name.empty()) {
    lost_tree_ = true;
    return ignore("xml.master-name"_code, tag,
                  "a tree at the top of the file needs a name; that of the scene itself is root");
  }
  const bool is_root = object->name == "root";
  const bool is_new = references_.declare(context_, object->name, object->name_place);
  NodeId node = scene_.root;
  if (!is_new || !is_root) {
    // A tree whose name is taken is still read for errors, but is not part of the scene.
    node = is_new ? add_template(scene_, std::string(object->name)) : add_node(tag.location);
  }
  if (is_new && !is_root && scene_.nodes[scene_.root].location.known()) {
    const Location use = references_.early_use(std::string(object->name));
    context_.report(
        "xml.master-after-root"_code, tag,
        fmt::format("the master {} is declared after the root{}", quoted(object->name),
                    use.known() ? fmt::format(", though line {} uses it", use.line) : ""));
  }
  if (is_root) {
    scene_.nodes[node].name = "root";
  }
  scene_.nodes[node].location = tag.location;
  return push(Block::tree, node, tag.name);
}

// An element without children.
bool SceneBuilder::open_leaf(const XmlTag& tag, bool known) {
  return known && push(Block::leaf, 0, tag.name);
}

bool SceneBuilder::ignore(const Code& code, const XmlTag& tag, std::string message) {
  context_.report(code, tag, std::move(message));
  return false;
}

bool SceneBuilder::push(Block block, NodeId node, std::string_view element) {
  Frame& frame = frames_.emplace_back();
  frame.block = block;
  frame.node = node;
  frame.element = element;
  return true;
}

// The contents of a tree: transblocks, their transforms and their objects.

bool SceneBuilder::open_in_tree(const XmlTag& tag) {
  constexpr std::string_view transblock = "transblock";
  if (tag.name == transblock) {
    return open_transblock(tag);
  }
  if (!nearest_name(tag.name, {&transblock, 1}).empty()) {
    context_.report("xml.misspelled-transblock"_code, tag,
                    fmt::format("{} was read as <transblock>", element_text(tag.name)),
                    correction(tag.name, transblock));
    return open_transblock(tag);
  }
  if (tag.name != "object") {
    report_unknown_element(context_, tag, top().element);
    return false;
  }
  context_.report("xml.object-without-transblock"_code, tag,
                  "the object is in a tree without a transblock around it; it was read as if one "
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
    return ignore("xml.after-object"_code, tag,
                  fmt::format("{} is ignored, like everything that follows the first object of a "
                              "transblock; --compat course uses it",
                              element_text(tag.name)));
  }
  if (tag.name == "transblock") {
    return ignore("xml.misplaced-element"_code, tag,
                  "a transblock cannot be directly inside a transblock, so it was ignored; put it "
                  "into <object type=\"tree\">");
  }
  const std::optional<std::size_t> field = find_field(context_, tag, block_names, top().element);
  if (!field) {
    return false;
  }
  if (top().has_content) {
    context_.report("xml.after-object-used"_code, tag,
                    fmt::format("{} follows the first object of a transblock; it was used anyway",
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

// Called inside a transblock.
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
    context_.diagnostics.report("xml.reserved-root"_code, Severity::warning, object.name_place,
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
    return ignore("xml.master-name"_code, tag, "an instance needs the name of a master");
  }
  if (object.name == "root") {
    return ignore("xml.reserved-root"_code, tag,
                  "root cannot be a part of the scene; it is the scene");
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

// Moves all transforms so far to the node, in an array of the exact size.
void SceneBuilder::flush_transforms(NodeId node) {
  std::vector<Transform>& all = scene_.nodes[node].transforms;
  if (all.empty()) {
    all.assign(transforms_.begin(), transforms_.end());
  } else {
    all.insert(all.end(), transforms_.begin(), transforms_.end());
  }
  transforms_.clear();
}

// An instance has no contents: if another object follows, the instance moves into a child.
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
    context_.diagnostics.report("xml.empty-tree"_code, tree.name_place, "the tree is empty");
    return;
  }
  const std::string name = std::exchange(node.name, {});
  references_.use(scene_, tree.node, name, tree.name_place, true);
}

void SceneBuilder::end_transblock(const Frame& block) {
  flush_transforms(block.node);
  if (!block.has_content) {
    context_.diagnostics.report("xml.transblock-without-object"_code,
                                scene_.nodes[block.node].location,
                                "the transblock has no object, so nothing is drawn for it");
  }
}

}  // namespace

Scene read_xml(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics) {
  TextPlaces places(text);
  SceneBuilder builder({options, diagnostics, places});
  return builder.finish(read_events(text, options, places, builder, diagnostics).complete);
}

}  // namespace scenefile
