#pragma once
// merge, for parts of a class.

#include "app/command.h"
#include "scenefile/trace/part_set.h"

#include <span>
#include <string>

namespace scenefile::app {

/// Writes and prints what grade does for the whole class. `set` is complete; `paths` are those of
/// its files.
ExitCode merge_class(const Options& options, const SortedParts& set,
                     std::span<const std::string> paths, Context& context);

}  // namespace scenefile::app
