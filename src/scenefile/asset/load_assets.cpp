#include "scenefile/asset/load_assets.h"

#include "scenefile/asset/codes.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/asset/read_obj.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

FileContents no_access(const std::string& /*name*/) {
  return {"", "no files are opened here"};
}

Texture load_texture(const FileReference& file, const FetchFile& fetch, const Limits& limits,
                     std::uint64_t& budget, Diagnostics& diagnostics) {
  const auto warn = [&](const Code& code, const std::string& why) {
    diagnostics.report(
        code, file.location,
        fmt::format("texture {}: {}; shading with the diffuse color", quoted(file.name, 200), why));
  };
  const FileContents contents = fetch(file.name);
  if (!contents.error.empty()) {
    warn(texture_missing, contents.error);
    return {};
  }
  std::string error;
  bool over_limit = false;
  Texture texture = decode_image(contents.bytes, limits, budget, error, &over_limit);
  if (!error.empty()) {
    warn(over_limit ? texture_limit : texture_undecodable, "cannot decode: " + error);
  }
  return texture;
}

// Loads meshes within the budgets of all of them.
class MeshLoader {
 public:
  MeshLoader(const FetchFile& fetch, const LoadOptions& options, Diagnostics& diagnostics)
      : fetch_(fetch),
        options_(options),
        diagnostics_(diagnostics),
        triangles_(options.limits.mesh_triangles),
        bytes_(options.limits.mesh_bytes) {}

  Mesh load(const FileReference& file) {
    const FileContents contents = fetch_(file.name);
    if (!contents.error.empty()) {
      report(mesh_missing, file, contents.error);
      return {};
    }
    Diagnostics findings(options_.limits);
    Mesh mesh = read_obj(contents.bytes, file.name, options_.limits, triangles_, bytes_, findings);
    for (Diagnostic finding : findings.list()) {
      finding.severity = softened(finding.severity);
      diagnostics_.add(std::move(finding));
    }
    if (const std::size_t errors = findings.count(Severity::error); errors > 0) {
      report(mesh_unusable, file,
             fmt::format("{} error{} in the file", errors, errors == 1 ? "" : "s"));
    }
    return mesh;
  }

 private:
  Severity softened(Severity severity) const {
    return options_.allow_missing && severity == Severity::error ? Severity::warning : severity;
  }

  void report(const Code& code, const FileReference& file, const std::string& why) {
    const char* consequence = options_.allow_missing ? "; drawing without it" : "";
    diagnostics_.report(code, softened(code.severity), file.location,
                        fmt::format("mesh {}: {}{}", quoted(file.name, 200), why, consequence));
  }

  const FetchFile& fetch_;
  const LoadOptions& options_;
  Diagnostics& diagnostics_;
  std::uint64_t triangles_;
  std::uint64_t bytes_;
};

}  // namespace

Assets load_assets(std::span<const FileReference> texture_files,
                   std::span<const FileReference> mesh_files, const FetchFile& fetch_file,
                   const LoadOptions& options, Diagnostics& diagnostics) {
  const FetchFile fetch = fetch_file ? fetch_file : FetchFile(no_access);
  Assets assets;
  assets.textures.resize(texture_files.size());
  assets.meshes.resize(mesh_files.size());
  std::uint64_t budget = options.limits.texture_bytes;
  for (std::size_t i = 0; options.textures && i < texture_files.size(); ++i) {
    assets.textures[i] = load_texture(texture_files[i], fetch, options.limits, budget, diagnostics);
  }
  MeshLoader meshes(fetch, options, diagnostics);
  for (std::size_t i = 0; i < mesh_files.size(); ++i) {
    assets.meshes[i] = meshes.load(mesh_files[i]);
  }
  return assets;
}

}  // namespace scenefile
