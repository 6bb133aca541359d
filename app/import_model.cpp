#include "app/import_model.h"

#include "app/named_files.h"
#include "scenefile/base/text.h"
#include "scenefile/import/read_gltf.h"
#include "scenefile/import/read_obj_scene.h"
#include "scenefile/io/file.h"
#include "scenefile/scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace scenefile::app {

namespace {

std::string extension_of(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

// "the material library scene.mtl of the model".
std::string part_of_model(const std::string& name) {
  const std::string extension = extension_of(name);
  return fmt::format("the {} {} of the model",
                     extension == ".mtl"   ? "material library"
                     : extension == ".bin" ? "buffer"
                                           : "texture",
                     escaped(name));
}

}  // namespace

// The prefix of file names. It contains no spaces, because OBJ cannot express them in file names.
std::string file_stem(const std::string& output) {
  std::string stem = std::filesystem::path(output).stem().string().substr(0, 100);
  std::replace_if(
      stem.begin(), stem.end(),
      [](unsigned char c) { return c < 0x80 && std::isalnum(c) == 0 && c != '-' && c != '_'; },
      '_');
  return stem.empty() ? "model" : stem;
}

bool is_model(const std::string& path) {
  static constexpr std::array<std::string_view, 3> extensions{".glb", ".gltf", ".obj"};
  return std::find(extensions.begin(), extensions.end(), extension_of(path)) != extensions.end();
}

LoadedScene import_model(const std::string& path, const std::string& output, const Options& options,
                         std::vector<ImportedFile>& files, Context& context) {
  LoadedScene scene;
  scene.diagnostics = Diagnostics(options.load.limits);
  scene.path = path;
  context.phase = "reading the file";
  const Result<std::string> bytes = read_file(path, options.load.limits.file_bytes);
  if (!bytes) {
    scene.unreadable = bytes.error();
    return scene;
  }
  context.phase = "reading the model";
  AssetRoots roots(asset_roots_options(path, options));
  const ImportOptions import{
      .stem = file_stem(output),
      .fetch =
          [&](const std::string& name) {
            const UsedFile file{roots.resolve(name).path, part_of_model(name)};
            if (const Result<void> added = context.files.read(file); !added) {
              scene.unreadable = added.error();
            }
            return roots.read(name);
          },
      .limits = options.load.limits,
  };
  ImportedScene imported = extension_of(path) == ".obj"
                               ? read_obj_scene(*bytes, import, scene.diagnostics)
                               : read_gltf(*bytes, import, scene.diagnostics);
  scene.written = std::move(imported.scene);
  files = std::move(imported.files);
  if (!scene.diagnostics.has_errors()) {
    context.phase = "checking the scene";
    check(scene.written, options.load.limits, scene.diagnostics);
  }
  return scene;
}

Outcome write_model(const std::string& output, const std::string& text,
                    const std::vector<ImportedFile>& files, Context& context) {
  const std::filesystem::path folder = std::filesystem::path(output).parent_path();
  std::vector<OutputFile> list;
  std::vector<UsedFile> claimed;
  for (const ImportedFile& file : files) {
    list.push_back({(folder / file.name).string(), &file.bytes});
    const std::string& path = list.back().path;
    claimed.push_back({path, fmt::format("the file {} next to the output", escaped(path))});
  }
  if (Outcome refused = claim_outputs(claimed, context); refused.status != ExitCode::fine) {
    return refused;
  }
  list.push_back({output, &text});
  return outcome_of(write_files(list));
}

}  // namespace scenefile::app
