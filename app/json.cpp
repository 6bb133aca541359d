#include "app/json.h"

#include "app/limit_table.h"
#include "app/names.h"
#include "scenefile/explain/object_names.h"
#include "scenefile/scene/vocabulary_words.h"
#include "scenefile/verbs/codes.h"
#include "scenefile/verbs/scene_json.h"

#include <algorithm>
#include <array>
#include <set>

namespace scenefile::app {

namespace {

void add_camera(Json& json, const Scene& scene) {
  const Camera camera = scene.camera.value_or(Camera{});
  json.begin_object("camera");
  json.add("default", !scene.camera.has_value());
  json.add("position", camera.position);
  json.add("look", camera.look);
  json.add("up", camera.up);
  json.add("height_angle_deg", camera.height_angle_deg);
  json.add("aperture", camera.aperture);
  json.add("focal_length", camera.focal_length);
  json.end_object();
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
  json.add("nodes", s.nodes);
  json.add("depth", s.depth);
  json.add("transforms", s.transforms);
  add_counts(json, "primitives", s.primitives, shape_words);
  add_counts(json, "lights", s.lights, light_words);
  json.add("templates", s.templates);
  json.add("instances", s.instances);
  json.add("instance_nesting", s.instance_nesting);
  json.add("virtual_primitives", s.virtual_primitives);
  json.add("virtual_lights", s.virtual_lights);
  json.add("materials", s.materials);
  json.add("textures", s.textures);
  json.add("meshes", s.meshes);
  json.end_object();
}

void add_file(Json& json, const AssetFile& file) {
  json.begin_object();
  json.add("kind", word_of(file.kind));
  json.add("name", file.reference.name);
  json.add("line", file.reference.location.line);
  if (!file.from.empty()) {
    json.add("file", file.from);
  }
  json.add("found", file.resolved.error.empty());
  json.add("rule", rule_text(file.resolved.rule));
  if (file.resolved.error.empty()) {
    json.add("path", file.resolved.path);
  } else {
    json.add("error", file.resolved.error);
  }
  json.begin_array("tried");
  for (const std::string& path : file.resolved.tried) {
    json.value(path);
  }
  json.end_array();
  json.end_object();
}

void add_face_material(Json& json, const FaceMaterial& m) {
  json.add("name", m.name);
  json.add("file", m.file);
  json.add("line", m.location.line);
  json.add("diffuse", m.diffuse);
  json.add("specular", m.specular);
  json.add("emission", m.emission);
  json.add("transmission", m.transmission);
  json.add("shininess", m.shininess);
  json.add("ior", m.ior);
  json.add("illum", m.illum);
}

void add_face_materials(Json& json, const LoadedScene& scene) {
  json.begin_array("face_materials");
  for (std::size_t i = 0; i < scene.assets.mesh_materials.size(); ++i) {
    const MeshMaterials& mesh = scene.assets.mesh_materials[i];
    const std::vector<std::size_t> triangles = triangles_of_materials(mesh);
    for (std::size_t k = 0; k < mesh.materials.size(); ++k) {
      json.begin_object();
      json.add("mesh", scene.ready.scene.mesh_files[i].name);
      json.add("triangles", triangles[k]);
      add_face_material(json, mesh.materials[k]);
      json.end_object();
    }
  }
  json.end_array();
}

void add_bounds(Json& json, const std::optional<Bounds>& bounds) {
  if (bounds.has_value()) {
    json.begin_object("bounds");
    json.add("min", bounds->min);
    json.add("max", bounds->max);
    json.end_object();
  }
}

void add_code(Json& json, const Code& code) {
  json.begin_object();
  json.add("name", code.name);
  json.add("severity", severity_name(code.severity));
  if (code.otherwise) {
    json.add("otherwise", severity_name(*code.otherwise));
  }
  json.add("dialect", code.kind == CodeKind::dialect);
  json.add("limit", code.kind == CodeKind::limit);
  json.add("summary", code.summary);
  json.add("help", code.help);
  json.end_object();
}

void add_cause(Json& json, const CauseHelp& page) {
  json.begin_object();
  json.add("name", name_of(page.cause));
  json.add("title", page.title);
  json.add("looks", page.looks);
  json.add("why", page.why);
  json.add("where", page.where);
  json.end_object();
}

void add_command(Json& json, const Command& command) {
  json.begin_object();
  json.add("name", command.name);
  json.add("arguments", command.arguments);
  json.add("summary", command.summary);
  json.begin_array("options");
  for (const OptionRow& row : option_table()) {
    if ((row.commands & command.bit) != 0) {
      json.begin_object();
      json.add("name", row.name);
      json.add("letter", row.letter);
      json.add("value", row.value);
      json.add("help", row.help);
      json.end_object();
    }
  }
  json.end_array();
  json.end_object();
}

}  // namespace

namespace {

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
  json.add("lights_drawn", std::uint64_t{report.lights});
  json.begin_array("lights_skipped");
  for (const SkippedLight& light : report.skipped_lights) {
    json.begin_object();
    json.add("type", word_of(light.type));
    add_location(json, light.location);
    json.end_object();
  }
  json.end_array();
}

void add_work(Json& json, const RenderReport& report) {
  json.add("engine", report.gl.renderer.empty() ? "trace" : "gl");
  if (!report.gl.renderer.empty()) {
    json.add("renderer", report.gl.renderer);
    json.add("draw_calls", std::uint64_t{report.gl.draw_calls});
    json.add("shadow_maps", std::uint64_t{report.gl.shadow_maps});
    json.add("objects", report.gl.objects);
    json.add("triangles", report.gl.triangles);
    return;
  }
  json.add("primary_rays", report.stats.primary_rays);
  json.add("shadow_rays", report.stats.shadow_rays);
  json.add("secondary_rays", report.stats.secondary_rays);
  json.add("build_seconds", report.stats.build_seconds);
  json.add("trace_seconds", report.stats.trace_seconds);
}

}  // namespace

std::string render_json(const LoadedScene& scene, const RenderReport& report) {
  const RenderOptions& options = report.options;
  Json json;
  begin_document(json, "render");
  json.key("scene");
  add_scene(json, scene);
  json.add("output", report.output);
  json.add("written", report.written);
  if (!report.error.empty()) {
    json.add("error", report.error);
  }
  if (report.realtime) {
    json.add("width", options.width);
    json.add("height", options.height);
    json.add("profile", "realtime");
    add_realtime(json, *report.realtime);
  } else {
    add_render_options(json, options);
  }
  if (std::any_of(options.layers.begin(), options.layers.end(),
                  [](const Layer& l) { return l.kind == LayerKind::object_id; })) {
    add_object_ids(json, scene);
  }
  if (report.store) {
    json.begin_object("store");
    json.add("found", report.store->found);
    json.add("drawn", report.store->drawn);
    json.begin_array("missing");
    for (const std::uint32_t share : report.store->missing) {
      json.value(share);
    }
    json.end_array();
    json.end_object();
  }
  add_work(json, report);
  json.add("seconds", report.seconds);
  json.end_object();
  return json.text();
}

std::string info_json(const LoadedScene& scene, const InfoReport* report) {
  Json json;
  begin_document(json, "info");
  json.key("scene");
  add_scene(json, scene);
  if (report != nullptr) {
    add_camera(json, scene.written);
    add_summary(json, report->summary);
    add_bounds(json, report->bounds);
    if (report->realtime) {
      json.begin_object("realtime");
      add_realtime(json, *report->realtime);
      json.add("shape_triangles", report->realtime->triangles);
      json.end_object();
    }
    json.begin_array("files");
    for (const AssetFile& file : report->files) {
      add_file(json, file);
    }
    json.end_array();
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
  json.add("output", report.output);
  json.add("format", format_words[static_cast<std::size_t>(report.format)]);
  json.add("written", report.error.empty());
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
  json.begin_array("files");
  for (const FormatReport& file : files) {
    json.begin_object();
    json.key("scene");
    json.raw(file.scene);
    json.add("changed", file.changed);
    if (!file.error.empty()) {
      json.add("error", file.error);
    }
    json.end_object();
  }
  json.end_array();
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
  Json json;
  add_command(json, command);
  return json.text();
}

std::string code_json(const Code& code) {
  Json json;
  add_code(json, code);
  return json.text();
}

std::string cause_json(Cause cause) {
  Json json;
  add_cause(json, help_of(cause));
  return json.text();
}

std::string vocabulary_json() {
  Json json;
  const auto add_words = [&](std::string_view name, std::span<const std::string_view> words) {
    json.begin_array(name);
    for (const std::string_view word : words) {
      json.value(word);
    }
    json.end_array();
  };
  begin_document(json, "help");
  json.begin_object("xml");
  for (const ElementWord& element : element_words()) {
    json.begin_object(element.name);
    json.add("about", element.about);
    add_words("children", element.children);
    json.begin_object("attributes");
    for (const AttributeWord& attribute : element.attributes) {
      json.begin_object(attribute.name);
      json.add("about", attribute.about);
      add_words("values", attribute.values);
      json.add("required", attribute.required);
      json.end_object();
    }
    json.end_object();
    json.end_object();
  }
  json.end_object();
  json.begin_object("json");
  for (const ObjectWord& object : object_words()) {
    json.begin_object(object.name);
    for (const KeyWord& key : object.keys) {
      json.begin_object(key.name);
      json.add("about", key.about);
      add_words("values", key.values);
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
  json.end_object();
  return json.text();
}

std::string help_json() {
  Json json;
  begin_document(json, "help");
  json.begin_array("commands");
  for (const Command& command : commands()) {
    add_command(json, command);
  }
  json.end_array();
  json.begin_array("codes");
  for (const Code* code : all_codes()) {
    add_code(json, *code);
  }
  json.end_array();
  json.begin_array("causes");
  for (std::size_t i = 0; i < cause_count; ++i) {
    add_cause(json, help_of(static_cast<Cause>(i)));
  }
  json.end_array();
  json.begin_array("limits");
  for (const LimitRow& limit : limit_table()) {
    json.begin_object();
    json.add("name", limit.name);
    json.add("default", limit.get({}));
    json.add("most", limit.most);
    json.add("help", limit.help);
    json.end_object();
  }
  json.end_array();
  json.end_object();
  return json.text();
}

}  // namespace scenefile::app
