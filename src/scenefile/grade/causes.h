#pragma once
// Finds out why a picture differs from its reference: simulates common mistakes, and names one only
// if simulating it turns the reference into the picture.

#include "scenefile/mistakes/cause.h"
#include "scenefile/mistakes/views.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scenefile {

/// Light of a light, in 1/255.
struct LightParts {
  glm::dvec3 diffuse{0};
  glm::dvec3 specular{0};
};

/// What a program with mistakes draws at a pixel, in 1/255, not clamped.
struct MistakenPixel {
  glm::dvec3 color{0};
  /// Of the color, if these add up to it: ambient light, that of each light of the scene, and what
  /// mirrors and glass add. Without `lights`, they are not known.
  glm::dvec3 ambient{0};
  std::vector<LightParts> lights = {};
  glm::dvec3 followed{0};
};

/// If at most this share of the pixels differs, pictures are the same.
inline constexpr double max_share_same = 0.001;

struct CauseReport {
  /// Mistakes that together explain the difference. Empty if no known mistakes do.
  std::vector<Claim> claims;
  /// Other single mistakes that explain it almost as well as the best.
  std::vector<Claim> rivals;
  /// A mistake that explains only a part: something else is wrong too, or instead.
  std::vector<Claim> partial;
  /// Parts of the explanation that are not mistakes, such as other ways of sampling.
  std::vector<Claim> notes;
  /// Without claims: what nearly all pixels that differ have in common, and few others, in words,
  /// such as "99 % of the pixels that differ show highlights; so do 2 % of the others". May be
  /// empty.
  std::string confined;
  /// The place that was asked for, drawn with `claims` or `partial`, if these can be drawn.
  std::optional<MistakenPixel> asked;
  /// Fraction of pixels that differ by more than edges and rounding explain.
  double share_different = 0;
  /// Whether these are so few, and so scattered, that the pictures count as the same.
  bool only_details = true;
  /// Fraction of pixels where our picture of the scene differs from the reference. If it is large,
  /// there are no claims that need the scene. 1 without a scene.
  double share_scene_unlike = 1;
  /// Which steps of the search found the claims, joined by '+', and how many rays it traced: to
  /// measure the search (tests/student/ledger.py).
  std::string route;
  std::uint64_t rays = 0;
};

enum class LookFor : std::uint8_t { single_mistakes, several_at_once };

/// Looks for mistakes by simulating each one, in a model of a student's ray tracer, at a few
/// thousand pixels. Calls `go_on` occasionally with the finished fraction of the work in [0, 1]; if
/// it returns false, stops with the claims so far. If the sizes differ, claims only that the
/// picture is turned by a quarter turn.
CauseReport find_causes(const Texture& reference, const Texture& test,
                        const SceneView* view = nullptr,
                        const std::function<bool(double done)>& go_on = {},
                        LookFor look_for = LookFor::several_at_once);

/// What the differences are, if CauseReport::only_details, in words: "at edges and by rounding", or
/// by how much values differ elsewhere.
std::string words_of_details(const Texture& reference, const Texture& test);

/// What the scene shows at the center of a pixel of a picture of that size: RenderPrimitive::source
/// of the nearest shape. nullopt if there is none, or if the scene has too many shapes.
std::optional<std::uint32_t> source_at(const SceneView& view, const glm::ivec2& pixel,
                                       const glm::ivec2& size);

/// A view by its index, and whether its picture is as similar to the reference as the best one;
/// otherwise it is nearly as similar.
struct AlikeView {
  std::size_t index = 0;
  bool equally = true;
};

/// The views whose pictures are the most similar to the reference; those that are equally similar
/// come first. `views` must not be empty.
std::vector<AlikeView> alike(const Texture& reference, std::span<const SceneView> views);

}  // namespace scenefile
