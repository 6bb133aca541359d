#include "scenefile/base/line_diff.h"

#include <algorithm>

namespace scenefile {

namespace {

using Index = std::ptrdiff_t;
using Same = std::function<bool(std::size_t, std::size_t)>;

struct LinePair {
  std::size_t a = 0;
  std::size_t b = 0;
};

// Searches for a shortest list of edits from one point, a pair of lines, to the end, or, if it is
// long, for its beginning.
class EditSearch {
 public:
  EditSearch(LinePair from, std::size_t size_a, std::size_t size_b, const Same& same)
      : from_(from),
        size_a_(static_cast<Index>(size_a - from.a)),
        size_b_(static_cast<Index>(size_b - from.b)),
        same_(same) {}

  // Appends the pairs of equal lines, the last first, and returns the point.
  LinePair run(std::vector<LinePair>& pairs) {
    Index best = 0;
    const auto progress = [&](Index k) { return 2 * reached(edits(), k) - k; };
    do {
      reached_.emplace_back(2 * reached_.size() + 1, nowhere);
      best = edits();
      for (Index k = -edits(); k <= edits(); k += 2) {
        reached(edits(), k) = follow(k, start(edits(), k));
        if (reached(edits(), k) != nowhere &&
            (reached(edits(), best) == nowhere || progress(k) > progress(best))) {
          best = k;
        }
      }
    } while (progress(best) != size_a_ + size_b_ && edits() != most_edits);
    // The first half of many edits is right in nearly all cases.
    return trace(best, progress(best) == size_a_ + size_b_ ? edits() : edits() / 2, pairs);
  }

 private:
  static constexpr Index most_edits = 100;
  static constexpr Index nowhere = -1;

  Index edits() const { return static_cast<Index>(reached_.size()) - 1; }
  // The furthest line of a on the diagonal k = a - b.
  Index& reached(Index edits, Index k) {
    return reached_[static_cast<std::size_t>(edits)][static_cast<std::size_t>(k + edits)];
  }

  // Where the diagonal is entered with the last of some edits.
  Index start(Index edits, Index k) {
    if (edits == 0) {
      return 0;
    }
    const Index by_removal = k > -edits ? reached(edits - 1, k - 1) : nowhere;
    const Index by_addition = k < edits ? reached(edits - 1, k + 1) : nowhere;
    const bool removable = by_removal != nowhere && by_removal < size_a_;
    const bool addable = by_addition != nowhere && by_addition - k <= size_b_;
    return std::max(removable ? by_removal + 1 : nowhere, addable ? by_addition : nowhere);
  }

  Index follow(Index k, Index a) const {
    while (a != nowhere && a < size_a_ && a - k < size_b_) {
      const LinePair pair = pair_at(k, a);
      if (!same_(pair.a, pair.b)) {
        break;
      }
      ++a;
    }
    return a;
  }

  // Goes back from the diagonal with all edits. Appends the pairs up to the number of edits.
  LinePair trace(Index k, Index most, std::vector<LinePair>& pairs) {
    LinePair end;
    for (Index edits = this->edits(); edits >= 0; --edits) {
      const Index first = start(edits, k);
      if (edits == most) {
        end = pair_at(k, reached(edits, k));
      }
      for (Index a = reached(edits, k); edits <= most && a-- > first;) {
        pairs.push_back(pair_at(k, a));
      }
      const bool removal = edits > 0 && k > -edits && reached(edits - 1, k - 1) != nowhere &&
                           reached(edits - 1, k - 1) + 1 == first;
      k += removal ? -1 : 1;
    }
    return end;
  }

  LinePair pair_at(Index k, Index a) const {
    return {from_.a + static_cast<std::size_t>(a), from_.b + static_cast<std::size_t>(a - k)};
  }

  LinePair from_;
  Index size_a_;
  Index size_b_;
  const Same& same_;
  std::vector<std::vector<Index>> reached_;  // for each number of edits
};

}  // namespace

std::vector<LineChange> line_changes(std::size_t size_a, std::size_t size_b, const Same& same) {
  std::vector<LinePair> pairs;
  for (LinePair at; at.a < size_a || at.b < size_b;) {
    const auto before = static_cast<std::ptrdiff_t>(pairs.size());
    at = EditSearch(at, size_a, size_b, same).run(pairs);
    std::reverse(pairs.begin() + before, pairs.end());
  }
  pairs.push_back({size_a, size_b});
  std::vector<LineChange> changes;
  LinePair at;
  for (const LinePair& pair : pairs) {
    if (at.a != pair.a || at.b != pair.b) {
      changes.push_back({at.a, pair.a - at.a, at.b, pair.b - at.b});
    }
    at = {pair.a + 1, pair.b + 1};
  }
  return changes;
}

std::vector<std::span<const LineChange>> hunks_of(std::span<const LineChange> changes,
                                                  std::size_t context) {
  std::vector<std::span<const LineChange>> hunks;
  for (std::size_t first = 0, next = 0; first < changes.size(); first = next) {
    next = first + 1;
    while (next < changes.size() &&
           changes[next].a - changes[next - 1].a - changes[next - 1].removed <= 2 * context) {
      ++next;
    }
    hunks.push_back(changes.subspan(first, next - first));
  }
  return hunks;
}

void visit_hunk(std::span<const LineChange> hunk, std::size_t context, std::size_t size_a,
                const std::function<void(char, std::size_t, std::size_t)>& visit) {
  const std::size_t before = std::min(hunk.front().a, context);
  std::size_t a = hunk.front().a - before;
  std::size_t b = hunk.front().b - before;
  const auto keep_until = [&](std::size_t end) {
    for (; a < end; ++a, ++b) {
      visit(' ', a, b);
    }
  };
  for (const LineChange& change : hunk) {
    keep_until(change.a);
    for (; a < change.a + change.removed; ++a) {
      visit('-', a, b);
    }
    for (; b < change.b + change.added; ++b) {
      visit('+', a, b);
    }
  }
  keep_until(std::min(a + context, size_a));
}

}  // namespace scenefile
