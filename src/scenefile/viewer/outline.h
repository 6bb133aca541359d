#pragma once
// The scene graph as the rows of a tree view.

#include "scenefile/scene/prepare.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace scenefile::viewer {

enum class RowKind : std::uint8_t { globals, camera, light, group, copy, primitive, templates };

/// A row. Its contents follow it, up to `end`.
struct OutlineRow {
  RowKind kind = RowKind::group;
  std::uint32_t depth = 0;
  std::uint32_t end = 0;     ///< index of the first row after its contents
  std::uint32_t parent = 0;  ///< index; of the row itself at the top level
  std::string label{};       ///< its name, or what it is
  std::string detail{};      ///< such as the file of a mesh, or the type of a light; may be empty
  Location location{};
  std::uint32_t source = no_index;  ///< of primitives, instances and lights that are drawn
};

struct Outline {
  std::vector<OutlineRow> rows;
  std::vector<std::uint32_t> row_of_source;  ///< by source; no_index: none
};

/// Global data and the camera, then the root with its lights, objects and groups, then the
/// templates.
Outline make_outline(const Scene& scene, const Prepared& ready);

/// Matches the rows of two versions of a scene: for each row of `before` its index in `after`,
/// no_index if it no longer exists. Rows match if their parents match, with the same kind and label
/// and the same position among those; rows with equal details are matched first.
std::vector<std::uint32_t> match_rows(const Outline& before, const Outline& after);

/// Indices of the visible rows, where `open` rows show their contents.
std::vector<std::uint32_t> visible_rows(const Outline& outline,
                                        const std::set<std::uint32_t>& open);

/// The sources of a row and all its contents; does not enter instances.
std::set<std::uint32_t> sources_in(const Outline& outline, std::uint32_t row);

/// Whether sources_in() is not empty; stops at the first.
bool has_sources(const Outline& outline, std::uint32_t row);

/// The ancestors of a row, outermost first, which must be open to show it.
std::vector<std::uint32_t> rows_around(const Outline& outline, std::uint32_t row);

}  // namespace scenefile::viewer
