#pragma once
// What compression as a JPEG does to the colors of a picture. Internal to verbs.

#include "scenefile/asset/image.h"

#include <vector>

namespace scenefile {

/// By pixel, the contrast in its block of 16x16 pixels, the largest in which a JPEG compresses
/// colors together: of the channel where it is the largest, from 0 to 255. The more contrast, the
/// more the colors change.
std::vector<float> contrast_of_blocks(const Texture& picture);

/// Whether the pictures differ as by compression: in nearly all blocks, the means are equal, and
/// pixels differ by little for the contrast there. Sizes must be equal.
bool differ_by_compression(const Texture& reference, const Texture& test);

}  // namespace scenefile
