#pragma once
// The codes of the format room by prefix.

#include "scenefile/format/codes.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace scenefile {

/// The codes whose names start with `family`, such as "json.", sorted by name.
inline std::vector<const Code*> codes_of(std::string_view family) {
  std::vector<const Code*> codes(format_codes().begin(), format_codes().end());
  std::erase_if(codes, [&](const Code* code) { return !code->name.starts_with(family); });
  std::sort(codes.begin(), codes.end(),
            [](const Code* a, const Code* b) { return a->name < b->name; });
  return codes;
}

}  // namespace scenefile
