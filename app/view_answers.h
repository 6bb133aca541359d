#pragma once
// Answers the window's questions about a picture, in the words of explain and diff.

#include "scenefile/viewer/pixel_question.h"

#include <functional>
#include <string>

namespace scenefile::app {

/// As `explain` prints it, with the value of the other picture as --mine.
std::string explain_for_view(const viewer::PixelQuestion& question);

/// As `diff --scene` prints it, with our picture as the reference. Draws our picture first.
std::string cause_for_view(const viewer::CauseQuestion& question,
                           const std::function<bool()>& go_on);

}  // namespace scenefile::app
