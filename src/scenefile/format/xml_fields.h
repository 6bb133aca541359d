#pragma once
// Which child of a block an element is. Internal to the room.

#include "scenefile/format/xml_context.h"
#include "scenefile/format/xml_values.h"
#include "scenefile/scene/vocabulary.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

namespace scenefile {

/// A name of a child element; `field` is the same for all names of one child.
struct FieldName {
  std::string_view name;
  std::size_t field = 0;
  bool alias = false;  ///< worth a warning
};

/// How many elements and aliases the rows name.
template <typename Owner, std::size_t N>
constexpr std::size_t count_names(const ValueRow<Owner> (&rows)[N]) {
  std::size_t count = 0;
  for (const ValueRow<Owner>& row : rows) {
    count += !row.xml.empty() + !row.xml_alias.empty();
  }
  return count;
}

/// The names of a block's children; `field` is the index of the row.
template <std::size_t Count, typename Owner, std::size_t N>
constexpr std::array<FieldName, Count> names_of(const ValueRow<Owner> (&rows)[N]) {
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

/// Reads the number or the three numbers of an element into the member of its row; `not_known`
/// after an error. Rows of other kinds are for the caller.
template <typename Owner>
void read_value(const XmlContext& context, const XmlTag& tag, const ValueRow<Owner>& row,
                Owner& owner) {
  if (const auto* const number = std::get_if<float Owner::*>(&row.member)) {
    owner.** number = read_single(context, tag).value_or(not_known);
  } else if (const auto* const optional = std::get_if<std::optional<float> Owner::*>(&row.member)) {
    owner.** optional = read_single(context, tag).value_or(not_known);
  } else if (const auto* const vector = std::get_if<glm::vec3 Owner::*>(&row.member)) {
    owner.** vector = read_three(context, tag, row.kind).value_or(glm::vec3(not_known));
  }
}

/// The child that the element is, or nothing when it is to be left out with everything in it;
/// reports names that are not as they should be. `block` is the element around it.
std::optional<std::size_t> find_field(const XmlContext& context, const XmlTag& tag,
                                      std::span<const FieldName> names, std::string_view block);

/// Reports an element that may not stand in `block`.
void report_unknown_element(const XmlContext& context, const XmlTag& tag, std::string_view block,
                            std::span<const FieldName> names = {});

/// Reports every attribute of an element that has none.
void expect_no_attributes(const XmlContext& context, const XmlTag& tag);
/// Reports an attribute that a block does not have; suggests an element, or one of `known`.
void report_block_attribute(const XmlContext& context, const XmlTag& tag,
                            const XmlAttribute& attribute, std::span<const std::string_view> known);

/// Where the children of a block stood.
class SeenFields {
 public:
  /// Notes the place of a child; reports it when there was one before.
  void note(const XmlContext& context, const XmlTag& tag, std::size_t field);
  bool has(std::size_t field) const { return places_[field].known(); }
  Location place(std::size_t field) const { return places_[field]; }

 private:
  std::array<Location, 16> places_{};
};

/// Notes where the children stood that findings can be about.
template <typename Owner, std::size_t N>
void add_places(const ValueRow<Owner> (&rows)[N], const SeenFields& seen, Location owner,
                Scene& scene) {
  for (std::size_t i = 0; i < N; ++i) {
    if (rows[i].field && seen.has(i)) {
      scene.field_places.push_back({owner, *rows[i].field, seen.place(i)});
    }
  }
}

}  // namespace scenefile
