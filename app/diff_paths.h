#pragma once
// The command diff for path-traced pictures.

#include "app/command.h"
#include "app/load.h"
#include "app/load_picture.h"
#include "scenefile/verbs/compare_paths.h"

#include <optional>
#include <span>

namespace scenefile::app {

/// Whether to judge the pictures as path-traced: --mode path, or an option that implies it, or a
/// scene that only faces light, unless other options exclude it.
bool are_path_traced(const Options& options, const LoadedScene& scene);

/// The processor time in which a truth is drawn: --time, or truth_seconds.
double seconds_of_truth(const Options& options);
/// Draws the truth of the picture that the options describe, shows progress, and judges `mine`.
Outcome judge_by_truth(const LoadedScene& scene, const Options& options, Context& context,
                       const DecodedPicture& mine, PathTruth& truth, PathVerdict& verdict);

/// Judges each picture by the truth, which is drawn from the scene. The last picture is the one
/// under test; one before it is the reference.
ExitCode diff_paths(Options options, std::span<const LoadedPicture> pictures,
                    const LoadedScene& scene, Context& context);

}  // namespace scenefile::app
