#include "scenefile/base/line_diff.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<LineChange> changes(std::string_view a, std::string_view b) {
  return line_changes(a.size(), b.size(),
                      [&](std::size_t i, std::size_t j) { return a[i] == b[j]; });
}

// The second text, made from the first one and what the changes add.
std::string patched(std::string_view a, std::string_view b,
                    const std::vector<LineChange>& changes) {
  std::string text;
  std::size_t at = 0;
  for (const LineChange& change : changes) {
    text += a.substr(at, change.a - at);
    EXPECT_EQ(text.size(), change.b);
    text += b.substr(change.b, change.added);
    at = change.a + change.removed;
  }
  return text + std::string(a.substr(at));
}

std::size_t count(const std::vector<LineChange>& changes) {
  std::size_t edits = 0;
  for (const LineChange& change : changes) {
    edits += change.removed + change.added;
  }
  return edits;
}

// By the table of all prefixes.
std::size_t fewest_edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t corner = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t edits = a[i - 1] == b[j - 1] ? corner : 1 + std::min(row[j], row[j - 1]);
      corner = std::exchange(row[j], edits);
    }
  }
  return row.back();
}

std::string random_text(std::mt19937& random, std::size_t size, int letters) {
  std::string text(size, ' ');
  for (char& c : text) {
    c = static_cast<char>('a' + static_cast<int>(random() % static_cast<unsigned>(letters)));
  }
  return text;
}

TEST(LineChanges, AreTheRunsThatDiffer) {
  EXPECT_THAT(changes("", ""), IsEmpty());
  EXPECT_THAT(changes("abc", "abc"), IsEmpty());
  EXPECT_THAT(changes("abc", "axc"), ElementsAre(LineChange{1, 1, 1, 1}));
  EXPECT_THAT(changes("abc", "abxyc"), ElementsAre(LineChange{2, 0, 2, 2}));
  EXPECT_THAT(changes("abc", ""), ElementsAre(LineChange{0, 3, 0, 0}));
  EXPECT_THAT(changes("", "ab"), ElementsAre(LineChange{0, 0, 0, 2}));
  EXPECT_THAT(changes("abcdef", "xbcdey"),
              ElementsAre(LineChange{0, 1, 0, 1}, LineChange{5, 1, 5, 1}));
}

TEST(LineChanges, AreTheFewest) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::string a = random_text(random, random() % 30, 1 + i % 5);
    const std::string b = random_text(random, random() % 30, 1 + i % 5);
    const std::vector<LineChange> found = changes(a, b);
    EXPECT_EQ(patched(a, b, found), b);
    EXPECT_EQ(count(found), fewest_edits(a, b)) << a << " " << b;
  }
}

TEST(LineChanges, ManyTakeLittleTime) {
  std::mt19937 random(2);
  const std::string a = random_text(random, 50'000, 20);
  const std::string b = random_text(random, 40'000, 20);
  std::size_t comparisons = 0;
  const std::vector<LineChange> found =
      line_changes(a.size(), b.size(), [&](std::size_t i, std::size_t j) {
        ++comparisons;
        return a[i] == b[j];
      });
  EXPECT_EQ(patched(a, b, found), b);
  EXPECT_LT(comparisons, 50'000'000u);
  // Changes far apart are the fewest also then.
  std::string few = a;
  for (std::size_t i = 25; i < few.size(); i += 50) {
    few[i] = '.';
  }
  EXPECT_EQ(count(changes(a, few)), 2000u);
}

TEST(Hunks, HaveTheirContextOnce) {
  const std::string_view a = "0123456789abcdefghij";
  const std::string_view b = "012345678Xabcdefghij+";
  const auto shown = [&](std::size_t context) {
    std::string text;
    const std::vector<LineChange> found = changes(a, b);
    for (const auto& hunk : hunks_of(found, context)) {
      text += "@";
      visit_hunk(hunk, context, a.size(), [&](char mark, std::size_t i, std::size_t j) {
        text += mark;
        text += mark == '+' ? b[j] : a[i];
      });
    }
    return text;
  };
  EXPECT_EQ(shown(0), "@-9+X@++");
  EXPECT_EQ(shown(2), "@ 7 8-9+X a b@ i j++");
  EXPECT_EQ(shown(5), "@ 4 5 6 7 8-9+X a b c d e f g h i j++");
}

}  // namespace
}  // namespace scenefile
