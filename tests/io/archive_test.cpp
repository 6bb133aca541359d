#include "scenefile/io/archive.h"

#include "io/temp_folder.h"
#include "support/write_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace scenefile {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing_support::TempFolder;
using testing_support::write_archive;
using testing_support::WrittenEntry;
using Kind = WrittenEntry::Kind;

// "path=contents" or "path: problem" for each entry.
struct Visit {
  std::vector<std::string> entries;
  std::string why;

  void operator()(const ArchiveEntry& entry, const ReadEntry& read) {
    const Result<std::string> bytes = read(1000);
    entries.push_back(entry.path + (bytes ? "=" + *bytes : ": " + bytes.error().text));
  }
};

Visit visited(const std::string& bytes, ArchiveBudget budget = {}) {
  Visit visit;
  visit.why = visit_archive_bytes(bytes, budget, std::ref(visit));
  return visit;
}

TEST(Archive, Names) {
  EXPECT_TRUE(is_archive_name("a.ZIP"));
  EXPECT_TRUE(is_archive_name("a.b.tar.gz"));
  EXPECT_FALSE(is_archive_name(".zip"));
  EXPECT_FALSE(is_archive_name("a.gz"));
  EXPECT_EQ(without_archive_ending("a.b.tar.gz"), "a.b");
  EXPECT_EQ(without_archive_ending("a.png"), "a.png");
}

TEST(Archive, AllFormatsAreRead) {
  const TempFolder folder;
  for (const char* name : {"a.zip", "a.tar", "a.tar.gz", "a.tgz"}) {
    SCOPED_TRACE(name);
    const std::string bytes = write_archive(
        name,
        {{"./b//c.png", "C"}, {"d", "", Kind::folder}, {"d/\xC3\xA9.png", std::string(900, 'e')}});
    const Visit visit = visited(bytes);
    EXPECT_EQ(visit.why, "");
    EXPECT_THAT(visit.entries, ElementsAre("b/c.png=C", "d/\xC3\xA9.png=" + std::string(900, 'e')));
    Visit of_file;
    ArchiveBudget budget;
    EXPECT_EQ(visit_archive(folder.write(name, bytes), budget, std::ref(of_file)), "");
    EXPECT_EQ(of_file.entries, visit.entries);
  }
}

TEST(Archive, FoldersAreVisitedForAllThatIsInThem) {
  for (const char* name : {"a.zip", "a.tar"}) {
    const std::string bytes = write_archive(name, {{"a/b.png"},
                                                   {"c/d/", "", Kind::folder},
                                                   {"e/.DS_Store"},
                                                   {"f/.git/g/HEAD"},
                                                   {"__MACOSX/", "", Kind::folder},
                                                   {"__MACOSX/h/._b.png"},
                                                   {"../i/b.png"},
                                                   {"b.png"}});
    std::vector<std::string> folders;
    ArchiveBudget budget;
    EXPECT_EQ(visit_archive_bytes(
                  bytes, budget, [](const ArchiveEntry&, const ReadEntry&) {},
                  [&](std::string_view path) { folders.emplace_back(path); }),
              "");
    EXPECT_THAT(folders, ElementsAre("a", "c/d", "e", "f")) << name;
  }
}

TEST(Archive, JunkIsSkippedAndEverythingElseHasAProblem) {
  const Visit visit = visited(write_archive("a.tar", {{"__MACOSX/a.png"},
                                                      {"a/._b.png"},
                                                      {".DS_Store"},
                                                      {"a.png", "/etc/passwd", Kind::symbolic_link},
                                                      {"b.png", "a.png", Kind::hard_link},
                                                      {"c.png", "", Kind::device},
                                                      {"../d.png"},
                                                      {"/e.png"},
                                                      {"f/../../f.png"}}));
  EXPECT_EQ(visit.why, "");
  EXPECT_THAT(
      visit.entries,
      ElementsAre("a.png: a symbolic link, not a file", "b.png: a hard link, not a file",
                  "c.png: not a regular file", "../d.png: its path leads out of the archive",
                  "e.png: its path leads out of the archive",
                  "f/../../f.png: its path leads out of the archive"));
}

TEST(Archive, PasswordsAreReported) {
  EXPECT_THAT(visited(write_archive("a.zip", {{"a.png"}}, "secret")).entries,
              ElementsAre("a.png: protected by a password"));
}

TEST(Archive, LimitsAreKept) {
  for (const char* name : {"a.zip", "a.tar", "a.tgz"}) {
    SCOPED_TRACE(name);
    const std::string bytes =
        write_archive(name, {{"a", std::string(800, 'a')}, {"b", std::string(800, 'b')}, {"c"}});
    EXPECT_EQ(visited(bytes, {.entries = 2}).why, "it contains too many files");
    EXPECT_EQ(visited(bytes, {.entries = 2}).entries.size(), 2U);
    const Visit few = visited(bytes, {.bytes = 1500});
    EXPECT_EQ(few.why, "it is too large when unpacked");
    EXPECT_THAT(few.entries.at(0), HasSubstr("aaa"));
    const Visit large = visited(write_archive(name, {{"a", std::string(1001, 'a')}, {"b"}}));
    EXPECT_THAT(large.entries, ElementsAre("a: it is too large when unpacked", "b=x"));
  }
  // Two thousand times smaller than its contents, which are not unpacked.
  const std::string bomb = write_archive("a.tgz", {{"a", std::string(1 << 24, '\0')}, {"b"}});
  EXPECT_LT(bomb.size(), 40'000U);
  EXPECT_THAT(visited(bomb, {.bytes = 1 << 20}).entries, IsEmpty());
}

// libarchive does not recognize a ZIP file without entries.
TEST(Archive, WithoutEntries) {
  const TempFolder folder;
  const std::string empty = "PK\5\6" + std::string(18, '\0');
  std::string with_comment = empty + "none";
  with_comment[20] = 4;
  for (const std::string& bytes : {empty, with_comment, write_archive("a.tar", {}),
                                   write_archive("a.tgz", {}), write_archive("a.zip", {})}) {
    SCOPED_TRACE(bytes.size());
    EXPECT_EQ(visited(bytes).why, "");
    EXPECT_THAT(visited(bytes).entries, IsEmpty());
    Visit of_file;
    ArchiveBudget budget;
    EXPECT_EQ(visit_archive(folder.write("a.zip", bytes), budget, std::ref(of_file)), "");
    EXPECT_THAT(of_file.entries, IsEmpty());
  }
  std::string with_entries = empty;
  with_entries[10] = 1;
  for (const std::string& bytes :
       {empty.substr(1), empty.substr(0, 21), empty + "x", with_entries}) {
    EXPECT_THAT(visited(bytes).why, HasSubstr("it cannot be read as an archive: "));
  }
}

TEST(Archive, DamageIsReported) {
  EXPECT_THAT(visited("").why, HasSubstr("it cannot be read as an archive: "));
  EXPECT_THAT(visited(std::string(3000, 'Z')).why, HasSubstr("it cannot be read as an archive: "));
  for (const char* name : {"a.zip", "a.tgz"}) {
    SCOPED_TRACE(name);
    const std::string bytes = write_archive(name, {{"a.png", "The quick brown fox"}});
    EXPECT_NE(visited(bytes.substr(0, bytes.size() / 2)).why, "");
  }
  std::string wrong = write_archive("a.zip", {{"a.png", "Victor jagt"}, {"b"}}, {}, true);
  wrong.at(wrong.find("Victor")) = 'v';
  const Visit visit = visited(wrong);
  EXPECT_THAT(visit.entries.at(0), HasSubstr("a.png: it is damaged: "));
  EXPECT_THAT(visit.entries.at(1), "b=x");
  // libarchive ends this message with a line break.
  std::string longer =
      write_archive("a.zip", {{"a.png", "The quick brown fox jumps over the lazy dog"}, {"b"}});
  ++longer.at(22);  // the size in the header of the entry
  const std::string why = visited(longer).entries.at(0);
  EXPECT_THAT(why, HasSubstr("a.png: it is damaged: "));
  EXPECT_EQ(why.find('\n'), std::string::npos);
}

TEST(Archive, OfFilesOnlyRegularOnes) {
  const TempFolder folder;
  ArchiveBudget budget;
  Visit visit;
  EXPECT_NE(visit_archive(folder.path("none.zip"), budget, std::ref(visit)), "");
  std::filesystem::create_symlink(folder.write("a.zip", write_archive("a.zip", {{"a"}})),
                                  folder.path("b.zip"));
  EXPECT_NE(visit_archive(folder.path("b.zip"), budget, std::ref(visit)), "");
  EXPECT_THAT(visit.entries, IsEmpty());
}

}  // namespace
}  // namespace scenefile
