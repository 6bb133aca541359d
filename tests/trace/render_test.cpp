// Whole pictures: determinism, cancellation, ray counts.

#include "scenefile/trace/trace_scene.h"
#include "trace/build_scene.h"

#include <gtest/gtest.h>

#include <thread>

namespace scenefile::trace_test {
namespace {

// A scene with many features.
SceneBuilder busy_scene() {
  SceneBuilder b;
  RenderMaterial floor;
  floor.reflective = glm::vec3(0.25);
  floor.blend = 0.5;
  floor.texture = {0, 8, 8};
  b.texture(2, 2, {0, 255, 255, 0});
  RenderMaterial glass;
  glass.transparent = {0.9f, 0.5f, 0.5f};
  glass.specular = glm::vec3(1);
  glass.shininess = 20;
  glass.ior = 1.4f;
  b.add(Shape::cube, Affine{glm::mat3(10), glm::vec3(0, -5.5, -4)}, b.material(floor));
  const std::uint32_t g = b.material(glass);
  for (int i = 0; i < 12; ++i) {
    const auto shape = i % 4 == 0 ? Shape::cone : i % 4 == 1 ? Shape::cylinder : Shape::sphere;
    b.add(shape, translate({float(i % 4) - 1.5f, 0, -3 - float(i / 4)}), g);
  }
  RenderLight& light = b.light(LightType::area, {1, 4, -2}, glm::vec3(0.75));
  light.half_u = {0.5, 0, 0};
  light.half_v = {0, 0, 0.5};
  b.light(LightType::point, {-3, 5, 2}, glm::vec3(0.5));
  b.scene.camera.aperture = 0.02;
  b.scene.camera.focal_length = 4;
  b.look({0, 1, 1}, {0, 0, -4});
  return b;
}

TEST(Render, ThreadsDoNotChangeABit) {
  const SceneBuilder b = busy_scene();
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = default_options(profile);
    options.features.super_sample = true;
    options.threads = 1;
    const Image one = b.picture(93, 71, options);
    for (const int threads : {2, 7}) {
      options.threads = threads;
      EXPECT_EQ(one.rgb, b.picture(93, 71, options).rgb) << threads;
    }
  }
}

TEST(Render, GroupsAreNotNeededOnceTheStructureIsBuilt) {
  const SceneBuilder b = busy_scene();
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = default_options(profile);
    options.width = 93;
    options.height = 71;
    RenderScene scene = b.scene;
    const TraceScene traced(scene, b.assets);
    std::vector<RenderGroup>().swap(scene.groups);
    const RenderResult used_up = render(scene, b.assets, options, {.traced = &traced});
    EXPECT_EQ(used_up.image.rgb, b.picture(93, 71, options).rgb);
  }
}

TEST(Render, ACanvasOfAnySizeChangesNoPixel) {
  const SceneBuilder b = busy_scene();
  RenderOptions options = default_options(Profile::course);
  options.width = 93;
  options.height = 71;
  for (const auto& [width, height] : {std::pair(93, 71), std::pair(71, 93), std::pair(1, 1)}) {
    Image canvas(width, height);
    const float* const memory = canvas.rgb.data();
    const Image drawn = render(b.scene, b.assets, options, {.canvas = std::move(canvas)}).image;
    EXPECT_EQ(drawn.rgb, b.picture(93, 71, options).rgb);
    EXPECT_EQ(drawn.rgb.data() == memory, width == 93);
  }
}

// Progress and previews are read while other threads write; intended for ThreadSanitizer.
TEST(Render, ProgressWorksWithAnyNumberOfThreads) {
  const SceneBuilder b = busy_scene();
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = default_options(profile);
    options.width = 64;
    options.height = 48;
    options.threads = 1;
    const Image one = render(b.scene, b.assets, options).image;
    Preview preview;
    preview.interval_seconds = 0;
    preview.show = [](const Image& image) { EXPECT_EQ(image.width, 64); };
    for (options.threads = 1; options.threads <= 16; ++options.threads) {
      const RenderResult result =
          render(b.scene, b.assets, options,
                 {.progress = [](double) { return true; }, .preview = preview});
      EXPECT_TRUE(one.rgb == result.image.rgb) << options.threads;
    }
  }
}

TEST(Render, LayersAndNoiseAreTheSameForAnyNumberOfThreads) {
  const SceneBuilder b = busy_scene();
  RenderOptions options = default_options(Profile::fine);
  options.width = 64;
  options.height = 48;
  options.samples = 4;
  options.denoise = true;
  options.layers = {{LayerKind::normal}, {LayerKind::light, 1}, {LayerKind::shadow}};
  options.threads = 1;
  const RenderResult one = render(b.scene, b.assets, options);
  for (const int threads : {2, 5, 16}) {
    options.threads = threads;
    const RenderResult result = render(b.scene, b.assets, options);
    EXPECT_TRUE(one.image.rgb == result.image.rgb) << threads;
    for (std::size_t i = 0; i < one.layers.size(); ++i) {
      EXPECT_TRUE(one.layers[i].values == result.layers[i].values) << threads;
    }
  }
}

// Camera rays of a picture of 40 x 30 pixels that shows a disk on black.
std::uint64_t camera_rays(int samples, int min_samples, const RenderOptions& others = {}) {
  SceneBuilder b;
  RenderMaterial plain;
  plain.ambient = glm::vec3(1);
  b.add(Shape::sphere, translate({0, 0, -3}), b.material(plain));
  b.look({0, 0, 0}, {0, 0, -1});
  RenderOptions options = others;
  options.width = 40;
  options.height = 30;
  options.samples = samples;
  options.min_samples = min_samples;
  return render(b.scene, b.assets, options).stats.primary_rays;
}

TEST(Render, SamplesMayBeForced) {
  constexpr std::uint64_t pixels = 40 * 30;
  EXPECT_EQ(camera_rays(16, 16), 16 * pixels);
  EXPECT_EQ(camera_rays(5, 5), 5 * pixels);
  EXPECT_GT(camera_rays(16, 1), camera_rays(1, 1)) << "an edge takes more";
  EXPECT_LT(camera_rays(16, 1), 8 * pixels);
  EXPECT_GT(camera_rays(16, 6), 6 * pixels);
  EXPECT_LT(camera_rays(16, 6), 9 * pixels);
  RenderOptions crop;
  crop.crop = {10, 10, 20, 15};
  EXPECT_EQ(camera_rays(16, 16, crop), 16u * 10 * 5) << "nobody asks the neighbors";
  EXPECT_EQ(camera_rays(4, 9), camera_rays(4, 4)) << "no more than the most";
}

TEST(Render, SeedChangesTheNoiseAndNothingElse) {
  const SceneBuilder b = busy_scene();
  RenderOptions options = default_options(Profile::fine);
  const Image a = b.picture(40, 30, options);
  EXPECT_EQ(a.rgb, b.picture(40, 30, options).rgb);
  options.seed = 1;
  const Image c = b.picture(40, 30, options);
  EXPECT_NE(a.rgb, c.rgb);
  double difference = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    difference += a.rgb[i] - c.rgb[i];
  }
  EXPECT_NEAR(difference / double(a.rgb.size()), 0, 2e-3);
}

TEST(Render, ProgressRisesToTheEnd) {
  const SceneBuilder b = busy_scene();
  RenderOptions options = default_options(Profile::fine);
  options.width = 64;
  options.height = 48;
  double last = 0;
  const RenderResult result = render(b.scene, b.assets, options, {.progress = [&](double done) {
                                       EXPECT_GE(done, last);
                                       EXPECT_LE(done, 1);
                                       last = done;
                                       return true;
                                     }});
  EXPECT_EQ(result.status, RenderStatus::complete);
}

TEST(Render, ProgressIsCalledByOneThreadAtATime) {
  const SceneBuilder b = busy_scene();
  RenderOptions options = default_options(Profile::course);
  options.width = options.height = 100;
  options.threads = 4;
  std::atomic<int> inside{0};
  render(b.scene, b.assets, options, {.progress = [&](double) {
           EXPECT_EQ(++inside, 1);
           std::this_thread::sleep_for(std::chrono::milliseconds(1));
           --inside;
           return true;
         }});
}

TEST(Render, StopsOnRequest) {
  const SceneBuilder b = busy_scene();
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = default_options(profile);
    options.width = 4000;
    options.height = 3000;
    const RenderResult result =
        render(b.scene, b.assets, options, {.progress = [](double) { return false; }});
    EXPECT_EQ(result.status, RenderStatus::cancelled);
    EXPECT_EQ(result.image.width, 4000);
    EXPECT_LT(result.stats.primary_rays, 4000u * 3000u / 4);
  }
}

TEST(Render, CountsItsRays) {
  SceneBuilder b;
  RenderMaterial m;
  m.reflective = glm::vec3(1);
  b.add(Shape::cube, Affine{glm::mat3(100), glm::vec3(0, 0, -60)}, b.material(m));
  b.light(LightType::point, {0, 0, 5}, glm::vec3(1));
  RenderOptions options = default_options(Profile::course);
  options.width = 20;
  options.height = 10;
  const RenderResult result = render(b.scene, b.assets, options);
  EXPECT_EQ(result.stats.primary_rays, 200u);
  EXPECT_EQ(result.stats.shadow_rays, 200u);
  EXPECT_EQ(result.stats.secondary_rays, 200u);
}

TEST(Render, EmptyScenesAreBlack) {
  const RenderScene nothing;
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = default_options(profile);
    options.width = options.height = 3;
    const RenderResult result = render(nothing, {}, options);
    EXPECT_EQ(result.status, RenderStatus::complete);
    EXPECT_EQ(result.image.rgb, std::vector<float>(27, 0.0f));
  }
}

TEST(Render, ImageCoordinatesRunRightAndDown) {
  SceneBuilder b;
  b.add(Shape::sphere, translate({1, 1, -3}), b.glowing({1, 0, 0}));
  b.add(Shape::sphere, translate({-1, -1, -3}), b.glowing({0, 1, 0}));
  const Image image = b.picture(60, 60, default_options(Profile::course));
  EXPECT_EQ(image.pixel(47, 12)[0], 1);
  EXPECT_EQ(image.pixel(12, 47)[1], 1);
}

TEST(Render, FieldOfViewIsTheFullVerticalAngle) {
  // A wall at distance 2 whose top edge is at 45 degrees: exactly the upper edge of the picture.
  SceneBuilder b;
  b.add(Shape::cube, Affine{glm::mat3(4), glm::vec3(0, 0, -4)}, b.glowing(glm::vec3(1)));
  b.look({0, 0, 0}, {0, 0, -1}, 89.9);
  const RenderOptions options = default_options(Profile::course);
  const Image fits = b.picture(11, 11, options);
  EXPECT_EQ(fits.pixel(5, 0)[0], 1);
  b.look({0, 0, 0}, {0, 0, -1}, 95 * 1.1);
  const Image wider = b.picture(11, 11, options);
  EXPECT_EQ(wider.pixel(5, 0)[0], 0);
  EXPECT_EQ(wider.pixel(5, 1)[0], 1);
}

TEST(Render, FineProfileSmoothsEdges) {
  SceneBuilder b;
  b.add(Shape::cube, Affine{glm::mat3(2), glm::vec3(1.003, 0, -4)}, b.glowing(glm::vec3(1)));
  const Image image = b.picture(41, 41, default_options(Profile::fine));
  int between = 0;
  for (int x = 0; x < 41; ++x) {
    const float v = image.pixel(x, 20)[0];
    between += v > 0.1f && v < 0.9f ? 1 : 0;
  }
  EXPECT_EQ(between, 1);
}

TEST(Render, DefaultsOfTheProfiles) {
  EXPECT_FALSE(default_options(Profile::course).features.super_sample);
  EXPECT_EQ(default_options(Profile::course).max_depth, 4);
  EXPECT_TRUE(default_options(Profile::fine).features.super_sample);
  EXPECT_EQ(default_options(Profile::fine).max_depth, 16);
  EXPECT_EQ(rounding_of(Profile::course), Rounding::truncate);
  EXPECT_EQ(rounding_of(Profile::fine), Rounding::nearest);
}

}  // namespace
}  // namespace scenefile::trace_test
