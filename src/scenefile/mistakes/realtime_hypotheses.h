#pragma once
// The mistakes to try in pictures of the assignment Realtime.

#include "scenefile/mistakes/realtime_picture.h"
#include "scenefile/mistakes/views.h"

#include <functional>
#include <string>
#include <vector>

namespace scenefile {

/// The earliest stage of drawing that a mistake changes; the first ones are the cheapest to test.
enum class RealtimeStage : std::uint8_t {
  picture,  ///< only the finished picture
  shading,  ///< not which triangles are visible
  raster,   ///< which triangles are visible, of the same shapes
  shapes,
};

struct RealtimeHypothesis {
  Cause cause = Cause::rounding;
  std::string what;
  RealtimeStage stage = RealtimeStage::shading;
  std::function<void(RealtimeTrial&)> draw;
  Turn turn;
  std::function<glm::dvec3(const glm::dvec3&)> color;  ///< empty: unchanged
  bool mistake = true;  ///< false: another way of drawing, which programs may choose
};

/// The mistakes that can affect this scene. Of two that look alike, the more common one comes
/// first. `lit`: the view's scene with only the lights of its milestone; must outlive them.
std::vector<RealtimeHypothesis> realtime_hypotheses(const RealtimeView& view,
                                                    const RenderScene& lit, int width, int height);

/// "5,3"
std::string parameters_text(const TessellationParameters& parameters);

}  // namespace scenefile
