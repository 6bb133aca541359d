#pragma once
// Internal to export.

#include "scenefile/base/diagnostics.h"

#include <string>
#include <string_view>

namespace scenefile {

/// Reports unless the same message was reported before.
void report_once(const Code& code, std::string_view message, Diagnostics& diagnostics);

}  // namespace scenefile
