#include "scenefile/format/json_blocks.h"

#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/block.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/foreign_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <variant>

namespace scenefile {

namespace {

// Reads the values of a block except the direction of view; reports those that it must have.
template <typename Owner, std::size_t N>
void read_rows(JsonContext& context, const JsonFields& fields, const ValueRow<Owner> (&rows)[N],
               const BlockReader<Owner>& block) {
  for (std::size_t i = 0; i < N; ++i) {
    const std::size_t key = key_of(rows, i);
    if (rows[i].json.empty()) {
      continue;
    }
    if (is_needed(rows[i].need, false) && !fields.require(key)) {
      block.unread.insert(*rows[i].field);
    } else if (rows[i].has_member() && rows[i].field != Field::look && fields.has(key)) {
      block.read(rows[i], WrittenJson{context, fields.key(key)});
    }
  }
}

bool is_object(JsonContext& context, JsonIndex item, std::string_view what) {
  if (context.tape.is_object(item)) {
    return true;
  }
  context.report(
      "json.wrong-type"_code, item,
      fmt::format("{} must be an object, found {}", what, describe_json(context.tape, item)));
  return false;
}

bool is_object_value(JsonContext& context, JsonIndex key) {
  if (context.tape.is_object(key + 1)) {
    return true;
  }
  report_json_type(context, key, "an object");
  return false;
}

void report_unused(JsonContext& context, const JsonFields& fields, std::size_t key,
                   std::string_view why) {
  if (fields.has(key)) {
    context.report(
        "json.unused-key"_code, fields.key(key),
        fmt::format("{} has no effect {}", quoted(context.tape.string(fields.key(key))), why));
  }
}

// Whether the name could be that of an extension.
bool is_identifier(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

// A hint for an unknown type: the format's word for it, advice about a light among primitives, or
// the list of types.
std::string type_hint(std::string_view word, std::span<const std::string_view> names) {
  if (const std::string_view ours = translated_name(word, names); !ours.empty()) {
    return fmt::format("; did you mean \"{}\"?", ours);
  }
  const bool is_light =
      std::find(light_words.begin(), light_words.end(), word) != light_words.end();
  return is_light ? "; lights belong in the list \"lights\" of a group"
                  : fmt::format("; known are {}", fmt::join(names, ", "));
}

// The index in `names` of the "type" of a light or primitive. A misspelled type is an error, and
// then counts as the suggested one. Returns nullopt, and reports it, for any other type.
std::optional<std::size_t> read_type(JsonContext& context, const JsonFields& fields,
                                     std::string_view what, std::span<const std::string_view> names,
                                     const Code& unknown) {
  constexpr std::size_t type_key = 0;
  if (!fields.require(type_key)) {
    return std::nullopt;
  }
  const JsonIndex key = fields.key(type_key);
  const std::optional<std::string> name = text_value(context, key, context.limits.name_bytes);
  if (!name) {
    return std::nullopt;
  }
  const auto found = std::find(names.begin(), names.end(), *name);
  if (found != names.end()) {
    return static_cast<std::size_t>(found - names.begin());
  }
  const std::string_view near = nearest_name(std::string_view(*name).substr(0, 64), names);
  const bool misspelled = !near.empty();
  context.diagnostics.add({&unknown,
                           misspelled || !is_identifier(*name) ? Severity::error : unknown.severity,
                           context.place(key + 1),
                           {},
                           fmt::format("unknown {} type {}{}", what, quoted(*name),
                                       misspelled ? fmt::format("; did you mean \"{}\"?", near)
                                                  : type_hint(*name, names)),
                           {},
                           misspelled ? correction(*name, near, names)
                                      : correction(*name, translated_name(*name, names))});
  const auto meant = std::find(names.begin(), names.end(), near);
  return misspelled ? std::optional<std::size_t>(meant - names.begin()) : std::nullopt;
}

namespace global {
constexpr auto names = keys_of<key_of(global_rows, std::size(global_rows))>(global_rows);
constexpr JsonVocabulary vocabulary{"globalData", names};
}  // namespace global

namespace camera {
constexpr auto names = keys_of<key_of(camera_rows, std::size(camera_rows))>(camera_rows);
constexpr JsonVocabulary vocabulary{"cameraData", names};
constexpr std::size_t look = key_of(camera_rows, look_row);
constexpr std::size_t focus = key_of(camera_rows, focus_row);

void read_direction(JsonContext& context, const JsonFields& fields, JsonIndex object,
                    const BlockReader<Camera>& block) {
  if (fields.has(look) && fields.has(focus)) {
    const JsonIndex second = std::max(fields.key(look), fields.key(focus));
    context.report("json.look-and-focus"_code, second,
                   "cameraData has both \"look\" and \"focus\"; remove one of them");
    block.unread.insert(Field::look);
  } else if (fields.has(focus)) {
    glm::vec3 point;
    read_focus(block, WrittenJson{context, fields.key(focus)}, point);
    look_at(point, block.values);
  } else if (fields.has(look)) {
    block.read(camera_rows[look_row], WrittenJson{context, fields.key(look)});
  } else {
    context.report("json.missing-key"_code, object,
                   "cameraData must have one of the keys \"look\" and \"focus\"");
    block.unread.insert(Field::look);
  }
}
}  // namespace camera

namespace light {
constexpr auto names = keys_of<key_of(light_rows, std::size(light_rows))>(light_rows);
constexpr JsonVocabulary vocabulary{"a light", names};
constexpr std::size_t type = 0;
static_assert(names[type] == "type");
constexpr std::size_t color = key_of(light_rows, Field::color);

// According to the format's documentation, a light without a type is a point light. Without a color
// it is not a light.
std::optional<std::size_t> read_kind(JsonContext& context, const JsonFields& fields,
                                     JsonIndex item) {
  if (fields.has(type)) {
    return read_type(context, fields, "light", light_words, "json.unknown-light-type"_code);
  }
  if (fields.has(color)) {
    context.report("json.light-default"_code, item,
                   "a light must have the key \"type\"; it counts as a point light");
    return static_cast<std::size_t>(LightType::point);
  }
  context.report("json.no-light"_code, item,
                 "this is not a light: it has neither \"type\" nor \"color\", and is left out");
  return std::nullopt;
}

// check() handles a missing direction, angle or size.
void report_missing(JsonContext& context, const JsonFields& fields, JsonIndex item, LightType kind,
                    Field field) {
  const auto report = [&](std::string_view value) {
    context.report("json.light-default"_code, item,
                   fmt::format("{} light must have the key \"{}\"; {} is used",
                               with_article(word_of(kind)), row_of(light_rows, field).json, value));
  };
  if (field == Field::color) {
    fields.require(color);
  } else if (field == Field::attenuation) {
    report("1 0 0 (no falloff)");
  } else if (field == Field::penumbra_deg) {
    report("0 (a hard edge)");
  }
}

void read_values(JsonContext& context, const JsonFields& fields, JsonIndex item, Light& light,
                 Scene& scene) {
  const BlockReader<Light> block{light, light.unread, light.location, scene};
  for (std::size_t i = 0; i < std::size(light_rows); ++i) {
    const ValueRow<Light>& row = light_rows[i];
    const std::size_t key = key_of(light_rows, i);
    if (row.json.empty() || !row.has_member()) {
      continue;
    }
    if (!fields.has(key)) {
      if (light_needs(light.type, row, false)) {
        report_missing(context, fields, item, light.type, *row.field);
      }
    } else if (!row.used_by_type(light.type)) {
      report_unused(context, fields, key,
                    fmt::format("on {} light", with_article(word_of(light.type))));
    } else if (row.kind == ValueKind::text) {
      light.name = text_value(context, fields.key(key), context.limits.name_bytes).value_or("");
    } else {
      block.read(row, WrittenJson{context, fields.key(key)});
    }
  }
}
}  // namespace light

namespace primitive {
enum Key { type, mesh_file, first_of_material };
constexpr std::string_view own_names[] = {"type", "meshFile"};
constexpr auto names = keys_of<first_of_material + key_of(material_rows, std::size(material_rows))>(
    material_rows, own_names);
constexpr JsonVocabulary vocabulary{"a primitive", names};
static_assert(std::size(names) <= JsonFields::max_keys);

// Like the course's reader, reads anything that is not a number as 1.
float read_repeat(JsonContext& context, const JsonFields& fields, std::size_t key) {
  if (!fields.has(key)) {
    return 1;
  }
  const JsonIndex at = fields.key(key);
  if (context.tape.is_number(at + 1)) {
    return number_value(context, at).value_or(1);
  }
  context.diagnostics.report(
      "json.wrong-type"_code, Severity::warning, context.place(at),
      fmt::format("{} must be a number, found {}; 1 is used", quoted(context.tape.string(at)),
                  describe_json(context.tape, at + 1)));
  return 1;
}

Rare<TextureUse> read_texture(JsonContext& context, const JsonFields& fields, std::size_t file) {
  const std::size_t u = file + 1;
  const std::size_t v = file + 2;
  if (!fields.has(file) && !fields.has(u) && !fields.has(v)) {
    return {};
  }
  if (!fields.has(file)) {
    const std::string why = fmt::format("without \"{}\"", names[file]);
    report_unused(context, fields, u, why);
    report_unused(context, fields, v, why);
    return {};
  }
  std::optional<std::string> name =
      text_value(context, fields.key(file), context.limits.name_bytes);
  if (!name) {
    return {};
  }
  return TextureUse{*std::move(name), read_repeat(context, fields, u),
                    read_repeat(context, fields, v), context.place(fields.key(file))};
}

void read_material(JsonContext& context, const JsonFields& fields, Primitive& primitive,
                   Scene& scene) {
  Material& material = primitive.material;
  const BlockReader<Material> block{material, primitive.unread, primitive.location, scene};
  for (std::size_t i = 0; i < std::size(material_rows); ++i) {
    const ValueRow<Material>& row = material_rows[i];
    const std::size_t key = first_of_material + key_of(material_rows, i);
    const auto* const texture = std::get_if<Rare<TextureUse> Material::*>(&row.member);
    if (texture == nullptr) {
      if (row.has_member() && fields.has(key)) {
        block.read(row, WrittenJson{context, fields.key(key)});
      }
      continue;
    }
    material.** texture = read_texture(context, fields, key);
    if (*texture == &Material::texture && fields.has(key) && !material.texture) {
      primitive.unread.insert(Field::blend);  // unknown whether there is a texture to blend
    }
  }
}
}  // namespace primitive

}  // namespace

void read_json_global(JsonContext& context, JsonIndex key, Scene& scene) {
  if (!is_object_value(context, key)) {
    return;
  }
  Global& global = scene.global;
  global.location = context.place(key);
  read_rows(context, JsonFields(context, key + 1, global::vocabulary), global_rows,
            BlockReader<Global>{global, global.unread, global.location, scene});
}

void read_json_camera(JsonContext& context, JsonIndex key, Scene& scene) {
  if (!is_object_value(context, key)) {
    return;
  }
  const JsonFields fields(context, key + 1, camera::vocabulary);
  Camera& camera = scene.camera.emplace();
  camera.location = context.place(key);
  const BlockReader<Camera> block{camera, camera.unread, camera.location, scene};
  read_rows(context, fields, camera_rows, block);
  camera::read_direction(context, fields, key + 1, block);
}

std::optional<Light> read_json_light(JsonContext& context, JsonIndex item, Scene& scene) {
  if (!is_object(context, item, "a light")) {
    return std::nullopt;
  }
  const JsonFields fields(context, item, light::vocabulary);
  const std::optional<std::size_t> type = light::read_kind(context, fields, item);
  if (!type) {
    return std::nullopt;
  }
  Light light;
  light.type = static_cast<LightType>(*type);
  light.location = context.place(item);
  if (!course_json_has(light.type)) {
    context.report("json.area-light"_code, fields.key(light::type),
                   "the course's JSON reader does not support area lights and rejects the file");
  }
  light::read_values(context, fields, item, light, scene);
  return light;
}

std::optional<Primitive> read_json_primitive(JsonContext& context, JsonIndex item, Scene& scene) {
  if (!is_object(context, item, "a primitive")) {
    return std::nullopt;
  }
  const JsonFields fields(context, item, primitive::vocabulary);
  const std::optional<std::size_t> type =
      read_type(context, fields, "primitive", shape_words, "json.unknown-primitive-type"_code);
  if (!type) {
    return std::nullopt;
  }
  Primitive primitive;
  primitive.shape = static_cast<Shape>(*type);
  primitive.location = context.place(item);
  primitive::read_material(context, fields, primitive, scene);
  if (primitive.shape != Shape::mesh) {
    report_unused(context, fields, primitive::mesh_file, "on any primitive but a mesh");
  } else if (fields.has(primitive::mesh_file)) {
    const JsonIndex key = fields.key(primitive::mesh_file);
    std::optional<std::string> file = text_value(context, key, context.limits.name_bytes);
    if (!file) {
      return std::nullopt;
    }
    primitive.mesh_file = *std::move(file);
    scene.field_places.push_back({primitive.location, Field::mesh_file, context.place(key)});
  }
  return primitive;
}

}  // namespace scenefile
