#include "scenefile/import/read_obj_scene.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/asset/mtl_file.h"
#include "scenefile/asset/read_obj.h"
#include "scenefile/base/components.h"
#include "scenefile/base/text.h"
#include "scenefile/export/flat_mesh.h"
#include "scenefile/import/codes.h"
#include "scenefile/import/complete_scene.h"
#include "scenefile/import/mesh_text.h"
#include "scenefile/import/picture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace scenefile {

namespace {

// An upper bound for the text of an OBJ file, per triangle with all attributes.
constexpr std::uint64_t obj_bytes_of_triangle = 400;

using Corners = std::array<std::uint32_t, 3>;

struct Faces {
  std::string material;
  std::vector<Corners> triangles;
  std::vector<Corners> normals;
  std::vector<Corners> uvs;
};

bool has_emission_map(const MtlMaterial& mtl) {
  return !mtl.emission_map.name.empty();
}

// A map says where a material emits; without it, nothing does.
glm::vec3 emission_of(const MtlMaterial& mtl) {
  return has_emission_map(mtl) ? glm::vec3(0) : mtl.emission.value_or(glm::vec3(0));
}

// With emission, as phong_of() has it for glTF. Ka 1 1 1 is the default of many programs, and would
// be too bright here.
glm::vec3 ambient_of(const MtlMaterial& mtl, const glm::vec3& diffuse) {
  const glm::vec3 ambient = mtl.ambient.value_or(glm::vec3(0));
  return (ambient == glm::vec3(1) ? 0.1f * diffuse : ambient) + emission_of(mtl);
}

// Illumination models of glass: 6, 7 and 9.
bool refracts(int illum) {
  return illum == 6 || illum == 7 || illum == 9;
}

// With the defaults of the format.
Material phong_material(const MtlMaterial& mtl) {
  constexpr float most = 1e6f;
  const auto color = [&](const std::optional<glm::vec3>& value, float otherwise) {
    return glm::min(value.value_or(glm::vec3(otherwise)), glm::vec3(most));
  };
  const glm::vec3 specular = color(mtl.specular, 0);
  const int illum = mtl.illum.value_or(2);
  const bool mirror = illum >= 3 && illum <= 7 && illum != 4;
  Material m;
  // Glass with a color but without d lets everything through.
  const float opacity = mtl.opacity.value_or(refracts(illum) && mtl.transmission ? 0 : 1);
  // Glass adds what it lets through; other surfaces let through what they do not cover.
  m.diffuse = (refracts(illum) ? 1 : opacity) * color(mtl.diffuse, 1);
  m.ambient = glm::min(ambient_of(mtl, m.diffuse), glm::vec3(most));
  if (illum >= 2 && mtl.shininess.value_or(0) > 0) {
    m.specular = specular;
    m.shininess = std::min(*mtl.shininess, most);
  }
  if (mirror) {
    m.reflective = specular;
  }
  if (opacity < 1) {
    m.transparent = (1 - opacity) * color(mtl.transmission, 1);
    const float ior = std::clamp(mtl.ior.value_or(1), 0.1f, 10.0f);
    m.ior = ior == 1 ? 0 : ior;
  }
  return m;
}

class ObjSceneReader {
 public:
  ObjSceneReader(std::string_view text, const ImportOptions& options, Diagnostics& diagnostics)
      : text_(text),
        options_(options),
        diagnostics_(diagnostics),
        texture_budget_(options.limits.texture_bytes) {}

  ImportedScene read() {
    std::uint64_t triangles = options_.limits.mesh_triangles;
    std::uint64_t bytes = options_.limits.mesh_bytes;
    ObjMaterials written;
    mesh_ = read_obj(text_, "", options_.limits, triangles, bytes, diagnostics_, &written);
    if (diagnostics_.has_errors()) {
      return {};
    }
    if (mesh_.triangles.empty()) {
      diagnostics_.report("import.not-a-model"_code, {}, "the OBJ file has no triangles");
      return {};
    }
    if (mesh_.triangles.size() * obj_bytes_of_triangle > options_.limits.mesh_bytes) {
      diagnostics_.report(
          "import.limit"_code, {},
          fmt::format("{} triangles, divided by material, exceed the limit for all meshes",
                      mesh_.triangles.size()));
      return {};
    }
    sort_faces(written);
    read_libraries(written, bytes);
    result_.scene.global = {1, 1, 1, 1.0f, {}};
    for (const Faces& faces : faces_) {
      add_object(faces);
    }
    if (emits_) {
      report_emission(diagnostics_);
    }
    for (const std::string_view what : left_out_) {
      diagnostics_.report("import.left-out"_code, {}, fmt::format("{} are left out", what));
    }
    if (!diagnostics_.has_errors()) {
      complete_scene(result_.scene, box_, diagnostics_);
    }
    return std::move(result_);
  }

 private:
  // First the triangles without a material.
  void sort_faces(const ObjMaterials& written) {
    faces_.resize(written.names.size() + 1);
    for (std::size_t i = 0; i < written.names.size(); ++i) {
      faces_[i + 1].material = written.names[i].name;
    }
    constexpr Corners none{mesh_no_index, mesh_no_index, mesh_no_index};
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const std::uint32_t material =
          written.of_triangle.empty() ? mesh_no_index : written.of_triangle[i];
      Faces& faces = faces_[material == mesh_no_index ? 0 : material + 1];
      faces.triangles.push_back(mesh_.triangles[i]);
      faces.uvs.push_back(mesh_.triangle_uvs.empty() ? none : mesh_.triangle_uvs[i]);
      faces.normals.push_back(mesh_.triangle_normals.empty() ? none : mesh_.triangle_normals[i]);
    }
  }

  Result<std::string> fetch(const std::string& name) const {
    return options_.fetch ? options_.fetch(name) : Error{"it is not opened here"};
  }

  // Every library counts, as the format says.
  void read_libraries(const ObjMaterials& written, std::uint64_t bytes) {
    has_libraries_ = !written.libraries.empty();
    std::map<std::string, bool> readable;
    for (const std::vector<FileReference>& line : written.libraries) {
      std::string error;
      bool any = false;
      for (const FileReference& name : line) {
        const auto [entry, is_new] = readable.try_emplace(name.name, true);
        if (is_new) {
          const Result<std::string> text = fetch(name.name);
          if (text) {
            add_library(*text, name.name, bytes);
          } else {
            entry->second = false;
            error = text.error().text;
          }
        }
        any = any || entry->second;
      }
      if (!any && !error.empty()) {
        diagnostics_.report(
            "import.missing-file"_code, line.back().location,
            fmt::format("the materials {}: {}", quoted(line.back().name, 400), error));
      }
    }
  }

  // The first material of a name counts.
  void add_library(const std::string& text, const std::string& name, std::uint64_t& bytes) {
    for (MtlMaterial& material : read_mtl(text, name, options_.limits, bytes, diagnostics_)) {
      std::string key = material.name;
      materials_.try_emplace(std::move(key), std::move(material));
    }
  }

  void add_object(const Faces& faces) {
    if (faces.triangles.empty()) {
      return;
    }
    // Keeps the vertices; only the lists of triangles change.
    mesh_.triangles = faces.triangles;
    const auto used = [](const std::vector<Corners>& list) {
      return std::any_of(list.begin(), list.end(),
                         [](const Corners& c) { return c[0] != mesh_no_index; });
    };
    mesh_.triangle_uvs = used(faces.uvs) ? faces.uvs : std::vector<Corners>();
    mesh_.triangle_normals = used(faces.normals) ? faces.normals : std::vector<Corners>();
    const FlatMesh flat = flatten(mesh_);
    box_ = unite(box_, bounds(mesh_));
    Primitive primitive;
    primitive.shape = Shape::mesh;
    primitive.material = material_of(faces.material);
    const std::string name = fmt::format("{}-{}.obj", options_.stem, result_.files.size() + 1);
    result_.files.push_back(
        {name, obj_text({flat.positions, flat.normals, flat.uvs, flat.indices})});
    primitive.mesh_file = name;
    const NodeId node = add_child(result_.scene, result_.scene.root);
    result_.scene.nodes[node].name = node_name(faces.material);
    result_.scene.nodes[node].primitives.push_back(std::move(primitive));
  }

  Material material_of(const std::string& name) {
    const auto found = materials_.find(name);
    if (found == materials_.end()) {
      if (!name.empty() && has_libraries_) {
        diagnostics_.report("import.left-out"_code, {},
                            fmt::format("no library has the material {}", quoted(name)));
      }
      return {};
    }
    Material material = phong_material(found->second);
    emits_ = emits_ || largest(emission_of(found->second)) > 0;
    note_left_out(found->second);
    const std::string picture = this->picture(found->second.diffuse_map.name, material.diffuse);
    if (!picture.empty()) {
      material.texture = TextureUse{picture, 1, 1, {}};
      material.blend = 1;
    }
    return material;
  }

  void note_left_out(const MtlMaterial& mtl) {
    const std::pair<std::string_view, bool> maps[] = {
        {"pictures of emission", has_emission_map(mtl)},
        {"pictures of highlights", !mtl.specular_map.name.empty()},
        {"masks by alpha", mtl.has_alpha_map},
        {"bump and normal maps", mtl.has_bump_map}};
    for (const auto& [what, used] : maps) {
      if (used) {
        left_out_.insert(what);
      }
    }
  }

  // The picture multiplied by the diffuse color, as a file of the scene; empty if there is none.
  std::string picture(const std::string& file, const glm::vec3& factor) {
    if (file.empty()) {
      return {};
    }
    const auto [entry, is_new] = pictures_.try_emplace({file, factor.x, factor.y, factor.z});
    if (!is_new) {
      return entry->second;
    }
    const Result<std::string> bytes = fetch(file);
    Result<Texture> texture =
        bytes ? decode_image(*bytes, options_.limits, texture_budget_) : Error{bytes.error().text};
    if (!texture) {
      const Error& error = texture.error();
      const std::string name = quoted(file, 400);
      error.kind == ErrorKind::limit
          ? diagnostics_.report("import.limit"_code, {}, fmt::format("{}: {}", name, error.text))
          : diagnostics_.report("import.missing-file"_code, {},
                                fmt::format("the picture {}: {}", name, error.text));
      return {};
    }
    for (std::size_t i = 0; i < texture->rgb.size(); ++i) {
      texture->rgb[i] =
          quantize(factor[static_cast<int>(i % 3)] * (static_cast<float>(texture->rgb[i]) / 255),
                   Rounding::nearest);
    }
    entry->second = add_picture(*texture, options_, result_.files);
    return entry->second;
  }

  std::string_view text_;
  const ImportOptions& options_;
  Diagnostics& diagnostics_;
  Mesh mesh_;
  Bounds box_;
  std::vector<Faces> faces_;
  bool has_libraries_ = false;
  bool emits_ = false;  // a material that is used
  std::set<std::string_view> left_out_;
  std::map<std::string, MtlMaterial, std::less<>> materials_;
  std::map<std::tuple<std::string, float, float, float>, std::string> pictures_;
  std::uint64_t texture_budget_;
  ImportedScene result_;
};

}  // namespace

ImportedScene read_obj_scene(std::string_view text, const ImportOptions& options,
                             Diagnostics& diagnostics) {
  return ObjSceneReader(text, options, diagnostics).read();
}

}  // namespace scenefile
