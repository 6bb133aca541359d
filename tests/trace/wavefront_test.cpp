// Rays traced in wavefronts give exactly the same results as single rays, in every instruction set
// of the machine.

#include "scenefile/trace/wavefront.h"

#include "scenefile/trace/adaptive_sampler.h"
#include "scenefile/trace/pixel_sampler.h"
#include "trace/build_scene.h"
#include "trace/single_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>

namespace scenefile {
namespace {

using trace_test::SceneBuilder;

struct Random {
  std::mt19937 engine;
  float in(float low, float high) {
    return low + (high - low) * float(engine() % 100001) / 100000.0f;
  }
  glm::vec3 vector(float low, float high) {
    const float x = in(low, high);
    const float y = in(low, high);
    return {x, y, in(low, high)};
  }
};

RenderMaterial some_material(Random& random, const std::vector<std::uint32_t>& textures) {
  RenderMaterial m;
  m.ambient = random.vector(0, 0.2f);
  m.diffuse = random.vector(0, 1);
  m.specular = random.in(0, 1) < 0.3f ? glm::vec3(0) : random.vector(0, 1);
  m.shininess = random.in(0, 1) < 0.3f ? random.in(0.1f, 30) : std::floor(random.in(0, 40));
  m.reflective = random.in(0, 1) < 0.5f ? glm::vec3(0) : random.vector(0, 0.9f);
  m.transparent = random.in(0, 1) < 0.5f ? glm::vec3(0) : random.vector(0, 0.9f);
  m.ior = random.in(0.6f, 2);
  if (random.in(0, 1) < 0.5f) {
    m.texture = {textures[random.engine() % textures.size()], random.in(0.5f, 3), 2};
    m.blend = random.in(0, 1);
  }
  return m;
}

void add_lights(SceneBuilder& b, Random& random) {
  b.light(LightType::directional, glm::normalize(glm::vec3(-1, -2, -0.5f)), {0.4f, 0.3f, 0.2f});
  b.light(LightType::point, {3, 4, 2}, {0.7f, 0.6f, 0.9f}).attenuation = {0.2f, 0.1f, 0.05f};
  RenderLight& spot = b.light(LightType::spot, {-2, 5, 3}, {0.8f, 0.9f, 0.5f});
  spot.direction = glm::normalize(glm::vec3(0.4f, -1, -0.6f));
  spot.inner_angle = 0.2f;
  spot.outer_angle = random.in(0.25f, 0.8f);
  RenderLight& area = b.light(LightType::area, {0, 4, 0}, {0.3f, 0.3f, 0.3f});
  area.direction = {0, -1, 0};
  area.half_u = {0.5f, 0, 0};
  area.half_v = {0, 0, 0.5f};
}

/// `count` shapes around the origin; some much larger or smaller than others, some along the axes,
/// some at the same place.
SceneBuilder some_scene(unsigned seed, int count) {
  Random random{std::mt19937(seed)};
  SceneBuilder b;
  const std::vector<std::uint32_t> textures = {b.texture(2, 3, {0, 255, 40, 200, 90, 130}),
                                               b.texture(1, 1, {77})};
  const float spread = 0.8f * std::cbrt(float(count));
  Affine place;
  for (int i = 0; i < count; ++i) {
    const auto shape = static_cast<Shape>(random.engine() % 4);
    if (i % 5 != 4) {
      place = trace_test::translate(random.vector(-spread, spread)) *
              trace_test::rotate(i % 3 == 0 ? 0 : random.in(0, 360), {1, 1, 0.5f}) *
              trace_test::scale(i == 1 ? glm::vec3(30, 0.01f, 30) : random.vector(0.2f, 2));
    }
    b.add(shape, place, b.material(some_material(random, textures)));
  }
  add_lights(b, random);
  const float angle = random.in(0, 6.28f);
  b.look({2.5f * spread * std::sin(angle), random.in(-1, 3), 2.5f * spread * std::cos(angle)},
         {0, 0, 0});
  return b;
}

/// Samples for each pixel of the picture, with everything that the fine profile varies.
std::vector<CameraSample> samples_of(const Tracer& tracer, const CameraRays& camera) {
  const bool fine = !tracer.course();
  const AdaptiveSampler sampler(tracer, camera);
  std::vector<CameraSample> samples;
  for (int y = 0; y < tracer.options.height; ++y) {
    for (int x = 0; x < tracer.options.width; ++x) {
      samples.push_back(fine ? sampler.sample(x, y, 0)
                             : CameraSample{{x + 0.5, y + 0.5}, {}, {}, {}});
    }
  }
  return samples;
}

/// The picture traced ray by ray.
std::vector<SampleResult> alone(const Tracer& tracer, ScalarCounts& counts) {
  const CameraRays camera = tracer.camera();
  std::vector<SampleResult> results;
  for (const CameraSample& sample : samples_of(tracer, camera)) {
    const std::uint64_t penumbras = counts.penumbras;
    const Color color = trace_sample(tracer, camera, sample, counts);
    results.push_back({color, counts.penumbras != penumbras});
  }
  return results;
}

/// The same traced in wavefronts.
std::vector<SampleResult> together(const Tracer& tracer, const WavefrontKernel* kernel,
                                   RayCounts& counts) {
  const CameraRays camera = tracer.camera();
  WavefrontScene scene(tracer, camera);
  scene.kernel = kernel;
  const WavefrontPointer memory = make_wavefront();
  const std::vector<CameraSample> samples = samples_of(tracer, camera);
  std::vector<SampleResult> results(samples.size());
  for (std::size_t i = 0; i < samples.size(); i += wavefront_samples) {
    const auto count =
        static_cast<int>(std::min<std::size_t>(wavefront_samples, samples.size() - i));
    trace_wavefront(scene, &samples[i], count, *memory, &results[i], counts);
  }
  return results;
}

RenderOptions small(Profile profile) {
  RenderOptions options = default_options(profile);
  options.width = 41;
  options.height = 31;
  return options;
}

std::vector<const WavefrontKernel*> all_kernels() {
  std::vector<const WavefrontKernel*> kernels = wavefront_kernels();
  kernels.push_back(&one_lane_kernel());
  return kernels;
}

void expect_equal(const SceneBuilder& b, const RenderOptions& options) {
  SCOPED_TRACE(options.profile == Profile::fine ? "fine" : "course");
  const Tracer tracer(b.scene, b.assets, options);
  ASSERT_EQ(tracer.status(), RenderStatus::complete);
  ScalarCounts expected_counts;
  const std::vector<SampleResult> expected = alone(tracer, expected_counts);
  for (const WavefrontKernel* kernel : all_kernels()) {
    RayCounts counts;
    const std::vector<SampleResult> results = together(tracer, kernel, counts);
    std::size_t different = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const bool penumbra = tracer.course() || results[i].penumbra == expected[i].penumbra;
      different += results[i].color == expected[i].color && penumbra ? 0 : 1;
    }
    EXPECT_EQ(different, 0u) << kernel->name << ": of " << results.size();
    EXPECT_EQ(counts.primary, expected_counts.primary) << kernel->name;
    EXPECT_EQ(counts.shadow, expected_counts.shadow) << kernel->name;
    EXPECT_EQ(counts.secondary, expected_counts.secondary) << kernel->name;
  }
}

constexpr Profile profiles[] = {Profile::course, Profile::fine};

void expect_equal(const SceneBuilder& b) {
  for (const Profile profile : profiles) {
    expect_equal(b, small(profile));
  }
}

class Wavefront : public testing::TestWithParam<int> {};

TEST_P(Wavefront, AgreesWithSingleRays) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    expect_equal(some_scene(seed, GetParam()));
  }
}

INSTANTIATE_TEST_SUITE_P(Objects, Wavefront, testing::Values(1, 3, 12, 40, 300, 3000));

TEST(WavefrontOptions, FeaturesMayBeOff) {
  const SceneBuilder b = some_scene(7, 12);
  for (const Profile profile : profiles) {
    for (bool Features::*feature : {&Features::shadows, &Features::reflect, &Features::refract,
                                    &Features::texture, &Features::texture_filter}) {
      RenderOptions options = small(profile);
      options.features.*feature = false;
      expect_equal(b, options);
    }
    RenderOptions options = small(profile);
    options.mode = Mode::intersect;
    expect_equal(b, options);
  }
}

TEST(WavefrontOptions, MoreRaysThanFit) {
  SceneBuilder b = some_scene(3, 12);
  for (RenderMaterial& m : b.scene.materials) {
    m.reflective = m.transparent = glm::vec3(0.8f);
  }
  b.scene.global.transparent = 1.0f;
  for (const Profile profile : profiles) {
    RenderOptions options = small(profile);
    options.max_depth = 8;
    expect_equal(b, options);
  }
  // The maximum for a sample.
  for (RenderMaterial& m : b.scene.materials) {
    m.reflective = m.transparent = glm::vec3(1);
  }
  b.scene.global.specular = 1;
  RenderOptions options = small(Profile::fine);
  options.width = options.height = 9;
  options.max_depth = 64;
  expect_equal(b, options);
}

TEST(WavefrontOptions, FresnelsEquations) {
  SceneBuilder b = some_scene(4, 30);
  b.scene.global.transparent = 0.9f;
  for (const bool reflect : {true, false}) {
    RenderOptions options = small(Profile::fine);
    options.fresnel = true;
    options.features.reflect = reflect;
    expect_equal(b, options);
    options.features.refract = false;
    expect_equal(b, options);
  }
}

TEST(WavefrontOptions, Normals) {
  const SceneBuilder b = some_scene(6, 30);
  for (const Profile profile : profiles) {
    RenderOptions options = small(profile);
    options.mode = Mode::normals;
    expect_equal(b, options);
  }
}

void expect_same_surface(const AovSample& a, const AovSample& b) {
  EXPECT_EQ(a.camera.point, b.camera.point);
  EXPECT_EQ(a.camera.lens, b.camera.lens);
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.hit, b.hit);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.uv, b.uv);
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.albedo, b.albedo);
  EXPECT_EQ(a.lit, b.lit);
  EXPECT_EQ(a.diffused, b.diffused);
  EXPECT_EQ(a.unshadowed, b.unshadowed);
  EXPECT_EQ(a.bounces, b.bounces);
  EXPECT_EQ(a.rays, b.rays);
}

/// The surface at the center of a pixel is what a single ray finds there.
void expect_center(const Tracer& tracer, const CameraRays& camera, const SampledPixel& pixel) {
  const AovHit& center = pixel.surfaces.center;
  const Ray ray = camera.ray(glm::dvec2(pixel.at) + 0.5, {0, 0});
  Hit hit;
  ASSERT_EQ(tracer.accelerator.closest(ray, 0, std::numeric_limits<double>::infinity(), hit),
            center.hit);
  if (center.hit) {
    const SurfacePoint point =
        surface_point(tracer.scene, tracer.assets, ray, hit, !tracer.course());
    EXPECT_EQ(center.position, point.position);
    EXPECT_EQ(center.uv, point.object.uv);
    EXPECT_EQ(center.source, hit.source);
  }
}

/// Pixels traced in wavefronts, and sample by sample.
template <typename Draw>
void expect_same_pixels(const SceneBuilder& b, const RenderOptions& options, const Draw& draw) {
  const Tracer tracer(b.scene, b.assets, options);
  const CameraRays camera = tracer.camera();
  const WavefrontScene scene(tracer, camera);
  WavefrontPool pool;
  const AovRequest request{true, {2, 0}, true};
  std::vector<glm::ivec2> places;
  for (int i = 0; i < 300; ++i) {
    places.emplace_back(i % options.width, i / options.width);
  }
  RayCounts counts;
  ScalarCounts expected_counts;
  PixelSampler sampler(scene, pool, request, counts);
  SingleSampler single(tracer, camera, request, expected_counts);
  const std::vector<SampledPixel> pixels = draw(sampler, tracer, camera, places);
  const std::vector<SampledPixel> expected = draw(single, tracer, camera, places);
  ASSERT_EQ(pixels.size(), expected.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_EQ(pixels[i].at, expected[i].at);
    EXPECT_EQ(pixels[i].color, expected[i].color);
    EXPECT_EQ(pixels[i].samples.sum, expected[i].samples.sum);
    ASSERT_EQ(pixels[i].surfaces.samples.size(), expected[i].surfaces.samples.size());
    for (std::size_t k = 0; k < pixels[i].surfaces.samples.size(); ++k) {
      expect_same_surface(pixels[i].surfaces.samples[k], expected[i].surfaces.samples[k]);
    }
    EXPECT_EQ(pixels[i].surfaces.light_colors, expected[i].surfaces.light_colors);
    expect_center(tracer, camera, pixels[i]);
  }
  EXPECT_EQ(counts.primary, expected_counts.primary);
}

TEST(PixelSampler, TheCoursesPatternsAndTheirHits) {
  SceneBuilder b = some_scene(8, 40);
  const auto draw = [](auto& sampler, const Tracer&, const CameraRays&, const auto& places) {
    return sampler.course(places);
  };
  RenderOptions options = small(Profile::course);
  expect_same_pixels(b, options, draw);
  options.features.super_sample = true;
  expect_same_pixels(b, options, draw);
  b.scene.camera.aperture = 0.2f;
  b.scene.camera.focal_length = 5;
  expect_same_pixels(b, options, draw);
}

TEST(PixelSampler, FineSamplesAndTheirHits) {
  const SceneBuilder b = some_scene(8, 40);
  for (const bool fresnel : {false, true}) {
    RenderOptions options = small(Profile::fine);
    options.fresnel = fresnel;
    options.samples = 8;
    expect_same_pixels(
        b, options,
        [](auto& sampler, const Tracer& tracer, const CameraRays& camera, const auto& places) {
          std::vector<std::uint16_t> refinements;
          for (std::size_t i = 0; i < places.size(); ++i) {
            refinements.push_back(static_cast<std::uint16_t>(1 + i % 255));
          }
          return sampler.take(AdaptiveSampler(tracer, camera), places, refinements);
        });
    expect_same_pixels(
        b, options,
        [](auto& sampler, const Tracer& tracer, const CameraRays& camera, const auto& places) {
          return sampler.take_center_samples(AdaptiveSampler(tracer, camera), places);
        });
  }
}

TEST(WavefrontOptions, BumpMapsAndLenses) {
  SceneBuilder b = some_scene(11, 40);
  for (std::size_t i = 0; i < b.scene.materials.size(); i += 3) {
    b.scene.materials[i].bump_map = {0, 2, 1.5f};
  }
  b.scene.camera.aperture = 0.3;
  b.scene.camera.focal_length = 6;
  expect_equal(b, small(Profile::fine));
}

Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0.5f}, {0, 0, -1}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  return mesh;
}

// The front of a cube, which it covers exactly.
Mesh front() {
  Mesh mesh;
  mesh.positions = {{-0.5f, -0.5f, 0.5f}, {0.5f, -0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

// Each mesh twice, the second time scaled, in front of and behind the shape at the same place.
TEST(WavefrontOptions, MeshesAmongShapes) {
  for (const int shapes : {1, 4, 40, 300}) {
    SCOPED_TRACE(shapes);
    SceneBuilder b = some_scene(static_cast<unsigned>(shapes), shapes);
    const std::uint32_t meshes[] = {b.mesh(tetrahedron()), b.mesh(front())};
    std::vector<RenderPrimitive>& all = b.scene.groups.front().primitives;
    for (int i = 0; i < std::min(shapes, 12); ++i) {
      for (const float size : {1.0f, 0.6f + 0.1f * float(i)}) {
        RenderPrimitive primitive =
            b.primitive(Shape::mesh, all[i].group_from_object * trace_test::scale(glm::vec3(size)),
                        all[i].material);
        primitive.mesh = meshes[i % 2];
        all.insert(all.begin() + (i % 3 == 0 ? 0 : i), primitive);
      }
    }
    expect_equal(b);
  }
}

// Normals and (u, v), which one of the triangles lacks.
Mesh textured_tetrahedron() {
  Mesh mesh = tetrahedron();
  mesh.normals = {{-1, -1, 1}, {2, -1, 1}, {0, 1, 1}, {0, 0.2f, -1}};
  mesh.uvs = {{0, 0}, {1.5f, 0}, {0.5f, 2}, {0.3f, 0.4f}};
  mesh.triangle_normals = mesh.triangle_uvs = mesh.triangles;
  mesh.triangle_normals[1].fill(mesh_no_index);
  mesh.triangle_uvs[2].fill(mesh_no_index);
  return mesh;
}

TEST(WavefrontOptions, TexturesAndBumpMapsOfMeshes) {
  SceneBuilder b = some_scene(21, 12);
  const std::uint32_t texture = b.texture(4, 3, {0, 255, 40, 200, 90, 130, 10, 60, 5, 70, 8, 99});
  for (RenderMaterial& m : b.scene.materials) {
    m.texture = {texture, 2, 1.5f};
    m.blend = 0.7f;
    m.bump_map = {texture, 1, 3};
  }
  const std::uint32_t meshes[] = {b.mesh(textured_tetrahedron()), b.mesh(tetrahedron())};
  for (std::size_t i = 0; i < b.scene.groups.front().primitives.size(); i += 2) {
    RenderPrimitive& primitive = b.scene.groups.front().primitives[i];
    primitive.shape = Shape::mesh;
    primitive.mesh = meshes[i / 2 % 2];
  }
  expect_equal(b);
  for (bool Features::*feature : {&Features::texture, &Features::texture_filter}) {
    RenderOptions options = small(Profile::fine);
    options.features.*feature = false;
    expect_equal(b, options);
  }
}

TEST(WavefrontOptions, InstancesAndMeshes) {
  SceneBuilder b = some_scene(5, 20);
  RenderPrimitive primitive = b.primitive(Shape::mesh, trace_test::translate({0, 1, 0}), 2);
  primitive.mesh = b.mesh(tetrahedron());
  const RenderGroup inner = b.scene.groups.front();
  b.scene.groups.emplace_back();
  b.scene.groups.back().primitives.push_back(primitive);
  for (const float x : {-3.0f, 0.0f, 3.0f}) {
    b.scene.groups.back().instances.push_back(b.instance(0, trace_test::translate({x, 0, x})));
  }
  b.scene.root = 1;
  expect_equal(b);
}

TEST(WavefrontOptions, EnormousAndTinyScenes) {
  for (const float size : {1e-9f, 1e-4f, 1e5f, 1e12f}) {
    SceneBuilder b = some_scene(9, 30);
    for (RenderPrimitive& p : b.scene.groups.front().primitives) {
      p.group_from_object = trace_test::scale(glm::vec3(size)) * p.group_from_object;
    }
    b.scene.camera.position *= double(size);
    SCOPED_TRACE(size);
    expect_equal(b);
  }
}

TEST(WavefrontOptions, NothingToSee) {
  SceneBuilder b;
  b.light(LightType::point, {0, 3, 0}, {1, 1, 1});
  b.add(Shape::sphere, trace_test::translate({0, 0, 5}), b.glowing({1, 1, 1}));
  expect_equal(b);
}

TEST(WavefrontKernels, AreThoseThatRunHere) {
  const std::vector<const WavefrontKernel*> kernels = wavefront_kernels();
  ASSERT_FALSE(kernels.empty()) << "the tests above compare nothing";
  std::set<std::string_view> names;
  for (const WavefrontKernel* const kernel : kernels) {
    EXPECT_TRUE(kernel->runs_here()) << kernel->name;
    EXPECT_TRUE(names.insert(kernel->name).second) << kernel->name;
  }
#ifdef __x86_64__
  EXPECT_GT(kernels.size(), 1u) << "SSE4 and AVX2 are on every machine that runs tests";
#endif
}

}  // namespace
}  // namespace scenefile
