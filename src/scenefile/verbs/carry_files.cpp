#include "scenefile/verbs/carry_files.h"

#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/verbs/codes.h"

#include <fmt/format.h>

#include <unordered_map>

namespace scenefile {

namespace {

bool has_folder(const std::string& output) {
  return output != "-" && !output.starts_with("/dev/");
}

// Decides only once for each name.
class Carrier {
 public:
  Carrier(LoadedScene& scene, const std::string& output, const AssetAccess& access,
          const Limits& limits)
      : scene_(scene),
        folder_(real_folder_of(output)),
        here_(asset_roots_options(scene.path, access, limits)),
        there_(asset_roots_options(output, access, limits)) {}

  // The name for the new folder.
  const std::string& carry(const std::string& name, Location location) {
    const auto [entry, is_new] = names_.try_emplace(name, name);
    if (is_new) {
      entry->second = name_there(name, location);
    }
    return entry->second;
  }

 private:
  std::string name_there(const std::string& name, Location location) {
    const ResolvedAsset here = here_.resolve(name);
    if (!here.error.empty()) {
      return name;
    }
    const ResolvedAsset there = there_.resolve(name);
    const bool same = there.error.empty() && there.path == here.path;
    // Our search may find files that other programs would not find.
    if (same && (there.rule < AssetRule::path_suffix || there.rule <= here.rule)) {
      return name;
    }
    std::string relative = path_from(folder_, here.path);
    if (there_.resolve(relative).path == here.path) {
      scene_.diagnostics.report(
          "convert.file-renamed"_code, location,
          fmt::format("{} is written as {}, so that it is found from the output's folder",
                      quoted(name, 400), quoted(relative, 400)));
      return relative;
    }
    if (same) {
      return name;
    }
    scene_.diagnostics.report(
        "convert.file-left-behind"_code, location,
        fmt::format("{} {} from the folder of the output; it is {}: copy it there, or give "
                    "--asset-root whenever the output is used",
                    quoted(name, 400), there.error.empty() ? "is another file" : "is not found",
                    escaped(here.path, 400)));
    return name;
  }

  LoadedScene& scene_;
  std::string folder_;
  AssetRoots here_;
  AssetRoots there_;
  std::unordered_map<std::string, std::string> names_;
};

}  // namespace

void carry_files(LoadedScene& scene, const std::string& output, const AssetAccess& access,
                 const Limits& limits) {
  if (!has_folder(output) || real_folder_of(scene.path) == real_folder_of(output)) {
    return;
  }
  Carrier carrier(scene, output, access, limits);
  for (Node& node : scene.written.nodes) {
    for (Primitive& primitive : node.primitives) {
      if (primitive.shape == Shape::mesh) {
        primitive.mesh_file = carrier.carry(primitive.mesh_file, primitive.location);
      }
      for (auto* use : {&primitive.material.texture, &primitive.material.bump_map}) {
        if (use->has_value()) {
          (*use)->file = carrier.carry((*use)->file, (*use)->location);
        }
      }
    }
  }
}

}  // namespace scenefile
