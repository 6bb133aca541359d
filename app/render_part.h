#pragma once
// render --part: one part of a picture, into a file that merge takes.

#include "app/load.h"
#include "scenefile/trace/part_file.h"
#include "scenefile/trace/render.h"

#include <cstdint>
#include <string>

namespace scenefile::app {

/// The picture that `options` ask for, to be divided into options.part->count parts.
DividedPicture divided_picture(const Options& options, const LoadedScene& scene);

/// Looks at the file that would be written. `there`: it is this part, whole. What is a part of
/// another picture, or no part at all, is refused; a damaged part counts as none.
Outcome find_part(const Options& options, const DividedPicture& picture, bool& there);

Outcome write_part(const Options& options, const DividedPicture& picture,
                   const RenderResult& result, Context& context);

}  // namespace scenefile::app
