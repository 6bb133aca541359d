#include "scenefile/format/xml_values.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace scenefile {

namespace {

constexpr AttributeForm single_forms[] = {
    {{"v"}}, {{"value"}, true}, {{"val"}, true}, {{"n"}, true}};
constexpr AttributeForm word_forms[] = {
    {{"v"}}, {{"value"}, true}, {{"id"}, true}, {{"thing"}, true}};
constexpr AttributeForm vector_forms[] = {{{"x", "y", "z"}}};
constexpr AttributeForm color_forms[] = {{{"r", "g", "b"}, false, "a"},
                                         {{"x", "y", "z"}, true, "w"}};
constexpr AttributeForm attenuation_forms[] = {
    {{"v1", "v2", "v3"}}, {{"x", "y", "z"}}, {{"a", "b", "c"}}};
constexpr AttributeForm row_forms[] = {{{"a", "b", "c", "d"}}, {{"v1", "v2", "v3", "v4"}}};

constexpr AttributeForm rotate_forms[] = {{{"x", "y", "z", "angle"}}, {{"x", "y", "z", "a"}, true}};

struct FoundForm {
  Parts parts{};
  std::size_t count = 0;
  bool dialect = false;
};

// Of attributes whose names differ only in letter case the one in that of the form.
const XmlAttribute* find_name(const XmlTag& tag, std::string_view name, bool any_case) {
  const XmlAttribute* const exact = tag.find(name);
  if (exact != nullptr || !any_case) {
    return exact;
  }
  const auto found =
      std::find_if(tag.attributes.begin(), tag.attributes.end(),
                   [&](const XmlAttribute& a) { return equal_ignoring_case(a.name, name); });
  return found == tag.attributes.end() ? nullptr : &*found;
}

FoundForm find_form(const XmlTag& tag, const AttributeForm& form, std::size_t parts,
                    bool any_case) {
  FoundForm found;
  found.dialect = form.dialect;
  for (std::size_t i = 0; i < parts; ++i) {
    found.parts[i] = find_name(tag, form.names[i], any_case);
    found.count += found.parts[i] != nullptr;
  }
  return found;
}

// The form with the most matching names; missing parts are taken from other forms.
FoundForm find_best_form(const XmlTag& tag, const Signature& signature, bool any_case) {
  FoundForm best;
  for (const AttributeForm& form : signature.forms) {
    const FoundForm found = find_form(tag, form, signature.parts, any_case);
    best = found.count > best.count ? found : best;
  }
  if (best.count == 0 || best.count == signature.parts) {
    return best;
  }
  for (const AttributeForm& form : signature.forms) {
    const FoundForm found = find_form(tag, form, signature.parts, any_case);
    for (std::size_t i = 0; i < signature.parts; ++i) {
      if (best.parts[i] == nullptr && found.parts[i] != nullptr) {
        best.parts[i] = found.parts[i];
        best.dialect = true;
        ++best.count;
      }
    }
  }
  return best;
}

// The parts' names for messages: "r, g, b".
std::string names_text(const Signature& signature) {
  const auto& names = signature.forms.front().names;
  return fmt::format("{}", fmt::join(names.begin(), names.begin() + signature.parts, ", "));
}

std::vector<std::string_view> missing_names(const Signature& signature, const Parts& parts) {
  // In the form that the author started to use.
  const AttributeForm* form = &signature.forms.front();
  for (const AttributeForm& candidate : signature.forms) {
    for (std::size_t i = 0; i < signature.parts; ++i) {
      if (parts[i] != nullptr && equal_ignoring_case(parts[i]->name, candidate.names[i]) &&
          form->names[i] != candidate.names[i]) {
        form = &candidate;
      }
    }
  }
  std::vector<std::string_view> missing;
  for (std::size_t i = 0; i < signature.parts; ++i) {
    if (parts[i] == nullptr) {
      missing.push_back(form->names[i]);
    }
  }
  return missing;
}

// The form that names the part so, in any letter case; null if none does.
const AttributeForm* form_of(const Signature& signature, std::size_t part, std::string_view name) {
  const auto found = std::find_if(
      signature.forms.begin(), signature.forms.end(),
      [&](const AttributeForm& form) { return equal_ignoring_case(form.names[part], name); });
  return found == signature.forms.end() ? nullptr : &*found;
}

// The format's names of all parts, of missing ones as in missing_names().
std::vector<std::string_view> names_of_parts(const Signature& signature, const Parts& parts) {
  const std::vector<std::string_view> missing = missing_names(signature, parts);
  std::vector<std::string_view> names;
  auto next = missing.begin();
  for (std::size_t i = 0; i < signature.parts; ++i) {
    const AttributeForm* const form =
        parts[i] != nullptr ? form_of(signature, i, parts[i]->name) : nullptr;
    names.push_back(parts[i] == nullptr ? *next++
                    : form != nullptr   ? form->names[i]
                                        : parts[i]->name);
  }
  return names;
}

std::size_t index_of_part(const Signature& signature, std::string_view name) {
  for (const AttributeForm& form : signature.forms) {
    for (std::size_t i = 0; i < signature.parts; ++i) {
      if (form.names[i] == name) {
        return i;
      }
    }
  }
  return 0;
}

bool is_part(const Parts& parts, const XmlAttribute& attribute) {
  return std::find(parts.begin(), parts.end(), &attribute) != parts.end();
}

bool is_alpha(const Signature& signature, const XmlAttribute& attribute) {
  return std::any_of(signature.forms.begin(), signature.forms.end(),
                     [&](const AttributeForm& form) {
                       return !form.alpha.empty() && form.alpha == attribute.name;
                     });
}

std::vector<const XmlAttribute*> unknown_attributes(const XmlTag& tag, const Signature& signature,
                                                    const Parts& parts) {
  std::vector<const XmlAttribute*> unknown;
  for (const XmlAttribute& attribute : tag.attributes) {
    if (!is_part(parts, attribute) && !is_alpha(signature, attribute)) {
      unknown.push_back(&attribute);
    }
  }
  return unknown;
}

// Reports missing parts that attributes of other names were probably meant to be, which then take
// their places: blue for b, or the only unknown attribute for the only missing part.
void settle_missing(const XmlContext& context, const XmlTag& tag, const Signature& signature,
                    Parts& parts) {
  const std::vector<const XmlAttribute*> unknown = unknown_attributes(tag, signature, parts);
  for (const XmlAttribute* const attribute : unknown) {
    const std::vector<std::string_view> missing = missing_names(signature, parts);
    const bool only = unknown.size() == 1 && missing.size() == 1;
    const auto begins_with = [&](std::string_view name) {
      return equal_ignoring_case(attribute->name.substr(0, name.size()), name);
    };
    const auto part = std::find_if(missing.begin(), missing.end(), [&](std::string_view name) {
      return only || begins_with(name);
    });
    if (part == missing.end() || !nearest_name(attribute->name, missing).empty()) {
      continue;
    }
    // That no other is left over is no evidence of what the author meant.
    report_meant(context, tag, *attribute, *part, begins_with(*part));
    parts[index_of_part(signature, *part)] = attribute;
  }
}

// Reports attributes that are not parts; a misspelled one takes the place of a missing part.
void settle_others(const XmlContext& context, const XmlTag& tag, const Signature& signature,
                   Parts& parts) {
  settle_missing(context, tag, signature, parts);
  for (const XmlAttribute& attribute : tag.attributes) {
    if (is_part(parts, attribute)) {
      continue;
    }
    const std::string_view near = nearest_name(attribute.name, missing_names(signature, parts));
    if (is_alpha(signature, attribute)) {
      context.report("xml.color-alpha"_code, attribute,
                     fmt::format("attribute {} of {} has no effect: a color has three parts",
                                 attribute.name, element_text(tag.name)));
    } else if (!near.empty()) {
      context.report("xml.misspelled-attribute"_code, attribute,
                     fmt::format("unknown attribute {} of {}{}", escaped(attribute.name, 40),
                                 element_text(tag.name), did_you_mean(near)),
                     correction(attribute.name, near, missing_names(signature, parts)));
      parts[index_of_part(signature, near)] = &attribute;
    } else {
      report_unknown_attribute(context, tag, attribute, {});
    }
  }
}

bool any_near(const XmlTag& tag, const Signature& signature, const Parts& parts) {
  const std::vector<std::string_view> missing = missing_names(signature, parts);
  return std::any_of(tag.attributes.begin(), tag.attributes.end(), [&](const XmlAttribute& a) {
    return !is_part(parts, a) && !nearest_name(a.name, missing).empty();
  });
}

// Accepts other names for the last part, or for all parts but the last, if the rest have their
// proper names. Returns whether it did.
bool take_rest(const XmlContext& context, const XmlTag& tag, const Signature& signature,
               Parts& parts) {
  const std::size_t last = signature.parts - 1;
  const auto count = std::count(parts.begin(), parts.begin() + signature.parts, nullptr);
  const bool only_last = count == 1 && parts[last] == nullptr;
  const bool all_others = count == static_cast<std::ptrdiff_t>(last) && parts[last] != nullptr;
  if ((!only_last && !all_others) || tag.attributes.size() != signature.parts ||
      any_near(tag, signature, parts)) {
    return false;
  }
  const std::vector<std::string_view> missing = missing_names(signature, parts);
  std::vector<std::string> taken;
  std::size_t next = only_last ? last : 0;
  for (const XmlAttribute& attribute : tag.attributes) {
    if (!is_part(parts, attribute)) {
      taken.push_back(escaped(attribute.name, 40));
      parts[next++] = &attribute;
    }
  }
  context.report(only_last ? "xml.alias-attribute"_code : "xml.positional-attributes"_code,
                 *parts[only_last ? last : 0],
                 fmt::format("attribute{} {} of {} {} read as {}", only_last ? "" : "s",
                             fmt::join(taken, ", "), element_text(tag.name),
                             only_last ? "was" : "were", fmt::join(missing, ", ")),
                 only_last ? correction(parts[last]->name, missing[0]) : std::nullopt);
  return true;
}

// Whether no attribute has any of the format's names for the parts.
bool all_names_foreign(const XmlTag& tag, const Signature& signature) {
  return std::all_of(tag.attributes.begin(), tag.attributes.end(), [&](const XmlAttribute& a) {
    return std::all_of(
        signature.forms.begin(), signature.forms.end(), [&](const AttributeForm& form) {
          return form.dialect ||
                 std::find(form.names.begin(), form.names.end(), a.name) == form.names.end();
        });
  });
}

constexpr std::string_view list_separators = " \t\r\n,;";

// The numbers in "1 2 3", "1,2,3", or for a color #rrggbb, as text; empty for anything else.
std::vector<std::string> numbers_in(std::string_view value, bool is_color) {
  constexpr std::string_view hexadecimal = "0123456789abcdefABCDEF";
  std::vector<std::string> numbers;
  if (is_color && value.size() == 7 && value[0] == '#' &&
      value.find_first_not_of(hexadecimal, 1) == std::string_view::npos) {
    for (std::size_t i = 1; i < value.size(); i += 2) {
      const int part = std::stoi(std::string(value.substr(i, 2)), nullptr, 16);
      numbers.push_back(fmt::format("{:.3g}", part / 255.0));
    }
    return numbers;
  }
  for (std::size_t at = 0; (at = value.find_first_not_of(list_separators, at)) != value.npos;) {
    const std::size_t end = std::min(value.find_first_of(list_separators, at), value.size());
    const std::string_view word = value.substr(at, end - at);
    if (parse_number(word).error != NumberError::none || numbers.size() == 4) {
      return {};
    }
    numbers.emplace_back(word);
    at = end;
  }
  return numbers;
}

// Whether one separator is between all numbers: "1,5 2" may be two numbers or three.
bool is_plain_list(std::string_view value) {
  std::optional<std::string> first;
  for (std::size_t at = 0; (at = value.find_first_of(list_separators, at)) != value.npos;) {
    const std::size_t end = std::min(value.find_first_not_of(list_separators, at), value.size());
    std::string separator(value.substr(at, end - at));
    std::erase_if(separator, [](char c) { return blanks.find(c) != blanks.npos; });
    const bool between = at != 0 && end != value.size();
    if (between && separator != first.value_or(separator)) {
      return false;
    }
    first = between ? std::move(separator) : first;
    at = end;
  }
  return true;
}

// Reports all parts in a single attribute, and how to write them. Returns false if that is not the
// case.
bool report_one_for_all(const XmlContext& context, const XmlTag& tag, const Signature& signature,
                        const Parts& parts) {
  const auto& names = signature.forms.front().names;
  const bool is_color = names[0] == "r";
  if (signature.parts == 1 || tag.attributes.size() != 1) {
    return false;
  }
  const XmlAttribute& attribute = tag.attributes[0];
  std::vector<std::string> numbers = numbers_in(attribute.value, is_color);
  const bool listed = numbers.size() == signature.parts;
  if (numbers.size() == 1 && !is_part(parts, attribute) &&
      (is_color || equal_ignoring_case(tag.name, transform_word<Scale>))) {
    numbers.resize(signature.parts, numbers[0]);
  }
  if (numbers.size() != signature.parts) {
    return false;
  }
  std::string meant;
  for (std::size_t i = 0; i < signature.parts; ++i) {
    meant += fmt::format("{}{}=\"{}\"", i == 0 ? "" : " ", names[i], numbers[i]);
  }
  const bool certain = listed && attribute.value[0] != '#' && is_plain_list(attribute.value);
  context.report("xml.missing-attribute"_code, tag,
                 fmt::format("{} is missing the attributes {}; write {}", element_text(tag.name),
                             fmt::join(missing_names(signature, parts), ", "), meant),
                 Correction{std::string(attribute.name), meant, certain});
  return true;
}

// The attributes in their order. Made in place: see read_number().
std::optional<Parts> all_attributes(const XmlTag& tag) {
  std::optional<Parts> parts(std::in_place);
  for (std::size_t i = 0; i < tag.attributes.size(); ++i) {
    (*parts)[i] = &tag.attributes[i];
  }
  return parts;
}

// All attributes in order, as programs read them that ignore the names.
std::optional<Parts> by_order(const XmlContext& context, const XmlTag& tag,
                              const Signature& signature) {
  const XmlAttribute& first = tag.attributes.front();
  if (signature.parts == 1) {
    context.report("xml.alias-attribute"_code, first,
                   fmt::format("attribute {} of {} was read as {}", escaped(first.name, 40),
                               element_text(tag.name), names_text(signature)),
                   correction(first.name, signature.forms.front().names[0]));
  } else {
    context.report("xml.positional-attributes"_code, first,
                   fmt::format("the attributes of {} were read in their order, as {}",
                               element_text(tag.name), names_text(signature)));
  }
  return all_attributes(tag);
}

// Reports the parts that have a name of the format but for its letter case. Those that also have
// another name are left to report_alias().
void report_case(const XmlContext& context, const XmlTag& tag, const Signature& signature,
                 const Parts& parts) {
  for (std::size_t i = 0; i < signature.parts; ++i) {
    const AttributeForm* const form =
        parts[i] != nullptr ? form_of(signature, i, parts[i]->name) : nullptr;
    if (form != nullptr && !form->dialect && parts[i]->name != form->names[i]) {
      context.report("xml.name-case"_code, *parts[i],
                     fmt::format("attribute {} of {} was read as {}", parts[i]->name,
                                 element_text(tag.name), form->names[i]),
                     correction(parts[i]->name, form->names[i]));
    }
  }
}

void report_alias(const XmlContext& context, const XmlTag& tag, const Signature& signature,
                  const Parts& parts) {
  const AttributeForm& canonical = signature.forms.front();
  for (std::size_t i = 0; i < signature.parts; ++i) {
    if (parts[i] != nullptr && !equal_ignoring_case(parts[i]->name, canonical.names[i])) {
      context.report("xml.alias-attribute"_code, *parts[i],
                     fmt::format("attribute {} of {} was read as {}", parts[i]->name,
                                 element_text(tag.name), canonical.names[i]),
                     correction(parts[i]->name, canonical.names[i]));
      return;
    }
  }
}

// A fast check for the usual case: exactly the canonical names, in order.
bool is_canonical(const XmlTag& tag, const Signature& signature) {
  if (tag.attributes.size() != signature.parts) {
    return false;
  }
  for (std::size_t i = 0; i < signature.parts; ++i) {
    if (!same_name(tag.attributes[i].name, signature.forms.front().names[i])) {
      return false;
    }
  }
  return true;
}

std::string number_hint(std::string_view written, std::string_view meant) {
  const std::string word = lower_case(written);
  if (word.ends_with("rad") || word.ends_with("radians")) {
    return "; angles are in degrees, without a unit";
  }
  return meant.empty() ? "; numbers are written like 1.5 or -2e3" : did_you_mean(meant);
}

template <typename Owner, std::size_t N>
void find_kind(const ValueRow<Owner> (&rows)[N], std::string_view element,
               std::optional<ValueKind>& kind) {
  for (const ValueRow<Owner>& row : rows) {
    if (!kind && row.xml == element && !element.empty()) {
      kind = row.kind;
    }
  }
}

}  // namespace

Signature signature_of(ValueKind kind) {
  switch (kind) {
    case ValueKind::number:
      return {single_forms, 1};
    case ValueKind::id:
    case ValueKind::choice:
    case ValueKind::text:
    case ValueKind::file:
      return {word_forms, 1};
    case ValueKind::color:
      return {color_forms, 3};
    case ValueKind::coefficients:
      return {attenuation_forms, 3};
    case ValueKind::rotation:
      return {rotate_forms, 4, true, true};
    case ValueKind::matrix:
      return {row_forms, 4};
    case ValueKind::vector:
    case ValueKind::image:
      break;
  }
  return {vector_forms, 3};
}

std::string element_text(std::string_view name) {
  return fmt::format("<{}>", escaped(name, 40));
}

std::span<const std::string_view> part_names(ValueKind kind) {
  const Signature signature = signature_of(kind);
  const auto& form = signature.parts == 3 ? signature.forms.front() : vector_forms[0];
  return std::span(form.names).first(3);
}

std::string did_you_mean(std::string_view name, std::string_view mark) {
  if (name.empty()) {
    return {};
  }
  const bool marked = mark.size() == 2;
  return fmt::format("; did you mean {}{}{}?", mark.substr(0, marked), name,
                     mark.substr(marked ? 1 : 0));
}

void report_unknown_attribute(const XmlContext& context, const XmlTag& tag,
                              const XmlAttribute& attribute,
                              std::span<const std::string_view> known) {
  const std::string_view near = nearest_name(attribute.name, known);
  context.report(
      "xml.unknown-attribute"_code, attribute,
      fmt::format("unknown attribute {} of {} has no effect{}", escaped(attribute.name, 40),
                  element_text(tag.name), did_you_mean(near)),
      correction(attribute.name, near, known));
}

void report_meant(const XmlContext& context, const XmlTag& tag, const XmlAttribute& attribute,
                  std::string_view missing, bool certain) {
  context.report("xml.missing-attribute"_code, tag,
                 fmt::format("{} is missing the attribute {}; the unknown attribute {} is probably "
                             "meant to be it: write {}=\"{}\"",
                             element_text(tag.name), missing, escaped(attribute.name, 40), missing,
                             escaped(attribute.value, 60)),
                 Correction{std::string(attribute.name), std::string(missing), certain});
}

std::optional<ValueKind> kind_of_element(std::string_view element) {
  std::optional<ValueKind> kind;
  find_kind(global_rows, element, kind);
  find_kind(camera_rows, element, kind);
  find_kind(light_rows, element, kind);
  find_kind(material_rows, element, kind);
  return kind;
}

std::string as_attributes(std::string_view element, std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  const std::string word(text.substr(first, text.find_last_not_of(blanks) + 1 - first));
  std::vector<std::string> numbers = numbers_in(text, true);
  std::vector<std::string_view> names;
  const ValueKind kind = kind_of_element(element).value_or(ValueKind::vector);
  if (kind == ValueKind::image) {
    names = {"file"};
    numbers = {word};
  } else if (numbers.size() <= 1) {
    names = {"v"};
    numbers = {word};
  } else if (numbers.size() == 3) {
    const auto form = part_names(kind);
    names.assign(form.begin(), form.begin() + 3);
  } else if (numbers.size() == 4 && element == transform_word<Rotate>) {
    names = {"x", "y", "z", "angle"};
  }
  if (names.size() != numbers.size() || word.empty() || word.size() > 60 ||
      word.find_first_of("<>&\"\n\r") != std::string::npos) {
    return {};
  }
  std::string written = fmt::format("<{}", element);
  for (std::size_t i = 0; i < names.size(); ++i) {
    written += fmt::format(" {}=\"{}\"", names[i], escaped(numbers[i], 60));
  }
  return written + "/>";
}

void report_missing(const XmlContext& context, const XmlTag& tag, const Signature& signature,
                    const Parts& parts) {
  const std::vector<std::string_view> missing = missing_names(signature, parts);
  context.report("xml.missing-attribute"_code, tag,
                 fmt::format("{} is missing the attribute{} {}", element_text(tag.name),
                             missing.size() == 1 ? "" : "s", fmt::join(missing, ", ")));
}

std::optional<Parts> find_parts(const XmlContext& context, const XmlTag& tag,
                                const Signature& signature) {
  if (is_canonical(tag, signature)) {
    return all_attributes(tag);
  }
  FoundForm found = find_best_form(tag, signature, false);
  // A single attribute may have any name, and the course's programs use only the order.
  if (found.count < signature.parts && signature.parts > 1 && !context.options.compat_course) {
    found = find_best_form(tag, signature, true);
  }
  if (found.count < signature.parts && tag.attributes.size() == signature.parts &&
      all_names_foreign(tag, signature)) {
    return by_order(context, tag, signature);
  }
  if (found.count <= 1 && report_one_for_all(context, tag, signature, found.parts)) {
    return std::nullopt;
  }
  if (found.dialect) {
    report_alias(context, tag, signature, found.parts);
  }
  report_case(context, tag, signature, found.parts);
  const bool by_order_too = signature.free_names && take_rest(context, tag, signature, found.parts);
  const std::vector<std::string_view> names = names_of_parts(signature, found.parts);
  settle_others(context, tag, signature, found.parts);
  const auto end = found.parts.begin() + static_cast<std::ptrdiff_t>(signature.parts);
  if (!signature.optional && std::find(found.parts.begin(), end, nullptr) != end) {
    report_missing(context, tag, signature, found.parts);
    return std::nullopt;
  }
  if (!by_order_too) {
    report_order(context, tag, std::span(found.parts).first(signature.parts), names);
  }
  return found.parts;
}

void report_order(const XmlContext& context, const XmlTag& tag,
                  std::span<const XmlAttribute* const> in_order,
                  std::span<const std::string_view> names) {
  Parts wanted{};
  const auto end = std::remove_copy(in_order.begin(), in_order.end(), wanted.begin(), nullptr);
  // Attributes are stored in the order of the text, so pointers can be compared.
  if (std::is_sorted(wanted.begin(), end)) {
    return;
  }
  Parts written = wanted;
  std::stable_sort(written.begin(), written.begin() + (end - wanted.begin()));
  const auto other = std::mismatch(
      wanted.begin(), end, written.begin(),
      [](const XmlAttribute* a, const XmlAttribute* b) { return a->value == b->value; });
  if (other.first == end) {
    return;
  }
  std::vector<std::string_view> present;
  for (std::size_t i = 0; i < in_order.size(); ++i) {
    if (in_order[i] != nullptr) {
      present.push_back(names[i]);
    }
  }
  context.report("xml.attribute-order"_code, **other.second,
                 fmt::format("the attributes of {} were read by their names; programs that use "
                             "their order differ: write them in the order {}",
                             element_text(tag.name), fmt::join(present, ", ")));
}

bool read_number(const XmlContext& context, const XmlTag& tag, const XmlAttribute& attribute,
                 float& number) {
  const ParsedNumber parsed = parse_number(attribute.value);
  number = parsed.error == NumberError::none ? static_cast<float>(parsed.value) : 0;
  if (parsed.error == NumberError::none && !underflows(attribute.value, number)) {
    return true;
  }
  const std::string what =
      fmt::format("attribute {} of {}", escaped(attribute.name, 40), element_text(tag.name));
  const std::string value = quoted(attribute.value);
  switch (parsed.error) {
    case NumberError::none:
      context.report(
          "xml.number-underflow"_code, attribute,
          fmt::format("{}: {} is too small for a number here; it counts as 0", what, value));
      return true;
    case NumberError::empty:
      context.report("xml.empty-number"_code, attribute, what + " is empty; it counts as 0");
      return true;
    case NumberError::out_of_range:
      context.report("xml.number-range"_code, attribute,
                     fmt::format("{}: {} is too large for a number", what, value));
      return false;
    case NumberError::malformed:
      break;
  }
  const std::string meant = nearest_number(attribute.value);
  if (!context.options.compat_course) {
    context.report(
        "xml.number"_code, attribute,
        fmt::format("{}: {} is not a number{}", what, value, number_hint(attribute.value, meant)),
        number_correction(attribute.value, meant));
    return false;
  }
  number = static_cast<float>(parsed.value);
  context.diagnostics.add(
      {&"xml.number"_code,
       Severity::warning,
       context.place(attribute),
       {},
       fmt::format("{}: {} is not a number; it was read as {}", what, value, number_text(number)),
       {},
       number_correction(attribute.value, meant)});
  return true;
}

bool read_numbers(const XmlContext& context, const XmlTag& tag, const Parts& parts,
                  std::span<float> numbers) {
  bool all_known = true;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = 0;
    all_known =
        (parts[i] == nullptr || read_number(context, tag, *parts[i], numbers[i])) && all_known;
  }
  return all_known;
}

bool read_single(const XmlContext& context, const XmlTag& tag, float& number) {
  const std::optional<Parts> parts = find_parts(context, tag, signature_of(ValueKind::number));
  number = 0;
  return parts && read_number(context, tag, *(*parts)[0], number);
}

bool read_three(const XmlContext& context, const XmlTag& tag, ValueKind kind, glm::vec3& value) {
  const std::optional<Parts> parts = find_parts(context, tag, signature_of(kind));
  value = {};
  return parts && read_numbers(context, tag, *parts, {&value.x, 3});
}

bool read_matrix_row(const XmlContext& context, const XmlTag& tag, glm::vec4& row) {
  const std::optional<Parts> parts = find_parts(context, tag, signature_of(ValueKind::matrix));
  row = {};
  return parts && read_numbers(context, tag, *parts, {&row.x, 4});
}

std::optional<std::string_view> read_word(const XmlContext& context, const XmlTag& tag) {
  const std::optional<Parts> parts = find_parts(context, tag, signature_of(ValueKind::choice));
  return parts ? std::optional((*parts)[0]->value) : std::nullopt;
}

}  // namespace scenefile
