#pragma once
// The values of a scene file, one row each: its names in both dialects, its kind, the member that
// holds it, and which lights use it. Readers, writers, check and diff use these tables. Internal to
// the rooms scene, format and grade.

#include "scenefile/base/rare.h"
#include "scenefile/base/shape.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace scenefile {

enum class ValueKind : std::uint8_t {
  number,
  vector,  ///< a point or direction
  color,
  coefficients,  ///< constant, linear, quadratic
  id,            ///< a whole number
  word,          ///< the type of a light
  text,
  texture
};

/// The member that holds a value. None if the readers convert the value, or if it has no effect.
template <typename Owner>
using Member =
    std::variant<std::monostate, float Owner::*, glm::vec3 Owner::*, std::optional<float> Owner::*,
                 std::optional<int> Owner::*, std::string Owner::*, Rare<TextureUse> Owner::*>;

/// Which lights use a value: all, or only those with some property.
using UsedBy = bool (*)(LightType);
constexpr bool every_light(LightType /*type*/) {
  return true;
}

template <typename Owner>
struct ValueRow {
  ValueKind kind = ValueKind::number;
  std::string_view xml{};   ///< name of the element; empty: not available in XML
  std::string_view json{};  ///< key; empty: not available in JSON
  Member<Owner> member{};
  std::optional<Field> field{};  ///< for findings about the value; nullopt: there are none
  UsedBy used_by = every_light;
  std::string_view xml_alias{};  ///< another name of the element; accepted with a warning
  /// XML files give this value to lights of all types; it is kept without a warning where unused.
  bool idle_in_xml = false;
  std::array<std::string_view, 2> json_repeat{};  ///< texture: keys of repeat_u and repeat_v
  std::uint8_t written = 0;  ///< sort key of the writers; ties keep the order of the rows

  constexpr bool used_by_type(LightType type) const { return used_by(type); }
  /// The name in messages and differences.
  constexpr std::string_view name() const { return xml.empty() ? json : xml; }
  constexpr bool has_member() const { return !std::holds_alternative<std::monostate>(member); }
};

inline constexpr ValueRow<Global> global_rows[] = {
    {ValueKind::number, "ambientcoeff", "ambientCoeff", &Global::ambient, Field::ambient},
    {ValueKind::number, "diffusecoeff", "diffuseCoeff", &Global::diffuse, Field::diffuse},
    {ValueKind::number, "specularcoeff", "specularCoeff", &Global::specular, Field::specular},
    {ValueKind::number, "transparentcoeff", "transparentCoeff", &Global::transparent,
     Field::transparent},
};

/// `focus` is a point to look at; readers convert it to a direction.
inline constexpr ValueRow<Camera> camera_rows[] = {
    {ValueKind::vector, "pos", "position", &Camera::position, Field::position},
    {ValueKind::vector, "look", "look", &Camera::look, Field::look},
    {ValueKind::vector, "focus", "focus", {}, Field::look},
    {ValueKind::vector, "up", "up", &Camera::up, Field::up},
    {.xml = "heightangle",
     .json = "heightAngle",
     .member = &Camera::height_angle_deg,
     .field = Field::height_angle_deg,
     .xml_alias = "angle"},
    {ValueKind::number, "aspectratio", {}},
    {ValueKind::number, "aperture", "aperture", &Camera::aperture, Field::aperture},
    {ValueKind::number, "focallength", "focalLength", &Camera::focal_length, Field::focal_length},
};

inline constexpr ValueRow<Light> light_rows[] = {
    {.kind = ValueKind::id,
     .xml = "id",
     .member = &Light::id,
     .field = Field::id,
     .xml_alias = "number"},
    {ValueKind::word, "type", "type"},
    {ValueKind::text, {}, "name", &Light::name},
    {ValueKind::color, "color", "color", &Light::color, Field::color},
    {.kind = ValueKind::coefficients,
     .xml = "function",
     .json = "attenuationCoeff",
     .member = &Light::attenuation,
     .field = Field::attenuation,
     .used_by = has_position,
     .idle_in_xml = true},
    {ValueKind::vector, "position", {}, &Light::position, Field::position, has_position},
    {ValueKind::vector, "direction", "direction", &Light::direction, Field::direction,
     has_direction},
    {ValueKind::number, "penumbra", "penumbra", &Light::penumbra_deg, Field::penumbra_deg,
     has_cone},
    {ValueKind::number, "angle", "angle", &Light::angle_deg, Field::angle_deg, has_cone},
    {ValueKind::number, "radius", {}},
    {ValueKind::number, "width", "width", &Light::width, Field::width, has_rectangle},
    {ValueKind::number, "height", "height", &Light::height, Field::height, has_rectangle},
};

inline constexpr ValueRow<Material> material_rows[] = {
    {.kind = ValueKind::color,
     .xml = "ambient",
     .json = "ambient",
     .member = &Material::ambient,
     .field = Field::ambient,
     .written = 1},
    {.kind = ValueKind::color,
     .xml = "diffuse",
     .json = "diffuse",
     .member = &Material::diffuse,
     .field = Field::diffuse,
     .written = 0},
    {.kind = ValueKind::color,
     .xml = "specular",
     .json = "specular",
     .member = &Material::specular,
     .field = Field::specular,
     .written = 2},
    {.kind = ValueKind::color,
     .xml = "reflective",
     .json = "reflective",
     .member = &Material::reflective,
     .field = Field::reflective,
     .xml_alias = "reflect",
     .written = 4},
    {.kind = ValueKind::color,
     .xml = "transparent",
     .json = "transparent",
     .member = &Material::transparent,
     .field = Field::transparent,
     .written = 5},
    {ValueKind::color, "emissive", {}},
    {.xml = "shininess",
     .json = "shininess",
     .member = &Material::shininess,
     .field = Field::shininess,
     .xml_alias = "shine",
     .written = 3},
    {.xml = "ior", .json = "ior", .member = &Material::ior, .field = Field::ior, .written = 6},
    {.xml = "blend",
     .json = "blend",
     .member = &Material::blend,
     .field = Field::blend,
     .written = 8},
    {.kind = ValueKind::texture,
     .xml = "texture",
     .json = "textureFile",
     .member = &Material::texture,
     .json_repeat = {"textureU", "textureV"},
     .written = 7},
    {.kind = ValueKind::texture,
     .xml = "bumpmap",
     .json = "bumpMapFile",
     .member = &Material::bump_map,
     .json_repeat = {"bumpMapU", "bumpMapV"},
     .written = 9},
};

/// The word of a transform in both dialects; each type of Transform::map must have one.
template <typename Map>
constexpr std::string_view transform_word = [] {
  static_assert(sizeof(Map) == 0, "give this transform a word");
  return std::string_view();
}();
template <>
inline constexpr std::string_view transform_word<Translate> = "translate";
template <>
inline constexpr std::string_view transform_word<Rotate> = "rotate";
template <>
inline constexpr std::string_view transform_word<Scale> = "scale";
template <>
inline constexpr std::string_view transform_word<Matrix> = "matrix";

/// The words of transforms, in the order of Transform::map.
template <typename... Maps>
constexpr std::array<std::string_view, sizeof...(Maps)> words_of_maps(
    const std::variant<Maps...>* /*type*/) {
  return {transform_word<Maps>...};
}
inline constexpr auto transform_words =
    words_of_maps(static_cast<const decltype(Transform::map)*>(nullptr));

constexpr bool is_transform(std::string_view word) {
  return std::find(transform_words.begin(), transform_words.end(), word) != transform_words.end();
}

/// The XML elements that contain other elements, except <matrix>. The first four occur only in
/// scene files.
inline constexpr std::array<std::string_view, 6> structure_elements{
    "scenefile", "globaldata", "cameradata", "lightdata", "object", "transblock"};

/// The index of a field's row in its table; the first if the field has two rows.
template <typename Owner, std::size_t N>
constexpr std::size_t index_of(const ValueRow<Owner> (&rows)[N], Field field) {
  std::size_t i = 0;
  while (rows[i].field != field) {
    ++i;
  }
  return i;
}

template <typename Owner, std::size_t N>
constexpr const ValueRow<Owner>& row_of(const ValueRow<Owner> (&rows)[N], Field field) {
  return rows[index_of(rows, field)];
}

/// Whether the value affects lights of that type.
constexpr bool light_uses(LightType type, Field field) {
  return row_of(light_rows, field).used_by_type(type);
}

/// "point light".
constexpr std::string_view light_type_name(LightType type) {
  switch (type) {
    case LightType::point:
      return "point light";
    case LightType::directional:
      return "directional light";
    case LightType::spot:
      return "spotlight";
    case LightType::area:
      return "area light";
  }
  return {};
}

/// Whether the course's JSON reader supports lights of the type; it rejects files with others.
constexpr bool course_json_has(LightType type) {
  switch (type) {
    case LightType::point:
    case LightType::directional:
    case LightType::spot:
      return true;
    case LightType::area:
      return false;
  }
  return false;
}

/// The rows in the order of both writers.
template <typename Owner, std::size_t N>
constexpr std::array<const ValueRow<Owner>*, N> as_written(const ValueRow<Owner> (&rows)[N]) {
  std::array<const ValueRow<Owner>*, N> order{};
  for (std::size_t i = 0; i < N; ++i) {
    std::size_t at = i;
    for (; at > 0 && order[at - 1]->written > rows[i].written; --at) {
      order[at] = order[at - 1];
    }
    order[at] = &rows[i];
  }
  return order;
}

}  // namespace scenefile
