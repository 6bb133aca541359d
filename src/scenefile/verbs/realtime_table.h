#pragma once
// The optional table of settings next to references of the assignment Realtime.

#include "scenefile/base/realtime.h"
#include "scenefile/verbs/grade_files.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Its name in the folder of the references.
inline constexpr std::string_view realtime_table_name = "references.tsv";

struct RealtimeRow {
  std::string scene;      ///< path as written
  std::string reference;  ///< path as written
  RealtimeOptions panel;
};

/// Reads a table with tabs between its columns. The first line names them: scene, reference,
/// assignment (lights-camera or action), parameter1, parameter2, near, far, filter. Other columns
/// are ignored, and so is a table without parameter1. Missing columns and empty cells mean the
/// assignment's defaults. `wrong`: an error message with the line number; empty on success.
std::vector<RealtimeRow> read_realtime_table(std::string_view text, std::string& wrong);

/// The row of a reference, or null.
const RealtimeRow* row_of(const std::vector<RealtimeRow>& table, const FoundFile& reference);

/// The index of the file that a path in the table refers to, or -1.
int file_named(const std::vector<FoundFile>& files, std::string_view path);

/// The scene whose name is a prefix of the reference's name: unit_cone_min shows unit_cone. -1 if
/// there is none.
int scene_of_variant(const FoundFile& reference, const std::vector<FoundFile>& scenes);

}  // namespace scenefile
