#pragma once
// Compares a path-traced picture with the truth, which is drawn from the scene; as text and JSON.

#include "scenefile/noise/judge_path.h"
#include "scenefile/verbs/json_writer.h"
#include "scenefile/verbs/load_scene.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile {

/// Processor time for the truth unless another one is given: enough for pictures of 256x256 with
/// 1000 samples per pixel.
inline constexpr double truth_seconds = 40;

/// Draws the truth of the scene, with all assets, at options.width x options.height (draw_truth()).
RenderStatus draw_truth(const LoadedScene& scene, const RenderOptions& options, double seconds,
                        const Progress& progress, PathTruth& truth);

/// The verdict about a picture. Each variant that may explain it, but has too much noise, is drawn
/// again with more samples for a third of `seconds`, the processor time of the truth. The truth
/// keeps them for other pictures (PathTruth::finer_variants), but the verdict does not depend on
/// which those were.
RenderStatus judge_by_truth(const LoadedScene& scene, const RenderOptions& options, double seconds,
                            const Progress& progress, const DecodedPicture& mine, PathTruth& truth,
                            PathVerdict& verdict);

/// The verdict as human-readable text.
std::string path_verdict_text(const PathVerdict& verdict);
/// Of a verdict that is too_noisy: what would help.
std::string too_noisy_text(const PathVerdict& verdict);

/// The truth, tone-mapped like PNG files of mode path.
Texture truth_picture(const PathTruth& truth);

/// What is beyond the noise: white where nothing is, red where the picture is brighter than the
/// truth, blue where it is darker, gray where blocks were left out. Full color is three times the
/// largest significance by chance.
Texture significance_picture(const PathTruth& truth, const PathVerdict& verdict);

/// A plot of the light by bounces, of the truth and of the picture.
std::string energy_svg(const PathVerdict& verdict);

/// A kind of light.
struct PathTerm {
  std::string name;  ///< "direct light"
  Color light{0};
};

/// The pixels around one, and what the truth says about them.
struct PathNeighborhood {
  PathVerdict verdict;  ///< of the whole picture
  PixelRegion block;
  Color truth{0};
  double truth_error = 0;     ///< standard error of the luminance
  std::optional<Color> mine;  ///< nullopt: black in both, clipped, or near a lamp
  double error = 0;           ///< of the difference: both noises
  double significance = 0;
  std::vector<PathTerm> terms;  ///< of the truth; bounces add up to it
};

/// `verdict`: of a picture of the size of the truth.
PathNeighborhood neighborhood(const PathTruth& truth, PathVerdict verdict, const glm::ivec2& pixel);

/// Adds members to the open object.
void add_path_verdict(Json& json, const PathVerdict& verdict);

}  // namespace scenefile
