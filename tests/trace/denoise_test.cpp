#include "scenefile/trace/denoise.h"

#include "trace/build_scene.h"

#include <gtest/gtest.h>

namespace scenefile::trace_test {
namespace {

double psnr(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double difference =
        std::clamp(double(a.rgb[i]), 0.0, 1.0) - std::clamp(double(b.rgb[i]), 0.0, 1.0);
    sum += difference * difference;
  }
  return -10 * std::log10(sum / double(a.rgb.size()) + 1e-12);
}

// A checkered floor with a sphere and a block.
SceneBuilder table() {
  SceneBuilder b;
  RenderMaterial floor;
  floor.blend = 1;
  floor.texture = {0, 6, 6};
  b.texture(4, 4, {60, 220, 60, 220, 220, 60, 220, 60, 60, 220, 60, 220, 220, 60, 220, 60});
  b.add(Shape::cube, Affine{glm::mat3(20), glm::vec3(0, -10.5, -4)}, b.material(floor));
  RenderMaterial m;
  m.diffuse = {0.9f, 0.5f, 0.2f};
  b.add(Shape::sphere, translate({-0.6f, 0, -3.5f}), b.material(m));
  m.diffuse = {0.3f, 0.5f, 0.8f};
  b.add(Shape::cube, translate({0.6f, 0, -4}) * rotate(30, {0, 1, 0}), b.material(m));
  b.look({0, 1.2, 0.5}, {0, -0.2, -4}, 40);
  return b;
}

void add_area_light(SceneBuilder& b, float size) {
  RenderLight& light = b.light(LightType::area, {1.5f, 4, -2}, glm::vec3(0.9f));
  light.half_u = {size, 0, 0};
  light.half_v = {0, 0, size};
}

SceneBuilder soft_shadows() {
  SceneBuilder b = table();
  add_area_light(b, 2.5f);
  return b;
}

SceneBuilder out_of_focus() {
  SceneBuilder b = table();
  b.light(LightType::directional, glm::normalize(glm::vec3(-1, -2, -1)), glm::vec3(0.9f));
  b.scene.camera.aperture = 0.1;
  b.scene.camera.focal_length = 3;
  return b;
}

SceneBuilder both() {
  SceneBuilder b = table();
  add_area_light(b, 1);
  b.scene.camera.aperture = 0.05;
  b.scene.camera.focal_length = 4;
  return b;
}

RenderOptions options_of(int samples) {
  RenderOptions options = default_options(Profile::fine);
  options.samples = samples;
  options.width = 80;
  options.height = 60;
  return options;
}

struct Denoise : ::testing::TestWithParam<SceneBuilder (*)()> {};

TEST_P(Denoise, BringsFewSamplesNearerToMany) {
  const SceneBuilder b = GetParam()();
  RenderOptions options = options_of(512);
  options.seed = 7;
  const Image truth = b.picture(80, 60, options);
  for (const int samples : {4, 16}) {
    options = options_of(samples);
    const double noisy = psnr(b.picture(80, 60, options), truth);
    options.denoise = true;
    const double clean = psnr(b.picture(80, 60, options), truth);
    RecordProperty("psnr_" + std::to_string(samples), std::to_string(noisy));
    std::printf("%d samples: %.2f dB, denoised %.2f dB\n", samples, noisy, clean);
    EXPECT_GT(clean, noisy + (samples == 4 ? 1.0 : 0.5));
  }
}

TEST_P(Denoise, LeavesManySamplesAsTheyAre) {
  const SceneBuilder b = GetParam()();
  RenderOptions options = options_of(512);
  const Image image = b.picture(80, 60, options);
  options.denoise = true;
  const double same = psnr(b.picture(80, 60, options), image);
  std::printf("512 samples: %.2f dB\n", same);
  EXPECT_GT(same, 48);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Denoise, ::testing::Values(soft_shadows, out_of_focus, both));

TEST(DenoiseBounds, WithoutNoiseNothingChanges) {
  SceneBuilder b = table();
  b.light(LightType::point, {1, 4, 0}, glm::vec3(0.8f));
  RenderOptions options = options_of(4);
  const Image image = b.picture(80, 60, options);
  options.denoise = true;
  EXPECT_EQ(b.picture(80, 60, options).rgb, image.rgb);
}

TEST(DenoiseBounds, HardShadowsStaySharpNextToAreaLights) {
  SceneBuilder b = table();
  b.light(LightType::point, {1, 4, 0}, glm::vec3(0.8f));
  b.light(LightType::area, {0, -8, -4}, glm::vec3(0.8f)).direction = {0, -1, 0};
  RenderOptions options = options_of(4);
  const Image image = b.picture(80, 60, options);
  options.denoise = true;
  const Image same = b.picture(80, 60, options);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    EXPECT_NEAR(same.rgb[i], image.rgb[i], 1e-5f);
  }
}

TEST(DenoiseBounds, NoChannelMovesByMoreThanThreeStandardErrors) {
  std::vector<PixelStatistics> pixels(32 * 32);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i].signal = glm::vec3(static_cast<float>(i * 7919 % 1000) / 1000);
    pixels[i].variance = glm::vec3(i % 2 == 0 ? 1e-4f : 0);
    pixels[i].normal = {0, 1, 0};
    pixels[i].position = {float(i % 32), 0, float(i / 32)};
    pixels[i].coverage = 1;
  }
  const std::vector<glm::vec3> colors = denoised(32, 32, pixels, true);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_LE(std::abs(colors[i].x - pixels[i].signal.x), 3 * 0.01f + 1e-6f);
  }
}

TEST(DenoiseBounds, GuidesAreEdges) {
  // Equal noise on both sides of an edge in normal, albedo, position or coverage.
  for (const int guide : {0, 1, 2, 3}) {
    std::vector<PixelStatistics> pixels(32 * 16);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const bool right = i % 32 >= 16;
      const float noise = static_cast<float>(i * 7919 % 1000) / 1000 - 0.5f;
      PixelStatistics& p = pixels[i];
      p.signal = glm::vec3((right ? 0.52f : 0.48f) + 0.2f * noise);
      p.variance = glm::vec3(0.2f * 0.2f / 12);
      p.normal = guide == 0 && right ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
      p.albedo = glm::vec3(guide == 1 && right ? 0.6f : 0.5f);
      p.position = {float(i % 32), guide == 2 && right ? 10.0f : 0, float(i / 32)};
      p.coverage = guide == 3 && right ? 0.5f : 1;
    }
    const std::vector<glm::vec3> colors = denoised(32, 16, pixels, guide != 1);
    double left = 0, right = 0;
    for (std::size_t y = 0; y < 16; ++y) {
      left += colors[32 * y + 15].x / 16;
      right += colors[32 * y + 16].x / 16;
    }
    EXPECT_NEAR(left, 0.48, 0.012) << guide;
    EXPECT_NEAR(right, 0.52, 0.012) << guide;
  }
}

}  // namespace
}  // namespace scenefile::trace_test
