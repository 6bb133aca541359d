#pragma once
// Codes for tests of diagnostics.

#include "scenefile/base/diagnostics.h"

namespace scenefile {

inline constexpr Code odd{"test.odd", Severity::warning, "odd", "help"};
inline constexpr Code bad{"test.bad", Severity::error, "bad", "help"};

}  // namespace scenefile
