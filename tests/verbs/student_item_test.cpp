#include "scenefile/verbs/student_item.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace scenefile {
namespace {

using ::testing::HasSubstr;

StudentResult some_student() {
  PictureResult right;
  right.name = "ball";
  right.measures.difference.psnr_db = std::numeric_limits<double>::infinity();
  right.png = std::string("\x89PNG\0\xff", 6);
  right.fingerprint = 0xfedcba9876543210;
  PictureResult wrong;
  wrong.name = "cube \"\\ \xc3\xa9";
  wrong.verdict = Verdict::differs;
  wrong.measures.size = {640, 480};
  wrong.measures.right_size = {320, 240};
  wrong.measures.ssim = 1.0 / 3;
  wrong.measures.difference.mean = -1e-9;
  wrong.measures.linear = true;
  wrong.reasons = {"bad name: \xff\xfe", "two\nlines"};
  wrong.causes = {{static_cast<Cause>(cause_count - 1), "what", "evidence", 0.1, true}};
  wrong.causes.front().alternatives = {"what", "\xff"};
  wrong.rivals = {{}, {}};
  wrong.notes = {""};
  wrong.identical = "ada, ben";
  return {"ann", {right, wrong}, {"a/b.png", "\x80"}};
}

TEST(StudentItem, KeepsEveryValue) {
  const StudentResult student = some_student();
  const std::string text = encode_student(student, "the key");
  EXPECT_THAT(text, HasSubstr("{\n  \"key\": \"the key\",\n"));
  StudentResult read;
  ASSERT_TRUE(decode_student(text, read));
  EXPECT_EQ(encode_student(read, "the key"), text);
  EXPECT_EQ(read.name, "ann");
  EXPECT_EQ(read.unmatched, student.unmatched);
  ASSERT_EQ(read.pictures.size(), 2U);
  EXPECT_EQ(read.pictures[0].png, student.pictures[0].png);
  EXPECT_EQ(read.pictures[0].fingerprint, student.pictures[0].fingerprint);
  EXPECT_EQ(read.pictures[0].measures.difference.psnr_db,
            student.pictures[0].measures.difference.psnr_db);
  EXPECT_EQ(read.pictures[1].name, student.pictures[1].name);
  EXPECT_EQ(read.pictures[1].verdict, Verdict::differs);
  EXPECT_EQ(read.pictures[1].measures.ssim, 1.0 / 3);
  EXPECT_EQ(read.pictures[1].measures.difference.mean, -1e-9);
  EXPECT_EQ(read.pictures[1].measures.right_size.x, 320);
  EXPECT_EQ(read.pictures[1].reasons, student.pictures[1].reasons);
  EXPECT_EQ(read.pictures[1].causes[0].cause, student.pictures[1].causes[0].cause);
  EXPECT_TRUE(read.pictures[1].causes[0].said);
  EXPECT_EQ(read.pictures[1].causes[0].alternatives, student.pictures[1].causes[0].alternatives);
}

TEST(StudentItem, RefusesOtherDocuments) {
  const std::string text = encode_student(some_student(), "");
  StudentResult read;
  for (std::size_t i = 0; i + 2 < text.size(); i += 7) {
    EXPECT_FALSE(decode_student(text.substr(0, i), read)) << i;
  }
  for (const char* const other :
       {"", "[]", "{}", R"({"student": 1})", R"({"student": {"name": "a", "pictures": []}})",
        R"({"student": {"name": "a", "pictures": [1], "unmatched": []}})",
        R"({"student": {"name": {"base64": "%"}, "pictures": [], "unmatched": []}})"}) {
    EXPECT_FALSE(decode_student(other, read)) << other;
  }
  std::string cause = text;
  cause.replace(cause.find("\"verdict\": 0"), 12, "\"verdict\": 9");
  EXPECT_FALSE(decode_student(cause, read));
}

}  // namespace
}  // namespace scenefile
