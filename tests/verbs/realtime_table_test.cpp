#include "scenefile/verbs/realtime_table.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

namespace scenefile {
namespace {

TEST(RealtimeTable, CellsAreSettings) {
  std::string wrong;
  const std::vector<RealtimeRow> table = read_realtime_table(
      "reference\tremark\tparameter1\tparameter2\tnear\tfar\tfilter\tassignment\r\n"
      "a.png\tnew\t5\t7\t0.5\t20\tblur\taction\r\n\nb.png\t\t\t\t\t\t\t\n",
      wrong);
  EXPECT_EQ(wrong, "");
  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(table[0].reference, "a.png");
  EXPECT_EQ(table[0].panel.tessellation.parameter1, 5);
  EXPECT_EQ(table[0].panel.tessellation.parameter2, 7);
  EXPECT_EQ(table[0].panel.near, 0.5);
  EXPECT_EQ(table[0].panel.far, 20);
  EXPECT_EQ(word_of(table[0].panel.filter), "blur");
  EXPECT_EQ(table[0].panel.milestone, Milestone::action);
  EXPECT_EQ(table[1].panel, RealtimeOptions());
  EXPECT_TRUE(read_realtime_table("scene\treference\na.xml\ta.png\n", wrong).empty());
  EXPECT_EQ(wrong, "");
}

TEST(RealtimeTable, EachWrongCellIsReported) {
  const std::string depths = "near and far are depths above 0, near less than far";
  for (const auto& [column, cell, why] :
       {std::tuple("parameter2", "0", "parameter1 and parameter2 are numbers from 1 to 1024"),
        {"near", "-1", depths.c_str()},
        {"far", "0.001", depths.c_str()},
        {"filter", "blurr", "unknown filter blurr"},
        {"assignment", "Action", "unknown assignment Action"}}) {
    std::string wrong;
    read_realtime_table(
        std::string("reference\tparameter1\t") + column + "\na.png\t5\t" + cell + "\n", wrong);
    EXPECT_EQ(wrong, std::string("line 2: ") + why);
  }
}

}  // namespace
}  // namespace scenefile
