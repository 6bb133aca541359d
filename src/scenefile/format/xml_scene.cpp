#include "scenefile/format/xml_scene.h"

#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/xml_comments.h"
#include "scenefile/format/xml_plain.h"
#include "scenefile/format/xml_scene_builder.h"
#include "scenefile/format/xml_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace scenefile {

namespace {

enum TopField : std::size_t { t_globals, t_camera, t_light, t_object };
constexpr FieldName top_names[] = {{"globaldata", t_globals},
                                   {"cameradata", t_camera},
                                   {"lightdata", t_light},
                                   {"object", t_object}};

}  // namespace

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
      xml_text, location,
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

// False: the element is left out with everything in it.
bool SceneBuilder::open(const XmlTag& tag) {
  switch (top().block) {
    case Block::document:
      return open_document(tag);
    case Block::scenefile:
      return open_top(tag);
    case Block::globals:
      return open_leaf(tag, read_global(context_, tag, globals_, scene_));
    case Block::camera:
      return open_leaf(tag, read_camera_part(context_, tag, camera_));
    case Block::light:
      return open_leaf(tag, read_light_part(context_, tag, light_));
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
      return ignore(xml_instance_children, tag,
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
    context_.report(xml_root_element, tag,
                    fmt::format("the file is no scene: expected <scenefile>, found {}{}",
                                element_text(tag.name), did_you_mean(near, "<>")));
    if (near.empty()) {
      stopped_ = true;
      return false;
    }
  } else if (tag.name != "scenefile") {
    context_.report(xml_name_case, tag,
                    fmt::format("{} was read as <scenefile>", element_text(tag.name)));
  }
  for (const XmlAttribute& attribute : tag.attributes) {
    if (attribute.name == "xmlns") {
      context_.report(xml_unknown_attribute, attribute,
                      "attribute xmlns of <scenefile> has no effect: the format has no namespace, "
                      "and validators refuse one; remove it");
    }
    // xsi:noNamespaceSchemaLocation is how editors are told of the schema.
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
    context_.report(xml_duplicate_element, tag,
                    fmt::format("a second <globaldata>, after line {}; what it gives counts",
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
    return ignore(xml_light_limit, tag,
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
    return ignore(xml_misplaced_element, tag,
                  "only trees may stand at the top of the file: this object must be inside a "
                  "transblock of a tree; it was ignored");
  }
  if (object->name.empty()) {
    lost_tree_ = true;
    return ignore(xml_master_name, tag,
                  "a tree at the top of the file needs a name; that of the scene itself is root");
  }
  const bool is_root = object->name == "root";
  const bool is_new = references_.declare(context_, object->name, object->name_place);
  NodeId node = scene_.root;
  if (!is_new || !is_root) {
    // A tree of a name that is taken is read, for what is wrong in it, and belongs nowhere.
    node = is_new ? add_template(scene_, std::string(object->name)) : add_node(tag.location);
  }
  if (is_new && !is_root && scene_.nodes[scene_.root].location.known()) {
    const Location use = references_.early_use(std::string(object->name));
    context_.report(
        xml_master_after_root, tag,
        fmt::format("the master {} is declared after the root{}", quoted(object->name),
                    use.known() ? fmt::format(", though line {} uses it", use.line) : ""));
  }
  if (is_root) {
    scene_.nodes[node].name = "root";
  }
  scene_.nodes[node].location = tag.location;
  return push(Block::tree, node, tag.name);
}

// An element without children of its own.
bool SceneBuilder::open_leaf(const XmlTag& tag, bool known) {
  return known && push(Block::leaf, 0, tag.name);
}

bool SceneBuilder::ignore(const Code& code, const XmlTag& tag, std::string message) {
  context_.report(code, tag, std::move(message));
  return false;
}

bool SceneBuilder::push(Block block, NodeId node, std::string_view element) {
  Frame frame;
  frame.block = block;
  frame.node = node;
  frame.element = element;
  frames_.push_back(frame);
  return true;
}

namespace {

// Nothing, and nothing reported, when the text is not plain.
std::optional<Scene> read_plain(std::string_view text, const ReadOptions& options,
                                Diagnostics& diagnostics) {
  Diagnostics findings = diagnostics;
  TextCursor places(text);
  SceneBuilder builder({options, findings, places});
  const PlainEnd end = read_plain_events(text, options.limits, places, builder);
  if (end == PlainEnd::not_plain) {
    return std::nullopt;
  }
  Scene scene = builder.finish(end == PlainEnd::complete);
  diagnostics = std::move(findings);
  return scene;
}

}  // namespace

Scene read_xml(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics) {
  if (std::optional<Scene> scene = read_plain(text, options, diagnostics)) {
    return std::move(*scene);
  }
  const std::optional<std::string> mended = mend_comments(text, options, diagnostics);
  text = mended ? std::string_view(*mended) : text;
  TextCursor places(text);
  SceneBuilder builder({options, diagnostics, places});
  const bool complete = read_events(text, options.limits, places, builder, diagnostics);
  return builder.finish(complete);
}

}  // namespace scenefile
