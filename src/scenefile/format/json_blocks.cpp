#include "scenefile/format/json_blocks.h"

#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/foreign_names.h"
#include "scenefile/format/read_common.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <variant>

namespace scenefile {

namespace {

// An object whose values are read, and where findings about them are stored.
struct ObjectReader {
  JsonContext& context;
  const JsonFields& fields;
  Location owner;
  FieldSet& unread;
  Scene& scene;

  // Reads the value of a row into its member, which keeps its default after an error. The caller
  // handles textures.
  template <typename Owner>
  void read(std::size_t key, const ValueRow<Owner>& row, Owner& to) const {
    if (!fields.has(key)) {
      return;
    }
    const auto store = [&](const auto member, const auto& value) {
      if (value) {
        to.*member = *value;
      } else {
        unread.insert(*row.field);
      }
    };
    bool worth_a_place = row.field.has_value();
    if (const auto* const number = std::get_if<float Owner::*>(&row.member)) {
      store(*number, number_value(context, fields.key(key)));
    } else if (const auto* const maybe = std::get_if<std::optional<float> Owner::*>(&row.member)) {
      store(*maybe, number_value(context, fields.key(key)));
    } else if (const auto* const text = std::get_if<std::string Owner::*>(&row.member)) {
      to.** text = text_value(context, fields.key(key), context.limits.name_bytes).value_or("");
    } else if (const auto* const vector = std::get_if<glm::vec3 Owner::*>(&row.member)) {
      store(*vector, read_three(key, row.kind));
      if constexpr (std::is_same_v<Owner, Material>) {
        worth_a_place = needs_place(*row.field, to.**vector);
      }
    }
    if (worth_a_place) {
      note(key, *row.field);
    }
  }
  template <typename Owner, std::size_t N>
  void read(const ValueRow<Owner> (&rows)[N], Field field, Owner& to) const {
    read(key_of(rows, field), row_of(rows, field), to);
  }
  std::optional<glm::vec3> read_three(std::size_t key, ValueKind kind) const {
    const JsonIndex at = fields.key(key);
    return kind == ValueKind::color ? color_value(context, at) : vector_value(context, at);
  }
  void note(std::size_t key, Field field) const {
    scene.field_places.push_back({owner, field, context.place(fields.key(key))});
  }
};

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
constexpr std::size_t look = key_of(camera_rows, Field::look);
constexpr std::size_t focus = look + 1;
static_assert(names[focus] == "focus");

void read_required(const ObjectReader& reader, Field field, Camera& camera) {
  if (reader.fields.require(key_of(camera_rows, field))) {
    reader.read(camera_rows, field, camera);
  } else {
    reader.unread.insert(field);
  }
}

// A focus is a point to look at; the scene only has directions.
void read_direction(const ObjectReader& reader, JsonIndex object, Camera& camera) {
  JsonContext& context = reader.context;
  const JsonFields& fields = reader.fields;
  if (fields.has(look) && fields.has(focus)) {
    const JsonIndex second = std::max(fields.key(look), fields.key(focus));
    context.report("json.look-and-focus"_code, second,
                   "cameraData has both \"look\" and \"focus\"; remove one of them");
    reader.unread.insert(Field::look);
  } else if (fields.has(focus)) {
    const std::optional<glm::vec3> point = reader.read_three(focus, ValueKind::vector);
    if (point && !reader.unread.contains(Field::position)) {
      camera.look = direction_to(*point, camera.position);
    } else {
      reader.unread.insert(Field::look);
    }
    reader.note(focus, Field::look);
  } else if (fields.has(look)) {
    reader.read(camera_rows, Field::look, camera);
  } else {
    context.report("json.missing-key"_code, object,
                   "cameraData must have one of the keys \"look\" and \"focus\"");
    reader.unread.insert(Field::look);
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

void report_unused_keys(JsonContext& context, const JsonFields& fields, LightType kind) {
  const std::string why = fmt::format("on a {} light", word_of(kind));
  for (std::size_t i = 0; i < std::size(light_rows); ++i) {
    if (!light_rows[i].json.empty() && !light_rows[i].used_by_type(kind)) {
      report_unused(context, fields, key_of(light_rows, i), why);
    }
  }
}

void report_default(JsonContext& context, const JsonFields& fields, JsonIndex item, Field field,
                    LightType kind, std::string_view value) {
  const std::size_t key = key_of(light_rows, field);
  if (!fields.has(key)) {
    context.report("json.light-default"_code, item,
                   fmt::format("a {} light must have the key \"{}\"; {} is used", word_of(kind),
                               names[key], value));
  }
}

// check() handles a missing direction or angle.
void require_keys(JsonContext& context, const JsonFields& fields, JsonIndex item, LightType kind) {
  fields.require(color);
  if (course_json_has(kind) && light_uses(kind, Field::attenuation)) {
    report_default(context, fields, item, Field::attenuation, kind, "1 0 0 (no falloff)");
  }
  if (light_uses(kind, Field::penumbra_deg)) {
    report_default(context, fields, item, Field::penumbra_deg, kind, "0 (a hard edge)");
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

void read_material(const ObjectReader& reader, Material& material) {
  for (std::size_t i = 0; i < std::size(material_rows); ++i) {
    const ValueRow<Material>& row = material_rows[i];
    const std::size_t key = first_of_material + key_of(material_rows, i);
    const auto* const texture = std::get_if<Rare<TextureUse> Material::*>(&row.member);
    if (texture == nullptr) {
      if (row.has_member()) {
        reader.read(key, row, material);
      }
      continue;
    }
    material.** texture = read_texture(reader.context, reader.fields, key);
    if (*texture == &Material::texture && reader.fields.has(key) && !material.texture) {
      reader.unread.insert(Field::blend);  // unknown whether there is a texture to blend
    }
  }
}
}  // namespace primitive

}  // namespace

void read_json_global(JsonContext& context, JsonIndex key, Scene& scene) {
  if (!is_object_value(context, key)) {
    return;
  }
  const JsonFields fields(context, key + 1, global::vocabulary);
  scene.global.location = context.place(key);
  const ObjectReader reader{context, fields, scene.global.location, scene.global.unread, scene};
  fields.require(key_of(global_rows, Field::ambient));
  fields.require(key_of(global_rows, Field::diffuse));
  fields.require(key_of(global_rows, Field::specular));
  for (const ValueRow<Global>& row : global_rows) {
    reader.read(global_rows, *row.field, scene.global);
  }
}

void read_json_camera(JsonContext& context, JsonIndex key, Scene& scene) {
  if (!is_object_value(context, key)) {
    return;
  }
  const JsonFields fields(context, key + 1, camera::vocabulary);
  Camera& camera = scene.camera.emplace();
  camera.location = context.place(key);
  const ObjectReader reader{context, fields, camera.location, camera.unread, scene};
  camera::read_required(reader, Field::position, camera);
  camera::read_required(reader, Field::up, camera);
  camera::read_required(reader, Field::height_angle_deg, camera);
  camera::read_direction(reader, key + 1, camera);
  reader.read(camera_rows, Field::aperture, camera);
  reader.read(camera_rows, Field::focal_length, camera);
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
  light::require_keys(context, fields, item, light.type);
  light::report_unused_keys(context, fields, light.type);
  const ObjectReader reader{context, fields, light.location, light.unread, scene};
  for (std::size_t i = 0; i < std::size(light_rows); ++i) {
    const ValueRow<Light>& row = light_rows[i];
    if (!row.json.empty() && row.has_member() && row.used_by_type(light.type)) {
      reader.read(key_of(light_rows, i), row, light);
    }
  }
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
  const ObjectReader reader{context, fields, primitive.location, primitive.unread, scene};
  primitive::read_material(reader, primitive.material);
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
