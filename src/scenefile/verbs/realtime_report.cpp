#include "scenefile/verbs/realtime_report.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/geometry/realtime_mesh.h"
#include "scenefile/verbs/codes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace scenefile {

namespace {

// The triangles of all shapes in the root group, including instances.
double count_triangles(const RenderScene& scene, const TessellationParameters& parameters) {
  std::array<double, shape_count> each{};
  for (std::size_t i = 0; i < shape_count; ++i) {
    each[i] =
        static_cast<double>(realtime_mesh(static_cast<Shape>(i), parameters).triangles.size());
  }
  std::vector<double> of_group;
  for (const RenderGroup& group : scene.groups) {
    double sum = 0;
    for (const RenderPrimitive& primitive : group.primitives) {
      sum += each[static_cast<std::size_t>(primitive.shape)];
    }
    for (const RenderInstance& instance : group.instances) {
      sum += of_group[instance.group];  // a group comes after the groups that it contains
    }
    of_group.push_back(sum);
  }
  return scene.root < of_group.size() ? of_group[scene.root] : 0;
}

std::vector<std::string_view> features_not_drawn(const RenderScene& scene) {
  const auto any = [&](const auto& test) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), test);
  };
  std::vector<std::string_view> result;
  if (any([](const RenderMaterial& m) { return m.texture.used() && m.blend != 0; })) {
    result.emplace_back("textures");
  }
  if (any([](const RenderMaterial& m) { return m.reflective != glm::vec3(0); })) {
    result.emplace_back("reflections");
  }
  if (any([](const RenderMaterial& m) { return m.transparent != glm::vec3(0); })) {
    result.emplace_back("transparency");
  }
  return result;
}

}  // namespace

RealtimeReport realtime_report(const RealtimeOptions& options, const LoadedScene& scene) {
  RealtimeReport report;
  report.options = options;
  for (const RenderLight& light : scene.ready.scene.lights) {
    if (has_light(options.milestone, light.type)) {
      ++report.lights;
    } else {
      report.skipped_lights.push_back(
          {light.type, place_of(scene.written, scene.ready.sources[light.source])});
    }
  }
  report.triangles = count_triangles(scene.ready.scene, options.tessellation);
  return report;
}

void check_realtime(const RealtimeOptions& options, LoadedScene& scene) {
  const RealtimeReport report = realtime_report(options, scene);
  const std::string_view milestone = word_of(options.milestone);
  for (const SkippedLight& light : report.skipped_lights) {
    const bool in_action = has_light(Milestone::action, light.type);
    scene.diagnostics.report(
        "realtime.light-skipped"_code, light.location,
        fmt::format("the milestone {} has no {} lights: this one is not used{}", milestone,
                    word_of(light.type), in_action ? "; --milestone action has them" : ""));
  }
  if (report.lights == 0 && !report.skipped_lights.empty()) {
    scene.diagnostics.report("realtime.no-light"_code, {},
                             fmt::format("none of the scene's lights is used in the milestone {}: "
                                         "the picture shows ambient light only",
                                         milestone));
  }
  if (const auto missing = features_not_drawn(scene.ready.scene); !missing.empty()) {
    scene.diagnostics.report(
        "realtime.not-drawn"_code, {},
        fmt::format("the scene has features that the assignment Realtime does not draw: {}",
                    fmt::join(missing, ", ")));
  }
}

}  // namespace scenefile
