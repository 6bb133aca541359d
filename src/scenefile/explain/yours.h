#pragma once
// Compares a pixel of another program with the terms of ours, to find out what would explain its
// value.

#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/explain.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace scenefile {

/// A change of our terms, such as a known mistake, that gives the other value.
struct YoursFit {
  std::string what;     ///< completes "yours equals ours ...": "without the ambient term"
  glm::dvec3 value{0};  ///< the changed value of ours, in 1/255, not clamped
};

struct Yours {
  std::array<std::uint8_t, 3> value{};
  bool equal = false;          ///< both values are equal, within the tolerance
  std::vector<YoursFit> fits;  ///< the simplest first; empty: no known change gives it
};

/// The tolerance of a fit, in 1/255: both values are rounded.
inline constexpr double yours_tolerance = 1.5;

/// The color of a picture's pixel, from the colors of the records that it is mixed from.
using PixelOf = std::function<glm::dvec3(std::span<const glm::dvec3>)>;

/// Compares a pixel that is mixed from several records with `value`, leaving out, doubling or
/// changing the same term in all of them. There is at least one record; the first one is the most
/// important.
Yours compare_with_yours(const RenderScene& scene, std::span<const PixelRecord> records,
                         const PixelOf& pixel_of, const std::array<std::uint8_t, 3>& value);

/// The same for the shown sample of a pixel. A fit is evidence, not proof: other mistakes may give
/// the same color at one pixel.
Yours compare_with_yours(const RenderScene& scene, const PixelRecord& pixel,
                         const std::array<std::uint8_t, 3>& value);

}  // namespace scenefile
