#include "scenefile/viewer/actions.h"

#include <gtest/gtest.h>

#include <set>

namespace scenefile::viewer {

namespace {

TEST(Actions, EachKeyAndEachActionOnce) {
  std::set<std::string_view> keys;
  std::set<Action> all;
  for (const ActionRow& row : actions()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_TRUE(all.insert(row.action).second) << row.what;
    EXPECT_EQ(action_of(parse_key(row.key)), &row) << row.key;
    EXPECT_EQ(key_text(parse_key(row.key)), row.key);
  }
  EXPECT_EQ(all.size(), static_cast<std::size_t>(Action::quit) + 1);
}

TEST(Actions, ActionsOfAGroupAreAdjacent) {
  std::set<std::string_view> seen;
  std::string_view group;
  for (const ActionRow& row : actions()) {
    if (row.group != group) {
      EXPECT_TRUE(seen.insert(row.group).second) << row.group;
      group = row.group;
    }
  }
}

TEST(Actions, FlyingKeysHaveNoOtherAction) {
  for (const char* key : {"W", "A", "S", "D", "Q", "E", "Shift+W"}) {
    EXPECT_EQ(action_of(parse_key(key)), nullptr) << key;
  }
}

TEST(Actions, ShiftShowsTheOppositeSideAndNothingElse) {
  EXPECT_EQ(action_of(parse_key("Ctrl+Shift+1"))->action, Action::side_back);
  EXPECT_EQ(action_of(parse_key("?"))->action, Action::help);
  EXPECT_EQ(action_of(parse_key("Shift+R")), nullptr);
  EXPECT_EQ(action_of(parse_key("Ctrl+R")), nullptr);
}

}  // namespace

}  // namespace scenefile::viewer
