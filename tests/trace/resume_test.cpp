// Interrupting and resuming pictures.

#include "scenefile/trace/picture_state.h"
#include "trace/build_scene.h"

#include <gtest/gtest.h>

#include <utility>

namespace scenefile::trace_test {
namespace {

// Edges, a penumbra and a mirror: some pixels converge immediately, others do not.
SceneBuilder uneven_scene() {
  SceneBuilder b;
  RenderMaterial mirror;
  mirror.reflective = glm::vec3(0.5);
  const std::uint32_t m = b.material(mirror);
  b.add(Shape::cube, Affine{glm::mat3(10), glm::vec3(0, -5.5, -4)}, m);
  for (int i = 0; i < 5; ++i) {
    b.add(Shape::sphere, translate({float(i) - 2, 0, -4}), m);
  }
  RenderLight& light = b.light(LightType::area, {1, 4, -2}, glm::vec3(0.75));
  light.half_u = {0.5, 0, 0};
  light.half_v = {0, 0, 0.5};
  b.look({0, 1, 1}, {0, 0, -4});
  return b;
}

RenderOptions options_of(Profile profile) {
  RenderOptions options = default_options(profile);
  options.width = 40;
  options.height = 24;
  return options;
}

// Stops after some calls of the progress function, and resumes from the state saved then.
RenderResult in_parts(const SceneBuilder& b, const RenderOptions& options, int calls, int& parts) {
  Checkpoints checkpoints;
  for (parts = 1;; ++parts) {
    std::string saved;
    checkpoints.interval_seconds = 0;
    checkpoints.save = [&](const std::string& state) { saved = state; };
    int left = calls;
    RenderResult result =
        render(b.scene, b.assets, options,
               {.progress = [&](double) { return --left > 0; }, .checkpoints = checkpoints});
    if (result.status != RenderStatus::cancelled) {
      return result;
    }
    checkpoints.resume = saved;
  }
}

PictureState empty_state(int width, int height, bool two_passes) {
  RenderOptions options = default_options(Profile::fine);
  options.width = width;
  options.height = height;
  options.samples = two_passes ? 16 : 1;
  return make_state({}, options);
}

TEST(Resume, GivesTheSameBytes) {
  SceneBuilder b = uneven_scene();
  b.scene.camera.focal_length = 4;
  for (const auto& [profile, aperture] :
       {std::pair(Profile::fine, 0.0), std::pair(Profile::fine, 0.01),
        std::pair(Profile::course, 0.0)}) {
    b.scene.camera.aperture = aperture;
    for (const int threads : {1, 3}) {
      RenderOptions options = options_of(profile);
      options.threads = threads;
      const RenderResult whole = render(b.scene, b.assets, options);
      for (const int calls : {1, 2}) {
        int parts = 0;
        const RenderResult result = in_parts(b, options, calls, parts);
        EXPECT_EQ(result.status, RenderStatus::complete);
        EXPECT_TRUE(result.image.rgb == whole.image.rgb) << parts << " parts";
      }
    }
  }
}

TEST(Resume, ContinuesWhereItStopped) {
  const SceneBuilder b = uneven_scene();
  RenderOptions options = options_of(Profile::course);
  options.width = 400;
  options.height = 300;
  options.features.super_sample = true;
  Checkpoints checkpoints;
  checkpoints.interval_seconds = 0;
  checkpoints.save = [&](const std::string& state) { checkpoints.resume = state; };
  double stopped_at = 0;
  const RenderResult first = render(b.scene, b.assets, options,
                                    {.progress =
                                         [&](double done) {
                                           stopped_at = done;
                                           return done < 0.3;
                                         },
                                     .checkpoints = checkpoints});
  ASSERT_EQ(first.status, RenderStatus::cancelled);
  const RenderResult whole = render(b.scene, b.assets, options);
  const RenderResult second = render(b.scene, b.assets, options, {.checkpoints = checkpoints});
  EXPECT_LT(double(second.stats.primary_rays), double(whole.stats.primary_rays) * 0.9);
  EXPECT_GE(stopped_at, 0.3);
}

TEST(Resume, StatesOfOtherPicturesAreRejected) {
  PictureState state = empty_state(40, 30, true);
  PictureState narrow = empty_state(39, 30, true);
  PictureState one_pass = empty_state(40, 30, false);
  const std::string bytes = encode_state(state);
  EXPECT_TRUE(decode_state(bytes, state));
  EXPECT_FALSE(decode_state(bytes, narrow));
  EXPECT_FALSE(decode_state(bytes, one_pass));
  EXPECT_FALSE(decode_state(bytes.substr(1), state));
  EXPECT_FALSE(decode_state({}, state));
  std::string third_pass = bytes;
  third_pass[8] = 2;
  EXPECT_FALSE(decode_state(third_pass, state));

  const SceneBuilder b = uneven_scene();
  Checkpoints checkpoints;
  checkpoints.resume = bytes;
  EXPECT_EQ(
      render(b.scene, b.assets, options_of(Profile::fine), {.checkpoints = checkpoints}).status,
      RenderStatus::not_resumed);
}

TEST(Resume, AStateContainsTheFinishedWork) {
  PictureState state = empty_state(20, 2, true);
  for (int x = 0; x < 20; ++x) {
    state.image.pixel(x, 0)[0] = float(x + 1);
    state.marked[std::size_t(x)] = std::uint8_t(x % 2);
  }
  state.pieces.finish(state.pieces.at(16, 0));
  PictureState first = empty_state(20, 2, true);
  ASSERT_TRUE(decode_state(encode_state(state), first));
  EXPECT_EQ(first.image.pixel(15, 0)[0], 0);
  EXPECT_EQ(first.image.pixel(16, 0)[0], 17);
  EXPECT_TRUE(first.pieces.done(first.pieces.at(19, 0)));
  EXPECT_FALSE(first.pieces.done(first.pieces.at(0, 0)));

  state.pass = 1;
  state.pieces.restart();
  PictureState second = empty_state(20, 2, true);
  ASSERT_TRUE(decode_state(encode_state(state), second));
  EXPECT_EQ(second.pass, 1u);
  EXPECT_EQ(second.image.pixel(2, 0)[0], 3) << "settled in the first pass";
  EXPECT_EQ(second.image.pixel(3, 0)[0], 0) << "to be done again";
  EXPECT_EQ(second.marked, state.marked);
}

}  // namespace
}  // namespace scenefile::trace_test
