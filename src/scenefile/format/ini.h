#pragma once
// INI files in the dialect of Qt's QSettings, which configure the course's programs.
//
//     ; a comment, also after a value; a line that starts with # is a comment too
//     [Section]
//     key = value           surrounding spaces are ignored
//     key = "a; b"          quotes keep spaces and semicolons
//     key = caf\xe9 \\ \"   escapes, quoted or not: \\ \" \' \? and \x with hexadecimal digits
//
// Internal to format.

#include "scenefile/base/diagnostics.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

struct IniEntry {
  std::string section;  ///< as written; empty before the first section
  std::string key;
  std::string value;  ///< unquoted, with escapes resolved
  Location key_place;
  Location value_place;  ///< where the value starts, even if it is empty
};

/// All valid entries in the order of the file. Reports invalid lines.
std::vector<IniEntry> read_ini(std::string_view text, Diagnostics& diagnostics);

}  // namespace scenefile
