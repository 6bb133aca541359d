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

// The bytes, or the error.
std::string bytes_of(const std::string& path, std::uint64_t most = plenty) {
  const Result<std::string> read = read_file(path, most);
  EXPECT_EQ(error_text(read), "");
  return read ? *read : std::string();
}
std::string why_not(const std::string& path) {
  return error_text(read_file(path, plenty));
}

TEST(ReadFile, ReturnsTheBytesUnchanged) {
  const TempFolder folder;
  const std::string bytes = std::string("a\0b\r\n\xff", 6) + std::string(200'000, 'z');
  EXPECT_EQ(bytes_of(folder.write("a file", bytes)), bytes);
  EXPECT_EQ(bytes_of(folder.write("empty", "")), "");
}

TEST(ReadFile, ReportsErrorsAndReturnsNothing) {
  const TempFolder folder;
  EXPECT_THAT(why_not(folder.path("nosuch")),
              ::testing::AllOf(HasSubstr(folder.path("nosuch")), HasSubstr("No such file")));
  EXPECT_THAT(why_not(folder.path()), HasSubstr("is a directory"));
  EXPECT_THAT(why_not("/dev/zero"), HasSubstr("is a device"));
  EXPECT_THAT(why_not(""), HasSubstr("No such file"));
}

TEST(ReadFile, DoesNotBlockOnAPipe) {
  const TempFolder folder;
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  EXPECT_THAT(why_not(folder.path("pipe")), HasSubstr("is a pipe"));
}

TEST(ReadFile, RejectsFilesBeyondTheLimit) {
  const TempFolder folder;
  const std::string file = folder.write("f", "12345");
  EXPECT_EQ(bytes_of(file, 5), "12345");
  const Result<std::string> refused = read_file(file, 4);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::limit);
  EXPECT_THAT(refused.error().text, HasSubstr("limit of 4 bytes"));
}

TEST(ReadFile, RejectsAHugeSparseFileWithoutReading) {
  const TempFolder folder;
  const std::string file = folder.write("giant");
  ASSERT_EQ(::truncate(file.c_str(), off_t{1} << 36), 0);
  const Result<std::string> refused = read_file(file, plenty);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::limit);
}

TEST(ReadFile, EscapesThePath) {
  EXPECT_EQ(why_not("no\x1b[31m").find('\x1b'), std::string::npos);
}

// Runs `use` with `content` on standard input, through a pipe.
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
    with_standard_input("hello", [&] { EXPECT_EQ(bytes_of(name), "hello") << name; });
  }
}

TEST(ReadFile, LimitsStandardInputToo) {
  with_standard_input("hello", [] {
    const Result<std::string> refused = read_file("-", 4);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::limit);
    EXPECT_THAT(refused.error().text, HasSubstr("standard input"));
  });
}

}  // namespace

}  // namespace scenefile
