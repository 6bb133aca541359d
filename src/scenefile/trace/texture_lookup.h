#pragma once
// Colors of a texture at (u, v), v up, row 0 of the image on top, wrapping in both directions.
// 8-bit values are linear: the format knows no gamma.

#include "scenefile/asset/image.h"
#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace scenefile {

/// Column and row of the texel that holds the point.
glm::ivec2 texel_at(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv);

/// That texel (course and fine without filter).
glm::dvec3 lookup_nearest(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv);

/// The course's filter: weights are taken from the corner of the texel instead of its middle, so
/// the picture is shifted by half a texel.
glm::dvec3 lookup_course_filter(const Texture& texture, const RenderTexture& use,
                                const glm::dvec2& uv);

/// A texture with its halved copies, each the area average of the one before.
class Pyramid {
 public:
  explicit Pyramid(const Texture& texture);

  bool empty() const { return base_->empty(); }
  int levels() const { return 1 + static_cast<int>(smaller_.size()); }
  const Texture& level(int index) const { return index == 0 ? *base_ : smaller_[index - 1]; }

 private:
  const Texture* base_;
  std::vector<Texture> smaller_;
};

/// The parallelogram of (u, v) that a ray sees, by its sides: how (u, v) change for a step to the
/// right in the picture, and for one down.
struct UvFootprint {
  glm::dvec2 right{0};
  glm::dvec2 down{0};
};

/// Average over the footprint; interpolates between texel middles where the footprint is smaller
/// than a texel. `grid`: 2 to look up each quarter of the footprint by itself.
glm::dvec3 lookup_filtered(const Pyramid& pyramid, const RenderTexture& use, const glm::dvec2& uv,
                           const UvFootprint& footprint, int grid = 1);

}  // namespace scenefile
