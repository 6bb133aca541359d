#include "scenefile/path/explain_path.h"

#include "scenefile/path/path_kernel.h"
#include "scenefile/path/path_state.h"
#include "scenefile/trace/no_denormals.h"
#include "scenefile/trace/ray_tree_recorder.h"
#include "scenefile/trace/tasks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile {

namespace {

std::uint32_t nearest_to_center(const PathPixel& pixel) {
  std::uint32_t best = 0;
  double least = 2;
  for (std::uint32_t i = 0; i < pixel.samples.size(); ++i) {
    const double distance =
        glm::length(pixel.samples[i].point - glm::dvec2(pixel.x + 0.5, pixel.y + 0.5));
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return best;
}

std::optional<ObjectRef> occluder_of(const PathScene& scene, const PathVertex& vertex,
                                     const PathLight& light) {
  const Tracer& tracer = scene.tracer;
  std::optional<ObjectRef> darkest;
  if (!light.shadow_ray || light.visibility == Color(1)) {
    return darkest;
  }
  const Ray ray{vertex.point.position, light.to_light};
  double least = 2;  // light that one object leaves
  Hit hit;
  for (double from = vertex.point.offset;
       least > 0 && tracer.accelerator.closest(ray, from, light.distance, hit); from = hit.t) {
    const bool is_lamp = light.light == no_index;
    const double left =
        is_lamp
            ? 0
            : luminance(Transmission::factor(scene.transmission.density(hit.material, hit.mesh)));
    if (left < least) {
      least = left;
      darkest = object_at(tracer, ray, from, hit.source);
    }
  }
  return darkest;
}

void name_objects(const PathScene& scene, PathPixel& pixel) {
  const Tracer& tracer = scene.tracer;
  for (const PathVertex& vertex : pixel.path.vertices) {
    pixel.objects.push_back(object_at(tracer, vertex.ray, vertex.start, vertex.source));
    for (std::uint32_t i = 0; i < vertex.lights; ++i) {
      pixel.occluders.push_back(
          occluder_of(scene, vertex, pixel.path.lights[vertex.first_light + i]));
    }
  }
}

}  // namespace

RenderStatus explain_path(const RenderScene& scene, const Assets& assets,
                          const RenderOptions& options, int x, int y,
                          std::optional<std::uint32_t> sample, PathPixel& pixel) {
  const ThreadLimit limit(options.threads);
  const TraceScene traced(scene, assets, {.threads = options.threads, .instance_names = true});
  if (traced.status() != RenderStatus::complete) {
    return traced.status();
  }
  const PathScene paths(traced, scene, options);
  const NoDenormals no_denormals;
  pixel = PathPixel();
  pixel.x = x;
  pixel.y = y;
  pixel.options = paths.options;
  RenderOptions only = paths.options;
  only.crop = PixelRegion{x, y, x + 1, y + 1};
  only.denoise = false;
  only.layers.clear();
  PathState state = make_path_state(only);
  RayCounts counts;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(only.samples); ++i) {
    const Color light = path_light(paths, x, y, i, counts, &pixel.path);
    pixel.samples.push_back({pixel.path.point, pixel.path.lens, light,
                             static_cast<std::uint32_t>(pixel.path.vertices.size())});
    add_sample(light, 0, state);
  }
  pixel.shown =
      sample.value_or(no_index) < pixel.samples.size() ? *sample : nearest_to_center(pixel);
  path_light(paths, x, y, pixel.shown, counts, &pixel.path);
  name_objects(paths, pixel);
  const Image image = image_of(state);
  std::copy(image.rgb.begin(), image.rgb.end(), pixel.picture.begin());
  pixel.standard_error = state.counts.front() > 1 ? std::sqrt(variances_of(state).front())
                                                  : std::numeric_limits<double>::infinity();
  return paths.tracer.status();
}

}  // namespace scenefile
