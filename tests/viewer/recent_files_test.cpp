#include "scenefile/viewer/recent_files.h"

#include "io/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace scenefile::viewer {

namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing_support::TempFolder;

TEST(RecentFiles, LatestFirstWithoutDuplicates) {
  const TempFolder folder;
  const std::string path = folder.path("state/scenefile/recent");
  EXPECT_THAT(load_recent_files(path), IsEmpty());
  EXPECT_EQ(add_recent_file(path, "/a.xml"), "");
  EXPECT_EQ(add_recent_file(path, "/with a blank.json"), "");
  EXPECT_EQ(add_recent_file(path, "/a.xml"), "");
  EXPECT_THAT(load_recent_files(path), ElementsAre("/a.xml", "/with a blank.json"));
}

TEST(RecentFiles, AreBounded) {
  const TempFolder folder;
  const std::string path = folder.path("recent");
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(add_recent_file(path, "/" + std::to_string(i)), "");
  }
  const std::vector<std::string> files = load_recent_files(path);
  EXPECT_EQ(files.size(), max_recent_files);
  EXPECT_EQ(files.front(), "/29");
}

TEST(RecentFiles, ADamagedListCountsAsEmptyAndIsReplaced) {
  const TempFolder folder;
  const std::string path = folder.path("recent");
  for (const std::string& text :
       {std::string("/a.xml\nb.xml\n"), std::string("/a.xml\n\n"), std::string("/a\0.xml\n", 8),
        std::string(100000, '/'), std::string("\x7f\x45LF")}) {
    folder.write("recent", text);
    EXPECT_THAT(load_recent_files(path), IsEmpty()) << text.substr(0, 20);
    EXPECT_EQ(add_recent_file(path, "/good.xml"), "");
    EXPECT_THAT(load_recent_files(path), ElementsAre("/good.xml"));
  }
}

TEST(RecentFiles, SkipsUnsuitablePaths) {
  const TempFolder folder;
  const std::string path = folder.path("recent");
  EXPECT_EQ(add_recent_file("", "/a.xml"), "");
  EXPECT_EQ(add_recent_file(path, "/two\nlines.xml"), "");
  EXPECT_EQ(add_recent_file(path, "relative.xml"), "");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_NE(add_recent_file(folder.write("file", "x") + "/below/recent", "/a.xml"), "");
}

}  // namespace

}  // namespace scenefile::viewer
