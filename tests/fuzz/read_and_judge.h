#pragma once

#include <string_view>

namespace scenefile::fuzz {

/// Reads the text as a scene with high and low limits, checks, prepares and writes it, and verifies
/// the result of each step.
void read_and_judge(std::string_view text);

}  // namespace scenefile::fuzz
