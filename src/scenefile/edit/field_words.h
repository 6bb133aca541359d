#pragma once
// What the fields of a scene file are called, their ranges and start values, beside what
// scene/vocabulary.h says. Internal to edit.

#include "scenefile/edit/document.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace scenefile {

struct FieldWord {
  std::string_view xml;  ///< empty: not available in that dialect
  std::string_view json;
  std::string_view title;
  FieldKind kind = FieldKind::number;
  NumberRange range{};
  std::string_view start{};   ///< of a new field; words with spaces between them
  std::uint8_t xml_rank = 0;  ///< sort key of the order in XML; ties keep that of the table

  std::string_view name(bool is_xml) const { return is_xml ? xml : json; }
};

inline constexpr NumberRange any_number{};
inline constexpr NumberRange not_negative{.low = 0};
inline constexpr NumberRange positive{.low = 0, .open_low = true};

inline constexpr FieldWord global_fields[] = {
    {"ambientcoeff", "ambientCoeff", "Ambient coefficient", FieldKind::number, {0, 100}, "0.5"},
    {"diffusecoeff", "diffuseCoeff", "Diffuse coefficient", FieldKind::number, {0, 100}, "0.5"},
    {"specularcoeff", "specularCoeff", "Specular coefficient", FieldKind::number, {0, 100}, "0.5"},
    {"transparentcoeff",
     "transparentCoeff",
     "Transparent coefficient",
     FieldKind::number,
     {0, 100},
     "0.5"},
};

inline constexpr FieldWord camera_fields[] = {
    {"pos", "position", "Position", FieldKind::vector, any_number, "5 5 5"},
    {"look", "look", "Direction of view", FieldKind::vector, any_number, "-1 -1 -1"},
    {"focus", "focus", "Focus", FieldKind::vector, any_number, "0 0 0"},
    {"up", "up", "Up", FieldKind::vector, any_number, "0 1 0"},
    {"heightangle", "heightAngle", "Height angle", FieldKind::number, {0, 180, true, true}, "45"},
    {"aperture", "aperture", "Aperture", FieldKind::number, not_negative, "0"},
    {"focallength", "focalLength", "Focal length", FieldKind::number, not_negative, "0"},
};

inline constexpr FieldWord light_fields[] = {
    {"type", "type", "Type of light", FieldKind::choice, any_number, "point"},
    {"id", {}, "Id", FieldKind::id, {0, 7}, "0"},
    {{}, "name", "Name", FieldKind::text},
    {"color", "color", "Color", FieldKind::color, {0, 10'000}, "1 1 1"},
    {"function", "attenuationCoeff", "Attenuation", FieldKind::coefficients, not_negative, "1 0 0"},
    {"position", {}, "Position", FieldKind::vector, any_number, "2 5 3"},
    {"direction", "direction", "Direction", FieldKind::vector, any_number, "-2 -5 -3"},
    {"penumbra", "penumbra", "Penumbra", FieldKind::number, not_negative, "5", 1},
    {"angle", "angle", "Angle", FieldKind::number, {0, 180, true}, "30"},
    {"width", "width", "Width", FieldKind::number, positive, "1", 2},
    {"height", "height", "Height", FieldKind::number, positive, "1", 2},
};

inline constexpr NumberRange color_range{0, 16};
inline constexpr NumberRange repeat_range{0.001, 10'000};

inline constexpr FieldWord primitive_fields[] = {
    {{}, "type", "Shape", FieldKind::choice, any_number, "cube"},
    {{}, "meshFile", "Mesh file", FieldKind::file, any_number, "meshes/teapot.obj"},
    {"ambient", "ambient", "Ambient color", FieldKind::color, color_range, "0 0 0", 1},
    {"diffuse", "diffuse", "Diffuse color", FieldKind::color, color_range, "1 1 1"},
    {"specular", "specular", "Specular color", FieldKind::color, color_range, "0 0 0", 1},
    {"reflective", "reflective", "Reflective color", FieldKind::color, color_range, "0 0 0", 1},
    {"transparent", "transparent", "Transparent color", FieldKind::color, color_range, "0 0 0", 1},
    {"shininess", "shininess", "Shininess", FieldKind::number, {0, 10'000}, "0", 1},
    {"ior", "ior", "Index of refraction", FieldKind::number, {0, 5}, "1", 1},
    {"blend", "blend", "Blend", FieldKind::number, {0, 1}, "0", 3},
    {"texture", {}, "Texture", FieldKind::image, repeat_range, "textures/wood.png 1 1", 4},
    {"bumpmap", {}, "Bump map", FieldKind::image, repeat_range, "textures/bumps.png 1 1", 2},
    {{}, "textureFile", "Texture", FieldKind::file, any_number, "textures/wood.png"},
    {{}, "textureU", "Texture repeats along u", FieldKind::number, repeat_range, "1"},
    {{}, "textureV", "Texture repeats along v", FieldKind::number, repeat_range, "1"},
    {{}, "bumpMapFile", "Bump map", FieldKind::file, any_number, "textures/bumps.png"},
    {{}, "bumpMapU", "Bump map repeats along u", FieldKind::number, repeat_range, "1"},
    {{}, "bumpMapV", "Bump map repeats along v", FieldKind::number, repeat_range, "1"},
};

inline constexpr FieldWord name_field{"name", "name", "Name", FieldKind::text};
inline constexpr FieldWord shape_field{"name", {}, "Shape", FieldKind::choice, any_number, "cube"};
inline constexpr FieldWord mesh_field{"filename",      {},         "Mesh file",
                                      FieldKind::file, any_number, "meshes/teapot.obj"};
inline constexpr FieldWord template_field{"name", "name", "Template", FieldKind::choice};

inline constexpr FieldWord transform_fields[] = {
    {"translate", "translate", "Translation", FieldKind::vector, any_number, "0 0 0"},
    {"rotate", "rotate", "Rotation", FieldKind::rotation, any_number, "0 1 0 0"},
    {"scale", "scale", "Scale", FieldKind::vector, any_number, "1 1 1"},
    {"matrix", "matrix", "Matrix", FieldKind::matrix, any_number,
     "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"},
};

/// The fields of an item of that kind that are elements or entries of its own; transforms aside.
std::span<const FieldWord> words_of(ItemKind kind);

/// Their order in the dialect.
std::vector<const FieldWord*> ordered_words(ItemKind kind, bool xml);

/// Whether lights of a type ("spot") need a field, and whether it has an effect on them.
struct LightUse {
  bool needed = false;
  bool effective = true;
};
LightUse light_use(std::string_view field, std::string_view type, bool xml);

/// How many parts a value has, and what each is called.
std::vector<std::string_view> parts_of(const FieldWord& word, bool xml);

/// The start values of the parts.
std::vector<std::string> start_of(const FieldWord& word);

}  // namespace scenefile
