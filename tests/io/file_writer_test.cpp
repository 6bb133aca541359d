// Writing files in pieces.

#include "scenefile/io/file_writer.h"

#include "io/temp_folder.h"

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

}  // namespace

}  // namespace scenefile
