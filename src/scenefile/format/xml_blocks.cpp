#include "scenefile/format/xml_blocks.h"

#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/block.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/foreign_names.h"
#include "scenefile/format/xml_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// The index of the word, ignoring case; names.size() if there is none.
template <std::size_t N>
std::size_t index_of(const std::array<std::string_view, N>& names, std::string_view word) {
  std::size_t i = 0;
  while (i < N && !equal_ignoring_case(names[i], word)) {
    ++i;
  }
  return i;
}

// Likewise; reports a word in other letter case, which no program of the course accepts. `place` is
// called for that: most scenes have many words and no such finding.
template <std::size_t N, typename Place>
std::size_t find_word(const XmlContext& context, Place place, std::string_view what,
                      const std::array<std::string_view, N>& names, std::string_view word) {
  const std::size_t i = index_of(names, word);
  if (i < N && word != names[i]) {
    context.diagnostics.report("xml.name-case"_code, place(),
                               fmt::format("{} {} was read as {}", what, quoted(word), names[i]),
                               correction(word, names[i]));
  }
  return i;
}

// Finds the attribute, preferring the exact name, otherwise ignoring case, which no program of the
// course accepts.
const XmlAttribute* find_in_any_case(const XmlContext& context, const XmlTag& tag,
                                     std::string_view name) {
  if (const XmlAttribute* exact = tag.find(name)) {
    return exact;
  }
  for (const XmlAttribute& attribute : tag.attributes) {
    if (equal_ignoring_case(attribute.name, name)) {
      context.report("xml.name-case"_code, attribute,
                     fmt::format("attribute {} of {} was read as {}", attribute.name,
                                 element_text(tag.name), name),
                     correction(attribute.name, name));
      return &attribute;
    }
  }
  return nullptr;
}

}  // namespace

// Global data and the camera.

namespace {

constexpr auto global_names = names_of<count_names(global_rows)>(global_rows);
constexpr auto camera_names = names_of<count_names(camera_rows)>(camera_rows);

// Reports the values that count because the file does not give them.
void report_defaults(const XmlContext& context, const CameraDraft& draft) {
  for (std::size_t i = 0; i < std::size(camera_rows); ++i) {
    const ValueRow<Camera>& row = camera_rows[i];
    const bool is_look = i == look_row;
    const bool given = draft.seen.has(i) || (is_look && draft.seen.has(focus_row));
    if (!given && !row.xml_assumed.empty()) {
      context.diagnostics.report("xml.camera-default"_code, draft.camera.location,
                                 fmt::format("<cameradata> has no {}; the default {}{} is used",
                                             is_look ? "<look> or <focus>" : element_text(row.xml),
                                             is_look ? "look " : "", row.xml_assumed));
    }
  }
}

void resolve_direction(const XmlContext& context, CameraDraft& draft) {
  Camera& camera = draft.camera;
  const Location look = draft.seen.place(look_row);
  const Location focus = draft.seen.place(focus_row);
  if (look.known() && focus.known()) {
    const bool focus_last = std::tie(look.line, look.column) < std::tie(focus.line, focus.column);
    context.diagnostics.report(
        "xml.look-and-focus"_code, focus_last ? focus : look,
        fmt::format("<cameradata> has both <look> and <focus>; the other one is at line {}",
                    (focus_last ? look : focus).line));
    camera.unread.insert(Field::look);
  } else if (focus.known()) {
    look_at(draft.focus, camera);
    if (camera.look == glm::vec3(0)) {
      context.diagnostics.report(
          "xml.focus-at-position"_code, focus,
          "<focus> is the position of the camera itself, so there is no direction to look in");
      camera.unread.insert(Field::look);
      camera.look = Camera().look;
    }
  }
}

// The aspect ratio has no effect, but an invalid one may hide a mistake.
void report_aspect_ratio(const XmlContext& context, const XmlTag& tag) {
  const XmlAttribute* const v = tag.find("v");
  const XmlAttribute* const given = v != nullptr ? v : tag.find("value");
  const ParsedNumber number = parse_number(given != nullptr ? given->value : "1");
  const bool is_ratio = number.error == NumberError::none && number.value > 0;
  context.diagnostics.report(
      "xml.ignored-element"_code, is_ratio ? Severity::note : Severity::warning, tag.location,
      fmt::format("<aspectratio>{} has no effect: the picture's size decides",
                  is_ratio ? "" : fmt::format(" {} is not a ratio, and", quoted(given->value))));
}

}  // namespace

bool read_global(const XmlContext& context, const XmlTag& tag, SeenFields& seen, Scene& scene) {
  const std::optional<std::size_t> field = find_field(context, tag, global_names, "globaldata");
  if (!field) {
    return false;
  }
  seen.note(context, tag, *field);
  Global& global = scene.global;
  const BlockReader<Global> block{global, global.unread, global.location, scene};
  block.read(global_rows[*field], WrittenXml{context, tag});
  return true;
}

bool read_camera_part(const XmlContext& context, const XmlTag& tag, CameraDraft& draft,
                      Scene& scene) {
  const std::optional<std::size_t> field = find_field(context, tag, camera_names, "cameradata");
  if (!field) {
    return false;
  }
  draft.seen.note(context, tag, *field);
  const ValueRow<Camera>& row = camera_rows[*field];
  Camera& camera = draft.camera;
  const BlockReader<Camera> block{camera, camera.unread, camera.location, scene};
  if (*field == focus_row) {
    read_focus(block, WrittenXml{context, tag}, draft.focus);
  } else if (row.has_member()) {
    block.read(row, WrittenXml{context, tag});
  } else {
    report_aspect_ratio(context, tag);
  }
  return true;
}

void finish_camera(const XmlContext& context, CameraDraft& draft, Scene& scene) {
  report_defaults(context, draft);
  resolve_direction(context, draft);
  if (scene.camera) {
    context.diagnostics.report("xml.second-camera"_code, draft.camera.location,
                               fmt::format("a second <cameradata>, after line {}; this one counts",
                                           scene.camera->location.line));
  }
  scene.camera = draft.camera;
}

// Lights.

namespace {

constexpr auto light_names = names_of<count_names(light_rows)>(light_rows);

bool has(const LightDraft& draft, Field field) {
  return draft.seen.has(index_of(light_rows, field));
}

void read_type(const XmlContext& context, Location place, std::string_view word,
               LightDraft& draft) {
  std::size_t i = find_word(
      context, [&] { return place; }, "light type", light_words, word);
  if (i == light_words.size()) {
    const std::string_view usual = translated_name(word, light_words);
    const std::string_view near = usual.empty() ? nearest_name(word, light_words) : usual;
    context.diagnostics.report(
        "xml.light-type"_code, place,
        fmt::format("unknown light type {}{}", quoted(word),
                    near.empty() ? "; the types are point, directional, spot and area"
                                 : did_you_mean(near)),
        correction(word, near, usual.empty() ? light_words : std::span<const std::string_view>()));
    draft.type_known = !near.empty();
    i = near.empty() ? static_cast<std::size_t>(LightType::point) : index_of(light_words, near);
  }
  draft.light.type = static_cast<LightType>(i);
}

void read_id(const XmlContext& context, Location place, std::string_view word, Light& light) {
  const ParsedNumber number = parse_number(word);
  const bool whole = number.error == NumberError::none && std::trunc(number.value) == number.value;
  if (whole && std::abs(number.value) <= std::numeric_limits<int>::max()) {
    light.id = static_cast<int>(number.value);
    return;
  }
  context.diagnostics.report(
      "xml.light-id"_code, place,
      fmt::format("the light id {} is not a whole number from 0 to 7; it has no effect",
                  quoted(word)));
}

// Reports values that the light's type does not use.
void report_unused(const XmlContext& context, const LightDraft& draft) {
  for (std::size_t i = 0; i < std::size(light_rows); ++i) {
    const ValueRow<Light>& row = light_rows[i];
    if (draft.seen.has(i) && !row.used_by_type(draft.light.type) && !row.idle_in_xml) {
      context.diagnostics.report("xml.light-unused"_code, draft.seen.place(i),
                                 fmt::format("<{}> has no effect on {} light", row.xml,
                                             with_article(word_of(draft.light.type))));
    }
  }
}

void report_defaults(const XmlContext& context, const LightDraft& draft) {
  const LightType type = draft.light.type;
  const auto missing = [&](Field field) {
    const ValueRow<Light>& row = row_of(light_rows, field);
    if (light_needs(type, row, true) && !has(draft, field)) {
      context.diagnostics.report("xml.light-default"_code, draft.light.location,
                                 fmt::format("the {} light has no <{}>; the default {} is used",
                                             word_of(type), row.xml, row.xml_assumed));
    }
  };
  missing(Field::position);
  missing(Field::color);
  if (!has(draft, Field::id) && !draft.light.id) {
    context.diagnostics.report("xml.light-id"_code, draft.light.location,
                               "the light has no <id>; give each light a number from 0 to 7");
  }
  if (has(draft, Field::angle_deg)) {
    missing(Field::penumbra_deg);
  }
}

}  // namespace

LightDraft begin_light(const XmlContext& context, const XmlTag& tag) {
  constexpr std::string_view known[] = {"id", "type"};
  LightDraft draft;
  draft.light.location = tag.location;
  draft.light.position = glm::vec3(3);
  for (const XmlAttribute& attribute : tag.attributes) {
    const bool is_type = attribute.name == "type";
    if (!is_type && attribute.name != "id") {
      report_block_attribute(context, tag, attribute, known);
      continue;
    }
    context.report("xml.alias-attribute"_code, attribute,
                   fmt::format("attribute {0} of <lightdata> was read as <{0}>", attribute.name));
    const Location place = context.place(attribute);
    if (is_type) {
      read_type(context, place, attribute.value, draft);
    } else {
      read_id(context, place, attribute.value, draft.light);
    }
  }
  return draft;
}

bool read_light_part(const XmlContext& context, const XmlTag& tag, LightDraft& draft,
                     Scene& scene) {
  const std::optional<std::size_t> field = find_field(context, tag, light_names, "lightdata");
  if (!field) {
    return false;
  }
  draft.seen.note(context, tag, *field);
  const ValueRow<Light>& row = light_rows[*field];
  const WrittenXml value{context, tag};
  const BlockReader<Light> block{draft.light, draft.light.unread, draft.light.location, scene};
  if (row.kind == ValueKind::id) {
    block.note(Field::id, value);
    if (const std::optional<std::string_view> word = read_word(context, tag)) {
      read_id(context, tag.location, *word, draft.light);
    }
  } else if (row.kind == ValueKind::choice) {
    if (const std::optional<std::string_view> word = read_word(context, tag)) {
      read_type(context, tag.location, *word, draft);
    } else {
      draft.type_known = false;
    }
  } else if (!row.has_member()) {
    context.report("xml.ignored-element"_code, tag,
                   fmt::format("<{}> of a light has no effect", row.xml));
  } else {
    block.read(row, value);
  }
  return true;
}

void finish_light(const XmlContext& context, LightDraft& draft, Scene& scene) {
  if (draft.type_known) {
    report_unused(context, draft);
    report_defaults(context, draft);
  }
  if (!light_uses(draft.light.type, Field::position) && !has(draft, Field::position)) {
    draft.light.position = glm::vec3(0);
  }
  scene.nodes[scene.root].lights.push_back(std::move(draft.light));
}

// Materials.

namespace {

constexpr auto material_names = names_of<count_names(material_rows)>(material_rows);
constexpr std::size_t blend_row = index_of(material_rows, Field::blend);

bool is_blend_name(std::string_view name) {
  return name == "blend" || name == "float" || name == "value" || name == "val" || name == "n";
}

// Reads `blend` as a bare attribute of a texture, as sketched in the format's documentation.
void read_bare_blend(const WrittenXml& from, const XmlAttribute& attribute, bool is_texture,
                     PrimitiveDraft& draft, Primitive& primitive) {
  const std::string name = escaped(attribute.name, 40);
  if (!is_texture) {
    from.context.report("xml.texture-blend"_code, attribute,
                        fmt::format("attribute {} of <bumpmap> has no effect: a bump map is not "
                                    "blended",
                                    name));
    return;
  }
  from.context.report("xml.texture-blend"_code, attribute,
                      fmt::format("attribute {} of <texture> was read as <blend>", name));
  float blend = 0;
  const bool known = read_number(from.context, from.tag, attribute, blend);
  if (!draft.seen.has(blend_row)) {
    primitive.material.blend = blend;
    primitive.unread.set(Field::blend, !known);
  }
}

bool name_fits(const XmlContext& context, const XmlTag& tag, const XmlAttribute& attribute) {
  if (attribute.value.size() <= context.options.limits.name_bytes) {
    return true;
  }
  context.report("xml.length-limit"_code, attribute,
                 fmt::format("the file name of {} is longer than the limit of {} bytes",
                             element_text(tag.name), context.options.limits.name_bytes));
  return false;
}

Rare<TextureUse> read_texture(const WrittenXml& from, bool is_texture, PrimitiveDraft& draft,
                              Primitive& primitive) {
  constexpr std::string_view known[] = {"file", "u", "v"};
  const XmlAttribute* file = find_image_file(from.context, from.tag);
  if (file == nullptr || !name_fits(from.context, from.tag, *file)) {
    return {};
  }
  const std::array<const XmlAttribute*, 3> in_order = {
      file, find_repeat(from.context, from.tag, "u"), find_repeat(from.context, from.tag, "v")};
  report_order(from.context, from.tag, in_order, known);
  TextureUse texture{std::string(file->value), 1, 1, from.tag.location};
  for (const XmlAttribute& attribute : from.tag.attributes) {
    if (&attribute == file) {
      continue;
    }
    if (&attribute == in_order[1] || &attribute == in_order[2]) {
      float& repeat = &attribute == in_order[1] ? texture.repeat_u : texture.repeat_v;
      repeat = read_number(from.context, from.tag, attribute, repeat) ? repeat : 1;
    } else if (is_blend_name(attribute.name)) {
      read_bare_blend(from, attribute, is_texture, draft, primitive);
    } else {
      report_unknown_attribute(from.context, from.tag, attribute, known);
    }
  }
  return texture;
}

}  // namespace

const XmlAttribute* find_image_file(const XmlContext& context, const XmlTag& tag) {
  if (const XmlAttribute* file = tag.find("file")) {
    return file;
  }
  const XmlAttribute* found = tag.find("filename");
  for (const XmlAttribute& attribute : tag.attributes) {
    const bool other = !equal_ignoring_case(attribute.name, "u") &&
                       !equal_ignoring_case(attribute.name, "v") &&
                       parse_number(attribute.value).error == NumberError::malformed;
    found = found == nullptr && other ? &attribute : found;
  }
  if (found == nullptr) {
    context.report("xml.missing-attribute"_code, tag,
                   fmt::format("{} is missing the attribute file", element_text(tag.name)));
    return nullptr;
  }
  context.report("xml.alias-attribute"_code, *found,
                 fmt::format("attribute {} of {} was read as file", escaped(found->name, 40),
                             element_text(tag.name)),
                 correction(found->name, "file"));
  return found;
}

const XmlAttribute* find_repeat(const XmlContext& context, const XmlTag& tag,
                                std::string_view name) {
  return context.options.compat_course ? tag.find(name) : find_in_any_case(context, tag, name);
}

bool read_primitive_part(const XmlContext& context, const XmlTag& tag, PrimitiveDraft& draft,
                         Scene& scene) {
  const std::optional<std::size_t> field = find_field(context, tag, material_names, "object");
  if (!field) {
    return false;
  }
  draft.seen.note(context, tag, *field);
  Primitive& primitive = scene.nodes[draft.node].primitives.back();
  const WrittenXml value{context, tag};
  const ValueRow<Material>& row = material_rows[*field];
  if (const auto* const texture = std::get_if<Rare<TextureUse> Material::*>(&row.member)) {
    const bool is_texture = *texture == &Material::texture;
    primitive.material.** texture = read_texture(value, is_texture, draft, primitive);
    draft.texture_known = is_texture ? primitive.material.texture.has_value() : draft.texture_known;
  } else if (row.has_member()) {
    const BlockReader<Material> block{primitive.material, primitive.unread, primitive.location,
                                      scene};
    block.read(row, value);
  } else {
    context.report("xml.ignored-element"_code, tag,
                   fmt::format("<{}> has no effect: objects do not shine", row.xml));
  }
  return true;
}

void finish_primitive(PrimitiveDraft& draft, Scene& scene) {
  if (!draft.texture_known) {
    // Unknown whether there is a texture to blend.
    scene.nodes[draft.node].primitives.back().unread.insert(Field::blend);
  }
}

// The tags of objects.

namespace {

constexpr std::array<std::string_view, 3> type_names = {"tree", "master", "primitive"};

std::optional<ObjectType> read_type(const XmlContext& context, const XmlAttribute& attribute,
                                    bool has_name) {
  const std::size_t i = find_word(
      context, [&] { return context.place(attribute); }, attribute.name, type_names,
      attribute.value);
  if (i < type_names.size()) {
    return static_cast<ObjectType>(i);
  }
  const std::string type = quoted(attribute.value);
  const std::string_view near = nearest_name(attribute.value, type_names);
  if (!near.empty()) {
    context.report("xml.object-type"_code, attribute,
                   fmt::format("unknown object type {}{}", type, did_you_mean(near)),
                   correction(attribute.value, near, type_names));
    return static_cast<ObjectType>(index_of(type_names, near));
  }
  const std::string_view usual = translated_name(attribute.value, type_names);
  std::string hint = did_you_mean(usual);
  std::optional<Correction> better = correction(attribute.value, usual);
  if (const std::size_t shape = index_of(shape_words, attribute.value);
      shape != shape_words.size()) {
    const std::string primitive = fmt::format("type=\"primitive\" name=\"{}\"", shape_words[shape]);
    hint = "; write " + primitive;
    better =
        has_name ? std::nullopt : std::optional(Correction{std::string(attribute.name), primitive});
  }
  context.report(
      "xml.unknown-object-type"_code, attribute,
      fmt::format("object type {} is not part of the format, so the object was ignored{}", type,
                  hint),
      std::move(better));
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

Found find_attributes(const XmlContext& context, const XmlTag& tag) {
  Found found{tag.find("type"), tag.find("name"), tag.find("filename"), tag.find("meshfile"), {}};
  const std::size_t count = (found.type != nullptr) + (found.name != nullptr) +
                            (found.filename != nullptr) + (found.meshfile != nullptr);
  if (count == tag.attributes.size()) {
    return found;  // the usual case
  }
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

// The missing attribute that another one was probably meant to be, by its value; empty if none.
std::string_view meant_by_value(const Found& found, const XmlAttribute& attribute) {
  const auto is_value = [&](std::string_view word) {
    return equal_ignoring_case(attribute.value, word);
  };
  if (found.type == nullptr && std::any_of(type_names.begin(), type_names.end(), is_value)) {
    return "type";
  }
  if (found.name == nullptr && std::any_of(shape_words.begin(), shape_words.end(), is_value)) {
    return "name";
  }
  return {};
}

// Reports other attributes; a misspelled one takes the place of the missing one.
void settle_others(const XmlContext& context, const XmlTag& tag, Found& found) {
  for (const XmlAttribute* attribute : found.others) {
    const std::string_view near = nearest_name(attribute->name, missing_names(found));
    const std::string_view meant = near.empty() ? meant_by_value(found, *attribute) : near;
    if (meant.empty()) {
      report_unknown_attribute(context, tag, *attribute, {});
      continue;
    }
    if (near.empty()) {
      report_meant(context, tag, *attribute, meant, true);
    } else {
      context.report("xml.misspelled-attribute"_code, *attribute,
                     fmt::format("unknown attribute {} of <object>{}", escaped(attribute->name, 40),
                                 did_you_mean(near)),
                     correction(attribute->name, near, missing_names(found)));
    }
    (meant == "type" ? found.type : meant == "name" ? found.name : found.filename) = attribute;
  }
}

// Moves the file of a mesh to `filename`, under whichever name it was given.
void settle_mesh_file(const XmlContext& context, Found& found) {
  if (found.filename != nullptr && found.meshfile != nullptr) {
    context.report("xml.mesh-files"_code, *found.meshfile,
                   "the mesh has both filename and meshfile; filename counts");
  }
  if (found.filename == nullptr) {
    found.filename = found.meshfile;
  }
  if (found.filename == nullptr && found.is_mesh() && found.others.size() == 1 &&
      found.name != nullptr && found.type != nullptr) {
    found.filename = found.others.front();
    found.others.clear();
    context.report("xml.alias-attribute"_code, *found.filename,
                   fmt::format("attribute {} of <object> was read as filename",
                               escaped(found.filename->name, 40)),
                   correction(found.filename->name, "filename"));
  }
}

bool name_fits(const XmlContext& context, const XmlAttribute* attribute) {
  const std::uint32_t limit = context.options.limits.name_bytes;
  if (attribute == nullptr || attribute->value.size() <= limit) {
    return true;
  }
  context.report("xml.length-limit"_code, *attribute,
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
    context.report("xml.missing-attribute"_code, tag,
                   "<object> is missing the attribute type: tree, master or primitive");
    return std::nullopt;
  }
  const std::array<const XmlAttribute*, 3> in_order = {found.type, found.name, found.filename};
  constexpr std::string_view names[] = {"type", "name", "filename"};
  report_order(context, tag, in_order, names);
  const std::optional<ObjectType> type = read_type(context, *found.type, found.name != nullptr);
  if (!type || !name_fits(context, found.name) || !name_fits(context, found.filename)) {
    return std::nullopt;
  }
  ObjectTag object{*type,        found.name != nullptr, found.filename != nullptr, {}, {},
                   tag.location, tag.location};
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
    context.report("xml.missing-attribute"_code, tag,
                   "<object type=\"primitive\"> is missing the attribute name, the shape");
    return std::nullopt;
  }
  if (object.name.find_first_not_of(" \t\r\n") == std::string::npos) {
    context.diagnostics.report(
        "xml.missing-attribute"_code, object.name_place,
        fmt::format("the attribute name of the primitive is empty; it must say the shape: {}",
                    fmt::join(shape_words, ", ")));
    return std::nullopt;
  }
  std::size_t i = find_word(
      context, [&] { return object.name_place; }, "name", shape_words, object.name);
  if (i == shape_words.size()) {
    const std::string_view near = nearest_name(object.name, shape_words);
    const std::string shape = quoted(object.name);
    if (near.empty()) {
      const std::string_view usual = translated_name(object.name, shape_words);
      context.diagnostics.report(
          "xml.unknown-shape"_code, object.name_place,
          fmt::format("shape {} is not part of the format ({}); it is not drawn{}", shape,
                      fmt::join(shape_words, ", "), did_you_mean(usual)),
          correction(object.name, usual));
      return std::nullopt;
    }
    context.diagnostics.report("xml.misspelled-shape"_code, object.name_place,
                               fmt::format("unknown shape {}{}", shape, did_you_mean(near)),
                               correction(object.name, near, shape_words));
    i = index_of(shape_words, near);
  }
  const auto shape = static_cast<Shape>(i);
  if (shape == Shape::mesh && object.filename.empty()) {
    context.report("xml.missing-attribute"_code, tag,
                   object.has_filename ? "the attribute filename of the mesh is empty"
                                       : "the mesh is missing the attribute filename");
    return std::nullopt;
  }
  if (shape != Shape::mesh && !object.filename.empty()) {
    context.diagnostics.report(
        "xml.unknown-attribute"_code, object.filename_place,
        fmt::format("the file name has no effect: a {} is not a mesh", shape_words[i]));
  }
  return shape;
}

// Transforms.

namespace {

bool is_finite(const glm::mat4& m) {
  const float* const first = &m[0][0];
  return std::all_of(first, first + 16, [](float value) { return std::isfinite(value); });
}

template <typename Map>
std::optional<Transform> read_vector(const XmlContext& context, const XmlTag& tag) {
  Map map;
  if (!read_three(context, tag, ValueKind::vector, map.by)) {
    return std::nullopt;
  }
  return Transform{map, tag.location};
}

// Sets the last row to 0 0 0 1.
void make_affine(const XmlContext& context, const MatrixDraft& draft, glm::mat4& rows) {
  const glm::vec4 last = rows[3];
  if (last == glm::vec4(0, 0, 0, 1)) {
    return;
  }
  const bool only_w = glm::vec3(last) == glm::vec3(0);
  const auto report = [&](Severity severity, std::string_view what) {
    context.diagnostics.report("xml.matrix-not-affine"_code, severity, draft.last_row,
                               fmt::format("the last row of the matrix is {} {} {} {}; {}", last.x,
                                           last.y, last.z, last.w, what));
  };
  const bool repeated = !only_w && last == rows[2];
  const bool no_translation = rows[0].w == 0 && rows[1].w == 0 && rows[2].w == 0;
  if (only_w && !is_finite(rows / last.w)) {
    report(Severity::error, "it must be 0 0 0 1");
  } else if (only_w) {
    report(Severity::warning, "the matrix was divided by its last number to make it 0 0 0 1");
    rows /= last.w;
  } else if (repeated) {
    report(Severity::warning, "it repeats the third row. It must be 0 0 0 1, so it has no effect");
  } else if (no_translation && last.w == 1) {
    report(Severity::warning,
           "it has no effect. The matrix seems to be transposed: a translation belongs in the last "
           "column");
  } else {
    report(Severity::warning, "projective maps are not supported, so it has no effect");
  }
  rows[3] = {0, 0, 0, 1};
}

}  // namespace

std::optional<Transform> read_translate(const XmlContext& context, const XmlTag& tag) {
  return read_vector<Translate>(context, tag);
}

std::optional<Transform> read_scale(const XmlContext& context, const XmlTag& tag) {
  return read_vector<Scale>(context, tag);
}

std::optional<Transform> read_rotate(const XmlContext& context, const XmlTag& tag) {
  const std::optional<Parts> found = find_parts(context, tag, signature_of(ValueKind::rotation));
  if (!found) {
    return std::nullopt;
  }
  const Parts& parts = *found;
  const int axis_parts = (parts[0] != nullptr) + (parts[1] != nullptr) + (parts[2] != nullptr);
  if (axis_parts == 0 && parts[3] != nullptr) {
    context.report("xml.rotate-axis"_code, tag,
                   "<rotate> has no axis, so it has no effect; write its axis as x, y and z");
    return std::nullopt;
  }
  if (axis_parts != 3) {
    report_missing(context, tag, signature_of(ValueKind::rotation), parts);
    return std::nullopt;
  }
  if (parts[3] == nullptr) {
    context.report("xml.rotate-angle"_code, tag,
                   "<rotate> has no angle, so it has no effect; write its degrees as angle");
  }
  glm::vec4 numbers;
  if (!read_numbers(context, tag, parts, {&numbers.x, 4})) {
    return std::nullopt;
  }
  return Transform{Rotate{glm::vec3(numbers), numbers.w}, tag.location};
}

void read_matrix_child(const XmlContext& context, const XmlTag& tag, MatrixDraft& draft) {
  if (draft.count >= 4) {
    draft.valid = false;
    context.report(
        "xml.matrix-rows"_code, tag,
        fmt::format("{} is one row too many: a matrix has four", element_text(tag.name)));
    return;
  }
  glm::vec4& row = draft.rows[static_cast<int>(draft.count)];
  draft.valid = read_matrix_row(context, tag, row) && draft.valid;
  draft.last_row = tag.location;
  ++draft.count;
}

std::optional<Transform> finish_matrix(const XmlContext& context, const MatrixDraft& draft) {
  if (draft.count < 4) {
    context.diagnostics.report(
        "xml.matrix-rows"_code, draft.location,
        fmt::format("the matrix has {} rows instead of four, each written <row a=\"1\" "
                    "b=\"0\" c=\"0\" d=\"0\"/>",
                    draft.count));
    return std::nullopt;
  }
  if (!draft.valid) {
    return std::nullopt;
  }
  glm::mat4 rows = draft.rows;
  make_affine(context, draft, rows);
  return Transform{Matrix{glm::transpose(rows)}, draft.location};
}

}  // namespace scenefile
