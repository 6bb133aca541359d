#include "scenefile/verbs/explain.h"

#include "scenefile/verbs/render_error.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

Result<ExplainReport> explain_path_pixel(const LoadedScene& scene, const RenderOptions& options,
                                         int x, int y, std::optional<std::uint32_t> sample) {
  ExplainReport report;
  const RenderStatus status =
      explain_path(scene.ready.scene, scene.assets, options, x, y, sample, report.path.emplace());
  if (const std::optional<Error> error = render_error(status)) {
    return *error;
  }
  if (const auto error = no_such_sample(sample, report.path->samples.size())) {
    return *error;
  }
  return report;
}

}  // namespace

std::optional<Error> no_such_sample(std::optional<std::uint32_t> sample, std::size_t taken) {
  if (sample.value_or(0) < taken) {
    return std::nullopt;
  }
  return Error{
      fmt::format("there is no sample {}: the pixel has {}, counted from 0", *sample, taken),
      ErrorKind::usage};
}

Result<ExplainReport> explain_pixel(const LoadedScene& scene, const RenderOptions& options, int x,
                                    int y, std::optional<std::uint32_t> sample) {
  if (options.mode == Mode::path) {
    return explain_path_pixel(scene, options, x, y, sample);
  }
  const Explainer explainer(scene.ready.scene, scene.assets, options);
  if (const std::optional<Error> error = render_error(explainer.status())) {
    return *error;
  }
  ExplainReport report;
  report.pixel = explainer.explain(x, y, sample);
  if (const std::optional<Error> error = render_error(explainer.status())) {
    return *error;
  }
  if (const auto error = no_such_sample(sample, report.pixel.samples.size())) {
    return *error;
  }
  report.remarks = remarks(scene.ready.scene, report.pixel);
  return report;
}

}  // namespace scenefile
