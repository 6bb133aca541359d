#include "scenefile/base/diagnostics.h"

#include "base/test_codes.h"

#include <gtest/gtest.h>

namespace scenefile {
namespace {

TEST(Diagnostics, CountsBySeverity) {
  Diagnostics d;
  EXPECT_FALSE(d.has_errors());
  d.report(odd, {1, 2}, "a");
  d.report(bad, {3, 4}, "b");
  d.report(odd, Severity::note, {}, "c");
  EXPECT_TRUE(d.has_errors());
  EXPECT_EQ(d.count(Severity::note), 1u);
  EXPECT_EQ(d.count(Severity::warning), 1u);
  EXPECT_EQ(d.list().size(), 3u);
}

TEST(Diagnostics, KeepsAHundredOfAKindAndCountsTheRest) {
  Diagnostics d;
  for (int i = 0; i < 250; ++i) {
    d.report(odd, {}, "again");
  }
  d.report(bad, {}, "once");
  EXPECT_EQ(d.list().size(), 101u);
  EXPECT_EQ(d.dropped(odd), 150u);
  EXPECT_EQ(d.dropped(bad), 0u);
  EXPECT_EQ(d.dropped(), 150u);
  EXPECT_EQ(d.count(Severity::warning), 250u);
}

TEST(Diagnostics, TheFirstOfAKindSurvivesFullMemory) {
  Limits limits;
  limits.message_bytes = 10;
  Diagnostics d(limits);
  d.report(odd, {}, std::string(100, 'x'));
  d.report(odd, {}, "y");
  d.report(bad, {}, "kept");
  ASSERT_EQ(d.list().size(), 2u);
  EXPECT_EQ(d.list()[1].message, "kept");
  EXPECT_EQ(d.dropped(odd), 1u);
}

TEST(Diagnostics, RewriteChangesKeptAndDroppedAlike) {
  Diagnostics d;
  for (int i = 0; i < 120; ++i) {
    d.report(odd, {}, "again");
  }
  d.report(bad, {}, "b");
  d.rewrite([](const Code& code, Severity severity) -> std::optional<Severity> {
    if (&code == &bad) {
      return std::nullopt;
    }
    return severity == Severity::warning ? Severity::error : severity;
  });
  EXPECT_EQ(d.count(Severity::warning), 0u);
  EXPECT_EQ(d.count(Severity::error), 120u);
  EXPECT_EQ(d.list().size(), 100u);
}

}  // namespace
}  // namespace scenefile
