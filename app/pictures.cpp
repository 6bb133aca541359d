#include "app/pictures.h"

#include "app/output.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"
#include "scenefile/io/item.h"
#include "scenefile/io/memory.h"
#include "scenefile/path/render_path.h"
#include "scenefile/trace/layers.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace scenefile::app {

namespace {

ImageFormat format_of(const std::string& path) {
  return image_format_of(path).value_or(ImageFormat::png8);
}

LayerStorage storage_of(const Options& options) {
  return layer_storage(format_of(options.output));
}

FileNote note_of(std::string_view key) {
  return {key.empty() ? std::string() : item_text(key)};
}

Outcome write(const std::string& path, Result<std::string> bytes, std::string_view key,
              Context& context) {
  if (!bytes) {
    return {ExitCode::environment, "cannot encode the picture: " + bytes.error().text};
  }
  context.phase = "writing the picture";
  if (!key.empty()) {
    seal_item(*bytes);
    renew_png_text(*bytes);
  }
  return outcome_of(write_file(path, *bytes));
}

// What the file gets of a picture: that of mode path is linear, and only some formats store it.
const Image& shown_in(const std::string& path, const Image& image, const Options& options,
                      Image& toned) {
  const ImageFormat format = format_of(path);
  const bool linear = format == ImageFormat::exr || format == ImageFormat::pfm;
  if (options.render.mode != Mode::path || linear) {
    return image;
  }
  toned = tone_mapped(image, options.tone, options.exposure);
  return toned;
}

Outcome write_image(const std::string& path, const Image& image, Rounding rounding,
                    std::string_view key, Context& context) {
  context.phase = "encoding the picture";
  return write(path, encode_image(image, format_of(path), rounding, note_of(key)), key, context);
}

Outcome write_in_one(const Options& options, const RenderResult& result, std::string_view key,
                     Context& context) {
  context.phase = "encoding the picture";
  return write(
      options.output,
      encode_layers(result.image.width, result.image.height, all_layers(result), note_of(key)), key,
      context);
}

}  // namespace

Image canvas(int width, int height) {
  Image image;
  image.width = width;
  image.height = height;
  const std::size_t count = std::size_t{3} * width * height;
  image.rgb.reserve(count);
  ask_for_large_pages(image.rgb.data(), count * sizeof(float));
  image.rgb.resize(count);
  return image;
}

RenderResult trace_picture(const Options& options, const RenderOptions& render_options,
                           const LoadedScene& scene, const TraceScene& traced,
                           const Progress& progress, Image canvas, int* samples) {
  const RenderScene& ready = scene.ready.scene;
  if (render_options.mode != Mode::path) {
    return render(ready, scene.assets, render_options,
                  {.progress = progress, .canvas = std::move(canvas), .traced = &traced});
  }
  PathResult path =
      render_path(ready, scene.assets, render_options,
                  {.progress = progress, .seconds = options.seconds, .traced = &traced});
  if (samples != nullptr) {
    *samples = static_cast<int>(path.samples);
  }
  if (path.state.dropped > 0 && !options.quiet) {
    say(fmt::format("warning: {} sample{} not finite; their light is missing\n", path.state.dropped,
                    path.state.dropped == 1 ? " was" : "s were"));
  }
  return std::move(static_cast<RenderResult&>(path));
}

std::string layer_file(const std::string& output, const Layer& layer) {
  const std::size_t point = output.rfind('.');
  return fmt::format("{}.{}{}", output.substr(0, point), layer_name(layer), output.substr(point));
}

std::vector<std::string> picture_files(const Options& options) {
  std::vector<std::string> files{options.output};
  for (const Layer& layer : options.render.layers) {
    if (storage_of(options) == LayerStorage::apart) {
      files.push_back(layer_file(options.output, layer));
    }
  }
  return files;
}

std::vector<ImageLayer> all_layers(RenderResult result) {
  std::vector<ImageLayer> layers{{"", {"R", "G", "B"}, false, std::move(result.image.rgb)}};
  layers.insert(layers.end(), std::make_move_iterator(result.layers.begin()),
                std::make_move_iterator(result.layers.end()));
  return layers;
}

Outcome write_pictures(const Options& options, const RenderResult& result, Context& context,
                       std::string_view key) {
  if (!options.render.layers.empty() && storage_of(options) == LayerStorage::together) {
    return write_in_one(options, result, key, context);
  }
  Image toned;
  const Image& image = shown_in(options.output, result.image, options, toned);
  Outcome outcome =
      write_image(options.output, image, rounding_of(options.render.profile), key, context);
  const int max_depth = options.render.max_depth;
  for (std::size_t i = 0; i < result.layers.size() && outcome.error.empty(); ++i) {
    const Layer& layer = options.render.layers[i];
    Image picture = layer_picture(layer, result.layers[i], image.width, image.height, max_depth);
    if (is_path_light(layer.kind)) {
      map_tones(picture.rgb, options.tone, options.exposure,
                brightest(result.image.rgb, options.exposure));
    }
    outcome =
        write_image(layer_file(options.output, layer), picture, Rounding::nearest, key, context);
  }
  return outcome;
}

Outcome write_8bit_picture(const Options& options, const Image& image, Context& context,
                           std::string_view key) {
  return write_image(options.output, image, Rounding::nearest, key, context);
}

}  // namespace scenefile::app
