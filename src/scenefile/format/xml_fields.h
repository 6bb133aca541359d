#pragma once
// Looks up the children of a block by name. Internal to format.

#include "scenefile/format/xml_values.h"
#include "scenefile/scene/vocabulary.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace scenefile {

/// The name of a child element; aliases have the same `field`.
struct FieldName {
  std::string_view name;
  std::size_t field = 0;
  bool alias = false;  ///< accepted with a warning
};

/// The number of names and aliases in the rows.
template <typename Owner, std::size_t N>
constexpr std::size_t count_names(const ValueRow<Owner> (&rows)[N]) {
  std::size_t count = 0;
  for (const ValueRow<Owner>& row : rows) {
    count += !row.xml.empty() + !row.xml_alias.empty();
  }
  return count;
}

/// Of one block.
inline constexpr std::size_t max_fields = 16;

/// The names of a block's children; `field` is the index of the row.
template <std::size_t Count, typename Owner, std::size_t N>
constexpr std::array<FieldName, Count> names_of(const ValueRow<Owner> (&rows)[N]) {
  static_assert(N <= max_fields);
  std::array<FieldName, Count> names{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < N; ++i) {
    if (!rows[i].xml.empty()) {
      names[next++] = {rows[i].xml, i};
    }
    if (!rows[i].xml_alias.empty()) {
      names[next++] = {rows[i].xml_alias, i, true};
    }
  }
  return names;
}

/// The field of a child element. Reports aliases, misspelled and unknown names. Returns nullopt to
/// skip the element with its contents. `block` is the parent element.
std::optional<std::size_t> find_field(const XmlContext& context, const XmlTag& tag,
                                      std::span<const FieldName> names, std::string_view block);

/// Reports an element that is not allowed in `block`.
void report_unknown_element(const XmlContext& context, const XmlTag& tag, std::string_view block,
                            std::span<const FieldName> names = {});

/// Reports every attribute of an element that should have none.
void expect_no_attributes(const XmlContext& context, const XmlTag& tag);
/// Reports an unknown attribute of a block; suggests a child element, or one of `known`.
void report_block_attribute(const XmlContext& context, const XmlTag& tag,
                            const XmlAttribute& attribute, std::span<const std::string_view> known);

/// The value of an element, for BlockReader.
struct WrittenXml {
  const XmlContext& context;
  const XmlTag& tag;

  Location place() const { return tag.location; }
  bool number(float& number) const { return read_single(context, tag, number); }
  bool three(ValueKind kind, glm::vec3& value) const {
    return read_three(context, tag, kind, value);
  }
};

/// The places of a block's children.
class SeenFields {
 public:
  /// Stores the place of a child; reports a duplicate.
  void note(const XmlContext& context, const XmlTag& tag, std::size_t field);
  bool has(std::size_t field) const { return places_[field].known(); }
  Location place(std::size_t field) const { return places_[field]; }

 private:
  std::array<Location, max_fields> places_{};
};

}  // namespace scenefile
