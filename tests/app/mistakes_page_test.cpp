// docs/mistakes.md is the program's output, and every cause has a page.

#include "app/run_program.h"
#include "scenefile/grade/cause_help.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

TEST(MistakesPage, IsWhatTheProgramPrints) {
  std::ifstream file(std::string(SCENEFILE_FIXTURES) + "/../../docs/mistakes.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(run_program({"help", "causes", "--markdown"}).out, text);
}

TEST(MistakesPage, EveryCauseHasHelp) {
  const std::string list = run_program({"help", "causes"}).out;
  for (std::size_t i = 0; i < cause_count; ++i) {
    const std::string name(name_of(static_cast<Cause>(i)));
    EXPECT_THAT(list, HasSubstr(name));
    EXPECT_EQ(find_cause(name), static_cast<Cause>(i));
    EXPECT_THAT(run_program({"help", name}).out, HasSubstr("Where to look: "));
  }
  EXPECT_EQ(run_program({"help", "acnee"}).status, 2);
}

}  // namespace
}  // namespace scenefile
