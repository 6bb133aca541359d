#include "scenefile/grade/gradebook.h"

#include "scenefile/base/base64.h"
#include "scenefile/grade/markup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::grade_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Gradebook two_students() {
  Claim claim;
  claim.cause = Cause::shadows;
  claim.what = "there are no shadows";
  claim.evidence = "because";
  PictureResult good;
  good.name = "ball";
  PictureResult bad = good;
  bad.name = "a<b";
  bad.verdict = Verdict::differs;
  bad.reasons = {"PSNR is 31.20 dB, less than 40"};
  bad.causes = {claim};
  bad.png = "PNG";
  PictureResult none = good;
  none.verdict = Verdict::missing;
  none.reasons = {"there is no such picture"};
  return {{{"anna", {good, good}}, {"ben & co", {none, bad}}}};
}

TEST(Gradebook, Counts) {
  const Gradebook book = two_students();
  EXPECT_EQ(book.count(Verdict::passed), 2u);
  EXPECT_EQ(book.count(Verdict::missing), 1u);
  EXPECT_FALSE(book.all_passed());
  EXPECT_TRUE((Gradebook{{book.students[0]}}.all_passed()));
}

TEST(Gradebook, Text) {
  EXPECT_EQ(gradebook_text(two_students()),
            "anna      2 of 2 passed\n"
            "ben & co  0 of 2 passed\n"
            "    a<b: differs: PSNR is 31.20 dB, less than 40; cause: there are no shadows\n"
            "    missing: ball\n"
            "2 students: 2 pictures passed, 1 differs, 1 missing, 0 unreadable\n");
}

TEST(Gradebook, IgnoredFilesAreListedWithTheirReason) {
  Gradebook book = two_students();
  book.ignored = {{"who.png", "", "not known"},
                  {"anna/a.cpp", "anna", "not a picture"},
                  {"anna/b<.zip", "anna", "old"},
                  {"anna/c.cpp", "anna", "not a picture"},
                  {"ben/a.cpp", "ben", "not a picture"}};
  EXPECT_THAT(gradebook_text(book), HasSubstr("    missing: ball\n"
                                              "ignored:\n"
                                              "    who.png: not known\n"
                                              "    anna/a.cpp and 1 more: not a picture\n"
                                              "    anna/b<.zip: old\n"
                                              "    ben/a.cpp: not a picture\n"
                                              "2 students: 2 pictures passed"));
  EXPECT_THAT(gradebook_html(book, "t"),
              AllOf(HasSubstr("<li>anna/a.cpp and 1 more: not a picture</li>"),
                    HasSubstr("<li>anna/b&lt;.zip: old</li>")));
}

TEST(Gradebook, IdenticalFilesAreNotedForTheClass) {
  Gradebook book = two_students();
  book.students.push_back(book.students[0]);
  book.students[2].name = "cleo";
  book.students[0].pictures[0].fingerprint = 1;
  book.students[0].pictures[1].fingerprint = 2;
  book.students[2].pictures[0].fingerprint = 1;
  book.students[2].pictures[1].fingerprint = 1;  // of another reference
  find_identical_files(book);
  EXPECT_EQ(book.students[0].pictures[0].identical, "anna, cleo");
  EXPECT_EQ(book.students[0].pictures[1].identical, "");
  EXPECT_EQ(book.students[1].pictures[0].identical, "");
  EXPECT_EQ(book.students[2].pictures[0].identical, "anna, cleo");
  EXPECT_EQ(book.students[2].pictures[1].identical, "");
  EXPECT_THAT(gradebook_text(book), HasSubstr("identical files:\n    ball: anna, cleo\n3 stud"));
  EXPECT_THAT(gradebook_csv(book), HasSubstr("\"identical files: anna, cleo\""));
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr("<li>ball: anna, cleo</li>"));
  // Pages of students say nothing about others.
  EXPECT_THAT(student_html(book.students[0], "t"), Not(HasSubstr("cleo")));
}

TEST(Gradebook, CsvOfStudents) {
  Gradebook book = two_students();
  book.ignored = {{"a", "ben & co", "b"}, {"c", "", "d"}};
  EXPECT_EQ(students_csv(book),
            "student,score,max_score,differs,missing,unreadable,ignored\r\n"
            "\"anna\",2,2,0,0,0,0\r\n\"ben & co\",0,2,1,1,0,1\r\n");
}

TEST(Gradebook, NamesCannotForgeLines) {
  EXPECT_EQ(gradebook_text({{{"eve\nanna  1 of 1 passed", {}}}}),
            "eve\\nanna  1 of 1 passed  0 of 0 passed\n"
            "1 student: 0 pictures passed, 0 differ, 0 missing, 0 unreadable\n");
}

TEST(Gradebook, HtmlIsSelfContainedAndEscaped) {
  const std::string html = gradebook_html(two_students(), "Ray <1>");
  EXPECT_THAT(html, AllOf(HasSubstr("<title>Ray &lt;1&gt;</title>"), HasSubstr("ben &amp; co"),
                          HasSubstr("a&lt;b"), HasSubstr("data:image/png;base64,UE5H"),
                          HasSubstr("there are no shadows"), HasSubstr("href=\"#p1-1\""),
                          HasSubstr("id=\"p1-1\"")));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("http")), Not(HasSubstr("a<b"))));
  // The page contains only its own script, which follows all text from students.
  EXPECT_EQ(html.find("<script"), html.rfind("<script"));
  EXPECT_GT(html.find("<script"), html.find("</main>"));
}

TEST(Gradebook, NamesCannotInjectScripts) {
  Gradebook book = two_students();
  book.students[1].name = "<script>alert(1)</script>";
  book.students[1].pictures[1].name = "\"><img src=x onerror=alert(1)>";
  const std::string html = gradebook_html(book, "t");
  EXPECT_EQ(html.find("<script"), html.rfind("<script"));
  EXPECT_THAT(html, Not(HasSubstr("<img src=x")));
  EXPECT_THAT(student_html(book.students[1], "t"), Not(HasSubstr("<script")));
}

TEST(Gradebook, PicturesMayBeSeparateFiles) {
  Gradebook book = two_students();
  book.students[1].pictures[1].png.clear();
  book.students[1].pictures[1].png_file = "report-pictures/2-2.png";
  const std::string html = gradebook_html(book, "t");
  EXPECT_THAT(html, HasSubstr("<img loading=\"lazy\" alt=\"reference, picture and difference of "
                              "a&lt;b\" src=\"report-pictures/2-2.png\">"));
  EXPECT_THAT(html, Not(HasSubstr("base64")));
}

TEST(Gradebook, CausesAreCountedForAStudentAndTheClass) {
  Gradebook book = two_students();
  book.students[1].pictures[0].verdict = Verdict::differs;
  book.students[1].pictures[0].causes = book.students[1].pictures[1].causes;
  const std::vector<CauseCount> counts = count_causes(book.students);
  ASSERT_EQ(counts.size(), 1u);
  EXPECT_EQ(counts[0].cause, Cause::shadows);
  EXPECT_EQ(counts[0].pictures, 2u);
  EXPECT_EQ(counts[0].students, 1u);
  const std::string html = gradebook_html(book, "t");
  EXPECT_THAT(html, AllOf(HasSubstr("shadows in 2 of 2"),
                          HasSubstr("shadows: 1 of 2 students, 2 pictures")));
  EXPECT_THAT(student_html(book.students[1], "t"), HasSubstr("shadows in 2 of 2"));
}

TEST(Gradebook, MissingPicturesHaveNoCause) {
  const std::string html = gradebook_html(two_students(), "t");
  EXPECT_THAT(html, AllOf(HasSubstr("shadows in 1 of 1"), HasSubstr("</span>: 1 picture</h3>"),
                          HasSubstr("<span id=\"p1-0\">ball</span>")));
}

TEST(Gradebook, APictureOfAnotherSizeSaysSo) {
  Gradebook book = two_students();
  PictureResult& picture = book.students[1].pictures[1];
  picture.causes.clear();
  picture.measures.size = {800, 600};
  picture.measures.right_size = {1024, 768};
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr("<a href=\"#p1-1\">size</a>"));
}

TEST(Gradebook, NotesStandBesideResultsButAreNoMistakes) {
  Gradebook book = two_students();
  for (PictureResult& picture : book.students[1].pictures) {
    picture.notes = {"four samples <each>"};
  }
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr("Not a mistake: four samples &lt;each&gt;"));
  EXPECT_THAT(gradebook_junit(book), HasSubstr("not a mistake: four samples &lt;each&gt;"));
  book.students[0].pictures[0].notes = {"fine"};
  EXPECT_THAT(student_html(book.students[0], "t"),
              AllOf(HasSubstr("passed"), HasSubstr("Not a mistake: fine")));
}

TEST(Gradebook, AllFilesAreUtf8) {
  Gradebook book = two_students();
  book.students[0].name = "J\xF6rg";
  const std::string name = "J\xEF\xBF\xBDrg";
  EXPECT_THAT(gradebook_csv(book), HasSubstr(name));
  EXPECT_THAT(gradebook_junit(book), HasSubstr(name));
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr(name));
}

TEST(Gradebook, Csv) {
  Gradebook book = two_students();
  book.students[0].name = "=cmd|' /C calc'!A0";
  book.students[0].pictures.resize(1);
  book.students[0].pictures[0].notes = {"fine"};
  EXPECT_EQ(
      gradebook_csv(book),
      "student,picture,verdict,psnr_db,ssim,flip,causes,what,reasons,notes\r\n"
      "\"'=cmd|' /C calc'!A0\",\"ball\",passed,99.00,1.0000,0.0000,\"\",\"\",\"\",\"fine\"\r\n"
      "\"ben & co\",\"ball\",missing,,,,\"\",\"\",\"there is no such picture\",\"\"\r\n"
      "\"ben & co\",\"a<b\",differs,99.00,1.0000,0.0000,\"shadows\",\"there are no shadows\","
      "\"PSNR is 31.20 dB, less than 40\",\"\"\r\n");
}

TEST(Gradebook, Gradescope) {
  EXPECT_EQ(
      gradescope_json({"eve \"x\"", {two_students().students[1].pictures[1]}}),
      "{\n  \"score\": 0,\n  \"output_format\": \"text\",\n  \"tests\": [\n    {\"name\": "
      "\"a<b\", \"number\": \"1\", \"score\": 0, \"max_score\": 1, \"status\": \"failed\", "
      "\"output\": \"PSNR is 31.20 dB, less than 40\\nCause: there are no shadows [shadows]\\n  "
      "because\\n\", \"tags\": [\"shadows\"], \"visibility\": \"visible\"}\n  ]\n}\n");
}

TEST(Gradebook, Junit) {
  EXPECT_THAT(
      gradebook_junit(two_students()),
      AllOf(HasSubstr("<testsuites tests=\"4\" failures=\"2\">"),
            HasSubstr("<testsuite name=\"ben &amp; co\" tests=\"2\" failures=\"2\">"),
            HasSubstr("<testcase classname=\"anna\" name=\"ball\"/>"),
            HasSubstr("<failure type=\"differs\" message=\"PSNR is 31.20 dB, less than 40\">"
                      "cause: there are no shadows (because)\n</failure>")));
}

TEST(Gradebook, Base64) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(Gradebook, MarkupContainsOnlyValidXmlCharacters) {
  EXPECT_EQ(markup("a&\"\x01\n"), "a&amp;&quot;?\n");
}

}  // namespace
}  // namespace scenefile::grade_test
