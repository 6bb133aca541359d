// Path-traced pictures as data: the same for any number of threads, in parts, in passes.

#include "path/rooms.h"
#include "scenefile/path/path_scene.h"
#include "scenefile/trace/visit_options.h"

#include <gtest/gtest.h>

#include <limits>

namespace scenefile::path_test {
namespace {

Room lit_room() {
  Room room;
  Model model;
  FaceMaterial shiny = diffuse(glm::vec3(0.4f));
  shiny.specular = glm::vec3(0.4f);
  shiny.shininess = 20;
  model.box({-1, 0, -1}, {1, 2, 1}, true, model.material(diffuse(glm::vec3(0.7f))));
  model.quad({-0.3f, 1.99f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f},
             model.material(diffuse(glm::vec3(0.5f), glm::vec3(12, 10, 8))));
  model.box({-0.6f, 0, -0.6f}, {0, 0.9f, 0}, false, model.material(shiny));
  room.add(model);
  room.look({0, 1, 0.95}, {0, 0.9, 0}, 70);
  room.scene.camera.aperture = 0.02;
  room.scene.camera.focal_length = 1;
  return room;
}

TEST(PathPicture, ThreadsDoNotChangeIt) {
  RenderOptions options = path_options(40, 33, 4);
  options.threads = 1;
  const Image one = draw(lit_room(), options).image;
  options.threads = 2;
  EXPECT_EQ(draw(lit_room(), options).image.rgb, one.rgb);
}

TEST(PathPicture, CropIsPartOfTheWhole) {
  RenderOptions options = path_options(40, 33, 4);
  const Image whole = draw(lit_room(), options).image;
  options.crop = PixelRegion{7, 5, 30, 32};
  const Image part = draw(lit_room(), options).image;
  ASSERT_EQ(part.width, 23);
  ASSERT_EQ(part.height, 27);
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_EQ(part.pixel(x, y)[c], whole.pixel(x + 7, y + 5)[c]);
      }
    }
  }
}

TEST(PathPicture, PassesAddUp) {
  const Room room = lit_room();
  const RenderOptions options = path_options(20, 20, 13);
  const Image at_once = draw(room, options).image;
  const TraceScene traced(room.scene, room.assets);
  const PathScene scene(traced, room.scene, options);
  PathState state = make_path_state(options);
  RenderStats stats;
  for (const std::uint32_t samples : {1, 5, 6, 13}) {
    EXPECT_EQ(add_samples(scene, samples, state, {}, stats), RenderStatus::complete);
  }
  EXPECT_EQ(image_of(state).rgb, at_once.rgb);
  EXPECT_EQ(stats.primary_rays, 20u * 20 * 13);
  EXPECT_GT(stats.shadow_rays, stats.primary_rays / 2);
}

TEST(PathPicture, CancelledOneCanGoOn) {
  const Room room = lit_room();
  const RenderOptions options = path_options(64, 64, 8);
  const TraceScene traced(room.scene, room.assets);
  const PathScene scene(traced, room.scene, options);
  PathState state = make_path_state(options);
  RenderStats stats;
  EXPECT_EQ(add_samples(
                scene, 8, state, [](double) { return false; }, stats),
            RenderStatus::cancelled);
  EXPECT_EQ(add_samples(scene, 8, state, {}, stats), RenderStatus::complete);
  EXPECT_EQ(image_of(state).rgb, draw(room, options).image.rgb);
}

TEST(PathPicture, TimeLimitsTheSamples) {
  RenderOptions options = path_options(32, 32, 1 << 16);
  PathControl control;
  control.seconds = 0.2;
  const Room room = lit_room();
  const PathResult limited = render_path(room.scene, room.assets, options, control);
  EXPECT_EQ(limited.status, RenderStatus::complete);
  EXPECT_GE(limited.samples, 1u);
  EXPECT_LT(limited.samples, 1u << 16);
  // The number of samples gives the same picture again.
  options.samples = static_cast<int>(limited.samples);
  EXPECT_EQ(draw(room, options).image.rgb, limited.image.rgb);
}

TEST(PathPicture, SeedsAreIndependent) {
  RenderOptions options = path_options(16, 16, 16);
  const PathResult a = draw(lit_room(), options);
  options.seed = std::uint64_t{1} << 40;
  const PathResult b = draw(lit_room(), options);
  const std::vector<float> variances = variances_of(a.state);
  double difference = 0, expected = 0;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const auto bright = [&](const Image& image) {
      return luminance({image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2]});
    };
    difference += std::pow(bright(a.image) - bright(b.image), 2);
    expected += 2 * variances[i];
  }
  // Less than the variance of independent samples, because those of a pixel are stratified.
  EXPECT_LT(difference, expected);
  EXPECT_GT(difference, 0.02 * expected);
}

TEST(PathPicture, LimitOfIndirectLight) {
  RenderOptions options = path_options(16, 16, 16);
  const double all = mean_of(draw(lit_room(), options).image).y;
  options.clamp = 1e-9;
  const double direct_clamped = mean_of(draw(lit_room(), options).image).y;
  options.clamp = 0;
  options.max_depth = 1;
  EXPECT_NEAR(direct_clamped, mean_of(draw(lit_room(), options).image).y, 1e-6);
  options.max_depth = 0;
  options.clamp = 1e9;
  EXPECT_EQ(mean_of(draw(lit_room(), options).image).y, all);
}

TEST(PathPicture, ExtremeScenesGiveFiniteNumbers) {
  const float large = std::numeric_limits<float>::max();
  FaceMaterial bright = diffuse(glm::vec3(1000), glm::vec3(large));
  FaceMaterial dense = diffuse(glm::vec3(1), glm::vec3(1e-38f));
  dense.specular = glm::vec3(large);
  dense.shininess = large;
  FaceMaterial flat = glossy(glm::vec3(0.9f), 0);
  for (const FaceMaterial& m :
       {bright, dense, flat, mirror(glm::vec3(large)), glass(1e-30f), glass(1e30f)}) {
    for (const float size : {1.0f, 1e-12f, 1e12f}) {
      Room room;
      Model model;
      model.box(glm::vec3(-1), glm::vec3(1), true, model.material(m));
      model.quad({-0.5f, 0.5f, -0.5f}, {1, 0, 0}, {0, 0, 1},
                 model.material(diffuse(glm::vec3(0.5f), glm::vec3(1))));
      // Without area.
      model.mesh.triangles.push_back({0, 1, 1});
      model.materials.of_triangle.push_back(1);
      room.add(model, scale(glm::vec3(size)));
      room.look({0, 0, 0}, glm::dvec3(-0.4, -0.1, -1) * double(size), 70);
      const PathResult r = draw(room, path_options(8, 8, 8));
      for (const float value : r.image.rgb) {
        ASSERT_TRUE(std::isfinite(value) && value >= 0);
      }
    }
  }
}

TEST(PathPicture, EmptySceneIsBlack) {
  const PathResult r = draw(Room(), path_options(4, 4, 2));
  EXPECT_EQ(r.status, RenderStatus::complete);
  EXPECT_EQ(mean_of(r.image), glm::dvec3(0));
}

TEST(PathPicture, OptionsSaySoWhereTheyHaveNoEffect) {
  for (const char* const name :
       {"light_samples", "direct_only", "continuation", "convention", "clamp"}) {
    EXPECT_TRUE(supports_option(Mode::path, support_of(name))) << name;
    EXPECT_FALSE(supports_option(Mode::ray, support_of(name))) << name;
  }
  for (const char* const name : {"features", "min_samples", "fresnel"}) {
    EXPECT_FALSE(supports_option(Mode::path, support_of(name))) << name;
    EXPECT_TRUE(supports_option(Mode::ray, support_of(name))) << name;
  }
}

}  // namespace
}  // namespace scenefile::path_test
