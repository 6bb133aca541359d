#include "app/view_answers.h"

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

std::string cause_text(const viewer::CauseQuestion& question, const std::function<bool()>& go_on) {
  const LoadedScene scene = loaded_of(*question.scene);
  Texture ours = question.ours != nullptr ? *question.ours : Texture();
  if (!question.realtime) {
    const RenderResult result =
        render(scene.ready.scene, scene.assets, question.options,
               {.progress = [&](double) { return go_on(); }, .preview = {}});
    if (const std::optional<Error> error = render_error(result.status)) {
      return error->text + '\n';
    }
    ours = quantize(result.image, rounding_of(question.options.profile));
  }
  CompareSettings settings;
  settings.ways = {way_of(question)};
  const PictureComparison found =
      compare_pictures(ours, *question.other, &scene, settings, [&](double) { return go_on(); });
  if (found.measures.same_size && found.measures.difference.max == 0) {
    return "equal\n";
  }
  return causes_text(found) + where_text(found, {}, {});  // a click explains a pixel
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
    if (question.other) {
      add_yours(scene, *question.other, *report);
    }
    return explain_text(scene, *report);
  } catch (const std::bad_alloc&) {
    return "there is not enough memory to explain this pixel\n";
  }
}

std::string cause_for_view(const viewer::CauseQuestion& question,
                           const std::function<bool()>& go_on) {
  try {
    return cause_text(question, go_on);
  } catch (const std::bad_alloc&) {
    return "there is not enough memory to look for the cause\n";
  }
}

}  // namespace scenefile::app
