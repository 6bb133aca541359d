// Output on terminals, and in logs.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

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

struct TerminalOutput : ProgramFolder {};

TEST_F(TerminalOutput, FindingsAreColoredUnlessDisabled) {
  const std::vector<std::string> check{"check", folder.write("s.xml", "<scenefile>")};
  EXPECT_THAT(at_terminal(check).out, HasSubstr("\x1b[1;31merror:\x1b[0m"));
  EXPECT_THAT(at_terminal(check, {"NO_COLOR=1"}).out, Not(HasSubstr("\x1b")));
  EXPECT_THAT(at_terminal(check, {"TERM=dumb"}).out, Not(HasSubstr("\x1b")));
}

TEST_F(TerminalOutput, ProgressIsOnlyShownOnATerminal) {
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

TEST_F(TerminalOutput, LinesOfDiffWrapThere) {
  const std::string scene = folder.write("s.xml", good_scene);
  const std::string reference = folder.path("a.png");
  const std::string mine = folder.path("b.png");
  const std::vector<std::string> draw{"render",    scene,    "--size", "64x48",
                                      "--profile", "course", "-o",     reference};
  ASSERT_EQ(run_program(draw).status, 0);
  std::vector<std::string> normals = draw;
  normals.back() = mine;
  normals.insert(normals.end(), {"--mode", "normals"});
  ASSERT_EQ(run_program(normals).status, 0);
  RunSettings settings;
  settings.environment = plain_environment;
  settings.environment.emplace_back("CI=true");  // no progress bar
  settings.folder = folder.path(".");
  const std::vector<std::string> diff{"diff", "a.png", "b.png", "--scene", "s.xml"};
  const auto longest = [](const std::string& text) {
    std::size_t most = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      most = std::max(most, line.find("try: ") == std::string::npos ? line.size() : 0);
    }
    return most;
  };
  EXPECT_GT(longest(run_program(diff, settings).out), 100U);
  settings.terminal = true;
  settings.columns = 70;
  const std::string wrapped = run_program(diff, settings).out;
  EXPECT_LE(longest(wrapped), 71U) << "with the carriage return";
  EXPECT_THAT(wrapped, HasSubstr("cause: "));
  EXPECT_THAT(wrapped, HasSubstr(" --mine b.png"));
}

}  // namespace

}  // namespace scenefile
