#include "scenefile/import/read_obj_scene.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/asset/obj_corner.h"
#include "scenefile/asset/obj_words.h"
#include "scenefile/asset/read_obj.h"
#include "scenefile/base/text.h"
#include "scenefile/export/flat_mesh.h"
#include "scenefile/import/codes.h"
#include "scenefile/import/complete_scene.h"
#include "scenefile/import/mesh_text.h"
#include "scenefile/import/picture_file.h"
#include "scenefile/import/read_mtl.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
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
    mesh_ = read_obj(text_, "", options_.limits, triangles, bytes, diagnostics_);
    if (diagnostics_.has_errors()) {
      return {};
    }
    if (mesh_.triangles.empty()) {
      diagnostics_.report(import_not_a_model, {}, "the OBJ file has no triangles");
      return {};
    }
    if (mesh_.triangles.size() * obj_bytes_of_triangle > options_.limits.mesh_bytes) {
      diagnostics_.report(
          import_limit, {},
          fmt::format("{} triangles, divided by material, exceed the limit for all meshes",
                      mesh_.triangles.size()));
      return {};
    }
    sort_faces();
    result_.scene.global = {1, 1, 1, 1.0f, {}};
    for (const Faces& faces : faces_) {
      add_object(faces);
    }
    if (!diagnostics_.has_errors()) {
      complete_scene(result_.scene, box_, diagnostics_);
    }
    return std::move(result_);
  }

 private:
  // read_obj() has already validated every statement.
  void sort_faces() {
    ObjWords words(text_);
    CornerLists lists{{"vertex", mesh_.positions.size(), 0},
                      {"uv", mesh_.uvs.size(), 0},
                      {"normal", mesh_.normals.size(), 0}};
    std::size_t current = faces_of("");
    while (words.next_statement()) {
      const std::string_view keyword = words.next_word();
      if (keyword == "v") {
        ++lists.positions.so_far;
      } else if (keyword == "vt") {
        ++lists.uvs.so_far;
      } else if (keyword == "vn") {
        ++lists.normals.so_far;
      } else if (keyword == "usemtl") {
        current = faces_of(words.next_word());
      } else if (keyword == "mtllib") {
        for (std::string_view name = words.next_word(); !name.empty(); name = words.next_word()) {
          read_library(std::string(name), words.location(name));
        }
      } else if (keyword == "f") {
        add_face(words, lists, faces_[current]);
      }
    }
  }

  std::size_t faces_of(std::string_view material) {
    const auto [entry, is_new] = numbers_.try_emplace(std::string(material), faces_.size());
    if (is_new) {
      faces_.push_back({std::string(material), {}, {}, {}});
    }
    return entry->second;
  }

  Result<std::string> fetch(const std::string& name) const {
    return options_.fetch ? options_.fetch(name) : Error{"it is not opened here"};
  }

  void read_library(const std::string& name, Location location) {
    if (!libraries_.emplace(name, true).second) {
      return;
    }
    const Result<std::string> text = fetch(name);
    if (!text) {
      diagnostics_.report(
          import_missing_file, location,
          fmt::format("the materials {}: {}", quoted(name, 400), text.error().text));
      return;
    }
    read_mtl(*text, materials_);
  }

  static void add_face(ObjWords& words, const CornerLists& lists, Faces& faces) {
    std::optional<Corner> first;
    std::optional<Corner> last;
    for (std::string_view word = words.next_word(); !word.empty(); word = words.next_word()) {
      const Result<Corner> corner = parse_corner(word, lists);
      if (!corner) {
        return;
      }
      if (first && last) {
        add_triangle(*first, *last, *corner, faces);
      }
      (first ? last : first) = *corner;
    }
  }

  static void add_triangle(const Corner& a, const Corner& b, const Corner& c, Faces& faces) {
    if (a.position == b.position || b.position == c.position || a.position == c.position) {
      return;
    }
    constexpr Corners none{mesh_no_index, mesh_no_index, mesh_no_index};
    const auto all = [&](const Corners& list) {
      return std::find(list.begin(), list.end(), mesh_no_index) == list.end() ? list : none;
    };
    faces.triangles.push_back({a.position, b.position, c.position});
    faces.uvs.push_back(all({a.uv, b.uv, c.uv}));
    faces.normals.push_back(all({a.normal, b.normal, c.normal}));
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
    result_.scene.nodes[node].name = faces.material.substr(0, 200);
    result_.scene.nodes[node].primitives.push_back(std::move(primitive));
  }

  Material material_of(const std::string& name) {
    const auto found = materials_.find(name);
    if (found == materials_.end()) {
      if (!name.empty() && !libraries_.empty()) {
        diagnostics_.report(import_left_out, {},
                            fmt::format("no library has the material {}", quoted(name)));
      }
      return {};
    }
    Material material = found->second.material;
    const std::string picture = this->picture(found->second);
    if (!picture.empty()) {
      material.texture = TextureUse{picture, 1, 1, {}};
      material.blend = 1;
    }
    return material;
  }

  // The picture multiplied by the diffuse color, as a file of the scene; empty if there is none.
  std::string picture(const MtlMaterial& mtl) {
    if (mtl.picture.empty()) {
      return {};
    }
    const glm::vec3& factor = mtl.material.diffuse;
    const auto [entry, is_new] = pictures_.try_emplace({mtl.picture, factor.x, factor.y, factor.z});
    if (!is_new) {
      return entry->second;
    }
    const Result<std::string> bytes = fetch(mtl.picture);
    Result<Texture> texture =
        bytes ? decode_image(*bytes, options_.limits, texture_budget_) : Error{bytes.error().text};
    if (!texture) {
      const Error& error = texture.error();
      const std::string name = quoted(mtl.picture, 400);
      error.kind == ErrorKind::limit
          ? diagnostics_.report(import_limit, {}, fmt::format("{}: {}", name, error.text))
          : diagnostics_.report(import_missing_file, {},
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
  std::map<std::string, std::size_t, std::less<>> numbers_;
  std::map<std::string, bool> libraries_;
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
