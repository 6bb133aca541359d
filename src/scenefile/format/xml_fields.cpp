#include "scenefile/format/xml_fields.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/foreign_names.h"
#include "scenefile/format/xml_values.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// Whether the format has an element with that name, not counting aliases.
bool is_known(std::string_view name) {
  return std::find(std::begin(structure_elements), std::end(structure_elements), name) !=
             std::end(structure_elements) ||
         is_transform(name) || kind_of_element(name);
}

// The parent of an element, for one that is in another; empty if several parents are possible.
std::string_view home_of(std::string_view name) {
  if (is_transform(name)) {
    return "; transforms belong in a transblock, before its object";
  }
  constexpr std::pair<std::string_view, std::string_view> homes[] = {
      {"transblock", "; transblocks belong in trees"},
      {"object", "; an object belongs in a transblock of a tree"},
      {"globaldata", "; it belongs at the top level, in <scenefile>"},
      {"cameradata", "; it belongs at the top level, in <scenefile>"},
      {"lightdata", "; it belongs at the top level, in <scenefile>"},
      {"diffuse", "; it belongs in the primitive that it colors"},
      {"texture", "; it belongs in the primitive that it covers"}};
  const auto* const found = std::find_if(std::begin(homes), std::end(homes),
                                         [&](const auto& home) { return home.first == name; });
  return found == std::end(homes) ? std::string_view() : found->second;
}

// The name without a namespace prefix.
std::string_view local_name(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::vector<std::string_view> words_of(std::span<const FieldName> names) {
  std::vector<std::string_view> words;
  words.reserve(names.size());
  for (const FieldName& n : names) {
    words.push_back(n.name);
  }
  return words;
}

std::string_view translated(std::string_view name, std::span<const FieldName> names) {
  return translated_name(name, words_of(names));
}

std::string_view nearest_field(std::string_view name, std::span<const FieldName> names) {
  const std::string_view near = nearest_name(local_name(name), words_of(names));
  const std::string_view meant = translated(name, names);
  return near.empty() || meant.empty() ? near : meant;
}

std::optional<std::size_t> field_of(std::string_view name, std::span<const FieldName> names) {
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const FieldName& n) { return n.name == name; });
  return found == names.end() ? std::nullopt : std::optional(found->field);
}

std::string_view canonical_name(std::span<const FieldName> names, std::size_t field) {
  for (const FieldName& n : names) {
    if (n.field == field && !n.alias) {
      return n.name;
    }
  }
  return {};
}

}  // namespace

void report_unknown_element(const XmlContext& context, const XmlTag& tag, std::string_view block,
                            std::span<const FieldName> names) {
  const std::string where = element_text(block);
  if (is_known(tag.name)) {
    const std::string_view usual = translated(tag.name, names);
    const std::string meant = did_you_mean(usual, "<>");
    context.report("xml.misplaced-element"_code, tag,
                   fmt::format("{} does not belong in {}; it was ignored{}", element_text(tag.name),
                               where, meant.empty() ? home_of(tag.name) : meant),
                   correction(tag.name, usual));
    return;
  }
  const auto* const shape =
      std::find_if(std::begin(shape_words), std::end(shape_words),
                   [&](std::string_view word) { return equal_ignoring_case(word, tag.name); });
  if (shape != std::end(shape_words)) {
    const std::string object = fmt::format("object type=\"primitive\" name=\"{}\"", *shape);
    context.report("xml.unknown-element"_code, tag,
                   fmt::format("unknown element {} in {}; it was ignored: write <{}/>",
                               element_text(tag.name), where, object),
                   Correction{std::string(tag.name), object, block == "transblock"});
    return;
  }
  const std::string_view near = nearest_field(tag.name, names);
  if (near.empty()) {
    const std::string_view usual = translated(tag.name, names);
    context.report("xml.unknown-element"_code, tag,
                   fmt::format("unknown element {} in {}; it was ignored{}", element_text(tag.name),
                               where, did_you_mean(usual, "<>")),
                   correction(tag.name, usual));
    return;
  }
  context.report("xml.misspelled-element"_code, tag,
                 fmt::format("unknown element {} in {}{}", element_text(tag.name), where,
                             did_you_mean(near, "<>")),
                 correction(tag.name, near, words_of(names)));
}

std::optional<std::size_t> find_field(const XmlContext& context, const XmlTag& tag,
                                      std::span<const FieldName> names, std::string_view block) {
  for (const FieldName& n : names) {
    if (same_name(n.name, tag.name)) {
      if (n.alias) {
        context.report(
            "xml.alias-element"_code, tag,
            fmt::format("{} in {} was read as {}", element_text(tag.name), element_text(block),
                        element_text(canonical_name(names, n.field))),
            correction(tag.name, canonical_name(names, n.field)));
      }
      return n.field;
    }
  }
  for (const FieldName& n : names) {
    if (equal_ignoring_case(n.name, tag.name)) {
      context.report("xml.name-case"_code, tag,
                     fmt::format("{} in {} was read as {}", element_text(tag.name),
                                 element_text(block), element_text(n.name)),
                     correction(tag.name, n.name));
      return n.field;
    }
  }
  report_unknown_element(context, tag, block, names);
  return is_known(tag.name) ? std::nullopt : field_of(nearest_field(tag.name, names), names);
}

void expect_no_attributes(const XmlContext& context, const XmlTag& tag) {
  for (const XmlAttribute& attribute : tag.attributes) {
    report_block_attribute(context, tag, attribute, {});
  }
}

void report_block_attribute(const XmlContext& context, const XmlTag& tag,
                            const XmlAttribute& attribute,
                            std::span<const std::string_view> known) {
  if (!is_known(attribute.name)) {
    report_unknown_attribute(context, tag, attribute, known);
    return;
  }
  context.report("xml.unknown-attribute"_code, attribute,
                 fmt::format("attribute {} of {} has no effect; write it as an element inside",
                             attribute.name, element_text(tag.name)));
}

void SeenFields::note(const XmlContext& context, const XmlTag& tag, std::size_t field) {
  if (has(field)) {
    context.report("xml.duplicate-element"_code, tag,
                   fmt::format("{} is given again, after line {}; this one counts",
                               element_text(tag.name), places_[field].line));
  }
  places_[field] = tag.location;
}

}  // namespace scenefile
