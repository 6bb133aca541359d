#include "run_row.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/base/report.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/io/asset_roots.h"
#include "scenefile/io/file.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/prepare.h"

#include <ctime>

namespace scenefile::conformance {

namespace {

// An error of the scene or one of its files, as text; empty when the scene can be drawn.
std::string load(const std::string& path, RenderScene& scene, Assets& assets) {
  std::string text;
  const Limits limits;
  if (IoError error = read_file(path, limits.file_bytes, text); !error.empty()) {
    return error;
  }
  Diagnostics diagnostics(limits);
  const Scene written = read_scene(text, {.compat_course = true, .limits = limits}, diagnostics);
  if (!diagnostics.has_errors()) {
    check(written, limits, diagnostics);
  }
  if (!diagnostics.has_errors()) {
    scene = prepare(written, limits).scene;
    const AssetRootsOptions roots{.scene_path = path, .asset_roots = {}};
    const FetchFile fetch = [&](const std::string& name) {
      FileContents contents;
      contents.error = read_asset(roots, name, contents.bytes);
      return contents;
    };
    assets = load_assets(scene.texture_files, scene.mesh_files, fetch, {}, diagnostics);
  }
  return diagnostics.has_errors() ? report_text(diagnostics, path, text, {.excerpt = false}) : "";
}

std::string load_reference(const std::string& path, Texture& picture) {
  std::string bytes;
  const Limits limits;
  if (IoError error = read_file(path, limits.file_bytes, bytes); !error.empty()) {
    return error;
  }
  std::uint64_t budget = limits.texture_bytes;
  std::string error;
  picture = decode_image(bytes, limits, budget, error);
  return error.empty() ? "" : path + ": " + error;
}

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

Result run_row(const std::string& corpus, const Row& row) {
  Result result;
  result.row = row;
  RenderScene scene;
  Assets assets;
  result.error = load_reference(corpus + "/" + row.reference, result.theirs);
  if (result.error.empty()) {
    result.error = load(corpus + "/" + row.scene, scene, assets);
  }
  if (!result.error.empty()) {
    return result;
  }
  RenderOptions options = default_options(Profile::course);
  options.mode = row.mode;
  options.features = row.features;
  options.width = result.theirs.width;
  options.height = result.theirs.height;
  const double start = cpu_seconds();
  const RenderResult rendered = render(scene, assets, options);
  result.cpu_seconds = cpu_seconds() - start;
  if (rendered.status != RenderStatus::complete) {
    result.error = "the tracer gave up";
    return result;
  }
  result.ours = quantize(rendered.image, rounding_of(Profile::course));
  result.difference = compare_images(result.ours, result.theirs);
  return result;
}

}  // namespace scenefile::conformance
