#pragma once
// The codes of the format room by prefix.

#include "scenefile/format/codes.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace scenefile {

/// The codes whose names start with `family`, such as "json.", sorted by name.
inline std::vector<const Code*> codes_of(std::string_view family) {
  std::vector<const Code*> codes;
  for (const Code& code : format_codes) {
    if (code.name.starts_with(family)) {
      codes.push_back(&code);
    }
  }
  std::sort(codes.begin(), codes.end(),
            [](const Code* a, const Code* b) { return a->name < b->name; });
  return codes;
}

}  // namespace scenefile
