// Pixels of the assignment Realtime. The rasterizer says which triangle a pixel shows; the tracer
// explains the light on that triangle alone, so both engines share one lighting equation.

#include "scenefile/verbs/explain.h"
#include "scenefile/verbs/render_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

using glm::dvec3;

dvec3 to_bytes(const dvec3& color) {
  return glm::round(glm::clamp(color, dvec3(0), dvec3(1)) * 255.0) / 255.0;
}

dvec3 mixed(const RealtimePixel& pixel, std::span<const dvec3> colors) {
  dvec3 sum(0);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    sum += pixel.shares[i].weight * to_bytes(colors[i]);
  }
  return glm::clamp(pixel.colors * sum + pixel.added, dvec3(0), dvec3(1));
}

// A scene in which one triangle, with the normal of the point everywhere, is all that can be hit.
// Its picture has one pixel, which shows the point.
struct OneTriangle {
  RenderScene scene;
  Assets assets;
};

OneTriangle one_triangle(const RenderScene& scene, const RealtimeSurface& surface,
                         Milestone milestone) {
  OneTriangle one;
  one.scene.global = scene.global;
  for (const RenderLight& light : scene.lights) {
    if (has_light(milestone, light.type)) {
      one.scene.lights.push_back(light);
    }
  }
  one.scene.materials = {scene.materials[surface.material]};
  one.scene.mesh_files.resize(1);
  RenderPrimitive primitive;
  primitive.group_from_object = surface.world_from_object;
  primitive.shape = Shape::mesh;
  primitive.mesh = 0;
  primitive.source = surface.object.source;
  one.scene.groups.resize(1);
  one.scene.groups[0].primitives = {primitive};
  // Moved so that the point is its centroid: a pixel at an edge may show a point just outside of
  // the triangle.
  const auto& corners = surface.object_corners;
  const dvec3 moved = surface.object_position - (corners[0] + corners[1] + corners[2]) / 3.0;
  Mesh mesh;
  for (const dvec3& corner : corners) {
    mesh.positions.emplace_back(corner + moved);
  }
  mesh.normals = {glm::vec3(surface.object_normal)};
  mesh.triangles = {{0, 1, 2}};
  mesh.triangle_normals = {{0, 0, 0}};
  one.assets.meshes.push_back(std::move(mesh));
  RenderCamera& camera = one.scene.camera;
  camera.position = scene.camera.position;
  const dvec3 point = DAffine(surface.world_from_object).point(surface.object_position);
  camera.w = glm::normalize(camera.position - point);
  const dvec3 aside = std::abs(camera.w.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  camera.u = glm::normalize(glm::cross(aside, camera.w));
  camera.v = glm::cross(camera.w, camera.u);
  return one;
}

// Replaces what is specific to the scene of one triangle by the values of the given scene, and adds
// the lights that the milestone does not draw.
void restore(const RenderScene& scene, const RealtimeSurface& surface, Milestone milestone,
             RayRecord& ray) {
  if (ray.surface.has_value()) {
    SurfaceRecord& record = *ray.surface;
    record.object = surface.object;
    record.shape = surface.shape;
    record.mesh = surface.mesh;
    record.triangle = surface.triangle;
    record.material = surface.material;
    record.has_uv = false;
  }
  std::vector<LightRecord> lights;
  auto known = ray.lights.begin();
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
    LightRecord light;
    if (!has_light(milestone, scene.lights[i].type)) {
      light.unlit = Unlit::in_this_mode;
    } else if (known != ray.lights.end()) {
      light = *known++;
    }
    light.light = i;
    lights.push_back(std::move(light));
  }
  ray.lights = std::move(lights);
}

RenderOptions options_of(const glm::ivec2& size) {
  RenderOptions options = default_options(Profile::fine);
  options.features = {false, false, false, false, false, false, false};
  options.width = size.x;
  options.height = size.y;
  options.samples = 1;
  options.threads = 1;
  return options;
}

Result<PixelRecord> record_of(const RenderScene& scene, const RealtimeSurface& surface,
                              Milestone milestone) {
  const OneTriangle one = one_triangle(scene, surface, milestone);
  const Explainer explainer(one.scene, one.assets, options_of({1, 1}));
  if (const std::optional<Error> error = render_error(explainer.status())) {
    return *error;
  }
  PixelRecord record = explainer.explain(0, 0);
  restore(scene, surface, milestone, record.rays.front());
  return record;
}

PixelRecord background_record() {
  PixelRecord record;
  record.options = options_of({1, 1});
  record.rays.emplace_back();
  return record;
}

}  // namespace

Result<ExplainReport> explain_realtime_pixel(const LoadedScene& scene, const RealtimeOptions& panel,
                                             const glm::ivec2& size, const glm::ivec2& pixel,
                                             std::optional<std::uint32_t> sample) {
  const RenderScene& ready = scene.ready.scene;
  std::optional<RealtimePixel> found = realtime_pixel(ready, scene.assets, panel, size, pixel);
  if (!found) {
    return Error{fmt::format("pixels of scenes with more than {:.0f} shapes are not explained",
                             max_explained_shapes),
                 ErrorKind::limit};
  }
  if (const auto error = no_such_sample(sample, found->shares.size())) {
    return *error;
  }
  ExplainReport report;
  RealtimeRecord& realtime = report.realtime.emplace();
  realtime.panel = panel;
  realtime.pixel = *std::move(found);
  std::vector<SampleRecord> samples;
  std::vector<dvec3> colors;
  for (const RealtimeFramePixel& share : realtime.pixel.shares) {
    Result<PixelRecord> record = share.surface ? record_of(ready, *share.surface, panel.milestone)
                                               : Result<PixelRecord>(background_record());
    if (!record) {
      return record.error();
    }
    SampleRecord& of_frame = samples.emplace_back();
    of_frame.point = (glm::dvec2(share.at) + 0.5) / glm::dvec2(realtime.pixel.frame);
    of_frame.point = glm::dvec2(of_frame.point.x, 1 - of_frame.point.y) * glm::dvec2(size);
    of_frame.color = record->color;
    of_frame.rays = 1;
    if (share.surface) {
      of_frame.object = share.surface->object;
    }
    colors.push_back(record->color);
    realtime.shares.push_back(*std::move(record));
  }
  const std::uint32_t shown = sample.value_or(0);
  report.pixel = realtime.shares[shown];
  report.pixel.x = pixel.x;
  report.pixel.y = pixel.y;
  report.pixel.options = options_of(size);
  report.pixel.samples = std::move(samples);
  report.pixel.shown = shown;
  report.pixel.color = mixed(realtime.pixel, colors);
  for (int c = 0; c < 3; ++c) {
    report.pixel.picture[std::size_t(c)] = static_cast<float>(report.pixel.color[c]);
    report.pixel.value[std::size_t(c)] =
        quantize(report.pixel.picture[std::size_t(c)], Rounding::nearest);
  }
  report.remarks = remarks(ready, report.pixel);
  return report;
}

void add_yours(const LoadedScene& scene, const std::array<std::uint8_t, 3>& value,
               ExplainReport& report) {
  const RenderScene& ready = scene.ready.scene;
  if (!report.realtime) {
    report.yours = compare_with_yours(ready, report.pixel, value);
    return;
  }
  const RealtimePixel& pixel = report.realtime->pixel;
  const auto pixel_of = [&](std::span<const dvec3> colors) { return mixed(pixel, colors); };
  report.yours = compare_with_yours(ready, report.realtime->shares, pixel_of, value);
}

}  // namespace scenefile
