// Output on terminals, and in logs.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<std::string> plain_environment{"TERM=xterm", "CI=", "NO_COLOR="};

ProgramRun at_terminal(const std::vector<std::string>& words,
                       const std::vector<std::string>& more = {}) {
  RunSettings settings;
  settings.terminal = true;
  settings.environment = plain_environment;
  settings.environment.insert(settings.environment.end(), more.begin(), more.end());
  return run_program(words, settings);
}

TEST(Terminal, FindingsAreColoredUnlessDisabled) {
  const TempFolder folder;
  const std::vector<std::string> check{"check", folder.write("s.xml", "<scenefile>")};
  EXPECT_THAT(at_terminal(check).out, HasSubstr("\x1b[1;31merror:\x1b[0m"));
  EXPECT_THAT(at_terminal(check, {"NO_COLOR=1"}).out, Not(HasSubstr("\x1b")));
  EXPECT_THAT(at_terminal(check, {"TERM=dumb"}).out, Not(HasSubstr("\x1b")));
}

TEST(Terminal, ProgressIsOnlyShownOnATerminal) {
  const TempFolder folder;
  const std::string scene = folder.write("s.xml", good_scene);
  const std::vector<std::string> render{"render", scene,    "-o", folder.path("o.png"),
                                        "--size", "200x200"};
  const ProgramRun shown = at_terminal(render);
  EXPECT_EQ(shown.status, 0);
  EXPECT_THAT(shown.out, HasSubstr(" %  "));
  EXPECT_THAT(shown.out, HasSubstr("\r\x1b[K")) << "it goes away";
  for (const std::string variable : {"CI=true", "TERM=dumb"}) {
    EXPECT_THAT(at_terminal(render, {variable}).out, Not(HasSubstr("%"))) << variable;
  }
  for (const std::string option : {"--quiet", "--json"}) {
    std::vector<std::string> words = render;
    words.push_back(option);
    EXPECT_THAT(at_terminal(words).out, Not(HasSubstr("%"))) << option;
  }
}

}  // namespace

}  // namespace scenefile
