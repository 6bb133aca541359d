#include "scenefile/viewer/outline.h"

#include "io/temp_folder.h"
#include "scenefile/viewer/hidden.h"
#include "viewer/test_scene.h"

#include <gtest/gtest.h>

namespace scenefile::viewer {

namespace {

struct OutlineTest : ::testing::Test {
  testing_support::TempFolder folder;
  OpenedScene opened = testing::open_file(folder.write("a.xml", testing::scene_text));
  Outline outline = make_outline(opened.written, opened.ready);

  std::uint32_t row(const std::string& label, int which = 0) const {
    for (std::uint32_t i = 0; i < outline.rows.size(); ++i) {
      if (outline.rows[i].label == label && which-- == 0) {
        return i;
      }
    }
    ADD_FAILURE() << label;
    return 0;
  }
};

TEST_F(OutlineTest, ShowsTheSceneInTheOrderOfTheFile) {
  std::string text;
  for (const OutlineRow& r : outline.rows) {
    text += std::string(2 * r.depth, ' ') + r.label +
            (r.detail.empty() ? "" : " (" + r.detail + ")") + "\n";
  }
  EXPECT_EQ(text,
            "camera\n"
            "root\n"
            "  directional light\n"
            "  point light\n"
            "  group (sphere)\n"
            "    sphere\n"
            "  group (cube)\n"
            "    cube\n"
            "  spike (copy)\n"
            "  spike (copy)\n"
            "templates\n"
            "  spike\n"
            "    group (cone)\n"
            "      cone\n");
}

TEST_F(OutlineTest, RowsKnowTheirPlaceAndTheirSource) {
  const OutlineRow& sphere = outline.rows[row("sphere")];
  EXPECT_EQ(sphere.location.line, 19U);
  ASSERT_NE(sphere.source, no_index);
  EXPECT_EQ(outline.row_of_source[sphere.source], row("sphere"));
  EXPECT_NE(outline.rows[row("spike")].source, no_index);
  EXPECT_NE(outline.rows[row("point light")].source, no_index);
  EXPECT_EQ(rows_around(outline, row("sphere")),
            (std::vector<std::uint32_t>{row("root"), row("group")}));
  EXPECT_EQ(outline.rows[row("root")].end, row("templates"));
  EXPECT_EQ(outline.rows[row("templates")].end, outline.rows.size());
}

TEST_F(OutlineTest, OnlyOpenRowsShowWhatTheyHold) {
  EXPECT_EQ(visible_rows(outline, {}),
            (std::vector<std::uint32_t>{row("camera"), row("root"), row("templates")}));
  EXPECT_EQ(visible_rows(outline, {row("root")}).size(), 9U);
}

TEST_F(OutlineTest, HidingTakesAwayWhatARowHolds) {
  const RenderScene& scene = opened.ready.scene;
  EXPECT_EQ(count_virtual_primitives(scene), 4);
  EXPECT_EQ(count_virtual_primitives(without_hidden(scene, sources_in(outline, row("sphere")))), 3);
  EXPECT_EQ(count_virtual_primitives(without_hidden(scene, sources_in(outline, row("spike")))), 3);
  EXPECT_EQ(count_virtual_primitives(without_hidden(scene, sources_in(outline, row("cone")))), 2);
  const RenderScene dark = without_hidden(scene, sources_in(outline, row("point light")));
  ASSERT_EQ(dark.lights.size(), 1U);
  EXPECT_EQ(dark.lights[0].type, LightType::directional);
  const RenderScene green = without_hidden(scene, {}, 1);
  ASSERT_EQ(green.lights.size(), 1U);
  EXPECT_EQ(green.lights[0].type, LightType::point);
}

TEST_F(OutlineTest, BoundsOfWhatIsSelected) {
  const Bounds sphere = bounds_of(opened.ready.scene, {}, sources_in(outline, row("sphere")));
  EXPECT_NEAR(sphere.min.x, -1.5, 1e-6);
  EXPECT_NEAR(sphere.max.y, 0.5, 1e-6);
  const Bounds cones = bounds_of(opened.ready.scene, {}, sources_in(outline, row("cone")));
  EXPECT_NEAR(cones.min.x, -1.5, 1e-6);
  EXPECT_NEAR(cones.max.x, 1.5, 1e-6);
  const Bounds copy = bounds_of(opened.ready.scene, {}, sources_in(outline, row("spike", 1)));
  EXPECT_NEAR(copy.min.x, 0.5, 1e-6);
  EXPECT_TRUE(bounds_of(opened.ready.scene, {}, {}).empty());
}

}  // namespace

}  // namespace scenefile::viewer
