#include "scenefile/scene/diff_values.h"

#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/scene/check_parts.h"

#include <fmt/format.h>

#include <variant>

namespace scenefile {

namespace {

// Both zeros are equal, so they must read alike.
std::string text_of(float value) {
  return number_text(value + 0.0f);
}
std::string text_of(const glm::vec3& value) {
  return vector_text(value + glm::vec3(0.0f));
}
std::string text_of(int value) {
  return fmt::format("{}", value);
}
std::string text_of(const std::string& value) {
  return quoted(value, value.size());
}
std::string text_of(const TextureUse& use) {
  return fmt::format("{} repeated {} by {}", text_of(use.file), text_of(use.repeat_u),
                     text_of(use.repeat_v));
}

template <typename T>
std::string text_of(const std::optional<T>& value) {
  return value ? text_of(*value) : "none";
}
std::string text_of(const Rare<TextureUse>& use) {
  return use ? text_of(*use) : "none";
}

std::string text_of(const Translate& t) {
  return "translate " + text_of(t.by);
}
std::string text_of(const Rotate& r) {
  return fmt::format("rotate {} about {}", text_of(r.angle_deg), text_of(r.axis));
}
std::string text_of(const Scale& s) {
  return "scale " + text_of(s.by);
}
std::string text_of(const Matrix& matrix) {
  std::string text = "matrix";
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      text += (column == 0 && row != 0 ? " / " : " ") + text_of(matrix.m()[column][row]);
    }
  }
  return text;
}
std::string text_of(const std::vector<Transform>& transforms) {
  std::string text;
  for (const Transform& transform : transforms) {
    text += text.empty() ? "" : ", ";
    text += std::visit([](const auto& map) { return text_of(map); }, transform.map);
  }
  return text;
}

template <typename T>
void add(Values& values, std::string_view name, const T& value, const T& standard) {
  if (!(value == standard)) {
    values.push_back({name, text_of(value)});
  }
}

void add(Values& values, const Material& m) {
  static const Material standard;
  add(values, "ambient", m.ambient, standard.ambient);
  add(values, "diffuse", m.diffuse, standard.diffuse);
  add(values, "specular", m.specular, standard.specular);
  add(values, "reflective", m.reflective, standard.reflective);
  add(values, "transparent", m.transparent, standard.transparent);
  add(values, "shininess", m.shininess, standard.shininess);
  add(values, "ior", m.ior, standard.ior);
  add(values, "blend", m.blend, standard.blend);
  add(values, "texture", m.texture, standard.texture);
  add(values, "bumpmap", m.bump_map, standard.bump_map);
}

}  // namespace

Values values_of(const Global& global) {
  const Global standard;
  Values values;
  add(values, "ambientcoeff", global.ambient, standard.ambient);
  add(values, "diffusecoeff", global.diffuse, standard.diffuse);
  add(values, "specularcoeff", global.specular, standard.specular);
  add(values, "transparentcoeff", global.transparent, standard.transparent);
  return values;
}

Values values_of(const Camera& camera) {
  const Camera standard;
  Values values;
  add(values, "pos", camera.position, standard.position);
  add(values, "look", camera.look, standard.look);
  add(values, "up", camera.up, standard.up);
  add(values, "heightangle", camera.height_angle_deg, standard.height_angle_deg);
  add(values, "aperture", camera.aperture, standard.aperture);
  add(values, "focallength", camera.focal_length, standard.focal_length);
  return values;
}

Values values_of(const Light& light) {
  const Light standard;
  Values values{{"type", std::string(light_type_name(light.type))}};
  add(values, "name", light.name, standard.name);
  add(values, "id", light.id, standard.id);
  add(values, "color", light.color, standard.color);
  add(values, "position", light.position, standard.position);
  add(values, "direction", light.direction, standard.direction);
  add(values, "function", light.attenuation, standard.attenuation);
  add(values, "angle", light.angle_deg, standard.angle_deg);
  add(values, "penumbra", light.penumbra_deg, standard.penumbra_deg);
  add(values, "width", light.width, standard.width);
  add(values, "height", light.height, standard.height);
  return values;
}

Values values_of(const Primitive& primitive) {
  Values values{{"type", std::string(word_of(primitive.shape))}};
  add(values, "file", primitive.mesh_file.str(), std::string());
  add(values, primitive.material);
  return values;
}

Values values_of(const Node& node) {
  Values values;
  add(values, "name", node.name.str(), std::string());
  add(values, "instance of", node.instance_of.str(), std::string());
  if (!node.transforms.empty()) {
    values.push_back({"transforms", text_of(node.transforms)});
  }
  return values;
}

}  // namespace scenefile
