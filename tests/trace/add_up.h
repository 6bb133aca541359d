#pragma once
// Whether the numbers of an explained pixel are the pixel.

#include "scenefile/trace/explain.h"

#include <string>

namespace scenefile::trace_test {

/// Adds all terms anew, in the documented order. Returns the first place where the result is not
/// the recorded number to the last bit; empty: all of them are.
std::string what_does_not_add_up(const RenderScene& scene, const PixelRecord& pixel);

/// Compares with the pixel of a picture that render() made with the same options.
std::string what_differs(const PixelRecord& pixel, const Image& image);

}  // namespace scenefile::trace_test
