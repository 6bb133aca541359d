// Pictures driven by the caller: passes, parts, and a reused acceleration structure.

#include "scenefile/trace/picture_state.h"
#include "trace/build_scene.h"

#include <gtest/gtest.h>

#include <limits>

namespace scenefile::trace_test {
namespace {

// Edges, a mirror, a penumbra, and a weak lens unless `aperture` is 0.
SceneBuilder many_spheres(double aperture = 0) {
  SceneBuilder b;
  b.scene.camera.aperture = aperture;
  b.scene.camera.focal_length = 4;
  RenderMaterial mirror;
  mirror.diffuse = {0.6f, 0.5f, 0.4f};
  mirror.reflective = glm::vec3(0.5);
  const std::uint32_t m = b.material(mirror);
  b.add(Shape::cube, Affine{glm::mat3(10), glm::vec3(0, -5.5, -4)}, m);
  for (int i = 0; i < 12; ++i) {
    b.add(Shape::sphere, translate({float(i) * 0.5f - 2, float(i % 3) * 0.4f, -4}), m);
  }
  RenderLight& light = b.light(LightType::area, {1, 4, -2}, glm::vec3(0.75));
  light.half_u = {0.5, 0, 0};
  light.half_v = {0, 0, 0.5};
  b.look({0, 1, 1}, {0, 0, -4});
  return b;
}

// Options for all kinds of pictures.
std::vector<RenderOptions> all_kinds() {
  std::vector<RenderOptions> kinds;
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = default_options(profile);
    options.width = 75;
    options.height = 50;
    kinds.push_back(options);
    options.samples = 1;
    options.features.super_sample = true;
    kinds.push_back(options);
    options.samples = 8;
    options.layers = {{LayerKind::depth, 0}, {LayerKind::light, 0}, {LayerKind::object_id, 0}};
    kinds.push_back(options);
    options.denoise = profile == Profile::fine;
    kinds.push_back(options);
    options.crop = PixelRegion{13, 7, 61, 44};
    kinds.push_back(options);
    options.mode = Mode::normals;
    kinds.push_back(options);
  }
  return kinds;
}

void finish(const TraceScene& traced, const SceneBuilder& b, const RenderOptions& options,
            PictureState& state) {
  while (!complete(state)) {
    ASSERT_EQ(render_pass(traced, b.scene, options, state), RenderStatus::complete);
  }
}

void expect_same(const Resolved& drawn, const RenderResult& expected) {
  EXPECT_EQ(drawn.image.width, expected.image.width);
  EXPECT_TRUE(drawn.image.rgb == expected.image.rgb);
  ASSERT_EQ(drawn.layers.size(), expected.layers.size());
  for (std::size_t i = 0; i < drawn.layers.size(); ++i) {
    EXPECT_EQ(drawn.layers[i].name, expected.layers[i].name);
    EXPECT_TRUE(drawn.layers[i].values == expected.layers[i].values) << drawn.layers[i].name;
  }
}

TEST(State, PassesMakeThePicture) {
  for (const double aperture : {0.0, 0.01}) {
    const SceneBuilder b = many_spheres(aperture);
    const TraceScene traced(b.scene, b.assets);
    for (const RenderOptions& options : all_kinds()) {
      PictureState state = make_state(b.scene, options);
      finish(traced, b, options, state);
      expect_same(resolve(std::move(state)), render(b.scene, b.assets, options));
    }
  }
}

TEST(State, PartsMergeToTheSameBytes) {
  for (const double aperture : {0.0, 0.01}) {
    const SceneBuilder b = many_spheres(aperture);
    const TraceScene traced(b.scene, b.assets);
    for (const RenderOptions& options : all_kinds()) {
      const RenderResult expected = render(b.scene, b.assets, options);
      for (const std::uint32_t count : {1u, 2u, 3u, 7u, 50u}) {
        PictureState whole = make_state(b.scene, options);
        for (std::uint32_t i = count; i-- > 0;) {
          EXPECT_FALSE(complete(whole) && count < 10) << "parts are missing";
          PictureState part = make_part(b.scene, options, i, count);
          EXPECT_EQ(merge(whole, part), complete(part)) << "an incomplete part is refused";
          if (!complete(part)) {
            finish(traced, b, options, part);
            EXPECT_TRUE(merge(whole, part));
          }
        }
        EXPECT_TRUE(complete(whole)) << count;
        expect_same(resolve(std::move(whole)), expected);
      }
    }
  }
}

TEST(State, PartsOfOtherPicturesAreRejected) {
  const SceneBuilder b = many_spheres();
  const TraceScene traced(b.scene, b.assets);
  const RenderOptions course = all_kinds()[0];
  RenderOptions fine = all_kinds()[6];
  PictureState part = make_part(b.scene, course, 0, 2);
  finish(traced, b, course, part);
  PictureState other = make_state(b.scene, fine);
  EXPECT_FALSE(merge(other, part));
  RenderOptions layered = course;
  layered.layers = {{LayerKind::depth, 0}};
  other = make_state(b.scene, layered);
  EXPECT_FALSE(merge(other, part));
  RenderOptions small = course;
  small.width = 20;
  other = make_state(b.scene, small);
  EXPECT_FALSE(merge(other, part));
}

TEST(State, ShortCallsContinue) {
  const SceneBuilder b = many_spheres();
  const TraceScene traced(b.scene, b.assets);
  for (const RenderOptions& options : all_kinds()) {
    PictureState state = make_state(b.scene, options);
    for (int calls = 0; !complete(state) && calls < 1000; ++calls) {
      render_pass(traced, b.scene, options, state, [](double) { return false; });
      // As if another process resumed.
      PictureState next = make_state(b.scene, options);
      ASSERT_TRUE(decode_state(encode_state(state), next));
      state = std::move(next);
    }
    expect_same(resolve(std::move(state)), render(b.scene, b.assets, options));
  }
}

TEST(State, OneStructureServesOtherCamerasLightsMaterialsAndOptions) {
  SceneBuilder b = many_spheres();
  const TraceScene traced(b.scene, b.assets);
  for (int i = 0; i < 3; ++i) {
    b.look({float(i) - 1, 1, 1}, {0, 0, -4});
    b.scene.lights.front().color = glm::vec3(0.25f * float(i + 1));
    b.scene.materials.front().diffuse.x = 0.2f * float(i);
    for (const RenderOptions& options : all_kinds()) {
      const RenderResult kept = render(b.scene, b.assets, options, {.traced = &traced});
      const RenderResult fresh = render(b.scene, b.assets, options);
      EXPECT_TRUE(kept.image.rgb == fresh.image.rgb);
    }
  }
}

TEST(State, AStructureThatCannotBeBuiltIsReported) {
  const SceneBuilder b = many_spheres();
  EXPECT_EQ(TraceScene(b.scene, b.assets).status(), RenderStatus::complete);
  EXPECT_GE(TraceScene(b.scene, b.assets).build_seconds(), 0);
}

}  // namespace
}  // namespace scenefile::trace_test
