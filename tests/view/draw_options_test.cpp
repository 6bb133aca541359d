// OpenGL options derived from the options of a picture.

#include "scenefile/view/draw_options.h"

#include "scenefile/trace/visit_options.h"

#include <gtest/gtest.h>

namespace scenefile {

namespace {

bool same_drawing(const RenderOptions& a, const RenderOptions& b) {
  return draw_options(a) == draw_options(b) &&
         upload_options(a).flat_meshes == upload_options(b).flat_meshes;
}

TEST(DrawOptions, ContainTheFeaturesOfOpenGl) {
  // Together the profiles cover all options: only the course has super-sampling.
  const RenderOptions course = default_options(Profile::course);
  for (std::size_t n = 0;; ++n) {
    RenderOptions changed = course;
    OptionField field;
    std::size_t next = 0;
    visit_options(changed.features, [&](const OptionField& f, bool& on) {
      if (next++ == n) {
        on = !on;
        field = f;
      }
    });
    if (field.name.empty()) {
      EXPECT_EQ(n, 7U);
      break;
    }
    EXPECT_NE(same_drawing(course, changed), supports_option(Engine::gl, field.support))
        << field.name;
  }
}

TEST(DrawOptions, ContainTheProfile) {
  const RenderOptions course = default_options(Profile::course);
  const RenderOptions fine = default_options(Profile::fine);
  EXPECT_TRUE(draw_options(course).course);
  EXPECT_FALSE(draw_options(fine).course);
  EXPECT_TRUE(upload_options(course).flat_meshes);
  EXPECT_FALSE(upload_options(fine).flat_meshes);
  EXPECT_EQ(draw_options(course).samples, 1);
  EXPECT_EQ(draw_options(fine).samples, 0) << "by the size of the objects";
}

TEST(DrawOptions, IntersectUsesOnlyDirectionalLights) {
  RenderOptions options = default_options(Profile::course);
  options.mode = Mode::intersect;
  const DrawOptions draw = draw_options(options);
  EXPECT_TRUE(draw.directional_only);
  EXPECT_FALSE(draw.shadows || draw.textures || draw.transparency);
  options.profile = Profile::fine;
  EXPECT_FALSE(draw_options(options).directional_only);
}

}  // namespace

}  // namespace scenefile
