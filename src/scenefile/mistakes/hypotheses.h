#pragma once
// The mistakes to try.

#include "scenefile/mistakes/cause.h"
#include "scenefile/mistakes/mistakes.h"
#include "scenefile/mistakes/views.h"

#include <functional>
#include <string>
#include <vector>

namespace scenefile {

/// The color of a pixel is a mean of those around it.
struct PixelFilter {
  std::vector<double> weights;  ///< of columns and of rows; empty: no filter
  int before = 0;               ///< the columns to the left, and rows above
};

/// A scene with mistakes. Its groups are empty if no mistake changes the shapes.
struct Trial {
  RenderScene scene;
  RenderOptions options;
  ModelMistakes mistakes;
  glm::dvec2 shift{0};  ///< of rays, from pixel centers, in pixels: right and down
  PixelFilter filter{};
  int samples = 1;               ///< of each pixel, across and down
  int divisor = 0;               ///< of the sum of a pixel's samples; 0: their number
  bool black_if_missed = false;  ///< pixels are black if one of their samples hits nothing
};

/// The earliest stage of drawing that a mistake changes; the first ones are the cheapest to test.
enum class Stage : std::uint8_t {
  picture,  ///< only the finished picture
  shading,  ///< colors, but not what rays hit
  hits,     ///< what rays hit, with the same shapes
  camera,
  shapes,
};

/// Flips of the picture.
struct Turn {
  bool across = false;
  bool down = false;
  friend bool operator==(const Turn&, const Turn&) = default;
};

/// A mistake: its effect on drawing the scene, or on the finished picture.
struct Hypothesis {
  Cause cause = Cause::rounding;
  std::string what;
  Stage stage = Stage::shading;
  std::function<void(Trial&)> draw;
  Turn turn;
  /// For colors before clamping; empty: unchanged.
  std::function<glm::dvec3(const glm::dvec3&)> color;
  bool mistake = true;  ///< false: another way of sampling, which programs may choose
  /// Whether the searches combine it with others. Curves that are fitted to the reference are not:
  /// they can imitate any other mistake.
  bool combines = true;
  /// Whether it changes the camera's axes, which rays are made of, but a view matrix has as rows.
  bool axes = false;
};

/// Whether the mistake only shows at edges: other samples of pixels.
bool shows_at_edges(const Hypothesis& h);

/// Whether the mistake, in transforms, replaces all objects, which then have other sources and
/// materials.
bool replaces_objects(const Hypothesis& h);

/// Filters of pixels, and their sizes in words.
std::span<const std::pair<const char*, PixelFilter>> pixel_filters();
std::string blurred_by(std::string_view size);
inline constexpr const char* missed_samples =
    "pixels stay black where one of several samples misses everything";
/// That pixels are means of samples, in words. `side`: samples across and down.
std::string words_of_samples(int side);

/// Mistakes that change the finished picture.
std::vector<Hypothesis> picture_hypotheses();

/// Mistakes that change what is drawn, without those that cannot affect this scene. Of two that
/// look alike, the more common one comes first.
std::vector<Hypothesis> drawing_hypotheses(const SceneView& view, int width, int height);

/// The changed scene, ready to be drawn with the assets of the view; nullopt if it needs others.
std::optional<RenderScene> ready_with_same_files(const RenderScene& scene, const Scene& changed);

}  // namespace scenefile
