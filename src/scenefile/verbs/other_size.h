#pragma once
// Pictures of other sizes than their reference: what can be compared instead. Internal to verbs.

#include "scenefile/verbs/compare_pictures.h"

#include <functional>
#include <string>
#include <vector>

namespace scenefile {

/// Fills in what is compared if the sizes differ. `scene`: null if it cannot be drawn.
void make_comparable(const Texture& given, const Texture& test, const LoadedScene* scene,
                     const std::vector<DrawnWay>& ways, const std::function<bool(double)>& go_on,
                     PictureComparison& found);

/// Such as "its part at 10,20 of size 640x480, after scaling" of a screenshot, or "with the part at
/// 30,20 of the reference" of a part that was cut out.
std::string what_was_compared(const PictureComparison& found);

/// The pixels of a whole picture of that size that are in `test`.
PixelRegion visible(const PicturePlace& place, const Texture& test);

}  // namespace scenefile
