#include "scenefile/export/write_obj.h"

#include "scenefile/base/components.h"
#include "scenefile/base/number.h"
#include "scenefile/export/baked_textures.h"
#include "scenefile/export/codes.h"
#include "scenefile/export/flat_mesh.h"
#include "scenefile/export/phong_pbr.h"
#include "scenefile/export/report_once.h"
#include "scenefile/geometry/tessellate.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <utility>

namespace scenefile {

namespace {

class ObjWriter {
 public:
  ObjWriter(const RenderScene& scene, const Assets& assets, const ObjOptions& options,
            Diagnostics& diagnostics)
      : scene_(scene),
        options_(options),
        diagnostics_(diagnostics),
        textures_(assets.textures, PictureEncoding::linear),
        numbers_(scene.materials.size()) {
    for (std::size_t shape = 0; shape < shape_words.size(); ++shape) {
      shapes_.push_back(flatten(tessellate(static_cast<Shape>(shape), options.segments)));
    }
    for (const Mesh& mesh : assets.meshes) {
      meshes_.push_back(flatten(mesh));
    }
  }

  ObjScene write() {
    if (count_triangles() > static_cast<double>(options_.max_triangles)) {
      diagnostics_.report(
          "export.size-limit"_code, {},
          fmt::format("with all instances of its templates the scene has more than {} triangles",
                      options_.max_triangles));
      return {};
    }
    report_once("export.lost"_code, "OBJ files have no lights and no camera", diagnostics_);
    files_.obj = fmt::format("mtllib {}.mtl\n", options_.stem);
    objects();
    if (textures_.clipped()) {
      report_once("export.approximate"_code, "colors over 1 are clamped to 1 in pictures",
                  diagnostics_);
    }
    files_.pictures = textures_.files();
    return std::move(files_);
  }

 private:
  const FlatMesh& mesh_of(const RenderPrimitive& p) const {
    return p.shape == Shape::mesh ? meshes_[p.mesh] : shapes_[static_cast<std::size_t>(p.shape)];
  }

  double count_triangles() const {
    std::vector<double> of_group;
    for (const RenderGroup& group : scene_.groups) {
      double count = 0;
      for (const RenderPrimitive& p : group.primitives) {
        count += static_cast<double>(mesh_of(p).indices.size()) / 3;
      }
      for (const RenderInstance& instance : group.instances) {
        count += of_group[instance.group];
      }
      of_group.push_back(count);
    }
    return of_group.empty() ? 0 : of_group[scene_.root];
  }

  // Expands each instance of each template, without recursion.
  void objects() {
    std::vector<std::pair<std::uint32_t, DAffine>> waiting{{scene_.root, {}}};
    while (!waiting.empty() && !scene_.groups.empty()) {
      const auto [group, world_from_group] = waiting.back();
      waiting.pop_back();
      for (const RenderPrimitive& p : scene_.groups[group].primitives) {
        object(p, world_from_group * DAffine(p.group_from_object));
      }
      const auto& instances = scene_.groups[group].instances;
      for (auto i = instances.rbegin(); i != instances.rend(); ++i) {
        waiting.emplace_back(i->group, world_from_group * DAffine(i->group_from_instance));
      }
    }
  }

  void line(std::string_view word, std::initializer_list<float> values) {
    files_.obj += word;
    for (const float value : values) {
      files_.obj += ' ';
      files_.obj += number_text(value);
    }
    files_.obj += '\n';
  }

  void object(const RenderPrimitive& p, const DAffine& world_from_object) {
    const FlatMesh& mesh = mesh_of(p);
    if (mesh.indices.empty()) {
      return;
    }
    const RenderMaterial& material = scene_.materials[p.material];
    fmt::format_to(std::back_inserter(files_.obj), "o {}_{}\nusemtl m{}\n", word_of(p.shape),
                   ++objects_, material_number(p.material));
    for (const glm::vec3& position : mesh.positions) {
      const glm::vec3 v(world_from_object.point(glm::dvec3(position)));
      line("v", {v.x, v.y, v.z});
    }
    const bool shows = textures_.shows(material);
    for (const glm::vec2& uv : mesh.uvs) {
      // Repeats count from the top of the picture, but v from the bottom.
      const float u = shows ? uv.x * material.texture.repeat_u : uv.x;
      const float v = shows ? 1 - (1 - uv.y) * material.texture.repeat_v : uv.y;
      line("vt", {u, v});
    }
    const DAffine object_from_world = inverse(world_from_object);
    for (const glm::vec3& normal : mesh.normals) {
      const glm::vec3 n(glm::normalize(transform_normal(object_from_world, glm::dvec3(normal))));
      line("vn", {n.x, n.y, n.z});
    }
    faces(mesh, glm::determinant(world_from_object.linear) < 0);
    positions_ += mesh.positions.size();
    uvs_ += mesh.uvs.size();
    normals_ += mesh.normals.size();
  }

  // A reflection reverses the order of the corners, to keep the outside outside.
  void faces(const FlatMesh& mesh, bool mirrored) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      files_.obj += 'f';
      for (const std::size_t k :
           {std::size_t{0}, std::size_t(mirrored ? 2 : 1), std::size_t(mirrored ? 1 : 2)}) {
        const std::uint64_t corner = mesh.indices[i + k] + std::uint64_t{1};
        auto out = std::back_inserter(files_.obj);
        fmt::format_to(out, " {}", positions_ + corner);
        if (!mesh.uvs.empty()) {
          fmt::format_to(out, "/{}", uvs_ + corner);
        } else if (!mesh.normals.empty()) {
          files_.obj += '/';
        }
        if (!mesh.normals.empty()) {
          fmt::format_to(out, "/{}", normals_ + corner);
        }
      }
      files_.obj += '\n';
    }
  }

  std::uint32_t material_number(std::uint32_t index) {
    if (numbers_[index] == 0) {
      numbers_[index] = ++materials_;
      add_material(scene_.materials[index]);
    }
    return numbers_[index];
  }

  void add_material(const RenderMaterial& material) {
    const PhongColors phong = phong_colors(material, scene_.global, options_.transparent);
    const auto color = [&](std::string_view word, const glm::vec3& c) {
      files_.mtl +=
          fmt::format("{} {} {} {}\n", word, number_text(c.x), number_text(c.y), number_text(c.z));
    };
    const bool highlight = phong.shininess > 0 && largest(phong.specular) > 0;
    const bool mirror = largest(phong.reflective) > 0;
    const float through = std::min(1.0f, largest(phong.transparent));
    files_.mtl += fmt::format("newmtl m{}\n", materials_);
    color(options_.path ? "Ke" : "Ka", phong.ambient);
    // Kd multiplies the picture.
    color("Kd", textures_.shows(material) ? glm::vec3(1) : phong.diffuse);
    color("Ks", highlight ? phong.specular : phong.reflective);
    files_.mtl += fmt::format("Ns {}\n", number_text(highlight ? phong.shininess : 0));
    if (through > 0) {
      color("Tf", phong.transparent / through);
      files_.mtl += fmt::format("d {}\nNi {}\n", number_text(1 - through), number_text(phong.ior));
    }
    const int illum = illumination(mirror, through > 0, highlight);
    files_.mtl += fmt::format("illum {}\n", options_.path ? path_illumination(illum) : illum);
    if (textures_.shows(material)) {
      files_.mtl +=
          fmt::format("map_Kd {}-{}.png\n", options_.stem,
                      textures_.bake(material, phong.diffuse, glm::vec3(0), options_.path) + 1);
    }
    files_.mtl += '\n';
    if (mirror && highlight && phong.reflective != phong.specular) {
      report_once("export.approximate"_code, "mirrors take their color from the highlight",
                  diagnostics_);
    }
    if (material.bump_map.used()) {
      report_once("export.lost"_code, "bump maps are left out", diagnostics_);
    }
  }

  // Illumination models of the MTL format by number.
  static int illumination(bool mirror, bool glass, bool highlight) {
    if (glass) {
      return mirror ? 6 : 9;
    }
    return mirror ? 3 : highlight ? 2 : 1;
  }

  // Path tracers of the course know a mirror and glass with Fresnel's reflection.
  static int path_illumination(int illum) {
    return illum >= 6 ? illum_glass : illum == 3 ? illum_mirror : illum;
  }

  const RenderScene& scene_;
  const ObjOptions& options_;
  Diagnostics& diagnostics_;
  BakedTextures textures_;
  std::vector<FlatMesh> shapes_;
  std::vector<FlatMesh> meshes_;
  std::vector<std::uint32_t> numbers_;  // of materials, from 1; 0: not written yet
  std::uint32_t materials_ = 0;
  std::uint64_t objects_ = 0;
  std::uint64_t positions_ = 0;
  std::uint64_t uvs_ = 0;
  std::uint64_t normals_ = 0;
  ObjScene files_;
};

}  // namespace

ObjScene write_obj(const RenderScene& scene, const Assets& assets, const ObjOptions& options,
                   Diagnostics& diagnostics) {
  return ObjWriter(scene, assets, options, diagnostics).write();
}

}  // namespace scenefile
