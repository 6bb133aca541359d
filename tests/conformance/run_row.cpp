#include "run_row.h"

#include "read_picture.h"
#include "support/load_scene.h"

#include <ctime>

namespace scenefile::conformance {

namespace {

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

RowResult run_row(const std::string& corpus, const Row& row) {
  RowResult result;
  result.row = row;
  result.error = read_picture(corpus + "/" + row.reference, result.theirs);
  if (!result.error.empty()) {
    return result;
  }
  const testing_support::LoadedScene loaded =
      testing_support::load_scene(corpus + "/" + row.scene, true);
  if (!loaded.error.empty()) {
    result.error = loaded.error;
    return result;
  }
  RenderOptions options = default_options(Profile::course);
  options.mode = row.mode;
  options.features = row.features;
  options.width = result.theirs.width;
  options.height = result.theirs.height;
  const double start = cpu_seconds();
  const RenderResult rendered = render(loaded.ready.scene, loaded.assets, options);
  result.cpu_seconds = cpu_seconds() - start;
  if (rendered.status != RenderStatus::complete) {
    result.error = "the tracer failed";
    return result;
  }
  result.ours = quantize(rendered.image, rounding_of(Profile::course));
  result.difference = compare_images(result.ours, result.theirs);
  return result;
}

}  // namespace scenefile::conformance
