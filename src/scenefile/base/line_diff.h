#pragma once
// What changed between two lists of lines (Myers, "An O(ND) difference algorithm"), and its hunks.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace scenefile {

/// The lines [a, a + removed) of the first list became the lines [b, b + added) of the second.
struct LineChange {
  std::size_t a = 0;
  std::size_t removed = 0;
  std::size_t b = 0;
  std::size_t added = 0;

  friend bool operator==(const LineChange&, const LineChange&) = default;
};

/// `same(i, j)`: whether line i of the first list equals line j of the second. The changes are the
/// fewest, or nearly so if there are hundreds. Takes time linear in the number of lines; the factor
/// grows with the number of changes, up to a few hundred.
std::vector<LineChange> line_changes(std::size_t size_a, std::size_t size_b,
                                     const std::function<bool(std::size_t, std::size_t)>& same);

/// Changes that are shown together: there are at most 2 * `context` lines between them.
std::vector<std::span<const LineChange>> hunks_of(std::span<const LineChange> changes,
                                                  std::size_t context);

/// Visits the lines of a hunk in the order of the unified format, with `context` lines around them:
/// visit(mark, i, j), where the mark is ' ', '-' or '+', and i and j are the next lines of the
/// first and second list.
void visit_hunk(std::span<const LineChange> hunk, std::size_t context, std::size_t size_a,
                const std::function<void(char, std::size_t, std::size_t)>& visit);

}  // namespace scenefile
