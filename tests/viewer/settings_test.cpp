#include "scenefile/viewer/settings.h"

#include "io/temp_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace scenefile::viewer {

namespace {

using testing_support::TempFolder;

Settings other_settings() {
  Settings settings;
  settings.window_width = 900;
  settings.panel_width = 212.5F;
  settings.outline = false;
  settings.ray_tracing = true;
  settings.samples = 64;
  return settings;
}

TEST(Settings, RoundTripsAllValues) {
  Settings settings;
  EXPECT_TRUE(parse_settings(settings_text(other_settings()), settings));
  EXPECT_EQ(settings, other_settings());
}

TEST(Settings, DamageIsAllOrNothing) {
  for (const char* text : {"window_width = 900\nshadows", "window_width = 900\nshadows = yes",
                           "window_width = 900\nshadows =", "= 3", "\x7f\x45LF"}) {
    Settings settings;
    EXPECT_FALSE(parse_settings(text, settings)) << text;
    EXPECT_EQ(settings, Settings()) << text;
  }
}

TEST(Settings, NewerVersionsAndValuesOutOfRange) {
  Settings settings;
  EXPECT_TRUE(
      parse_settings("# note\r\n\r\nnew_thing = 7\nwindow_width = 1e9\nsamples=-4\n", settings));
  EXPECT_EQ(settings.window_width, 16384);
  EXPECT_EQ(settings.samples, 1);
}

TEST(Settings, Places) {
  const auto path = [](const char* xdg, const char* home) {
    return user_path(xdg, home, ".config", "view.ini");
  };
  EXPECT_EQ(path("/x", "/home/me"), "/x/scenefile/view.ini");
  EXPECT_EQ(path("relative", "/home/me"), "/home/me/.config/scenefile/view.ini");
  EXPECT_EQ(path(nullptr, "/home/me"), "/home/me/.config/scenefile/view.ini");
  EXPECT_EQ(path(nullptr, nullptr), "");
}

TEST(Settings, Files) {
  const TempFolder folder;
  const std::string path = folder.path("a/b/view.ini");
  std::string note;
  EXPECT_EQ(load_settings(path, note), Settings());
  EXPECT_EQ(note, "");
  EXPECT_EQ(save_settings(path, other_settings()), "");
  EXPECT_EQ(load_settings(path, note), other_settings());
  EXPECT_EQ(folder.list(), std::vector<std::string>{"a"});
  struct stat status {};
  ASSERT_EQ(::stat(folder.path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0700U);
  folder.write("a/b/view.ini", "what");
  EXPECT_EQ(load_settings(path, note), Settings());
  EXPECT_NE(note.find("damaged"), std::string::npos);
  EXPECT_NE(save_settings(folder.path("a/b/view.ini/no"), {}), "");
}

}  // namespace

}  // namespace scenefile::viewer
