#include "scenefile/trace/layers.h"

#include "trace/build_scene.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace scenefile::trace_test {
namespace {

TEST(LayerWords, AreReadAndWritten) {
  std::vector<Layer> layers;
  EXPECT_EQ(parse_layers("depth,light-12,object-id", layers), "");
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[1], (Layer{LayerKind::light, 11}));
  EXPECT_EQ(layer_name(layers[1]), "light-12");
  for (const std::string_view word : layer_words) {
    EXPECT_EQ(parse_layers(word, layers), "");
    EXPECT_EQ(layer_name(layers[0]), word);
  }
}

TEST(LayerWords, MistakesAreNamed) {
  std::vector<Layer> layers;
  EXPECT_EQ(parse_layers("depth,normals", layers), "normals");
  EXPECT_EQ(parse_layers("uv,uv", layers), "uv");
  for (const char* const word :
       {"light-0", "light-", "light-1x", "light-01", "light--1", "Depth"}) {
    EXPECT_EQ(parse_layers(word, layers), word);
  }
  EXPECT_EQ(parse_layers("", layers), ",");
  EXPECT_EQ(parse_layers("uv,", layers), ",");
}

RenderOptions with_layers(Profile profile, std::string_view words) {
  RenderOptions options = default_options(profile);
  EXPECT_EQ(parse_layers(words, options.layers), "");
  options.width = 24;
  options.height = 16;
  return options;
}

constexpr std::string_view all_words =
    "depth,normal,uv,albedo,object-id,light-1,light-2,shadow,reflection-depth";

// A lit wall with its front at z = -3 that fills the view; a small plate casts a shadow on it.
SceneBuilder wall() {
  SceneBuilder b;
  RenderMaterial m;
  m.ambient = glm::vec3(0.0625);
  m.diffuse = {0.5, 0.25, 0.125};
  b.add(Shape::cube, Affine{glm::mat3(20), glm::vec3(0, 0, -13)}, b.material(m));
  b.light(LightType::directional, {0, 0, -1}, glm::vec3(0.5));
  b.light(LightType::point, {0, 0, 2}, {0.25, 0, 0});
  return b;
}

const float* value(const RenderResult& result, const RenderOptions& options, std::size_t layer,
                   int x, int y) {
  const ImageLayer& l = result.layers[layer];
  return &l.values[l.channels.size() * (std::size_t(y) * options.width + x)];
}

TEST(Layers, ContainWhatTheCameraSees) {
  for (const Profile profile : {Profile::course, Profile::fine}) {
    const RenderOptions options = with_layers(profile, all_words);
    const SceneBuilder b = wall();
    const RenderResult result = render(b.scene, b.assets, options);
    ASSERT_EQ(result.layers.size(), 9U);
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(12, 8), std::pair(23, 3)}) {
      const auto at = [&, x = x, y = y](std::size_t layer) {
        return value(result, options, layer, x, y);
      };
      EXPECT_NEAR(at(0)[0], 3, 1e-6);  // along the view axis, not along the ray
      EXPECT_NEAR(at(1)[2], 1, 1e-6);
      const float across =
          float(std::tan(b.scene.camera.fov_y / 2)) * 3 / 8;  // size of a pixel on the wall
      EXPECT_NEAR(at(2)[0], 0.5f + (float(x) + 0.5f - 12) * across / 20, 1e-5);
      EXPECT_NEAR(at(3)[1], 0.25, 1e-6);
      EXPECT_EQ(at(4)[0], 1);
      EXPECT_NEAR(at(5)[0], 0.25, 1e-6);
      EXPECT_GT(at(6)[0], 0.05);
      EXPECT_EQ(at(6)[1], 0);
      EXPECT_NEAR(at(7)[0], 0, 1e-9);
      EXPECT_EQ(at(8)[0], 0);
    }
  }
}

TEST(Layers, OfAnEmptyScene) {
  SceneBuilder b;
  const RenderOptions options = with_layers(Profile::fine, all_words);
  const RenderResult result = render(b.scene, b.assets, options);
  EXPECT_EQ(value(result, options, 0, 3, 3)[0], std::numeric_limits<float>::infinity());
  for (std::size_t i = 1; i < result.layers.size(); ++i) {
    EXPECT_EQ(value(result, options, i, 3, 3)[0], 0) << result.layers[i].name;
  }
}

// Spheres in front of the wall: edges, shadows, and optionally glass and mirrors.
SceneBuilder spheres(float mirror) {
  SceneBuilder b = wall();
  RenderMaterial m;
  m.diffuse = {0.125, 0.5, 0.25};
  m.specular = glm::vec3(0.25);
  m.shininess = 5;
  m.reflective = glm::vec3(mirror);
  const std::uint32_t material = b.material(m);
  b.add(Shape::sphere, translate({-0.7f, 0.1f, -2}), material);
  b.add(Shape::cone, translate({0.6f, -0.2f, -2.2f}), material);
  return b;
}

TEST(Layers, LightsAddUpToThePicture) {
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = with_layers(profile, "light-1,light-2");
    options.features.super_sample = true;
    SceneBuilder b = spheres(0);
    b.scene.global.ambient = 0;
    const RenderResult result = render(b.scene, b.assets, options);
    for (std::size_t i = 0; i < result.image.rgb.size(); ++i) {
      ASSERT_NEAR(result.layers[0].values[i] + result.layers[1].values[i], result.image.rgb[i],
                  1e-6)
          << i;
    }
  }
}

TEST(Layers, DoNotChangeThePicture) {
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = with_layers(profile, all_words);
    options.features.super_sample = true;
    const SceneBuilder b = spheres(0.5);
    const RenderResult with = render(b.scene, b.assets, options);
    options.threads = 1;
    const RenderResult alone = render(b.scene, b.assets, options);
    for (std::size_t i = 0; i < with.layers.size(); ++i) {
      EXPECT_EQ(with.layers[i].values, alone.layers[i].values) << with.layers[i].name;
    }
    options.layers.clear();
    EXPECT_EQ(render(b.scene, b.assets, options).image.rgb, with.image.rgb);
  }
}

TEST(Layers, MeansAreSmoothAtEdges) {
  const RenderOptions options = with_layers(Profile::fine, all_words);
  const SceneBuilder b = spheres(0);
  const RenderResult result = render(b.scene, b.assets, options);
  bool short_normal = false;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const float* const n = value(result, options, 1, x, y);
      short_normal = short_normal || glm::length(glm::vec3(n[0], n[1], n[2])) < 0.95f;
      const float id = value(result, options, 4, x, y)[0];
      EXPECT_TRUE(id == 1 || id == 2 || id == 3) << id;
    }
  }
  EXPECT_TRUE(short_normal);
}

TEST(Layers, ShadowIsTheShareOfRemovedLight) {
  SceneBuilder b = wall();
  // Occludes the left half for the directional light, which provides two thirds of the red light
  // there and all of the green and blue.
  b.scene.lights.pop_back();
  b.add(Shape::cube, translate({-10, 0, 5}) * scale({20, 40, 0.5f}), 0);
  const RenderOptions options = with_layers(Profile::fine, "shadow");
  const RenderResult result = render(b.scene, b.assets, options);
  EXPECT_EQ(value(result, options, 0, 4, 8)[0], 1);
  EXPECT_EQ(value(result, options, 0, 20, 8)[0], 0);
  b.light(LightType::directional, {0.5f, 0, -std::sqrt(0.75f)}, glm::vec3(0.5));
  b.scene.lights.back().direction = -b.scene.lights.back().direction;  // from behind: unlit
  const RenderResult unchanged = render(b.scene, b.assets, options);
  EXPECT_EQ(value(unchanged, options, 0, 4, 8)[0], 1);
}

TEST(Layers, ReflectionDepthCountsBounces) {
  const RenderOptions options = with_layers(Profile::fine, "reflection-depth");
  const SceneBuilder b = spheres(0.5);
  const RenderResult result = render(b.scene, b.assets, options);
  EXPECT_EQ(value(result, options, 0, 0, 0)[0], 0);
  EXPECT_GE(value(result, options, 0, 7, 7)[0], 1);
}

TEST(LayerPicture, MapsValuesToColors) {
  const auto pictured = [](const char* word, std::vector<std::string> channels,
                           std::vector<float> values) {
    std::vector<Layer> layers;
    parse_layers(word, layers);
    const int width = static_cast<int>(values.size() / channels.size());
    return layer_picture(layers[0], {word, std::move(channels), false, std::move(values)}, width, 1,
                         4)
        .rgb;
  };
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> depth = pictured("depth", {"Z"}, {2, 4, 3, infinity});
  EXPECT_EQ(depth[0], 1);
  EXPECT_EQ(depth[3], 0);
  EXPECT_EQ(depth[6], 0.5f);
  EXPECT_EQ(depth[9], 0);
  EXPECT_EQ(pictured("normal", {"X", "Y", "Z"}, {0, -1, 1, 0, 0, 0}),
            (std::vector<float>{0.5f, 0, 1, 0, 0, 0}));
  EXPECT_EQ(pictured("uv", {"U", "V"}, {0.25f, 0.75f}), (std::vector<float>{0.25f, 0.75f, 0}));
  EXPECT_EQ(pictured("reflection-depth", {"Y"}, {1})[2], 0.25f);
  const std::vector<float> ids = pictured("object-id", {"ID"}, {0, 1, 2});
  EXPECT_EQ(ids[0] + ids[1] + ids[2], 0);
  EXPECT_NE(std::vector<float>(ids.begin() + 3, ids.begin() + 6),
            std::vector<float>(ids.begin() + 6, ids.end()));
}

// Cuts out a region of the picture.
std::vector<float> part_of(const std::vector<float>& values, int width, const PixelRegion& crop) {
  const std::size_t channels = values.size() / std::size_t(width) / 16;
  std::vector<float> part;
  for (int y = crop.y0; y < crop.y1; ++y) {
    const float* const row = &values[channels * (std::size_t(y) * width + crop.x0)];
    part.insert(part.end(), row, row + channels * crop.width());
  }
  return part;
}

TEST(Crop, IsThatPartOfThePicture) {
  SceneBuilder b = spheres(0.5);
  b.scene.lights[1].type = LightType::area;
  b.scene.lights[1].direction = {0, 0, -1};
  b.scene.lights[1].half_u = {1, 0, 0};
  b.scene.lights[1].half_v = {0, 1, 0};
  b.scene.camera.focal_length = 3;
  for (const auto& [profile, aperture] :
       {std::pair(Profile::course, 0.0), std::pair(Profile::fine, 0.0),
        std::pair(Profile::fine, 0.02)}) {
    b.scene.camera.aperture = aperture;
    RenderOptions options = with_layers(profile, all_words);
    options.features.super_sample = true;
    for (options.denoise = false;; options.denoise = true) {
      options.crop.reset();
      const RenderResult whole = render(b.scene, b.assets, options);
      for (const PixelRegion& crop :
           {PixelRegion{0, 0, 24, 16}, PixelRegion{5, 4, 13, 11}, PixelRegion{23, 15, 24, 16}}) {
        options.crop = crop;
        const RenderResult result = render(b.scene, b.assets, options);
        EXPECT_EQ(result.image.width, crop.width());
        EXPECT_EQ(result.image.height, crop.height());
        EXPECT_EQ(result.image.rgb, part_of(whole.image.rgb, 24, crop));
        for (std::size_t i = 0; i < whole.layers.size(); ++i) {
          EXPECT_EQ(result.layers[i].values, part_of(whole.layers[i].values, 24, crop));
        }
      }
      if (options.denoise) {
        break;
      }
    }
  }
}

TEST(Preview, EndsWithThePicture) {
  const SceneBuilder b = spheres(0.5);
  RenderOptions options = default_options(Profile::fine);
  options.width = 160;
  options.height = 100;
  options.crop = PixelRegion{10, 10, 150, 90};
  std::vector<Image> shown;
  Preview preview;
  preview.show = [&](const Image& image) { shown.push_back(image); };
  preview.interval_seconds = 0;
  const RenderResult result = render(b.scene, b.assets, options, {.preview = preview});
  EXPECT_EQ(result.image.rgb, render(b.scene, b.assets, options).image.rgb);
  ASSERT_GE(shown.size(), 2U);
  EXPECT_EQ(shown.back().rgb, result.image.rgb);
  for (const Image& image : shown) {
    EXPECT_EQ(image.width, 140);
    EXPECT_GT(image.pixel(139, 79)[0], 0) << "no part is ever empty";
  }
}

}  // namespace
}  // namespace scenefile::trace_test
