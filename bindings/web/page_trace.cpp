// Tracing and explaining the open scene.

#include "page.h"
#include "scenefile/verbs/explain.h"
#include "scenefile/verbs/render_error.h"

#include <utility>

namespace scenefile {

extern "C" {

/// The pixels x0 <= x < x1, y0 <= y < y1 of a picture of the open scene; null if the answer is an
/// error.
const std::uint8_t* page_render(int profile, int mode, int features, int width, int height,
                                int samples, int max_depth, int x0, int y0, int x1, int y1) {
  Page& p = page();
  const std::uint8_t* pixels = nullptr;
  answered([&]() -> std::string {
    if (!p.scene.usable()) {
      return error_json("the scene has errors");
    }
    RenderOptions options =
        picture_options(profile, mode, features, width, height, samples, max_depth);
    options.crop = PixelRegion{x0, y0, x1, y1};
    if (!p.traced) {
      p.traced.emplace(p.scene.ready.scene, p.scene.assets, TraceSceneOptions{.threads = 1});
    }
    if (const auto error = render_error(p.traced->status())) {
      return error_json(error->text);
    }
    RenderControl control;
    control.traced = &*p.traced;
    const RenderResult result =
        render(p.scene.ready.scene, p.scene.assets, options, std::move(control));
    if (const auto error = render_error(result.status)) {
      return error_json(error->text);
    }
    pixels = show(quantize(result.image, rounding_of(options.profile)));
    return "{}";
  });
  return pixels;
}

/// The document of `scenefile explain --json` for a pixel of that picture. `red`, `green`, `blue`:
/// its value in another program's picture, or -1 for none.
const char* page_explain(int profile, int mode, int features, int width, int height, int samples,
                         int max_depth, int x, int y, int red, int green, int blue) {
  return answered([&] {
    const LoadedScene& scene = page().scene;
    if (!scene.usable()) {
      return error_json("the scene has errors");
    }
    const RenderOptions options =
        picture_options(profile, mode, features, width, height, samples, max_depth);
    Result<ExplainReport> report = explain_pixel(scene, options, x, y);
    if (!report) {
      return error_json(report.error().text);
    }
    if (red >= 0) {
      const auto byte = [](int v) { return static_cast<std::uint8_t>(v); };
      report->yours = compare_with_yours(scene.ready.scene, report->pixel,
                                         {byte(red), byte(green), byte(blue)});
    }
    return explain_json(scene, options, &*report);
  });
}

/// The same as human-readable text.
const char* page_explain_text(int profile, int mode, int features, int width, int height,
                              int samples, int max_depth, int x, int y) {
  return answered([&] {
    const LoadedScene& scene = page().scene;
    const Result<ExplainReport> report = explain_pixel(
        scene, picture_options(profile, mode, features, width, height, samples, max_depth), x, y);
    return report ? explain_text(scene, *report) : report.error().text;
  });
}
}

}  // namespace scenefile
