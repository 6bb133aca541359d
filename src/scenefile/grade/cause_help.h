#pragma once
// What each cause looks like, why it happens, and where in a student's program to look. No code:
// finding the line is the student's work.

#include "scenefile/grade/causes.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// A page about one cause.
struct CauseHelp {
  Cause cause = Cause::rounding;
  std::string_view title;
  std::string_view looks;  ///< what it looks like
  std::string_view why;    ///< why it happens
  std::string_view where;  ///< where to look
};

const CauseHelp& help_of(Cause cause);

/// The cause of that name (name_of), or nothing.
std::optional<Cause> find_cause(std::string_view name);

/// All pages, as docs/mistakes.md has them.
std::string causes_markdown();

}  // namespace scenefile
