// The session without a window: input and its effects.

#include "scenefile/viewer/session.h"

#include "viewer/session_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

namespace scenefile::viewer {

namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::TempFolder;
using SessionTest = testing::SessionFixture;

TEST_F(SessionTest, OpensAtTheCameraOfTheScene) {
  ASSERT_NE(session.shown, nullptr);
  EXPECT_EQ(session.camera.position, glm::dvec3(0, 0, 6));
  EXPECT_EQ(session.camera, session.home);
  EXPECT_EQ(scene_name(session), "a.xml");
}

TEST_F(SessionTest, AClickSelectsTheObject) {
  click(140, 150);
  EXPECT_EQ(selected(), "sphere");
  EXPECT_THAT(session.selected_path, HasSubstr("root"));
  click(260, 150);
  EXPECT_EQ(selected(), "cube");
  click(140, 245);
  EXPECT_EQ(selected(), "cone");
  EXPECT_THAT(session.selected_path, HasSubstr(" > "));
  EXPECT_NEAR(selected_bounds(session).max.x, -0.5, 1e-6) << "only of this copy";
  select(session, session.selected);
  EXPECT_NEAR(selected_bounds(session).max.x, 1.5, 1e-6) << "of all";
  EXPECT_THAT(session.selected_path, Not(HasSubstr(" > "))) << "in the template";
  EXPECT_TRUE(session.open_rows.contains(session.shown->outline.rows[*session.selected].parent));
  click(200, 20);
  EXPECT_EQ(selected(), "");
}

TEST_F(SessionTest, HiddenObjectsAreNotPicked) {
  click(140, 150);
  perform(session, Action::hide_selected);
  EXPECT_FALSE(session.hidden.empty());
  EXPECT_FALSE(draw_options(session).objects[*session.hidden.begin()]);
  click(140, 150);
  EXPECT_EQ(selected(), "");
  perform(session, Action::show_all);
  click(140, 150);
  EXPECT_EQ(selected(), "sphere");
}

TEST_F(SessionTest, MouseGesturesMoveTheCamera) {
  drag(50, 0);
  EXPECT_LT(session.camera.position.x, -1);
  EXPECT_NEAR(glm::length(session.camera.position - session.home.pivot), 6, 1);
  perform(session, Action::scene_camera);
  EXPECT_EQ(session.camera, session.home);
  drag(0, 40, {"", false, true});
  EXPECT_GT(session.camera.position.y, 0.1);
  perform(session, Action::scene_camera);
  drag(40, 0, {"", true, false});
  EXPECT_EQ(session.camera.position, session.home.position);
  perform(session, Action::scene_camera);
  drag(0, -40, {}, 1);
  EXPECT_LT(session.camera.position.z, 6);
  perform(session, Action::scene_camera);
  wheel_turned(session, 3);
  EXPECT_LT(session.camera.position.z, 6);
}

TEST_F(SessionTest, SmallMovementsStillClick) {
  pointer_moved(session, {140, 150});
  pointer_pressed(session, 0, {});
  pointer_moved(session, {142, 151});
  pointer_released(session);
  EXPECT_EQ(selected(), "sphere");
  EXPECT_EQ(session.camera, session.home);
}

TEST_F(SessionTest, KeysFlyWhileHeld) {
  EXPECT_TRUE(key_pressed(session, parse_key("W")));
  pass(0.5);
  const double z = session.camera.position.z;
  EXPECT_LT(z, 6);
  key_released(session, "W");
  pass(0.5);
  EXPECT_EQ(session.camera.position.z, z);
  EXPECT_TRUE(key_pressed(session, parse_key("Home")));
  EXPECT_EQ(session.camera, session.home);
  EXPECT_FALSE(key_pressed(session, parse_key("Ctrl+J")));
}

TEST_F(SessionTest, AChangedFileKeepsTheCameraAndTheSelection) {
  drag(50, 0);
  click(200, 150);
  const ViewCamera before = session.camera;
  select(session, session.shown->outline.row_of_source[0]);
  const std::uint64_t version = session.version;
  rewrite("r=\"1\" g=\"0\" b=\"0\"", "r=\"0\" g=\"0\" b=\"0.5\"");
  EXPECT_EQ(session.version, version + 1);
  EXPECT_EQ(session.camera, before);
  EXPECT_TRUE(session.selected.has_value());
  EXPECT_THAT(session.selected_path, HasSubstr("root"));
}

TEST_F(SessionTest, StateStaysWithItsObjectWhenOthersAreAdded) {
  click(260, 150);
  ASSERT_EQ(selected(), "cube");
  perform(session, Action::hide_selected);
  rewrite("<translate x=\"-1\" y=\"0\" z=\"0\"/>",
          "<object type=\"primitive\" name=\"cylinder\"><diffuse r=\"1\" g=\"1\" b=\"1\"/></object>"
          "</transblock><transblock><translate x=\"-1\" y=\"0\" z=\"0\"/>");
  EXPECT_EQ(selected(), "cube");
  EXPECT_TRUE(is_hidden(session, *session.selected));
  EXPECT_EQ(session.hidden.size(), 1U);
  EXPECT_THAT(session.selected_path, HasSubstr("#3")) << session.selected_path;
}

TEST_F(SessionTest, RemovedObjectsAreDeselected) {
  click(140, 245);
  ASSERT_EQ(selected(), "cone");
  ASSERT_FALSE(session.selected_copy.empty());
  rewrite(
      "<transblock><translate x=\"-1\" y=\"-1.5\" z=\"0\"/><object type=\"master\" "
      "name=\"spike\"/></transblock>",
      "");
  EXPECT_EQ(selected(), "cone") << "the other copy is left";
  rewrite(
      "<transblock><translate x=\"1\" y=\"-1.5\" z=\"0\"/><object type=\"master\" "
      "name=\"spike\"/></transblock>",
      "");
  EXPECT_FALSE(session.selected.has_value() && session.selected_copy.size() > 0);
}

TEST_F(SessionTest, TheSingleShownLightStays) {
  perform(session, Action::next_light);
  perform(session, Action::next_light);
  ASSERT_EQ(draw_options(session).lights, (std::vector<bool>{false, true}));
  rewrite("<lightdata><id v=\"0\"",
          "<lightdata><id v=\"2\"/><color r=\"1\" g=\"0\" b=\"0\"/><type v=\"directional\"/>"
          "<direction x=\"0\" y=\"-1\" z=\"0\"/></lightdata><lightdata><id v=\"0\"");
  EXPECT_EQ(draw_options(session).lights, (std::vector<bool>{false, false, true}));
}

TEST_F(SessionTest, ACameraThatWasNotMovedFollowsTheFile) {
  rewrite("z=\"6\"", "z=\"9\"");
  EXPECT_EQ(session.camera.position.z, 9);
}

TEST_F(SessionTest, ABrokenFileKeepsTheLastGoodPicture) {
  const auto before = session.shown;
  rewrite("<diffuse r=\"1\"", "<difuse r=\"1\"");
  EXPECT_EQ(session.shown, before);
  ASSERT_NE(session.broken, nullptr);
  EXPECT_TRUE(session.broken->opened.diagnostics.has_errors());
  rewrite("<difuse", "<diffuse");
  EXPECT_EQ(session.broken, nullptr);
  EXPECT_NE(session.shown, before);
}

TEST_F(SessionTest, AFileThatIsRemovedAndRestored) {
  std::filesystem::rename(path, path + "~");
  settle();
  ASSERT_NE(session.broken, nullptr);
  EXPECT_NE(session.broken->opened.unreadable, "");
  std::filesystem::rename(path + "~", path);
  settle();
  EXPECT_EQ(session.broken, nullptr);
}

TEST_F(SessionTest, RealtimeIsDrawnWithThePanelsSettings) {
  EXPECT_FALSE(draw_options(session).realtime.has_value());
  session.settings.ray_tracing = true;
  perform(session, Action::realtime);
  session.realtime_panel.tessellation = {3, 9};
  session.realtime_panel.filter = Filter::blur;
  ASSERT_TRUE(draw_options(session).realtime.has_value());
  EXPECT_EQ(*draw_options(session).realtime, session.realtime_panel);
  EXPECT_FALSE(shows_traced(session));
  perform(session, Action::wireframe);
  EXPECT_EQ(draw_options(session).mode, DrawMode::wireframe);
  EXPECT_THAT(mode_text(session), HasSubstr("Realtime"));
}

TEST_F(SessionTest, ClicksHitTheRealtimePicture) {
  click(140, 150);
  ASSERT_TRUE(session.selected.has_value());
  const std::uint32_t sphere = *session.selected;
  perform(session, Action::realtime);
  session.realtime_panel.milestone = Milestone::action;
  session.pixels = {1024, 768};
  const CameraView view = camera_view(session);
  EXPECT_NEAR(view.box.size.x, 400.0 * 1024 / 1092, 1e-6);
  EXPECT_NEAR(view.box.at.y + view.box.size.y, 300, 1e-6);
  select(session, std::nullopt);
  click(view.box.at.x + 140 / 400.0 * view.box.size.x, view.box.at.y + view.box.size.y / 2);
  EXPECT_EQ(session.selected, sphere);
  click(399, 1);
  EXPECT_FALSE(session.selected.has_value()) << "beyond the camera's view";
  session.realtime_panel.milestone = Milestone::lights_camera;
  const CameraView whole = camera_view(session);
  const glm::dvec2 at = whole.box.at + whole.box.size * glm::dvec2(0.35, 0.5);
  click(at.x, at.y);
  EXPECT_EQ(session.selected, sphere);
  session.realtime_panel.near = 6;
  click(at.x, at.y);
  EXPECT_FALSE(session.selected.has_value()) << "its front is clipped, its back culled";
  session.realtime_panel.near = 0.1;
  session.realtime_panel.far = 5.4;
  click(at.x, at.y);
  EXPECT_FALSE(session.selected.has_value());
}

TEST_F(SessionTest, KeysOfTheAssignment) {
  session.settings.assignment_keys = true;
  EXPECT_FALSE(uses_assignment_keys(session)) << "Ctrl+S saves in all other pictures";
  session.realtime = true;
  const ViewCamera before = session.camera;
  key_pressed(session, {"Space"});
  pass(1);
  key_released(session, "Space");
  EXPECT_NEAR(session.camera.position.y - before.position.y, 5, 0.3);
  key_pressed(session, {"Control", true});
  pass(1);
  key_released(session, "Control");
  EXPECT_NEAR(session.camera.position.y, before.position.y, 0.6);
  const glm::dvec3 ahead = axes_of(session.camera).ahead;
  const glm::dvec3 start = session.camera.position;
  key_pressed(session, {"W"});
  pass(1);
  key_released(session, "W");
  EXPECT_NEAR(glm::dot(session.camera.position - start, ahead), 5, 0.3);
  const glm::dvec3 stays = session.camera.position;
  drag(50, 0);
  EXPECT_LT(glm::length(session.camera.position - stays), 1e-9) << "looks around";
  EXPECT_LT(glm::dot(axes_of(session.camera).ahead, ahead), 0.9999);
}

TEST_F(SessionTest, OneLightAtATime) {
  perform(session, Action::next_light);
  EXPECT_EQ(draw_options(session).lights, (std::vector<bool>{true, false}));
  perform(session, Action::next_light);
  EXPECT_EQ(draw_options(session).lights, (std::vector<bool>{false, true}));
  perform(session, Action::next_light);
  EXPECT_EQ(draw_options(session).lights, (std::vector<bool>{true, true}));
}

TEST_F(SessionTest, ModesOfTheTable) {
  for (const auto& [key, mode] :
       {std::pair("2", DrawMode::wireframe), std::pair("3", DrawMode::normals),
        std::pair("4", DrawMode::uv), std::pair("5", DrawMode::depth),
        std::pair("6", DrawMode::object_id), std::pair("7", DrawMode::bounding_boxes),
        std::pair("1", DrawMode::shaded)}) {
    key_pressed(session, parse_key(key));
    EXPECT_EQ(draw_options(session).mode, mode) << key;
  }
}

TEST_F(SessionTest, DrawsLikeRenderWithOpenGl) {
  RenderOptions& asked = session.setup.trace;
  asked = default_options(Profile::course);
  EXPECT_TRUE(draw_options(session).course);
  EXPECT_EQ(draw_options(session).samples, 1);
  asked.features.refract = asked.features.texture_filter = false;
  EXPECT_FALSE(draw_options(session).transparency);
  EXPECT_FALSE(draw_options(session).texture_filter);
  asked.mode = Mode::normals;
  EXPECT_EQ(draw_options(session).mode, DrawMode::normals);
  asked.mode = Mode::intersect;
  EXPECT_FALSE(draw_options(session).shadows);
  EXPECT_FALSE(draw_options(session).textures);
  EXPECT_TRUE(draw_options(session).directional_only);
}

TEST_F(SessionTest, TracesRaysWhenTheCameraRests) {
  perform(session, Action::trace);
  EXPECT_FALSE(shows_traced(session));
  settle();
  ASSERT_TRUE(shows_traced(session));
  EXPECT_TRUE(session.traced->complete);
  EXPECT_EQ(session.traced->picture.width, 40);
  wheel_turned(session, 1);
  EXPECT_FALSE(shows_traced(session));
  settle();
  EXPECT_TRUE(shows_traced(session));
  key_pressed(session, parse_key("3"));
  EXPECT_FALSE(shows_traced(session));
}

TEST_F(SessionTest, ComparesTheTracedPicture) {
  const std::string reference = write_picture("right.png", 32, 24);
  drop(session, {reference});
  settle_files();
  EXPECT_EQ(session.compare, CompareView::split);
  place_pictures(session, {{0, 0}, {400, 400}});
  EXPECT_EQ(session.picture.size, glm::dvec2(400, 300));
  settle();
  ASSERT_TRUE(session.comparison.has_value());
  EXPECT_TRUE(session.comparison->measures.comparable);
  EXPECT_LT(session.comparison->measures.difference.psnr_db, 40);
  EXPECT_THAT(measures_text(session.comparison->measures), HasSubstr("dB"));
  EXPECT_EQ(session.comparison->flip.width, 32);
  // Someone replaces the reference.
  write_picture("right.png", 30, 20);
  settle();
  EXPECT_EQ(session.mine.decoded->texture.width, 30);
  EXPECT_EQ(session.comparison->difference.width, 30);
}

TEST_F(SessionTest, FloatsAreComparedAsFloats) {
  const auto write_floats = [&](const std::string& name, float value) {
    Image image(40, 30);
    std::fill(image.rgb.begin(), image.rgb.end(), value);
    return folder.write(name, *encode_image(image, ImageFormat::pfm, Rounding::nearest));
  };
  open_picture(session, write_floats("a.pfm", 2), Role::reference);
  open_picture(session, write_floats("b.pfm", 4), Role::mine);
  settle();
  EXPECT_EQ(sides_of(session), (Sides{Role::reference, Role::mine}));
  EXPECT_EQ(session.comparison->measures.difference.max, 510);
}

TEST_F(SessionTest, ComparesTheOpenGlPicture) {
  open_picture(session, write_picture("right.png", 16, 16));
  perform(session, Action::realtime);
  settle_files();
  pass(1);
  ASSERT_TRUE(wants_picture(session));
  compare_ours(session, quantize(Image(16, 16), Rounding::nearest));
  EXPECT_FALSE(wants_picture(session));
  settle();
  EXPECT_EQ(session.comparison->measures.difference.psnr_db, 99);
}

// Says that pictures 32 pixels wide are drawn as the course does, and equal ours.
void fit_by_width(Session& session, int& fits) {
  session.setup.fit_picture = [&fits](const FitQuestion& question) {
    ++fits;
    PictureFit fit;
    fit.options = default_options(Profile::course);
    fit.words = question.is_reference ? "its way" : "some way";
    fit.equal = question.picture->texture.width == 32;
    return fit;
  };
}

TEST_F(SessionTest, APictureThatEqualsOursIsTheReference) {
  int fits = 0;
  fit_by_width(session, fits);
  open_picture(session, write_picture("a.png", 32, 24));
  settle();
  EXPECT_TRUE(session.reference.exists());
  EXPECT_FALSE(session.mine.exists());
  EXPECT_EQ(session.setup.trace.profile, Profile::course);
  EXPECT_THAT(session.notice->text, HasSubstr("a.png equals our picture: it is the reference"));
  EXPECT_EQ(sides_of(session), (Sides{Role::ours, Role::reference}));
  EXPECT_EQ(fits, 1);
  // There is a reference now: the next one is mine.
  open_picture(session, write_picture("b.png", 32, 24));
  settle();
  EXPECT_EQ(session.mine.path, folder.path("b.png"));
  EXPECT_EQ(fits, 1) << "the reference says how ours is drawn";
  EXPECT_EQ(sides_of(session), (Sides{Role::reference, Role::mine}));
  EXPECT_EQ(session.comparison->measures.difference.psnr_db, 99);
  perform(session, Action::next_sides);
  EXPECT_EQ(sides_of(session), (Sides{Role::ours, Role::mine}));
  settle();
  EXPECT_LT(session.comparison->measures.difference.psnr_db, 40);
}

TEST_F(SessionTest, APictureThatDiffersFromOursIsMine) {
  int fits = 0;
  fit_by_width(session, fits);
  open_picture(session, write_picture("a.png", 40, 30));
  settle();
  EXPECT_TRUE(session.mine.exists());
  EXPECT_FALSE(session.reference.exists());
  EXPECT_THAT(session.notice->text, HasSubstr("it is mine; ours is drawn with some way"));
  // The user knows better.
  perform(session, Action::exchange_roles);
  settle();
  EXPECT_TRUE(session.reference.exists());
  EXPECT_FALSE(session.mine.exists());
  EXPECT_EQ(fits, 2);
  EXPECT_THAT(session.notice->text, HasSubstr("the reference, differs from our picture"));
}

TEST_F(SessionTest, MineOfAnotherSizeIsComparedWithOurs) {
  open_picture(session, write_picture("a.png", 32, 24), Role::reference);
  open_picture(session, write_picture("b.png", 40, 30), Role::mine);
  settle();
  EXPECT_EQ(sides_of(session), (Sides{Role::ours, Role::mine}));
  EXPECT_EQ(picture_size(session), glm::ivec2(40, 30));
  EXPECT_EQ(trace_options(session).width, 40);
  EXPECT_TRUE(session.comparison->measures.comparable);
}

TEST_F(SessionTest, PicturesAreShownInSeveralWays) {
  open_picture(session, write_picture("a.png", 40, 30));
  settle();
  EXPECT_EQ(role_in_front(session), Role::ours);
  perform(session, Action::other);
  EXPECT_EQ(role_in_front(session), Role::mine);
  perform(session, Action::flicker);
  std::set<Role> seen;
  for (int i = 0; i < 10; ++i) {
    pass(0.2);
    seen.insert(role_in_front(session));
  }
  EXPECT_EQ(seen, (std::set<Role>{Role::ours, Role::mine}));
  perform(session, Action::side_by_side);
  place_pictures(session, {{0, 0}, {804, 300}});
  EXPECT_EQ(session.picture.at, glm::dvec2(0, 0));
  EXPECT_EQ(session.beside.at, glm::dvec2(404, 0));
  EXPECT_EQ(session.beside.size, session.picture.size);
  place_pictures(session, {{0, 0}, {400, 604}});
  EXPECT_EQ(session.beside.at, glm::dvec2(0, 304)) << "one above the other is larger";
  click(140, 150);
  const std::string ours = selected();
  EXPECT_NE(ours, "");
  select(session, std::nullopt);
  click(140, 304 + 150);
  EXPECT_EQ(selected(), ours) << "the same place of the other picture";
  perform(session, Action::side_by_side);
  EXPECT_EQ(session.compare, CompareView::off);
}

TEST_F(SessionTest, TheSplitIsDragged) {
  open_picture(session, write_picture("right.png", 40, 30));
  EXPECT_FALSE(session.mine.exists()) << "read on another thread";
  settle_files();
  pointer_moved(session, {200, 100});
  pointer_pressed(session, 0, {});
  pointer_moved(session, {100, 100});
  pointer_released(session);
  EXPECT_NEAR(session.split, 0.25, 1e-9);
  EXPECT_EQ(session.camera, session.home);
}

TEST_F(SessionTest, PicturesAndFoldersAreDropped) {
  folder.write("more/b2.xml", testing::scene_text);
  folder.write("more/b10.xml", testing::scene_text);
  drop(session, {folder.path("more")});
  settle();
  EXPECT_EQ(scene_name(session), "b2.xml");
  perform(session, Action::next_scene);
  settle();
  EXPECT_EQ(scene_name(session), "b10.xml");
  EXPECT_EQ(session.shown->opened.path, folder.path("more") + "/b10.xml");
  perform(session, Action::next_scene);
  settle();
  EXPECT_EQ(scene_name(session), "b2.xml");
  open_picture(session, folder.path("more/b2.xml"));
  settle();
  ASSERT_TRUE(session.notice.has_value());
  EXPECT_TRUE(session.notice->bad);
}

TEST_F(SessionTest, DroppedPicturesAreReadInOrder) {
  const std::string first = write_picture("first.png", 12, 9);
  const std::string second = write_picture("second.png", 20, 15);
  const std::string damaged = folder.write("damaged.png", "\x89PNG\r\n\x1a\n");
  const std::string scene_without_ending = folder.write("scene", testing::scene_text);
  drop(session, {first, scene_without_ending, second, damaged});
  settle_files();
  EXPECT_EQ(session.mine.decoded->texture.width, 20);
  EXPECT_EQ(session.mine.path, second);
  EXPECT_EQ(scene_name(session), "scene");
  ASSERT_TRUE(session.notice.has_value());
  EXPECT_THAT(session.notice->text, HasSubstr("damaged.png"));
  EXPECT_TRUE(session.pictures.empty());
}

TEST_F(SessionTest, AReferenceThatIsBeingWrittenKeepsItsOldPicture) {
  const std::string reference = write_picture("right.png", 16, 12);
  open_picture(session, reference, Role::reference);
  settle_files();
  session.notice.reset();
  folder.write("right.png", "\x89PNG\r\n\x1a\n");
  settle_files();
  EXPECT_EQ(session.reference.decoded->texture.width, 16);
  EXPECT_FALSE(session.notice.has_value());
  write_picture("right.png", 24, 18);
  settle_files();
  EXPECT_EQ(session.reference.decoded->texture.width, 24);
}

TEST_F(SessionTest, CanBeDestroyedAtAnyTime) {
  const std::string reference = write_picture("right.png", 32, 24);
  for (int i = 0; i < 30; ++i) {
    Session other;
    other.setup = session.setup;
    other.settings.ray_tracing = true;
    other.picture = session.picture;
    other.pixels = {200, 150};
    open_scene(other, path);
    open_picture(other, reference, Role::reference);
    for (int step = 0; step < i; ++step) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      tick(other, 0.3 * step);
      if (step % 7 == 6) {
        perform(other, Action::reload);
      }
      if (wants_picture(other)) {
        compare_ours(other, quantize(Image(32, 24), Rounding::nearest));
      }
    }
  }
  tick(session, time);
  EXPECT_TRUE(settled(session));
}

TEST_F(SessionTest, NoticesDisappear) {
  say(session, "hello");
  pass(1);
  EXPECT_TRUE(session.notice.has_value());
  pass(10);
  EXPECT_FALSE(session.notice.has_value());
}

TEST_F(SessionTest, TheNoticeIsAboutTheLastDrop) {
  folder.write("empty/readme.txt");
  drop(session, {folder.path("empty")});
  ASSERT_TRUE(session.notice.has_value());
  EXPECT_THAT(session.notice->text, HasSubstr("no scene in this folder"));
  drop(session, {path});
  EXPECT_FALSE(session.notice.has_value());
}

TEST_F(SessionTest, TheVisibleSceneKeepsItsName) {
  drop(session, {folder.path("none.xml")});
  settle();
  EXPECT_EQ(scene_name(session), "none.xml");
  EXPECT_EQ(shown_name(session), "a.xml");
}

TEST_F(SessionTest, TheSelectionStaysWithItsGroup) {
  click(140, 150);
  rewrite("<object type=\"primitive\" name=\"sphere\">",
          "<object type=\"primitive\" name=\"cone\"/>"
          "</transblock><transblock><translate x=\"-1\" y=\"0.5\" z=\"0\"/>"
          "<object type=\"primitive\" name=\"sphere\">");
  EXPECT_EQ(selected(), "sphere");
  EXPECT_NEAR(session.selected_box.max.y, 1, 1e-6) << "it has moved";
  rewrite("<object type=\"primitive\" name=\"sphere\">",
          "<object type=\"tree\" name=\"ball\"><transblock>"
          "<object type=\"primitive\" name=\"sphere\"/></transblock></object></transblock>"
          "<transblock><object type=\"primitive\" name=\"cube\">");
  EXPECT_EQ(selected(), "") << "it is in another group";
  EXPECT_TRUE(session.selected_box.empty());
}

TEST_F(SessionTest, FramesTheSelection) {
  click(260, 150);
  perform(session, Action::frame);
  EXPECT_NEAR(session.camera.pivot.x, 1, 1e-5);
  EXPECT_LT(session.camera.position.z, 6);
  EXPECT_GT(scene().groups.size(), 0U);
}

}  // namespace

}  // namespace scenefile::viewer
