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

/// The terms that one light contributes.
struct LightTerms {
  std::uint32_t light = 0;
  glm::dvec3 diffuse{0};  ///< without shadows
  glm::dvec3 specular{0};
  glm::dvec3 hidden{0};  ///< removed by shadows
};

/// The terms of what the camera sees, as a sum.
struct Terms {
  glm::dvec3 ambient{0};
  std::vector<LightTerms> lights;
  glm::dvec3 mirror{0};
  glm::dvec3 glass{0};

  glm::dvec3 diffuse() const { return sum(&LightTerms::diffuse); }
  glm::dvec3 specular() const { return sum(&LightTerms::specular); }
  glm::dvec3 hidden() const { return sum(&LightTerms::hidden); }
  glm::dvec3 all() const { return ambient + diffuse() + specular() + mirror + glass; }

 private:
  glm::dvec3 sum(glm::dvec3 LightTerms::*part) const {
    glm::dvec3 total(0);
    for (const LightTerms& l : lights) {
      total += l.*part;
    }
    return total;
  }
};

/// Of the shown sample.
Terms terms_of(const PixelRecord& pixel);

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

/// Whether a color in 1/255, clamped, has this value but for rounding.
bool gives_value(const glm::dvec3& color, const std::array<std::uint8_t, 3>& value);

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
