#pragma once
// The output files of a render.

#include "app/load.h"
#include "scenefile/trace/render.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile::app {

/// Traces a picture by rays or paths, as `render` says, with the limits of time and messages of
/// `options`. `samples`: set to the number per pixel in mode path.
RenderResult trace_picture(const Options& options, const RenderOptions& render,
                           const LoadedScene& scene, const TraceScene& traced,
                           const Progress& progress, Image canvas = {}, int* samples = nullptr);

/// The paths: the output, and for PNG one for each layer, such as x.depth.png for x.png.
std::vector<std::string> picture_files(const Options& options);

/// A black image in huge pages: allocating it in small pages takes 5 % of the time for rendering a
/// simple picture.
Image canvas(int width, int height);

/// "x.depth.png" of "x.png".
std::string layer_file(const std::string& output, const Layer& layer);

/// What one file of a picture with its layers contains: the picture itself without a name, then the
/// layers.
std::vector<ImageLayer> all_layers(RenderResult result);

/// Writes all files. In mode path, PNG files are tone-mapped. `key`: if not empty, each file is an
/// item with this key (io/item.h).
Outcome write_pictures(const Options& options, const RenderResult& result, Context& context,
                       std::string_view key = {});

/// Writes a picture whose values are already multiples of 1/255.
Outcome write_8bit_picture(const Options& options, const Image& image, Context& context,
                           std::string_view key = {});

}  // namespace scenefile::app
