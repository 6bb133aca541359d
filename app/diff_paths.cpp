#include "app/diff_paths.h"

#include "app/output.h"
#include "app/progress.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace scenefile::app {

namespace {

struct Judged {
  PathVerdict mine;
  std::optional<PathVerdict> reference;
  std::vector<std::string> broken;  // thresholds
};

ExitCode write_pictures_of(const Options& options, const PathTruth& truth, const Texture& mine,
                           const PathVerdict& verdict, Context& context) {
  const Texture map = significance_picture(truth, verdict);
  const Texture right = truth_picture(truth);
  const std::array<const Texture*, 3> sheet{&right, &mine, &map};
  ExitCode status = save_maps(options, map, sheet, context);
  if (!options.energy.empty()) {
    if (const std::string error = error_text(write_file(options.energy, energy_svg(verdict)));
        !error.empty()) {
      say_error(error);
      status = worse(status, ExitCode::environment);
    }
  }
  return status;
}

std::string text_of(const Options& options, std::span<const LoadedPicture> pictures,
                    const Judged& judged) {
  std::string text;
  for (const LoadedPicture& picture : pictures) {
    text +=
        fmt::format("{}{}", text.empty() ? "" : " and ", escaped(shown_name(picture.path), 4096));
  }
  text +=
      fmt::format(", compared with the truth of {}\n", escaped(shown_name(options.scene), 4096));
  if (judged.reference && !judged.reference->right) {
    text += fmt::format("note: the first picture {}\n",
                        judged.reference->too_noisy
                            ? "is too noisy to tell whether it is right"
                            : "differs from the truth of the scene by more than its noise");
    for (const PathClaim& claim : judged.reference->causes) {
      text += fmt::format("note: in the first picture {}\n", claim.what);
    }
  }
  for (const std::string& clause : judged.broken) {
    text += fmt::format("different: {}\n", clause);
  }
  return text + path_verdict_text(judged.mine);
}

std::string json_of(std::span<const LoadedPicture> pictures, const LoadedScene& scene,
                    const Judged& judged, bool same) {
  Json json;
  begin_document(json, "diff");
  for (const LoadedPicture& picture : pictures) {
    add_picture(json, &picture == &pictures.back() ? "b" : "a", picture);
  }
  json.key("scene");
  json.raw(scene_json(scene));
  json.add({{"same", same}, {"broken", judged.broken}});
  json.begin_object("path");
  add_path_verdict(json, judged.mine);
  json.end_object();
  if (judged.reference) {
    json.begin_object("reference_path");
    add_path_verdict(json, *judged.reference);
    json.end_object();
  }
  json.end_object();
  return json.text();
}

}  // namespace

bool are_path_traced(const Options& options, const LoadedScene& scene) {
  return options.render.mode == Mode::path ||
         (may_choose_path_mode(options) && !was_given(options, "--profile") &&
          lit_by_faces_only(scene) && option_without_paths(options).empty());
}

double seconds_of_truth(const Options& options) {
  return options.seconds > 0 ? options.seconds : truth_seconds;
}

Outcome judge_by_truth(const LoadedScene& scene, const Options& options, Context& context,
                       const DecodedPicture& mine, PathTruth& truth, PathVerdict& verdict) {
  context.phase = "comparing the picture with the truth";
  ProgressBar bar(!options.quiet && !options.json && wants_progress());
  const double seconds = seconds_of_truth(options);
  const Progress progress = [&](double done) {
    bar.update(done);
    return true;
  };
  RenderStatus drawn = draw_truth(scene, options.render, seconds, progress, truth);
  if (drawn == RenderStatus::complete) {
    drawn = judge_by_truth(scene, options.render, seconds, progress, mine, truth, verdict);
  }
  return outcome_of(drawn, context);
}

ExitCode diff_paths(Options options, std::span<const LoadedPicture> pictures,
                    const LoadedScene& scene, Context& context) {
  const Texture& mine = pictures.back().picture.texture;
  const Texture& first = pictures.front().picture.texture;
  if (first.width != mine.width || first.height != mine.height) {
    return fail(ExitCode::findings,
                fmt::format("the pictures have {}x{} and {}x{} pixels; path-traced pictures are "
                            "compared only at the same size",
                            first.width, first.height, mine.width, mine.height));
  }
  set_path_mode(options);
  options.render.width = mine.width;
  options.render.height = mine.height;
  PathTruth truth;
  Judged judged;
  if (const Outcome outcome =
          judge_by_truth(scene, options, context, pictures.back().picture, truth, judged.mine);
      !outcome.error.empty()) {
    return fail(outcome);
  }
  if (pictures.size() > 1) {
    judged.reference.emplace();
    const RenderStatus drawn =
        scenefile::judge_by_truth(scene, options.render, seconds_of_truth(options), {},
                                  pictures.front().picture, truth, *judged.reference);
    if (const Outcome outcome = outcome_of(drawn, context); !outcome.error.empty()) {
      return fail(outcome);
    }
    if (options.thresholds != Thresholds()) {
      judged.broken =
          broken_thresholds(options.thresholds, measure(first, mine, options.pixel_threshold));
    }
  }
  const bool same = judged.mine.right && judged.broken.empty();
  const std::string text = options.json    ? json_of(pictures, scene, judged, same)
                           : options.quiet ? std::string()
                                           : text_of(options, pictures, judged);
  return answer_comparison(options, same,
                           write_pictures_of(options, truth, mine, judged.mine, context), text);
}

}  // namespace scenefile::app
