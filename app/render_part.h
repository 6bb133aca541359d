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

/// Looks for an existing output file. `there`: it is this part, and complete. Refuses to replace a
/// part of another picture, or a file that is not a part; a damaged part will be replaced.
Outcome find_part(const Options& options, const DividedPicture& picture, bool& there);

Outcome write_part(const Options& options, const DividedPicture& picture,
                   const RenderResult& result, Context& context);

}  // namespace scenefile::app
