#include "scenefile/grade/hypotheses.h"

#include "scenefile/base/limits.h"
#include "scenefile/grade/model.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/transforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

namespace scenefile {

namespace {

using glm::dvec3;
using Hypotheses = std::vector<Hypothesis>;

using std::numbers::pi;

double srgb_code(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

double srgb_value(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

void add_picture(Hypotheses& list, Cause cause, std::string what,
                 std::function<dvec3(const dvec3&)> color) {
  list.push_back({cause, std::move(what), Touches::picture, {}, {}, std::move(color)});
}

void add_curve(Hypotheses& list, std::string what, double (*curve)(double)) {
  add_picture(list, Cause::gamma, std::move(what), [curve](const dvec3& color) {
    const dvec3 c = clamped(color);
    return dvec3(curve(c.x), curve(c.y), curve(c.z));
  });
}

void add_gamma(Hypotheses& list) {
  add_curve(list, "gamma 2.2 was applied, but the format has no gamma correction",
            [](double v) { return std::pow(v, 1 / 2.2); });
  add_curve(list, "values were taken to the power of 2.2 (gamma the wrong way)",
            [](double v) { return std::pow(v, 2.2); });
  add_curve(list, "gamma 2 was applied (a square root), but the format has no gamma correction",
            [](double v) { return std::sqrt(v); });
  add_curve(list, "gamma 1.8 was applied, but the format has no gamma correction",
            [](double v) { return std::pow(v, 1 / 1.8); });
  add_curve(list, "values were squared", [](double v) { return v * v; });
  add_curve(list, "values were taken to the power of 1.8",
            [](double v) { return std::pow(v, 1.8); });
  add_curve(list, "values were encoded as sRGB, but the format has no gamma correction", srgb_code);
  add_curve(list, "values were decoded from sRGB, but the format has no gamma correction",
            srgb_value);
  add_curve(list, "values were tone mapped (x / (1 + x)), but the format has no tone mapping",
            [](double v) { return v / (1 + v); });
}

void add_brightness(Hypotheses& list) {
  for (const auto& [factor, what] :
       {std::pair(0.5, "the picture is half as bright"),
        std::pair(2.0, "the picture is twice as bright"),
        std::pair(0.25, "the picture has a quarter of its brightness"),
        std::pair(4.0, "the picture is four times as bright"),
        std::pair(1 / 3.0, "the picture has a third of its brightness"),
        std::pair(1 / 1.5, "the picture has two thirds of its brightness"),
        std::pair(1.5, "the picture is one and a half times as bright")}) {
    add_picture(list, Cause::brightness, what,
                [factor = factor](const dvec3& c) { return factor * clamped(c); });
  }
  add_picture(list, Cause::brightness, "the picture is a negative",
              [](const dvec3& c) { return 1.0 - clamped(c); });
  add_picture(list, Cause::brightness, "the picture is gray", [](const dvec3& color) {
    const dvec3 c = clamped(color);
    return dvec3((c.x + c.y + c.z) / 3);
  });
  add_picture(list, Cause::brightness, "the picture is gray (by luminance)",
              [](const dvec3& color) {
                const dvec3 c = clamped(color);
                return dvec3(0.299 * c.x + 0.587 * c.y + 0.114 * c.z);
              });
  static constexpr std::array<const char*, 3> names{"red", "green", "blue"};
  for (int channel = 0; channel < 3; ++channel) {
    add_picture(list, Cause::swapped_channels,
                fmt::format("the {} of the picture is missing", names[channel]),
                [channel](const dvec3& color) {
                  dvec3 c = clamped(color);
                  c[channel] = 0;
                  return c;
                });
    add_picture(list, Cause::swapped_channels,
                fmt::format("only the {} of the picture is stored", names[channel]),
                [channel](const dvec3& color) {
                  dvec3 c(0);
                  c[channel] = clamped(color)[channel];
                  return c;
                });
    add_picture(list, Cause::swapped_channels,
                fmt::format("the {} of the picture is stored in all channels", names[channel]),
                [channel](const dvec3& color) { return dvec3(clamped(color)[channel]); });
  }
}

void add_overflow(Hypotheses& list) {
  add_picture(list, Cause::overflow, "values over 1 wrap around to dark: they are not clamped",
              [](const dvec3& color) {
                dvec3 c;
                for (int i = 0; i < 3; ++i) {
                  const double whole = std::floor(255 * std::max(color[i], 0.0));
                  c[i] = (whole - 256 * std::floor(whole / 256)) / 255;
                }
                return c;
              });
  add_picture(list, Cause::overflow,
              "values over 1 wrap around to dark: they are multiplied by 256 and not clamped",
              [](const dvec3& color) {
                dvec3 c;
                for (int i = 0; i < 3; ++i) {
                  const double whole = std::floor(256 * std::max(color[i], 0.0));
                  c[i] = (whole - 256 * std::floor(whole / 256)) / 255;
                }
                return c;
              });
  add_picture(list, Cause::overflow, "colors over 1 are scaled down by their maximum",
              [](const dvec3& color) {
                const double most = std::max({color.x, color.y, color.z, 1.0});
                return color / most;
              });
  add_picture(list, Cause::overflow, "colors over 1 become black", [](const dvec3& color) {
    return std::max({color.x, color.y, color.z}) > 1 ? dvec3(0) : color;
  });
  add_picture(list, Cause::overflow, "values over 1 become 0", [](const dvec3& color) {
    return dvec3(color.x > 1 ? 0 : color.x, color.y > 1 ? 0 : color.y, color.z > 1 ? 0 : color.z);
  });
  add_picture(list, Cause::overflow, "colors are scaled to full brightness", [](const dvec3& c) {
    const double most = std::max({c.x, c.y, c.z});
    return most > 0 ? c / most : c;
  });
}

// Mistakes in how a program computes the matrices of a scene's nodes.
struct PlacingRules {
  bool nesting_reversed = false;    // the matrix of the inner node acts last
  bool listed_reversed = false;     // the first listed transform acts first
  bool not_restored = false;        // the matrix of a node also applies to its next siblings
  bool written_transposed = false;  // rows of the file's matrices are read as columns
  bool transposed = false;          // for shapes
  bool inverted = false;            // for shapes
  bool lights_stay = false;         // lights ignore the transforms of their nodes
};

bool any_light(const RenderScene& scene, const std::function<bool(const RenderLight&)>& is) {
  return std::any_of(scene.lights.begin(), scene.lights.end(), is);
}

bool any_material(const RenderScene& scene, bool (*is)(const RenderMaterial&)) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), is);
}

// A light as written in the file, in world space, for a light of the render scene.
struct WrittenLight {
  dvec3 position{0};
  double length = 1;  // of the direction
};

// Calls `found` with each node and its matrix, once per instance.
struct Placing {
  const Scene& scene;
  const PlacingRules& rules;
  std::function<void(const Node&, const glm::dmat4&)> found;
  std::size_t left = 20000;  // maximum number of nodes to visit

  static glm::dmat4 matrix_of(const DAffine& a) {
    return {glm::dvec4(a.linear[0], 0), glm::dvec4(a.linear[1], 0), glm::dvec4(a.linear[2], 0),
            glm::dvec4(a.offset, 1)};
  }

  glm::dmat4 own(const Node& node) const {
    glm::dmat4 product(1);
    for (const Transform& t : node.transforms) {
      const auto* const written = std::get_if<Matrix>(&t.map);
      const glm::dmat4 m = written != nullptr && rules.written_transposed
                               ? glm::transpose(glm::dmat4(written->m()))
                               : matrix_of(composed(DAffine(), t));
      product = rules.listed_reversed ? m * product : product * m;
    }
    return product;
  }

  // Returns false if there are too many nodes. NOLINTNEXTLINE(misc-no-recursion): limited depth
  bool visit(NodeId id, glm::dmat4& parent, int depth) {
    if (left-- == 0 || depth > 200) {
      left = 0;
      return false;
    }
    const Node& node = scene.nodes[id];
    glm::dmat4 matrix = rules.nesting_reversed ? own(node) * parent : parent * own(node);
    found(node, matrix);
    for (const NodeId child : node.children) {
      if (!visit(child, matrix, depth + 1)) {
        return false;
      }
    }
    const std::string wanted(node.instance_of);
    for (const NodeId id_of_template : scene.templates) {
      if (!wanted.empty() && std::string(scene.nodes[id_of_template].name) == wanted) {
        return visit(id_of_template, matrix, depth + 1);
      }
    }
    if (rules.not_restored) {
      parent = matrix;
    }
    return true;
  }
};

std::vector<WrittenLight> lights_as_written(const Scene& written, const RenderScene& ready) {
  std::vector<std::pair<const Light*, glm::dmat4>> lights;
  const PlacingRules rules;
  Placing placing{written, rules, [&](const Node& node, const glm::dmat4& matrix) {
                    for (const Light& light : node.lights) {
                      lights.emplace_back(&light, matrix);
                    }
                  }};
  glm::dmat4 start(1);
  placing.visit(written.root, start, 0);
  std::vector<WrittenLight> result(ready.lights.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const RenderLight& light = ready.lights[i];
    for (auto& [candidate, matrix] : lights) {
      if (candidate == nullptr || candidate->type != light.type ||
          candidate->color != light.color) {
        continue;
      }
      const dvec3 direction(matrix * glm::dvec4(candidate->direction, 0));
      const dvec3 position(matrix * glm::dvec4(candidate->position, 1));
      const double length = glm::length(direction);
      const bool aimed = light.type == LightType::point ||
                         glm::length(direction - length * dvec3(light.direction)) < 1e-3 * length;
      const bool placed =
          light.type == LightType::directional ||
          glm::length(position - dvec3(light.position)) < 1e-3 * (1 + glm::length(position));
      if (aimed && placed) {
        result[i] = {position, length};
        candidate = nullptr;
        break;
      }
    }
  }
  return result;
}

// Moves each primitive and light to a separate node below the root, with a matrix computed by these
// rules.
bool place_all(Scene& scene, const PlacingRules& rules) {
  Scene flat;
  flat.name = scene.name;
  flat.global = scene.global;
  flat.camera = scene.camera;
  Placing placing{scene, rules, [&](const Node& node, const glm::dmat4& matrix) {
                    const auto add = [&](const glm::dmat4& map) -> Node& {
                      Node& added = flat.nodes[add_child(flat, flat.root)];
                      added.transforms.push_back({Matrix(glm::mat4(map)), {}});
                      return added;
                    };
                    if (!node.primitives.empty()) {
                      // Only the upper three rows of the inverse transform rays to object space.
                      glm::dmat4 to_world = rules.transposed ? glm::transpose(matrix) : matrix;
                      if (!rules.inverted) {
                        glm::dmat4 to_object = glm::inverse(to_world);
                        for (int column = 0; column < 4; ++column) {
                          to_object[column][3] = column == 3 ? 1 : 0;
                        }
                        to_world = glm::inverse(to_object);
                      } else {
                        to_world = glm::inverse(to_world);
                      }
                      add(to_world).primitives = node.primitives;
                    }
                    if (!node.lights.empty()) {
                      add(rules.lights_stay ? glm::dmat4(1) : matrix).lights = node.lights;
                    }
                  }};
  glm::dmat4 start(1);
  if (!placing.visit(scene.root, start, 0)) {
    return false;
  }
  scene = std::move(flat);
  return true;
}

class Maker {
 public:
  Maker(const SceneView& view, int width, int height)
      : view_(view),
        scene_(*view.scene),
        aspect_(static_cast<double>(width) / height),
        width_(width),
        height_(height) {
    for (const RenderGroup& group : scene_.groups) {
      for (const RenderPrimitive& p : group.primitives) {
        shapes_.insert(p.shape);
      }
    }
    for (const RenderLight& light : scene_.lights) {
      types_.insert(light.type);
    }
  }

  Hypotheses all() {
    add_other_features();
    if (view_.options.mode != Mode::normals) {
      add_ambient();
      add_diffuse();
      add_lights();
    }
    add_shadows();
    add_normals();
    if (view_.options.mode != Mode::normals) {
      add_specular();
      add_attenuation();
      add_spots();
      add_rare_lights();
      add_written_lights();
    }
    add_textures();
    add_mirrors();
    add_glass();
    add_depths();
    add_shapes();
    add_nearest();
    add_camera();
    add_shifts();
    add_transforms();
    add_mode_of_reference();
    add(Cause::lights, "no light contributes: only the ambient term is left",
        [](Trial& t) { t.scene.lights.clear(); });
    return std::move(list_);
  }

 private:
  bool ray_mode() const { return view_.options.mode == Mode::ray; }
  bool mirrors() const {
    return ray_mode() && view_.options.features.reflect &&
           any_material(scene_,
                        [](const RenderMaterial& m) { return m.reflective != glm::vec3(0); });
  }
  bool glass() const {
    return ray_mode() && view_.options.features.refract &&
           any_material(scene_,
                        [](const RenderMaterial& m) { return m.transparent != glm::vec3(0); });
  }

  void add(Cause cause, std::string what, std::function<void(Trial&)> draw,
           Touches touches = Touches::shading) {
    list_.push_back({cause, std::move(what), touches, std::move(draw), {}, {}});
  }

  // Sets one value of an enumeration in ModelMistakes.
  template <typename T>
  void set(Cause cause, T ModelMistakes::*member, T value, std::string what,
           Touches touches = Touches::shading) {
    add(
        cause, std::move(what), [member, value](Trial& t) { t.mistakes.*member = value; }, touches);
  }

  void add_other_features() {
    const RenderOptions& o = view_.options;
    if (o.mode == Mode::intersect && o.profile == Profile::course && types_.size() > 0 &&
        !(types_.size() == 1 && types_.contains(LightType::directional))) {
      add(Cause::features,
          "point and spot lights are counted, and the reference is of a mode that only has "
          "directional lights",
          [](Trial& t) { t.mistakes.all_lights = true; });
    }
    if (o.mode == Mode::intersect) {
      add(Cause::features,
          "shadows, reflections and textures are drawn, and the reference has none", [](Trial& t) {
            t.options.mode = Mode::ray;
            t.options.features = Features();
            t.options.features.texture_filter = false;
            t.options.features.refract = false;
          });
      add(Cause::features, "shadows are drawn, and the reference has none", [](Trial& t) {
        t.options.mode = Mode::ray;
        t.options.features = Features{true, false, false, false, false, false, false};
      });
      add(Cause::features,
          "point and spot lights and shadows are drawn, and the reference has none", [](Trial& t) {
            t.options.mode = Mode::ray;
            t.mistakes.all_lights = true;
            t.options.features = Features{true, false, false, false, false, false, false};
          });
    } else if (o.mode == Mode::normals) {
      for (const auto& [mode, features, what] :
           {std::tuple(Mode::ray, Features{true, true, false, true, false, false, false},
                       "the picture is lit, and the reference shows normals as colors"),
            std::tuple(Mode::ray, Features{false, false, false, false, false, false, false},
                       "the picture is lit, without shadows, and the reference shows normals as "
                       "colors"),
            std::tuple(Mode::intersect, Features{false, false, false, false, false, false, false},
                       "the picture is lit by directional lights alone, and the reference shows "
                       "normals as colors")}) {
        add(Cause::features, what, [mode = mode, features = features](Trial& t) {
          t.options.mode = mode;
          t.options.features = features;
        });
      }
    } else if (o.mode == Mode::ray) {
      if (!o.features.shadows) {
        add(Cause::features, "shadows are drawn, and the reference has none",
            [](Trial& t) { t.options.features.shadows = true; });
      }
      if (!o.features.reflect) {
        add(Cause::features, "reflections are drawn, and the reference has none",
            [](Trial& t) { t.options.features.reflect = true; });
      }
      if (!o.features.refract) {
        add(Cause::features, "glass is drawn, and the reference has none",
            [](Trial& t) { t.options.features.refract = true; });
      }
      if (!o.features.texture) {
        add(Cause::features, "textures are drawn, and the reference has none",
            [](Trial& t) { t.options.features.texture = true; });
      }
      if (o.features.depthoffield && scene_.camera.aperture > 0) {
        add(Cause::features, "there is no depth of field",
            [](Trial& t) { t.options.features.depthoffield = false; });
      }
    }
    using S = ShownInstead;
    if (o.mode != Mode::normals) {
      set(Cause::features, &ModelMistakes::shown, S::normals,
          "normals are drawn as colors, (n + 1) / 2, and no lighting");
    }
    set(Cause::features, &ModelMistakes::shown, S::absolute_normals,
        "normals are drawn as colors, |n|, and no lighting");
    set(Cause::features, &ModelMistakes::shown, S::raw_normals,
        "normals are drawn as colors, without a shift, and no lighting");
    set(Cause::features, &ModelMistakes::shown, S::object_normals,
        "normals of the object's own space are drawn as colors, and no lighting");
    set(Cause::features, &ModelMistakes::shown, S::flat_diffuse,
        "the plain diffuse color is drawn, and no lighting");
    set(Cause::features, &ModelMistakes::shown, S::flat_ambient_diffuse,
        "ambient and diffuse colors are drawn, and no lighting");
    set(Cause::features, &ModelMistakes::shown, S::white, "every object is white, and no lighting");
  }

  // Tried late, because simpler mistakes can also leave out lights.
  void add_mode_of_reference() {
    if (view_.options.mode == Mode::ray) {
      add(Cause::features, "the picture is drawn without shadows, reflections and textures",
          [](Trial& t) {
            t.options.features.shadows = t.options.features.reflect = false;
            t.options.features.refract = t.options.features.texture = false;
          });
      add(Cause::features,
          "point and spot lights are not counted: the picture is of a mode that only has "
          "directional lights",
          [](Trial& t) {
            t.options.mode = Mode::intersect;
            t.options.profile = Profile::course;
          });
    }
  }

  void add_ambient() {
    add(Cause::ambient, "the ambient term is missing",
        [](Trial& t) { t.scene.global.ambient = 0; });
    if (scene_.lights.size() != 2) {
      add(Cause::ambient, "the ambient term is added twice",
          [](Trial& t) { t.scene.global.ambient *= 2; });
    }
    if (scene_.lights.size() > 1) {
      add(Cause::ambient, "the ambient term is added once for each light",
          [](Trial& t) { t.scene.global.ambient *= static_cast<float>(t.scene.lights.size()); });
      add(Cause::ambient, "the ambient term is added once more for each light", [](Trial& t) {
        t.scene.global.ambient *= static_cast<float>(t.scene.lights.size() + 1);
      });
    }
    if (scene_.global.ambient != 1) {
      add(Cause::ambient, "the ambient term lacks the global coefficient",
          [](Trial& t) { t.scene.global.ambient = 1; });
    }
    using A = AmbientMistake;
    set(Cause::ambient, &ModelMistakes::ambient, A::times_diffuse,
        "the ambient color is multiplied by the diffuse color");
    set(Cause::ambient, &ModelMistakes::ambient, A::lit_only,
        "the ambient term is added only where a light arrives");
    set(Cause::ambient, &ModelMistakes::ambient, A::unlit_only,
        "the ambient term is added only where no light arrives");
    add(Cause::ambient, "the diffuse color is used as the ambient color", [](Trial& t) {
      for (RenderMaterial& m : t.scene.materials) {
        m.ambient = m.diffuse;
      }
    });
    add(Cause::ambient, "the coefficient of the ambient term is squared",
        [](Trial& t) { t.scene.global.ambient *= t.scene.global.ambient; });
  }

  void add_diffuse() {
    using D = DiffuseMistake;
    for (const double factor : {0.0, 2.0, 0.5}) {
      set(Cause::diffuse, &ModelMistakes::diffuse_factor, factor,
          factor == 0   ? "the diffuse term is missing"
          : factor == 2 ? "the diffuse term is added twice"
                        : "the diffuse term is halved");
    }
    set(Cause::diffuse, &ModelMistakes::diffuse_factor, 1 / pi,
        "the diffuse term is divided by pi");
    const auto put = [&](D value, const char* what) {
      set(Cause::diffuse, &ModelMistakes::diffuse, value, what);
    };
    put(D::no_coefficient, "the diffuse term lacks the global coefficient");
    put(D::absolute,
        "the diffuse term takes the absolute value of N.L: surfaces are lit from behind");
    put(D::absolute_everywhere,
        "the absolute value of N.L is taken: surfaces are lit from behind, with highlights");
    put(D::not_clamped, "N.L is not clamped to 0: lights darken surfaces that face away");
    put(D::no_cosine, "the diffuse term lacks N.L");
    put(D::by_view, "the diffuse term uses N.V, not N.L");
    put(D::half_lambert, "the diffuse term uses (N.L + 1) / 2, not N.L");
    put(D::squared, "the diffuse term has N.L twice");
    put(D::no_color, "the diffuse term lacks the color of the material");
    put(D::no_light_color, "the diffuse term lacks the color of the light");
    put(D::color_of_ambient, "the diffuse term takes the ambient color");
    put(D::color_of_specular, "the diffuse term takes the specular color");
  }

  void add_specular() {
    if (!any_material(scene_, [](const RenderMaterial& m) { return m.specular != glm::vec3(0); })) {
      return;
    }
    for (const float factor : {0.0f, 2.0f, 0.5f}) {
      add(Cause::specular,
          factor == 0   ? "the specular term is missing"
          : factor == 2 ? "the specular term is added twice"
                        : "the specular term is halved",
          [factor](Trial& t) {
            for (RenderMaterial& m : t.scene.materials) {
              m.specular *= factor;
            }
          });
    }
    using S = SpecularMistake;
    const auto put = [&](S value, const char* what) {
      set(Cause::specular, &ModelMistakes::specular, value, what);
    };
    set(Cause::blinn, &ModelMistakes::specular, S::blinn,
        "highlights are Blinn's (N.H)^n, and the equation has Phong's (R.V)^n");
    set(Cause::blinn, &ModelMistakes::specular, S::blinn_four,
        "highlights are Blinn's with four times the exponent, and the equation has Phong's "
        "(R.V)^n");
    put(S::no_coefficient, "the specular term lacks the global coefficient");
    put(S::times_cosine, "the specular term is multiplied by N.L");
    put(S::absolute, "the specular term takes the absolute value of R.V");
    put(S::negative_power, "R.V is not clamped to 0 before it is raised to the exponent");
    put(S::clamped_mirror, "R of the specular term is computed with N.L clamped to 0");
    put(S::no_exponent, "the specular term lacks the exponent");
    put(S::reversed_mirror, "R of the specular term points the wrong way");
    put(S::by_light_view, "the specular term uses L.V, not R.V");
    put(S::by_normal_view, "the specular term uses N.V, not R.V");
    put(S::mirror_of_view_wrong, "the eye vector of the specular term points away from the eye");
    put(S::eye_at_origin, "the eye of the specular term is at the world's origin");
    put(S::looks_along_camera, "the eye vector of the specular term is the same in all pixels");
    put(S::exponent_double, "the exponent of highlights is doubled");
    put(S::exponent_half, "the exponent of highlights is halved");
    put(S::exponent_quarter, "the exponent of highlights is divided by 4");
    put(S::exponent_four, "the exponent of highlights is multiplied by 4");
    put(S::no_color, "the specular term lacks the color of the material");
    put(S::no_light_color, "the specular term lacks the color of the light");
    put(S::diffuse_color, "the specular term takes the diffuse color");
    put(S::squared_coefficient, "the specular term has the global coefficient twice");
    put(S::times_shininess, "the specular term is multiplied by the exponent");
    put(S::lit_side_only, "highlights are cut off where N.L is below 0");
    if (any_material(scene_, [](const RenderMaterial& m) {
          return m.specular != glm::vec3(0) && m.shininess == 0;
        })) {
      put(S::zero_shines, "an exponent of 0 gives a uniform highlight instead of none");
    }
  }

  void change_lights(Cause cause, std::string what, std::function<void(RenderLight&)> change) {
    add(cause, std::move(what), [change = std::move(change)](Trial& t) {
      std::for_each(t.scene.lights.begin(), t.scene.lights.end(), change);
    });
  }

  void add_lights() {
    using L = LightVectorMistake;
    const bool positional = types_.contains(LightType::point) || types_.contains(LightType::spot);
    const bool directional = types_.contains(LightType::directional);
    const auto put = [&](L value, const char* what) {
      set(Cause::lights, &ModelMistakes::light_vector, value, what);
    };
    if (positional) {
      put(L::not_normalized, "vectors to point and spot lights are not normalized");
    }
    if (positional && directional) {
      put(L::reversed, "vectors to all lights point the wrong way");
    }
    if (directional) {
      put(L::reversed_directional, "directional lights shine the wrong way");
      change_lights(Cause::lights, "directional lights are used as point lights at their position",
                    [](RenderLight& l) {
                      l.type = l.type == LightType::directional ? LightType::point : l.type;
                    });
    }
    if (positional) {
      put(L::reversed_positional, "vectors to point and spot lights point away from them");
      put(L::to_origin, "point lights shine along one direction everywhere");
      change_lights(Cause::lights, "lights are at the world's origin",
                    [](RenderLight& l) { l.position = glm::vec3(0); });
      change_lights(Cause::lights, "the position of lights is negated",
                    [](RenderLight& l) { l.position = -l.position; });
    }
    if (scene_.lights.size() > 1) {
      add(Cause::lights, "only the first light is used",
          [](Trial& t) { t.scene.lights.resize(1); });
      add(Cause::lights, "only the last light is used",
          [](Trial& t) { t.scene.lights.erase(t.scene.lights.begin(), t.scene.lights.end() - 1); });
      add(Cause::lights, "the last light is left out", [](Trial& t) { t.scene.lights.pop_back(); });
      add(Cause::lights, "the first light is left out",
          [](Trial& t) { t.scene.lights.erase(t.scene.lights.begin()); });
      change_lights(Cause::lights, "the light is divided by the number of lights",
                    [n = float(scene_.lights.size())](RenderLight& l) { l.color /= n; });
    }
    for (const LightType type : types_) {
      if (types_.size() > 1) {
        add(Cause::lights, fmt::format("{} lights are left out", word_of(type)), [type](Trial& t) {
          std::erase_if(t.scene.lights, [type](const RenderLight& l) { return l.type == type; });
        });
      }
    }
    if (types_.size() > 2) {
      for (const LightType type : types_) {
        add(Cause::lights, fmt::format("all lights but the {} ones are left out", word_of(type)),
            [type](Trial& t) {
              std::erase_if(t.scene.lights,
                            [type](const RenderLight& l) { return l.type != type; });
            });
      }
    }
    change_lights(Cause::lights, "the color of lights is ignored: they are white",
                  [](RenderLight& l) { l.color = glm::vec3(1); });
    change_lights(Cause::lights, "lights are twice as bright",
                  [](RenderLight& l) { l.color *= 2; });
    change_lights(Cause::lights, "lights are half as bright", [](RenderLight& l) { l.color /= 2; });
  }

  void add_rare_lights() {
    using L = LightVectorMistake;
    const bool positional = types_.contains(LightType::point) || types_.contains(LightType::spot);
    const bool directional = types_.contains(LightType::directional);
    const auto put = [&](L value, const char* what) {
      set(Cause::lights, &ModelMistakes::light_vector, value, what);
    };
    if (positional && directional) {
      put(L::reversed_shading,
          "vectors to all lights point the wrong way in the lighting; shadow rays are right");
    }
    if (directional) {
      put(L::reversed_directional_shading,
          "directional lights shine the wrong way in the lighting; shadow rays are right");
    }
    if (positional) {
      put(L::reversed_positional_shading,
          "vectors to point and spot lights point away from them in the lighting; shadow rays are "
          "right");
    }
  }

  // Mistakes about lights that need the written file, because the prepared scene lacks that
  // information.
  void add_written_lights() {
    if (view_.written == nullptr) {
      return;
    }
    const std::vector<WrittenLight> written = lights_as_written(*view_.written, scene_);
    std::vector<double> lengths;
    bool longer = false;
    bool placed = false;
    for (std::size_t i = 0; i < written.size(); ++i) {
      const bool directed = scene_.lights[i].type == LightType::directional ||
                            scene_.lights[i].type == LightType::spot;
      lengths.push_back(directed ? written[i].length : 1);
      longer = longer || std::abs(lengths.back() - 1) > 0.01;
      placed = placed || (scene_.lights[i].type == LightType::directional &&
                          glm::length(written[i].position) > 1e-3);
    }
    using L = LightVectorMistake;
    const auto put = [&](L value, const char* what) {
      add(Cause::lights, what, [value, lengths](Trial& t) {
        t.mistakes.light_vector = value;
        t.mistakes.light_lengths = lengths;
      });
    };
    if (longer && types_.contains(LightType::directional)) {
      put(L::directional_as_long_as_written, "directions of directional lights are not normalized");
    }
    if (longer && types_.contains(LightType::spot)) {
      put(L::spot_as_long_as_written, "directions of spot lights are not normalized");
    }
    if (longer && types_.contains(LightType::directional) && types_.contains(LightType::spot)) {
      put(L::as_long_as_written, "directions of lights are not normalized");
    }
    if (placed) {
      add(Cause::lights, "the direction of directional lights is read from the position",
          [written](Trial& t) {
            t.mistakes.light_vector = L::position_as_direction;
            for (std::size_t i = 0; i < t.scene.lights.size() && i < written.size(); ++i) {
              if (t.scene.lights[i].type == LightType::directional) {
                t.scene.lights[i].position = glm::vec3(written[i].position);
              }
            }
          });
    } else if (types_.contains(LightType::directional)) {
      set(Cause::lights, &ModelMistakes::light_vector, L::position_as_direction,
          "the direction of directional lights is read from the position");
    }
  }

  void add_attenuation() {
    if (!any_light(scene_, [](const RenderLight& l) { return l.type != LightType::directional; })) {
      return;
    }
    using A = AttenuationMistake;
    const auto put = [&](A value, const char* what) {
      set(Cause::attenuation, &ModelMistakes::attenuation, value, what);
    };
    const bool fades = any_light(scene_, [](const RenderLight& l) {
      return l.type != LightType::directional && l.attenuation != glm::vec3(1, 0, 0);
    });
    put(A::inverse_square, "lights fade by 1 / d^2, not by their coefficients");
    put(A::inverse, "lights fade by 1 / d, not by their coefficients");
    put(A::inverse_square_unlimited,
        "lights fade by 1 / d^2, not limited to 1, not by their coefficients");
    put(A::inverse_unlimited, "lights fade by 1 / d, not limited to 1, not by their coefficients");
    put(A::one_plus_square, "lights fade by 1 / (1 + d^2), not by their coefficients");
    if (!fades) {
      return;
    }
    put(A::absent, "lights do not fade with distance");
    if (any_light(scene_, [](const RenderLight& l) { return l.attenuation.z != 0; })) {
      put(A::no_quadratic, "the quadratic term of the attenuation is missing");
    }
    if (any_light(scene_, [](const RenderLight& l) { return l.attenuation.y != 0; })) {
      put(A::no_linear, "the linear term of the attenuation is missing");
    }
    if (any_light(scene_, [](const RenderLight& l) { return l.attenuation.x != 0; })) {
      put(A::no_constant, "the constant term of the attenuation is missing");
    }
    put(A::not_clamped, "the attenuation is not clamped to 1");
    put(A::squared, "the attenuation is applied twice");
    put(A::multiplied, "light is multiplied by the attenuation polynomial instead of divided");
    put(A::reversed_coefficients, "the coefficients of the attenuation are read in reverse order");
    put(A::diffuse_only, "highlights do not fade with distance");
    put(A::specular_only, "the diffuse term does not fade with distance");
    put(A::one_plus, "1 is added to the attenuation polynomial");
    put(A::squared_distance, "the attenuation uses the squared distance as the distance");
    put(A::clamped_below, "the attenuation is clamped to at least 1 instead of at most 1");
  }

  void add_spots() {
    if (!types_.contains(LightType::spot)) {
      return;
    }
    using S = SpotMistake;
    const auto put = [&](S value, const char* what) {
      set(Cause::spot_falloff, &ModelMistakes::spot, value, what);
    };
    const auto spot = [&](std::string what, void (*change)(RenderLight&)) {
      change_lights(Cause::spot_falloff, std::move(what), [change](RenderLight& l) {
        if (l.type == LightType::spot) {
          change(l);
        }
      });
    };
    spot("spots shine in all directions", [](RenderLight& l) { l.type = LightType::point; });
    spot("spots have no penumbra: full light up to the outer angle",
         [](RenderLight& l) { l.inner_angle = l.outer_angle; });
    put(S::linear, "spots fall off linearly instead of by the smoothstep");
    spot("spots end at their inner angle", [](RenderLight& l) { l.outer_angle = l.inner_angle; });
    spot("the penumbra is outside the angle of the spot, not inside", [](RenderLight& l) {
      const float penumbra = l.outer_angle - l.inner_angle;
      l.inner_angle = l.outer_angle;
      l.outer_angle += penumbra;
    });
    spot("the penumbra is used as the inner angle", [](RenderLight& l) {
      l.inner_angle = std::min(l.outer_angle - l.inner_angle, l.outer_angle);
    });
    spot("inner and outer angle of spots are mixed up: angle and penumbra are swapped",
         [](RenderLight& l) {
           const float penumbra = l.outer_angle - l.inner_angle;
           const float outer = l.outer_angle;
           l.outer_angle = penumbra;
           l.inner_angle = std::max(0.0f, penumbra - outer);
         });
    spot("the angle of spots is that of full light halfway into the penumbra", [](RenderLight& l) {
      const float half = (l.outer_angle - l.inner_angle) / 2;
      l.inner_angle += half;
      l.outer_angle += half;
    });
    spot("spots fall off from their axis, not from the inner angle",
         [](RenderLight& l) { l.inner_angle = 0; });
    spot("the angle of the spot is used as the full angle of the cone", [](RenderLight& l) {
      const float penumbra = l.outer_angle - l.inner_angle;
      l.outer_angle /= 2;
      l.inner_angle = std::max(0.0f, l.outer_angle - penumbra);
    });
    spot("both angles of the spot are halved", [](RenderLight& l) {
      l.inner_angle /= 2;
      l.outer_angle /= 2;
    });
    spot("both angles of the spot are doubled", [](RenderLight& l) {
      l.inner_angle *= 2;
      l.outer_angle *= 2;
    });
    put(S::in_cosine, "the falloff of spots is between cosines, not between angles");
    put(S::linear_in_cosine, "spots fall off linearly between cosines");
    put(S::inverted, "spots are dark inside and bright outside");
    put(S::penumbra_inverted, "the falloff of spots runs the wrong way in the penumbra");
    put(S::no_limit, "spots shine beyond their outer angle");
    put(S::squared, "the falloff of spots is applied twice");
    put(S::cosine_power, "spots fall off by the cosine");
    put(S::reversed_axis, "spots shine backward");
    spot("spots shine along the opposite direction",
         [](RenderLight& l) { l.direction = -l.direction; });
  }

  void add_normals() {
    using N = NormalMistake;
    const auto put = [&](N value, const char* what) {
      set(Cause::normals, &ModelMistakes::normals, value, what);
    };
    put(N::by_matrix, "normals are not transformed by the inverse transpose");
    put(N::of_object, "normals are left in the space of the object");
    put(N::by_inverse, "normals are transformed by the inverse, not transposed");
    put(N::by_transpose, "normals are transformed by the transpose, not inverted");
    put(N::inverted, "normals point inward");
    put(N::toward_eye, "normals are turned toward the eye");
    put(N::not_normalized, "normals are not normalized after the transform");
    put(N::raw_not_normalized, "normals are never normalized");
    put(N::gradient_not_normalized, "normals are never normalized (gradients)");
    put(N::matrix_not_normalized, "normals are transformed like directions, and not normalized");
    put(N::translated, "normals are translated, like points");
  }

  void add_shadows() {
    if (!ray_mode() || !view_.options.features.shadows || scene_.lights.empty()) {
      return;
    }
    add(Cause::shadows, "there are no shadows",
        [](Trial& t) { t.options.features.shadows = false; });
    using S = ShadowMistake;
    const auto put = [&](S value, const char* what) {
      set(Cause::shadows, &ModelMistakes::shadow, value, what);
    };
    const bool positional = types_.contains(LightType::point) || types_.contains(LightType::spot);
    if (positional) {
      put(S::beyond_light, "objects behind a light cast shadows too: the distance is not compared");
    }
    if (scene_.lights.size() > 1) {
      put(S::ambient_only,
          "where one light is shadowed, all are lost: only the ambient term is left");
      put(S::stops, "lights after the first shadowed one are lost");
      put(S::first_light_for_all, "the shadow of the first light counts for all");
    }
    put(S::reversed, "shadow rays point away from the light");
    put(S::black, "shadows are black: the ambient term is lost");
    put(S::no_ambient_if_all, "where every light is shadowed, the ambient term is lost, too");
    put(S::keeps_specular, "shadows remove only the diffuse term");
    put(S::keeps_diffuse, "shadows remove only the specular term");
    put(S::half, "shadows take half of the light");
    if (types_.contains(LightType::spot)) {
      put(S::spot_along_axis, "shadow rays of spots run along the axis of the spot");
      put(S::spot_without, "spots cast no shadows");
    }
    if (types_.contains(LightType::point)) {
      put(S::point_without, "point lights cast no shadows");
    }
    if (types_.contains(LightType::directional)) {
      put(S::directional_without, "directional lights cast no shadows");
      put(S::direction_unnormalized_far, "shadows of directional lights are only 1 unit long");
    }
    if (any_material(scene_,
                     [](const RenderMaterial& m) { return m.transparent != glm::vec3(0); })) {
      put(S::glass_lets_through, "transparent objects cast no shadows");
    }
    put(S::not_own_object, "objects cast no shadow on themselves");
    put(S::any_nearer_than_eye,
        "the distance of occluders is compared with the distance to the eye");
    put(S::unit_length, "only objects nearer than 1 unit cast shadows");
    put(S::point_as_directional, "shadows of point lights are only 1 unit long");
    put(S::from_eye, "shadow rays start at the eye");
    put(S::from_origin, "shadow rays start at the world's origin");
    put(S::squared_distance,
        "the distance of occluders is compared with the square of the light's distance");
    put(S::object_distance, "distances along shadow rays are measured in object space");
    if (types_.contains(LightType::directional)) {
      put(S::directional_ends_at_position,
          "shadow rays of directional lights end at the light's position");
    }
    put(S::light_from_origin, "the light's distance is measured from the world's origin");
    for (const double bias :
         {0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.75, 1.0, 2.0}) {
      set(Cause::shadows, &ModelMistakes::shadow_bias, bias,
          fmt::format("shadow rays start too far from the surface (about {} units)", bias));
    }
    for (const double lift : {0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 1.0}) {
      set(Cause::shadows, &ModelMistakes::shadow_lift, lift,
          fmt::format(
              "shadow rays start too far from the surface (about {} units along the normal)",
              lift));
    }
  }

  void add_textures() {
    if (!ray_mode() || !view_.options.features.texture ||
        !any_material(scene_,
                      [](const RenderMaterial& m) { return m.texture.used() && m.blend != 0; })) {
      return;
    }
    add(Cause::texture, "textures are not drawn",
        [](Trial& t) { t.options.features.texture = false; });
    const auto change = [&](std::string what, void (*change_one)(RenderMaterial&)) {
      add(Cause::texture, std::move(what), [change_one](Trial& t) {
        std::for_each(t.scene.materials.begin(), t.scene.materials.end(), change_one);
      });
    };
    const auto uv = [&](UvMistake value, const char* what) {
      set(Cause::texture, &ModelMistakes::uv, value, what);
    };
    const auto put = [&](TextureMistake value, const char* what) {
      set(Cause::texture, &ModelMistakes::texture, value, what);
    };
    using U = UvMistake;
    using T = TextureMistake;
    uv(U::flip_v, "textures are upside down");
    uv(U::flip_u, "textures are mirrored left to right");
    uv(U::flip_both, "textures are mirrored both ways");
    put(T::swapped_uv, "u and v of textures are swapped");
    change("textures are not repeated",
           [](RenderMaterial& m) { m.texture.repeat_u = m.texture.repeat_v = 1; });
    change("the repeat counts of textures are swapped",
           [](RenderMaterial& m) { std::swap(m.texture.repeat_u, m.texture.repeat_v); });
    put(T::blend_ignored, "the blend of textures is ignored: the texture replaces the color");
    put(T::times_coefficient, "textures are multiplied by the global diffuse coefficient");
    put(T::times_coefficient_no_blend,
        "textures are multiplied by the global diffuse coefficient, and the blend is ignored");
    put(T::times_diffuse, "textures are multiplied by the diffuse color");
    put(T::times_diffuse_no_blend,
        "textures are multiplied by the diffuse color, and the blend is ignored");
    put(T::blend_reversed, "the blend of textures is reversed");
    put(T::added, "textures are added to the diffuse color, not blended with it");
    put(T::blend_drops_color, "the diffuse color's share of the blend is missing");
    put(T::no_coefficient_on_rest,
        "the diffuse color blended with the texture lacks its coefficient");
    put(T::unlit, "textures are drawn without N.L");
    put(T::blue_red, "red and blue of textures are swapped");
    put(T::gray, "textures are gray");
    put(T::lookup_clamped, "textures end at their edges: the lookup does not wrap around");
    put(T::divided_repeat, "u and v are divided by the repeat counts");
    put(T::decoded, "textures are decoded with gamma 2.2");
    if (view_.options.features.texture_filter) {
      set(Cause::features, &ModelMistakes::texture, T::not_filtered,
          "textures are not filtered, and those of the reference are");
    } else {
      set(Cause::features, &ModelMistakes::texture, T::filtered_centered,
          "textures are filtered, and those of the reference are not");
      set(Cause::features, &ModelMistakes::texture, T::filtered,
          "textures are filtered (half a texel off), and those of the reference are not");
    }
    put(T::ambient_too, "the texture replaces the ambient color as well");
    uv(U::round_flip_u, "textures run the wrong way around spheres, cylinders and cones");
    uv(U::half, "textures are rotated by half a turn around spheres, cylinders and cones");
    uv(U::quarter, "textures are rotated by a quarter turn around spheres, cylinders and cones");
    uv(U::three_quarters,
       "textures are rotated by three quarters of a turn around spheres, cylinders and cones");
    uv(U::sphere_linear_v, "v of spheres grows with the height, not with the angle");
    uv(U::sphere_flip_v, "textures are upside down on spheres");
    uv(U::cube_same_faces, "opposite faces of cubes have the same u and v");
    uv(U::flat_flip_u, "textures are mirrored on flat faces");
    uv(U::flat_flip_v, "textures are upside down on flat faces");
    uv(U::caps_flip_v, "textures are upside down on caps");
    uv(U::caps_as_side, "caps are textured like the side");
    uv(U::sphere_missing, "spheres have no texture");
    uv(U::cube_missing, "cubes have no texture");
    uv(U::cylinder_missing, "cylinders have no texture");
    uv(U::cone_missing, "cones have no texture");
    uv(U::caps_missing, "caps have no texture");
    if (any_material(scene_, [](const RenderMaterial& m) {
          return m.texture.repeat_u != m.texture.repeat_v || m.texture.repeat_u != 1;
        })) {
      change("textures repeat only along u", [](RenderMaterial& m) { m.texture.repeat_v = 1; });
      change("textures repeat only along v", [](RenderMaterial& m) { m.texture.repeat_u = 1; });
    }
  }

  void add_mirrors() {
    if (!mirrors()) {
      return;
    }
    if (glass()) {
      add(Cause::reflection, "there are no reflections",
          [](Trial& t) { t.options.features.reflect = false; });
    }
    using M = MirrorMistake;
    const auto put = [&](M value, const char* what) {
      set(Cause::reflection, &ModelMistakes::mirror, value, what);
    };
    put(M::color_ignored, "the reflective color is ignored");
    put(M::no_coefficient, "reflections lack the global specular coefficient");
    put(M::neither, "reflections have no weight: neither coefficient nor reflective color");
    put(M::blended_coefficient,
        "reflections are blended with the lighting (by coefficient and color), not added");
    put(M::blended, "reflections are blended with the lighting (by their color), not added");
    put(M::blended_all, "reflections are blended with the lighting, not added");
    put(M::blended_plain,
        "reflections are blended with the lighting by only the coefficient, not added");
    put(M::averaged, "reflections and lighting are averaged, not added");
    put(M::replaces, "reflections replace the lighting");
    put(M::not_chained,
        "weights are not multiplied along the path: nothing after the first mirror is weighted");
    put(M::last_weight_only,
        "weights are not multiplied along the path: each reflection only has the weight of its "
        "mirror");
    put(M::eye_at_camera,
        "highlights in reflections are computed for the camera, not for the reflected ray");
    put(M::specular_color, "reflections are weighted by the specular color");
    put(M::all_materials, "everything that has highlights reflects");
    put(M::reversed, "reflected rays point into the surface");
    put(M::wrong_sign, "reflected rays have the wrong sign: d + 2 (d.n) n");
    put(M::along_normal, "reflected rays follow the normal");
    put(M::straight, "reflected rays continue straight ahead");
    put(M::no_shadows, "reflections show no shadows");
    put(M::no_ambient, "reflections lack the ambient term");
    put(M::doubled, "reflections are added twice");
    put(M::halved, "reflections are halved");
    put(M::diffuse_coefficient, "reflections are weighted by the diffuse coefficient");
    put(M::no_local, "mirrors are not lit");
    put(M::times_cosine, "reflections are multiplied by N.V");
    put(M::times_diffuse, "reflections are multiplied by the diffuse color");
    put(M::white_background, "reflected rays that hit nothing are white");
    put(M::clamped_never, "reflected colors are not clamped to 1 before they are added");
  }

  void add_glass() {
    if (!glass()) {
      return;
    }
    add(Cause::refraction, "there is no refraction",
        [](Trial& t) { t.options.features.refract = false; });
    using G = GlassMistake;
    const auto put = [&](G value, const char* what) {
      set(Cause::refraction, &ModelMistakes::glass, value, what);
    };
    put(G::eta_inverted, "the ratio of the indices of refraction is inverted");
    put(G::straight, "rays go straight through transparent objects: they are not bent");
    put(G::one_side, "rays are bent on the way in, not on the way out");
    put(G::entering_always, "the ratio of the indices is the same on the way in and out");
    put(G::shaded_inside, "the inner walls of transparent objects are lit and weighted again");
    put(G::no_coefficient, "refraction lacks the global transparent coefficient");
    put(G::color_ignored, "the transparent color is ignored");
    put(G::blended, "refraction is blended with the lighting, not added");
    put(G::no_total_reflection, "total internal reflection is black");
    put(G::black_inside, "rays end inside of transparent objects");
    put(G::mirrored, "transparent objects reflect: the wrong direction is used");
    put(G::times_diffuse, "refraction is multiplied by the diffuse color");
    put(G::no_local, "transparent objects are not lit");
    put(G::ior_one_and_half, "the index of refraction is always 1.5");
    put(G::half, "refraction is halved");
  }

  void add_depths() {
    if (!mirrors() && !glass()) {
      return;
    }
    for (const int depth : {0, 1, 2, 3, 4, 5, 6, 8, 10}) {
      if (depth != view_.options.max_depth && (depth != 0 || mirrors())) {
        add(Cause::recursion_depth,
            depth == 0 && glass()
                ? std::string("there is neither reflection nor refraction (recursion depth 0)")
            : depth == 0 ? std::string("there are no reflections (recursion depth 0)")
                         : fmt::format("the recursion ends at depth {}, not {}", depth,
                                       view_.options.max_depth),
            [depth](Trial& t) { t.options.max_depth = depth; });
      }
    }
  }

  void edit_shapes(std::string what, std::function<void(RenderGroup&)> change) {
    add(
        Cause::shapes, std::move(what),
        [change = std::move(change)](Trial& t) {
          std::for_each(t.scene.groups.begin(), t.scene.groups.end(), change);
        },
        Touches::shapes);
  }

  void add_shapes() {
    const bool cylinder = shapes_.contains(Shape::cylinder);
    const bool cone = shapes_.contains(Shape::cone);
    if (cylinder) {
      set(Cause::shapes, &ModelMistakes::no_cylinder_caps, true, "cylinders have no caps",
          Touches::hits);
    }
    if (cone) {
      set(Cause::shapes, &ModelMistakes::no_cone_cap, true, "cones have no cap", Touches::hits);
    }
    if (cone && cylinder) {
      add(
          Cause::shapes, "cylinders and cones have no caps",
          [](Trial& t) { t.mistakes.no_cylinder_caps = t.mistakes.no_cone_cap = true; },
          Touches::hits);
    }
    if (cone || cylinder) {
      set(Cause::shapes, &ModelMistakes::cap_normals_down, true, "normals of caps are inverted");
    }
    if (cone) {
      using C = ConeNormalMistake;
      const auto put = [&](C value, const char* what) {
        set(Cause::shapes, &ModelMistakes::cone_normal, value, what);
      };
      put(C::level, "normals of cones are horizontal, like those of cylinders");
      put(C::like_sphere, "normals of cones are those of spheres");
      put(C::half_slope, "normals of cones rise too little");
      put(C::double_slope, "normals of cones rise too much");
      put(C::four_slopes, "normals of cones rise far too much");
      put(C::slope_down, "normals of cones point down");
    }
    for (const Shape shape : shapes_) {
      if (shapes_.size() > 1) {
        edit_shapes(fmt::format("{}s are not drawn", plural_stem(shape)), [shape](RenderGroup& g) {
          std::erase_if(g.primitives,
                        [shape](const RenderPrimitive& p) { return p.shape == shape; });
        });
      }
      for (const float factor : {2.0f, 0.5f}) {
        edit_shapes(fmt::format("{}s are {} as large as they should be", plural_stem(shape),
                                factor == 2 ? "twice" : "half"),
                    [shape, factor](RenderGroup& g) {
                      for (RenderPrimitive& p : g.primitives) {
                        p.group_from_object.linear *= p.shape == shape ? factor : 1.0f;
                      }
                    });
      }
      for (const Shape other : {Shape::sphere, Shape::cube}) {
        if (other != shape && shape != Shape::mesh) {
          edit_shapes(fmt::format("{}s are drawn as {}s", plural_stem(shape), plural_stem(other)),
                      [shape, other](RenderGroup& g) {
                        for (RenderPrimitive& p : g.primitives) {
                          p.shape = p.shape == shape ? other : p.shape;
                        }
                      });
        }
      }
    }
    if (cone) {
      edit_shapes("cones are upside down", [](RenderGroup& g) {
        for (RenderPrimitive& p : g.primitives) {
          if (p.shape == Shape::cone) {
            p.group_from_object.linear[1] *= -1.0f;
          }
        }
      });
    }
    edit_shapes("all shapes are twice as large as they should be", [](RenderGroup& g) {
      for (RenderPrimitive& p : g.primitives) {
        p.group_from_object.linear *= 2.0f;
      }
    });
    edit_shapes("all shapes are half as large as they should be", [](RenderGroup& g) {
      for (RenderPrimitive& p : g.primitives) {
        p.group_from_object.linear *= 0.5f;
      }
    });
    add(
        Cause::shapes, "only the first shape is drawn",
        [](Trial& t) {
          bool found = false;
          for (RenderGroup& g : t.scene.groups) {
            if (&g != &t.scene.groups[t.scene.root] || g.primitives.empty() || found) {
              continue;
            }
            g.primitives.resize(1);
            g.instances.clear();
            found = true;
          }
        },
        Touches::shapes);
    add(
        Cause::shapes, "the last shape is missing",
        [](Trial& t) {
          RenderGroup& root = t.scene.groups[t.scene.root];
          if (!root.primitives.empty()) {
            root.primitives.pop_back();
          }
        },
        Touches::shapes);
    add(
        Cause::shapes, "the first shape is missing",
        [](Trial& t) {
          RenderGroup& root = t.scene.groups[t.scene.root];
          if (!root.primitives.empty()) {
            root.primitives.erase(root.primitives.begin());
          }
        },
        Touches::shapes);
  }

  static std::string plural_stem(Shape shape) {
    return shape == Shape::mesh ? "meshe" : std::string(word_of(shape));
  }

  void add_nearest() {
    using N = NearestMistake;
    const auto put = [&](N value, const char* what) {
      set(Cause::nearest_hit, &ModelMistakes::nearest, value, what, Touches::hits);
    };
    put(N::last, "the last object that is hit is shown, not the nearest");
    put(N::first, "the first object that is hit is shown, not the nearest");
    put(N::farthest, "the farthest hit is shown, not the nearest");
    put(N::farthest_object, "the object whose hit is farthest is shown, not the nearest");
    put(N::object_distance, "distances are measured in object space");
    put(N::object_distance_compared, "distances are compared in object space");
    put(N::object_distance_everywhere,
        "distances are measured in object space, also along shadow rays");
    put(N::far_root, "the far side of each object is shown");
    const auto put_behind = [&](N value, const char* what) {
      for (const bool in_reflections : {false, true}) {
        if (!in_reflections || mirrors() || glass()) {
          add(
              Cause::nearest_hit,
              fmt::format("{}{}", what,
                          in_reflections ? ", and reflections show what lies behind them" : ""),
              [=](Trial& t) {
                t.mistakes.nearest = value;
                t.mistakes.behind_in_reflections = in_reflections;
              },
              Touches::hits);
        }
      }
    };
    put_behind(N::behind, "objects behind the camera are shown too");
    put_behind(N::behind_first, "objects behind the camera are shown first");
    put(N::near_root_only, "objects are invisible from inside");
  }

  void edit_camera(std::string what, std::function<void(RenderCamera&)> change) {
    add(
        Cause::camera, std::move(what),
        [change = std::move(change)](Trial& t) { change(t.scene.camera); }, Touches::camera);
  }

  // Scales the width and height of the film.
  void stretch(std::string what, double across, double up) {
    if (std::isfinite(across) && std::isfinite(up)) {
      edit_camera(std::move(what), [=](RenderCamera& c) {
        c.u *= across;
        c.v *= up;
      });
    }
  }

  void add_camera() {
    const double h = scene_.camera.fov_y;
    const double right = std::tan(h / 2);
    const double degrees = h * 180 / pi;
    if (std::abs(aspect_ - 1) > 0.01) {
      stretch("the width angle is computed as aspect times the height angle",
              std::tan(aspect_ * h / 2) / (aspect_ * right), 1);
      stretch("the aspect ratio is ignored: width and height are treated as equal", 1 / aspect_, 1);
      stretch("the height angle is used as the width angle", 1 / aspect_, 1 / aspect_);
      stretch("the aspect ratio is inverted (height by width)", 1 / (aspect_ * aspect_), 1);
      stretch("the height is divided by the aspect ratio, and the width multiplied", 1,
              1 / aspect_);
      stretch("the aspect ratio is applied to the height, not to the width", 1 / aspect_, aspect_);
      stretch("the aspect ratio is applied twice", aspect_, 1);
      stretch("the height angle is divided by the aspect ratio, and it is taken for the width",
              1 / aspect_, std::tan(h / aspect_ / 2) / right);
    }
    stretch("the full field of view is used as the half angle", std::tan(h) / right,
            std::tan(h) / right);
    stretch("a quarter of the field of view is used as the half angle", std::tan(h / 4) / right,
            std::tan(h / 4) / right);
    stretch("the field of view is in degrees instead of radians", std::tan(degrees / 2) / right,
            std::tan(degrees / 2) / right);
    stretch("the field of view is in degrees instead of radians, and not halved",
            std::tan(degrees) / right, std::tan(degrees) / right);
    stretch("the angle itself is used instead of its tangent", h / 2 / right, h / 2 / right);
    stretch("the sine of the angle is used instead of its tangent", std::sin(h / 2) / right,
            std::sin(h / 2) / right);
    stretch("the film is half as large as it should be", 0.5, 0.5);
    stretch("the film is twice as large as it should be", 2, 2);
    stretch("the field of view is ignored: 90 degrees", 1 / right, 1 / right);
    stretch("the field of view is ignored: 45 degrees", std::tan(pi / 8) / right,
            std::tan(pi / 8) / right);
    stretch("the field of view is ignored: 60 degrees", std::tan(pi / 6) / right,
            std::tan(pi / 6) / right);
    stretch("pixel positions are divided by width - 1 and height - 1", width_ / (width_ - 1.0),
            height_ / (height_ - 1.0));
    list_.back().cause = Cause::half_pixel_shift;
    edit_camera("the camera looks backward", [](RenderCamera& c) { c.w = -c.w; });
    edit_camera("the camera looks backward (turned around)", [](RenderCamera& c) {
      c.w = -c.w;
      c.u = -c.u;
    });
    edit_camera("the camera is at the world's origin",
                [](RenderCamera& c) { c.position = dvec3(0); });
    edit_camera("the camera's position is negated",
                [](RenderCamera& c) { c.position = -c.position; });
    edit_camera("the camera's matrix is transposed: it maps to the camera's space",
                [](RenderCamera& c) {
                  const glm::dmat3 axes = glm::transpose(glm::dmat3(c.u, c.v, c.w));
                  c.u = axes[0];
                  c.v = axes[1];
                  c.w = axes[2];
                });
    edit_camera("the camera ignores the up vector: up is the world's y", [](RenderCamera& c) {
      const dvec3 u = glm::cross(dvec3(0, 1, 0), c.w);
      if (glm::length(u) > 1e-6) {
        c.u = glm::normalize(u);
        c.v = glm::cross(c.w, c.u);
      }
    });
    edit_camera("the camera's axes are the world axes", [](RenderCamera& c) {
      c.u = {1, 0, 0};
      c.v = {0, 1, 0};
      c.w = {0, 0, 1};
    });
    edit_camera(
        "the camera looks at the world's origin, not along its direction", [](RenderCamera& c) {
          const dvec3 w = c.position;
          if (glm::length(w) > 1e-6 && glm::length(glm::cross(c.v, glm::normalize(w))) > 1e-6) {
            c.w = glm::normalize(w);
            c.u = glm::normalize(glm::cross(c.v, c.w));
            c.v = glm::cross(c.w, c.u);
          }
        });
    for (const double scale : {1.0, 2.0, 3.0, 5.0, 10.0, glm::length(scene_.camera.position)}) {
      if (scale > 0) {
        add(
            Cause::camera, "rays of the camera are parallel: there is no perspective",
            [scale](Trial& t) { t.mistakes.orthographic = scale; }, Touches::camera);
      }
    }
    if (view_.written != nullptr && view_.written->camera) {
      const Camera& written = *view_.written->camera;
      const dvec3 up(written.up);
      const dvec3 look(written.look);
      if (glm::length(up) > 0 && glm::length(look) > 0) {
        edit_camera("the up vector is not made perpendicular to the view",
                    [up](RenderCamera& c) { c.v = glm::normalize(up); });
        edit_camera("neither right nor up of the camera is normalized",
                    [up](RenderCamera& c) { c.u = glm::cross(-c.w, glm::normalize(up)); });
        edit_camera("the camera's right axis is not normalized, and up is computed from it",
                    [up](RenderCamera& c) {
                      c.u = glm::cross(-c.w, glm::normalize(up));
                      c.v = glm::cross(c.w, c.u);
                    });
        const auto aim = [](RenderCamera& c, const dvec3& direction, const dvec3& upward) {
          const dvec3 w = -direction;
          if (glm::length(w) > 1e-6 && glm::length(glm::cross(upward, w)) > 1e-6) {
            c.w = glm::normalize(w);
            c.u = glm::normalize(glm::cross(upward, c.w));
            c.v = glm::cross(c.w, c.u);
          }
        };
        edit_camera("the look direction is used as a point to look at",
                    [=](RenderCamera& c) { aim(c, look - c.position, up); });
        edit_camera("the point to look at is used as a direction",
                    [=](RenderCamera& c) { aim(c, look + c.position, up); });
        edit_camera("the look direction is not normalized", [=](RenderCamera& c) { c.w = -look; });
      }
    }
  }

  void add_shifts() {
    static constexpr std::array<std::pair<glm::dvec2, const char*>, 8> places{
        {{{-0.5, -0.5}, "upper left corners"},
         {{0.5, 0.5}, "lower right corners"},
         {{-0.5, 0.5}, "lower left corners"},
         {{0.5, -0.5}, "upper right corners"},
         {{-0.5, 0}, "left edges"},
         {{0.5, 0}, "right edges"},
         {{0, -0.5}, "upper edges"},
         {{0, 0.5}, "lower edges"}}};
    for (const auto& [shift, where] : places) {
      add(
          Cause::half_pixel_shift,
          fmt::format("rays go through the {} of pixels, not their centers", where),
          [by = shift](Trial& t) { t.shift = by; }, Touches::camera);
    }
  }

  // Draws a modified scene file. It must use the same assets.
  void rewrite(std::string what, std::function<bool(Scene&)> change) {
    Scene scene = *view_.written;
    if (!change(scene)) {
      return;
    }
    RenderScene changed = prepare(scene, Limits()).scene;
    if (!number_files_alike(changed)) {
      return;
    }
    changed.camera = scene_.camera;
    add(
        Cause::transforms, std::move(what),
        [changed = std::move(changed)](Trial& t) {
          t.scene.groups = changed.groups;
          t.scene.root = changed.root;
          t.scene.materials = changed.materials;
          t.scene.lights = changed.lights;
        },
        Touches::shapes);
  }

  // Gives the files of `changed` the same indices as in the scene.
  bool number_files_alike(RenderScene& changed) const {
    const auto number = [](const std::vector<FileReference>& files, const std::string& name) {
      const auto found = std::find_if(files.begin(), files.end(),
                                      [&](const FileReference& f) { return f.name == name; });
      return found == files.end() ? no_index : static_cast<std::uint32_t>(found - files.begin());
    };
    for (RenderMaterial& m : changed.materials) {
      for (RenderTexture* texture : {&m.texture, &m.bump_map}) {
        if (texture->used()) {
          texture->file = number(scene_.texture_files, changed.texture_files[texture->file].name);
          if (!texture->used()) {
            return false;
          }
        }
      }
    }
    for (RenderGroup& group : changed.groups) {
      for (RenderPrimitive& p : group.primitives) {
        if (p.mesh != no_index) {
          p.mesh = number(scene_.mesh_files, changed.mesh_files[p.mesh].name);
          if (p.mesh == no_index) {
            return false;
          }
        }
      }
    }
    return true;
  }

  void place_each(const char* what, const PlacingRules& rules) {
    rewrite(what, [&](Scene& scene) { return place_all(scene, rules); });
  }

  template <typename Change>
  void rewrite_each(const char* what, const Change& change) {
    rewrite(what, [&](Scene& scene) {
      bool any = false;
      for (Node& node : scene.nodes) {
        for (Transform& transform : node.transforms) {
          any = change(transform) || any;
        }
      }
      return any;
    });
  }

  void add_transforms() {
    static constexpr std::size_t most_nodes = 3000;
    if (view_.written == nullptr || view_.written->nodes.size() > most_nodes) {
      return;
    }
    rewrite("transforms are applied in reverse order", [](Scene& scene) {
      bool any = false;
      for (Node& node : scene.nodes) {
        any = any || node.transforms.size() > 1;
        std::reverse(node.transforms.begin(), node.transforms.end());
      }
      return any;
    });
    const auto turned = [](Transform& t, float factor) {
      Rotate* const rotate = std::get_if<Rotate>(&t.map);
      if (rotate != nullptr) {
        rotate->angle_deg *= factor;
      }
      return rotate != nullptr && rotate->angle_deg != 0;
    };
    rewrite_each("rotations turn the wrong way", [&](Transform& t) { return turned(t, -1); });
    rewrite_each("angles of rotations are in degrees instead of radians",
                 [&](Transform& t) { return turned(t, float(180 / pi)); });
    rewrite_each("angles of rotations are converted to radians twice",
                 [&](Transform& t) { return turned(t, float(pi / 180)); });
    rewrite_each("rotations are ignored", [&](Transform& t) {
      const bool any = std::holds_alternative<Rotate>(t.map);
      if (any) {
        t.map = Translate();
      }
      return any;
    });
    rewrite_each("scalings are ignored", [&](Transform& t) {
      const bool any = std::holds_alternative<Scale>(t.map);
      if (any) {
        t.map = Translate();
      }
      return any;
    });
    rewrite_each("translations are ignored", [&](Transform& t) {
      const bool any = std::holds_alternative<Translate>(t.map);
      if (any) {
        t.map = Translate();
      }
      return any;
    });
    rewrite_each("translations go the wrong way", [&](Transform& t) {
      Translate* const move = std::get_if<Translate>(&t.map);
      if (move != nullptr) {
        move->by = -move->by;
      }
      return move != nullptr;
    });
    rewrite_each("matrices are ignored", [&](Transform& t) {
      const bool any = std::holds_alternative<Matrix>(t.map);
      if (any) {
        t.map = Translate();
      }
      return any;
    });
    rewrite_each("the axes of rotations are not normalized", [&](Transform& t) {
      // Like glm::rotate with an axis that is not normalized; approximated by a scaled angle.
      Rotate* const rotate = std::get_if<Rotate>(&t.map);
      if (rotate == nullptr || std::abs(glm::length(rotate->axis) - 1) < 1e-4f) {
        return false;
      }
      const glm::vec3 a = rotate->axis;
      const float s = std::sin(glm::radians(rotate->angle_deg));
      const float c = std::cos(glm::radians(rotate->angle_deg));
      glm::mat4 m(1);
      const glm::mat3 cross(0, a.z, -a.y, -a.z, 0, a.x, a.y, -a.x, 0);
      const glm::mat3 rotation = c * glm::mat3(1) + (1 - c) * glm::outerProduct(a, a) + s * cross;
      m[0] = glm::vec4(rotation[0], 0);
      m[1] = glm::vec4(rotation[1], 0);
      m[2] = glm::vec4(rotation[2], 0);
      t.map = Matrix(m);
      return true;
    });
    rewrite("transforms of outer blocks are ignored", [](Scene& scene) {
      bool any = false;
      for (Node& node : scene.nodes) {
        if (!node.children.empty() && !node.transforms.empty()) {
          node.transforms.clear();
          any = true;
        }
      }
      return any;
    });
    rewrite("transforms of inner blocks replace those of outer ones", [](Scene& scene) {
      bool any = false;
      for (Node& node : scene.nodes) {
        if (node.children.empty() || node.transforms.empty()) {
          continue;
        }
        bool inner = true;
        for (const NodeId child : node.children) {
          inner = inner && !scene.nodes[child].transforms.empty();
        }
        if (inner) {
          node.transforms.clear();
          any = true;
        }
      }
      return any;
    });
    rewrite("all transforms are ignored", [](Scene& scene) {
      bool any = false;
      for (Node& node : scene.nodes) {
        any = any || !node.transforms.empty();
        node.transforms.clear();
      }
      return any;
    });
    place_each("matrices of nested blocks are multiplied in the wrong order",
               {.nesting_reversed = true});
    place_each("all matrices are multiplied in the wrong order",
               {.nesting_reversed = true, .listed_reversed = true});
    place_each("the matrix is not restored after a block: its transforms also apply to the next",
               {.not_restored = true});
    place_each("object-to-world matrices are transposed", {.transposed = true});
    place_each("matrices of the file are transposed", {.written_transposed = true});
    place_each("rays are transformed by the object-to-world matrix, not by its inverse",
               {.inverted = true});
    place_each("lights are not moved by the transforms of their blocks", {.lights_stay = true});
    rewrite("the last transform of each block is missing", [](Scene& scene) {
      bool any = false;
      for (Node& node : scene.nodes) {
        if (node.transforms.size() > 1) {
          node.transforms.pop_back();
          any = true;
        }
      }
      return any;
    });
    rewrite("the first transform of each block is missing", [](Scene& scene) {
      bool any = false;
      for (Node& node : scene.nodes) {
        if (node.transforms.size() > 1) {
          node.transforms.erase(node.transforms.begin());
          any = true;
        }
      }
      return any;
    });
  }

  const SceneView& view_;
  const RenderScene& scene_;
  double aspect_;
  double width_;
  double height_;
  std::set<Shape> shapes_;
  std::set<LightType> types_;
  Hypotheses list_;
};

}  // namespace

std::vector<Hypothesis> picture_hypotheses() {
  Hypotheses list;
  const auto turned = [&](Cause cause, const char* what, bool across, bool down) {
    list.push_back({cause, what, Touches::picture, {}, {across, down}, {}});
  };
  turned(Cause::vertical_flip, "the picture is upside down (mirrored top to bottom)", false, true);
  turned(Cause::horizontal_flip, "the picture is mirrored left to right", true, false);
  turned(Cause::vertical_flip, "the picture is rotated by half a turn (mirrored both ways)", true,
         true);
  static constexpr std::array<std::pair<std::array<int, 3>, const char*>, 5> orders{
      {{{2, 1, 0}, "blue, green, red"},
       {{1, 0, 2}, "green, red, blue"},
       {{0, 2, 1}, "red, blue, green"},
       {{1, 2, 0}, "green, blue, red"},
       {{2, 0, 1}, "blue, red, green"}}};
  for (const auto& [order, said] : orders) {
    add_picture(list, Cause::swapped_channels,
                fmt::format("the channels are in the order {}", said),
                [o = order](const dvec3& c) { return dvec3(c[o[0]], c[o[1]], c[o[2]]); });
  }
  add_gamma(list);
  add_brightness(list);
  add_overflow(list);
  return list;
}

std::vector<Hypothesis> drawing_hypotheses(const SceneView& view, int width, int height) {
  return Maker(view, width, height).all();
}

}  // namespace scenefile
