#include "support/load_scene.h"

#include "scenefile/base/report.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/io/asset_roots.h"
#include "scenefile/io/file.h"
#include "scenefile/scene/check.h"

#include <utility>

namespace scenefile::testing_support {

Assets load_files(const std::string& path, const RenderScene& scene, Diagnostics& diagnostics,
                  bool materials) {
  AssetRoots roots({.scene_path = path, .asset_roots = {}});
  const FetchFile fetch = [&](const std::string& name) { return roots.read(name); };
  return load_assets(scene.texture_files, scene.mesh_files, fetch,
                     {.materials = materials || scene.lights.empty(), .limits = {}}, diagnostics);
}

LoadedScene load_scene(const std::string& path, bool compat_course) {
  LoadedScene loaded;
  const Limits limits;
  const Result<std::string> read = read_file(path, limits.file_bytes);
  if (!read) {
    loaded.error = read.error().text;
    return loaded;
  }
  const std::string& text = *read;
  loaded.written =
      read_scene(text, {.compat_course = compat_course, .limits = limits}, loaded.diagnostics);
  if (!loaded.diagnostics.has_errors()) {
    check(loaded.written, limits, loaded.diagnostics);
  }
  if (!loaded.diagnostics.has_errors()) {
    loaded.ready = prepare(loaded.written, limits);
    loaded.assets = load_files(path, loaded.ready.scene, loaded.diagnostics);
  }
  if (loaded.diagnostics.has_errors()) {
    loaded.error = report_text(loaded.diagnostics, path, text, {.excerpt = false});
  }
  return loaded;
}

}  // namespace scenefile::testing_support
