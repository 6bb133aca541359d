#include "scenefile/grade/grade_part.h"

#include <gtest/gtest.h>

namespace scenefile {
namespace {

GradePartHead head() {
  GradePartHead h;
  h.whole = {{1, 2, 3, 4}, 4, 9, 18};
  h.index = 1;
  h.submissions = 5;
  return h;
}

// Every member has a different value.
Gradebook book() {
  PictureResult passed;
  passed.name = "ball";
  passed.measures.size = {3, 4};
  passed.measures.right_size = {5, 6};
  passed.measures.difference = {0.1, 0.2, 7, 0.3};
  passed.measures.ssim = 0.4;
  passed.measures.flip_mean = 0.5;
  passed.measures.flip_max = 0.6;
  PictureResult failed;
  failed.name = std::string("a\0b", 3);
  failed.verdict = Verdict::unreadable;
  failed.measures.same_size = false;
  failed.reasons = {"", "two"};
  failed.causes = {{Cause::samples, "what", "evidence", 0.7, true}};
  failed.rivals = {{Cause::gamma, "rival", "e", 0.6, false}};
  failed.partial = {{Cause::normals, "part", "f", 0.5, false}};
  failed.notes = {"a note"};
  failed.png = "png";
  failed.png_file = "file";
  failed.fingerprint = 77;
  failed.identical = "anna, ben";
  return {{{"anna", {passed, failed}}, {"", {}}},
          {{"a.zip", "anna", "damaged"}, {"b", "", "c"}},
          "fall"};
}

TEST(GradePart, RoundTrips) {
  const std::string bytes = encode_grade_part(head(), book());
  GradePartHead found;
  Gradebook read;
  ASSERT_EQ(decode_grade_part(bytes, found, read), "");
  EXPECT_EQ(found, head());
  ASSERT_EQ(read.students.size(), 2U);
  EXPECT_EQ(encode_grade_part(found, read), bytes);
  EXPECT_EQ(gradebook_csv(read), gradebook_csv(book()));
  EXPECT_EQ(read.ignored, book().ignored);
  EXPECT_EQ(read.name, "fall");
  const PictureResult& picture = read.students[0].pictures[1];
  EXPECT_EQ(picture.verdict, Verdict::unreadable);
  EXPECT_EQ(picture.causes.at(0).cause, Cause::samples);
  EXPECT_EQ(picture.causes.at(0).explained, 0.7);
  EXPECT_TRUE(picture.causes.at(0).said);
  EXPECT_EQ(picture.rivals.at(0).what, "rival");
  EXPECT_EQ(picture.partial.at(0).what, "part");
  EXPECT_EQ(picture.png_file, "file");
  EXPECT_EQ(picture.fingerprint, 77U);
  EXPECT_EQ(picture.identical, "anna, ben");
  EXPECT_EQ(read.students[0].pictures[0].measures.flip_max, 0.6);
  EXPECT_TRUE(is_grade_part(bytes));
}

TEST(GradePart, EveryChangedByteIsDetected) {
  const std::string bytes = encode_grade_part(head(), book());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    GradePartHead found;
    Gradebook read;
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x41);
    EXPECT_NE(decode_grade_part(changed, found, read), "") << i;
    EXPECT_NE(decode_grade_part(bytes.substr(0, i), found, read), "") << i;
  }
  GradePartHead found;
  Gradebook read;
  EXPECT_NE(decode_grade_part(bytes + "x", found, read), "");
  // The number of students must be that of the part.
  EXPECT_NE(decode_grade_part(encode_grade_part(head(), {}), found, read), "");
}

TEST(GradePart, EachStudentIsInOnePart) {
  for (const std::uint32_t count : {1U, 2U, 7U, 10U, 1000U}) {
    for (const std::size_t all :
         {std::size_t{0}, std::size_t{1}, std::size_t{9}, std::size_t{999}}) {
      std::size_t next = 0;
      for (std::uint32_t index = 0; index < count; ++index) {
        const StudentRange range = students_of(index, count, all);
        EXPECT_EQ(range.begin, next);
        EXPECT_LE(range.end - range.begin, all / count + 1);
        next = range.end;
      }
      EXPECT_EQ(next, all);
    }
  }
}

}  // namespace
}  // namespace scenefile
