#include "app/load.h"

#include "scenefile/base/hash.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/io/file.h"
#include "scenefile/io/memory.h"
#include "scenefile/io/parallel.h"
#include "scenefile/scene/check.h"

#include <cstdlib>
#include <utility>

namespace scenefile::app {

AssetRootsOptions asset_roots_options(const std::string& path, const Options& options) {
  AssetRootsOptions roots{.scene_path = path,
                          .asset_roots = options.asset_roots,
                          .allow_outside = options.allow_outside,
                          .max_bytes = options.limits.file_bytes};
  // What /course/cs123/data was on the course's machines.
  if (const char* const data = std::getenv("CS123_DATA"); data != nullptr && *data != '\0') {
    roots.asset_roots.emplace_back(data);
  }
  return roots;
}

namespace {

void load_files(LoadedScene& scene, const Options& options, bool textures, bool allow_missing) {
  AssetRoots roots(asset_roots_options(scene.path, options));
  Hash hash;
  const FetchFile fetch = [&](const std::string& name) {
    FileContents contents;
    IoError error = roots.read(name, contents.bytes);
    contents.error = std::move(error.text);
    contents.over_limit = error.over_limit;
    hash.add(name);
    hash.add(contents.bytes);
    return contents;
  };
  LoadOptions load;
  load.textures = textures;
  load.allow_missing = allow_missing;
  load.limits = options.limits;
  load.for_each = [&](std::size_t count, const std::function<void(std::size_t)>& work) {
    for_each_index(count, options.render.threads, work);
  };
  scene.assets = load_assets(scene.ready.scene.texture_files, scene.ready.scene.mesh_files, fetch,
                             load, scene.diagnostics);
  scene.asset_fingerprint = hash.value();
}

void locate(AssetRoots& roots, AssetKind kind, const std::vector<FileReference>& references,
            std::vector<AssetFile>& files) {
  for (const FileReference& reference : references) {
    files.push_back({kind, reference, roots.resolve(reference.name)});
  }
}

}  // namespace

LoadedScene load_scene(const std::string& path, const Options& options, LoadDepth depth,
                       bool allow_missing, Context& context) {
  const Limits& limits = options.limits;
  LoadedScene scene;
  scene.diagnostics = Diagnostics(limits);
  scene.path = path;
  context.phase = "reading the file";
  scene.unreadable = read_file(path, limits.file_bytes, scene.text);
  if (!scene.unreadable.empty()) {
    return scene;
  }
  context.phase = "reading the scene";
  scene.written = read_scene(scene.text, {.compat_course = options.compat_course, .limits = limits},
                             scene.diagnostics);
  context.phase = "checking the scene";
  check(scene.written, limits, scene.diagnostics);
  context.phase = "preparing the scene";
  scene.ready = prepare(scene.written, limits);
  if (depth != LoadDepth::prepared) {
    context.phase = "loading textures and meshes";
    load_files(scene, options, depth == LoadDepth::with_all_assets, allow_missing);
  }
  return scene;
}

void check_picture(LoadedScene& scene, ViewQuestion question) {
  if (scene.diagnostics.has_errors()) {
    return;
  }
  if (scene.written.camera) {
    question.camera = scene.written.camera->location;
  }
  question.place_of = [&](std::uint32_t source) { return scene.ready.sources[source].location; };
  check_view(scene.ready.scene, scene.assets, question, scene.diagnostics);
}

void forget_file(LoadedScene& scene) {
  std::string().swap(scene.text);  // an assignment would keep the memory
  scene.written = {};
  scene.ready.sources = {};
  return_free_memory();
}

std::vector<AssetFile> locate_files(const LoadedScene& scene, const Options& options) {
  AssetRoots roots(asset_roots_options(scene.path, options));
  std::vector<AssetFile> files;
  locate(roots, AssetKind::texture, scene.ready.scene.texture_files, files);
  locate(roots, AssetKind::mesh, scene.ready.scene.mesh_files, files);
  return files;
}

}  // namespace scenefile::app
