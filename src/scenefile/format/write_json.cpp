#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/write_forms.h"
#include "scenefile/format/write_text.h"
#include "scenefile/format/write_values.h"
#include "scenefile/scene/vocabulary.h"
#include "scenefile/scene/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

bool stands_at_origin(const Light& light) {
  return light.position == glm::vec3(0);
}

// Takes the leading transforms that a single group can represent: each kind once, in the fixed
// order. A matrix needs a separate group, because some programs reject it next to other transforms.
std::span<const Transform> take_sayable(std::span<const Transform>& transforms) {
  std::size_t count = 0;
  while (count < transforms.size() &&
         (count == 0 || (transforms[count - 1].map.index() < transforms[count].map.index() &&
                         !std::holds_alternative<Matrix>(transforms[count].map)))) {
    ++count;
  }
  const std::span<const Transform> sayable = transforms.first(count);
  transforms = transforms.subspan(count);
  return sayable;
}

class JsonForm {
 public:
  JsonForm(const Scene& scene, Diagnostics& diagnostics)
      : scene_(tidy_copy(scene)), diagnostics_(diagnostics) {}

  Scene make() {
    if (!scene_.camera) {
      diagnostics_.report("write.default-camera"_code, {},
                          "the scene has no camera; the default is written");
      scene_.camera.emplace();
    }
    shape_lights();
    shape_root();
    is_head_.assign(scene_.nodes.size(), false);
    for (const NodeId head : tree_heads(scene_)) {
      is_head_[head] = true;
    }
    const std::size_t written = scene_.nodes.size();
    for (NodeId id = 0; id < written; ++id) {
      shape_instance(id);
      split_transforms(id);
    }
    if (splits_ != 0) {
      diagnostics_.report(
          "write.transforms-nested"_code, {},
          fmt::format("the transforms of {} have an order that needs nested groups in JSON",
                      counted(splits_, "group")));
    }
    drop_empty_groups(scene_, {}, diagnostics_);
    keep_templates_names();
    return std::move(scene_);
  }

 private:
  void shape_lights() {
    std::size_t ids = 0;
    const std::size_t written = scene_.nodes.size();
    for (NodeId id = 0; id < written; ++id) {
      for (Light& light : scene_.nodes[id].lights) {
        ids += light.id ? 1 : 0;
        light.id.reset();
        clear_unused(light, false);
        if (!course_json_has(light.type)) {
          diagnostics_.report("write.area-light"_code, light.location,
                              "the course's JSON reader does not support area lights");
        }
      }
      const bool is_root = id == scene_.root;
      const auto& lights = scene_.nodes[id].lights;
      if (!std::all_of(lights.begin(), lights.end(), stands_at_origin) ||
          (is_root && !lights.empty())) {
        give_lights_groups(id);
      }
    }
    if (ids != 0) {
      diagnostics_.report("write.light-id"_code, {},
                          fmt::format("the id{} of {} light{} {} left out", ids == 1 ? "" : "s",
                                      ids, ids == 1 ? "" : "s", ids == 1 ? "is" : "are"));
    }
  }

  // Consecutive lights at the same position share a group, to keep their order.
  void give_lights_groups(NodeId id) {
    std::vector<std::vector<Light>> runs;
    for (Light& light : std::exchange(scene_.nodes[id].lights, {})) {
      if (runs.empty() || runs.back().back().position != light.position) {
        runs.emplace_back();
      }
      runs.back().push_back(std::move(light));
    }
    const NodeId first = add_front_children(scene_, id, runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      Node& group = scene_.nodes[first + i];
      const Light& light = runs[i].front();
      group.location = light.location;
      if (light.position != glm::vec3(0)) {
        group.transforms.push_back({Translate{light.position}, light.location});
      }
      group.lights = std::move(runs[i]);
      for (Light& inside : group.lights) {
        inside.position = glm::vec3(0);
      }
    }
  }

  // The root contains only groups.
  void shape_root() {
    Node& root = scene_.nodes[scene_.root];
    root.name.clear();
    if (!root.transforms.empty() || !root.primitives.empty() || !root.instance_of.empty()) {
      push_down(scene_, scene_.root, true);
    }
  }

  // Moves an instance into a child if it has transforms or a name, or is the head of a template.
  void shape_instance(NodeId id) {
    const Node& node = scene_.nodes[id];
    if (!node.instance_of.empty() &&
        (!node.transforms.empty() || !node.name.empty() || is_head_[id])) {
      push_down(scene_, id, false);
    }
  }

  // Nests groups until each has transforms that it can represent.
  void split_transforms(NodeId id) {
    const std::vector<Transform> all = std::exchange(scene_.nodes[id].transforms, {});
    std::span<const Transform> rest = all;
    while (true) {
      const std::span<const Transform> sayable = take_sayable(rest);
      scene_.nodes[id].transforms.assign(sayable.begin(), sayable.end());
      if (rest.empty()) {
        break;
      }
      id = push_down(scene_, id, false);
    }
    splits_ += scene_.nodes[id].transforms.size() == all.size() ? 0 : 1;
  }

  // A group with the name of a template would be read as an instance of it.
  void keep_templates_names() {
    NameTable names;
    for (const NodeId head : scene_.templates) {
      names.take(scene_.nodes[head].name);
    }
    NameTable templates = names;
    for (NodeId id = 0; id < scene_.nodes.size(); ++id) {
      names.take(scene_.nodes[id].name);
    }
    for (NodeId id = 0; id < scene_.nodes.size(); ++id) {
      Node& node = scene_.nodes[id];
      const bool head = id < is_head_.size() && is_head_[id];
      if (head || node.name.empty() || !templates.is_taken(node.name)) {
        continue;
      }
      std::string free = names.make_free(node.name);
      diagnostics_.report("write.renamed"_code, node.location,
                          fmt::format("the group {} has the name of a template; it is called {}",
                                      quoted(node.name), quoted(free)));
      node.name = std::move(free);
    }
  }

  Scene scene_;
  Diagnostics& diagnostics_;
  std::vector<bool> is_head_;
  std::size_t splits_ = 0;
};

// Prints members and elements, one per line; vectors are on one line. An empty key adds an element
// to an array.
class JsonPrinter {
 public:
  JsonPrinter(const Limits& limits, Diagnostics& diagnostics, std::vector<ListedLine>* listing)
      : limits_(limits), diagnostics_(diagnostics), starts_(listing) {
    starts_.start(out_, 0);
  }

  LineStarts& starts() { return starts_; }

  void open(std::string_view key, char bracket) {
    begin(key);
    out_ += bracket;
    open_.push_back({bracket, true});
    deepest_ = std::max(deepest_, open_.size());
  }
  void close() {
    const Level level = open_.back();
    open_.pop_back();
    if (!level.empty) {
      new_line();
    }
    out_ += level.bracket == '{' ? '}' : ']';
  }

  void value(std::string_view key, float v) {
    begin(key);
    out_ += starts_.number(v);
  }
  void numbers(std::string_view key, std::initializer_list<float> values) {
    begin(key);
    char separator = '[';
    for (const float value : values) {
      out_ += separator;
      out_ += separator == ',' ? " " : "";
      out_ += starts_.number(value);
      separator = ',';
    }
    out_ += ']';
    deepest_ = std::max(deepest_, open_.size() + 1);
  }
  void three(std::string_view key, ValueKind, const glm::vec3& v) { numbers(key, {v.x, v.y, v.z}); }
  void text(std::string_view key, std::string_view value, Location place) {
    begin(key);
    if (!append_json(out_, value)) {
      diagnostics_.report("write.character"_code, place,
                          fmt::format("{} contains bytes that are not UTF-8", quoted(value)));
    }
  }
  template <typename Owner>
  void image(const ValueRow<Owner>& row, const TextureUse& use) {
    text(row.json, use.file, use.location);
    value(row.json_repeat[0].key, use.repeat_u);
    value(row.json_repeat[1].key, use.repeat_v);
  }
  void id(std::string_view, int, Location) {}  // JSON has no ids

  template <typename Owner>
  static std::string_view name_of(const ValueRow<Owner>& row) {
    return row.json;
  }
  static bool is_idle(const ValueRow<Light>&) { return false; }

  /// Whether the output exceeds the nesting limit of the readers; the caller should then stop.
  bool too_deep() const { return deepest_ > limits_.nesting; }
  std::string take() { return std::move(out_); }

 private:
  struct Level {
    char bracket;
    bool empty;
  };

  void new_line() {
    out_ += '\n';
    starts_.start(out_, open_.size());
  }

  void begin(std::string_view key) {
    if (open_.empty()) {
      return;
    }
    out_ += open_.back().empty ? "" : ",";
    open_.back().empty = false;
    new_line();
    if (!key.empty()) {
      out_ += fmt::format("\"{}\": ", key);
    }
  }

  const Limits& limits_;
  Diagnostics& diagnostics_;
  LineStarts starts_;
  std::string out_;
  std::vector<Level> open_;
  std::size_t deepest_ = 0;
};

void print_camera(JsonPrinter& to, const Camera& camera) {
  to.starts().at("camera", camera.location);
  to.open("cameraData", '{');
  print_values(to, camera, {Field::position, Field::up, Field::look, Field::height_angle_deg});
  to.close();
}

template <typename Owner>
void print_object(JsonPrinter& to, std::string_view key, const Owner& owner) {
  to.open(key, '{');
  print_values(to, owner);
  to.close();
}

void print_map(JsonPrinter& to, const Translate& translate) {
  to.three(transform_word<Translate>, ValueKind::vector, translate.by);
}

void print_map(JsonPrinter& to, const Scale& scale) {
  to.three(transform_word<Scale>, ValueKind::vector, scale.by);
}

void print_map(JsonPrinter& to, const Rotate& rotate) {
  to.numbers(transform_word<Rotate>,
             {rotate.axis.x, rotate.axis.y, rotate.axis.z, rotate.angle_deg});
}

void print_map(JsonPrinter& to, const Matrix& matrix) {
  const glm::mat4 rows = glm::transpose(matrix.m());
  to.open(transform_word<Matrix>, '[');
  for (int row = 0; row < 4; ++row) {
    to.numbers("", {rows[row][0], rows[row][1], rows[row][2], rows[row][3]});
  }
  to.close();
}

void print_primitive(JsonPrinter& to, const Primitive& primitive, NodeId node) {
  to.starts().at(word_of(primitive.shape), primitive.location, node);
  to.open("", '{');
  to.text("type", word_of(primitive.shape), primitive.location);
  if (primitive.shape == Shape::mesh) {
    to.text("meshFile", primitive.mesh_file, primitive.location);
  }
  print_values(to, primitive.material);
  to.close();
}

// Prints nested groups without recursion.
class GroupPrinter {
 public:
  GroupPrinter(JsonPrinter& to, const Scene& scene) : to_(to), scene_(scene) {}

  /// The root is not a group, but its groups are a list.
  void print_root() {
    to_.open("groups", '[');
    frames_.push_back({scene_.root, 0});
    run();
  }
  void print_template(NodeId head) {
    if (open_group(head)) {
      run();
    }
  }

 private:
  struct Frame {
    NodeId node;
    std::size_t next;
  };

  void run() {
    while (!frames_.empty() && !to_.too_deep()) {
      Frame& top = frames_.back();
      const Node& node = scene_.nodes[top.node];
      if (top.next < node.children.size()) {
        open_group(node.children[top.next++]);
        continue;
      }
      to_.close();
      if (top.node != scene_.root) {
        to_.close();
      }
      frames_.pop_back();
    }
  }

  // Prints the group up to its list of groups, which stays open. Returns false if it has none.
  bool open_group(NodeId id) {
    const Node& node = scene_.nodes[id];
    to_.starts().at({}, node.location, id);
    to_.open("", '{');
    if (!node.instance_of.empty()) {
      to_.text("name", node.instance_of, node.location);
      to_.close();
      return false;
    }
    if (!node.name.empty()) {
      to_.text("name", node.name, node.location);
    }
    for (const Transform& transform : node.transforms) {
      to_.starts().at({}, transform.location, id);
      std::visit([&](const auto& map) { print_map(to_, map); }, transform.map);
    }
    to_.starts().at({}, node.location, id);
    print_lights(node, id);
    // A group with only a name would be read as an instance.
    if (!node.primitives.empty() || (node.children.empty() && node.lights.empty())) {
      print_primitives(node, id);
    }
    if (node.children.empty()) {
      to_.close();
      return false;
    }
    to_.open("groups", '[');
    frames_.push_back({id, 0});
    return true;
  }

  void print_lights(const Node& node, NodeId id) {
    if (node.lights.empty()) {
      return;
    }
    to_.open("lights", '[');
    for (const Light& light : node.lights) {
      to_.starts().at(light_type_name(light.type), light.location, id);
      print_object(to_, "", light);
    }
    to_.close();
  }

  void print_primitives(const Node& node, NodeId id) {
    to_.open("primitives", '[');
    for (const Primitive& primitive : node.primitives) {
      print_primitive(to_, primitive, id);
    }
    to_.close();
  }

  JsonPrinter& to_;
  const Scene& scene_;
  std::vector<Frame> frames_;
};

std::string print_json(const Scene& scene, const Limits& limits, Diagnostics& diagnostics,
                       std::vector<ListedLine>* listing = nullptr) {
  JsonPrinter to(limits, diagnostics, listing);
  to.open("", '{');
  if (!scene.name.empty()) {
    to.text("name", scene.name, {});
  }
  to.starts().at("global data", scene.global.location);
  print_object(to, "globalData", scene.global);
  print_camera(to, scene.camera.value_or(Camera()));
  if (!scene.templates.empty()) {
    to.open("templateGroups", '[');
    for (const NodeId head : scene.templates) {
      GroupPrinter(to, scene).print_template(head);
    }
    to.close();
  }
  GroupPrinter(to, scene).print_root();
  to.close();
  if (to.too_deep()) {
    report_nesting(limits, diagnostics);
    return {};
  }
  return to.take() + "\n";
}

}  // namespace

Scene json_form(const Scene& scene, Diagnostics& diagnostics) {
  return JsonForm(scene, diagnostics).make();
}

std::string write_json(const Scene& scene, const Limits& limits, Diagnostics& diagnostics) {
  return print_json(json_form(scene, diagnostics), limits, diagnostics);
}

SceneListing list_json(const Scene& scene) {
  const Limits limits = listing_limits();
  Diagnostics ignored(limits);
  SceneListing listing{json_form(scene, ignored), {}, {}};
  listing.text = print_json(listing.form, limits, ignored, &listing.lines);
  return listing;
}

}  // namespace scenefile
