#include "scenefile/scene/diff_align.h"

#include <algorithm>
#include <deque>
#include <map>
#include <unordered_map>
#include <utility>

namespace scenefile {

namespace {

using Match = std::pair<std::size_t, std::size_t>;  // place in a, place in b

// Equal items, the k-th of its kind in a with the k-th in b, in the order of a.
std::vector<Match> equal_items(const std::vector<AlignItem>& a, const std::vector<AlignItem>& b) {
  std::unordered_map<std::uint64_t, std::deque<std::size_t>> places;
  for (std::size_t i = 0; i < b.size(); ++i) {
    places[b[i].hash].push_back(i);
  }
  std::vector<Match> matches;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto found = places.find(a[i].hash);
    if (found != places.end() && !found->second.empty()) {
      matches.emplace_back(i, found->second.front());
      found->second.pop_front();
    }
  }
  return matches;
}

// The longest part of the matches that ascends in b too: what stayed in its place.
std::vector<Match> longest_ascent(const std::vector<Match>& matches) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> last;  // of the best ascent of each length, into matches
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

// Pairs what is left over by label: equal ones first, then the k-th of a label with the k-th.
class Leftovers {
 public:
  Leftovers(const std::vector<AlignItem>& a, const std::vector<AlignItem>& b,
            const std::vector<Match>& kept)
      : partner_of_a_(a.size(), none), taken_b_(b.size()), kept_b_(b.size()) {
    for (const auto& [in_a, in_b] : kept) {
      take(in_a, in_b);
      kept_b_[in_b] = true;
    }
    for (const auto& [in_a, in_b] : equal_items(a, b)) {
      if (partner_of_a_[in_a] == none && !taken_b_[in_b]) {
        take(in_a, in_b);
      }
    }
    pair_by_label(a, b);
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t partner(std::size_t in_a) const { return partner_of_a_[in_a]; }
  bool taken(std::size_t in_b) const { return taken_b_[in_b]; }
  bool kept(std::size_t in_b) const { return kept_b_[in_b]; }

 private:
  void take(std::size_t in_a, std::size_t in_b) {
    partner_of_a_[in_a] = in_b;
    taken_b_[in_b] = true;
  }

  void pair_by_label(const std::vector<AlignItem>& a, const std::vector<AlignItem>& b) {
    std::map<std::string, std::deque<std::size_t>> free;
    for (std::size_t i = 0; i < b.size(); ++i) {
      if (!taken_b_[i]) {
        free[b[i].label].push_back(i);
      }
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto found = free.find(a[i].label);
      if (partner_of_a_[i] == none && found != free.end() && !found->second.empty()) {
        take(i, found->second.front());
        found->second.pop_front();
      }
    }
  }

  std::vector<std::size_t> partner_of_a_;
  std::vector<bool> taken_b_;
  std::vector<bool> kept_b_;
};

}  // namespace

std::vector<AlignedPair> align(const std::vector<AlignItem>& a, const std::vector<AlignItem>& b) {
  const Leftovers pairs(a, b, longest_ascent(equal_items(a, b)));
  std::vector<AlignedPair> aligned;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t j = pairs.partner(i);
    if (j == Leftovers::none) {
      aligned.push_back({i, std::nullopt});
      continue;
    }
    const bool equal = a[i].hash == b[j].hash;
    aligned.push_back({i, j, equal, equal && !pairs.kept(j)});
  }
  for (std::size_t j = 0; j < b.size(); ++j) {
    if (!pairs.taken(j)) {
      aligned.push_back({std::nullopt, j});
    }
  }
  return aligned;
}

}  // namespace scenefile
