#pragma once
// Finds a picture inside another one: in a screenshot with a window's frame, or in a part that was
// cut out.

#include "scenefile/asset/image.h"

#include <glm/glm.hpp>

#include <optional>

namespace scenefile {

/// Where a picture is inside another one, in the pixels of the latter.
struct PicturePlace {
  glm::ivec2 corner{0};  ///< upper left corner; negative: cut off
  glm::ivec2 size{0};    ///< of the whole picture, with what was cut off

  friend bool operator==(const PicturePlace&, const PicturePlace&) = default;
};

/// The place of `reference` in `shown`, at any size, but with its aspect ratio: where the
/// directions of most edges agree, so that the colors may be wrong. At most 40 % may be cut off.
/// nullopt if there is no such place, or if `shown` as a whole is as good: a picture of the same
/// scene, at another size and with the same height angle.
std::optional<PicturePlace> find_picture(const Texture& reference, const Texture& shown);

/// The place of a picture next to the one at `place`, of the same size, if that one is the
/// reference itself, as in a window that shows both.
std::optional<PicturePlace> picture_next_to(const PicturePlace& place, const Texture& reference,
                                            const Texture& shown);

/// Whether most edges of each picture have no counterpart in the other, at the same place and in
/// the same direction. Wrong colors keep some of the edges; another scene or camera does not. The
/// sizes must be equal.
bool have_other_outlines(const Texture& a, const Texture& b);

/// The pixels of the rectangle, which must be inside the picture.
Texture cut_out(const Texture& picture, const glm::ivec2& corner, const glm::ivec2& size);

}  // namespace scenefile
