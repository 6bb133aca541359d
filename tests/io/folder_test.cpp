#include "scenefile/io/folder.h"

#include "io/temp_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace scenefile {

namespace {

using testing_support::TempFolder;

TEST(Folder, StampsTellVersionsApart) {
  const TempFolder folder;
  const std::string path = folder.write("a", "one");
  const FileStamp stamp = stamp_of(path);
  EXPECT_TRUE(stamp.exists);
  EXPECT_EQ(stamp.size, 3U);
  EXPECT_EQ(stamp_of(path), stamp);
  std::filesystem::rename(folder.write("b", "two"), path);
  EXPECT_NE(stamp_of(path), stamp);
  EXPECT_EQ(stamp_of(folder.path("none")), FileStamp());
}

TEST(Folder, ListsFilesAlone) {
  const TempFolder folder;
  folder.write("b");
  folder.write("a/inner");
  folder.write("c");
  EXPECT_EQ(files_in(folder.path()), (std::vector<std::string>{"b", "c"}));
  EXPECT_EQ(files_in(folder.path(), 1).size(), 1U);
  EXPECT_TRUE(files_in(folder.path("none")).empty());
  EXPECT_TRUE(is_folder(folder.path("a")));
  EXPECT_FALSE(is_folder(folder.path("b")));
}

TEST(Folder, PartsOfPaths) {
  EXPECT_EQ(folder_of("a/b/c.xml"), "a/b");
  EXPECT_EQ(folder_of("c.xml"), ".");
  EXPECT_EQ(file_name_of("a/b/c.xml"), "c.xml");
}

TEST(Folder, IsMadeWithThoseAboveIt) {
  const TempFolder folder;
  EXPECT_TRUE(make_folder(folder.path("x/y/z")).empty());
  EXPECT_TRUE(make_folder(folder.path("x/y/z")).empty());
  EXPECT_TRUE(is_folder(folder.path("x/y/z")));
  folder.write("file");
  EXPECT_FALSE(make_folder(folder.path("file/z")).empty());
}

}  // namespace

}  // namespace scenefile
