#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/read_common.h"
#include "scenefile/format/xml_blocks.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

namespace scenefile {

namespace {

constexpr auto material_names = names_of<count_names(material_rows)>(material_rows);

struct Writer {
  const XmlContext& context;
  const XmlTag& tag;
  const SeenFields& seen;
  Primitive& primitive;
  Scene& scene;

  // Reads a number or a color.
  void value(const ValueRow<Material>& row) const {
    Material& material = primitive.material;
    read_value(context, tag, row, material);
    const auto* const color = std::get_if<glm::vec3 Material::*>(&row.member);
    if (color == nullptr || needs_place(*row.field, material.**color)) {
      scene.field_places.push_back({primitive.location, *row.field, tag.location});
    }
  }
};

bool is_blend_name(std::string_view name) {
  return name == "blend" || name == "float" || name == "value" || name == "val" || name == "n";
}

// Reads `blend` as a bare attribute of a texture, as sketched in the format's documentation.
void read_bare_blend(const Writer& to, const XmlAttribute& attribute, bool is_texture) {
  const std::string name = escaped(attribute.name, 40);
  if (!is_texture) {
    to.context.report(xml_texture_blend, attribute,
                      fmt::format("attribute {} of <bumpmap> has no effect: a bump map is not "
                                  "blended",
                                  name));
    return;
  }
  to.context.report(xml_texture_blend, attribute,
                    fmt::format("attribute {} of <texture> was read as <blend>", name));
  const float blend = read_number(to.context, to.tag, attribute).value_or(not_known);
  if (!to.seen.has(index_of(material_rows, Field::blend))) {
    to.primitive.material.blend = blend;
  }
}

// The file name: `file`, another dialect's name for it, or the first attribute that is not a
// number.
const XmlAttribute* find_file(const XmlContext& context, const XmlTag& tag) {
  if (const XmlAttribute* file = tag.find("file")) {
    return file;
  }
  const XmlAttribute* found = tag.find("filename");
  for (const XmlAttribute& attribute : tag.attributes) {
    const bool other = attribute.name != "u" && attribute.name != "v" &&
                       parse_number(attribute.value).error == NumberError::malformed;
    found = found == nullptr && other ? &attribute : found;
  }
  if (found == nullptr) {
    context.report(xml_missing_attribute, tag,
                   fmt::format("{} is missing the attribute file", element_text(tag.name)));
    return nullptr;
  }
  context.report(xml_alias_attribute, *found,
                 fmt::format("attribute {} of {} was read as file", escaped(found->name, 40),
                             element_text(tag.name)));
  return found;
}

bool name_fits(const XmlContext& context, const XmlTag& tag, const XmlAttribute& attribute) {
  if (attribute.value.size() <= context.options.limits.name_bytes) {
    return true;
  }
  context.report(xml_length_limit, attribute,
                 fmt::format("the file name of {} is longer than the limit of {} bytes",
                             element_text(tag.name), context.options.limits.name_bytes));
  return false;
}

Rare<TextureUse> read_texture(const Writer& to, bool is_texture) {
  constexpr std::string_view known[] = {"file", "u", "v"};
  const XmlAttribute* file = find_file(to.context, to.tag);
  if (file == nullptr || !name_fits(to.context, to.tag, *file)) {
    return {};
  }
  const std::array<const XmlAttribute*, 3> in_order = {file, to.tag.find("u"), to.tag.find("v")};
  report_order(to.context, to.tag, in_order);
  TextureUse texture{std::string(file->value), 1, 1, to.tag.location};
  for (const XmlAttribute& attribute : to.tag.attributes) {
    if (&attribute == file) {
      continue;
    }
    if (attribute.name == "u") {
      texture.repeat_u = read_number(to.context, to.tag, attribute).value_or(not_known);
    } else if (attribute.name == "v") {
      texture.repeat_v = read_number(to.context, to.tag, attribute).value_or(not_known);
    } else if (is_blend_name(attribute.name)) {
      read_bare_blend(to, attribute, is_texture);
    } else {
      report_unknown_attribute(to.context, to.tag, attribute, known);
    }
  }
  return texture;
}

}  // namespace

bool read_primitive_part(const XmlContext& context, const XmlTag& tag, PrimitiveDraft& draft,
                         Scene& scene) {
  const std::optional<std::size_t> field = find_field(context, tag, material_names, "object");
  if (!field) {
    return false;
  }
  draft.seen.note(context, tag, *field);
  Primitive& primitive = scene.nodes[draft.node].primitives.back();
  const Writer to{context, tag, draft.seen, primitive, scene};
  const ValueRow<Material>& row = material_rows[*field];
  if (const auto* const texture = std::get_if<Rare<TextureUse> Material::*>(&row.member)) {
    const bool is_texture = *texture == &Material::texture;
    primitive.material.** texture = read_texture(to, is_texture);
    draft.texture_known = is_texture ? primitive.material.texture.has_value() : draft.texture_known;
  } else if (row.has_member()) {
    to.value(row);
  } else {
    context.report(xml_ignored_element, tag,
                   fmt::format("<{}> has no effect: objects do not shine", row.xml));
  }
  return true;
}

void finish_primitive(const PrimitiveDraft& draft, Scene& scene) {
  if (!draft.texture_known) {
    // Unknown whether there is a texture to blend.
    scene.nodes[draft.node].primitives.back().material.blend = not_known;
  }
}

}  // namespace scenefile
