#include "io/temp_folder.h"
#include "scenefile/io/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

namespace scenefile {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;
using testing_support::TempFolder;

TEST(WriteFile, WritesAllAndNothingElse) {
  const TempFolder folder;
  const std::string bytes(300'000, 'q');
  EXPECT_EQ(error_text(check_writable(folder.path("out"))), "");
  EXPECT_THAT(folder.list(), ElementsAre());
  EXPECT_EQ(error_text(write_file(folder.path("out"), bytes)), "");
  EXPECT_EQ(folder.read("out"), bytes);
  EXPECT_THAT(folder.list(), ElementsAre("out"));
}

TEST(WriteFile, KeepsTheModeOfTheOldFile) {
  const TempFolder folder;
  const std::string file = folder.write("out", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  EXPECT_EQ(error_text(write_file(file, "new")), "");
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640U);
  EXPECT_EQ(folder.read("out"), "new");
}

TEST(WriteFile, WritesThroughLinks) {
  const TempFolder folder;
  folder.write("real/old", "old");
  ASSERT_EQ(::symlink("real/old", folder.path("to_old").c_str()), 0);
  ASSERT_EQ(::symlink("real/none", folder.path("to_none").c_str()), 0);
  for (const std::string name : {"old", "none"}) {
    EXPECT_EQ(error_text(write_file(folder.path("to_" + name), "new")), "");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("to_" + name)));
    EXPECT_EQ(folder.read("real/" + name), "new");
  }
}

TEST(WriteFiles, WritesAllAndNothingElse) {
  const TempFolder folder;
  folder.write("b", "old");
  const std::string one(300'000, 'q');
  const std::string two = "two";
  const std::vector<OutputFile> files{{folder.path("a"), &one}, {folder.path("b"), &two}};
  EXPECT_EQ(error_text(write_files(files)), "");
  EXPECT_EQ(folder.read("a"), one);
  EXPECT_EQ(folder.read("b"), two);
  EXPECT_THAT(folder.list(), UnorderedElementsAre("a", "b"));
}

TEST(WriteFiles, WritesNoneWhereOneCannotBe) {
  const TempFolder folder;
  folder.write("kept", "old");
  folder.write("folder/inside", "");
  const std::string bytes = "new";
  for (const std::string bad : {"folder", "none/file"}) {
    for (const bool first : {false, true}) {
      std::vector<OutputFile> files{{folder.path("kept"), &bytes}, {folder.path("new"), &bytes}};
      files.insert(first ? files.begin() : files.end(), {folder.path(bad), &bytes});
      EXPECT_THAT(error_text(write_files(files)), HasSubstr("cannot write"));
      EXPECT_EQ(folder.read("kept"), "old");
      EXPECT_THAT(folder.list(), UnorderedElementsAre("kept", "folder"));
    }
  }
}

TEST(WriteFiles, RejectsDevices) {
  const TempFolder folder;
  const std::string bytes = "new";
  const std::vector<OutputFile> files{{folder.path("a"), &bytes}, {"/dev/null", &bytes}};
  EXPECT_THAT(error_text(write_files(files)), HasSubstr("not a regular file"));
  EXPECT_THAT(folder.list(), ElementsAre());
}

TEST(WriteFile, ALoopOfLinksIsAnError) {
  const TempFolder folder;
  ASSERT_EQ(::symlink("loop", folder.path("loop").c_str()), 0);
  EXPECT_THAT(error_text(write_file(folder.path("loop"), "x")), HasSubstr("cannot write"));
}

TEST(WriteFile, FailsBeforeWorkWhereItWouldFailAfter) {
  const TempFolder folder;
  folder.write("file");
  for (const std::string& path :
       {folder.path(), folder.path("no/such/out"), folder.path("file/out"), std::string(),
        folder.path(std::string(300, 'n'))}) {
    const Result<void> before = check_writable(path);
    EXPECT_THAT(error_text(before), HasSubstr("cannot write")) << path;
    EXPECT_EQ(error_text(before), error_text(write_file(path, "x")));
  }
}

TEST(WriteFile, WritesADeviceInPlace) {
  EXPECT_EQ(error_text(check_writable("/dev/null")), "");
  EXPECT_EQ(error_text(write_file("/dev/null", "x")), "");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_THAT(error_text(write_file("/dev/full", "x")), HasSubstr("No space left"));
}

TEST(WriteFile, LeavesTheOldFileWhenTheDiskIsFull) {
  const TempFolder folder;
  const std::string file = folder.write("out", "old");
  // A file size limit simulates a full disk.
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  ::getrlimit(RLIMIT_FSIZE, &old_limit);
  rlimit small = old_limit;
  small.rlim_cur = 100;
  ::setrlimit(RLIMIT_FSIZE, &small);
  const Result<void> failed = write_file(file, std::string(1000, 'n'));
  ::setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(error_text(failed), HasSubstr("File too large"));
  EXPECT_EQ(folder.read("out"), "old");
  EXPECT_THAT(folder.list(), ElementsAre("out"));
}

TEST(WriteFile, RespectsAProtectedTarget) {
  if (::geteuid() == 0) {
    GTEST_SKIP() << "nothing is protected from root";
  }
  const TempFolder folder;
  const std::string file = folder.write("out", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  EXPECT_THAT(error_text(check_writable(file)), HasSubstr("Permission denied"));
  EXPECT_THAT(error_text(write_file(file, "new")), HasSubstr("Permission denied"));
  EXPECT_EQ(folder.read("out"), "old");
}

}  // namespace

}  // namespace scenefile
