#pragma once
// A ray tracer as a student would write it: single precision, one ray a pixel, no acceleration, and
// nothing shared with the project's tracer. It can make the mistakes that students make.

#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/render_scene.h"

namespace scenefile::grade_test {

struct Plan {
  int width = 96;
  int height = 72;
  int depth = 4;  ///< reflections
  float pixel_x = 0.5f;
  float pixel_y = 0.5f;
  float ambient = 1;  ///< factors of the terms
  float diffuse = 1;
  float specular = 1;
  bool blinn = false;
  bool attenuation = true;
  bool inverse_transpose = true;
  bool shadows = true;
  bool offset = true;  ///< of rays that start on surfaces
  bool texture_up = false;
  bool repeat = true;
  enum class Spot { smooth, linear, hard, none, outside } spot = Spot::smooth;
  bool round = false;
};

/// Spheres, cubes and cylinders of the root group.
Texture draw(const RenderScene& scene, const Assets& assets, const Plan& plan);

}  // namespace scenefile::grade_test
