// Manual pages and shell completion, which are generated from the tables of the help.

#include "app/run_program.h"
#include "io/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <memory>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// Commands and their options, as `help --json` lists them.
std::vector<std::pair<std::string, std::vector<std::string>>> commands() {
  const auto document = parse_json(run_program({"help", "--json"}).out);
  std::vector<std::pair<std::string, std::vector<std::string>>> result;
  for (const auto& command : document["commands"].GetArray()) {
    auto& [name, options] = result.emplace_back();
    name = command["name"].GetString();
    for (const auto& option : command["options"].GetArray()) {
      options.emplace_back(option["name"].GetString());
    }
  }
  return result;
}

std::string with_escaped_hyphens(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '-' ? "\\-" : std::string(1, c);
  }
  return result;
}

TEST(Manual, HasAPageForEachCommandWithAllItsOptions) {
  const std::string overview = run_program({"help", "--man"}).out;
  EXPECT_THAT(overview, StartsWith(".TH SCENEFILE 1 "));
  ASSERT_GE(commands().size(), 11u);
  for (const auto& [command, options] : commands()) {
    EXPECT_THAT(overview, HasSubstr("\\fBscenefile\\-" + command + "\\fR(1)"));
    const ProgramRun page = run_program({"help", "--man", command});
    EXPECT_EQ(page.status, 0);
    EXPECT_THAT(page.out, HasSubstr(".SH NAME\nscenefile\\-" + command + " \\- "));
    for (const std::string& option : options) {
      EXPECT_THAT(page.out, HasSubstr("\\fB" + with_escaped_hyphens(option) + "\\fR"))
          << command << " " << option;
    }
  }
}

TEST(Manual, EscapesTextThatRoffWouldReadAsRequests) {
  for (const auto& [command, options] : commands()) {
    const std::string page = run_program({"help", "--man", command}).out;
    for (std::size_t at = page.find('\n'); at != std::string::npos; at = page.find('\n', at + 1)) {
      if (at + 1 < page.size() && page[at + 1] == '\'') {
        ADD_FAILURE() << command << ": a line starts with an apostrophe";
      }
    }
    EXPECT_THAT(page, Not(HasSubstr("\n.png"))) << command;
  }
}

// The completions that bash offers for the last word.
std::string proposals(const std::string& words) {
  const TempFolder folder;
  const std::string script = folder.path("completion.bash");
  std::ofstream(script) << run_program({"help", "--completion", "bash"}).out;
  const std::string command = "bash --norc -c 'source " + script + "; COMP_WORDS=(" + words +
                              "); COMP_CWORD=$((${#COMP_WORDS[@]}-1)); _scenefile 2>/dev/null; "
                              "echo \"${COMPREPLY[*]}\"'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::array<char, 20000> said{};
  const std::size_t bytes = fread(said.data(), 1, said.size(), pipe.get());
  return std::string(said.data(), bytes);
}

TEST(Completion, ProposesInBash) {
  EXPECT_EQ(proposals("scenefile rend"), "render\n");
  EXPECT_EQ(proposals("scenefile render --prof"), "--profile\n");
  EXPECT_THAT(proposals("scenefile render --profile \"\""), HasSubstr("course fine"));
  EXPECT_EQ(proposals("scenefile convert --to js"), "json\n");
  EXPECT_EQ(proposals("scenefile help camera.up-z"), "camera.up-zero\n");
  EXPECT_EQ(proposals("scenefile check --heat"), "\n");
}

TEST(Completion, CompletesTheLastWordOfAList) {
  EXPECT_EQ(proposals("scenefile render --features shadows,ref"),
            "shadows,reflect shadows,refract\n");
}

TEST(Completion, OffersEveryOptionInEveryShell) {
  const std::string zsh = run_program({"help", "--completion", "zsh"}).out;
  const std::string fish = run_program({"help", "--completion", "fish"}).out;
  const std::string bash = run_program({"help", "--completion", "bash"}).out;
  for (const auto& [command, options] : commands()) {
    for (const std::string& option : options) {
      EXPECT_THAT(bash, HasSubstr(option)) << command;
      EXPECT_THAT(zsh, HasSubstr("'" + option + "[")) << command;
      EXPECT_THAT(fish,
                  HasSubstr("__fish_seen_subcommand_from " + command + "' -l " + option.substr(2)))
          << command;
    }
  }
}

TEST(Completion, RejectsOtherShells) {
  const ProgramRun run = run_program({"help", "--completion", "tcsh"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("bash"));
}

}  // namespace

}  // namespace scenefile
