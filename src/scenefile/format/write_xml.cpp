#include "scenefile/base/affine.h"
#include "scenefile/base/number.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/write_forms.h"
#include "scenefile/format/write_text.h"
#include "scenefile/format/write_values.h"
#include "scenefile/format/xml_values.h"
#include "scenefile/scene/vocabulary.h"
#include "scenefile/scene/walk.h"
#include "scenefile/scene/world_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// A direction that gives exactly `wanted` when it is normalized again; for `wanted` itself, the
// result may differ by rounding.
glm::vec3 stable_direction(const Light& light, const RenderLight& wanted) {
  Light trial = light;
  const auto comes_out = [&](const glm::vec3& direction) {
    trial.direction = direction;
    const std::optional<RenderLight> ready = ready_light(trial, DAffine());
    return ready && ready->direction == wanted.direction;
  };
  if (comes_out(light.direction)) {
    return light.direction;
  }
  // Nearly always one of the first few lengths works.
  constexpr int lengths = 4096;
  for (int i = 0; i < lengths; ++i) {
    const glm::vec3 longer = wanted.direction * (1.0f + static_cast<float>(i) / lengths);
    if (comes_out(longer)) {
      return longer;
    }
  }
  return wanted.direction;
}

bool is_finite(const RenderLight& light) {
  const glm::vec3 sum = glm::abs(light.position) + glm::abs(light.half_u) + glm::abs(light.half_v);
  return std::isfinite(2 * (sum.x + sum.y + sum.z));
}

// Every light of a scene in world space, once for each instance of its template, in the order of
// prepare(). Lights of the root without transforms are unchanged.
class WorldCopies {
 public:
  WorldCopies(const Scene& scene, const Limits& limits, Diagnostics& diagnostics)
      : scene_(scene), limits_(limits), diagnostics_(diagnostics) {}

  std::vector<Light> make() {
    world_lights(scene_, [this](const WorldLight& at) { return add(at); });
    if (moved_ != 0) {
      diagnostics_.report("write.light-moved"_code, first_moved_,
                          fmt::format("{} light{} moved from groups to the top of the file", moved_,
                                      moved_ == 1 ? " is" : "s are"));
    }
    return std::move(lights_);
  }

 private:
  // Returns false if the limit is reached.
  bool add(const WorldLight& at) {
    const Light& light = scene_.nodes[at.node].lights[at.index];
    if (lights_.size() == limits_.lights) {
      diagnostics_.report(
          "write.light-limit"_code, light.location,
          fmt::format("the scene has more lights than the limit of {}", limits_.lights));
      return false;
    }
    const bool at_root = at.node == scene_.root;
    if (at_root && at.world_from_node == DAffine()) {
      lights_.push_back(light);
      return true;
    }
    const std::optional<RenderLight> ready = ready_light(light, at.world_from_node);
    if (!ready || !is_finite(*ready)) {
      diagnostics_.report(
          "write.light-dark"_code, light.location,
          fmt::format("the {} light lights nothing and is left out", word_of(light.type)));
      return true;
    }
    lights_.push_back(placed(light, *ready));
    if (!at_root) {
      first_moved_ = moved_ == 0 ? light.location : first_moved_;
      ++moved_;
    }
    return true;
  }

  Light placed(const Light& light, const RenderLight& ready) {
    Light result = light;
    if (light_uses(light.type, Field::position)) {
      result.position = ready.position;
    }
    if (light_uses(light.type, Field::direction)) {
      result.direction = stable_direction(light, ready);
    }
    if (has_rectangle(light.type)) {
      place_rectangle(result, light, ready);
    }
    return result;
  }

  void place_rectangle(Light& result, const Light& light, const RenderLight& wanted) {
    const auto same_sides = [&] {
      const std::optional<RenderLight> ready = ready_light(result, DAffine());
      return ready && alike(wanted, *ready);
    };
    if (same_sides()) {
      return;
    }
    result.width = static_cast<float>(2 * glm::length(glm::dvec3(wanted.half_u)));
    result.height = static_cast<float>(2 * glm::length(glm::dvec3(wanted.half_v)));
    if (!same_sides()) {
      diagnostics_.report(
          "write.light-turned"_code, light.location,
          "the area light is rotated or sheared by its group in a way that XML cannot express");
    }
  }

  const Scene& scene_;
  const Limits& limits_;
  Diagnostics& diagnostics_;
  std::vector<Light> lights_;
  std::size_t moved_ = 0;
  Location first_moved_;
};

class XmlForm {
 public:
  XmlForm(const Scene& scene, const Limits& limits, Diagnostics& diagnostics)
      : scene_(tidy_copy(scene)), diagnostics_(diagnostics) {
    move_lights(limits);
  }

  Scene make() {
    if (!scene_.name.empty() && scene_.name != "root") {
      diagnostics_.report(
          "write.scene-name"_code, {},
          fmt::format("the name of the scene, {}, is left out", quoted(scene_.name)));
    }
    scene_.name.clear();
    const std::size_t written = scene_.nodes.size();
    is_head_.assign(written, false);
    for (const NodeId head : tree_heads(scene_)) {
      is_head_[head] = true;
    }
    for (NodeId node = 0; node < written; ++node) {
      is_head_[node] ? shape_head(node) : shape_node(node);
      make_affine(node);
    }
    drop_empty_groups(scene_, held_lights_, diagnostics_);
    make_names_unique(written);
    return std::move(scene_);
  }

 private:
  void move_lights(const Limits& limits) {
    std::vector<Light> lights = WorldCopies(scene_, limits, diagnostics_).make();
    for (Node& node : scene_.nodes) {
      held_lights_.push_back(!node.lights.empty());
      node.lights.clear();
    }
    add_ids(lights);
    for (Light& light : lights) {
      clear_unused(light, true);
      if (!light.name.empty()) {
        diagnostics_.report(
            "write.light-name"_code, light.location,
            fmt::format("the name {} of the light is left out", quoted(light.name)));
        light.name.clear();
      }
    }
    scene_.nodes[scene_.root].lights = std::move(lights);
  }

  void add_ids(std::vector<Light>& lights) {
    std::set<int> taken;
    std::size_t without = 0;
    for (const Light& light : lights) {
      light.id ? (void)taken.insert(*light.id) : (void)++without;
    }
    int next = 0;
    for (Light& light : lights) {
      while (!light.id && taken.contains(next)) {
        ++next;
      }
      light.id = light.id.value_or(next);
      taken.insert(*light.id);
    }
    if (without != 0) {
      diagnostics_.report("write.light-id"_code, {}, counted(without, "light") + " got an id");
    }
  }

  // The root and templates are trees without a transblock around them.
  void shape_head(NodeId id) {
    if (!scene_.nodes[id].transforms.empty() || !scene_.nodes[id].instance_of.empty()) {
      std::vector<Light> lights = std::exchange(scene_.nodes[id].lights, {});
      const NodeId inner = push_down(scene_, id, true);
      scene_.nodes[id].lights = std::move(lights);
      shape_node(inner);
      make_affine(inner);
      return;
    }
    give_primitives_nodes(id);
  }

  // A transblock has one object: a primitive, an instance or a tree. Only trees have names.
  void shape_node(NodeId id) {
    const Node& node = scene_.nodes[id];
    if (!node.instance_of.empty()) {
      if (!node.name.empty()) {
        push_down(scene_, id, false);
      }
      return;
    }
    const bool alone = node.name.empty() && node.children.empty() && node.primitives.size() == 1;
    if (!alone) {
      give_primitives_nodes(id);
    }
  }

  void give_primitives_nodes(NodeId id) {
    std::vector<Primitive> primitives = std::exchange(scene_.nodes[id].primitives, {});
    const NodeId first = add_front_children(scene_, id, primitives.size());
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      Node& child = scene_.nodes[first + i];
      child.location = primitives[i].location;
      child.primitives.push_back(std::move(primitives[i]));
    }
  }

  void make_affine(NodeId id) {
    for (Transform& transform : scene_.nodes[id].transforms) {
      const auto* const matrix = std::get_if<Matrix>(&transform.map);
      if (matrix == nullptr) {
        continue;
      }
      glm::mat4 affine = matrix->m();
      for (int column = 0; column < 4; ++column) {
        affine[column][3] = column == 3 ? 1.0f : 0.0f;
      }
      if (affine != matrix->m()) {
        transform.map = Matrix(affine);
        diagnostics_.report("write.matrix-row"_code, transform.location,
                            "the last row of the matrix is written as 0 0 0 1");
      }
    }
  }

  void make_names_unique(std::size_t written) {
    NameTable names;
    names.take("root");
    scene_.nodes[scene_.root].name = "root";
    for (const NodeId head : scene_.templates) {
      names.take(scene_.nodes[head].name);
    }
    free_the_root(names);
    for (NodeId id = 0; id < written; ++id) {
      RareText& name = scene_.nodes[id].name;
      if (is_head_[id] || name.empty() || scene_.nodes[id].children.empty() || names.take(name)) {
        continue;
      }
      std::string free = names.make_free(name);
      diagnostics_.report(
          "write.renamed"_code, scene_.nodes[id].location,
          fmt::format("the name {} is taken; the group is called {}", quoted(name), quoted(free)));
      name = std::move(free);
    }
  }

  // JSON has no reserved names: a template can be called root there.
  void free_the_root(NameTable& names) {
    const auto root =
        std::find_if(scene_.templates.begin(), scene_.templates.end(),
                     [this](NodeId head) { return scene_.nodes[head].name == "root"; });
    if (root == scene_.templates.end()) {
      return;
    }
    const std::string free = names.make_free("root");
    diagnostics_.report(
        "write.renamed"_code, scene_.nodes[*root].location,
        fmt::format("root is the scene itself in XML; the template is called {}", quoted(free)));
    scene_.nodes[*root].name = free;
    for (Node& node : scene_.nodes) {
      if (node.instance_of == "root") {
        node.instance_of = free;
      }
    }
  }

  Scene scene_;
  Diagnostics& diagnostics_;
  std::vector<bool> is_head_;  // of the nodes of the tidy copy
  std::vector<bool> held_lights_;
};

// Prints elements and attributes, one element per line.
class XmlPrinter {
 public:
  XmlPrinter(const Limits& limits, Diagnostics& diagnostics, std::vector<ListedLine>* listing)
      : limits_(limits), diagnostics_(diagnostics), starts_(listing) {}

  LineStarts& starts() { return starts_; }

  /// Starts a tag; attributes may follow, then children() or leaf().
  XmlPrinter& begin(std::string_view element) {
    starts_.start(out_, open_.size());
    out_ += '<';
    out_ += element;
    deepest_ = std::max(deepest_, open_.size() + 1);
    begun_ = element;
    return *this;
  }
  XmlPrinter& attribute(std::string_view name, std::string_view value, Location place) {
    out_ += fmt::format(" {}=\"", name);
    if (!append_xml(out_, value)) {
      diagnostics_.report(
          "write.character"_code, place,
          fmt::format("{} contains a character that XML cannot represent", quoted(value)));
    }
    out_ += '"';
    return *this;
  }
  XmlPrinter& attribute(std::string_view name, float value) {
    out_ += fmt::format(" {}=\"{}\"", name, starts_.number(value));
    return *this;
  }
  void leaf() { out_ += "/>\n"; }
  void children() {
    out_ += ">\n";
    open_.push_back(begun_);
  }
  void end() {
    const std::string_view element = open_.back();
    open_.pop_back();
    starts_.start(out_, open_.size());
    out_ += fmt::format("</{}>\n", element);
  }

  template <typename Owner>
  static std::string_view name_of(const ValueRow<Owner>& row) {
    return row.xml;
  }
  /// Whether it is written for lights that do not use it.
  bool is_idle(const ValueRow<Light>& row) const { return row.idle_in_xml && !starts_.listing(); }

  void value(std::string_view element, float v) { begin(element).attribute("v", v).leaf(); }
  void text(std::string_view element, std::string_view text, Location place) {
    begin(element).attribute("v", text, place).leaf();
  }
  void id(std::string_view element, int id, Location place) {
    if (!starts_.listing()) {
      text(element, fmt::format("{}", id), place);
    }
  }
  void three(std::string_view element, ValueKind kind, const glm::vec3& v) {
    const std::span<const std::string_view> names = part_names(kind);
    begin(element);
    for (int i = 0; i < 3; ++i) {
      attribute(names[static_cast<std::size_t>(i)], v[i]);
    }
    leaf();
  }
  template <typename Owner>
  void image(const ValueRow<Owner>& row, const TextureUse& use) {
    begin(row.xml).attribute("file", use.file, use.location);
    attribute("u", use.repeat_u).attribute("v", use.repeat_v).leaf();
  }

  /// Whether the output exceeds the nesting limit of the readers; the caller should then stop.
  bool too_deep() const { return deepest_ > limits_.nesting; }
  std::string take() { return std::move(out_); }

 private:
  const Limits& limits_;
  Diagnostics& diagnostics_;
  LineStarts starts_;
  std::string out_;
  std::vector<std::string_view> open_;
  std::string_view begun_;
  std::size_t deepest_ = 0;
};

void print_camera(XmlPrinter& to, const Camera& camera) {
  to.starts().at("camera", camera.location);
  to.begin("cameradata").children();
  print_values(to, camera, {Field::position, Field::look, Field::up, Field::height_angle_deg});
  to.end();
}

template <typename Owner>
void print_block(XmlPrinter& to, std::string_view element, const Owner& owner) {
  to.begin(element).children();
  print_values(to, owner);
  to.end();
}

void print_map(XmlPrinter& to, const Translate& translate) {
  to.three(transform_word<Translate>, ValueKind::vector, translate.by);
}

void print_map(XmlPrinter& to, const Scale& scale) {
  to.three(transform_word<Scale>, ValueKind::vector, scale.by);
}

void print_map(XmlPrinter& to, const Rotate& rotate) {
  to.begin(transform_word<Rotate>).attribute("x", rotate.axis.x).attribute("y", rotate.axis.y);
  to.attribute("z", rotate.axis.z).attribute("angle", rotate.angle_deg).leaf();
}

void print_map(XmlPrinter& to, const Matrix& matrix) {
  to.begin(transform_word<Matrix>).children();
  for (int row = 0; row < 4; ++row) {
    to.begin("row").attribute("a", matrix.m()[0][row]).attribute("b", matrix.m()[1][row]);
    to.attribute("c", matrix.m()[2][row]).attribute("d", matrix.m()[3][row]).leaf();
  }
  to.end();
}

void print_primitive(XmlPrinter& to, const Primitive& primitive, NodeId node) {
  to.starts().at(word_of(primitive.shape), primitive.location, node);
  to.begin("object").attribute("type", "primitive", primitive.location);
  to.attribute("name", word_of(primitive.shape), primitive.location);
  if (primitive.shape == Shape::mesh) {
    to.attribute("filename", primitive.mesh_file, primitive.location);
  }
  if (primitive.material == Material()) {
    to.leaf();
    return;
  }
  to.children();
  print_values(to, primitive.material);
  to.end();
}

// Prints trees of nodes without recursion.
class TreePrinter {
 public:
  TreePrinter(XmlPrinter& to, const Scene& scene) : to_(to), scene_(scene) {}

  void print(NodeId head) {
    open_tree(head);
    while (!frames_.empty() && !to_.too_deep()) {
      Frame& top = frames_.back();
      const Node& node = scene_.nodes[top.node];
      if (top.next == node.children.size()) {
        frames_.pop_back();
        to_.end();
        if (!frames_.empty()) {
          to_.end();
        }
      } else {
        print_child(node.children[top.next++]);
      }
    }
  }

 private:
  struct Frame {
    NodeId node;
    std::size_t next;
  };

  void open_tree(NodeId id) {
    const Node& node = scene_.nodes[id];
    to_.starts().at({}, node.location, id);
    to_.begin("object").attribute("type", "tree", node.location);
    if (!node.name.empty()) {
      to_.attribute("name", node.name, node.location);
    }
    if (node.children.empty()) {
      to_.leaf();
      return;
    }
    to_.children();
    frames_.push_back({id, 0});
  }

  void print_child(NodeId id) {
    const Node& node = scene_.nodes[id];
    const std::string_view what =
        node.primitives.empty() ? std::string_view() : word_of(node.primitives.front().shape);
    to_.starts().at(what, node.location, id);
    to_.begin("transblock").children();
    for (const Transform& transform : node.transforms) {
      to_.starts().at(what, transform.location, id);
      std::visit([&](const auto& map) { print_map(to_, map); }, transform.map);
    }
    to_.starts().at({}, node.location, id);
    if (!node.instance_of.empty()) {
      to_.begin("object").attribute("type", "master", node.location);
      to_.attribute("name", node.instance_of, node.location).leaf();
    } else if (!node.primitives.empty()) {
      print_primitive(to_, node.primitives.front(), id);
    } else {
      open_tree(id);
      return;
    }
    to_.end();
  }

  XmlPrinter& to_;
  const Scene& scene_;
  std::vector<Frame> frames_;
};

std::string print_xml(const Scene& scene, const Limits& limits, Diagnostics& diagnostics,
                      std::vector<ListedLine>* listing = nullptr) {
  XmlPrinter to(limits, diagnostics, listing);
  to.begin("scenefile").children();
  to.starts().at("global data", scene.global.location);
  print_block(to, "globaldata", scene.global);
  if (scene.camera) {
    print_camera(to, *scene.camera);
  }
  for (const Light& light : scene.nodes[scene.root].lights) {
    to.starts().at(light_type_name(light.type), light.location);
    print_block(to, "lightdata", light);
  }
  for (const NodeId head : scene.templates) {
    TreePrinter(to, scene).print(head);
  }
  TreePrinter(to, scene).print(scene.root);
  to.end();
  if (to.too_deep()) {
    report_nesting(limits, diagnostics);
    return {};
  }
  return to.take();
}

}  // namespace

Scene xml_form(const Scene& scene, const Limits& limits, Diagnostics& diagnostics) {
  return XmlForm(scene, limits, diagnostics).make();
}

std::string write_xml(const Scene& scene, const Limits& limits, Diagnostics& diagnostics) {
  return print_xml(xml_form(scene, limits, diagnostics), limits, diagnostics);
}

SceneListing list_xml(const Scene& scene) {
  const Limits limits = listing_limits();
  Diagnostics diagnostics(limits);
  SceneListing listing{xml_form(scene, limits, diagnostics), {}, {}};
  listing.text = print_xml(listing.form, limits, diagnostics, &listing.lines);
  listing.exact = diagnostics.count(Severity::warning) + diagnostics.count(Severity::error) == 0;
  return listing;
}

}  // namespace scenefile
