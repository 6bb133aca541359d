#pragma once
// The mistakes that are tried.

#include "scenefile/grade/causes.h"

namespace scenefile {

/// A scene that mistakes are made in.
struct Trial {
  RenderScene scene;
  RenderOptions options;
  /// From the middles of the full picture's pixels, in pixels: right and down.
  glm::dvec2 shift{0};
};

/// A mistake: what it does to the drawing of the scene or to the drawn picture.
struct Hypothesis {
  Cause cause = Cause::rounding;
  std::string what;
  std::function<void(Trial&)> draw;                ///< none: only the picture changes
  std::function<Texture(const Texture&)> picture;  ///< none: only the drawing changes
};

/// Those that change the finished picture.
std::vector<Hypothesis> picture_hypotheses();

/// Those that change what is drawn, as far as they make a difference to this scene.
std::vector<Hypothesis> drawing_hypotheses(const SceneView& view);

}  // namespace scenefile
