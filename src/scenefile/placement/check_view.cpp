#include "scenefile/placement/check_view.h"

#include "scenefile/base/number.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/placement/codes.h"
#include "scenefile/placement/scene_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace scenefile {

namespace {

constexpr glm::vec3 black(0);
constexpr std::string_view nothing_lit = "none of the lights reaches anything visible";

class ViewCheck {
 public:
  ViewCheck(const RenderScene& scene, const Assets& assets, const ViewQuestion& question,
            Diagnostics& diagnostics)
      : scene_(scene),
        assets_(assets),
        question_(question),
        diagnostics_(diagnostics),
        search_(scene, assets) {}

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

 private:
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
}

}  // namespace scenefile
