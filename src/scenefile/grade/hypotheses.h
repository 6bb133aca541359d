#pragma once
// The mistakes that are tried.

#include "scenefile/grade/causes.h"
#include "scenefile/grade/mistakes.h"

#include <functional>
#include <string>
#include <vector>

namespace scenefile {

/// A scene that mistakes are made in. Its groups are empty for mistakes that leave the shapes as
/// they are.
struct Trial {
  RenderScene scene;
  RenderOptions options;
  ModelMistakes mistakes;
  glm::dvec2 shift{0};  ///< from the middles of pixels, in pixels: right and down
};

/// What of a drawing a mistake touches; the first kinds cost less.
enum class Touches : std::uint8_t {
  picture,  ///< the finished picture alone
  shading,  ///< what rays meet stays
  hits,     ///< what rays meet, among the same shapes
  camera,
  shapes,
};

/// Where in a picture its pixels come from.
struct Turn {
  bool across = false;
  bool down = false;
  friend bool operator==(const Turn&, const Turn&) = default;
};

/// A mistake: what it does to the drawing of the scene or to the drawn picture.
struct Hypothesis {
  Cause cause = Cause::rounding;
  std::string what;
  Touches touches = Touches::shading;
  std::function<void(Trial&)> draw;
  Turn turn;
  /// Of a color that is not clamped yet; none: it stays.
  std::function<glm::dvec3(const glm::dvec3&)> color;
};

/// Those that change the finished picture.
std::vector<Hypothesis> picture_hypotheses();

/// Those that change what is drawn, as far as they can make a difference to this scene; the more
/// common of two that look alike comes first.
std::vector<Hypothesis> drawing_hypotheses(const SceneView& view, int width, int height);

}  // namespace scenefile
