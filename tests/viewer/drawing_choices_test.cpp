// Profile and features, changed while the window is open.

#include "scenefile/viewer/drawing_choices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::viewer {

namespace {

using ::testing::HasSubstr;

struct DrawingChoices : ::testing::Test {
  DrawingChoices() {
    session.setup.trace = default_options(Profile::fine);
    session.setup.trace.threads = 3;
    session.pixels = {40, 30};
  }
  Session session;
};

TEST_F(DrawingChoices, AProfileBringsItsFeaturesAndDepth) {
  EXPECT_EQ(drawn_as(session), DrawnAs::fine);
  toggle_feature(session, "reflect");
  const std::uint64_t version = session.version;
  draw_as(session, DrawnAs::course);
  EXPECT_EQ(drawn_as(session), DrawnAs::course);
  const RenderOptions course = default_options(Profile::course);
  EXPECT_EQ(trace_options(session).profile, Profile::course);
  EXPECT_EQ(trace_options(session).max_depth, course.max_depth);
  EXPECT_EQ(trace_options(session).features, course.features);
  EXPECT_EQ(trace_options(session).threads, 3);
  EXPECT_NE(session.version, version) << "meshes are uploaded in another way";
  EXPECT_THAT(mode_text(session), HasSubstr("profile course"));
  draw_as(session, DrawnAs::realtime);
  EXPECT_TRUE(session.realtime);
  EXPECT_EQ(drawn_as(session), DrawnAs::realtime);
  draw_as(session, DrawnAs::fine);
  EXPECT_FALSE(session.realtime);
}

TEST_F(DrawingChoices, FeaturesOneByOne) {
  EXPECT_TRUE(has_feature(session, "refract"));
  toggle_feature(session, "refract");
  EXPECT_FALSE(has_feature(session, "refract"));
  EXPECT_FALSE(trace_options(session).features.refract);
  EXPECT_TRUE(trace_options(session).features.reflect);
  toggle_feature(session, "no such feature");
  toggle_feature(session, "refract");
  EXPECT_EQ(trace_options(session).features, default_options(Profile::fine).features);
}

TEST_F(DrawingChoices, ShadowsAndTexturesFollowTheirKeysToo) {
  perform(session, Action::toggle_shadows);
  EXPECT_FALSE(has_feature(session, "shadows"));
  toggle_feature(session, "shadows");
  EXPECT_TRUE(has_feature(session, "shadows"));
  EXPECT_TRUE(trace_options(session).features.shadows);
  toggle_feature(session, "shadows");
  EXPECT_FALSE(trace_options(session).features.shadows);
}

TEST_F(DrawingChoices, TheProjectsOfTheCourse) {
  draw_as(session, DrawnAs::course);
  use_feature_set(session, "intersect");
  EXPECT_EQ(trace_options(session).mode, Mode::intersect);
  EXPECT_FALSE(trace_options(session).features.shadows);
  EXPECT_TRUE(is_feature_set(session, "intersect"));
  EXPECT_FALSE(is_feature_set(session, "none"));
  EXPECT_THAT(mode_text(session), HasSubstr("intersect"));
  use_feature_set(session, "illuminate");
  EXPECT_EQ(trace_options(session).mode, Mode::ray);
  EXPECT_TRUE(trace_options(session).features.shadows);
  EXPECT_TRUE(trace_options(session).features.texture);
  EXPECT_FALSE(trace_options(session).features.refract);
  EXPECT_TRUE(is_feature_set(session, "illuminate"));
  for (const std::string_view set : feature_sets) {
    use_feature_set(session, set);
    EXPECT_TRUE(is_feature_set(session, set)) << set;
  }
}

TEST_F(DrawingChoices, ChangesDiscardTheTracedPictureAndTheCause) {
  session.traced = TracedPicture{};
  session.cause.answer.text = "old";
  toggle_feature(session, "reflect");
  EXPECT_FALSE(session.traced.has_value());
  EXPECT_EQ(session.cause.answer.text, "");
}

}  // namespace

}  // namespace scenefile::viewer
