#include "app/json.h"

#include "app/codes_page.h"
#include "app/limit_table.h"
#include "app/names.h"
#include "scenefile/explain/object_names.h"
#include "scenefile/scene/vocabulary_words.h"
#include "scenefile/verbs/codes.h"
#include "scenefile/verbs/scene_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace scenefile::app {

namespace {

void add_camera(Json& json, const Scene& scene) {
  const Camera camera = scene.camera.value_or(Camera{});
  json.add_object("camera", {{"default", !scene.camera.has_value()},
                             {"position", camera.position},
                             {"look", camera.look},
                             {"up", camera.up},
                             {"height_angle_deg", camera.height_angle_deg},
                             {"aperture", camera.aperture},
                             {"focal_length", camera.focal_length}});
}

template <std::size_t n>
void add_counts(Json& json, std::string_view name, const std::array<std::size_t, n>& counts,
                const std::array<std::string_view, n>& names) {
  json.begin_object(name);
  for (std::size_t i = 0; i < n; ++i) {
    json.add(names[i], counts[i]);
  }
  json.end_object();
}

void add_summary(Json& json, const SceneSummary& s) {
  json.begin_object("summary");
  json.add({{"nodes", s.nodes}, {"depth", s.depth}, {"transforms", s.transforms}});
  add_counts(json, "primitives", s.primitives, shape_words);
  add_counts(json, "lights", s.lights, light_words);
  json.add({{"templates", s.templates},
            {"instances", s.instances},
            {"instance_nesting", s.instance_nesting},
            {"virtual_primitives", s.virtual_primitives},
            {"virtual_lights", s.virtual_lights},
            {"materials", s.materials},
            {"textures", s.textures},
            {"meshes", s.meshes}});
  json.end_object();
}

void add_file(Json& json, const AssetFile& file) {
  json.add({{"kind", word_of(file.kind)},
            {"name", file.reference.name},
            {"line", file.reference.location.line}});
  if (!file.from.empty()) {
    json.add("file", file.from);
  }
  const bool found = file.resolved.error.empty();
  json.add({{"found", found},
            {"rule", rule_text(file.resolved.rule)},
            {found ? "path" : "error", found ? file.resolved.path : file.resolved.error},
            {"tried", file.resolved.tried}});
}

void add_face_materials(Json& json, const LoadedScene& scene) {
  json.begin_array("face_materials");
  for (std::size_t i = 0; i < scene.assets.mesh_materials.size(); ++i) {
    const MeshMaterials& mesh = scene.assets.mesh_materials[i];
    const std::vector<std::size_t> triangles = triangles_of_materials(mesh);
    for (std::size_t k = 0; k < mesh.materials.size(); ++k) {
      const FaceMaterial& m = mesh.materials[k];
      json.begin_object();
      json.add({{"mesh", scene.ready.scene.mesh_files[i].name},
                {"triangles", triangles[k]},
                {"name", m.name},
                {"file", m.file},
                {"line", m.location.line},
                {"diffuse", m.diffuse},
                {"specular", m.specular},
                {"emission", m.emission},
                {"transmission", m.transmission},
                {"shininess", m.shininess},
                {"ior", m.ior},
                {"illum", m.illum}});
      json.end_object();
    }
  }
  json.end_array();
}

void add_code(Json& json, const Code& code) {
  json.add({{"name", code.name}, {"severity", severity_name(code.severity)}});
  if (code.otherwise) {
    json.add("otherwise", severity_name(*code.otherwise));
  }
  json.add({{"dialect", code.kind == CodeKind::dialect},
            {"limit", code.kind == CodeKind::limit},
            {"summary", code.summary},
            {"help", code.help}});
}

void add_cause(Json& json, const CauseHelp& page) {
  json.add({{"name", name_of(page.cause)},
            {"title", page.title},
            {"looks", page.looks},
            {"why", page.why},
            {"where", page.where}});
}

void add_command(Json& json, const Command& command) {
  json.add(
      {{"name", command.name}, {"arguments", command.arguments}, {"summary", command.summary}});
  json.add_objects("options", options_of(command), [&](const OptionRow* row) {
    json.add(
        {{"name", row->name}, {"letter", row->letter}, {"value", row->value}, {"help", row->help}});
  });
}

// Those of a family, or all.
void add_codes(Json& json, std::string_view family) {
  std::vector<const Code*> codes;
  for (const Code* const code : all_codes()) {
    if (family.empty() || family_of(*code) == family) {
      codes.push_back(code);
    }
  }
  json.add_objects("codes", codes, [&](const Code* code) { add_code(json, *code); });
}

void add_causes(Json& json) {
  json.begin_array("causes");
  for (std::size_t i = 0; i < cause_count; ++i) {
    json.begin_object();
    add_cause(json, help_of(static_cast<Cause>(i)));
    json.end_object();
  }
  json.end_array();
}

void add_limits(Json& json) {
  json.add_objects("limits", limit_table(), [&](const LimitRow& limit) {
    json.add({{"name", limit.name},
              {"default", limit.get({})},
              {"most", limit.most},
              {"help", limit.help}});
  });
}

// An answer of help.
template <typename AddMembers>
std::string help_document(const AddMembers& add_members) {
  Json json;
  begin_document(json, "help");
  add_members(json);
  json.end_object();
  return json.text();
}

// The numbers of objects in the layer object-id.
void add_object_ids(Json& json, const LoadedScene& scene) {
  json.begin_array("objects");
  const ObjectNames names(scene.written, scene.ready.sources);
  std::set<std::uint32_t> listed;
  for (const RenderGroup& group : scene.ready.scene.groups) {
    for (const RenderPrimitive& primitive : group.primitives) {
      if (listed.insert(primitive.source).second) {
        const WayPoint object = names.at(primitive.source);
        json.begin_object();
        json.add("id", primitive.source + 1);
        json.add("node", object.path);
        json.add("line", object.location.line);
        json.end_object();
      }
    }
  }
  json.end_array();
}

void add_realtime(Json& json, const RealtimeReport& report) {
  add_realtime_options(json, report.options);
  json.add("lights_drawn", report.lights);
  json.add_objects("lights_skipped", report.skipped_lights, [&](const SkippedLight& light) {
    json.add("type", word_of(light.type));
    add_location(json, light.location);
  });
}

void add_work(Json& json, const RenderReport& report) {
  if (!report.gl.renderer.empty()) {
    json.add({{"engine", "gl"},
              {"renderer", report.gl.renderer},
              {"draw_calls", report.gl.draw_calls},
              {"shadow_maps", report.gl.shadow_maps},
              {"objects", report.gl.objects},
              {"triangles", report.gl.triangles}});
    return;
  }
  json.add({{"engine", "trace"},
            {"primary_rays", report.stats.primary_rays},
            {"shadow_rays", report.stats.shadow_rays},
            {"secondary_rays", report.stats.secondary_rays},
            {"build_seconds", report.stats.build_seconds},
            {"trace_seconds", report.stats.trace_seconds}});
}

// In the words of JSON Schema.
void add_range(Json& json, const NumberRange& range) {
  if (std::isfinite(range.low)) {
    json.add(range.open_low ? "exclusiveMinimum" : "minimum", range.low);
  }
  if (std::isfinite(range.high)) {
    json.add(range.open_high ? "exclusiveMaximum" : "maximum", range.high);
  }
}

}  // namespace

std::string render_json(const LoadedScene& scene, const RenderReport& report) {
  const RenderOptions& options = report.options;
  Json json;
  begin_document(json, "render");
  json.key("scene");
  add_scene(json, scene);
  json.add({{"output", report.output}, {"written", report.written}});
  if (!report.error.empty()) {
    json.add("error", report.error);
  }
  if (report.realtime) {
    json.add({{"width", options.width}, {"height", options.height}, {"profile", "realtime"}});
    add_realtime(json, *report.realtime);
  } else {
    add_render_options(json, options);
  }
  if (std::any_of(options.layers.begin(), options.layers.end(),
                  [](const Layer& l) { return l.kind == LayerKind::object_id; })) {
    add_object_ids(json, scene);
  }
  if (report.store) {
    json.add_object("store", {{"found", report.store->found},
                              {"drawn", report.store->drawn},
                              {"missing", report.store->missing}});
  }
  add_work(json, report);
  json.add("seconds", report.seconds);
  json.end_object();
  return json.text();
}

std::string info_json(const LoadedScene& scene, const InfoReport* report,
                      const std::string& error) {
  Json json;
  begin_document(json, "info");
  json.key("scene");
  add_scene(json, scene);
  if (!error.empty()) {
    json.add("error", error);
  }
  if (report != nullptr) {
    add_camera(json, scene.written);
    add_summary(json, report->summary);
    if (report->bounds) {
      json.add_object("bounds", {{"min", report->bounds->min}, {"max", report->bounds->max}});
    }
    if (report->realtime) {
      json.begin_object("realtime");
      add_realtime(json, *report->realtime);
      json.add("shape_triangles", report->realtime->triangles);
      json.end_object();
    }
    json.add_objects("files", report->files, [&](const AssetFile& file) { add_file(json, file); });
    add_face_materials(json, scene);
    if (!report->tree.empty()) {
      json.add("tree", report->tree);
    }
  }
  json.end_object();
  return json.text();
}

std::string convert_json(const LoadedScene& scene, const ConvertReport& report) {
  Json json;
  begin_document(json, "convert");
  json.key("scene");
  add_scene(json, scene);
  json.add({{"output", report.output},
            {"format", word_of(report.format)},
            {"written", report.error.empty()}});
  if (!report.error.empty()) {
    json.add("error", report.error);
  }
  json.end_object();
  return json.text();
}

std::string format_json(const std::vector<FormatReport>& files, bool check) {
  Json json;
  begin_document(json, "format");
  json.add("check", check);
  json.add_objects("files", files, [&](const FormatReport& file) {
    json.key("scene");
    json.raw(file.scene);
    json.add("changed", file.changed);
    if (!file.error.empty()) {
      json.add("error", file.error);
    }
  });
  json.end_object();
  return json.text();
}

std::string failure_json(std::string_view command, std::string_view error,
                         std::string_view configuration) {
  Json json;
  begin_document(json, command);
  json.add("error", error);
  if (!configuration.empty()) {
    json.key("configuration");
    json.raw(configuration);
  }
  json.end_object();
  return json.text();
}

std::string command_json(const Command& command) {
  return help_document([&](Json& json) { add_command(json, command); });
}

std::string code_json(const Code& code) {
  return help_document([&](Json& json) { add_code(json, code); });
}

std::string cause_json(Cause cause) {
  return help_document([&](Json& json) { add_cause(json, help_of(cause)); });
}

std::string vocabulary_json(std::string_view name) {
  const auto wanted = [&](std::string_view word) { return name.empty() || word == name; };
  Json json;
  begin_document(json, "help");
  json.begin_object("xml");
  for (const ElementWord& element : element_words()) {
    if (!wanted(element.name)) {
      continue;
    }
    json.begin_object(element.name);
    json.add({{"about", element.about}, {"children", element.children}});
    json.begin_object("attributes");
    for (const AttributeWord& attribute : element.attributes) {
      json.add_object(attribute.name, {{"about", attribute.about},
                                       {"values", attribute.values},
                                       {"required", attribute.required}});
    }
    json.end_object();
    json.end_object();
  }
  json.end_object();
  json.begin_object("json");
  for (const ObjectWord& object : object_words()) {
    if (!name.empty() && find_key(object, name) == nullptr) {
      continue;
    }
    json.begin_object(object.name);
    for (const KeyWord& key : object.keys) {
      if (!wanted(key.name)) {
        continue;
      }
      json.begin_object(key.name);
      json.add({{"title", key.title}, {"about", key.about}, {"values", key.values}});
      if (!key.object.empty()) {
        json.add("in", key.object);
      }
      if (!key.example.empty()) {
        json.add("example", key.example);
      }
      json.end_object();
    }
    json.end_object();
  }
  json.end_object();
  std::vector<const ValueWord*> values;
  for (const ValueWord& value : value_words()) {
    if (wanted(value.xml) || wanted(value.json)) {
      values.push_back(&value);
    }
  }
  json.add_objects("values", values, [&](const ValueWord* row) {
    const ValueWord& value = *row;
    json.add({{"block", value.block},
              {"xml", value.xml},
              {"json", value.json},
              {"kind", word_of(value.kind)},
              {"repeats", value.repeats},
              {"required_in_xml", value.required_in_xml},
              {"required_in_json", value.required_in_json}});
    if (!value.fallback.empty()) {
      json.add("default", value.fallback);
    }
    if (!value.assumed_in_xml.empty()) {
      json.add("assumed_in_xml", value.assumed_in_xml);
    }
    add_range(json, value.range);
    if (!value.used_by.empty()) {
      json.add({{"used_by", value.used_by}, {"needed_by", value.needed_by}});
    }
  });
  json.end_object();
  return json.text();
}

std::string codes_json(std::string_view family, std::optional<Cause> cause) {
  return help_document([&](Json& json) {
    add_codes(json, family);
    if (cause) {
      json.add_objects("causes", std::array{*cause},
                       [&](Cause one) { add_cause(json, help_of(one)); });
    }
  });
}

std::string causes_json() {
  return help_document(add_causes);
}

std::string limits_json() {
  return help_document(add_limits);
}

std::string help_json() {
  return help_document([](Json& json) {
    json.add_objects("commands", commands(), [&](const Command& c) { add_command(json, c); });
    add_codes(json, {});
    add_causes(json);
    add_limits(json);
  });
}

}  // namespace scenefile::app
