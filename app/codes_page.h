#pragma once
// All codes on one page.

#include "scenefile/base/diagnostics.h"

#include <string>

namespace scenefile::app {

/// A line a code, for a terminal.
std::string codes_text();
/// "error, sometimes a warning", and what is special about the kind.
std::string severities_text(const Code& code);
/// docs/diagnostics.md.
std::string codes_markdown();

}  // namespace scenefile::app
