#pragma once
// Answers the window's questions about a picture, in the words of explain and diff.

#include "app/options.h"
#include "scenefile/viewer/pixel_question.h"

#include <functional>
#include <optional>
#include <string>

namespace scenefile::app {

/// As `diff --scene` finds out how the reference was drawn.
std::optional<viewer::PictureFit> fit_for_view(const viewer::FitQuestion& question,
                                               const Options& options);

/// As `explain` prints it.
std::string explain_for_view(const viewer::PixelQuestion& question);

/// As `diff --scene` prints it. Without a reference, our picture is drawn and takes its place.
viewer::CauseAnswer cause_for_view(const viewer::CauseQuestion& question, const Options& options,
                                   const std::function<bool()>& go_on);

}  // namespace scenefile::app
