// Changed files, folders, and the files that the window writes.

#include "io/temp_folder.h"
#include "scenefile/viewer/file_watch.h"
#include "scenefile/viewer/files_to_choose.h"
#include "scenefile/viewer/playlist.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace scenefile::viewer {

namespace {

using testing_support::TempFolder;
namespace fs = std::filesystem;

TEST(FilesToChoose, AreThoseThatTheSceneCanName) {
  const TempFolder folder;
  for (const char* const file : {"a.xml", "wood10.png", "wood2.JPG", "light.exr", "tree.obj",
                                 "maps/b.tga", "maps/c.obj", "maps/deep/d.png", ".hidden/e.png"}) {
    folder.write(file, "");
  }
  using Files = std::vector<std::string>;
  const std::string scene = folder.path("a.xml");
  EXPECT_EQ(files_to_choose(scene, FileUse::mesh), (Files{"maps/c.obj", "tree.obj"}));
  EXPECT_EQ(files_to_choose(scene, FileUse::image),
            (Files{"maps/b.tga", "wood2.JPG", "wood10.png"}));
  EXPECT_EQ(files_to_choose(folder.path("none/a.xml"), FileUse::mesh), Files());
}

TEST(FileWatch, ReportsAChangeOnceWhenTheFileIsStable) {
  const TempFolder folder;
  const std::string path = folder.write("a.xml", "one");
  FileWatch watch;
  watch.watch({path});
  EXPECT_FALSE(watch.changed());
  EXPECT_FALSE(watch.changed());
  folder.write("a.xml", "longer");
  EXPECT_FALSE(watch.changed()) << "it may still be written";
  folder.write("a.xml", "longer still");
  EXPECT_FALSE(watch.changed());
  EXPECT_TRUE(watch.changed());
  EXPECT_FALSE(watch.changed());
}

TEST(FileWatch, WatchingAFileAgainKeepsItsChange) {
  testing_support::TempFolder folder;
  const std::string path = folder.write("a.xml", "first");
  FileWatch watch;
  watch.watch({path});
  folder.write("a.xml", "second text");
  watch.watch({folder.path("texture.png"), path});
  EXPECT_FALSE(watch.changed());
  EXPECT_TRUE(watch.changed());
}

TEST(FileWatch, AFileOfTheSameSizeAndTimeIsAnotherFile) {
  const TempFolder folder;
  const std::string path = folder.write("a.xml", "one");
  const std::string other = folder.write("b.xml", "two");
  fs::last_write_time(other, fs::last_write_time(path));
  FileWatch watch;
  watch.watch({path});
  fs::rename(other, path);
  EXPECT_FALSE(watch.changed());
  EXPECT_TRUE(watch.changed());
}

TEST(FileWatch, ABrieflyMissingFileHasNotChanged) {
  const TempFolder folder;
  const std::string path = folder.write("a.xml", "one");
  FileWatch watch;
  watch.watch({path});
  fs::rename(path, path + "~");
  EXPECT_FALSE(watch.changed());
  fs::rename(path + "~", path);
  EXPECT_FALSE(watch.changed());
  EXPECT_FALSE(watch.changed());
}

TEST(FileWatch, MissingFilesMayAppear) {
  const TempFolder folder;
  FileWatch watch;
  watch.watch({folder.path("texture.png")});
  EXPECT_FALSE(watch.changed());
  folder.write("texture.png");
  EXPECT_FALSE(watch.changed());
  EXPECT_TRUE(watch.changed());
}

TEST(Playlist, IsInNaturalOrder) {
  const TempFolder folder;
  for (const char* name : {"a10.xml", "a9.XML", "B1.json", "a09b.xml", "notes.txt", "c.png"}) {
    folder.write(name);
  }
  fs::create_directory(folder.path("d.xml"));
  const std::string at = folder.path() + "/";
  EXPECT_EQ(scenes_in(folder.path()),
            (std::vector{at + "a9.XML", at + "a09b.xml", at + "a10.xml", at + "B1.json"}));
  EXPECT_EQ(neighbor_of(at + "a10.xml", 1), at + "B1.json");
  EXPECT_EQ(neighbor_of(at + "B1.json", 1), at + "a9.XML");
  EXPECT_EQ(neighbor_of(at + "a9.XML", -1), at + "B1.json");
  EXPECT_EQ(neighbor_of(at + "gone.xml", 1), at + "a9.XML");
  EXPECT_EQ(scene_at(folder.path()), at + "a9.XML");
  EXPECT_EQ(scene_at(at + "notes.txt"), at + "notes.txt");
}

TEST(Playlist, EmptyFolders) {
  const TempFolder folder;
  EXPECT_EQ(neighbor_of(folder.path("a.xml"), 1), "");
  EXPECT_EQ(scene_at(folder.path()), "");
}

}  // namespace

}  // namespace scenefile::viewer
