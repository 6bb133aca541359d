#pragma once
// The output files of a render.

#include "app/load.h"

#include <string>
#include <vector>

namespace scenefile::app {

/// The paths: the output, and for PNG one for each layer, such as x.depth.png for x.png.
std::vector<std::string> picture_files(const Options& options);

/// A black image in huge pages: allocating it in small pages takes 5 % of the time for rendering a
/// simple picture.
Image canvas(int width, int height);

/// "x.depth.png" of "x.png".
std::string layer_file(const std::string& output, const Layer& layer);

/// Writes all files. In mode path, PNG files are tone-mapped.
Outcome write_pictures(const Options& options, const RenderResult& result, Context& context);

/// Writes a picture whose values are already multiples of 1/255.
Outcome write_8bit_picture(const Options& options, const Image& image, Context& context);

/// Writes intermediate pictures to options.preview; does nothing if that is empty. A failure is
/// reported once and does not stop the render.
Preview preview_of(const Options& options);

}  // namespace scenefile::app
