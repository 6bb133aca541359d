#include "scenefile/viewer/script.h"

#include <gtest/gtest.h>

namespace scenefile::viewer {

namespace {

TEST(Script, Steps) {
  const Script script = parse_script(
      "# a tour\n\n key Ctrl+S \r\nhold W 10\nwheel -2\ndrop a b.xml\ncopy a b\nframes 3\nsettle\n"
      "screenshot x y.png\nquit");
  EXPECT_EQ(script.wrong, "");
  ASSERT_EQ(script.steps.size(), 9U);
  EXPECT_EQ(script.steps[0].text, "Ctrl+S");
  EXPECT_EQ(script.steps[0].line, 3U);
  EXPECT_EQ(script.steps[1].number, 10);
  EXPECT_EQ(script.steps[2].y, -2);
  EXPECT_EQ(script.steps[3].text, "a b.xml");
  EXPECT_EQ(script.steps[4].other, "b");
  EXPECT_EQ(script.steps[7].text, "x y.png");
  EXPECT_EQ(script.steps[8].kind, StepKind::quit);
}

TEST(Script, ADragIsManySteps) {
  const Script script = parse_script("drag middle 10 20 30 40 2");
  ASSERT_EQ(script.steps.size(), 5U);
  EXPECT_EQ(script.steps[1].kind, StepKind::press);
  EXPECT_EQ(script.steps[1].number, 2);
  EXPECT_EQ(script.steps[2].x, 20);
  EXPECT_EQ(script.steps[3].y, 40);
  EXPECT_EQ(script.steps[4].kind, StepKind::release);
}

TEST(Script, AcceptsTheKeysOfTheWindow) {
  for (const char* line :
       {"key Page Down", "key Ctrl+Q", "key ?", "hold W 3", "hold Shift 2", "key Right"}) {
    EXPECT_EQ(parse_script(line).wrong, "");
  }
}

TEST(Script, InvalidSteps) {
  for (const char* line : {"jump", "frames", "frames 0", "frames x", "wheel 1 2", "move 3",
                           "press thumb", "key", "key Foo", "key PageDown", "hold Foo 3",
                           "key Ctrl+", "screenshot x.jpg", "copy a", "drag left 1 2 3 4"}) {
    const Script script = parse_script("settle\n" + std::string(line) + "\nquit\n");
    EXPECT_EQ(script.wrong, "line 2: this is not a step");
    EXPECT_TRUE(script.steps.empty());
  }
}

}  // namespace

}  // namespace scenefile::viewer
