// Drawing scenes on another thread.

#include "scenefile/viewer/scene_painter.h"

#include "io/temp_folder.h"
#include "scenefile/view/headless.h"
#include "viewer/test_scene.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

namespace scenefile::viewer {

namespace {

using testing_support::TempFolder;

PaintContext headless() {
  const auto context = std::make_shared<std::unique_ptr<HeadlessContext>>();
  return {[context]() -> Result<GetProcAddress> {
            Result<std::unique_ptr<HeadlessContext>> made = HeadlessContext::create();
            if (!made) {
              return made.error();
            }
            *context = *std::move(made);
            return (*context)->get_proc_address();
          },
          [context] { context->reset(); }};
}

// A grid of spheres in front of the camera of the test scene.
std::string many_spheres() {
  std::string objects;
  for (int x = 0; x < 60; ++x) {
    for (int y = 0; y < 50; ++y) {
      objects += "<transblock><translate x=\"" + std::to_string(0.08 * (x - 30)) + "\" y=\"" +
                 std::to_string(0.08 * (y - 25)) +
                 "\" z=\"0\"/><scale x=\"0.07\" y=\"0.07\" z=\"0.07\"/><object type=\"primitive\" "
                 "name=\"sphere\"><diffuse r=\"1\" g=\"0\" "
                 "b=\"0\"/></object></transblock>";
    }
  }
  std::string text = testing::scene_text;
  const std::string root = "<object type=\"tree\" name=\"root\">";
  return text.insert(text.find(root) + root.size(), objects);
}

struct ScenePainterTest : ::testing::Test {
  void SetUp() override {
    Result<std::unique_ptr<ScenePainter>> made =
        ScenePainter::create(headless(), [this] { ++woken; });
    if (!made) {
      GTEST_SKIP() << made.error().text;
    }
    painter = *std::move(made);
  }
  PaintJob job(const std::string& text, int width, int height, bool refines = false) {
    auto scene = std::make_shared<OpenedScene>(testing::open_file(folder.write("a.xml", text)));
    EXPECT_TRUE(scene->usable());
    PaintJob job;
    job.recipe.version = text.size();
    job.recipe.camera = scene->ready.scene.camera;
    job.recipe.width = width;
    job.recipe.height = height;
    job.scene = std::move(scene);
    job.refines = refines;
    return job;
  }

  TempFolder folder;
  std::atomic<int> woken = 0;
  std::unique_ptr<ScenePainter> painter;
};

TEST_F(ScenePainterTest, DrawsWhatIsAskedFor) {
  EXPECT_NE(painter->renderer(), "");
  EXPECT_FALSE(painter->take(Painting::shown, true).has_value());
  painter->ask(job(testing::scene_text, 80, 60));
  const std::optional<Painted> painted = painter->take(Painting::shown, true);
  ASSERT_TRUE(painted.has_value());
  EXPECT_FALSE(painter->busy());
  ASSERT_EQ(painted->picture.width, 80);
  EXPECT_GT(painted->picture.texel(28, 30)[0], 100) << "the sphere on the left is red";
  EXPECT_EQ(painted->picture.texel(28, 30)[1], 0);
  EXPECT_EQ(painted->stats.objects, 4U);
  EXPECT_FALSE(painter->take().has_value()) << "each picture is taken once";
}

TEST_F(ScenePainterTest, ARefinementIsInterruptedAndLeavesNothingHalfDone) {
  const std::string text = many_spheres();
  painter->ask(job(text, 40, 30));
  ASSERT_TRUE(painter->take(Painting::shown, true).has_value());
  PaintJob best = job(text, 320, 240, true);
  best.recipe.options.samples = 4;
  painter->ask(best);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // it is probably being drawn
  const PaintJob small = job(text, 40, 30);
  painter->ask(small);
  const std::optional<Painted> painted = painter->take(Painting::shown, true);
  ASSERT_TRUE(painted.has_value());
  EXPECT_EQ(painted->recipe, small.recipe) << "the small picture is the last one";
  const auto fresh = ScenePainter::create(headless(), [] {});
  ASSERT_EQ(error_text(fresh), "");
  (*fresh)->ask(small);
  EXPECT_EQ(painted->picture.rgb, (*fresh)->take(Painting::shown, true)->picture.rgb)
      << "with its shadows";
}

TEST_F(ScenePainterTest, OtherPicturesComeAfterThoseOfTheWindow) {
  painter->ask(job(testing::scene_text, 80, 60));
  painter->ask(job(testing::scene_text, 16, 12, true), Painting::compared);
  painter->ask(job(testing::scene_text, 81, 61));
  std::optional<Painted> other;
  for (int i = 0; i < testing::patience && !other; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    other = painter->take(Painting::compared);
  }
  ASSERT_TRUE(other.has_value());
  EXPECT_EQ(other->picture.width, 16);
  EXPECT_EQ(painter->take(Painting::shown, true)->picture.width, 81);
}

TEST_F(ScenePainterTest, EndsInTheMiddleOfAPicture) {
  PaintJob best = job(many_spheres(), 320, 240, true);
  best.recipe.options.samples = 4;
  painter->ask(best);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  painter.reset();
}

TEST(ScenePainterWithoutContext, SaysWhy) {
  const auto painter = ScenePainter::create(
      {[]() -> Result<GetProcAddress> { return Error{"no context"}; }, [] {}}, [] {});
  EXPECT_EQ(error_text(painter), "no context");
}

}  // namespace

}  // namespace scenefile::viewer
