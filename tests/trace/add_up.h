#pragma once
// Checks that the terms of an explained pixel add up to the pixel.

#include "scenefile/trace/explain.h"

#include <string>

namespace scenefile::trace_test {

/// Adds all terms again, in the documented order. Returns the first place where the result is not
/// exactly the recorded number; empty if there is none.
std::string what_does_not_add_up(const RenderScene& scene, const PixelRecord& pixel);

/// Compares with the pixel of a picture that render() made with the same options.
std::string what_differs(const PixelRecord& pixel, const Image& image);

}  // namespace scenefile::trace_test
