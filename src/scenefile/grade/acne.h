#pragma once

#include "scenefile/asset/image.h"

namespace scenefile {

/// What speaks for surfaces that shadow themselves.
struct AcneEvidence {
  double between = 0;    ///< share of the differing pixels that lie between `lit` and `dark`
  double scattered = 0;  ///< neighbors that are right, for each differing pixel; 4 at most
};

/// `lit` is the right picture, `dark` the same without lights.
AcneEvidence look_for_acne(const Texture& test, const Texture& lit, const Texture& dark);

}  // namespace scenefile
