#pragma once
// From the attributes of a tag to numbers and text, in every way that the dialects name them.
// Internal to the room.

#include "scenefile/format/xml_context.h"
#include "scenefile/scene/vocabulary.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// One way to name the parts of a value.
struct AttributeForm {
  std::array<std::string_view, 4> names;  ///< as many as the value has parts
  bool dialect = false;                   ///< worth a warning
  std::string_view alpha{};               ///< one more, which has no effect
};

/// All ways to name the parts of a value; the first is the one that messages name.
struct Signature {
  std::span<const AttributeForm> forms;
  std::size_t parts = 1;
  bool optional = false;    ///< the caller judges missing parts itself
  bool free_names = false;  ///< the last part, or all others, may have any names
};

/// The attributes that hold the parts; null: missing.
using Parts = std::array<const XmlAttribute*, 4>;

/// Finds the parts by their names, else by another form, else by their order, and reports what is
/// assumed, unknown or missing. Nothing, after an error, when a part that must be there is missing.
/// After an error about a misspelled name the part is the one that was probably meant.
std::optional<Parts> find_parts(const XmlContext& context, const XmlTag& tag,
                                const Signature& signature);
/// The error for parts that are missing.
void report_missing(const XmlContext& context, const XmlTag& tag, const Signature& signature,
                    const Parts& parts);

/// The warning that the attributes stand in another order than that of `in_order`, where a program
/// that goes by the order alone would read other values. Null ones are missing.
void report_order(const XmlContext& context, const XmlTag& tag,
                  std::span<const XmlAttribute* const> in_order);

/// The value of a numeric attribute; reports what is wrong with it. `not_known` after an error.
float read_number(const XmlContext& context, const XmlTag& tag, const XmlAttribute& attribute);

/// Each of these gives nothing, after an error, when an attribute is missing or no number.
std::optional<float> read_single(const XmlContext& context, const XmlTag& tag);
std::optional<std::string_view> read_word(const XmlContext& context, const XmlTag& tag);
/// A vector, a color or coefficients.
std::optional<glm::vec3> read_three(const XmlContext& context, const XmlTag& tag, ValueKind kind);
std::optional<glm::vec4> read_matrix_row(const XmlContext& context, const XmlTag& tag);

/// The kind of the value that an element of this name has; nothing: it has none.
std::optional<ValueKind> kind_of_element(std::string_view element);

/// How to write as attributes what stands between the tags of the element, such as `<pos x="1"
/// y="2" z="3"/>` for 1 2 3; empty: it is not known.
std::string as_attributes(std::string_view element, std::string_view text);

/// The attribute is not part of the format; suggests the nearest of `known`.
void report_unknown_attribute(const XmlContext& context, const XmlTag& tag,
                              const XmlAttribute& attribute,
                              std::span<const std::string_view> known);

}  // namespace scenefile
