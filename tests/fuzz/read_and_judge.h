#pragma once

#include <string_view>

namespace scenefile::fuzz {

/// Reads the text as a scene with ample and with narrow limits, checks, prepares and writes it, and
/// judges what comes out at each step.
void read_and_judge(std::string_view text);

}  // namespace scenefile::fuzz
