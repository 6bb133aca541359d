#include "io/temp_folder.h"
#include "scenefile/io/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace scenefile {

namespace {

using ::testing::HasSubstr;
using testing_support::TempFolder;

constexpr std::uint64_t plenty = 1 << 20;

TEST(ReadFile, GivesTheBytesAsTheyAre) {
  const TempFolder folder;
  const std::string bytes = std::string("a\0b\r\n\xff", 6) + std::string(200'000, 'z');
  std::string read = "old";
  EXPECT_EQ(read_file(folder.write("a file", bytes), plenty, read).text, "");
  EXPECT_EQ(read, bytes);
  EXPECT_EQ(read_file(folder.write("empty", ""), plenty, read).text, "");
  EXPECT_EQ(read, "");
}

TEST(ReadFile, SaysWhyNotAndLeavesNothing) {
  const TempFolder folder;
  std::string bytes = "old";
  EXPECT_THAT(read_file(folder.path("nosuch"), plenty, bytes).text,
              ::testing::AllOf(HasSubstr(folder.path("nosuch")), HasSubstr("No such file")));
  EXPECT_EQ(bytes, "");
  EXPECT_THAT(read_file(folder.path(), plenty, bytes).text, HasSubstr("is a directory"));
  EXPECT_THAT(read_file("/dev/zero", plenty, bytes).text, HasSubstr("is a device"));
  EXPECT_THAT(read_file("", plenty, bytes).text, HasSubstr("No such file"));
}

TEST(ReadFile, DoesNotBlockOnAPipe) {
  const TempFolder folder;
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  std::string bytes;
  EXPECT_THAT(read_file(folder.path("pipe"), plenty, bytes).text, HasSubstr("is a pipe"));
}

TEST(ReadFile, RefusesMoreThanTheLimit) {
  const TempFolder folder;
  std::string bytes;
  const std::string file = folder.write("f", "12345");
  EXPECT_EQ(read_file(file, 5, bytes).text, "");
  const IoError error = read_file(file, 4, bytes);
  EXPECT_TRUE(error.over_limit);
  EXPECT_THAT(error.text, HasSubstr("limit of 4 bytes"));
  EXPECT_EQ(bytes, "");
}

TEST(ReadFile, RefusesASparseGiantWithoutReading) {
  const TempFolder folder;
  const std::string file = folder.write("giant");
  ASSERT_EQ(::truncate(file.c_str(), off_t{1} << 36), 0);
  std::string bytes;
  EXPECT_TRUE(read_file(file, plenty, bytes).over_limit);
}

TEST(ReadFile, EscapesThePath) {
  std::string bytes;
  EXPECT_EQ(read_file("no\x1b[31m", plenty, bytes).text.find('\x1b'), std::string::npos);
}

// Runs `use` with a pipe that holds `content` as standard input.
template <typename Use>
void with_standard_input(const std::string& content, Use use) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], content.data(), content.size()), static_cast<ssize_t>(content.size()));
  ::close(ends[1]);
  const int saved = ::dup(STDIN_FILENO);
  ::dup2(ends[0], STDIN_FILENO);
  ::close(ends[0]);
  use();
  ::dup2(saved, STDIN_FILENO);
  ::close(saved);
}

TEST(ReadFile, ReadsStandardInputEvenFromAPipe) {
  for (const std::string name : {"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"}) {
    with_standard_input("hello", [&] {
      std::string bytes;
      EXPECT_EQ(read_file(name, plenty, bytes).text, "") << name;
      EXPECT_EQ(bytes, "hello") << name;
    });
  }
}

TEST(ReadFile, BoundsStandardInputToo) {
  with_standard_input("hello", [] {
    std::string bytes;
    const IoError error = read_file("-", 4, bytes);
    EXPECT_TRUE(error.over_limit);
    EXPECT_THAT(error.text, HasSubstr("standard input"));
  });
}

}  // namespace

}  // namespace scenefile
