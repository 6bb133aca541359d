// Pixels of draw(), for scenes with known results.

#include "view/build_scene.h"

namespace scenefile {

namespace {

using namespace view_test;

DrawOptions one_sample() {
  DrawOptions options;
  options.samples = 1;
  return options;
}

TEST_F(Drawn, AnObjectIsWhereTheCameraSeesIt) {
  SceneBuilder builder;
  builder.add(Shape::sphere, place({1, 1, -4}), builder.glowing({1, 0.5f, 0.25f}));
  builder.scene.camera.fov_y = glm::radians(90.0);
  Drawing drawing = uploaded(builder);
  const Image image = draw_square(drawing, builder.scene.camera, one_sample());
  // (1, 1, -4) is a quarter of the way from the center to the upper right corner.
  const glm::vec3 inside = at(image, 20, 11);
  EXPECT_NEAR(inside.r, 1, 1.0 / 255);
  EXPECT_NEAR(inside.g, 0.5, 1.0 / 255);
  EXPECT_NEAR(inside.b, 0.25, 1.0 / 255);
  EXPECT_EQ(at(image, 11, 20), glm::vec3(0));
  EXPECT_EQ(stats.draw_calls, 1u);
  EXPECT_EQ(stats.objects, 1u);
}

TEST_F(Drawn, TheNearerObjectIsVisible) {
  SceneBuilder builder;
  builder.add(Shape::cube, place({0, 0, -3}), builder.glowing({1, 0, 0}));
  builder.add(Shape::cube, place({0, 0, -6}, 4), builder.glowing({0, 1, 0}));
  Drawing drawing = uploaded(builder);
  const Image image = draw_square(drawing, builder.scene.camera, one_sample());
  EXPECT_EQ(at(image, 16, 16), glm::vec3(1, 0, 0));
  EXPECT_EQ(at(image, 2, 16), glm::vec3(0, 1, 0));
}

TEST_F(Drawn, ObjectAtNamesWhatThePictureShows) {
  SceneBuilder builder;
  builder.add(Shape::cube, place({0, 0, -3}), builder.glowing({1, 0, 0}));
  builder.add(Shape::cube, place({1, 0, -4}), builder.glowing({0, 1, 0}));
  Drawing drawing = uploaded(builder);
  const RenderCamera& camera = builder.scene.camera;
  const auto source_at = [&](const DrawOptions& options, int x, int y) {
    const auto object = object_at(*device, drawing, camera, options, 64, 64, x, y);
    return object ? drawing.objects()[*object].source : no_index;
  };
  EXPECT_EQ(source_at({}, 32, 32), 0u);
  EXPECT_EQ(source_at({}, 55, 32), 1u);
  EXPECT_EQ(source_at({}, 32, 2), no_index);
  DrawOptions without_first;
  without_first.objects = {false};
  EXPECT_EQ(source_at(without_first, 32, 32), no_index);
}

TEST_F(Drawn, OneCallDrawsAllInstancesOfAShape) {
  SceneBuilder builder;
  const std::uint32_t material = builder.glowing({1, 1, 1});
  for (int i = 0; i < 50; ++i) {
    builder.add(Shape::cube, place({i % 10 - 5, i / 10 - 2, -20}, 0.5f), material);
  }
  Drawing drawing = uploaded(builder);
  draw_square(drawing, builder.scene.camera, one_sample());
  EXPECT_EQ(stats.draw_calls, 1u);
  EXPECT_EQ(stats.objects, 50u);
}

TEST_F(Drawn, CopiesBeyondTheLimitAreLeftOutWithAWarning) {
  SceneBuilder builder;
  builder.add(Shape::cube, place({0, 0, 0}), builder.glowing({1, 1, 1}));
  builder.scene.groups.emplace_back();
  for (int i = 0; i < 5; ++i) {
    builder.add_instance(0, place({0, 0, -4 - i}));
  }
  UploadOptions options;
  options.max_objects = 5;
  EXPECT_EQ(uploaded(builder, options).objects().size(), 5u);
  EXPECT_EQ(diagnostics.list().size(), 0u);
  options.max_objects = 4;
  EXPECT_EQ(uploaded(builder, options).objects().size(), 4u);
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].code->name, "gl.copies-left-out");
}

TEST_F(Drawn, TheFarthestAreLeftOutWhereThePictureIsCoveredTooOften) {
  SceneBuilder builder;
  const std::uint32_t red = builder.glowing({1, 0, 0});
  const std::uint32_t green = builder.glowing({0, 1, 0});
  for (int i = 0; i < 3000; ++i) {
    builder.add(Shape::cube, place({0, 0, -30 - 0.01f * float(i)}, 40), i == 2999 ? red : green);
  }
  builder.add(Shape::cube, place({0, 0, -90}, 0.01f), red);  // takes far less work than the others
  Drawing drawing = uploaded(builder);
  const Image image = draw_square(drawing, builder.scene.camera, one_sample(), 512);
  EXPECT_EQ(at(image, 256, 256), glm::vec3(0, 1, 0));
  EXPECT_GT(stats.left_out, 500u);
  EXPECT_EQ(stats.left_out + stats.objects, 3001u);
  draw_square(drawing, builder.scene.camera, one_sample(), 64);
  EXPECT_EQ(stats.left_out, 0u);
}

TEST_F(Drawn, SmallObjectsGetMoreSamplesByDefault) {
  const auto image_with = [&](float size, int samples) {
    SceneBuilder builder;
    const std::uint32_t material = builder.glowing({1, 1, 1});
    for (int i = 0; i < 100; ++i) {
      builder.add(Shape::sphere, place({1.01f * float(i % 10) - 5, float(i / 10 - 5), -20}, size),
                  material);
    }
    Drawing drawing = uploaded(builder);
    DrawOptions options;
    options.samples = samples;
    return draw_square(drawing, builder.scene.camera, options).rgb;
  };
  EXPECT_EQ(image_with(0.3f, 0), image_with(0.3f, 16));
  EXPECT_NE(image_with(0.3f, 0), image_with(0.3f, 4));
  EXPECT_EQ(image_with(4, 0), image_with(4, 4));
  EXPECT_NE(image_with(4, 0), image_with(4, 16));
}

TEST_F(Drawn, TracerOnlyEffectsAreNoted) {
  SceneBuilder builder;
  builder.add(Shape::cube, place({0, 0, -3}), builder.glowing({1, 1, 1}));
  uploaded(builder);
  EXPECT_EQ(diagnostics.list().size(), 0u);
  builder.scene.materials[0].reflective = glm::vec3(1);
  uploaded(builder);
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].code->name, "gl.not-drawn");
}

}  // namespace

}  // namespace scenefile
