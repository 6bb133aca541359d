#pragma once
// merge, for parts of a class.

#include "app/command.h"
#include "scenefile/trace/part_set.h"

#include <span>
#include <string>

namespace scenefile::app {

/// Writes and prints what grade would for the whole class. `set` must be complete; `paths` are its
/// files.
ExitCode merge_class(const Options& options, const SortedParts& set,
                     std::span<const std::string> paths, Context& context);

}  // namespace scenefile::app
