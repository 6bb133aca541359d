// The command diff: compares two scenes or two pictures.

#include "app/diff_paths.h"
#include "app/load.h"
#include "app/load_picture.h"
#include "app/named_files.h"
#include "app/option_table.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/wrap.h"
#include "scenefile/base/text.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/format/recognize.h"
#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/compare_scenes.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

LoadedScene load(const std::string& path, const Options& options, Context& context) {
  LoadedScene scene = load_scene(path, options, LoadDepth::prepared, true, context);
  if (!options.json) {
    say(findings_text(scene, options.quiet ? Verbosity::errors : Verbosity::warnings,
                      wants_color(Stream::chatter)));
  }
  return scene;
}

// Compares them by meaning.
ExitCode diff_scenes(const Options& options, Context& context) {
  const LoadedScene a = load(options.arguments[0], options, context);
  const LoadedScene b = load(options.arguments[1], options, context);
  Outcome unusable = outcome_of(status_of(a) == ExitCode::fine ? b : a);
  unusable.status = worse(unusable.status, status_of(b));
  if (unusable.status != ExitCode::fine) {
    return options.json ? answer_json(unusable, compare_scenes_json(a, b, nullptr, unusable.error))
                        : unusable.status;
  }
  context.phase = "comparing the scenes";
  const SceneDiff diff = compare_scenes(a, b);
  const ExitCode found = diff.same_meaning ? ExitCode::fine : ExitCode::findings;
  if (options.json) {
    return worse(found, answer(compare_scenes_json(a, b, &diff)));
  }
  return options.quiet
             ? found
             : worse(found, answer(compare_scenes_text(a, b, diff, wants_color(Stream::answer))));
}

std::string heading(const LoadedPicture& a, const LoadedPicture& b) {
  const std::string names = fmt::format("{} and {}", escaped(shown_name(a.path), 4096),
                                        escaped(shown_name(b.path), 4096));
  const Texture& p = a.picture.texture;
  const Texture& q = b.picture.texture;
  return p.width == q.width && p.height == q.height
             ? fmt::format("{}: {}x{}", names, p.width, p.height)
             : fmt::format("{}: {}x{} and {}x{}", names, p.width, p.height, q.width, q.height);
}

std::string remarks_text(const LoadedPicture& a, const LoadedPicture& b) {
  std::string text;
  for (const LoadedPicture* loaded : {&a, &b}) {
    const std::string name = escaped(shown_name(loaded->path), 4096);
    if (loaded->picture.jpeg) {
      text += fmt::format("  {} is a JPEG, which changes colors: compare PNGs\n", name);
    }
    if (loaded->picture.transparent) {
      text += fmt::format("  {}: {}\n", name, transparent_text);
    }
    if (loaded->picture.not_finite > 0) {
      text += fmt::format("  {}: {}\n", name, not_finite_text(loaded->picture));
    }
  }
  return text;
}

std::string measures_text(const PictureMeasures& m, int threshold) {
  if (!m.comparable) {
    return {};
  }
  return fmt::format(
      "{}  PSNR {:.2f} dB, mean difference {:.3f}/255, maximum {:.6g}/255\n"
      "  {:.3f} % of the pixels are off by more than {}/255\n"
      "{}  SSIM {:.4f}, FLIP {:.4f} (maximum {:.4f})\n",
      m.linear ? "  linear values:\n" : "", m.difference.psnr_db, m.difference.mean,
      m.difference.max, 100 * m.difference.share_over, threshold,
      m.linear ? "  as 8-bit pictures:\n" : "", m.ssim, m.flip_mean, m.flip_max);
}

// Explains a pixel of the second picture with what was found.
std::string explain_command(const Options& options, const glm::ivec2& pixel) {
  static constexpr std::string_view same[] = {
      "--profile",    "--features",      "--mode",     "--max-depth",  "--compat",
      "--asset-root", "--allow-outside", "--layer",    "--parameters", "--near",
      "--far",        "--filter",        "--milestone"};
  const auto word = [](const std::string& text) { return escaped(shell_word(text), 4096); };
  std::string command = fmt::format("scenefile explain {} --pixel {},{} --reference {} --mine {}",
                                    word(options.scene), pixel.x, pixel.y,
                                    word(options.arguments[0]), word(options.arguments[1]));
  for (const auto& [row, value] : options.given) {
    if (std::find(std::begin(same), std::end(same), row->name) != std::end(same)) {
      command += fmt::format(" {}", row->name) + (value.empty() ? "" : ' ' + word(value));
    }
  }
  return command;
}

// Wraps long lines for terminals, except commands, which are copied. Elsewhere, a line stays one.
std::string for_terminal(const std::string& text) {
  const std::size_t width = terminal_width(Stream::answer);
  if (width == 0) {
    return text;
  }
  std::string result;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    const bool command = line.find("try: ") != std::string_view::npos;
    result += command ? std::string(line) : wrapped(line, 0, 7, std::max<std::size_t>(width, 40));
    result += '\n';
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
  }
  return result;
}

std::string verdict_text(const PictureComparison& found, const Options& options) {
  if (found.measures.difference.max == 0 && found.measures.comparable && !found.other_size()) {
    return "equal\n";
  }
  std::string text;
  for (const std::string& clause : found.broken) {
    text += fmt::format("different: {}\n", clause);
  }
  return text.empty() ? "the same within the thresholds\n"
                      : text + causes_text(found) + where_text(found, [&](const glm::ivec2& pixel) {
                          return explain_command(options, pixel);
                        });
}

// `scene`: that of --scene, or null. `found`: null if an input cannot be used; `error` then says
// so.
std::string json_text(const LoadedPicture& a, const LoadedPicture& b, const LoadedScene* scene,
                      const PictureComparison* found, const std::string& error = {}) {
  Json json;
  begin_document(json, "diff");
  add_picture(json, "a", a);
  add_picture(json, "b", b);
  if (scene != nullptr) {
    json.key("scene");
    json.raw(scene_json(*scene));
  }
  if (!error.empty()) {
    json.add("error", error);
  }
  if (found != nullptr) {
    add_comparison(json, *found);
  }
  json.end_object();
  return json.text();
}

ExitCode write_maps(const Options& options, const Texture& a, const Texture& b,
                    const PictureComparison& found, Context& context) {
  if (options.heatmap.empty() && options.sheet.empty()) {
    return ExitCode::fine;
  }
  const Texture heat = heat_map(a, b);
  const Texture flip = flip_picture(found.flip_errors, a.width, a.height);
  std::vector<const Texture*> sheet{&a, &b, &heat};
  if (!flip.empty()) {
    sheet.push_back(&flip);
  }
  return save_maps(options, heat, sheet, context);
}

// If one input is a scene, reports that instead of a decoding error.
void report_scene_input(const PictureInput& input, LoadedPicture& loaded,
                        const LoadedPicture& other) {
  if (loaded.status == ExitCode::findings && other.error.empty() && is_scene_name(loaded.path) &&
      input.bytes && *input.bytes && has_scene_parts(**input.bytes)) {
    loaded.error = fmt::format(
        "{} is a scene and {} a picture; compare two scenes, or two pictures and name their scene "
        "with --scene",
        escaped(shown_name(loaded.path), 4096), escaped(shown_name(other.path), 4096));
  }
}

// Why there is nothing to compare the picture with, and where to get it.
std::string missing_reference(const Options& options, const Texture& picture) {
  return options.scene.empty()
             ? "diff needs two pictures, unless the scene is path-traced: scenefile diff A B, or "
               "scenefile diff B --scene SCENE --mode path"
             : fmt::format(
                   "diff needs the reference first; this draws it: scenefile render {} --profile "
                   "course --size {}x{} -o reference.png (a path-traced picture needs none, but "
                   "--mode path)",
                   escaped(shell_word(options.scene), 4096), picture.width, picture.height);
}

// The first one is the reference.
ExitCode diff_images(const Options& options, std::vector<PictureInput> inputs, Context& context) {
  if (const Outcome refused = check_named_outputs(options); refused.status != ExitCode::fine) {
    return fail(refused);
  }
  std::vector<LoadedPicture> pictures;
  for (const PictureInput& input : inputs) {
    pictures.push_back(load_picture(input, options.layer, context));
  }
  LoadedPicture& a = pictures.front();
  LoadedPicture& b = pictures.back();
  if (pictures.size() > 1) {
    report_scene_input(inputs.front(), a, b);
    report_scene_input(inputs.back(), b, a);
  }
  inputs.clear();
  if (const ExitCode status = worse(a.status, b.status); status != ExitCode::fine) {
    for (const LoadedPicture& loaded : pictures) {
      if (!loaded.error.empty()) {
        say_error(loaded.error);
      }
    }
    return options.json ? worse(status, answer(json_text(a, b, nullptr, nullptr, kept_errors())))
                        : status;
  }
  std::optional<LoadedScene> scene;
  if (!options.scene.empty()) {
    scene = load_scene_of_pictures(options.scene, options, context);
    if (const Outcome unusable = outcome_of(*scene); unusable.status != ExitCode::fine) {
      return options.json ? answer_json(unusable, json_text(a, b, &*scene, nullptr, unusable.error))
                          : unusable.status;
    }
    if (are_path_traced(options, *scene)) {
      return diff_paths(options, pictures, *scene, context);
    }
  }
  if (pictures.size() < 2 || options.render.mode == Mode::path) {
    return fail(ExitCode::usage, pictures.size() < 2
                                     ? missing_reference(options, a.picture.texture)
                                     : path_option(options) + " needs the scene: --scene SCENE");
  }
  round_alike(a.picture, b.picture);
  const LoadedScene* const shown = scene ? &*scene : nullptr;
  const PictureComparison found = compare_loaded(a, b, shown, options, context);
  // Prepares the output before writing files, so that nothing can fail afterwards.
  const std::string text = options.json ? json_text(a, b, shown, &found)
                           : options.quiet
                               ? std::string()
                               : heading(a, b) + "\n" + remarks_text(a, b) +
                                     measures_text(found.measures, options.pixel_threshold) +
                                     for_terminal(verdict_text(found, options));
  const ExitCode written = write_maps(options, found.reference_of(a.picture.texture),
                                      found.test_of(b.picture.texture), found, context);
  return answer_comparison(options, found.broken.empty(), written, text);
}

}  // namespace

ExitCode run_diff(const Options& options, Context& context) {
  std::vector<PictureInput> inputs;
  for (const std::string& path : options.arguments) {
    inputs.push_back(read_ahead(path));
  }
  const bool pictures = std::any_of(inputs.begin(), inputs.end(), is_picture);
  if (!pictures && options.arguments.size() < 2) {
    return fail(ExitCode::usage, "diff needs 2 names: scenefile diff A B");
  }
  if (pictures) {
    return diff_images(options, std::move(inputs), context);
  }
  for (const GivenOption& given : options.given) {
    // Scenes are read as by check.
    if ((given.row->commands & for_check) == 0) {
      return fail(ExitCode::usage,
                  fmt::format("{} is for pictures, not for scenes", given.row->name));
    }
  }
  inputs.clear();
  return diff_scenes(options, context);
}

}  // namespace scenefile::app
