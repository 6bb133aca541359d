#pragma once
// The list of mistakes that the functions add_*() fill, each with the mistakes of one subject.
// Of two mistakes that look alike, the one added first is named.

#include "scenefile/mistakes/hypotheses.h"

#include <functional>
#include <initializer_list>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

/// A value of an enumeration in ModelMistakes, and the mistake in words.
template <typename T>
using Row = std::pair<T, const char*>;

struct HypothesisList {
  const SceneView& view;
  const RenderScene& scene;  ///< of the view
  int width = 0;             ///< of the picture, in pixels
  int height = 0;
  std::set<Shape> shapes;     ///< those that the scene uses
  std::set<LightType> types;  ///< of its lights
  std::vector<Hypothesis> items;

  HypothesisList(const SceneView& scene_view, int picture_width, int picture_height);

  bool ray_mode() const { return view.options.mode == Mode::ray; }
  /// Whether the reference shows reflections or refraction.
  bool mirrors() const;
  bool glass() const;
  /// Whether the reference shows shadows.
  bool shadows() const;
  /// Whether the reference shows textures.
  bool textured() const;
  bool any_type(bool (*is)(LightType)) const;
  bool any_light(const std::function<bool(const RenderLight&)>& is) const;
  bool any_material(bool (*is)(const RenderMaterial&)) const;

  void add(Cause cause, std::string_view what, std::function<void(Trial&)> draw,
           Stage stage = Stage::shading);

  /// Each row sets one value in ModelMistakes.
  template <typename T>
  void set_each(Cause cause, T ModelMistakes::*member, std::initializer_list<Row<T>> rows,
                Stage stage = Stage::shading) {
    for (const auto& row : rows) {
      set(cause, member, row.first, row.second, stage);
    }
  }
  template <typename T>
  void set(Cause cause, T ModelMistakes::*member, T value, std::string_view what,
           Stage stage = Stage::shading) {
    add(
        cause, what, [member, value](Trial& t) { t.mistakes.*member = value; }, stage);
  }
};

void add_other_features(HypothesisList& list);
void add_mode_of_reference(HypothesisList& list);

// lighting_hypotheses.cpp: terms of the lighting equation
void add_ambient(HypothesisList& list);
void add_diffuse(HypothesisList& list);
void add_specular(HypothesisList& list);
void add_normals(HypothesisList& list);

// light_hypotheses.cpp
void add_lights(HypothesisList& list);
void add_reversed_shading(HypothesisList& list);
void add_written_lights(HypothesisList& list);
void add_brightness_of_light(HypothesisList& list);
void add_attenuation(HypothesisList& list);
void add_spots(HypothesisList& list);
void add_shadows(HypothesisList& list);

// surface_hypotheses.cpp
void add_textures(HypothesisList& list);
void add_mirrors(HypothesisList& list);
void add_glass(HypothesisList& list);
void add_depths(HypothesisList& list);

// shape_hypotheses.cpp
void add_shapes(HypothesisList& list);
void add_nearest(HypothesisList& list);

// camera_hypotheses.cpp
void add_camera(HypothesisList& list);
void add_shifts(HypothesisList& list);

// transform_hypotheses.cpp
void add_transforms(HypothesisList& list);

}  // namespace scenefile
