#pragma once
// Texture lookup at (u, v), with v up, row 0 of the image at the top, and repetition in both
// directions. 8-bit values are linear: the format has no gamma.

#include "scenefile/asset/image.h"
#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace scenefile {

/// Column and row of the texel that contains the point.
glm::ivec2 texel_at(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv);

/// The color of that texel (course profile, and fine without filtering).
glm::dvec3 lookup_nearest(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv);

/// Interpolates between the centers of texels.
glm::dvec3 lookup_smooth(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv);

/// A texture with its mip levels, each the area average of the previous one.
class MipMap {
 public:
  explicit MipMap(const Texture& texture);

  bool empty() const { return base_->empty(); }
  int levels() const { return 1 + static_cast<int>(smaller_.size()); }
  const Texture& level(int index) const { return index == 0 ? *base_ : smaller_[index - 1]; }

 private:
  const Texture* base_;
  std::vector<Texture> smaller_;
};

}  // namespace scenefile
