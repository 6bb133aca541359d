#pragma once
// The values of a scene file, one row each: its names in both dialects, its kind, the member that
// holds it, which lights use it, its range, and how it is explained. Readers, writers, check, diff,
// editors, the schemas and the tables of docs/format.md use these rows. Internal to the rooms
// scene, format, edit, lsp and grade.

#include "scenefile/base/rare.h"
#include "scenefile/base/shape.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/scene/scene.h"
#include "scenefile/scene/value_kind.h"

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

/// Whether the value must be written, by lights only if their type uses it.
enum class Need : std::uint8_t {
  always,
  in_json,  ///< in XML its start value counts if it is missing
  never,    ///< its start value counts if it is missing
  depends   ///< what counts if it is missing depends on other values or on the program
};

constexpr bool is_needed(Need need, bool in_xml) {
  return need == Need::always || (need == Need::in_json && !in_xml);
}

/// For people who write scenes.
struct ValueWords {
  std::string_view title{};  ///< empty: editors do not show it
  std::string_view start{};  ///< of a new field; words with spaces between them
  std::string_view about{};  ///< what it is: sentences; empty: it is not explained
  std::string_view parts{};  ///< what to write: sentences; of a color what each of its parts is
};

/// A key of JSON for what is an attribute in XML: how often an image repeats.
struct RepeatKey {
  std::string_view key{};
  std::string_view title{};
};

template <typename Owner>
struct ValueRow {
  ValueKind kind = ValueKind::number;
  std::string_view xml{};   ///< name of the element; empty: not available in XML
  std::string_view json{};  ///< key; empty: not available in JSON
  Member<Owner> member{};
  std::optional<Field> field{};  ///< for findings about the value; nullopt: there are none
  UsedBy used_by = every_light;
  NumberRange range{};  ///< of each number; of an image, how often it repeats
  Need need = Need::always;
  ValueWords words{};
  std::string_view xml_alias{};  ///< another name of the element; accepted with a warning
  /// What counts in XML, with a warning, if the value must be written but is missing. The members
  /// of Camera and Light start with it, except a light's position, which is the origin in JSON.
  std::string_view xml_assumed{};
  /// XML files give this value to lights of all types; it is kept without a warning where unused.
  bool idle_in_xml = false;
  std::array<RepeatKey, 2> json_repeat{};  ///< image: of repeat_u and repeat_v
  std::uint8_t written = 0;  ///< sort key of the writers; ties keep the order of the rows
  std::int8_t edited = 0;    ///< sort key of the editors in XML, likewise

  constexpr bool used_by_type(LightType type) const { return used_by(type); }
  /// The name in messages and differences.
  constexpr std::string_view name() const { return xml.empty() ? json : xml; }
  constexpr bool has_member() const { return !std::holds_alternative<std::monostate>(member); }
  /// Whether the start value counts if the value is missing.
  constexpr bool has_default(bool in_xml) const {
    return need == Need::never || (need == Need::in_json && in_xml);
  }
};

namespace ranges {
inline constexpr NumberRange not_negative{.low = 0};
inline constexpr NumberRange positive{.low = 0, .open_low = true};
// No student's file uses a larger color of a material on purpose. Bright lights with attenuation
// are common: colors up to 200 in files by students of the course.
inline constexpr NumberRange material_color{0, 16};
inline constexpr NumberRange light_color{0, 1e4};
inline constexpr NumberRange repeats{1e-3, 1e4};
inline constexpr NumberRange coefficient{0, 100};
}  // namespace ranges

inline constexpr ValueRow<Global> global_rows[] = {
    {.xml = "ambientcoeff",
     .json = "ambientCoeff",
     .member = &Global::ambient,
     .field = Field::ambient,
     .range = ranges::coefficient,
     .need = Need::in_json,
     .words = {"Ambient coefficient", "0.5", "Scales the ambient color of every object.",
               "Usually from 0 to 1."}},
    {.xml = "diffusecoeff",
     .json = "diffuseCoeff",
     .member = &Global::diffuse,
     .field = Field::diffuse,
     .range = ranges::coefficient,
     .need = Need::in_json,
     .words = {"Diffuse coefficient", "0.5",
               "Scales the diffuse color of every object, but not its texture.",
               "Usually from 0 to 1."}},
    {.xml = "specularcoeff",
     .json = "specularCoeff",
     .member = &Global::specular,
     .field = Field::specular,
     .range = ranges::coefficient,
     .need = Need::in_json,
     .words = {"Specular coefficient", "0.5",
               "Scales the specular and the reflected color of every object.",
               "Usually from 0 to 1."}},
    {.xml = "transparentcoeff",
     .json = "transparentCoeff",
     .member = &Global::transparent,
     .field = Field::transparent,
     .range = ranges::coefficient,
     .need = Need::depends,
     .words = {"Transparent coefficient", "0.5",
               "Scales the light that passes through transparent objects. Write it if anything is "
               "transparent: programs differ in the default, 0 or 0.5.",
               "Usually from 0 to 1."}},
};

/// `focus` is a point to look at; readers convert it to a direction.
inline constexpr ValueRow<Camera> camera_rows[] = {
    {.kind = ValueKind::vector,
     .xml = "pos",
     .json = "position",
     .member = &Camera::position,
     .field = Field::position,
     .words = {"Position", "5 5 5", "Where the camera is."},
     .xml_assumed = "5 5 5"},
    {.kind = ValueKind::vector,
     .xml = "look",
     .json = "look",
     .member = &Camera::look,
     .field = Field::look,
     .need = Need::depends,
     .words =
         {"Direction of view", "-1 -1 -1",
          "The direction in which the camera looks, of any length. Give look or focus, not both."},
     .xml_assumed = "-1 -1 -1"},
    {.kind = ValueKind::vector,
     .xml = "focus",
     .json = "focus",
     .field = Field::look,
     .need = Need::depends,
     .words = {"Focus", "0 0 0",
               "The point at which the camera looks. Give focus or look, not both."}},
    {.kind = ValueKind::vector,
     .xml = "up",
     .json = "up",
     .member = &Camera::up,
     .field = Field::up,
     .words = {"Up", "0 1 0",
               "The direction that is up in the picture, of any length; not parallel to the "
               "direction of view."},
     .xml_assumed = "0 1 0"},
    {.xml = "heightangle",
     .json = "heightAngle",
     .member = &Camera::height_angle_deg,
     .field = Field::height_angle_deg,
     .range = {0, 180, true, true},
     .words = {"Height angle", "45", "The full vertical angle of view.",
               "Degrees, above 0 and below 180; 30 to 60 are common."},
     .xml_alias = "angle",
     .xml_assumed = "45"},
    {.xml = "aspectratio",
     .range = ranges::positive,
     .need = Need::depends,
     .words = {"", "", "Has no effect: the aspect ratio is that of the picture.",
               "Has no effect; width divided by height, above 0."}},
    {.xml = "aperture",
     .json = "aperture",
     .member = &Camera::aperture,
     .field = Field::aperture,
     .range = ranges::not_negative,
     .need = Need::never,
     .words = {"Aperture", "0", "The size of the lens, for depth of field; 0: everything is sharp.",
               "World units, 0 or more."}},
    {.xml = "focallength",
     .json = "focalLength",
     .member = &Camera::focal_length,
     .field = Field::focal_length,
     .range = ranges::not_negative,
     .need = Need::never,
     .words = {"Focal length", "0",
               "The distance of the plane in focus, for depth of field; 0: everything is sharp.",
               "World units, 0 or more."}},
};

inline constexpr ValueRow<Light> light_rows[] = {
    {.kind = ValueKind::id,
     .xml = "id",
     .member = &Light::id,
     .field = Field::id,
     .range = {0, 7},
     .need = Need::depends,
     .words = {"Id", "0",
               "The number of the light. It has no effect here; some programs use it as an index.",
               "A whole number from 0 to 7, different for each light."},
     .xml_alias = "number"},
    {.kind = ValueKind::choice,
     .xml = "type",
     .json = "type",
     .need = Need::in_json,
     .words = {"Type of light", "point", "What kind of light this is.",
               "point: from its position in all directions. directional: parallel light from "
               "infinitely far away. spot: from its position into a cone. area: from a rectangle "
               "about its position; the course's JSON reader rejects it."},
     .edited = -1},
    {.kind = ValueKind::text,
     .json = "name",
     .member = &Light::name,
     .need = Need::depends,
     .words = {"Name", "", "A name for readers of the file."}},
    {.kind = ValueKind::color,
     .xml = "color",
     .json = "color",
     .member = &Light::color,
     .field = Field::color,
     .range = ranges::light_color,
     .words = {"Color", "1 1 1", "The color of the light.",
               "0 none, 1 full; above 1 for a bright light with attenuation."},
     .xml_assumed = "1 1 1"},
    {.kind = ValueKind::coefficients,
     .xml = "function",
     .json = "attenuationCoeff",
     .member = &Light::attenuation,
     .field = Field::attenuation,
     .used_by = has_position,
     .range = ranges::not_negative,
     .need = Need::in_json,
     .words = {"Attenuation", "1 0 0",
               "The attenuation of the light: it is divided by c + l d + q d^2, where d is the "
               "distance, and c, l and q are the constant, the linear and the quadratic "
               "coefficient; 1 0 0: no attenuation. No effect on a directional light."},
     .idle_in_xml = true},
    {.kind = ValueKind::vector,
     .xml = "position",
     .member = &Light::position,
     .field = Field::position,
     .used_by = has_position,
     .words = {"Position", "2 5 3", "The position of the light; for an area light, its center."},
     .xml_assumed = "3 3 3"},
    {.kind = ValueKind::vector,
     .xml = "direction",
     .json = "direction",
     .member = &Light::direction,
     .field = Field::direction,
     .used_by = has_direction,
     .words = {"Direction", "-2 -5 -3",
               "The direction in which the light travels, of any length but 0: from the light, not "
               "toward it. No effect on a point light."}},
    {.xml = "penumbra",
     .json = "penumbra",
     .member = &Light::penumbra_deg,
     .field = Field::penumbra_deg,
     .used_by = has_cone,
     .range = ranges::not_negative,
     .words = {"Penumbra", "5",
               "How far inside the edge of its cone a spotlight begins to fall off.",
               "Degrees, from 0 (a hard edge) to the angle of the spotlight."},
     .xml_assumed = "0",
     .edited = 1},
    {.xml = "angle",
     .json = "angle",
     .member = &Light::angle_deg,
     .field = Field::angle_deg,
     .used_by = has_cone,
     .range = {0, 180, true},
     .words = {"Angle", "30", "The half-angle of a spotlight's cone: from its axis to its edge.",
               "Degrees, above 0 and up to 180."}},
    {.xml = "radius", .need = Need::depends},
    {.xml = "width",
     .json = "width",
     .member = &Light::width,
     .field = Field::width,
     .used_by = has_rectangle,
     .range = ranges::positive,
     .words = {"Width", "1", "The width of an area light.", "World units, above 0."},
     .edited = 2},
    {.xml = "height",
     .json = "height",
     .member = &Light::height,
     .field = Field::height,
     .used_by = has_rectangle,
     .range = ranges::positive,
     .words = {"Height", "1", "The height of an area light.", "World units, above 0."},
     .edited = 2},
};

inline constexpr ValueRow<Material> material_rows[] = {
    {.kind = ValueKind::color,
     .xml = "ambient",
     .json = "ambient",
     .member = &Material::ambient,
     .field = Field::ambient,
     .range = ranges::material_color,
     .need = Need::never,
     .words = {"Ambient color", "0 0 0", "The color of the surface without any light.",
               "0 none, 1 full."},
     .written = 1,
     .edited = 1},
    {.kind = ValueKind::color,
     .xml = "diffuse",
     .json = "diffuse",
     .member = &Material::diffuse,
     .field = Field::diffuse,
     .range = ranges::material_color,
     .need = Need::never,
     .words = {"Diffuse color", "1 1 1", "The color of the surface in direct light.",
               "0 none, 1 full."},
     .written = 0},
    {.kind = ValueKind::color,
     .xml = "specular",
     .json = "specular",
     .member = &Material::specular,
     .field = Field::specular,
     .range = ranges::material_color,
     .need = Need::never,
     .words = {"Specular color", "0 0 0", "The color of highlights; needs a shininess above 0.",
               "0 none, 1 full."},
     .written = 2,
     .edited = 1},
    {.kind = ValueKind::color,
     .xml = "reflective",
     .json = "reflective",
     .member = &Material::reflective,
     .field = Field::reflective,
     .range = ranges::material_color,
     .need = Need::never,
     .words = {"Reflective color", "0 0 0", "How much of each color the surface mirrors.",
               "0 none, 1 full."},
     .xml_alias = "reflect",
     .written = 4,
     .edited = 1},
    {.kind = ValueKind::color,
     .xml = "transparent",
     .json = "transparent",
     .member = &Material::transparent,
     .field = Field::transparent,
     .range = ranges::material_color,
     .need = Need::never,
     .words = {"Transparent color", "0 0 0", "How much of each color passes through.",
               "0 none, 1 full."},
     .written = 5,
     .edited = 1},
    {.kind = ValueKind::color, .xml = "emissive", .need = Need::depends},
    {.xml = "shininess",
     .json = "shininess",
     .member = &Material::shininess,
     .field = Field::shininess,
     .range = {0, 1e4},
     .need = Need::never,
     .words = {"Shininess", "0",
               "The exponent of highlights: the larger, the smaller and sharper; 0: no highlight.",
               "0 to 10000; 1 to 200 are common."},
     .xml_alias = "shine",
     .written = 3,
     .edited = 1},
    {.xml = "ior",
     .json = "ior",
     .member = &Material::ior,
     .field = Field::ior,
     .range = {0, 5},
     .need = Need::never,
     .words = {"Index of refraction", "1",
               "The index of refraction of a transparent object; 1: light passes straight through.",
               "1.33 for water, 1.5 for glass, 2.4 for diamond; 0 means not given."},
     .written = 6,
     .edited = 1},
    {.xml = "blend",
     .json = "blend",
     .member = &Material::blend,
     .field = Field::blend,
     .range = {0, 1},
     .need = Need::never,
     .words = {"Blend", "0", "The share of the texture in the diffuse color.",
               "From 0, only the color, to 1, only the texture."},
     .written = 8,
     .edited = 3},
    {.kind = ValueKind::image,
     .xml = "texture",
     .json = "textureFile",
     .member = &Material::texture,
     .range = ranges::repeats,
     .need = Need::depends,
     .words = {"Texture", "textures/wood.png 1 1",
               "An image on the surface. Needs a blend above 0 to be visible."},
     .json_repeat = {{{"textureU", "Texture repeats along u"},
                      {"textureV", "Texture repeats along v"}}},
     .written = 7,
     .edited = 4},
    {.kind = ValueKind::image,
     .xml = "bumpmap",
     .json = "bumpMapFile",
     .member = &Material::bump_map,
     .range = ranges::repeats,
     .need = Need::depends,
     .words = {"Bump map", "textures/bumps.png 1 1",
               "An image whose brightness is the height of the surface."},
     .json_repeat = {{{"bumpMapU", "Bump map repeats along u"},
                      {"bumpMapV", "Bump map repeats along v"}}},
     .written = 9,
     .edited = 2},
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

/// Whether lights of the type must have the value. The course's JSON reader requires the
/// attenuation, but of its own types of light.
constexpr bool light_needs(LightType type, const ValueRow<Light>& row, bool in_xml) {
  return row.used_by_type(type) && is_needed(row.need, in_xml) &&
         (row.field != Field::attenuation || course_json_has(type));
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
