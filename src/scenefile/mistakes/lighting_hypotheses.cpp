#include "scenefile/base/shape_traits.h"
#include "scenefile/mistakes/hypothesis_list.h"

#include <fmt/format.h>

#include <numbers>

namespace scenefile {

void add_ambient(HypothesisList& list) {
  list.add(Cause::ambient, "the ambient term is missing",
           [](Trial& t) { t.scene.global.ambient = 0; });
  if (list.scene.lights.size() != 2) {
    list.add(Cause::ambient, "the ambient term is added twice",
             [](Trial& t) { t.scene.global.ambient *= 2; });
  }
  if (list.scene.lights.size() > 1) {
    list.add(Cause::ambient, "the ambient term is added once for each light",
             [](Trial& t) { t.scene.global.ambient *= static_cast<float>(t.scene.lights.size()); });
    list.add(Cause::ambient, "the ambient term is added once more for each light", [](Trial& t) {
      t.scene.global.ambient *= static_cast<float>(t.scene.lights.size() + 1);
    });
  }
  if (list.scene.global.ambient != 1) {
    list.add(Cause::ambient, "the ambient term is missing the global coefficient",
             [](Trial& t) { t.scene.global.ambient = 1; });
  }
  using A = AmbientMistake;
  list.set(Cause::ambient, &ModelMistakes::ambient, A::times_diffuse,
           "the ambient color is multiplied by the diffuse color");
  list.set(Cause::ambient, &ModelMistakes::ambient, A::lit_only,
           "the ambient term is added only where a light arrives");
  list.set(Cause::ambient, &ModelMistakes::ambient, A::unlit_only,
           "the ambient term is added only where no light arrives");
  const float ka = list.scene.global.ambient;
  for (const auto& [k, what] :
       {std::pair(list.scene.global.diffuse, "the ambient term has the diffuse coefficient"),
        std::pair(list.scene.global.specular, "the ambient term has the specular coefficient")}) {
    if (k != ka) {
      list.add(Cause::ambient, what, [k = k](Trial& t) { t.scene.global.ambient = k; });
    }
  }
  const auto tinted = [&](const char* what, const glm::vec3& by) {
    list.add(Cause::ambient, what, [by](Trial& t) {
      for (RenderMaterial& m : t.scene.materials) {
        m.ambient *= by;
      }
    });
  };
  if (!list.scene.lights.empty()) {
    glm::vec3 sum(0);
    for (const RenderLight& light : list.scene.lights) {
      sum += light.color;
    }
    tinted("the ambient term is multiplied by the color of each light, and added for each", sum);
    tinted("the ambient term is multiplied by the color of the first light",
           list.scene.lights.front().color);
    if (list.scene.lights.size() > 1) {
      tinted("the ambient term is multiplied by the color of the last light",
             list.scene.lights.back().color);
    }
  }
  if (list.any_type(has_position)) {
    list.set(Cause::ambient, &ModelMistakes::ambient, A::faded,
             "the ambient term is added for each light, times its attenuation and falloff");
    list.set(Cause::ambient, &ModelMistakes::ambient, A::faded_colored,
             "the ambient term is added for each light, times its color, attenuation and falloff");
  }
  if (list.shadows()) {
    list.set(Cause::ambient, &ModelMistakes::ambient, A::faded_shadowed,
             "the ambient term is treated as the other terms: each light adds it, times its color, "
             "attenuation and falloff, except in its shadow");
  }
  list.add(Cause::ambient, "the diffuse color is used as the ambient color", [](Trial& t) {
    for (RenderMaterial& m : t.scene.materials) {
      m.ambient = m.diffuse;
    }
  });
  list.add(Cause::ambient, "the ambient color of the material is ignored", [](Trial& t) {
    for (RenderMaterial& m : t.scene.materials) {
      m.ambient = glm::vec3(1);
    }
  });
  list.add(Cause::ambient, "the specular color is used as the ambient color", [](Trial& t) {
    for (RenderMaterial& m : t.scene.materials) {
      m.ambient = m.specular;
    }
  });
  if (list.textured()) {
    list.set_each<A>(Cause::ambient, &ModelMistakes::ambient,
                     {{A::times_texture, "the ambient term is multiplied by the texture"},
                      {A::only_texture, "the texture replaces the ambient color"},
                      {A::textured, "the ambient color is blended with the texture"}});
  }
  list.add(Cause::ambient, "the coefficient of the ambient term is squared",
           [](Trial& t) { t.scene.global.ambient *= t.scene.global.ambient; });
}

void add_diffuse(HypothesisList& list) {
  using D = DiffuseMistake;
  const RenderGlobal& global = list.scene.global;
  for (const auto& [k, what] :
       {std::pair(global.ambient, "the diffuse term has the ambient coefficient"),
        std::pair(global.specular, "the diffuse term has the specular coefficient")}) {
    if (k != global.diffuse) {
      list.add(Cause::diffuse, what, [k = k](Trial& t) { t.scene.global.diffuse = k; });
    }
  }
  list.set(Cause::diffuse, &ModelMistakes::diffuse_factor, 0.0, "the diffuse term is missing");
  list.set(Cause::diffuse, &ModelMistakes::diffuse_factor, 2.0, "the diffuse term is added twice");
  list.set(Cause::diffuse, &ModelMistakes::diffuse_factor, 1 / std::numbers::pi,
           "the diffuse term is divided by pi");
  const auto put = [&](std::initializer_list<Row<D>> rows) {
    list.set_each(Cause::diffuse, &ModelMistakes::diffuse, rows);
  };
  put({{D::no_coefficient, "the diffuse term is missing the global coefficient"},
       {D::absolute,
        "the diffuse term takes the absolute value of N.L: surfaces are lit from behind"},
       {D::absolute_everywhere,
        "the absolute value of N.L is taken: surfaces are lit from behind, with highlights"},
       {D::not_clamped, "N.L is not clamped to 0: lights darken surfaces that face away"},
       {D::no_cosine, "the diffuse term is missing N.L"},
       {D::by_view, "the diffuse term uses N.V, not N.L"},
       {D::half_lambert, "the diffuse term uses (N.L + 1) / 2, not N.L"},
       {D::squared, "the diffuse term has N.L twice"},
       {D::no_color, "the diffuse term is missing the color of the material"},
       {D::no_light_color, "the diffuse term is missing the color of the light"},
       {D::color_of_ambient, "the diffuse term takes the ambient color"},
       {D::color_of_specular, "the diffuse term takes the specular color"}});
}

void add_specular(HypothesisList& list) {
  if (!list.any_material([](const RenderMaterial& m) { return m.specular != glm::vec3(0); })) {
    return;
  }
  for (const float factor : {0.0f, 2.0f, 0.5f}) {
    list.add(Cause::specular,
             factor == 0   ? "the specular term is missing"
             : factor == 2 ? "the specular term is added twice"
                           : "the specular term is halved",
             [factor](Trial& t) {
               for (RenderMaterial& m : t.scene.materials) {
                 m.specular *= factor;
               }
             });
  }
  const RenderGlobal& global = list.scene.global;
  if (global.specular > 0 && global.diffuse != global.specular) {
    list.add(Cause::specular, "the specular term has the diffuse coefficient",
             [factor = global.diffuse / global.specular](Trial& t) {
               for (RenderMaterial& m : t.scene.materials) {
                 m.specular *= factor;
               }
             });
  }
  using S = SpecularMistake;
  const auto put = [&](std::initializer_list<Row<S>> rows) {
    list.set_each(Cause::specular, &ModelMistakes::specular, rows);
  };
  list.set(Cause::blinn, &ModelMistakes::specular, S::blinn,
           "highlights are Blinn's (N.H)^n, but the equation has Phong's (R.V)^n");
  list.set(Cause::blinn, &ModelMistakes::specular, S::blinn_four,
           "highlights are Blinn's with four times the exponent, but the equation has Phong's "
           "(R.V)^n");
  put({{S::no_coefficient, "the specular term is missing the global coefficient"},
       {S::times_cosine, "the specular term is multiplied by N.L"},
       {S::absolute, "the specular term takes the absolute value of R.V"},
       {S::negative_power, "R.V is not clamped to 0 before it is raised to the exponent"},
       {S::clamped_mirror, "R of the specular term is computed with N.L clamped to 0"},
       {S::no_exponent, "the specular term is missing the exponent"},
       {S::reversed_mirror, "R of the specular term has the wrong sign"},
       {S::by_light_view, "the specular term uses L.V, not R.V"},
       {S::by_normal_view, "the specular term uses N.V, not R.V"},
       {S::by_normal_light, "the specular term uses N.L, not R.V"},
       {S::mirror_not_doubled, "R of the specular term lacks a factor of 2: (N.L) N - L"},
       {S::mirror_of_view_wrong, "the eye vector of the specular term points away from the eye"},
       {S::eye_not_normalized, "the eye vector of the specular term is not normalized"},
       {S::ray_not_normalized, "camera rays are not normalized: the eye vector is too long"},
       {S::half_not_normalized, "highlights are Blinn's, and the vector H is not normalized"},
       {S::eye_as_direction, "the eye vector of the specular term is the eye's position"},
       {S::point_as_direction, "the eye vector of the specular term is the point's position"},
       {S::eye_at_origin, "the eye of the specular term is at the world's origin"},
       {S::looks_along_camera, "the eye vector of the specular term is the same in all pixels"},
       {S::exponent_double, "the exponent of highlights is doubled"},
       {S::exponent_half, "the exponent of highlights is halved"},
       {S::exponent_quarter, "the exponent of highlights is divided by 4"},
       {S::exponent_four, "the exponent of highlights is multiplied by 4"},
       {S::no_color, "the specular term is missing the color of the material"},
       {S::no_light_color, "the specular term is missing the color of the light"},
       {S::diffuse_color, "the specular term takes the diffuse color"},
       {S::times_diffuse, "the specular color is multiplied by the diffuse color"},
       {S::squared_coefficient, "the specular term has the global coefficient twice"},
       {S::times_shininess, "the specular term is multiplied by the exponent"},
       {S::lit_side_only, "highlights are cut off where N.L is below 0"}});
  for (const double exponent : {2.0, 5.0, 10.0, 16.0, 20.0, 32.0, 50.0, 64.0, 100.0}) {
    list.add(Cause::specular, fmt::format("the exponent of highlights is always {}", exponent),
             [exponent](Trial& t) { t.mistakes.exponent = exponent; });
  }
  if (list.any_material(
          [](const RenderMaterial& m) { return m.specular != glm::vec3(0) && m.shininess == 0; })) {
    put({{S::zero_shines, "an exponent of 0 gives a uniform highlight instead of none"}});
  }
}

void add_normals(HypothesisList& list) {
  using N = NormalMistake;
  const auto put = [&](std::initializer_list<Row<N>> rows) {
    list.set_each(Cause::normals, &ModelMistakes::normals, rows);
  };
  put({{N::by_matrix, "normals are not transformed by the inverse transpose"},
       {N::of_object, "normals are left in the space of the object"},
       {N::by_inverse, "normals are transformed by the inverse, not transposed"},
       {N::by_transpose, "normals are transformed by the transpose, not inverted"},
       {N::inverted, "normals point inward"},
       {N::absolute, "the components of normals are made positive: |n|"},
       {N::toward_eye, "normals are flipped toward the viewer"},
       {N::not_normalized, "normals are not normalized after the transform"},
       {N::raw_not_normalized, "normals are never normalized"},
       {N::gradient_not_normalized, "normals are never normalized (gradients)"},
       {N::cone_gradient_not_normalized,
        "normals are never normalized (points on spheres and cylinders, gradients on cones)"},
       {N::matrix_not_normalized, "normals are transformed like directions, and not normalized"},
       {N::translated, "normals are translated, like points (w = 1)"},
       {N::inverse_translated, "normals are transformed by the inverse, like points (w = 1)"},
       {N::right_translated, "normals are right, but translated, like points (w = 1)"},
       {N::four_normalized,
        "normals are normalized with four components: w is not 0 after the 4x4 inverse transpose"},
       {N::four_normalized_w1,
        "normals are normalized with four components, and w = 1 before the 4x4 matrix"}});
}

}  // namespace scenefile
