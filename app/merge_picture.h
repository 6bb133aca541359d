#pragma once
// merge, for parts of a picture: merges them while reading, band by band.

#include "app/load.h"
#include "scenefile/trace/part_set.h"

#include <span>
#include <string>

namespace scenefile::app {

/// Writes options.output and the files of the layers. The candidates must be complete
/// (sort_parts()); `paths` are their files.
Outcome merge_picture(const Options& options, std::span<const PartCandidate> candidates,
                      std::span<const std::string> paths, Context& context);

}  // namespace scenefile::app
