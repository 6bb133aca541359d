#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/foreign_names.h"
#include "scenefile/format/xml_blocks.h"
#include "scenefile/format/xml_values.h"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace scenefile {

namespace {

constexpr std::array<std::string_view, 3> type_names = {"tree", "master", "primitive"};

// The index of the name, ignoring case; names.size() if there is none.
template <std::size_t N>
std::size_t index_of(const std::array<std::string_view, N>& names, std::string_view word) {
  std::size_t i = 0;
  while (i < N && !equal_ignoring_case(names[i], word)) {
    ++i;
  }
  return i;
}

void report_case(const XmlContext& context, const XmlAttribute& attribute,
                 std::string_view canonical) {
  if (attribute.value != canonical) {
    context.report(
        xml_name_case, attribute,
        fmt::format("{} {} was read as {}", attribute.name, quoted(attribute.value), canonical));
  }
}

std::optional<ObjectType> read_type(const XmlContext& context, const XmlAttribute& attribute) {
  const std::size_t i = index_of(type_names, attribute.value);
  if (i < type_names.size()) {
    report_case(context, attribute, type_names[i]);
    return static_cast<ObjectType>(i);
  }
  const std::string_view near = nearest_name(attribute.value, type_names);
  const std::string type = quoted(attribute.value);
  const std::size_t shape = index_of(shape_words, attribute.value);
  if (near.empty()) {
    const std::string hint =
        shape == shape_words.size()
            ? did_you_mean(translated_name(attribute.value, type_names))
            : fmt::format("; write type=\"primitive\" name=\"{}\"", shape_words[shape]);
    context.report(
        xml_unknown_object_type, attribute,
        fmt::format("object type {} is not part of the format, so the object was ignored{}", type,
                    hint));
  } else {
    context.report(xml_object_type, attribute,
                   fmt::format("unknown object type {}{}", type, did_you_mean(near)));
    return static_cast<ObjectType>(index_of(type_names, near));
  }
  return std::nullopt;
}

// The attributes by name.
struct Found {
  const XmlAttribute* type = nullptr;
  const XmlAttribute* name = nullptr;
  const XmlAttribute* filename = nullptr;
  const XmlAttribute* meshfile = nullptr;
  std::vector<const XmlAttribute*> others;

  bool is_mesh() const { return name != nullptr && equal_ignoring_case(name->value, "mesh"); }
};

// Finds the attribute, preferring the exact name, otherwise ignoring case, which no program of the
// course accepts.
const XmlAttribute* find_in_any_case(const XmlContext& context, const XmlTag& tag,
                                     std::string_view name) {
  if (const XmlAttribute* exact = tag.find(name)) {
    return exact;
  }
  for (const XmlAttribute& attribute : tag.attributes) {
    if (equal_ignoring_case(attribute.name, name)) {
      context.report(xml_name_case, attribute,
                     fmt::format("attribute {} of <object> was read as {}", attribute.name, name));
      return &attribute;
    }
  }
  return nullptr;
}

Found find_attributes(const XmlContext& context, const XmlTag& tag) {
  Found found;
  found.type = find_in_any_case(context, tag, "type");
  found.name = find_in_any_case(context, tag, "name");
  found.filename = find_in_any_case(context, tag, "filename");
  found.meshfile = find_in_any_case(context, tag, "meshfile");
  for (const XmlAttribute& attribute : tag.attributes) {
    if (&attribute != found.type && &attribute != found.name && &attribute != found.filename &&
        &attribute != found.meshfile) {
      found.others.push_back(&attribute);
    }
  }
  return found;
}

std::vector<std::string_view> missing_names(const Found& found) {
  std::vector<std::string_view> missing;
  if (found.type == nullptr) {
    missing.push_back("type");
  }
  if (found.name == nullptr) {
    missing.push_back("name");
  }
  if (found.is_mesh() && found.filename == nullptr) {
    missing.push_back("filename");
  }
  return missing;
}

// Reports other attributes; a misspelled one takes the place of the missing one.
void settle_others(const XmlContext& context, const XmlTag& tag, Found& found) {
  for (const XmlAttribute* attribute : found.others) {
    const std::string_view near = nearest_name(attribute->name, missing_names(found));
    if (near.empty()) {
      report_unknown_attribute(context, tag, *attribute, {});
      continue;
    }
    context.report(xml_misspelled_attribute, *attribute,
                   fmt::format("unknown attribute {} of <object>{}", escaped(attribute->name, 40),
                               did_you_mean(near)));
    (near == "type" ? found.type : near == "name" ? found.name : found.filename) = attribute;
  }
}

// Moves the file of a mesh to `filename`, under whichever name it was given.
void settle_mesh_file(const XmlContext& context, Found& found) {
  if (found.filename != nullptr && found.meshfile != nullptr) {
    context.report(xml_mesh_files, *found.meshfile,
                   "the mesh has both filename and meshfile; filename counts");
  }
  if (found.filename == nullptr) {
    found.filename = found.meshfile;
  }
  if (found.filename == nullptr && found.is_mesh() && found.others.size() == 1 &&
      found.name != nullptr && found.type != nullptr) {
    found.filename = found.others.front();
    found.others.clear();
    context.report(xml_alias_attribute, *found.filename,
                   fmt::format("attribute {} of <object> was read as filename",
                               escaped(found.filename->name, 40)));
  }
}

bool name_fits(const XmlContext& context, const XmlAttribute* attribute) {
  const std::uint32_t limit = context.options.limits.name_bytes;
  if (attribute == nullptr || attribute->value.size() <= limit) {
    return true;
  }
  context.report(xml_length_limit, *attribute,
                 fmt::format("attribute {} of <object> is longer than the limit of {} bytes",
                             escaped(attribute->name, 40), limit));
  return false;
}

}  // namespace

std::optional<ObjectTag> read_object_tag(const XmlContext& context, const XmlTag& tag) {
  Found found = find_attributes(context, tag);
  settle_mesh_file(context, found);
  settle_others(context, tag, found);
  if (found.type == nullptr) {
    context.report(xml_missing_attribute, tag,
                   "<object> is missing the attribute type: tree, master or primitive");
    return std::nullopt;
  }
  const std::array<const XmlAttribute*, 3> in_order = {found.type, found.name, found.filename};
  report_order(context, tag, in_order);
  const std::optional<ObjectType> type = read_type(context, *found.type);
  if (!type || !name_fits(context, found.name) || !name_fits(context, found.filename)) {
    return std::nullopt;
  }
  ObjectTag object{*type, found.name != nullptr, {}, {}, tag.location, tag.location};
  if (found.name != nullptr) {
    object.name = found.name->value;
    object.name_place = context.place(*found.name);
  }
  if (found.filename != nullptr) {
    object.filename = found.filename->value;
    object.filename_place = context.place(*found.filename);
  }
  return object;
}

std::optional<Shape> read_shape(const XmlContext& context, const XmlTag& tag,
                                const ObjectTag& object) {
  if (!object.has_name) {
    context.report(xml_missing_attribute, tag,
                   "<object type=\"primitive\"> is missing the attribute name, the shape");
    return std::nullopt;
  }
  if (object.name.find_first_not_of(" \t\r\n") == std::string::npos) {
    context.diagnostics.report(
        xml_missing_attribute, object.name_place,
        fmt::format("the attribute name of the primitive is empty; it must say the shape: {}",
                    fmt::join(shape_words, ", ")));
    return std::nullopt;
  }
  std::size_t i = index_of(shape_words, object.name);
  if (i == shape_words.size()) {
    const std::string_view near = nearest_name(object.name, shape_words);
    const std::string shape = quoted(object.name);
    if (near.empty()) {
      context.diagnostics.report(
          xml_unknown_shape, object.name_place,
          fmt::format("shape {} is not part of the format ({}); it is not drawn{}", shape,
                      fmt::join(shape_words, ", "),
                      did_you_mean(translated_name(object.name, shape_words))));
      return std::nullopt;
    }
    context.diagnostics.report(xml_misspelled_shape, object.name_place,
                               fmt::format("unknown shape {}{}", shape, did_you_mean(near)));
    i = index_of(shape_words, near);
  } else if (object.name != shape_words[i]) {
    context.diagnostics.report(
        xml_name_case, object.name_place,
        fmt::format("name {} was read as {}", quoted(object.name), shape_words[i]));
  }
  const auto shape = static_cast<Shape>(i);
  if (shape == Shape::mesh && object.filename.empty()) {
    context.report(xml_missing_attribute, tag,
                   object.filename_place == tag.location
                       ? "the mesh is missing the attribute filename"
                       : "the attribute filename of the mesh is empty");
    return std::nullopt;
  }
  if (shape != Shape::mesh && !object.filename.empty()) {
    context.diagnostics.report(
        xml_unknown_attribute, object.filename_place,
        fmt::format("the file name has no effect: a {} is not a mesh", shape_words[i]));
  }
  return shape;
}

}  // namespace scenefile
