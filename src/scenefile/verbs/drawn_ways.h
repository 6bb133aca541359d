#pragma once
// The ways in which a reference may have been drawn: options of our program, and which of them fit.

#include "scenefile/grade/causes.h"
#include "scenefile/grade/realtime_causes.h"
#include "scenefile/verbs/load_scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A way in which a reference may have been rendered.
struct DrawnWay {
  RenderOptions options;
  std::string words;  ///< as command line options, such as "--profile course"
  /// Set for the assignment Realtime; `options` is then unused.
  std::optional<RealtimeOptions> realtime = std::nullopt;
  RealtimeUnknowns unknowns = {};  ///< of `realtime`: settings to find in the reference
  bool nearly = false;  ///< fits the reference nearly as well as the first way, not equally
};

/// Options that draw a picture this way, without its size and quality: "--profile course", and what
/// differs from the defaults of the profile.
std::string options_text(const RenderOptions& options);

/// Only `profiles` if the features are known; otherwise also with the sets of features that
/// references usually use.
std::vector<DrawnWay> possible_ways(std::span<const RenderOptions> profiles, bool features_known);

/// `ways`, reordered: if a folder in the path of the reference is named after a project of the
/// course (Intersect, grading_illuminate, intersect_normal_color), the way of that project comes
/// first. The last such folder counts. Of ways that fit a reference equally, the first is used.
std::vector<DrawnWay> folder_first(std::string_view reference, std::vector<DrawnWay> ways);

/// A way of drawing the assignment Realtime.
DrawnWay realtime_way(const RealtimeOptions& panel, const RealtimeUnknowns& unknowns);

/// The ways in which our picture of the scene, with all assets, is most similar to the reference:
/// the likeliest first, then those with other features. A single way that contradicts the reference
/// is replaced by those that fit it. `ways` must not be empty.
std::vector<DrawnWay> ways_drawn(const Texture& reference, const LoadedScene& scene,
                                 const std::vector<DrawnWay>& ways);

/// The share of the picture's pixels that differ from our picture drawn this way, except at edges
/// and by rounding.
double share_unlike(const Texture& picture, const LoadedScene& scene, const DrawnWay& way);
/// If more than this share differs, the scene or its settings are not those of the reference.
inline constexpr double max_share_unlike = 0.1;

/// Whether the picture is ours, drawn this way, except at edges and by rounding. Where samples
/// matter everywhere, only drawing all of it tells.
bool equals_ours(const Texture& picture, const LoadedScene& scene, const DrawnWay& way);

/// How a reference was drawn.
struct ReferenceWay {
  DrawnWay way;
  bool exactly = false;  ///< our picture drawn this way has its values within rounding
};

/// The way that draws all values of the reference, or else nearly all of them within rounding, with
/// the features of `way`, or the first ones of a profile, with each profile of `possible`, with or
/// without super-sampling; `way` if none does. Of the ways in `possible` that draw the same
/// picture, one that needs no list of features is preferred.
ReferenceWay reference_way(const Texture& reference, const LoadedScene& scene, const DrawnWay& way,
                           const std::vector<DrawnWay>& possible);

/// The part of the picture of a scene that is compared: members of SceneView.
struct ComparedPart {
  glm::dvec2 whole{0};
  glm::dvec2 corner{0};
  int samples = 1;
  std::vector<float> noise = {};
  std::optional<glm::dvec2> asked = std::nullopt;
};

/// What the search for causes needs. The results refer to the arguments.
SceneView view_of(const LoadedScene& scene, const DrawnWay& way, const ComparedPart& part = {});
RealtimeView realtime_view_of(const LoadedScene& scene, const DrawnWay& way,
                              const ComparedPart& part = {});

}  // namespace scenefile
