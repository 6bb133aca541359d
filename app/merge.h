#pragma once
// The two kinds of work of the command merge.

#include "app/load.h"
#include "scenefile/trace/part_set.h"

#include <span>
#include <string>

namespace scenefile::app {

/// Writes and prints what grade would for the whole class. `set` must be complete; `paths` are its
/// files.
ExitCode merge_class(const Options& options, const SortedParts& set,
                     std::span<const std::string> paths, Context& context);

/// Writes options.output and the files of the layers while reading, band by band. The candidates
/// must be complete (sort_parts()); `paths` are their files.
Outcome merge_picture(const Options& options, std::span<const PartCandidate> candidates,
                      std::span<const std::string> paths, Context& context);

}  // namespace scenefile::app
