#pragma once
// The table of settings that may lie beside references of the assignment Realtime.

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
/// assignment (lights-camera or action), parameter1, parameter2, near, far, filter. Others are
/// ignored, and so is a table without parameter1; missing ones and empty cells have the
/// assignment's defaults. `wrong`: an error text with the number of the line; empty: success.
std::vector<RealtimeRow> read_realtime_table(std::string_view text, std::string& wrong);

/// The row of a reference, or null.
const RealtimeRow* row_of(const std::vector<RealtimeRow>& table, const FoundFile& reference);

/// The index of the file that a path of the table names, or -1.
int file_named(const std::vector<FoundFile>& files, std::string_view path);

/// The scene whose name the reference's begins with, as unit_cone_min shows unit_cone; -1: none.
int scene_of_variant(const FoundFile& reference, const std::vector<FoundFile>& scenes);

}  // namespace scenefile
