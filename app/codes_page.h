#pragma once
// All codes on one page.

#include <string>

namespace scenefile::app {

/// A line a code, for a terminal.
std::string codes_text();
/// docs/diagnostics.md.
std::string codes_markdown();

}  // namespace scenefile::app
