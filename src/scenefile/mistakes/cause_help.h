#pragma once
// A help page for each cause: what it looks like, why it happens, and where to look in a student's
// program. Without code, because students should find the line themselves.

#include "scenefile/mistakes/cause.h"
#include "scenefile/mistakes/views.h"

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

/// The cause with that name (name_of), or nullopt.
std::optional<Cause> find_cause(std::string_view name);

/// All pages, as in docs/mistakes.md.
std::string causes_markdown();

}  // namespace scenefile
