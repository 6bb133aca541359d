#include "scenefile/trace/texture_lookup.h"
#include "trace/build_scene.h"
#include "trace/scalar_surface.h"

#include <gtest/gtest.h>

namespace scenefile::trace_test {
namespace {

Texture gray(int width, int height, const std::vector<std::uint8_t>& values) {
  Texture t;
  t.width = width;
  t.height = height;
  for (const std::uint8_t v : values) {
    t.rgb.insert(t.rgb.end(), {v, v, v});
  }
  return t;
}

double nearest(const Texture& t, double u, double v, float repeat = 1) {
  return lookup_nearest(t, {0, repeat, repeat}, {u, v}).x * 255;
}

TEST(TextureLookup, RowZeroIsAtTheTop) {
  const Texture t = gray(2, 2, {10, 20, 30, 40});
  EXPECT_NEAR(nearest(t, 0.25, 0.75), 10, 1e-9);
  EXPECT_NEAR(nearest(t, 0.75, 0.75), 20, 1e-9);
  EXPECT_NEAR(nearest(t, 0.25, 0.25), 30, 1e-9);
  EXPECT_NEAR(nearest(t, 0.75, 0.25), 40, 1e-9);
}

TEST(TextureLookup, WrapsAndRepeats) {
  const Texture t = gray(2, 1, {10, 20});
  EXPECT_NEAR(nearest(t, 1.0, 0.5), 10, 1e-9);
  EXPECT_NEAR(nearest(t, -0.1, 0.5), 20, 1e-9);
  EXPECT_NEAR(nearest(t, 0.3, 0.5, 2), 20, 1e-9);
  EXPECT_NEAR(nearest(t, 0.6, 0.5, 2), 10, 1e-9);
  EXPECT_NEAR(nearest(t, 0.1, 0.5, -1), 20, 1e-9);
}

TEST(TextureLookup, CourseFilterWeighsFromTheCorner) {
  const Texture t = gray(4, 1, {0, 100, 200, 0});
  const auto at = [&](double u) { return lookup_course_filter(t, {0, 1, 1}, {u, 0.5}).x * 255; };
  EXPECT_NEAR(at(0.25), 100, 1e-9);
  EXPECT_NEAR(at(0.375), 150, 1e-9);
  EXPECT_NEAR(at(0.875), 0, 1e-9);
}

double filtered(const Texture& t, double u, double width) {
  const MipMap p(t);
  return lookup_filtered(p, {0, 1, 1}, {u, 0.5}, {{width, 0}, {0, width}}).x * 255;
}

TEST(TextureLookup, FineFilterInterpolatesBetweenMiddles) {
  const Texture t = gray(4, 1, {0, 100, 200, 0});
  EXPECT_NEAR(filtered(t, 0.375, 0), 100, 1e-9);
  EXPECT_NEAR(filtered(t, 0.5, 0), 150, 1e-9);
}

TEST(TextureLookup, WideFootprintsGiveTheMean) {
  std::vector<std::uint8_t> stripes;
  for (int i = 0; i < 37 * 5; ++i) {
    stripes.push_back(i % 2 == 0 ? 0 : 200);
  }
  const Texture t = gray(37, 5, stripes);
  EXPECT_NEAR(filtered(t, 0.3, 4), 99.5, 3);
  EXPECT_NEAR(filtered(t, 0.3, 1e30), 99.5, 3);
  EXPECT_NEAR(filtered(t, 0.3, std::numeric_limits<double>::infinity()), 99.5, 3);
}

TEST(TextureLookup, LongFootprintsStaySharpAcross) {
  // Horizontal stripes with a footprint that is long along them.
  const Texture t = gray(64, 4, [] {
    std::vector<std::uint8_t> v(64 * 4, 0);
    std::fill(v.begin() + 64, v.begin() + 128, std::uint8_t{240});
    return v;
  }());
  const MipMap p(t);
  const glm::dvec3 c = lookup_filtered(p, {0, 1, 1}, {0.5, 0.625}, {{0.2, 0}, {0, 1e-3}});
  EXPECT_NEAR(c.x * 255, 240, 1e-6);
}

TEST(MipMap, LevelsAreAreaAverages) {
  const Texture t = gray(5, 1, {0, 50, 100, 150, 200});
  const MipMap p(t);
  ASSERT_EQ(p.levels(), 3);
  EXPECT_EQ(p.level(1).width, 2);
  EXPECT_EQ(int(p.level(1).texel(0, 0)[0]), 40);  // (0 + 50 + 100 / 2) / 2.5
  EXPECT_EQ(int(p.level(1).texel(1, 0)[0]), 160);
  EXPECT_EQ(int(p.level(2).texel(0, 0)[0]), 100);
}

TEST(Texturing, DistantCheckersTurnGrayInFine) {
  SceneBuilder b;
  RenderMaterial m;
  m.blend = 1;
  m.texture = {b.texture(2, 2, {0, 254, 254, 0}), 8000, 8000};
  b.add(Shape::cube, Affine{glm::mat3(400), glm::vec3(0, -201, 0)}, b.material(m));
  b.light(LightType::directional, {0, -1, 0}, glm::vec3(1));
  b.look({0, 0, 0}, {0, -0.02, -1}, 0.5);
  RenderOptions options = default_options(Profile::fine);
  options.features.shadows = false;
  const Image image = b.picture(16, 16, options);
  for (const float value : image.rgb) {
    EXPECT_NEAR(value, 0.5, 0.03);
  }
}

TEST(BumpMap, TiltsANormalByTheSlopeOfTheMap) {
  // The height increases by bump_height * (204 / 255) over the width of the map: one object unit.
  std::vector<std::uint8_t> ramp;
  for (int i = 0; i < 205; ++i) {
    ramp.push_back(static_cast<std::uint8_t>(i));
  }
  const double slope = 1.0 / 16 * (1.0 / 255) * 205;
  const glm::dvec3 expected = glm::normalize(glm::dvec3(-slope, 1, 0));
  SceneBuilder b;
  RenderMaterial m;
  m.bump_map.file = b.texture(205, 1, ramp);
  b.add(Shape::cube, Affine(), b.material(m));
  b.look({0.1, 2, 0}, {0.1, 0, 0}, 1);
  const glm::vec3 light = glm::normalize(glm::vec3(1, -1, 0));
  b.light(LightType::directional, light, glm::vec3(1));
  EXPECT_NEAR(b.seen(Profile::fine).x, glm::dot(expected, glm::dvec3(-light)), 1e-4);
  EXPECT_NEAR(b.seen(Profile::course).x, std::sqrt(0.5), 1e-6);  // not used in this profile
}

TEST(BumpMap, FlatMapChangesNothing) {
  for (const Shape shape : {Shape::cube, Shape::sphere, Shape::cylinder, Shape::cone}) {
    SceneBuilder b;
    RenderMaterial m;
    m.bump_map.file = b.texture(4, 4, std::vector<std::uint8_t>(16, 99));
    b.add(shape, Affine(), b.material(m));
    b.look({0.2, 2, 0.1}, {0.2, 0, 0.1}, 1);
    b.light(LightType::directional, {0.6f, -0.8f, 0}, glm::vec3(1));
    const glm::dvec3 with = b.seen(Profile::fine);
    b.scene.materials[0].bump_map = {};
    EXPECT_NEAR(with.x, b.seen(Profile::fine).x, 1e-9);
  }
}

}  // namespace
}  // namespace scenefile::trace_test
