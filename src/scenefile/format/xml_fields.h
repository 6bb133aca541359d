#pragma once
// Which child of a block an element is. Internal to the room.

#include "scenefile/format/xml_context.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace scenefile {

/// A name of a child element; `field` is the same for all names of one child.
struct FieldName {
  std::string_view name;
  std::size_t field = 0;
  bool alias = false;  ///< worth a warning
};

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

}  // namespace scenefile
