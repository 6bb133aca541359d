#include "scenefile/gradebook/gradebook.h"

#include "scenefile/base/base64.h"
#include "scenefile/grade/claims.h"
#include "scenefile/gradebook/markup.h"
#include "scenefile/mistakes/cause_help.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::gradebook_test {
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

TEST(Gradebook, NamesAreAlignedByColumns) {
  const std::string cyrillic = "\u0418\u0432\u0430\u043d";
  const std::string wide = "\u3074\u304b";
  EXPECT_THAT(gradebook_text({{{cyrillic, {}}, {wide, {}}, {"eve", {}}}}),
              HasSubstr(cyrillic + "  0 of 0 passed\n" + wide + "  0 of 0 passed\n" +
                        "eve   0 of 0 passed\n"));
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
  const std::string html = gradebook_html(two_students(), "Ray <1>", "2026-11-24");
  EXPECT_THAT(html, AllOf(HasSubstr("<title>Ray &lt;1&gt;</title>"), HasSubstr("ben &amp; co"),
                          HasSubstr("a&lt;b"), HasSubstr("data:image/png;base64,UE5H"),
                          HasSubstr("Graded on 2026-11-24"), HasSubstr("href=#p1-1"),
                          HasSubstr("id=p1-1")));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("http")), Not(HasSubstr("a<b"))));
  // The page contains only its own script, which follows all text from students.
  EXPECT_EQ(html.find("<script"), html.rfind("<script"));
  EXPECT_GT(html.find("<script"), html.find("</main>"));
  EXPECT_THAT(gradebook_html(two_students(), "t"), Not(HasSubstr("Graded on")));
}

TEST(Gradebook, NamesCannotInjectScripts) {
  Gradebook book = two_students();
  book.students[1].name = "<script>alert(1)</script>";
  PictureResult& picture = book.students[1].pictures[1];
  picture.name = "\"'><img src=x onerror=alert(1)>";
  picture.png_file = "javascript:\"'#?%<b>/1.png";
  picture.reasons = {"<script>reason"};
  picture.causes[0].what = "\" onmouseover=\"<script>";
  picture.causes[0].evidence = "<script>";
  picture.rivals = picture.partial = picture.causes;
  book.students[1].unmatched = {"<script>.png"};
  book.students[0].pictures[0].name = picture.name;
  for (const std::string& html : {gradebook_html(book, "</title><script>", "<script>"),
                                  student_html(book.students[1], "t")}) {
    EXPECT_EQ(html.find("<script"), html.rfind("<script"));
    EXPECT_THAT(html, AllOf(Not(HasSubstr("<img src=x")), Not(HasSubstr("\" onmouseover"))));
    EXPECT_THAT(html, HasSubstr("src=\"javascript%3A%22%27%23%3F%25%3Cb%3E/1.png\""));
    EXPECT_THAT(html, HasSubstr("<bdi>&lt;script&gt;alert(1)&lt;/script&gt;</bdi>"));
  }
}

TEST(Gradebook, PicturesMayBeSeparateFiles) {
  Gradebook book = two_students();
  book.students[1].pictures[1].png.clear();
  book.students[1].pictures[1].png_file = "my report-pictures/2-2.png";
  const std::string html = gradebook_html(book, "t");
  EXPECT_THAT(html, HasSubstr("<img loading=lazy alt=\"Enlarge a&lt;b\" "
                              "src=\"my%20report-pictures/2-2.png\">"));
  EXPECT_THAT(html, Not(HasSubstr("base64")));
}

TEST(Gradebook, PicturesThatPassedAreSmall) {
  Gradebook book = two_students();
  PictureResult& picture = book.students[0].pictures[1];
  picture.png = "PNG";
  picture.measures.right_size = {400, 200};
  for (const std::string& html : {gradebook_html(book, "t"), student_html(book.students[0], "t")}) {
    EXPECT_THAT(html, HasSubstr("<img loading=lazy alt=\"\" width=96 height=48 "
                                "src=\"data:image/png;base64,UE5H\"><bdi>ball"));
  }
}

// 150 students with 31 pictures, two of five of which differ, as in tests/student/class.py.
TEST(Gradebook, TheReportOfALargeClassIsSmall) {
  Gradebook book;
  for (int s = 0; s < 150; ++s) {
    StudentResult& student = book.students.emplace_back();
    student.name = "student-" + std::to_string(s);
    for (int p = 0; p < 31; ++p) {
      PictureResult& picture = student.pictures.emplace_back();
      picture.name = "recursive-spheres-" + std::to_string(p);
      picture.png_file = "report-pictures/" + std::to_string(s) + "-" + std::to_string(p) + ".png";
      if ((s + p) % 5 < 2) {
        picture.verdict = Verdict::differs;
        picture.reasons = {"PSNR is 31.20 dB, less than 40"};
        picture.causes = {{static_cast<Cause>((s + p) % 3 + 6), "the term is missing everywhere",
                           evidence_of_one(0.1, 2, 1), 0.99}};
      }
    }
  }
  EXPECT_LT(gradebook_html(book, "t").size(), 2'200'000U);
}

TEST(Gradebook, MistakesAreSentencesWithAPlaceToLook) {
  Gradebook book = two_students();
  const std::string sentence = "<b>There are no shadows</b> <code>shadows</code>";
  const std::string look = "<b>Where to look:</b> " + markup(help_of(Cause::shadows).where);
  for (const std::string& html : {gradebook_html(book, "t"), student_html(book.students[1], "t")}) {
    EXPECT_THAT(html, AllOf(HasSubstr("<p>" + sentence), HasSubstr(look), HasSubstr("because")));
    EXPECT_THAT(html, AllOf(Not(HasSubstr("In part")), Not(HasSubstr("Or: "))));
  }
  // What is not certain says so.
  PictureResult& picture = book.students[1].pictures[1];
  picture.partial.swap(picture.causes);
  picture.rivals = {picture.partial[0]};
  picture.rivals[0].what = "u is mirrored";
  const std::string html = student_html(book.students[1], "t");
  EXPECT_THAT(html, AllOf(HasSubstr("<p>In part: " + sentence), HasSubstr(look),
                          HasSubstr("something else is wrong, too"),
                          HasSubstr("In part: there are no shadows</span> <code>shadows"),
                          HasSubstr("Or: u is mirrored</span> <code>shadows")));
  EXPECT_THAT(html, Not(HasSubstr("<p>" + sentence)));
}

// Only what gives all pictures of the student remains beside the likeliest.
TEST(Gradebook, AlternativesThatDoNotFitAllPicturesAreLeftOut) {
  Gradebook book = two_students();
  std::vector<PictureResult>& pictures = book.students[1].pictures;
  pictures[0] = pictures[1];
  pictures[0].name = "cube";
  pictures[0].causes[0].what =
      "no shadows; or rays too long; or no lights: these give the same picture";
  pictures[0].causes[0].alternatives = {"no shadows", "rays too long", "no lights"};
  pictures[1].causes[0].what = "no shadows; or no lights; or no cubes: these give the same picture";
  pictures[1].causes[0].alternatives = {"no shadows", "no lights", "no cubes"};
  const std::string html = student_html(book.students[1], "t");
  EXPECT_THAT(html, HasSubstr("<b>No shadows</b> <code>shadows</code><br>or no lights<br>"));
  EXPECT_THAT(html, HasSubstr("These give the same picture:</span> <a href=#p0-0>cube"));
  EXPECT_THAT(html, HasSubstr("No shadows; or rays too long; or no lights: these give"));
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr("No shadows, or another mistake <small>"));
  pictures[1].causes[0].what = "no shadows";
  pictures[1].causes[0].alternatives.clear();
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr("<span>No shadows <small>· 2 pictures"));
}

// Words are not searched for what separates alternatives.
TEST(Gradebook, WordsOfOneMistakeStayTogether) {
  Gradebook book = two_students();
  std::string& what = book.students[1].pictures[1].causes[0].what;
  what = "this; or that: these give the same picture";
  EXPECT_THAT(student_html(book.students[1], "t"),
              HasSubstr("<b>this; or that: these give the same picture</b> <code>shadows"));
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
  EXPECT_THAT(
      gradebook_html(book, "t"),
      AllOf(HasSubstr("<span>There are no shadows <small>· 2 pictures</small></span>"),
            Not(HasSubstr("Most common mistake")),
            HasSubstr("<b>Shadows</b> <code>shadows</code> <span class=\"dim\">1 of 2 students, 2 "
                      "pictures</span>"),
            HasSubstr("In</span> <a href=#p1-0>ball</a>, <a href=#p1-1>")));
}

TEST(Gradebook, APictureWithTwoClaimsOfACauseCountsOnce) {
  Gradebook book = two_students();
  std::vector<Claim>& causes = book.students[1].pictures[1].causes;
  causes.push_back(causes[0]);
  causes[1].what = "shadows are gray";
  EXPECT_EQ(count_causes(book.students)[0].pictures, 1u);
  const std::string html = gradebook_html(book, "t");
  EXPECT_THAT(html, AllOf(HasSubstr("<span>There are no shadows <small>· 1 picture</small></span>"),
                          HasSubstr("<b>Shadows are gray</b>")));
  EXPECT_THAT(gradebook_csv(book),
              HasSubstr(",\"shadows\",\"there are no shadows; shadows are gray"));
  EXPECT_THAT(gradescope_json(book.students[1]), HasSubstr("\"tags\": [\"shadows\"]"));
}

TEST(Gradebook, TheSummaryCountsStudentsAndPictures) {
  EXPECT_THAT(gradebook_html(two_students(), "t"),
              AllOf(HasSubstr("<b>1 of 2 students</b> passed everything; <b>1</b> needs"),
                    HasSubstr("<b class=\"missing\">– 1</b> missing")));
  EXPECT_THAT(gradebook_html({{two_students().students[0]}}, "t"),
              AllOf(HasSubstr("<b>1 of 1 student</b> passed everything."),
                    Not(HasSubstr("href=\"#attention\""))));
  EXPECT_THAT(gradebook_html({}, "t"), HasSubstr("<b>0 of 0 students</b>"));
  EXPECT_THAT(student_html(two_students().students[0], "t"),
              HasSubstr("<b>2 of 2 pictures</b> passed"));
}

TEST(Gradebook, AMistakeOfSeveralStudentsIsTheMostCommon) {
  Gradebook book = two_students();
  book.students.push_back(book.students[1]);
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr("Most common mistake: Shadows (2 students)."));
}

TEST(Gradebook, MissingPicturesHaveNoCause) {
  EXPECT_THAT(gradebook_html(two_students(), "t"),
              AllOf(HasSubstr("– 1 picture missing"), HasSubstr("<bdi id=\"p1-0\">ball</bdi>"),
                    HasSubstr("<td class=missing><a href=#p1-0>")));
}

TEST(Gradebook, TheTableSaysWhyWithoutAMistake) {
  Gradebook book = two_students();
  EXPECT_THAT(gradebook_html(book, "t"), Not(HasSubstr("<span>Nothing")));
  book.students[0].pictures[1].measures.size = {48, 36};
  book.students[0].pictures[1].measures.right_size = {64, 48};
  book.students[1].pictures[1] = book.students[1].pictures[0];
  EXPECT_THAT(gradebook_html(book, "t"),
              AllOf(HasSubstr("<span>Wrong size <small>· 1 picture</small></span>"),
                    HasSubstr("<td class=\"mistakes\"><span>Nothing handed in</span></td>")));
  book.ignored = {{"ben & co/a.cpp", "ben & co", "not a picture"}};
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr("<span>Nothing to grade</span>"));
}

TEST(Gradebook, NotesStandBesideResults) {
  Gradebook book = two_students();
  for (PictureResult& picture : book.students[1].pictures) {
    picture.notes = {"four samples <each>"};
  }
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr("Note: four samples &lt;each&gt;"));
  EXPECT_THAT(gradebook_junit(book), HasSubstr("note: four samples &lt;each&gt;"));
  EXPECT_THAT(gradebook_text(book), HasSubstr(": note: four samples <each>\n"));
  EXPECT_THAT(gradescope_json(book.students[1]), HasSubstr("Note: four samples <each>\\n"));
  book.students[0].pictures[0].notes = {"fine"};
  EXPECT_THAT(student_html(book.students[0], "t"),
              AllOf(HasSubstr("passed"), HasSubstr("Note: fine")));
}

TEST(Gradebook, AllFilesAreUtf8) {
  Gradebook book = two_students();
  book.students[0].name = "J\xF6rg";
  const std::string name = "J\\xf6rg";  // other bytes are another name
  EXPECT_THAT(gradebook_csv(book), HasSubstr(name));
  EXPECT_THAT(gradebook_junit(book), HasSubstr(name));
  EXPECT_THAT(gradebook_html(book, "t"), HasSubstr(name));
}

TEST(Gradebook, Csv) {
  Gradebook book = two_students();
  book.students[0].name = "=cmd|' /C calc'!A0";
  book.students[0].pictures.resize(1);
  book.students[0].pictures[0].notes = {"fine"};
  book.students[1].pictures[1].measures.size = {48, 36};
  book.students[1].pictures[1].measures.right_size = {64, 48};
  EXPECT_EQ(
      gradebook_csv(book),
      "student,picture,verdict,size,expected_size,psnr_db,ssim,flip,causes,what,reasons,notes\r\n"
      "\"'=cmd|' /C calc'!A0\",\"ball\",passed,,,99.00,1.0000,0.0000,\"\",\"\",\"\",\"fine\"\r\n"
      "\"ben & co\",\"ball\",missing,,,,,,\"\",\"\",\"there is no such picture\",\"\"\r\n"
      "\"ben & co\",\"a<b\",differs,48x36,64x48,99.00,1.0000,0.0000,\"shadows\",\"there are no "
      "shadows\","
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

TEST(Gradebook, GradescopeGetsUtf8) {
  PictureResult picture = two_students().students[1].pictures[1];
  picture.notes = {"a\xff\n.png was graded"};
  picture.causes[0].evidence = "b\xff";
  EXPECT_THAT(
      gradescope_json({"eve", {picture}}),
      AllOf(HasSubstr(R"(\n  b\\xff\n)"), HasSubstr(R"(Note: a\\xff\\n.png was graded\n)")));
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
  EXPECT_EQ(markup("a&\"'\x01\n"), "a&amp;&quot;&#39;?\n");
}

TEST(Gradebook, LinksContainOnlyPlainCharacters) {
  EXPECT_EQ(link_to("a b-1/x_2.png"), "a%20b-1/x_2.png");
  EXPECT_EQ(link_to("java:\xC3\xA9#?%&\"'<"), "java%3A%C3%A9%23%3F%25%26%22%27%3C");
}

}  // namespace
}  // namespace scenefile::gradebook_test
