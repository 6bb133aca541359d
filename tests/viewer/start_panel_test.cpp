// Opening scenes from the panel of recent files and folders.

#include "scenefile/viewer/start_panel.h"

#include "io/temp_folder.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/io/folder.h"
#include "scenefile/viewer/recent_files.h"
#include "scenefile/viewer/session.h"
#include "viewer/session_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::viewer {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing_support::TempFolder;

std::vector<std::string> names_of(const std::vector<Choice>& choices) {
  std::vector<std::string> names;
  for (const Choice& choice : choices) {
    names.push_back(choice.name);
  }
  return names;
}

struct StartPanelTest : ::testing::Test {
  StartPanelTest() {
    session.setup.load = testing::open_request;
    session.setup.wake = [] {};
    session.setup.trace = default_options(Profile::fine);
    session.setup.recent_files = folder.path("state/recent");
    session.start.folder = folder.path("");  // not the working directory
    session.picture = {{0, 0}, {400, 300}};
    session.pixels = {40, 30};
  }

  void settle() { testing::settle(session, time); }

  TempFolder folder;
  std::string scene = folder.write("scenes/b.xml", testing::scene_text);
  Session session;
  double time = 0;
};

TEST_F(StartPanelTest, ListsFoldersScenesAndPictures) {
  folder.write("scenes/a10.xml");
  folder.write("scenes/a9.JSON");
  folder.write("scenes/readme.txt");
  folder.write("scenes/.hidden.xml");
  folder.write("scenes/picture.PNG");
  folder.write("scenes/other.tga");  // as for grade: is_picture_name()
  folder.write("scenes/more/x.xml");
  const std::vector<Choice> choices = list_choices(folder.path("scenes"));
  EXPECT_THAT(names_of(choices),
              ElementsAre("more", "a9.JSON", "a10.xml", "b.xml", "other.tga", "picture.PNG"));
  EXPECT_EQ(choices.front().kind, ChoiceKind::folder);
  EXPECT_EQ(choices.back().kind, ChoiceKind::picture);
  EXPECT_EQ(choices[1].path, folder.path("scenes/a9.JSON"));
  EXPECT_THAT(list_choices(folder.path("none")), IsEmpty());
}

TEST_F(StartPanelTest, GoesThroughFolders) {
  open_start_panel(session);
  choose(session, folder.path("scenes/"));
  EXPECT_EQ(session.start.folder, folder.path("scenes"));
  EXPECT_THAT(names_of(session.start.choices), ElementsAre("b.xml"));
  choose(session, folder_of(session.start.folder));
  EXPECT_THAT(names_of(session.start.choices), ElementsAre("scenes"));
}

TEST_F(StartPanelTest, TypedPaths) {
  StartPanel panel;
  panel.folder = "/scenes";
  panel.typed = "/else/a.xml";
  EXPECT_EQ(typed_path(panel, "/home/me"), "/else/a.xml");
  panel.typed = "a.xml";
  EXPECT_EQ(typed_path(panel, "/home/me"), "/scenes/a.xml");
  panel.typed = "~/a.xml";
  EXPECT_EQ(typed_path(panel, "/home/me"), "/home/me/a.xml");
  EXPECT_EQ(typed_path(panel, nullptr), "/scenes/~/a.xml");
}

TEST_F(StartPanelTest, AChosenSceneIsShownAndRemembered) {
  open_start_panel(session);
  EXPECT_THAT(session.start.recent, IsEmpty());
  choose(session, scene);
  settle();
  ASSERT_NE(session.shown, nullptr);
  EXPECT_FALSE(session.start.open);
  perform(session, Action::open);
  EXPECT_TRUE(session.start.open);
  EXPECT_THAT(session.start.recent, ElementsAre(scene));
  perform(session, Action::escape);
  EXPECT_FALSE(session.start.open);
}

TEST_F(StartPanelTest, AnInvalidFileIsReportedInThePanel) {
  const std::string broken = folder.write("scenes/broken.xml", "<scenefile>");
  open_start_panel(session);
  choose(session, broken);
  settle();
  EXPECT_TRUE(session.start.open);
  ASSERT_NE(session.broken, nullptr);
  EXPECT_TRUE(session.broken->opened.diagnostics.has_errors());
  EXPECT_THAT(load_recent_files(session.setup.recent_files), IsEmpty());
  choose(session, folder.path("none.xml"));
  ASSERT_TRUE(session.notice.has_value());
  EXPECT_TRUE(session.notice->bad);
  EXPECT_THAT(session.notice->text, HasSubstr("no such file"));
  choose(session, scene);
  settle();
  EXPECT_FALSE(session.start.open);
  EXPECT_EQ(session.broken, nullptr);
}

TEST_F(StartPanelTest, AChangeOfTheFileDoesNotCloseIt) {
  open_scene(session, scene);
  settle();
  perform(session, Action::open);
  const std::uint64_t version = session.version;
  folder.write("scenes/b.xml", testing::scene_text + "<!-- changed -->");
  for (int i = 0; i < testing::patience && session.version == version; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    tick(session, time += 0.05);
  }
  EXPECT_NE(session.version, version);
  EXPECT_TRUE(session.start.open);
}

TEST_F(StartPanelTest, APictureBecomesTheReference) {
  const std::string picture =
      folder.write("p.png", *encode_image(Image(8, 6), ImageFormat::png8, Rounding::nearest));
  open_start_panel(session);
  choose(session, picture);
  settle();
  EXPECT_EQ(session.mine.decoded->texture.width, 8);
}

TEST_F(StartPanelTest, WorksWithoutAScene) {
  for (const ActionRow& row : actions()) {
    if (row.action != Action::quit && row.action != Action::new_scene) {
      perform(session, row.action);
    }
  }
  EXPECT_EQ(session.shown, nullptr);
  EXPECT_EQ(scene_name(session), "");
}

}  // namespace

}  // namespace scenefile::viewer
