#pragma once
// The files that a render leaves.

#include "app/load.h"

#include <string>
#include <vector>

namespace scenefile::app {

/// Their names: the output, and for a PNG one of each layer, x.png giving x.depth.png.
std::vector<std::string> picture_files(const Options& options);

/// A black image, in large pages: to give out one in small pages takes the system as long as
/// tracing a twentieth of a simple picture.
Image canvas(int width, int height);

/// "x.depth.png" of "x.png".
std::string layer_file(const std::string& output, const Layer& layer);

/// Writes them all.
Outcome write_pictures(const Options& options, const RenderResult& result, Context& context);

/// Writes one whose values are already those of 8-bit pixels.
Outcome write_8bit_picture(const Options& options, const Image& image, Context& context);

/// Writes pictures on the way to options.preview; does nothing where that is empty. A failure is
/// said once and stops nothing.
Preview preview_of(const Options& options);

}  // namespace scenefile::app
