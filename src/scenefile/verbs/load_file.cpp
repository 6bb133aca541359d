#include "scenefile/verbs/load_file.h"

#include "scenefile/base/hash.h"
#include "scenefile/base/text.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/file.h"
#include "scenefile/io/memory.h"
#include "scenefile/verbs/realtime_table.h"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

namespace scenefile {

namespace {

void locate(AssetRoots& roots, AssetKind kind, const std::vector<FileReference>& references,
            std::vector<AssetFile>& files) {
  for (const FileReference& reference : references) {
    files.push_back({kind, reference, {}, roots.resolve(reference.name)});
  }
}

void set_paths(LoadedScene& scene, AssetRoots& roots) {
  scene.diagnostics.set_paths([&](const std::string& name) { return roots.path_of(name); });
}

}  // namespace

std::uint64_t file_fingerprint(const std::string& path, const Limits& limits) {
  const Result<std::string> bytes = read_file(path, limits.file_bytes);
  Hash hash;
  hash.add(bytes ? *bytes : bytes.error().text);
  return hash.value();
}

std::string settings_table(const std::string& folder) {
  for (const std::string& place : {folder, folder + "/.."}) {
    for (const FolderEntry& entry : entries_of(place)) {
      if (!entry.folder && !entry.link && entry.name == realtime_table_name) {
        return entry.path;
      }
    }
  }
  return {};
}

AssetRootsOptions asset_roots_options(const std::string& path, const AssetAccess& access,
                                      const Limits& limits) {
  AssetRootsOptions roots{.scene_path = path,
                          .asset_roots = access.roots,
                          .allow_outside = access.allow_outside,
                          .max_bytes = limits.file_bytes};
  if (const char* const data = std::getenv("CS123_DATA"); data != nullptr && *data != '\0') {
    roots.asset_roots.emplace_back(data);
  }
  return roots;
}

LoadedScene load_scene_file(const std::string& path, const LoadSettings& settings,
                            const AssetAccess& access) {
  if (settings.entering) {
    settings.entering("reading the file");
  }
  Result<std::string> text = read_file(path, settings.limits.file_bytes);
  if (!text) {
    LoadedScene scene;
    scene.diagnostics = Diagnostics(settings.limits);
    scene.path = path;
    scene.unreadable = text.error();
    return scene;
  }
  return load_scene_text(path, *std::move(text), settings, access);
}

LoadedScene load_scene_text(const std::string& path, std::string text, const LoadSettings& settings,
                            const AssetAccess& access) {
  AssetRoots roots(asset_roots_options(path, access, settings.limits));
  const FetchFile fetch = [&](const std::string& name) { return roots.read(name); };
  LoadedScene scene = load_scene(path, std::move(text), fetch, settings);
  set_paths(scene, roots);
  return scene;
}

void load_written_file(LoadedScene& scene, const LoadSettings& settings,
                       const AssetAccess& access) {
  AssetRoots roots(asset_roots_options(scene.path, access, settings.limits));
  const FetchFile fetch = [&](const std::string& name) { return roots.read(name); };
  load_written(scene, fetch, settings);
  set_paths(scene, roots);
}

Result<DecodedPicture> decode_picture_file(std::string_view bytes, const std::string& path,
                                           std::string_view layer, const Limits& limits) {
  const std::string name = escaped(shown_name(path), 4096);
  if (!is_image(bytes) && is_scene_name(path) && has_scene_parts(bytes)) {
    return input_error(fmt::format("{} is a scene, not a picture", name));
  }
  Result<DecodedPicture> picture = decode_picture(bytes, layer, limits);
  if (!picture) {
    const bool known = is_image(bytes);
    return Error{
        fmt::format("{}: {}{}", name, known ? "cannot decode: " : "", picture.error().text),
        picture.error().kind};
  }
  return picture;
}

Result<DecodedPicture> load_picture_file(const std::string& path, std::string_view layer,
                                         const Limits& limits) {
  const Result<std::string> bytes = read_file(path, limits.file_bytes);
  return bytes ? decode_picture_file(*bytes, path, layer, limits) : bytes.error();
}

std::vector<AssetFile> locate_files(const LoadedScene& scene, const AssetAccess& access,
                                    const Limits& limits) {
  AssetRoots roots(asset_roots_options(scene.path, access, limits));
  std::vector<AssetFile> files;
  locate(roots, AssetKind::texture, scene.ready.scene.texture_files, files);
  locate(roots, AssetKind::mesh, scene.ready.scene.mesh_files, files);
  for (const MeshReference& named : scene.assets.mesh_references) {
    files.push_back({named.kind, named.file, named.from, roots.resolve(named.file.name)});
  }
  return files;
}

std::vector<UsedFile> used_files(const LoadedScene& scene, const AssetAccess& access,
                                 const Limits& limits) {
  std::vector<UsedFile> files{{scene.path, fmt::format("the scene {}", escaped(scene.path))}};
  const auto add = [&](AssetKind kind, const std::string& name, const std::string& place) {
    files.push_back({place, fmt::format("the {} {} of the scene", word_of(kind), escaped(name))});
  };
  for (const AssetFile& file : locate_files(scene, access, limits)) {
    add(file.kind, file.reference.name, file.resolved.path);
  }
  if (!scene.assets.mesh_materials.empty()) {
    return files;  // with those that the meshes name
  }
  AssetRoots roots(asset_roots_options(scene.path, access, limits));
  const FetchFile fetch = [&](const std::string& name) { return roots.read(name); };
  for (const FileReference& mesh : scene.ready.scene.mesh_files) {
    const Result<std::string> text = roots.read(mesh.name);
    if (!text) {
      continue;
    }
    for (const MeshReference& file : files_named_by_mesh(mesh.name, *text, fetch, limits)) {
      add(file.kind, file.file.name, roots.resolve(file.file.name).path);
    }
  }
  return files;
}

void forget_file(LoadedScene& scene) {
  std::string().swap(scene.text);  // assignment would not free the memory
  scene.written = {};
  scene.ready.sources = {};
  return_free_memory();
}

}  // namespace scenefile
