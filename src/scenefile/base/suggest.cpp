#include "scenefile/base/suggest.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace scenefile {

namespace {

// Longer words are never misspellings of the format's names.
constexpr std::size_t longest_word = 40;
// "camera" for "cameradata"; shorter prefixes are ambiguous.
constexpr std::size_t shortest_start = 5;

bool starts_with_ignoring_case(std::string_view name, std::string_view start) {
  return start.size() <= name.size() &&
         std::equal(start.begin(), start.end(), name.begin(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

// Optimal string alignment distance, ignoring case.
std::size_t edits(std::string_view a, std::string_view b) {
  std::array<std::array<std::size_t, longest_word + 1>, longest_word + 1> d;
  for (std::size_t i = 0; i <= a.size(); ++i) {
    d[i][0] = i;
  }
  for (std::size_t j = 0; j <= b.size(); ++j) {
    d[0][j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t differ = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + differ});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
          lower(a[i - 2]) == lower(b[j - 1])) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

// The number of edits that make `name` of `word`.
std::size_t distance(std::string_view word, std::string_view name) {
  if (equal_ignoring_case(word, name)) {
    return 0;
  }
  const bool cut_short = word.size() >= shortest_start && starts_with_ignoring_case(name, word);
  return cut_short ? 1 : edits(word, name);
}

std::string digits_of(std::string_view word) {
  std::string digits;
  std::copy_if(word.begin(), word.end(), std::back_inserter(digits), is_digit);
  return digits;
}

}  // namespace

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> known) {
  if (word.size() > longest_word) {
    return {};
  }
  std::string_view best;
  std::size_t best_edits = std::max<std::size_t>(word.size(), 3) / 3 + 1;
  for (const std::string_view name : known) {
    if (equal_ignoring_case(word, name)) {
      return name;
    }
    if (name.size() > longest_word || word.size() < 2) {
      continue;
    }
    if (const std::size_t n = distance(word, name); n < best_edits) {
      best = name;
      best_edits = n;
    }
  }
  return best;
}

std::optional<Correction> correction(std::string_view word, std::string_view instead,
                                     std::span<const std::string_view> known) {
  if (instead.empty()) {
    return std::nullopt;
  }
  Correction found{std::string(word), std::string(instead)};
  // A translated name has no distance, and no rival.
  if (!known.empty() && word.size() <= longest_word && instead.size() <= longest_word) {
    const std::size_t least = distance(word, instead);
    const bool rival = std::any_of(known.begin(), known.end(), [&](std::string_view name) {
      return name != instead && name.size() <= longest_word && distance(word, name) <= least;
    });
    found.certain = !rival && digits_of(word) == digits_of(instead);
  }
  return found;
}

}  // namespace scenefile
