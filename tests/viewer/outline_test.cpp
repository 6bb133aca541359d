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
            "global data\n"
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

TEST_F(OutlineTest, RowsHaveAPlaceAndASource) {
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

TEST_F(OutlineTest, OnlyOpenRowsShowTheirContents) {
  EXPECT_EQ(visible_rows(outline, {}),
            (std::vector<std::uint32_t>{row("global data"), row("camera"), row("root"),
                                        row("templates")}));
  EXPECT_EQ(visible_rows(outline, {row("root")}).size(), 10U);
}

TEST_F(OutlineTest, HidingARowHidesItsContents) {
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

TEST(OutlineOfGroups, ShowsTheirContents) {
  const testing_support::TempFolder folder;
  const auto group = [](const std::string& objects) { return R"({"groups":[)" + objects + "]},"; };
  const std::string cone = R"({"primitives":[{"type":"cone"}]})";
  const std::string lamp = R"({"lights":[{"type":"point","color":[1,1,1]}]})";
  const std::string text =
      R"({"globalData":{"ambientCoeff":1,"diffuseCoeff":1,"specularCoeff":1},)"
      R"("cameraData":{"position":[0,0,6],"up":[0,1,0],"heightAngle":30,"look":[0,0,-1]},"groups":[)" +
      group(cone + "," + lamp + "," + cone) +
      group(cone + R"(,{"name":"a","groups":[]},{"name":"b"},{"name":"c"},{"name":"a"})") +
      R"({"name":"named","groups":[]}]})";
  const OpenedScene opened = testing::open_file(folder.write("a.json", text));
  ASSERT_FALSE(opened.diagnostics.has_errors());
  const Outline outline = make_outline(opened.written, opened.ready);
  std::vector<std::string> details;
  for (const OutlineRow& row : outline.rows) {
    if (row.depth == 1) {
      details.push_back(row.detail);
    }
  }
  EXPECT_EQ(details,
            (std::vector<std::string>{"cone \u00d72, point light", "cone, a \u00d72, b, ...", ""}));
}

TEST_F(OutlineTest, RowsAreFoundInAnotherVersion) {
  std::string text = testing::scene_text;
  const std::string sphere = R"(<object type="primitive" name="sphere">)";
  text.replace(text.find(sphere), sphere.size(), R"(<object type="primitive" name="cone">)");
  const OpenedScene next = testing::open_file(folder.write("b.xml", text));
  const Outline after = make_outline(next.written, next.ready);
  const std::vector<std::uint32_t> now = match_rows(outline, after);
  EXPECT_EQ(now[row("group")], row("group")) << "what it holds has changed";
  EXPECT_EQ(now[row("sphere")], no_index) << "gone";
  EXPECT_EQ(now[row("cube")], row("cube"));
  EXPECT_EQ(now[row("cone")], after.rows.size() - 1);
  EXPECT_EQ(now[row("spike", 1)], row("spike", 1));
  EXPECT_EQ(match_rows(outline, outline)[row("cone")], row("cone"));
  EXPECT_EQ(match_rows(outline, {})[row("root")], no_index);
}

TEST_F(OutlineTest, BoundsOfTheSelection) {
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
