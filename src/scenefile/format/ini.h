#pragma once
// INI files in the dialect of Qt's QSettings, which the course's programs are configured with.
//
//     ; a comment, also behind a value; a line that starts with # is one too
//     [Section]
//     key = value           blanks around both do not count
//     key = "a; b"          quotes keep blanks and semicolons
//     key = caf\xe9 \\ \"   escapes, quoted or not: \\ \" \' \? and \x with hexadecimal digits
//
// Private to the room.

#include "scenefile/base/diagnostics.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

struct IniEntry {
  std::string section;  ///< as written; empty before the first section
  std::string key;
  std::string value;  ///< unquoted, escapes resolved
  Location key_place;
  Location value_place;  ///< where the value starts, or would
};

/// All entries in the order of the file, those with mistakes left out; these are reported.
std::vector<IniEntry> read_ini(std::string_view text, Diagnostics& diagnostics);

}  // namespace scenefile
