#include "scenefile/format/write_xml.h"

#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/format/write_codes.h"
#include "scenefile/format/write_parts.h"
#include "scenefile/format/write_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// Elements and attributes, one element a line.
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
      diagnostics_.report(write_character, place,
                          fmt::format("{} holds a character that XML cannot hold", quoted(value)));
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

  void value(std::string_view element, float v) { begin(element).attribute("v", v).leaf(); }
  void vector(std::string_view element, const glm::vec3& v) {
    begin(element).attribute("x", v.x).attribute("y", v.y).attribute("z", v.z).leaf();
  }
  void color(std::string_view element, const glm::vec3& c) {
    begin(element).attribute("r", c.r).attribute("g", c.g).attribute("b", c.b).leaf();
  }
  void texture(const TextureUse& use) { image("texture", use); }
  void bump_map(const TextureUse& use) { image("bumpmap", use); }

  /// Whether elements were nested deeper than readers allow; there is no use in going on then.
  bool too_deep() const { return deepest_ > limits_.nesting; }
  std::string take() { return std::move(out_); }

 private:
  void image(std::string_view element, const TextureUse& use) {
    begin(element).attribute("file", use.file, use.location);
    attribute("u", use.repeat_u).attribute("v", use.repeat_v).leaf();
  }

  const Limits& limits_;
  Diagnostics& diagnostics_;
  std::string out_;
  std::vector<std::string_view> open_;
  std::string_view begun_;
  std::size_t deepest_ = 0;
};

void print_global(XmlPrinter& to, const Global& global) {
  to.begin("globaldata").children();
  to.value("ambientcoeff", global.ambient);
  to.value("diffusecoeff", global.diffuse);
  to.value("specularcoeff", global.specular);
  if (global.transparent) {
    to.value("transparentcoeff", *global.transparent);
  }
  to.end();
}

void print_camera(XmlPrinter& to, const Camera& camera) {
  to.begin("cameradata").children();
  to.vector("pos", camera.position);
  to.vector("look", camera.look);
  to.vector("up", camera.up);
  to.value("heightangle", camera.height_angle_deg);
  if (camera.aperture != 0 || camera.focal_length != 0) {
    to.value("aperture", camera.aperture);
    to.value("focallength", camera.focal_length);
  }
  to.end();
}

void print_light(XmlPrinter& to, const Light& light) {
  to.begin("lightdata").children();
  if (light.id) {
    to.begin("id").attribute("v", fmt::format("{}", *light.id), light.location).leaf();
  }
  to.begin("type").attribute("v", word_of(light.type), light.location).leaf();
  to.color("color", light.color);
  const bool directional = light.type == LightType::directional;
  if (!directional || light.attenuation != Light().attenuation) {
    to.begin("function").attribute("v1", light.attenuation.x);
    to.attribute("v2", light.attenuation.y).attribute("v3", light.attenuation.z).leaf();
  }
  if (!directional) {
    to.vector("position", light.position);
  }
  print_beam(to, light);
  to.end();
}

void print_map(XmlPrinter& to, const Translate& translate) {
  to.vector("translate", translate.by);
}

void print_map(XmlPrinter& to, const Scale& scale) {
  to.vector("scale", scale.by);
}

void print_map(XmlPrinter& to, const Rotate& rotate) {
  to.begin("rotate").attribute("x", rotate.axis.x).attribute("y", rotate.axis.y);
  to.attribute("z", rotate.axis.z).attribute("angle", rotate.angle_deg).leaf();
}

void print_map(XmlPrinter& to, const Matrix& matrix) {
  to.begin("matrix").children();
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
  print_material(to, primitive.material);
  to.end();
}

// Trees of nodes, on a stack of its own.
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
  print_global(to, scene.global);
  if (scene.camera) {
    print_camera(to, *scene.camera);
  }
  for (const Light& light : scene.nodes[scene.root].lights) {
    print_light(to, light);
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
