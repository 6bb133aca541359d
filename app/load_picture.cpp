#include "app/load_picture.h"

#include "app/load.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/realtime.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/report.h"
#include "scenefile/base/text.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>

namespace scenefile::app {

LoadedPicture load_picture(const PictureInput& input, const std::string& layer, Context& context) {
  context.phase = "reading a picture";
  LoadedPicture loaded;
  loaded.path = input.path;
  Result<DecodedPicture> picture = !input.bytes ? load_picture_file(input.path, layer)
                                   : *input.bytes
                                       ? decode_picture_file(**input.bytes, input.path, layer)
                                       : Result<DecodedPicture>(input.bytes->error());
  if (picture) {
    loaded.picture = *std::move(picture);
  } else {
    loaded.error = picture.error().text;
    loaded.status = exit_code(picture.error().kind);
  }
  return loaded;
}

LoadedScene load_scene_of_pictures(const std::string& path, const Options& options,
                                   Context& context) {
  LoadedScene scene = load_scene(path, options, LoadDepth::with_all_assets, true, context);
  if (!options.json) {
    say(findings_text(scene, Verbosity::errors, wants_color(Stream::chatter)));
    // Without its textures, the scene would not match the reference, and causes would be wrong.
    for (const Diagnostic* const finding : by_place(scene.diagnostics)) {
      if (finding->code->name.starts_with("texture.")) {
        const bool missing = finding->code->name == "texture.missing";
        say(fmt::format("{}: warning: {}{} [{}]\n", escaped(path, 4096),
                        escaped(finding->message, 4096),
                        missing ? "; --asset-root DIR adds its folder" : "", finding->code->name));
      }
    }
  }
  return scene;
}

std::vector<RenderOptions> possible_profiles(const Options& options) {
  if (was_given(options, "--profile")) {
    return {options.render};
  }
  return {render_options(options, Profile::course), render_options(options, Profile::fine)};
}

CompareSettings compare_settings(const Options& options) {
  CompareSettings settings;
  settings.thresholds = options.thresholds;
  settings.pixel_threshold = options.pixel_threshold;
  if (options.realtime) {
    settings.ways = {realtime_way(options.realtime_panel, realtime_unknowns(options))};
    return settings;
  }
  settings.ways = possible_ways(possible_profiles(options), was_given(options, "--features"));
  return settings;
}

PictureComparison compare_loaded(const LoadedPicture& a, const LoadedPicture& b,
                                 const LoadedScene* scene, const Options& options, Context& context,
                                 std::optional<glm::ivec2> asked) {
  context.phase = "comparing the pictures";
  ProgressBar bar(!options.quiet && !options.json && wants_progress());
  CompareSettings settings = compare_settings(options);
  settings.asked = asked;
  settings.lossy = a.picture.jpeg || b.picture.jpeg;
  settings.ways = folder_first(a.path, std::move(settings.ways));
  return compare_pictures(a.picture, b.picture, scene, settings, [&](double done) {
    bar.update(done);
    return true;
  });
}

PictureInput read_ahead(const std::string& path) {
  PictureInput input{path};
  if (path != "-" && !path.starts_with("/dev/") && !path.starts_with("/proc/")) {
    input.bytes = read_file(path, Limits{}.file_bytes);
  }
  return input;
}

bool is_picture(const PictureInput& input) {
  if (!input.bytes || !*input.bytes) {
    return input.bytes && is_picture_name(input.path);
  }
  const std::string& bytes = **input.bytes;
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  const bool markup = start != std::string::npos && (bytes[start] == '<' || bytes[start] == '{');
  return is_image(bytes) || (is_picture_name(input.path) && !markup);
}

ExitCode save_picture(const std::string& path, const Texture& picture, Context& context) {
  context.phase = "writing a picture";
  const Result<std::string> bytes =
      encode_image(to_float(picture), ImageFormat::png8, Rounding::nearest);
  const std::string error =
      bytes ? error_text(write_file(path, *bytes))
            : fmt::format("{}: cannot encode: {}", escaped(path, 4096), bytes.error().text);
  if (!error.empty()) {
    say_error(error);
  }
  return error.empty() ? ExitCode::fine : ExitCode::environment;
}

ExitCode save_maps(const Options& options, const Texture& map,
                   std::span<const Texture* const> sheet, Context& context) {
  ExitCode status = ExitCode::fine;
  if (!options.heatmap.empty()) {
    status = save_picture(options.heatmap, map, context);
  }
  if (!options.sheet.empty()) {
    status = worse(status, save_picture(options.sheet, side_by_side(sheet), context));
  }
  return status;
}

void add_picture(Json& json, std::string_view key, const LoadedPicture& loaded) {
  const DecodedPicture& picture = loaded.picture;
  json.begin_object(key);
  json.add("file", loaded.path);
  if (loaded.error.empty()) {
    json.add({{"width", picture.texture.width},
              {"height", picture.texture.height},
              {"jpeg", picture.jpeg},
              {"transparent", picture.transparent},
              {"not_finite", picture.not_finite}});
  } else {
    json.add("error", loaded.error);
  }
  json.end_object();
}

ExitCode answer_comparison(const Options& options, bool same, ExitCode written,
                           const std::string& text) {
  const ExitCode status = worse(written, same ? ExitCode::fine : ExitCode::findings);
  const bool silent = text.empty() || (options.json && written != ExitCode::fine);
  return silent ? status : worse(status, answer(text));
}

}  // namespace scenefile::app
