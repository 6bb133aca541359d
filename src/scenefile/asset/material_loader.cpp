#include "scenefile/asset/material_loader.h"

#include "scenefile/asset/codes.h"
#include "scenefile/asset/obj_words.h"
#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace scenefile {

namespace {

// The name, relative to the scene, of a file that a mesh names.
std::string next_to(const std::string& mesh, const std::string& name) {
  const bool absolute = name.starts_with('/') || name.starts_with('\\') || name.starts_with(":/") ||
                        name.starts_with("file:") || (name.size() > 1 && name[1] == ':');
  const std::size_t folder = mesh.find_last_of("/\\");
  return absolute || folder == std::string::npos ? name : mesh.substr(0, folder + 1) + name;
}

}  // namespace

std::vector<MeshReference> files_named_by_mesh(const std::string& mesh, std::string_view obj,
                                               const FetchFile& fetch, const Limits& limits) {
  std::vector<MeshReference> files;
  const auto add = [&](AssetKind kind, std::string name, const std::string& from) {
    MeshReference& file = files.emplace_back();
    file.kind = kind;
    file.file.name = std::move(name);
    file.from = from;
  };
  std::uint64_t budget = limits.mesh_bytes;
  Diagnostics ignored(limits);
  std::set<std::string> known;
  // Searching is much faster than reading the statements between.
  constexpr std::string_view keyword = "mtllib";
  std::size_t next = 0;
  for (std::size_t at = obj.find(keyword); at != std::string_view::npos;
       at = obj.find(keyword, next)) {
    next = at + keyword.size();
    ObjWords words(obj.substr(at));
    words.next_statement();
    // A statement of its own, not a word of another one or of a comment.
    const std::size_t last = at == 0 ? std::string_view::npos : obj.find_last_not_of(" \t", at - 1);
    if (words.next_word() != keyword ||
        (last != std::string_view::npos && obj[last] != '\n' && obj[last] != '\r')) {
      continue;
    }
    const std::vector<FileReference> names = library_names(words);
    next = at + words.at();  // a statement may be many lines long
    for (const FileReference& name : names) {
      const std::string library = next_to(mesh, name.name);
      if (!known.insert(library).second) {
        continue;
      }
      add(AssetKind::library, library, mesh);
      const Result<std::string> text = fetch(library);
      const std::vector<MtlMaterial> materials =
          text ? read_mtl(*text, library, limits, budget, ignored) : std::vector<MtlMaterial>();
      for (const MtlMaterial& material : materials) {
        for (const FileReference* map :
             {&material.diffuse_map, &material.specular_map, &material.emission_map}) {
          if (!map->name.empty()) {
            add(AssetKind::texture, next_to(mesh, map->name), library);
          }
        }
      }
    }
  }
  return files;
}

MaterialLoader::MaterialLoader(const FetchFile& fetch, const Limits& limits,
                               std::uint64_t& byte_budget,
                               std::span<const FileReference> texture_files,
                               Diagnostics& diagnostics)
    : fetch_(fetch),
      limits_(limits),
      budget_(byte_budget),
      diagnostics_(diagnostics),
      first_map_(texture_files.size()) {
  for (std::size_t i = 0; i < texture_files.size(); ++i) {
    textures_.try_emplace(texture_files[i].name, static_cast<std::uint32_t>(i));
  }
}

MeshMaterials MaterialLoader::load(const std::string& mesh, const ObjMaterials& written) {
  std::vector<bool> used(written.names.size());
  for (const std::uint32_t name : written.of_triangle) {
    if (name != mesh_no_index) {
      used[name] = true;
    }
  }
  MeshMaterials result;
  if (std::find(used.begin(), used.end(), true) == used.end()) {
    return result;
  }
  const std::vector<Library*> libraries = read_libraries(mesh, written);
  std::vector<std::uint32_t> numbers(used.size(), mesh_no_index);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] && add_material(mesh, written.names[i], libraries, result.materials)) {
      numbers[i] = static_cast<std::uint32_t>(result.materials.size() - 1);
    }
  }
  if (!result.materials.empty()) {
    result.of_triangle = written.of_triangle;
    for (std::uint32_t& material : result.of_triangle) {
      material = material == mesh_no_index ? material : numbers[material];
    }
  }
  return result;
}

std::vector<MaterialLoader::Library*> MaterialLoader::read_libraries(const std::string& mesh,
                                                                     const ObjMaterials& written) {
  std::vector<Library*> libraries;
  for (const std::vector<FileReference>& line : written.libraries) {
    Library* library = nullptr;
    for (const FileReference& name : line) {
      library = &read_library({next_to(mesh, name.name), name.location}, mesh);
      if (!library->error) {
        break;
      }
    }
    if (!library->error) {
      if (std::find(libraries.begin(), libraries.end(), library) == libraries.end()) {
        libraries.push_back(library);
      }
      continue;
    }
    report(
        library->error->kind == ErrorKind::limit ? "mtl.limit"_code : "mtl.missing"_code,
        line.back().location, mesh,
        fmt::format("the material library {}: {}; faces with its materials have that of the object",
                    quoted(line.back().name, 200), library->error->text),
        library->error->notes);
  }
  if (written.libraries.empty()) {
    const FileReference& name = written.names.front();
    report("mtl.missing"_code, name.location, mesh,
           fmt::format("the file uses the material {} and names no library; add a line mtllib "
                       "FILE.mtl",
                       quoted(name.name)));
  }
  return libraries;
}

MaterialLoader::Library& MaterialLoader::read_library(const FileReference& file,
                                                      const std::string& mesh) {
  const auto [entry, is_new] = libraries_.try_emplace(file.name);
  Library& library = entry->second;
  if (!is_new) {
    return library;
  }
  library.file = file.name;
  files_.push_back({AssetKind::library, file, mesh});
  const Result<std::string> text = fetch_(file.name);
  if (!text) {
    library.error = text.error();
    return library;
  }
  library.materials = read_mtl(*text, file.name, limits_, budget_, diagnostics_);
  library.judged.resize(library.materials.size());
  for (std::size_t i = 0; i < library.materials.size(); ++i) {
    library.numbers.emplace(library.materials[i].name, i);
  }
  return library;
}

bool MaterialLoader::add_material(const std::string& mesh, const FileReference& name,
                                  const std::vector<Library*>& libraries,
                                  std::vector<FaceMaterial>& materials) {
  for (Library* library : libraries) {
    const auto found = library->numbers.find(name.name);
    if (found == library->numbers.end()) {
      continue;
    }
    const MtlMaterial& material = library->materials[found->second];
    const std::uint64_t bytes = sizeof(FaceMaterial) + material.name.size() + library->file.size();
    if (bytes > budget_) {
      report("mtl.limit"_code, name.location, mesh,
             fmt::format("the material {} is left out: no memory is left of the limit for all "
                         "meshes",
                         quoted(name.name)));
      return false;
    }
    budget_ -= bytes;
    materials.push_back(face_material(mesh, *library, material));
    if (!library->judged[found->second]) {
      library->judged[found->second] = true;
      judge(*library, material, materials.back());
    }
    return true;
  }
  if (!libraries.empty()) {
    report_unknown(mesh, name, libraries);
  }
  return false;
}

void MaterialLoader::report_unknown(const std::string& mesh, const FileReference& name,
                                    const std::vector<Library*>& libraries) {
  constexpr std::size_t max_known = 1000;  // comparing names takes time
  std::vector<std::string_view> known;
  for (const Library* library : libraries) {
    for (const MtlMaterial& material : library->materials) {
      if (known.size() < max_known && diagnostics_.dropped("mtl.unknown-material"_code) == 0) {
        known.push_back(material.name);
      }
    }
  }
  const std::string_view meant = nearest_name(name.name, known);
  diagnostics_.add(
      {&"mtl.unknown-material"_code,
       "mtl.unknown-material"_code.severity,
       name.location,
       mesh,
       fmt::format("no library defines the material {}; its faces have the material of the "
                   "object{}",
                   quoted(name.name),
                   meant.empty() ? "" : fmt::format("; did you mean {}?", quoted(meant))),
       {},
       correction(name.name, meant, known)});
}

FaceMaterial MaterialLoader::face_material(const std::string& mesh, const Library& library,
                                           const MtlMaterial& written) {
  const auto color = [](const std::optional<glm::vec3>& value, const FileReference& map) {
    return value.value_or(glm::vec3(map.name.empty() ? 0.0f : 1.0f));
  };
  FaceMaterial m;
  m.name = written.name;
  m.diffuse = color(written.diffuse, written.diffuse_map);
  m.specular = color(written.specular, written.specular_map);
  m.emission = color(written.emission, written.emission_map);
  m.transmission = written.transmission.value_or(m.transmission);
  m.shininess = written.shininess.value_or(m.shininess);
  m.ior = written.ior.value_or(m.ior);
  m.illum = written.illum.value_or(m.illum);
  m.diffuse_map = map_index(mesh, library, written.diffuse_map);
  m.specular_map = map_index(mesh, library, written.specular_map);
  m.emission_map = map_index(mesh, library, written.emission_map);
  m.file = library.file;
  m.location = written.location;
  return m;
}

std::uint32_t MaterialLoader::map_index(const std::string& mesh, const Library& library,
                                        const FileReference& map) {
  if (map.name.empty()) {
    return no_map;
  }
  const std::string name = next_to(mesh, map.name);
  const auto [entry, is_new] =
      textures_.try_emplace(name, static_cast<std::uint32_t>(first_map_ + maps_.size()));
  if (is_new) {
    maps_.push_back({AssetKind::texture, {name, map.location}, library.file});
  }
  return entry->second;
}

void MaterialLoader::judge(const Library& library, const MtlMaterial& written,
                           const FaceMaterial& m) {
  constexpr int mirror = 5;
  constexpr int glass = 7;
  const auto note = [&](const Code& code, std::string text) {
    report(code, written.location, library.file, std::move(text));
  };
  const std::string name = quoted(m.name);
  // A texture makes a color darker by an unknown amount.
  glm::vec3 reflected = m.specular_map == no_map ? m.specular : glm::vec3(0);
  if (m.illum != mirror && m.diffuse_map == no_map) {
    reflected += m.diffuse;
  }
  const float most = std::max({reflected.x, reflected.y, reflected.z});
  constexpr float rounding = 1e-4f;
  if (m.illum != glass && most > 1 + rounding) {
    note("mtl.energy"_code,
         fmt::format("{} of the material {} is {} in a channel: it reflects more "
                     "light than it receives",
                     m.illum == mirror ? "Ks" : "Kd + Ks", name, number_text(most)));
  }
  if (m.illum == mirror && !written.ior) {
    note("mtl.mirror-ior"_code,
         fmt::format("the material {} is drawn as a mirror; illum 5 without Ni reflects nothing "
                     "in other programs",
                     name));
  }
  if (m.illum < 0 || (m.illum > 2 && m.illum != mirror && m.illum != glass)) {
    note("mtl.illum"_code,
         fmt::format("illum {} of the material {} is drawn like illum 2, from Kd and "
                     "Ks",
                     m.illum, name));
  }
  if (written.opacity.value_or(1) != 1) {
    note("mtl.opacity"_code,
         fmt::format("d {} of the material {} is not drawn: only illum 7 is transparent",
                     number_text(*written.opacity), name));
  }
}

void MaterialLoader::report(const Code& code, Location location, const std::string& file,
                            std::string message, std::vector<std::string> notes) {
  diagnostics_.add({&code, code.severity, location, file, std::move(message), std::move(notes)});
}

}  // namespace scenefile
