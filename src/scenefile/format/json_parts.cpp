#include "scenefile/format/json_parts.h"

#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/direction.h"
#include "scenefile/format/json_codes.h"
#include "scenefile/format/large_scene.h"
#include "scenefile/format/other_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace scenefile {

namespace {

// Takes over a value that could be read.
template <typename Member, typename Value>
void assign(Member& member, const std::optional<Value>& value) {
  member = value.value_or(Value(not_known));
}

// Reads values of one object into members and notes where they stand.
class Assigner {
 public:
  Assigner(JsonContext& context, const JsonFields& fields, Location owner, Scene& scene)
      : context_(context), fields_(fields), owner_(owner), scene_(scene) {}

  template <typename Member>
  void number(std::size_t key, Field field, Member& member) {
    read(key, field, member, number_value);
  }
  void vector(std::size_t key, Field field, glm::vec3& member) {
    read(key, field, member, vector_value);
  }
  void required_vector(std::size_t key, Field field, glm::vec3& member) {
    if (!fields_.require(key)) {
      member = glm::vec3(not_known);
    }
    vector(key, field, member);
  }
  void color(std::size_t key, Field field, glm::vec3& member) {
    read(key, field, member, color_value);
  }
  // Of a material.
  void shade(std::size_t key, Field field, glm::vec3& member) {
    if (!fields_.has(key)) {
      return;
    }
    assign(member, color_value(context_, fields_.key(key)));
    if (needs_place(field, member)) {
      note(key, field);
    }
  }

 private:
  template <typename Member, typename Read>
  void read(std::size_t key, Field field, Member& member, Read read_value) {
    if (!fields_.has(key)) {
      return;
    }
    assign(member, read_value(context_, fields_.key(key)));
    note(key, field);
  }
  void note(std::size_t key, Field field) {
    scene_.field_places.push_back({owner_, field, context_.place(fields_.key(key))});
  }

  JsonContext& context_;
  const JsonFields& fields_;
  Location owner_;
  Scene& scene_;
};

bool is_object(JsonContext& context, JsonIndex item, std::string_view what) {
  if (context.tape.is_object(item)) {
    return true;
  }
  context.report(
      json_wrong_type, item,
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
        json_unused_key, fields.key(key),
        fmt::format("{} has no effect {}", quoted(context.tape.string(fields.key(key))), why));
  }
}

// What an extension could be called.
bool is_identifier(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

// What an unknown type means: a word of ours, a light among primitives, or what there is.
std::string type_hint(std::string_view word, std::span<const std::string_view> names) {
  if (const std::string_view ours = in_our_words(word, names); !ours.empty()) {
    return fmt::format("; did you mean \"{}\"?", ours);
  }
  const bool is_light =
      std::find(light_words.begin(), light_words.end(), word) != light_words.end();
  return is_light ? "; lights stand in the list \"lights\" of a group"
                  : fmt::format("; known are {}", fmt::join(names, ", "));
}

// The place of the "type" of a light or primitive in `names`, after an error of the one that was
// probably meant; nothing, with a report, when it is none of them.
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
  const bool misspelt = !near.empty();
  context.diagnostics.report(unknown,
                             misspelt || !is_identifier(*name) ? Severity::error : unknown.severity,
                             context.place(key + 1),
                             fmt::format("unknown {} type {}{}", what, quoted(*name),
                                         misspelt ? fmt::format("; did you mean \"{}\"?", near)
                                                  : type_hint(*name, names)));
  const auto meant = std::find(names.begin(), names.end(), near);
  return misspelt ? std::optional<std::size_t>(meant - names.begin()) : std::nullopt;
}

namespace global {
enum Key { ambient, diffuse, specular, transparent };
constexpr std::string_view names[] = {"ambientCoeff", "diffuseCoeff", "specularCoeff",
                                      "transparentCoeff"};
constexpr JsonVocabulary vocabulary{"globalData", names};
}  // namespace global

namespace camera {
enum Key { position, up, height_angle, look, focus, aperture, focal_length };
constexpr std::string_view names[] = {"position", "up",       "heightAngle", "look",
                                      "focus",    "aperture", "focalLength"};
constexpr JsonVocabulary vocabulary{"cameraData", names};

// A focus is a point to look at; behind the reader there are directions only.
void read_direction(JsonContext& context, JsonIndex object, const JsonFields& fields,
                    Assigner& assigner, Camera& camera) {
  if (fields.has(look) && fields.has(focus)) {
    const JsonIndex second = std::max(fields.key(look), fields.key(focus));
    context.report(json_look_and_focus, second,
                   "cameraData has both \"look\" and \"focus\"; remove one of them");
    camera.look = glm::vec3(not_known);
    return;
  }
  if (!fields.has(look) && !fields.has(focus)) {
    context.report(json_missing_key, object,
                   "cameraData must have one of the keys \"look\" and \"focus\"");
    camera.look = glm::vec3(not_known);
  }
  assigner.vector(look, Field::look, camera.look);
  if (fields.has(focus)) {
    glm::vec3 point = camera.position + camera.look;
    assigner.vector(focus, Field::look, point);
    camera.look = direction_to(point, camera.position);
  }
}
}  // namespace camera

namespace light {
enum Key { type, color, name, attenuation, direction, penumbra, angle, width, height };
constexpr std::string_view names[] = {"type",      "color",    "name",  "attenuationCoeff",
                                      "direction", "penumbra", "angle", "width",
                                      "height"};
constexpr JsonVocabulary vocabulary{"a light", names};

// The format text: without a type a light is a point light. What has no color either is none.
std::optional<std::size_t> read_kind(JsonContext& context, const JsonFields& fields,
                                     JsonIndex item) {
  if (fields.has(type)) {
    return read_type(context, fields, "light", light_words, json_unknown_light_type);
  }
  if (fields.has(color)) {
    context.report(json_light_default, item,
                   "a light must have the key \"type\"; it counts as a point light");
    return static_cast<std::size_t>(LightType::point);
  }
  context.report(json_no_light, item,
                 "this is no light, it has neither \"type\" nor \"color\", and is left out");
  return std::nullopt;
}

void report_unused_keys(JsonContext& context, const JsonFields& fields, LightType kind) {
  const std::string why = fmt::format("on a {} light", light_words[static_cast<std::size_t>(kind)]);
  if (kind == LightType::point) {
    report_unused(context, fields, direction, why);
  }
  if (kind == LightType::directional) {
    report_unused(context, fields, attenuation, why);
  }
  if (kind != LightType::spot) {
    report_unused(context, fields, penumbra, why);
    report_unused(context, fields, angle, why);
  }
  if (kind != LightType::area) {
    report_unused(context, fields, width, why);
    report_unused(context, fields, height, why);
  }
}

void report_default(JsonContext& context, const JsonFields& fields, JsonIndex item, std::size_t key,
                    LightType kind, std::string_view value) {
  if (!fields.has(key)) {
    context.report(json_light_default, item,
                   fmt::format("a {} light must have the key \"{}\"; {} is used",
                               light_words[static_cast<std::size_t>(kind)], names[key], value));
  }
}

// A direction and an angle that are missing are for check() to judge.
void require_keys(JsonContext& context, const JsonFields& fields, JsonIndex item, LightType kind) {
  fields.require(color);
  if (kind == LightType::point || kind == LightType::spot) {
    report_default(context, fields, item, attenuation, kind, "1 0 0 (no falloff)");
  }
  if (kind == LightType::spot) {
    report_default(context, fields, item, penumbra, kind, "0 (a hard edge)");
  }
}
}  // namespace light

namespace primitive {
enum Key {
  type,
  mesh_file,
  ambient,
  diffuse,
  specular,
  reflective,
  transparent,
  shininess,
  ior,
  blend,
  texture_file,
  texture_u,
  texture_v,
  bump_file,
  bump_u,
  bump_v
};
constexpr std::string_view names[] = {"type",     "meshFile",    "ambient",     "diffuse",
                                      "specular", "reflective",  "transparent", "shininess",
                                      "ior",      "blend",       "textureFile", "textureU",
                                      "textureV", "bumpMapFile", "bumpMapU",    "bumpMapV"};
constexpr JsonVocabulary vocabulary{"a primitive", names};
static_assert(std::size(names) <= JsonFields::max_keys);

// The course's reader takes anything that is no number for 1.
float read_repeat(JsonContext& context, const JsonFields& fields, std::size_t key) {
  if (!fields.has(key)) {
    return 1;
  }
  const JsonIndex at = fields.key(key);
  if (context.tape.is_number(at + 1)) {
    return number_value(context, at).value_or(not_known);
  }
  context.diagnostics.report(
      json_wrong_type, Severity::warning, context.place(at),
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

void read_material(JsonContext& context, const JsonFields& fields, Assigner& assigner,
                   Material& material) {
  assigner.shade(ambient, Field::ambient, material.ambient);
  assigner.shade(diffuse, Field::diffuse, material.diffuse);
  assigner.shade(specular, Field::specular, material.specular);
  assigner.shade(reflective, Field::reflective, material.reflective);
  assigner.shade(transparent, Field::transparent, material.transparent);
  assigner.number(shininess, Field::shininess, material.shininess);
  assigner.number(ior, Field::ior, material.ior);
  assigner.number(blend, Field::blend, material.blend);
  material.texture = read_texture(context, fields, texture_file);
  if (fields.has(texture_file) && !material.texture) {
    material.blend = not_known;  // or rather, whether there is anything to blend
  }
  material.bump_map = read_texture(context, fields, bump_file);
}
}  // namespace primitive

}  // namespace

void read_json_global(JsonContext& context, JsonIndex key, Scene& scene) {
  if (!is_object_value(context, key)) {
    return;
  }
  const JsonFields fields(context, key + 1, global::vocabulary);
  scene.global.location = context.place(key);
  Assigner assigner(context, fields, scene.global.location, scene);
  fields.require(global::ambient);
  fields.require(global::diffuse);
  fields.require(global::specular);
  assigner.number(global::ambient, Field::ambient, scene.global.ambient);
  assigner.number(global::diffuse, Field::diffuse, scene.global.diffuse);
  assigner.number(global::specular, Field::specular, scene.global.specular);
  assigner.number(global::transparent, Field::transparent, scene.global.transparent);
}

void read_json_camera(JsonContext& context, JsonIndex key, Scene& scene) {
  if (!is_object_value(context, key)) {
    return;
  }
  const JsonFields fields(context, key + 1, camera::vocabulary);
  Camera& camera = scene.camera.emplace();
  camera.location = context.place(key);
  Assigner assigner(context, fields, camera.location, scene);
  assigner.required_vector(camera::position, Field::position, camera.position);
  assigner.required_vector(camera::up, Field::up, camera.up);
  if (fields.require(camera::height_angle)) {
    assigner.number(camera::height_angle, Field::height_angle_deg, camera.height_angle_deg);
  }
  camera::read_direction(context, key + 1, fields, assigner, camera);
  assigner.number(camera::aperture, Field::aperture, camera.aperture);
  assigner.number(camera::focal_length, Field::focal_length, camera.focal_length);
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
  if (light.type == LightType::area) {
    context.report(json_area_light, fields.key(light::type),
                   "the course's JSON reader knows no area lights and refuses the file");
  }
  light::require_keys(context, fields, item, light.type);
  light::report_unused_keys(context, fields, light.type);
  if (fields.has(light::name)) {
    light.name =
        text_value(context, fields.key(light::name), context.limits.name_bytes).value_or("");
  }
  Assigner assigner(context, fields, light.location, scene);
  assigner.color(light::color, Field::color, light.color);
  if (light.type != LightType::directional) {
    assigner.vector(light::attenuation, Field::attenuation, light.attenuation);
  }
  if (light.type != LightType::point) {
    assigner.vector(light::direction, Field::direction, light.direction);
  }
  if (light.type == LightType::spot) {
    assigner.number(light::penumbra, Field::penumbra_deg, light.penumbra_deg);
    assigner.number(light::angle, Field::angle_deg, light.angle_deg);
  }
  if (light.type == LightType::area) {
    assigner.number(light::width, Field::width, light.width);
    assigner.number(light::height, Field::height, light.height);
  }
  return light;
}

std::optional<Primitive> read_json_primitive(JsonContext& context, JsonIndex item, Scene& scene) {
  if (!is_object(context, item, "a primitive")) {
    return std::nullopt;
  }
  const JsonFields fields(context, item, primitive::vocabulary);
  const std::optional<std::size_t> type =
      read_type(context, fields, "primitive", shape_words, json_unknown_primitive_type);
  if (!type) {
    return std::nullopt;
  }
  Primitive primitive;
  primitive.shape = static_cast<Shape>(*type);
  primitive.location = context.place(item);
  Assigner assigner(context, fields, primitive.location, scene);
  primitive::read_material(context, fields, assigner, primitive.material);
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
