#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/write_text.h"
#include "scenefile/format/write_values.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// The attribute names of a value with three parts.
std::span<const std::string_view> part_names(ValueKind kind) {
  static constexpr std::string_view of_color[] = {"r", "g", "b"};
  static constexpr std::string_view of_coefficients[] = {"v1", "v2", "v3"};
  static constexpr std::string_view of_vector[] = {"x", "y", "z"};
  return kind == ValueKind::color          ? std::span(of_color)
         : kind == ValueKind::coefficients ? std::span(of_coefficients)
                                           : std::span(of_vector);
}

// Prints elements and attributes, one element per line.
class XmlPrinter {
 public:
  XmlPrinter(const Limits& limits, Diagnostics& diagnostics)
      : limits_(limits), diagnostics_(diagnostics) {}

  /// Starts a tag; attributes may follow, then children() or leaf().
  XmlPrinter& begin(std::string_view element) {
    out_.append(2 * open_.size(), ' ');
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
          write_character, place,
          fmt::format("{} contains a character that XML cannot represent", quoted(value)));
    }
    out_ += '"';
    return *this;
  }
  XmlPrinter& attribute(std::string_view name, float value) {
    out_ += fmt::format(" {}=\"{}\"", name, number_text(value));
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
    out_.append(2 * open_.size(), ' ');
    out_ += fmt::format("</{}>\n", element);
  }

  template <typename Owner>
  static std::string_view name_of(const ValueRow<Owner>& row) {
    return row.xml;
  }
  /// Whether it is written for lights that do not use it.
  static bool is_idle(const ValueRow<Light>& row) { return row.idle_in_xml; }

  void value(std::string_view element, float v) { begin(element).attribute("v", v).leaf(); }
  void text(std::string_view element, std::string_view text, Location place) {
    begin(element).attribute("v", text, place).leaf();
  }
  void id(std::string_view element, int id, Location place) {
    text(element, fmt::format("{}", id), place);
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
  std::string out_;
  std::vector<std::string_view> open_;
  std::string_view begun_;
  std::size_t deepest_ = 0;
};

void print_camera(XmlPrinter& to, const Camera& camera) {
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

void print_primitive(XmlPrinter& to, const Primitive& primitive) {
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
    to_.begin("transblock").children();
    for (const Transform& transform : node.transforms) {
      std::visit([&](const auto& map) { print_map(to_, map); }, transform.map);
    }
    if (!node.instance_of.empty()) {
      to_.begin("object").attribute("type", "master", node.location);
      to_.attribute("name", node.instance_of, node.location).leaf();
    } else if (!node.primitives.empty()) {
      print_primitive(to_, node.primitives.front());
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

}  // namespace

std::string print_xml(const Scene& scene, const Limits& limits, Diagnostics& diagnostics) {
  XmlPrinter to(limits, diagnostics);
  to.begin("scenefile").children();
  print_block(to, "globaldata", scene.global);
  if (scene.camera) {
    print_camera(to, *scene.camera);
  }
  for (const Light& light : scene.nodes[scene.root].lights) {
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

}  // namespace scenefile
