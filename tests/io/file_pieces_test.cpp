// Reading and writing files in pieces.

#include "io/temp_folder.h"
#include "scenefile/io/file_reader.h"
#include "scenefile/io/file_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {

namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing_support::TempFolder;

TEST(FileWriter, TheFileAppearsAtomically) {
  const TempFolder folder;
  Result<FileWriter> file = FileWriter::create(folder.path("a"));
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->append("0123"));
  ASSERT_TRUE(file->append("456789"));
  ASSERT_TRUE(file->replace(2, "xyz"));
  EXPECT_EQ(folder.read("a"), "");
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(folder.read("a"), "01xyz56789");
  EXPECT_THAT(folder.list(), ElementsAre("a"));
}

TEST(FileWriter, WithoutCommitNothingHappened) {
  const TempFolder folder;
  folder.write("a", "old");
  {
    Result<FileWriter> file = FileWriter::create(folder.path("a"));
    ASSERT_TRUE(file && file->append("new"));
    Result<FileWriter> other = FileWriter::create(folder.path("b"));
    ASSERT_TRUE(other);
  }
  EXPECT_EQ(folder.read("a"), "old");
  EXPECT_THAT(folder.list(), ElementsAre("a"));
}

TEST(FileWriter, UnwritablePathsAreRejected) {
  const TempFolder folder;
  EXPECT_FALSE(FileWriter::create(folder.path()));
  EXPECT_FALSE(FileWriter::create(folder.path("no/such")));
  EXPECT_THAT(folder.list(), IsEmpty());
}

TEST(FileReader, ReadsPieces) {
  const TempFolder folder;
  const Result<FileReader> file = FileReader::open(folder.write("a", "0123456789"));
  ASSERT_TRUE(file);
  EXPECT_EQ(file->size(), 10u);
  EXPECT_EQ(*file->read(3, 4), "3456");
  EXPECT_EQ(*file->read(8, 4), "89");
  EXPECT_EQ(*file->read(20, 4), "");
}

TEST(FileReader, RejectsOtherThanRegularFiles) {
  const TempFolder folder;
  EXPECT_FALSE(FileReader::open(folder.path()));
  EXPECT_FALSE(FileReader::open(folder.path("no")));
  EXPECT_FALSE(FileReader::open("/dev/zero"));
}

}  // namespace

}  // namespace scenefile
