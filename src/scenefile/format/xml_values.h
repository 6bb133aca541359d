#pragma once
// The context passed to every part of the XML reader, and functions that read numbers and text from
// the attributes of a tag, in all dialects. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/format/text_places.h"
#include "scenefile/format/xml_scanner.h"
#include "scenefile/scene/vocabulary.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace scenefile {

struct XmlContext {
  const ReadOptions& options;
  Diagnostics& diagnostics;
  TextPlaces& places;

  void report(const Code& code, const XmlTag& tag, std::string message,
              std::optional<Correction> correction = {}) const {
    diagnostics.report(code, tag.location, std::move(message), std::move(correction));
  }
  void report(const Code& code, const XmlAttribute& attribute, std::string message,
              std::optional<Correction> correction = {}) const {
    diagnostics.report(code, place(attribute), std::move(message), std::move(correction));
  }
  Location place(const XmlAttribute& attribute) const { return places.at(attribute.name.data()); }
};

/// The name of an element for messages, in angle brackets.
std::string element_text(std::string_view name);

/// The attributes of a value with three parts.
std::span<const std::string_view> part_names(ValueKind kind);

/// "; did you mean X?", or empty if X is empty. `mark` surrounds X: "<>" or "".
std::string did_you_mean(std::string_view name, std::string_view mark = "");

/// One way to name the parts of a value.
struct AttributeForm {
  std::array<std::string_view, 4> names;  ///< one for each part of the value
  bool dialect = false;                   ///< accepted with a warning
  std::string_view alpha{};               ///< an additional attribute without effect
};

/// All sets of names for the parts of a value; messages use the first.
struct Signature {
  std::span<const AttributeForm> forms;
  std::size_t parts = 1;
  bool optional = false;    ///< the caller handles missing parts
  bool free_names = false;  ///< the last part, or all but the last, may have any names
};

/// The names of the parts of a value of this kind, of a matrix those of a row; not of an image.
Signature signature_of(ValueKind kind);

/// The attributes of the parts; null if missing.
using Parts = std::array<const XmlAttribute*, 4>;

/// Finds the parts by name, in any of the forms, or otherwise by order, and reports what is
/// assumed, unknown or missing. Returns nullopt, after an error, if a required part is missing.
/// After an error about a misspelled name, the suggested part is used.
std::optional<Parts> find_parts(const XmlContext& context, const XmlTag& tag,
                                const Signature& signature);
/// Reports an error about missing parts.
void report_missing(const XmlContext& context, const XmlTag& tag, const Signature& signature,
                    const Parts& parts);

/// Warns if the attributes are not in the order of `in_order`, because programs that only use the
/// order would read other values. Null parts are missing. `names`: of the parts, in the format.
void report_order(const XmlContext& context, const XmlTag& tag,
                  std::span<const XmlAttribute* const> in_order,
                  std::span<const std::string_view> names);

/// Each of these returns false, after an error, if an attribute is missing or not a number; the
/// numbers that could not be read are then 0. They write in place because the processor stalls when
/// a struct is copied that was just written part by part.
bool read_number(const XmlContext& context, const XmlTag& tag, const XmlAttribute& attribute,
                 float& number);
/// The numbers of the first parts; 0 for null ones.
bool read_numbers(const XmlContext& context, const XmlTag& tag, const Parts& parts,
                  std::span<float> numbers);
bool read_single(const XmlContext& context, const XmlTag& tag, float& number);
/// A vector, a color or coefficients.
bool read_three(const XmlContext& context, const XmlTag& tag, ValueKind kind, glm::vec3& value);
bool read_matrix_row(const XmlContext& context, const XmlTag& tag, glm::vec4& row);
/// Returns nullopt after an error if the attribute is missing.
std::optional<std::string_view> read_word(const XmlContext& context, const XmlTag& tag);

/// The kind of value that elements of this name have; nullopt if they have none.
std::optional<ValueKind> kind_of_element(std::string_view element);

/// Suggests attributes for text between the tags of the element, such as `<pos x="1" y="2" z="3"/>`
/// for 1 2 3; empty if there is no suggestion.
std::string as_attributes(std::string_view element, std::string_view text);

/// Reports an error about a missing attribute and the unknown one that was probably meant to be it.
/// `certain`: of the correction.
void report_meant(const XmlContext& context, const XmlTag& tag, const XmlAttribute& attribute,
                  std::string_view missing, bool certain);

/// Reports an attribute that the format does not have; suggests the nearest of `known`.
void report_unknown_attribute(const XmlContext& context, const XmlTag& tag,
                              const XmlAttribute& attribute,
                              std::span<const std::string_view> known);

}  // namespace scenefile
