// scenefile_bench_kernels: measures the parts of a render separately, with Google Benchmark.
// --benchmark_filter=REGEX selects, --benchmark_format=json prints JSON.

#include "generated_scene.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/render.h"
#include "scenefile/trace/texture_lookup.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace scenefile;
using namespace scenefile::bench;

constexpr std::size_t objects = 100'000;

double draw(std::mt19937& random) {
  return std::uniform_real_distribution<double>(-1, 1)(random);
}
glm::dvec3 draw_point(std::mt19937& random) {
  return {draw(random), draw(random), draw(random)};
}

// Rays from around the shape through its bounding box; about half of them hit.
std::vector<Ray> rays_at_shape() {
  std::mt19937 random(1);
  std::vector<Ray> rays(4096);
  for (Ray& ray : rays) {
    ray.origin = 3.0 * glm::normalize(draw_point(random));
    ray.direction = glm::normalize(0.6 * draw_point(random) - ray.origin);
  }
  return rays;
}

void intersect_shape(benchmark::State& state, Shape shape) {
  const std::vector<Ray> rays = rays_at_shape();
  for (auto _ : state) {
    for (const Ray& ray : rays) {
      ShapeHit hit;
      benchmark::DoNotOptimize(intersect(shape, ray, 0, 1e9, hit));
      benchmark::DoNotOptimize(hit);
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * rays.size()));
}
BENCHMARK_CAPTURE(intersect_shape, cube, Shape::cube);
BENCHMARK_CAPTURE(intersect_shape, sphere, Shape::sphere);
BENCHMARK_CAPTURE(intersect_shape, cylinder, Shape::cylinder);
BENCHMARK_CAPTURE(intersect_shape, cone, Shape::cone);

void surface(benchmark::State& state, Shape shape) {
  std::mt19937 random(2);
  std::vector<glm::dvec3> points(4096);
  for (glm::dvec3& point : points) {
    point = 0.5 * glm::normalize(draw_point(random));
  }
  for (auto _ : state) {
    for (const glm::dvec3& point : points) {
      benchmark::DoNotOptimize(surface_at(shape, Face::side, point));
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * points.size()));
}
BENCHMARK_CAPTURE(surface, sphere, Shape::sphere);
BENCHMARK_CAPTURE(surface, cone, Shape::cone);

Texture noise(int side) {
  std::mt19937 random(3);
  Texture texture;
  texture.width = texture.height = side;
  texture.rgb.resize(std::size_t{3} * side * side);
  for (std::uint8_t& value : texture.rgb) {
    value = static_cast<std::uint8_t>(random());
  }
  return texture;
}

std::vector<glm::dvec2> uvs() {
  std::mt19937 random(4);
  std::vector<glm::dvec2> all(4096);
  for (glm::dvec2& uv : all) {
    uv = {draw(random), draw(random)};
  }
  return all;
}

template <typename Lookup>
void look_up(benchmark::State& state, Lookup lookup) {
  const Texture texture = noise(512);
  const MipMap mip_map(texture);
  const std::vector<glm::dvec2> all = uvs();
  for (auto _ : state) {
    for (const glm::dvec2& uv : all) {
      benchmark::DoNotOptimize(lookup(texture, mip_map, uv));
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * all.size()));
}
void texture_nearest(benchmark::State& state) {
  look_up(state, [](const Texture& texture, const MipMap&, const glm::dvec2& uv) {
    return lookup_nearest(texture, {0, 2, 2}, uv);
  });
}
void texture_course_filter(benchmark::State& state) {
  look_up(state, [](const Texture& texture, const MipMap&, const glm::dvec2& uv) {
    return lookup_course_filter(texture, {0, 2, 2}, uv);
  });
}
void texture_footprint(benchmark::State& state) {
  look_up(state, [](const Texture&, const MipMap& mip_map, const glm::dvec2& uv) {
    return lookup_filtered(mip_map, {0, 2, 2}, uv, {{0.02, 0}, {0, 0.01}});
  });
}
BENCHMARK(texture_nearest);
BENCHMARK(texture_course_filter);
BENCHMARK(texture_footprint);

Scene read(std::string_view text) {
  Diagnostics diagnostics;
  return read_scene(text, {}, diagnostics);
}

void read_text(benchmark::State& state, std::string (*make)(std::size_t)) {
  const std::string text = make(objects);
  for (auto _ : state) {
    benchmark::DoNotOptimize(read(text));
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}
BENCHMARK_CAPTURE(read_text, xml, xml_scene)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_text, json, json_scene)->Unit(benchmark::kMillisecond);

void count_objects(benchmark::State& state) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * objects));
}

void check_scene(benchmark::State& state) {
  const Scene scene = read(xml_scene(objects));
  for (auto _ : state) {
    Diagnostics diagnostics;
    check(scene, {}, diagnostics);
    benchmark::DoNotOptimize(diagnostics);
  }
  count_objects(state);
}
void prepare_scene(benchmark::State& state) {
  const Scene scene = read(xml_scene(objects));
  for (auto _ : state) {
    benchmark::DoNotOptimize(prepare(scene, {}));
  }
  count_objects(state);
}
void build_structure(benchmark::State& state) {
  const RenderScene scene = prepare(read(xml_scene(objects)), {}).scene;
  for (auto _ : state) {
    const Accelerator accelerator(scene, {});
    benchmark::DoNotOptimize(accelerator.status());
  }
  count_objects(state);
}
BENCHMARK(check_scene)->Unit(benchmark::kMillisecond);
BENCHMARK(prepare_scene)->Unit(benchmark::kMillisecond);
BENCHMARK(build_structure)->Unit(benchmark::kMillisecond);

// Camera rays of the scene, one at a time.
template <typename Ask>
void ask_rays(benchmark::State& state, Ask ask) {
  const RenderScene scene = prepare(read(xml_scene(objects)), {}).scene;
  const Accelerator accelerator(scene, {});
  std::mt19937 random(5);
  std::vector<Ray> rays(4096);
  for (Ray& ray : rays) {
    ray.origin = {0, 0, 200};
    ray.direction = glm::normalize(glm::dvec3(0.5 * draw(random), 0.5 * draw(random), -1));
  }
  for (auto _ : state) {
    for (const Ray& ray : rays) {
      benchmark::DoNotOptimize(ask(accelerator, ray));
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * rays.size()));
}
void closest_of_100000(benchmark::State& state) {
  ask_rays(state, [](const Accelerator& accelerator, const Ray& ray) {
    Hit hit;
    return accelerator.closest(ray, 0, 1e9, hit);
  });
}
void occluded_by_100000(benchmark::State& state) {
  const Transmission opaque({});
  ask_rays(state, [&](const Accelerator& accelerator, const Ray& ray) {
    return accelerator.transmittance(ray, 0, 1e9, opaque) == glm::dvec3(0);
  });
}
BENCHMARK(closest_of_100000);
BENCHMARK(occluded_by_100000);

// A sphere that fills the picture: camera rays, hits, and lighting with a varying number of lights.
void shade_sphere(benchmark::State& state) {
  Scene scene;
  Node& root = scene.nodes[scene.root];
  root.primitives.emplace_back().shape = Shape::sphere;
  root.primitives.back().material.specular = glm::vec3(0.5f);
  root.primitives.back().material.shininess = 20;
  for (int i = 0; i < state.range(0); ++i) {
    Light& light = root.lights.emplace_back();
    light.position = {3, 0.1f * static_cast<float>(i), 3};
  }
  scene.camera.emplace();
  scene.camera->position = {0, 0, 0.9f};
  scene.camera->look = {0, 0, -1};
  scene.camera->height_angle_deg = 20;
  const RenderScene ready = prepare(scene, {}).scene;
  RenderOptions options = default_options(Profile::course);
  options.width = options.height = 256;
  options.threads = 1;
  options.features.shadows = false;
  for (auto _ : state) {
    benchmark::DoNotOptimize(render(ready, {}, options));
  }
  state.SetItemsProcessed(state.iterations() * options.width * options.height);
}
BENCHMARK(shade_sphere)->Arg(1)->Arg(8)->Unit(benchmark::kMillisecond);

Image gradient() {
  Image image(1024, 768);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      float* const pixel = image.pixel(x, y);
      pixel[0] = static_cast<float>(x) / 1024;
      pixel[1] = static_cast<float>(y) / 768;
      pixel[2] = static_cast<float>((x * y) % 97) / 97;
    }
  }
  return image;
}

void encode(benchmark::State& state, ImageFormat format) {
  const Image image = gradient();
  for (auto _ : state) {
    benchmark::DoNotOptimize(encode_image(image, format, Rounding::nearest));
  }
}
BENCHMARK_CAPTURE(encode, png, ImageFormat::png8)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(encode, exr, ImageFormat::exr)->Unit(benchmark::kMillisecond);

void decode_png(benchmark::State& state) {
  const std::string bytes = *encode_image(gradient(), ImageFormat::png8, Rounding::nearest);
  for (auto _ : state) {
    benchmark::DoNotOptimize(decode_image(bytes));
  }
}
BENCHMARK(decode_png)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
