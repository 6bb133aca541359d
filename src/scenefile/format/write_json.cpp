#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/write_text.h"
#include "scenefile/format/write_values.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// Prints members and elements, one per line; vectors are on one line. An empty key adds an element
// to an array.
class JsonPrinter {
 public:
  JsonPrinter(const Limits& limits, Diagnostics& diagnostics)
      : limits_(limits), diagnostics_(diagnostics) {}

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
    out_ += number_text(v);
  }
  void numbers(std::string_view key, std::initializer_list<float> values) {
    begin(key);
    char separator = '[';
    for (const float value : values) {
      out_ += separator;
      out_ += separator == ',' ? " " : "";
      out_ += number_text(value);
      separator = ',';
    }
    out_ += ']';
    deepest_ = std::max(deepest_, open_.size() + 1);
  }
  void three(std::string_view key, ValueKind, const glm::vec3& v) { numbers(key, {v.x, v.y, v.z}); }
  void text(std::string_view key, std::string_view value, Location place) {
    begin(key);
    if (!append_json(out_, value)) {
      diagnostics_.report(write_character, place,
                          fmt::format("{} contains bytes that are not UTF-8", quoted(value)));
    }
  }
  template <typename Owner>
  void image(const ValueRow<Owner>& row, const TextureUse& use) {
    text(row.json, use.file, use.location);
    value(row.json_repeat[0], use.repeat_u);
    value(row.json_repeat[1], use.repeat_v);
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
    out_.append(2 * open_.size(), ' ');
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
  std::string out_;
  std::vector<Level> open_;
  std::size_t deepest_ = 0;
};

void print_camera(JsonPrinter& to, const Camera& camera) {
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

void print_primitive(JsonPrinter& to, const Primitive& primitive) {
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
      std::visit([&](const auto& map) { print_map(to_, map); }, transform.map);
    }
    print_lights(node);
    // A group with only a name would be read as an instance.
    if (!node.primitives.empty() || (node.children.empty() && node.lights.empty())) {
      print_primitives(node);
    }
    if (node.children.empty()) {
      to_.close();
      return false;
    }
    to_.open("groups", '[');
    frames_.push_back({id, 0});
    return true;
  }

  void print_lights(const Node& node) {
    if (node.lights.empty()) {
      return;
    }
    to_.open("lights", '[');
    for (const Light& light : node.lights) {
      print_object(to_, "", light);
    }
    to_.close();
  }

  void print_primitives(const Node& node) {
    to_.open("primitives", '[');
    for (const Primitive& primitive : node.primitives) {
      print_primitive(to_, primitive);
    }
    to_.close();
  }

  JsonPrinter& to_;
  const Scene& scene_;
  std::vector<Frame> frames_;
};

}  // namespace

std::string print_json(const Scene& scene, const Limits& limits, Diagnostics& diagnostics) {
  JsonPrinter to(limits, diagnostics);
  to.open("", '{');
  if (!scene.name.empty()) {
    to.text("name", scene.name, {});
  }
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

}  // namespace scenefile
