#include "scenefile/io/used_files.h"

#include "io/temp_folder.h"
#include "scenefile/io/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace scenefile {
namespace {

using testing_support::TempFolder;

// Whether writing `b` would replace `a`.
bool same_file(const std::string& a, const std::string& b) {
  UsedFiles files;
  EXPECT_TRUE(files.read({a, "the input"}));
  return !files.write({b, "the output"});
}

TEST(SameFile, RecognizesOtherSpellings) {
  const TempFolder folder;
  folder.write("a");
  folder.write("b");
  std::filesystem::create_symlink("a", folder.path("link"));
  std::filesystem::create_hard_link(folder.path("a"), folder.path("hard"));
  EXPECT_TRUE(same_file(folder.path("a"), folder.path("./a")));
  EXPECT_TRUE(same_file(folder.path("a"), folder.path("link")));
  EXPECT_TRUE(same_file(folder.path("a"), folder.path("hard")));
  EXPECT_FALSE(same_file(folder.path("a"), folder.path("b")));
  EXPECT_FALSE(same_file(folder.path("a"), folder.path("A")));
  EXPECT_FALSE(same_file(folder.path("a"), folder.path("none")));
  EXPECT_TRUE(same_file(folder.path("none"), folder.path("./none")));
  EXPECT_FALSE(same_file(folder.path("none"), folder.path("None")));
  EXPECT_FALSE(same_file(folder.path("none"), folder.path("other")));
  EXPECT_TRUE(same_file(folder.path("new/none"), folder.path("new/../new/none")));
  EXPECT_FALSE(same_file(folder.path("new/none"), folder.path("none")));
  std::filesystem::create_symlink("none", folder.path("to_none"));
  EXPECT_TRUE(same_file(folder.path("none"), folder.path("to_none")));
  EXPECT_FALSE(same_file("-", "-"));
  EXPECT_FALSE(same_file("/dev/stdout", "/dev/stdout"));
  EXPECT_FALSE(same_file("/dev/null", "/dev/null"));
  EXPECT_FALSE(same_file("", ""));
}

std::string error_of(const Result<void>& result) {
  return result ? std::string() : result.error().text;
}

TEST(UsedFiles, NoOutputIsAnInputOrAnotherOutput) {
  const TempFolder folder;
  const std::string scene = folder.write("scene.xml");
  const std::string out = folder.path("out.png");
  for (const bool input_first : {true, false}) {
    UsedFiles files;
    const UsedFile input{scene, "the scene s"};
    const UsedFile output{folder.path("./scene.xml"), "the output o"};
    EXPECT_EQ(error_of(input_first ? files.read(input) : files.write(output)), "");
    const Result<void> refused = input_first ? files.write(output) : files.read(input);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().text, "the output o would replace the scene s; choose another name");
    EXPECT_EQ(refused.error().kind, ErrorKind::usage);
  }
  UsedFiles files;
  EXPECT_EQ(error_of(files.write({out, "the sheet out.png"})), "");
  EXPECT_EQ(error_of(files.write({out, "the sheet out.png"})), "");
  EXPECT_EQ(error_of(files.write({out, "the report out.png"})),
            "the report out.png would replace the sheet out.png; choose another name");
  EXPECT_EQ(error_of(files.read({scene, "the scene"})), "");
  EXPECT_EQ(error_of(files.read({scene, "the reference"})), "");
  for (const char* const none : {"-", "/dev/null", "/dev/stdout", ""}) {
    EXPECT_EQ(error_of(files.read({none, "the scene"})), "");
    EXPECT_EQ(error_of(files.write({none, "the output"})), "");
    EXPECT_EQ(error_of(files.write({none, "the report"})), "");
  }
}

}  // namespace
}  // namespace scenefile
