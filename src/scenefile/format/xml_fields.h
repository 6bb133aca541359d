#pragma once
// Looks up the children of a block by name. Internal to format.

#include "scenefile/format/xml_values.h"
#include "scenefile/scene/vocabulary.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

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

/// What is known of a block's children.
class SeenFields {
 public:
  /// Stores the place of a child; reports a duplicate.
  void note(const XmlContext& context, const XmlTag& tag, std::size_t field);
  bool has(std::size_t field) const { return places_[field].known(); }
  Location place(std::size_t field) const { return places_[field]; }

  /// Whether the last value of the field could not be read.
  void set_unread(std::size_t field, bool unread) { unread_[field] = unread; }
  bool unread(std::size_t field) const { return unread_[field]; }
  bool any_unread() const { return unread_.any(); }

  /// For another block that adds to the values of this one.
  void forget_places() { places_ = {}; }

 private:
  std::array<Location, max_fields> places_{};
  std::bitset<max_fields> unread_;
};

/// Reads the number or the three numbers of an element into the member of its row, `rows[field]`;
/// after an error, the member gets its default. The caller handles rows of other kinds.
template <typename Owner, std::size_t N>
void read_value(const XmlContext& context, const XmlTag& tag, const ValueRow<Owner> (&rows)[N],
                std::size_t field, SeenFields& seen, Owner& owner) {
  const ValueRow<Owner>& row = rows[field];
  const auto note = [&](const auto member, bool known) {
    static const Owner defaults;
    if (!known) {
      owner.*member = defaults.*member;
    }
    seen.set_unread(field, !known);
  };
  if (const auto* const number = std::get_if<float Owner::*>(&row.member)) {
    note(*number, read_single(context, tag, owner.**number));
  } else if (const auto* const optional = std::get_if<std::optional<float> Owner::*>(&row.member)) {
    note(*optional, read_single(context, tag, (owner.**optional).emplace()));
  } else if (const auto* const vector = std::get_if<glm::vec3 Owner::*>(&row.member)) {
    note(*vector, read_three(context, tag, row.kind, owner.**vector));
  }
}

/// The values that could not be read.
template <typename Owner, std::size_t N>
FieldSet unread_fields(const ValueRow<Owner> (&rows)[N], const SeenFields& seen) {
  FieldSet fields;
  for (std::size_t i = 0; seen.any_unread() && i < N; ++i) {
    if (seen.unread(i)) {
      fields.insert(*rows[i].field);
    }
  }
  return fields;
}

/// Stores the places of the children that findings can refer to.
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
