#pragma once
// The scene graph as a list of lines, as a tree view shows it.

#include "scenefile/scene/prepare.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace scenefile::viewer {

enum class RowKind : std::uint8_t { camera, light, group, copy, primitive, templates };

/// One line. What it holds follows it, up to `end`.
struct OutlineRow {
  RowKind kind = RowKind::group;
  std::uint32_t depth = 0;
  std::uint32_t end = 0;     ///< index of the first row that is not inside this one
  std::uint32_t parent = 0;  ///< index; of itself at the top
  std::string label{};       ///< what the author called it, or what it is
  std::string detail{};      ///< such as the file of a mesh, or the type of a light; may be empty
  Location location{};
  std::uint32_t source = no_index;  ///< of primitives, copies and lights that are drawn
};

struct Outline {
  std::vector<OutlineRow> rows;
  std::vector<std::uint32_t> row_of_source;  ///< by source; no_index: none
};

/// The camera first, then the root with its lights, objects and groups, then the templates.
Outline make_outline(const Scene& scene, const Prepared& ready);

/// Where the rows of a version of a scene are in another: for each row of `before` its index in
/// `after`, no_index where it is gone. Rows are the same when their parents are, and kind and
/// label, counted among those that are equal in these; with the same detail before others.
std::vector<std::uint32_t> match_rows(const Outline& before, const Outline& after);

/// Indices of the rows that show when `open` rows show what they hold.
std::vector<std::uint32_t> visible_rows(const Outline& outline,
                                        const std::set<std::uint32_t>& open);

/// The sources of a row and of all that it holds; not through copies.
std::set<std::uint32_t> sources_in(const Outline& outline, std::uint32_t row);

/// Whether there is any; found at the first one.
bool has_sources(const Outline& outline, std::uint32_t row);

/// The rows around a row, outermost first: what must be open for it to show.
std::vector<std::uint32_t> rows_around(const Outline& outline, std::uint32_t row);

}  // namespace scenefile::viewer
