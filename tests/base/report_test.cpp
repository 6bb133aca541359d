#include "scenefile/base/report.h"

#include "base/test_codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string report(const Diagnostics& d, std::string_view text) {
  return report_text(d, "s.xml", text, {});
}

TEST(Report, ExcerptAndCaret) {
  Diagnostics d;
  d.report(bad, {2, 5}, "no such thing");
  EXPECT_EQ(report(d, "first\n\t<b> x\nlast"),
            "s.xml:2:5: error: no such thing [test.bad]\n"
            "    2 |  <b> x\n"
            "      |     ^\n");
}

TEST(Report, InOrderOfPlaceWhateverTheLineEnds) {
  Diagnostics d;
  d.report(bad, {3, 1}, "third");
  d.report(odd, {}, "nowhere");
  d.report(odd, {1, 1}, "first");
  EXPECT_EQ(report(d, "one\r\ntwo\rthree"),
            "s.xml:1:1: warning: first [test.odd]\n    1 | one\n      | ^\n"
            "s.xml:3:1: error: third [test.bad]\n    3 | three\n      | ^\n"
            "s.xml: warning: nowhere [test.odd]\n");
}

TEST(Report, LongLinesAreCutAroundThePlace) {
  Diagnostics d;
  d.report(bad, {1, 500}, "here");
  const std::string text = report(d, std::string(499, 'a') + 'B' + std::string(499, 'c'));
  EXPECT_LT(text.size(), 300u);
  const auto line = text.find("...a") + 3;
  const auto caret = text.find('^');
  EXPECT_EQ(text[caret - (text.rfind('\n', caret) - text.rfind('\n', line))], 'B');
}

TEST(Report, InputCannotForgeALineOrAnEscapeSequence) {
  Diagnostics d;
  d.report(bad, {1, 1}, "x\ns.xml: fine\033[31m\u202e");
  const std::string text = report(d, "\033[2J\u202e");
  EXPECT_THAT(text, Not(HasSubstr("\033")));
  EXPECT_THAT(text, Not(HasSubstr("\u202e")));
  EXPECT_THAT(text, HasSubstr("x\\ns.xml: fine\\u{1b}[31m\\u{202e}"));
}

TEST(Report, OtherFilesGetNoExcerptOfTheScene) {
  Diagnostics d;
  d.add({&bad, Severity::error, {1, 0}, "m.obj", "index 9"});
  EXPECT_EQ(report(d, "scene text"), "m.obj:1: error: index 9 [test.bad]\n");
}

TEST(Report, NotesFollowOnSeparateLines) {
  Diagnostics d;
  d.report(bad, Severity::error, {1, 1}, "no such file", {"looked for a", "looked for b\x1b[1m\n"});
  EXPECT_EQ(report(d, "x"),
            "s.xml:1:1: error: no such file [test.bad]\n"
            "    looked for a\n    looked for b\\u{1b}[1m\\n\n"
            "    1 | x\n      | ^\n");
}

TEST(Report, ColorsOnlyOnRequest) {
  Diagnostics d;
  d.report(bad, {1, 1}, "here");
  EXPECT_THAT(report(d, "x"), Not(HasSubstr("\033")));
  EXPECT_THAT(report_text(d, "s.xml", "x", {.color = true}), HasSubstr("\033[1;31merror:"));
}

TEST(Report, ReportsDroppedFindings) {
  Diagnostics d;
  for (int i = 0; i < 130; ++i) {
    d.report(odd, {}, "again");
  }
  EXPECT_THAT(report(d, ""), HasSubstr("and 30 more of the kind [test.odd]"));
}

TEST(Report, Verdict) {
  Diagnostics d;
  EXPECT_EQ(verdict_text(d, "s.xml"), "s.xml: fine");
  d.report(odd, {}, "");
  EXPECT_EQ(verdict_text(d, "s.xml"), "s.xml: 1 warning");
  d.report(bad, {}, "");
  d.report(bad, {}, "");
  EXPECT_EQ(verdict_text(d, "s.xml"), "s.xml: 2 errors, 1 warning");
}

}  // namespace
}  // namespace scenefile
