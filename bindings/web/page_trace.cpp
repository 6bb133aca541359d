// Tracing and explaining the open scene.

#include "page.h"
#include "scenefile/path/tone.h"
#include "scenefile/verbs/explain.h"
#include "scenefile/verbs/render_error.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace scenefile {

namespace {

// What rays are traced in, or why they cannot be.
Result<const TraceScene*> traced_scene() {
  Page& p = page();
  if (!p.scene.usable()) {
    return Error{"the scene has errors"};
  }
  if (!p.traced) {
    p.traced.emplace(p.scene.ready.scene, p.scene.assets, TraceSceneOptions{.threads = 1});
  }
  if (auto error = render_error(p.traced->status())) {
    return std::move(*error);
  }
  return &*p.traced;
}

bool is_same_picture(const RenderOptions& a, const RenderOptions& b) {
  return a.width == b.width && a.height == b.height && a.crop == b.crop &&
         a.max_depth == b.max_depth;
}

}  // namespace

extern "C" {

/// The pixels x0 <= x < x1, y0 <= y < y1 of a picture of the open scene; null if the answer is an
/// error.
const std::uint8_t* page_render(int profile, int mode, int features, int width, int height,
                                int samples, int max_depth, int x0, int y0, int x1, int y1) {
  Page& p = page();
  const std::uint8_t* pixels = nullptr;
  answered([&]() -> std::string {
    const Result<const TraceScene*> traced = traced_scene();
    if (!traced) {
      return error_json(traced.error().text);
    }
    RenderOptions options =
        picture_options(profile, mode, features, width, height, samples, max_depth);
    options.crop = PixelRegion{x0, y0, x1, y1};
    RenderControl control;
    control.traced = *traced;
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

/// Adds samples to those pixels of a picture of mode path, for about `seconds`; a call with the
/// same numbers goes on. Answers whether each has `samples`, and then also their white.
const char* page_path_add(int profile, int mode, int features, int width, int height, int samples,
                          int max_depth, int x0, int y0, int x1, int y1, double seconds) {
  return answered([&]() -> std::string {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const Result<const TraceScene*> traced = traced_scene();
    if (!traced) {
      return error_json(traced.error().text);
    }
    RenderOptions options =
        picture_options(profile, mode, features, width, height, samples, max_depth);
    options.crop = PixelRegion{x0, y0, x1, y1};
    Page& p = page();
    if (!p.paths || !is_same_picture(p.paths->options, options)) {
      p.paths.emplace(**traced, p.scene.ready.scene, options);
    }
    const Progress progress = [&](double) {
      return std::chrono::duration<double>(Clock::now() - start).count() < seconds;
    };
    RenderStats stats;
    const RenderStatus status =
        add_samples(p.paths->scene, static_cast<std::uint32_t>(options.samples), p.paths->state,
                    progress, stats);
    const bool complete = status == RenderStatus::complete;
    if (!complete && status != RenderStatus::cancelled) {
      return error_json(render_error(status)->text);
    }
    Json json;
    json.begin_object();
    json.add("complete", complete);
    if (complete) {
      json.add("white", brightest(image_of(p.paths->state).rgb, 0));
    }
    json.end_object();
    return json.text();
  });
}

/// The pixels to which page_path_add() added last; null if the answer is an error. `white`: the
/// largest of the picture's parts.
const std::uint8_t* page_path_pixels(double white) {
  const std::uint8_t* pixels = nullptr;
  answered([&]() -> std::string {
    if (!page().paths) {
      return error_json("the picture was not begun");
    }
    Image image = image_of(page().paths->state);
    map_tones(image.rgb, Tone::course, 0, white);
    pixels = show(quantize(image, Rounding::nearest));
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
