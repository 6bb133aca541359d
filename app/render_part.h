#pragma once
// render --part: draws one part of a picture into a file for merge.

#include "app/load.h"
#include "scenefile/trace/part_file.h"
#include "scenefile/trace/render.h"

#include <cstdint>
#include <string>

namespace scenefile::app {

/// The picture that `options` describe, to be divided into options.part->count parts.
DividedPicture divided_picture(const Options& options, const LoadedScene& scene);

/// Checks an existing output file. `there`: it is this part, and complete. A damaged part will be
/// replaced; a part of another picture, or a file that is not a part, is an error.
Outcome find_part(const Options& options, const DividedPicture& picture, bool& there);

Outcome write_part(const Options& options, const DividedPicture& picture,
                   const RenderResult& result, Context& context);

}  // namespace scenefile::app
