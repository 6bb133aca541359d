#include "scenefile/scene/diff_align.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace scenefile {

namespace {

using Match = std::pair<std::size_t, std::size_t>;  // index in a, index in b
using Places = std::vector<std::size_t>;

// Pairs items with equal keys, the k-th with a key in `a` with the k-th in `b`, in the order of
// `a`. Both lists contain indices in ascending order.
template <typename KeyA, typename KeyB>
std::vector<Match> pair_by(Places a, Places b, KeyA key_a, KeyB key_b) {
  std::stable_sort(a.begin(), a.end(),
                   [&](std::size_t i, std::size_t j) { return key_a(i) < key_a(j); });
  std::stable_sort(b.begin(), b.end(),
                   [&](std::size_t i, std::size_t j) { return key_b(i) < key_b(j); });
  std::vector<Match> matches;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (key_a(a[i]) < key_b(b[j])) {
      ++i;
    } else if (key_b(b[j]) < key_a(a[i])) {
      ++j;
    } else {
      matches.emplace_back(a[i++], b[j++]);
    }
  }
  std::sort(matches.begin(), matches.end());
  return matches;
}

// The longest increasing subsequence of the matches in b: the items that did not move.
std::vector<Match> longest_ascent(const std::vector<Match>& matches) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> last;  // last match of the best subsequence of each length
  std::vector<std::size_t> previous(matches.size(), none);
  for (std::size_t m = 0; m < matches.size(); ++m) {
    const auto at = std::lower_bound(
        last.begin(), last.end(), matches[m].second,
        [&](std::size_t i, std::size_t place) { return matches[i].second < place; });
    if (at != last.begin()) {
      previous[m] = *(at - 1);
    }
    if (at == last.end()) {
      last.push_back(m);
    } else {
      *at = m;
    }
  }
  std::vector<Match> ascent;
  for (std::size_t m = last.empty() ? none : last.back(); m != none; m = previous[m]) {
    ascent.push_back(matches[m]);
  }
  std::reverse(ascent.begin(), ascent.end());
  return ascent;
}

Places all_places(std::size_t count) {
  Places places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  return places;
}

Places free_places(const std::vector<bool>& taken) {
  Places places;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (!taken[i]) {
      places.push_back(i);
    }
  }
  return places;
}

}  // namespace

std::vector<AlignedPair> align(const std::vector<AlignItem>& a, const std::vector<AlignItem>& b) {
  const std::vector<Match> equal = pair_by(
      all_places(a.size()), all_places(b.size()), [&](std::size_t i) { return a[i].hash; },
      [&](std::size_t j) { return b[j].hash; });
  std::vector<AlignedPair> of_a(a.size());
  std::vector<bool> taken_a(a.size());
  std::vector<bool> taken_b(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    of_a[i].a = i;
  }
  for (const auto& [i, j] : equal) {
    of_a[i] = {i, j, true, true};
    taken_a[i] = taken_b[j] = true;
  }
  for (const auto& [i, j] : longest_ascent(equal)) {
    of_a[i].moved = false;
  }
  const std::vector<Match> versions = pair_by(
      free_places(taken_a), free_places(taken_b),
      [&](std::size_t i) -> const std::string& { return a[i].label; },
      [&](std::size_t j) -> const std::string& { return b[j].label; });
  for (const auto& [i, j] : versions) {
    of_a[i].b = j;
    taken_b[j] = true;
  }
  for (const std::size_t j : free_places(taken_b)) {
    of_a.push_back({std::nullopt, j});
  }
  return of_a;
}

}  // namespace scenefile
