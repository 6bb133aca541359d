#pragma once
// The value of another program's pixel beside the terms of ours: what would give it.

#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/explain.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// A change of our terms that gives the other value.
struct YoursFit {
  std::string what;     ///< completes "yours equals ours ...": "without the ambient term"
  glm::dvec3 value{0};  ///< what ours is then, in 1/255, not clamped
};

struct Yours {
  std::array<std::uint8_t, 3> value{};
  bool equal = false;          ///< to ours, within the tolerance
  std::vector<YoursFit> fits;  ///< the simplest first; empty: nothing that is known gives it
};

/// How far a fit may be off, in 1/255: rounding on both sides.
inline constexpr double yours_tolerance = 1.5;

/// Compares the shown sample of the pixel, its terms left out, doubled or made otherwise, with
/// `value`. A fit is evidence, not proof: other mistakes may give the same color at one pixel.
Yours compare_with_yours(const RenderScene& scene, const PixelRecord& pixel,
                         const std::array<std::uint8_t, 3>& value);

}  // namespace scenefile
