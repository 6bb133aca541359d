// docs/mistakes.md is the program's output, and every cause has a page.

#include "app/run_program.h"
#include "scenefile/mistakes/cause_help.h"

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

TEST(MistakesPage, CompletionOffersThem) {
  const std::string words = run_program({"help", "--completion", "bash"}).out;
  EXPECT_THAT(words, HasSubstr(" codes causes limits "));
  std::string names;
  for (std::size_t i = 0; i < cause_count; ++i) {
    names += " " + std::string(name_of(static_cast<Cause>(i)));
  }
  EXPECT_THAT(words, HasSubstr(names + "'"));
}

TEST(MistakesPage, IsAlsoJson) {
  const rapidjson::Document one = parse_json(run_program({"help", "shadows", "--json"}).out);
  EXPECT_STREQ(one["name"].GetString(), "shadows");
  EXPECT_EQ(one["title"].GetString(), help_of(Cause::shadows).title);
  EXPECT_EQ(one["where"].GetString(), help_of(Cause::shadows).where);
  const rapidjson::Document all = parse_json(run_program({"help", "causes", "--json"}).out);
  EXPECT_EQ(all["causes"].Size(), cause_count);
  EXPECT_FALSE(all.HasMember("codes"));
  // "camera" is also a family of codes.
  const rapidjson::Document both = parse_json(run_program({"help", "camera", "--json"}).out);
  ASSERT_EQ(both["causes"].Size(), 1U);
  EXPECT_STREQ(both["causes"][0]["name"].GetString(), "camera");
  EXPECT_GT(both["codes"].Size(), 0U);
}

}  // namespace
}  // namespace scenefile
