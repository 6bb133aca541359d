#include "scenefile/mistakes/hypotheses.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/mistakes/hypothesis_list.h"

#include <tuple>

namespace scenefile {

bool shows_at_edges(const Hypothesis& h) {
  return h.cause == Cause::half_pixel_shift || h.cause == Cause::samples;
}

bool replaces_objects(const Hypothesis& h) {
  return h.stage == Stage::shapes && h.cause == Cause::transforms;
}

void add_other_features(HypothesisList& list) {
  const RenderOptions& o = list.view.options;
  if (o.mode == Mode::intersect && o.profile == Profile::course &&
      list.any_type([](LightType type) { return !is_in_intersect(type); })) {
    list.add(
        Cause::features,
        "point lights and spotlights are counted, but the reference's mode only has directional "
        "lights",
        [](Trial& t) { t.mistakes.all_lights = true; });
  }
  if (o.mode == Mode::intersect) {
    list.add(Cause::features,
             "shadows, reflections and textures are drawn, but the reference has none",
             [](Trial& t) {
               t.options.mode = Mode::ray;
               t.options.features = Features();
               t.options.features.texture_filter = false;
               t.options.features.refract = false;
             });
    list.add(Cause::features, "shadows are drawn, but the reference has none", [](Trial& t) {
      t.options.mode = Mode::ray;
      t.options.features = Features{true, false, false, false, false, false, false};
    });
    list.add(Cause::features,
             "point lights, spotlights and shadows are drawn, but the reference has none",
             [](Trial& t) {
               t.options.mode = Mode::ray;
               t.mistakes.all_lights = true;
               t.options.features = Features{true, false, false, false, false, false, false};
             });
  } else if (o.mode == Mode::normals) {
    for (const auto& [mode, features, what] :
         {std::tuple(Mode::ray, Features{true, true, false, true, false, false, false},
                     "the picture is lit, but the reference shows normals as colors"),
          std::tuple(Mode::ray, Features{false, false, false, false, false, false, false},
                     "the picture is lit, without shadows, but the reference shows normals as "
                     "colors"),
          std::tuple(Mode::intersect, Features{false, false, false, false, false, false, false},
                     "the picture is lit by directional lights alone, but the reference shows "
                     "normals as colors")}) {
      list.add(Cause::features, what, [mode = mode, features = features](Trial& t) {
        t.options.mode = mode;
        t.options.features = features;
      });
    }
  } else if (o.mode == Mode::ray) {
    if (!o.features.shadows) {
      list.add(Cause::features, "shadows are drawn, but the reference has none",
               [](Trial& t) { t.options.features.shadows = true; });
    }
    if (!o.features.reflect) {
      list.add(Cause::features, "reflections are drawn, but the reference has none",
               [](Trial& t) { t.options.features.reflect = true; });
    }
    if (!o.features.refract) {
      list.add(Cause::features, "glass is drawn, but the reference has none",
               [](Trial& t) { t.options.features.refract = true; });
    }
    if (!o.features.texture) {
      list.add(Cause::features, "textures are drawn, but the reference has none",
               [](Trial& t) { t.options.features.texture = true; });
    }
    if (o.features.depthoffield && list.scene.camera.aperture > 0) {
      list.add(Cause::features, "there is no depth of field",
               [](Trial& t) { t.options.features.depthoffield = false; });
    }
  }
  using S = ShownInstead;
  if (o.mode != Mode::normals) {
    list.set(Cause::features, &ModelMistakes::shown, S::normals,
             "normals are drawn as colors, (n + 1) / 2, without lighting");
  }
  list.set_each<S>(
      Cause::features, &ModelMistakes::shown,
      {{S::absolute_normals, "normals are drawn as colors, |n|, without lighting"},
       {S::raw_normals, "normals are drawn as colors, without a shift, without lighting"},
       {S::object_normals, "object-space normals are drawn as colors, without lighting"},
       {S::flat_diffuse, "the plain diffuse color is drawn, without lighting"},
       {S::flat_ambient_diffuse, "ambient and diffuse colors are drawn, without lighting"}});
}

// Tried late, because simpler mistakes can also leave out lights.
void add_mode_of_reference(HypothesisList& list) {
  if (list.view.options.mode == Mode::ray) {
    list.add(Cause::features, "the picture is drawn without shadows, reflections and textures",
             [](Trial& t) {
               t.options.features.shadows = t.options.features.reflect = false;
               t.options.features.refract = t.options.features.texture = false;
             });
    list.add(
        Cause::features,
        "point lights and spotlights are not counted, as in the mode that only has directional "
        "lights",
        [](Trial& t) {
          t.options.mode = Mode::intersect;
          t.options.profile = Profile::course;
        });
  }
}

std::vector<Hypothesis> drawing_hypotheses(const SceneView& view, int width, int height) {
  HypothesisList list(view, width, height);
  const bool lit = view.options.mode != Mode::normals;
  add_other_features(list);
  if (lit) {
    add_ambient(list);
    add_diffuse(list);
    add_lights(list);
  }
  add_shadows(list);
  add_normals(list);
  if (lit) {
    add_specular(list);
    add_attenuation(list);
    add_spots(list);
    add_reversed_shading(list);
    add_written_lights(list);
  }
  add_textures(list);
  add_mirrors(list);
  add_glass(list);
  add_depths(list);
  if (lit) {
    // More likely mistakes in textures give the same picture.
    add_brightness_of_light(list);
  }
  add_shapes(list);
  add_nearest(list);
  add_camera(list);
  add_shifts(list);
  add_transforms(list);
  add_mode_of_reference(list);
  list.set(Cause::features, &ModelMistakes::shown, ShownInstead::white,
           "every object is white, without lighting");
  return std::move(list.items);
}

}  // namespace scenefile
