#pragma once
// All codes on one page.

#include "scenefile/base/diagnostics.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace scenefile::app {

/// A line a code, for a terminal of that width: of all codes, or of a family.
std::string codes_text(std::size_t terminal_width, std::string_view family = {});
/// What stands in front of the points of codes, sorted: "camera" of "camera.look-zero".
std::span<const std::string_view> code_families();
/// "error, sometimes a warning", and what is special about the kind.
std::string severities_text(const Code& code);
/// docs/diagnostics.md.
std::string codes_markdown();

}  // namespace scenefile::app
