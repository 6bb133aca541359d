#include "scenefile/io/folder.h"

#include "io/temp_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <utility>

namespace scenefile {

namespace {

using testing_support::TempFolder;

TEST(Folder, StampsDistinguishVersions) {
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

TEST(Folder, EntriesHaveTheKindOfWhatTheyLeadTo) {
  const TempFolder folder;
  folder.write("a/inner");
  folder.write("b");
  std::filesystem::create_symlink("a", folder.path("to-folder"));
  std::filesystem::create_symlink("b", folder.path("to-file"));
  std::filesystem::create_symlink("nowhere", folder.path("to-nothing"));
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  std::string kinds;
  for (const FolderEntry& entry : entries_of(folder.path())) {
    EXPECT_EQ(entry.path, folder.path(entry.name));
    kinds += entry.name + (entry.link ? " link" : "") + (entry.folder ? " folder" : "") +
             (entry.file ? " file" : "") + (entry.missing ? " missing\n" : "\n");
  }
  EXPECT_EQ(kinds,
            "a folder\nb file\npipe\nto-file link file\nto-folder link folder\n"
            "to-nothing link missing\n");
  int visited = 0;
  EXPECT_FALSE(
      visit_entries(folder.path() + "/", [&](const FolderEntry&) { return ++visited < 2; }));
  EXPECT_EQ(visited, 2);
}

TEST(Folder, SaysWhyItCannotBeRead) {
  const TempFolder folder;
  std::string problem;
  EXPECT_TRUE(entries_of(folder.path("none"), &problem).empty());
  EXPECT_EQ(problem, "No such file or directory");
  folder.write("b");
  EXPECT_EQ(visit_entries(folder.path("b"), [](const FolderEntry&) { return true; }),
            std::errc::not_a_directory);
  EXPECT_TRUE(is_folder(folder.path()));
  EXPECT_FALSE(is_folder(folder.path("b")));
}

TEST(Folder, FilesBelowAreInNaturalOrder) {
  const TempFolder folder;
  for (const char* name : {"b10", "b9", "Z/1", "a/2", "a/10", ".git/c", "a/.d", "__MACOSX/a/2"}) {
    folder.write(name);
  }
  std::filesystem::create_directory_symlink("..", folder.path("a/up"));
  std::filesystem::create_symlink("../b9", folder.path("a/link"));
  std::filesystem::create_symlink("nowhere", folder.path("a/lost"));
  std::vector<Error> errors;
  const std::string at = folder.path() + "/";
  EXPECT_EQ(files_below(folder.path(), errors),
            (std::vector{at + "b9", at + "b10", at + "a/2", at + "a/10", at + "a/link",
                         at + "a/lost", at + "Z/1"}));
  EXPECT_TRUE(errors.empty());
}

TEST(Folder, UnreadableFoldersAreReported) {
  const TempFolder folder;
  std::vector<Error> errors;
  EXPECT_TRUE(files_below(folder.path("none"), errors).empty());
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].text.find("none: cannot list the folder: "), std::string::npos);
}

TEST(Folder, NamesAreInNaturalOrder) {
  for (const auto& [first, second] :
       {std::pair("a9", "a10"), {"a09b", "a10"}, {"A1", "b1"}, {"a", "a1"}, {"B", "a1"}}) {
    EXPECT_EQ(natural_less(first, second), std::string(first) != "B") << first << second;
    EXPECT_EQ(natural_less(second, first), std::string(first) == "B") << first << second;
  }
  EXPECT_FALSE(natural_less("same", "same"));
}

TEST(Folder, PartsOfPaths) {
  EXPECT_EQ(folder_of("a/b/c.xml"), "a/b");
  EXPECT_EQ(folder_of("c.xml"), ".");
  EXPECT_EQ(file_name_of("a/b/c.xml"), "c.xml");
}

TEST(Folder, IsCreatedWithItsParents) {
  const TempFolder folder;
  EXPECT_EQ(error_text(make_folder(folder.path("x/y/z"))), "");
  EXPECT_EQ(error_text(make_folder(folder.path("x/y/z"))), "");
  EXPECT_TRUE(is_folder(folder.path("x/y/z")));
  folder.write("file");
  EXPECT_NE(error_text(make_folder(folder.path("file/z"))), "");
}

TEST(TemporaryFolder, IsRemovedWithItsContents) {
  std::string path;
  {
    Result<TemporaryFolder> made = TemporaryFolder::create();
    ASSERT_TRUE(made);
    const TemporaryFolder folder = *std::move(made);
    path = folder.path();
    EXPECT_TRUE(is_folder(path));
    EXPECT_TRUE(write_file(path + "/a", "x"));
  }
  EXPECT_FALSE(stamp_of(path).exists);
}

}  // namespace

}  // namespace scenefile
