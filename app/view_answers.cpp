#include "app/view_answers.h"

#include "app/diff_paths.h"
#include "app/load_picture.h"
#include "scenefile/verbs/compare_paths.h"
#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/explain.h"
#include "scenefile/verbs/render_error.h"

#include <new>

namespace scenefile::app {

namespace {

// A copy, since the window keeps using the original.
LoadedScene loaded_of(const viewer::OpenedScene& opened) {
  LoadedScene scene;
  scene.path = opened.path;
  scene.written = opened.written;
  scene.ready = opened.ready;
  scene.assets = opened.assets;
  return scene;
}

DrawnWay way_of(const viewer::CauseQuestion& question) {
  if (question.realtime) {
    return realtime_way(
        *question.realtime,
        {.parameters = false, .near = false, .far = false, .filter = false, .milestone = false});
  }
  return {question.options, options_text(question.options)};
}

// The ways in which the picture may have been drawn. A mistake may look like a missing feature:
// only a reference may lack features, or a picture in a folder of a project without them.
std::vector<DrawnWay> ways_to_fit(const viewer::FitQuestion& question, const Options& options) {
  const std::vector<DrawnWay> all = compare_settings(options).ways;
  std::vector<DrawnWay> ways = folder_first(question.path, all);
  if (!question.is_reference && !options.realtime) {
    ways.resize(ways.front().words == all.front().words ? 0 : 1);
    for (DrawnWay& way : possible_ways(possible_profiles(options), true)) {
      ways.push_back(std::move(way));
    }
  }
  return ways;
}

DrawnWay fitting_way(const viewer::FitQuestion& question, const LoadedScene& scene,
                     const Options& options) {
  const Texture& picture = question.picture->texture;
  const std::vector<DrawnWay> ways = ways_to_fit(question, options);
  if (ways.size() == 1 && !ways.front().realtime && !question.is_reference) {
    return ways.front();
  }
  const DrawnWay way = ways_drawn(picture, scene, ways).front();
  if (way.realtime) {
    return way;
  }
  // The profile of a wrong picture is a guess; its samples are not worth one.
  ReferenceWay exact = reference_way(picture, scene, way, ways);
  return question.is_reference || exact.exactly ? std::move(exact.way) : way;
}

// Against the truth, as `diff`; a reference would have noise of its own.
viewer::CauseAnswer judge_paths(const viewer::CauseQuestion& question, const LoadedScene& scene,
                                double seconds, const std::function<bool()>& go_on) {
  RenderOptions options = question.options;
  options.width = question.mine->texture.width;
  options.height = question.mine->texture.height;
  PathTruth truth;
  PathVerdict verdict;
  const Progress progress = [&](double) { return go_on(); };
  RenderStatus drawn = draw_truth(scene, options, seconds, progress, truth);
  if (drawn == RenderStatus::complete) {
    drawn = judge_by_truth(scene, options, seconds, progress, *question.mine, truth, verdict);
  }
  if (const std::optional<Error> error = render_error(drawn)) {
    return {error->text + '\n'};
  }
  if (drawn == RenderStatus::cancelled) {
    return {};
  }
  return {path_verdict_text(verdict)};
}

viewer::CauseAnswer find_cause(const viewer::CauseQuestion& question, const Options& options,
                               const std::function<bool()>& go_on) {
  const LoadedScene scene = loaded_of(*question.scene);
  if (!question.realtime && question.options.mode == Mode::path) {
    return judge_paths(question, scene, seconds_of_truth(options), go_on);
  }
  DecodedPicture reference;
  DecodedPicture mine = *question.mine;
  CompareSettings settings;
  settings.ways = {way_of(question)};
  if (question.reference != nullptr) {
    reference = *question.reference;
    if (!question.realtime) {
      settings = compare_settings(options);
      settings.ways = folder_first(question.reference_path, std::move(settings.ways));
    }
  } else if (question.realtime) {
    reference.texture = *question.ours;
  } else {
    const RenderResult result =
        render(scene.ready.scene, scene.assets, question.options,
               {.progress = [&](double) { return go_on(); }, .preview = {}});
    if (const std::optional<Error> error = render_error(result.status)) {
      return {error->text + '\n'};
    }
    reference.texture = quantize(result.image, rounding_of(question.options.profile));
  }
  settings.lossy = reference.jpeg || mine.jpeg;
  round_alike(reference, mine);
  const PictureComparison found =
      compare_pictures(reference, mine, &scene, settings, [&](double) { return go_on(); });
  if (found.measures.comparable && !found.other_size() && found.measures.difference.max == 0) {
    return {"equal\n"};
  }
  return {causes_text(found) + where_text(found), shows_nothing(found)};
}

}  // namespace

std::string explain_for_view(const viewer::PixelQuestion& question) {
  try {
    LoadedScene scene = loaded_of(*question.scene);
    scene.ready.scene = question.drawn;
    const RenderOptions& options = question.options;
    Result<ExplainReport> report =
        question.realtime ? explain_realtime_pixel(scene, *question.realtime,
                                                   {options.width, options.height}, question.pixel)
                          : explain_pixel(scene, options, question.pixel.x, question.pixel.y);
    if (!report) {
      return report.error().text + '\n';
    }
    if (question.mine && question.suggest) {
      add_yours(scene, *question.mine, *report);
    }
    return explain_text(scene, *report);
  } catch (const std::bad_alloc&) {
    return "there is not enough memory to explain this pixel\n";
  }
}

std::optional<viewer::PictureFit> fit_for_view(const viewer::FitQuestion& question,
                                               const Options& options) {
  try {
    const LoadedScene scene = loaded_of(*question.scene);
    const DrawnWay way = fitting_way(question, scene, options);
    return viewer::PictureFit{way.options, way.realtime, way.words,
                              equals_ours(question.picture->texture, scene, way)};
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  }
}

viewer::CauseAnswer cause_for_view(const viewer::CauseQuestion& question, const Options& options,
                                   const std::function<bool()>& go_on) {
  try {
    return find_cause(question, options, go_on);
  } catch (const std::bad_alloc&) {
    return {"there is not enough memory to look for the cause\n"};
  }
}

}  // namespace scenefile::app
