#include "app/command.h"
#include "app/json.h"
#include "app/load.h"
#include "app/output.h"
#include "scenefile/base/text.h"
#include "scenefile/placement/bounds.h"
#include "scenefile/scene/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace scenefile::app {

namespace {

template <typename V>
std::string vector_text(const V& v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}

// "3 (2 point, 1 spot)".
template <std::size_t n>
std::string counts_text(const std::array<std::size_t, n>& counts,
                        const std::array<std::string_view, n>& names) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < n; ++i) {
    if (counts[i] != 0) {
      parts.push_back(fmt::format("{} {}", counts[i], names[i]));
    }
  }
  const std::size_t sum = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  return parts.empty() ? "0" : fmt::format("{} ({})", sum, fmt::join(parts, ", "));
}

// Exact within the precision of a double.
std::string virtual_text(double count) {
  constexpr double exact = 9e15;
  if (!std::isfinite(count)) {
    return "more than 10^308";
  }
  return count < exact ? fmt::format("{:.0f}", count) : fmt::format("about {:.3g}", count);
}

std::string camera_text(const Scene& scene) {
  const Camera camera = scene.camera.value_or(Camera{});
  std::string text = fmt::format("position {}, look {}, up {}, height angle {:.6g} degrees",
                                 vector_text(camera.position), vector_text(camera.look),
                                 vector_text(camera.up), camera.height_angle_deg);
  if (camera.aperture > 0) {
    text +=
        fmt::format(", aperture {:.6g}, focal length {:.6g}", camera.aperture, camera.focal_length);
  }
  return scene.camera.has_value() ? text : "none; by default " + text;
}

std::string bounds_text(const std::optional<Bounds>& bounds) {
  return bounds.has_value()
             ? fmt::format("{} to {}, size {}", vector_text(bounds->min), vector_text(bounds->max),
                           vector_text(bounds->max - bounds->min))
             : "nothing is drawn";
}

std::string files_text(const std::vector<AssetFile>& files, AssetKind kind) {
  const auto total =
      std::count_if(files.begin(), files.end(), [&](const AssetFile& f) { return f.kind == kind; });
  const auto missing = std::count_if(files.begin(), files.end(), [&](const AssetFile& f) {
    return f.kind == kind && !f.resolved.error.empty();
  });
  return missing == 0 ? fmt::format("{}", total) : fmt::format("{}, {} missing", total, missing);
}

std::string realtime_text(const RealtimeReport& report) {
  const TessellationParameters& parameters = report.options.tessellation;
  std::array<std::size_t, light_words.size()> skipped{};
  for (const SkippedLight& light : report.skipped_lights) {
    ++skipped[static_cast<std::size_t>(light.type)];
  }
  std::string text = fmt::format("{}: {} {} used, {:.0f} triangles of shapes with parameters {},{}",
                                 word_of(report.options.milestone), report.lights,
                                 report.lights == 1 ? "light is" : "lights are", report.triangles,
                                 parameters.parameter1, parameters.parameter2);
  if (!report.skipped_lights.empty()) {
    text += "; skipped lights: " + counts_text(skipped, light_words);
  }
  return text;
}

void append_line(std::string& text, std::string_view name, std::string_view value) {
  text += fmt::format("  {:<11} {}\n", name, value);
}

std::string face_material_text(const FaceMaterial& m) {
  const std::array<std::pair<std::string_view, glm::vec3>, 4> colors{
      {{"Ke", m.emission}, {"Kd", m.diffuse}, {"Ks", m.specular}, {"Tf", m.transmission}}};
  std::string text;
  for (const auto& [name, color] : colors) {
    if (color != glm::vec3(0)) {
      text += fmt::format(", {} {}", name, vector_text(color));
    }
  }
  return text + fmt::format(", Ns {:.6g}, Ni {:.6g}, illum {}", m.shininess, m.ior, m.illum);
}

// The materials of a mesh, such as "light: 2 triangles, Ke 17 12 4, ...".
void append_face_materials(std::string& text, const std::string& name, const MeshMaterials& mesh) {
  const std::vector<std::size_t> triangles = triangles_of_materials(mesh);
  if (!triangles.empty()) {
    text += fmt::format("  face materials of {}\n", escaped(name, 400));
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const FaceMaterial& m = mesh.materials[i];
    text += fmt::format("    {}: {}{}\n", escaped(m.name), counted(triangles[i], "triangle"),
                        face_material_text(m));
  }
}

std::string summary_text(const LoadedScene& scene, const InfoReport& report) {
  const SceneSummary& s = report.summary;
  std::string text = escaped(shown_name(scene.path)) + "\n";
  append_line(text, "camera", camera_text(scene.written));
  append_line(text, "lights", counts_text(s.lights, light_words));
  append_line(text, "objects", counts_text(s.primitives, shape_words));
  append_line(text, "drawn", virtual_text(s.virtual_primitives));
  append_line(text, "nodes", fmt::format("{}, {} deep", s.nodes, s.depth));
  append_line(text, "templates",
              fmt::format("{}, {} instances, nested {} deep", s.templates, s.instances,
                          s.instance_nesting));
  append_line(text, "transforms", fmt::format("{}", s.transforms));
  append_line(text, "materials", fmt::format("{}", s.materials));
  append_line(text, "bounds", bounds_text(report.bounds));
  append_line(text, "textures", files_text(report.files, AssetKind::texture));
  append_line(text, "meshes", files_text(report.files, AssetKind::mesh));
  if (report.realtime) {
    append_line(text, "realtime", realtime_text(*report.realtime));
  }
  for (std::size_t i = 0; i < scene.assets.mesh_materials.size(); ++i) {
    append_face_materials(text, scene.ready.scene.mesh_files[i].name,
                          scene.assets.mesh_materials[i]);
  }
  return text;
}

std::string file_text(const AssetFile& file) {
  const ResolvedAsset& resolved = file.resolved;
  const std::string place = file.from.empty() ? "" : " of " + escaped(file.from, 400);
  const std::string head =
      fmt::format("{} {} (line {}{}): ", word_of(file.kind), quoted(file.reference.name, 400),
                  file.reference.location.line, place);
  if (resolved.error.empty()) {
    return fmt::format("{}{}: {}\n", head, rule_text(resolved.rule), escaped(resolved.path, 4096));
  }
  std::string text = head + resolved.error + "\n";
  for (const std::string& note : resolved.notes) {
    text += fmt::format("    {}\n", escaped(note, 4096));
  }
  return text;
}

std::string list_files(const std::vector<AssetFile>& files) {
  std::string text;
  for (const AssetFile& file : files) {
    text += file_text(file);
  }
  return text;
}

constexpr std::size_t max_indent = 100;

struct Visit {
  NodeId node = 0;
  std::size_t depth = 0;
  std::size_t place = 0;  ///< among its siblings, from 1
};

template <typename T, std::size_t n, typename Kind>
void append_kinds(std::vector<std::string>& parts, const std::vector<T>& things,
                  const std::array<std::string_view, n>& names, std::string_view suffix,
                  Kind kind_of) {
  std::array<std::size_t, n> counts{};
  for (const T& thing : things) {
    ++counts[static_cast<std::size_t>(kind_of(thing))];
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (counts[i] != 0) {
      parts.push_back(fmt::format("{} {}{}{}", counts[i], names[i], suffix,
                                  counts[i] == 1       ? ""
                                  : names[i] == "mesh" ? "es"
                                                       : "s"));
    }
  }
}

// "T R S M", in the order of the file.
std::string transforms_text(const Node& node) {
  static constexpr std::string_view letters = "TRSM";
  std::string text;
  for (const Transform& t : node.transforms) {
    text += letters[t.map.index()];
  }
  return text;
}

std::string node_text(const Scene& scene, const Visit& visit) {
  const Node& node = scene.nodes[visit.node];
  std::vector<std::string> parts;
  if (const std::string transforms = transforms_text(node); !transforms.empty()) {
    parts.push_back(transforms);
  }
  if (!node.instance_of.empty()) {
    parts.push_back("copy of " + escaped(node.instance_of));
  }
  append_kinds(parts, node.primitives, shape_words, "", [](const Primitive& p) { return p.shape; });
  append_kinds(parts, node.lights, light_words, " light", [](const Light& l) { return l.type; });
  const std::string name = node.name.empty() ? fmt::format("#{}", visit.place) : escaped(node.name);
  return fmt::format("{}{}{}{}", std::string(2 * std::min(visit.depth, max_indent), ' '), name,
                     parts.empty() ? "" : ": ", fmt::format("{}", fmt::join(parts, ", ")));
}

// The scene graph as an indented list: templates first, then the root.
std::string tree_text(const Scene& scene) {
  std::vector<Visit> todo{{scene.root, 0, 1}};
  for (std::size_t i = scene.templates.size(); i-- > 0;) {
    todo.push_back({scene.templates[i], 0, i + 1});
  }
  std::string text;
  while (!todo.empty()) {
    const Visit visit = todo.back();
    todo.pop_back();
    text += node_text(scene, visit) + "\n";
    const std::vector<NodeId>& children = scene.nodes[visit.node].children;
    for (std::size_t i = children.size(); i-- > 0;) {
      todo.push_back({children[i], visit.depth + 1, i + 1});
    }
  }
  return text;
}

InfoReport make_report(const LoadedScene& scene, const Options& options, Context& context) {
  context.phase = "summing up";
  InfoReport report;
  report.summary = summarize(scene.written);
  report.files = locate_files(scene, options);
  if (const Bounds bounds = scene_bounds(scene.ready.scene, scene.assets); !bounds.empty()) {
    report.bounds = bounds;
  }
  if (const auto realtime = realtime_options(options)) {
    report.realtime = realtime_report(*realtime, scene);
  }
  if (options.tree) {
    report.tree = tree_text(scene.written);
  }
  return report;
}

}  // namespace

ExitCode run_info(const Options& options, Context& context) {
  // Meshes are loaded for their bounds; textures are only looked up.
  const LoadedScene scene = load_scene(options.arguments.front(), options, LoadDepth::with_meshes,
                                       /*allow_missing=*/true, context);
  const Outcome outcome = outcome_of(scene);
  if (!options.json) {
    say(findings_text(scene, Verbosity::warnings, wants_color(Stream::chatter)));
  }
  if (outcome.status != ExitCode::fine) {
    return options.json ? answer_json(outcome, info_json(scene, nullptr, outcome.error))
                        : outcome.status;
  }
  const InfoReport report = make_report(scene, options, context);
  if (options.json) {
    return answer(info_json(scene, &report));
  }
  return answer(summary_text(scene, report) + (options.files ? list_files(report.files) : "") +
                report.tree);
}

}  // namespace scenefile::app
