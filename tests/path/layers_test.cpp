// Layers and denoising of path-traced pictures.

#include "scenefile/trace/layers.h"

#include "path/full_room.h"
#include "path/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scenefile::path_test {
namespace {

std::vector<Layer> layers_named(const std::string& names) {
  std::vector<Layer> layers;
  EXPECT_EQ(parse_layers(names, layers), "");
  return layers;
}

void expect_equal(const std::vector<float>& a, const std::vector<float>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i], b[i], tolerance * (1 + std::abs(b[i]))) << i;
  }
}

TEST(PathLayers, BouncesAddUpToThePicture) {
  for (const double clamp : {0.0, 0.1}) {
    RenderOptions options = path_options(24, 18, 8);
    options.max_depth = 5;
    options.clamp = clamp;
    options.layers = layers_named("bounce-0,bounce-1,bounce-2,bounce-3,bounce-4,bounce-5,bounce-6");
    const PathResult r = draw(full_room(true, true), options);
    std::vector<float> sum(r.image.rgb.size());
    for (const ImageLayer& layer : r.layers) {
      ASSERT_EQ(layer.values.size(), sum.size());
      EXPECT_EQ(layer.channels.size(), 3u);
      std::transform(sum.begin(), sum.end(), layer.values.begin(), sum.begin(), std::plus<>());
    }
    expect_equal(sum, r.image.rgb, 1e-5);
    // One more than max_depth: light at the last surface is not looked for.
    EXPECT_EQ(*std::max_element(r.layers[6].values.begin(), r.layers[6].values.end()), 0);
    EXPECT_GT(*std::max_element(r.layers[5].values.begin(), r.layers[5].values.end()), 0);
    EXPECT_EQ(r.layers[3].name, "bounce-3");
  }
}

TEST(PathLayers, DirectIsThePictureOfDirectOnly) {
  RenderOptions options = path_options(24, 18, 8);
  options.layers = layers_named("direct");
  const Room room = full_room(false, true);
  const PathResult r = draw(room, options);
  options.direct_only = true;
  expect_equal(r.layers[0].values, draw(room, options).image.rgb, 1e-5);
}

TEST(PathLayers, SpecularIsLightOfMirrorsAndGlass) {
  RenderOptions options = path_options(12, 12, 16);
  options.layers = layers_named("specular,bounce-0");
  FaceMaterial shiny = mirror(glm::vec3(0.8f));
  shiny.emission = glm::vec3(0.2f);
  const PathResult mirrors = draw(closed_box(shiny), options);
  std::vector<float> sum = mirrors.layers[0].values;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] += mirrors.layers[1].values[i];
  }
  expect_equal(sum, mirrors.image.rgb, 1e-5);
  const PathResult rough = draw(closed_box(diffuse(glm::vec3(0.5f), glm::vec3(0.2f))), options);
  EXPECT_EQ(rough.layers[0].values, std::vector<float>(rough.image.rgb.size()));
}

TEST(PathLayers, StatisticsAndSurfaces) {
  RenderOptions options = path_options(24, 18, 6);
  options.layers = layers_named("variance,samples,normal,albedo");
  const PathResult r = draw(full_room(false, false), options);
  EXPECT_EQ(r.layers[0].values, variances_of(r.state));
  EXPECT_EQ(r.layers[1].values, std::vector<float>(24 * 18, 6));
  for (std::size_t i = 0; i < 24 * 18; ++i) {
    const float* const n = &r.layers[2].values[3 * i];
    EXPECT_LE(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1.0001f);
  }
  // The floor.
  const std::size_t floor = 3 * (17 * 24 + 12);
  EXPECT_NEAR(r.layers[2].values[floor + 1], 1, 1e-6);
  EXPECT_NEAR(r.layers[3].values[floor], 0.7, 1e-6);
}

TEST(PathLayers, ChangeNoPixelAndFollowTheCrop) {
  const Room room = full_room(true, false);
  RenderOptions options = path_options(40, 30, 4);
  const Image plain = draw(room, options).image;
  options.layers = layers_named("specular,variance");
  const PathResult whole = draw(room, options);
  EXPECT_EQ(whole.image.rgb, plain.rgb);
  for (const bool denoise : {false, true}) {
    options.denoise = denoise;
    options.crop.reset();
    const PathResult all = draw(room, options);
    EXPECT_EQ(all.layers[0].values, whole.layers[0].values);
    options.crop = PixelRegion{13, 4, 31, 22};
    const PathResult part = draw(room, options);
    ASSERT_EQ(part.image.width, 18);
    ASSERT_EQ(part.layers[1].values.size(), 18u * 18u);
    for (int y = 0; y < 18; ++y) {
      for (int x = 0; x < 18; ++x) {
        for (int c = 0; c < 3; ++c) {
          ASSERT_EQ(part.image.pixel(x, y)[c], all.image.pixel(x + 13, y + 4)[c]);
        }
        ASSERT_EQ(part.layers[1].values[std::size_t(y * 18 + x)],
                  all.layers[1].values[std::size_t((y + 4) * 40 + x + 13)]);
      }
    }
  }
}

// Mean of (value - truth)^2 / (truth^2 + 0.01).
double relative_error(const Image& image, const Image& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const double off = image.rgb[i] - truth.rgb[i];
    sum += off * off / (double(truth.rgb[i]) * truth.rgb[i] + 0.01);
  }
  return sum / double(image.rgb.size());
}

Room textured_room() {
  Room room;
  const std::uint32_t checks =
      room.texture(4, 4, {20, 220, 20, 220, 220, 20, 220, 20, 20, 220, 20, 220, 220, 20, 220, 20});
  Model model;
  FaceMaterial floor = diffuse(glm::vec3(0.9f));
  floor.diffuse_map = checks;
  FaceMaterial shiny = diffuse({0.3f, 0.1f, 0.1f});
  shiny.specular = glm::vec3(0.5f);
  shiny.shininess = 40;
  model.box({-1, 0, -1}, {1, 2, 1}, true, model.material(floor));
  model.quad({-0.5f, 1.95f, -0.2f}, {1, 0, 0}, {0, 0, 0.4f},
             model.material(diffuse(glm::vec3(0.5f), glm::vec3(6, 6, 8))));
  model.box({-0.5f, 0, -0.5f}, {0.2f, 0.7f, 0.1f}, false, model.material(shiny));
  for (std::size_t i = 0; i < model.mesh.positions.size(); ++i) {
    model.mesh.uvs.emplace_back(i % 4 == 1 || i % 4 == 2 ? 1.0f : 0.0f, i % 4 >= 2 ? 1.0f : 0.0f);
  }
  model.mesh.triangle_uvs = model.mesh.triangles;
  room.add(model);
  room.look({0.1, 1.3, 0.95}, {0, 0.6, -0.3}, 75);
  return room;
}

TEST(PathDenoise, IsNearerToTheTruthThanTheNoisyPicture) {
  for (const bool textured : {false, true}) {
    const Room room = textured ? textured_room() : full_room(true, false);
    RenderOptions many = path_options(32, 24, 400);
    many.seed = 1;  // other paths
    const Image truth = draw(room, many).image;
    for (const int samples : {4, 16, 64}) {
      SCOPED_TRACE(std::to_string(samples) + (textured ? ", textured" : ", full"));
      RenderOptions options = path_options(32, 24, samples);
      const double noisy = relative_error(draw(room, options).image, truth);
      options.denoise = true;
      const double denoised = relative_error(draw(room, options).image, truth);
      EXPECT_LT(denoised, noisy);
    }
  }
}

// Bulbs smaller than a pixel in front of a wall, and a lamp behind the camera.
Room room_of_bulbs() {
  Room room;
  Model model;
  const std::uint32_t bulb = model.material(diffuse(glm::vec3(0), glm::vec3(30)));
  model.quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}, model.material(diffuse(glm::vec3(0.6f))));
  for (const float x : {-0.8f, 0.0f, 0.8f}) {
    model.quad({x - 0.01f, 0.3f * x, 0.3f}, {0.02f, 0, 0}, {0, 0.02f, 0}, bulb);
  }
  model.quad({-2, -2, 6}, {0, 4, 0}, {4, 0, 0},
             model.material(diffuse(glm::vec3(0), glm::vec3(0.2f))));
  room.add(model);
  room.look({0, 0, 3}, {0, 0, 0}, 45);
  return room;
}

TEST(PathDenoise, SmallLampsInFrontOfAWallAreKept) {
  const Room room = room_of_bulbs();
  RenderOptions many = path_options(48, 36, 1024);
  many.seed = 1;
  const Image truth = draw(room, many).image;
  for (const int samples : {16, 64, 256}) {
    SCOPED_TRACE(samples);
    RenderOptions options = path_options(48, 36, samples);
    const Image noisy = draw(room, options).image;
    options.denoise = true;
    const Image denoised = draw(room, options).image;
    EXPECT_LT(relative_error(denoised, truth), relative_error(noisy, truth));
    EXPECT_NEAR(mean_of(denoised).x, mean_of(noisy).x, 0.01 * mean_of(noisy).x);
  }
}

// Beside it nothing is seen, which says nothing about its light.
TEST(PathDenoise, ALampAsSmallAsAPixelIsKept) {
  Room room;
  Model model;
  model.quad({0, 0, 0}, {0.05f, 0, 0}, {0, 0.05f, 0},
             model.material(diffuse(glm::vec3(0), glm::vec3(4))));
  room.add(model);
  room.look({0, 0, 1}, {0, 0, 0}, 60);
  RenderOptions options = path_options(17, 13, 64);
  const Image noisy = draw(room, options).image;
  options.denoise = true;
  const Image denoised = draw(room, options).image;
  const float brightest = *std::max_element(noisy.rgb.begin(), noisy.rgb.end());
  ASSERT_GT(brightest, 0.5f);
  ASSERT_LT(brightest, 3.5f) << "fills a pixel";
  EXPECT_EQ(*std::max_element(denoised.rgb.begin(), denoised.rgb.end()), brightest);
}

TEST(PathDenoise, ExactPicturesAndBrightnessAreKept) {
  Room room;
  Model model;
  model.box(glm::vec3(-1), glm::vec3(1), true,
            model.material(diffuse(glm::vec3(0), glm::vec3(0.3f))));
  room.add(model);
  RenderOptions options = path_options(16, 16, 4);
  options.denoise = true;
  for (const float v : draw(room, options).image.rgb) {
    EXPECT_EQ(v, 0.3f);
  }
  // Proportional to the light of the scene.
  Room dark = full_room(false, false);
  const Image bright = draw(dark, options).image;
  for (FaceMaterial& m : dark.assets.mesh_materials[0].materials) {
    m.emission *= 1e-6f;
  }
  const Image faint = draw(dark, options).image;
  for (std::size_t i = 0; i < faint.rgb.size(); ++i) {
    EXPECT_NEAR(faint.rgb[i] * 1e6, bright.rgb[i], 1e-3 * (0.01 + bright.rgb[i]));
  }
}

}  // namespace
}  // namespace scenefile::path_test
