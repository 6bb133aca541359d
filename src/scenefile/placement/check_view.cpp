#include "scenefile/placement/check_view.h"

#include "scenefile/base/components.h"
#include "scenefile/base/number.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/base/text.h"
#include "scenefile/placement/codes.h"
#include "scenefile/placement/scene_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace scenefile {

namespace {

constexpr glm::vec3 black(0);
constexpr float rounding = 1e-4f;
constexpr std::string_view nothing_lit = "none of the lights reaches anything visible";

class ViewCheck {
 public:
  ViewCheck(const RenderScene& scene, const Assets& assets, const ViewQuestion& question,
            Diagnostics& diagnostics)
      : scene_(scene),
        assets_(assets),
        question_(question),
        diagnostics_(diagnostics),
        search_(scene, assets),
        without_uvs_(assets.meshes.size()) {
    for (const MeshMaterials& mesh : assets.mesh_materials) {
      const std::vector<std::uint32_t>& faces = mesh.of_triangle;
      shows_object_.push_back(faces.empty() ||
                              std::find(faces.begin(), faces.end(), mesh_no_index) != faces.end());
    }
  }

  void check_camera() {
    search_.enclosing(scene_.camera.position, scene_.camera.position, [&](const Enclosure& e) {
      diagnostics_.report("camera.inside-object"_code, question_.camera,
                          fmt::format("the camera is inside {}", text_of(*e.primitive)));
      return false;
    });
    if (search_.misses(view_region(scene_.camera, question_.aspect))) {
      diagnostics_.report(
          "camera.nothing-in-view"_code, question_.camera,
          fmt::format("no object is in view of the camera, for any aspect ratio up to {}",
                      number_text(static_cast<float>(question_.aspect))));
    }
  }

  void check_lights() {
    bool any = false;
    bool lit = false;
    for (const RenderLight& light : scene_.lights) {
      if (light.color != black) {
        any = true;
        lit = reaches(light) || lit;
      }
    }
    if (any && (!lit || !answers_light(scene_.global))) {
      diagnostics_.report("scene.unlit"_code, {}, std::string(lit ? dark_text() : nothing_lit));
    }
  }

  void check_materials() {
    const RenderPrimitive* brightest = nullptr;
    float most = 1 + rounding;
    for (const RenderGroup& group : scene_.groups) {
      for (const RenderPrimitive& primitive : group.primitives) {
        check_uvs(primitive);
        const float returned = largest(returned_light(scene_.materials[primitive.material]));
        if (question_.paths && returned > most && shows_its_material(primitive)) {
          brightest = &primitive;
          most = returned;
        }
      }
    }
    if (brightest != nullptr) {
      diagnostics_.report(
          "material.energy"_code, question_.place_of(brightest->source),
          fmt::format("diffuse, specular, reflective and transparent of the {}, each times its "
                      "coefficient, add up to {} in a channel: it returns more light than it "
                      "receives",
                      word_of(brightest->shape), number_text(most)));
    }
  }

 private:
  bool shows_its_material(const RenderPrimitive& primitive) const {
    return primitive.mesh >= shows_object_.size() || shows_object_[primitive.mesh];
  }

  // Summed like the path tracer does. A texture makes a color darker by an unknown amount.
  glm::vec3 returned_light(const RenderMaterial& m) const {
    const RenderGlobal& global = scene_.global;
    const auto positive = [](const glm::vec3& color) { return glm::max(color, black); };
    return (m.texture.used() ? 1 - m.blend : 1) * positive(global.diffuse * m.diffuse) +
           (m.shininess > 0 ? positive(global.specular * m.specular) : black) +
           positive(global.specular * m.reflective) +
           positive(global.transparent.value_or(0.5f) * m.transparent);
  }

  void check_uvs(const RenderPrimitive& primitive) {
    const std::uint32_t index = primitive.mesh;
    if (index >= assets_.meshes.size() || without_uvs_[index]) {
      return;
    }
    const Mesh& mesh = assets_.meshes[index];
    const RenderMaterial& own = scene_.materials[primitive.material];
    const bool textured = (own.texture.used() && own.blend > 0 && shows_its_material(primitive)) ||
                          faces_have_maps(index);
    if (textured && !mesh.triangles.empty() && mesh.triangle_uvs.empty()) {
      without_uvs_[index] = true;
      diagnostics_.report("material.texture-without-uvs"_code, question_.place_of(primitive.source),
                          fmt::format("the mesh {} has no texture coordinates (vt), so its texture "
                                      "shows a single color",
                                      quoted(scene_.mesh_files[index].name)));
    }
  }

  bool faces_have_maps(std::uint32_t mesh) const {
    const auto has_map = [](const FaceMaterial& m) {
      return m.diffuse_map != no_map || m.specular_map != no_map || m.emission_map != no_map;
    };
    if (mesh >= assets_.mesh_materials.size()) {
      return false;
    }
    const std::vector<FaceMaterial>& faces = assets_.mesh_materials[mesh].materials;
    return std::any_of(faces.begin(), faces.end(), has_map);
  }

  // For example "the sphere of line 12".
  std::string text_of(const RenderPrimitive& primitive) const {
    const std::string_view name = word_of(primitive.shape);
    const Location place = question_.place_of(primitive.source);
    return place.known() ? fmt::format("the {} of line {}", name, place.line)
                         : fmt::format("a {}", name);
  }

  // Returns whether the light may contribute to the picture; adds a finding if it cannot.
  bool reaches(const RenderLight& light) {
    if (search_.misses(lit_region(light))) {
      diagnostics_.report("light.misses"_code, question_.place_of(light.source),
                          has_cone(light.type)
                              ? "no object is in the cone of the spotlight"
                              : "no object is on the side that the area light shines on");
      return false;
    }
    return !is_enclosed(light);
  }

  // Whether an opaque object encloses the light, but not the camera. A highlight may still appear
  // on the outside of the object, because N.L < 0 does not suppress it.
  bool is_enclosed(const RenderLight& light) {
    bool shut_in = false;
    if (is_at_a_point(light.type) && question_.shadows) {
      search_.enclosing(
          glm::dvec3(light.position), scene_.camera.position, [&](const Enclosure& e) {
            const RenderMaterial& m = scene_.materials[e.primitive->material];
            if (e.holds_other || is_transparent(m)) {
              return true;
            }
            diagnostics_.report("light.inside-object"_code, question_.place_of(light.source),
                                fmt::format("the light is inside {}", text_of(*e.primitive)));
            shut_in = !has_highlight(scene_.global, m);
            return false;
          });
    }
    return shut_in;
  }

  bool is_transparent(const RenderMaterial& m) const {
    return scene_.global.transparent.value_or(1) != 0 && m.transparent != black;
  }
  static bool has_highlight(const RenderGlobal& global, const RenderMaterial& m) {
    return global.specular != 0 && m.specular != black && m.shininess > 0;
  }
  bool answers_light(const RenderGlobal& global) const {
    return faces_answer_light() || std::any_of(scene_.materials.begin(), scene_.materials.end(),
                                               [&](const RenderMaterial& m) {
                                                 const bool textured =
                                                     m.texture.used() && m.blend > 0;
                                                 return textured || has_highlight(global, m) ||
                                                        (global.diffuse != 0 && m.diffuse != black);
                                               });
  }
  // The materials of faces, which are only loaded for path tracing, have no coefficients.
  bool faces_answer_light() const {
    const auto answers = [](const FaceMaterial& m) {
      return m.diffuse != black || m.specular != black;
    };
    return std::any_of(assets_.mesh_materials.begin(), assets_.mesh_materials.end(),
                       [&](const MeshMaterials& mesh) {
                         return std::any_of(mesh.materials.begin(), mesh.materials.end(), answers);
                       });
  }
  // Why no light is visible.
  std::string_view dark_text() const {
    return answers_light(RenderGlobal())
               ? "the diffuse or specular coefficient of the global data is 0, so that no light is "
                 "visible"
               : "no material has a diffuse or specular part that light could show";
  }

  const RenderScene& scene_;
  const Assets& assets_;
  const ViewQuestion& question_;
  Diagnostics& diagnostics_;
  SceneSearch search_;
  std::vector<bool> shows_object_;  // by mesh: a triangle has no face material
  std::vector<bool> without_uvs_;   // by mesh: reported
};

}  // namespace

void check_view(const RenderScene& scene, const Assets& assets, const ViewQuestion& question,
                Diagnostics& diagnostics) {
  const bool empty = std::all_of(scene.groups.begin(), scene.groups.end(),
                                 [](const RenderGroup& group) { return group.primitives.empty(); });
  if (empty) {
    return;  // reported by check()
  }
  ViewCheck check(scene, assets, question, diagnostics);
  check.check_camera();
  check.check_lights();
  check.check_materials();
}

}  // namespace scenefile
