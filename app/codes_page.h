#pragma once
// The pages of diagnostic codes.

#include "scenefile/base/diagnostics.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace scenefile::app {

/// "camera" for "camera.look-zero".
std::string_view family_of(const Code& code);
/// One line per code, wrapped for the terminal: all codes, or those of a family.
std::string codes_text(std::size_t terminal_width, std::string_view family = {});
/// The families of all codes, sorted.
std::span<const std::string_view> code_families();
/// "error, sometimes a warning", and properties of its kind.
std::string severities_text(const Code& code);
/// The contents of docs/diagnostics.md.
std::string codes_markdown();

}  // namespace scenefile::app
