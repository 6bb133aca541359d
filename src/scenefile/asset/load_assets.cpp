#include "scenefile/asset/load_assets.h"

#include "scenefile/asset/codes.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/asset/material_loader.h"
#include "scenefile/asset/read_obj.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

Result<std::string> no_access(const std::string& /*name*/) {
  return Error{"no files are opened here"};
}

bool is_limit(const Error& error) {
  return error.kind == ErrorKind::limit;
}

// Loads textures within the budget of all of them, several at once.
class TextureLoader {
 public:
  TextureLoader(const FetchFile& fetch, const LoadOptions& options, Diagnostics& diagnostics)
      : fetch_(fetch),
        options_(options),
        diagnostics_(diagnostics),
        budget_(options.limits.texture_bytes) {}

  // `from`: the file that names it, or empty for the scene. All three outlive finish().
  void add(const FileReference& file, const std::string& from, Texture& texture) {
    Result<std::string> bytes = fetch_(file.name);
    const std::uint64_t encoded = bytes ? bytes->size() : 0;
    const std::uint64_t decoded = bytes ? decoded_bytes(*bytes) : 0;
    if (!fits(encoded, decoded)) {
      finish();
    }
    decoded_ += decoded;
    encoded_ += encoded;
    waiting_.push_back({file, from, std::move(bytes), texture, {}});
  }

  void finish() {
    const auto work = [&](std::size_t i) { decode(waiting_[i]); };
    if (options_.for_each && waiting_.size() > 1) {
      options_.for_each(waiting_.size(), work);
    } else {
      std::for_each(waiting_.begin(), waiting_.end(), [&](Waiting& one) { decode(one); });
    }
    for (const Waiting& one : waiting_) {
      report(one);
      budget_ -= one.texture.rgb.size();
    }
    waiting_.clear();
    encoded_ = 0;
    decoded_ = 0;
  }

 private:
  struct Waiting {
    const FileReference& file;
    const std::string& from;
    Result<std::string> bytes;
    Texture& texture;
    std::optional<Error> error;  // of decoding
  };

  // A batch that is decoded in parallel fits the budget, so that the same textures are rejected as
  // in sequence, and its files take little memory.
  bool fits(std::uint64_t encoded, std::uint64_t decoded) const {
    constexpr std::size_t max_files = 64;
    constexpr std::size_t max_bytes = 64'000'000;
    return waiting_.size() < max_files && encoded_ + encoded <= max_bytes &&
           decoded_ + decoded <= budget_;
  }

  void decode(Waiting& one) const {
    if (!one.bytes) {
      return;
    }
    std::uint64_t budget = budget_;
    if (Result<Texture> texture = decode_image(*one.bytes, options_.limits, budget)) {
      one.texture = *std::move(texture);
    } else {
      one.error = texture.error();
    }
  }

  void report(const Waiting& one) {
    if (!one.bytes) {
      const Error& error = one.bytes.error();
      warn(is_limit(error) ? "texture.limit"_code : "texture.missing"_code, one, error.text,
           error.notes);
    } else if (one.error) {
      warn(is_limit(*one.error) ? "texture.limit"_code : "texture.undecodable"_code, one,
           "cannot decode: " + one.error->text, {});
    }
  }

  void warn(const Code& code, const Waiting& one, const std::string& why,
            const std::vector<std::string>& notes) {
    diagnostics_.add({&code, code.severity, one.file.location, one.from,
                      fmt::format("texture {}: {}; shading with the {}", quoted(one.file.name, 200),
                                  why, one.from.empty() ? "diffuse color" : "color alone"),
                      notes});
  }

  const FetchFile& fetch_;
  const LoadOptions& options_;
  Diagnostics& diagnostics_;
  std::uint64_t budget_;
  std::vector<Waiting> waiting_;
  std::uint64_t encoded_ = 0;
  std::uint64_t decoded_ = 0;
};

// Loads meshes within the budgets of all of them.
class MeshLoader {
 public:
  MeshLoader(const FetchFile& fetch, const LoadOptions& options, Diagnostics& diagnostics)
      : fetch_(fetch),
        options_(options),
        diagnostics_(diagnostics),
        triangles_(options.limits.mesh_triangles),
        bytes_(options.limits.mesh_bytes) {}

  // `materials`: where they are wanted, or null.
  Mesh load(const FileReference& file, ObjMaterials* materials) {
    const Result<std::string> bytes = fetch_(file.name);
    if (!bytes) {
      const Error& error = bytes.error();
      report(is_limit(error) ? "mesh.limit"_code : "mesh.missing"_code, file, error.text,
             error.notes);
      return {};
    }
    Diagnostics findings(options_.limits);
    Mesh mesh =
        read_obj(*bytes, file.name, options_.limits, triangles_, bytes_, findings, materials);
    for (Diagnostic finding : findings.list()) {
      finding.severity = softened(finding.severity);
      diagnostics_.add(std::move(finding));
    }
    if (const std::size_t errors = findings.count(Severity::error); errors > 0) {
      report("mesh.unusable"_code, file, counted(errors, "error") + " in the file", {});
    }
    return mesh;
  }

  // What remains of limits.mesh_bytes.
  std::uint64_t& byte_budget() { return bytes_; }

 private:
  Severity softened(Severity severity) const {
    return options_.allow_missing && severity == Severity::error ? Severity::warning : severity;
  }

  void report(const Code& code, const FileReference& file, const std::string& why,
              const std::vector<std::string>& notes) {
    const char* consequence = options_.allow_missing ? "; it is left out" : "";
    diagnostics_.report(code, softened(code.severity), file.location,
                        fmt::format("mesh {}: {}{}", quoted(file.name, 200), why, consequence),
                        notes);
  }

  const FetchFile& fetch_;
  const LoadOptions& options_;
  Diagnostics& diagnostics_;
  std::uint64_t triangles_;
  std::uint64_t bytes_;
};

}  // namespace

bool has_emissive_faces(const Assets& assets) {
  return std::any_of(
      assets.mesh_materials.begin(), assets.mesh_materials.end(), [](const MeshMaterials& mesh) {
        return std::any_of(mesh.materials.begin(), mesh.materials.end(),
                           [](const FaceMaterial& m) { return m.emission != glm::vec3(0); });
      });
}

Assets load_assets(std::span<const FileReference> texture_files,
                   std::span<const FileReference> mesh_files, const FetchFile& fetch_file,
                   const LoadOptions& options, Diagnostics& diagnostics) {
  const FetchFile fetch = fetch_file ? fetch_file : FetchFile(no_access);
  Assets assets;
  assets.textures.resize(texture_files.size());
  assets.meshes.resize(mesh_files.size());
  assets.mesh_materials.resize(options.materials ? mesh_files.size() : 0);
  TextureLoader textures(fetch, options, diagnostics);
  const std::string scene;
  for (std::size_t i = 0; options.textures && i < texture_files.size(); ++i) {
    textures.add(texture_files[i], scene, assets.textures[i]);
  }
  textures.finish();
  MeshLoader meshes(fetch, options, diagnostics);
  MaterialLoader materials(fetch, options.limits, meshes.byte_budget(), texture_files, diagnostics);
  for (std::size_t i = 0; i < mesh_files.size(); ++i) {
    ObjMaterials written;
    assets.meshes[i] = meshes.load(mesh_files[i], options.materials ? &written : nullptr);
    if (options.materials) {
      assets.mesh_materials[i] = materials.load(mesh_files[i].name, written);
    }
  }
  const std::vector<MeshReference>& maps = materials.maps();
  assets.textures.resize(texture_files.size() + maps.size());
  for (std::size_t i = 0; options.textures && i < maps.size(); ++i) {
    textures.add(maps[i].file, maps[i].from, assets.textures[texture_files.size() + i]);
  }
  textures.finish();
  assets.mesh_references = materials.libraries();
  assets.mesh_references.insert(assets.mesh_references.end(), maps.begin(), maps.end());
  return assets;
}

}  // namespace scenefile
