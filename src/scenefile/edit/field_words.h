#pragma once
// The fields of a scene file as editors show them: the rows of scene/vocabulary.h, and those of
// objects and transforms, which have none there. Internal to edit.

#include "scenefile/edit/document.h"
#include "scenefile/scene/vocabulary.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

struct FieldWord {
  std::string_view xml;  ///< empty: not available in that dialect
  std::string_view json;
  std::string_view title;
  ValueKind kind = ValueKind::number;
  std::string_view start{};  ///< of a new field; words with spaces between them
  NumberRange range{};
  Need need = Need::depends;
  std::int8_t xml_rank = 0;  ///< sort key of the order in XML; ties keep that of the table

  constexpr std::string_view name(bool is_xml) const { return is_xml ? xml : json; }
};

inline constexpr FieldWord name_field{"name", "name", "Name", ValueKind::text};
inline constexpr FieldWord shape_field{"name", {}, "Shape",     ValueKind::choice,
                                       "cube", {}, Need::always};
inline constexpr FieldWord mesh_field{
    "filename", {}, "Mesh file", ValueKind::file, "meshes/teapot.obj"};
inline constexpr FieldWord template_field{"name", "name", "Template", ValueKind::choice};

inline constexpr FieldWord transform_fields[] = {
    {"translate", "translate", "Translation", ValueKind::vector, "0 0 0"},
    {"rotate", "rotate", "Rotation", ValueKind::rotation, "0 1 0 0"},
    {"scale", "scale", "Scale", ValueKind::vector, "1 1 1"},
    {"matrix", "matrix", "Matrix", ValueKind::matrix, "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"},
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
