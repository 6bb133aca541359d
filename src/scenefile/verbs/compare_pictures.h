#pragma once
// Compares a picture with its reference: how much they differ, and which common mistake explains
// it; as data, text and JSON.

#include "scenefile/asset/image_file.h"
#include "scenefile/compare/find_picture.h"
#include "scenefile/compare/measure.h"
#include "scenefile/compare/worst_region.h"
#include "scenefile/grade/causes.h"
#include "scenefile/verbs/drawn_ways.h"
#include "scenefile/verbs/json_writer.h"
#include "scenefile/verbs/load_scene.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class LookForCauses : std::uint8_t { where_broken, always };

struct CompareSettings {
  Thresholds thresholds;       ///< none: the pictures must be equal
  int pixel_threshold = 8;     ///< only larger differences count, in 1/255
  std::vector<DrawnWay> ways;  ///< the most similar to the reference is used
  bool ways_fit = false;       ///< `ways` are already the result of ways_drawn()
  LookForCauses look = LookForCauses::where_broken;  ///< for pictures that are not equal
  bool lossy = false;  ///< a picture is a JPEG: its colors are as exact as compression leaves them
  /// A pixel of the picture under test to draw with the mistakes: PictureComparison::asked.
  std::optional<glm::ivec2> asked = std::nullopt;
};

/// Where two pictures differ most, and what the scene shows there.
struct PlaceToLook {
  WorstRegion region;
  bool hit = false;    ///< whether the scene shows an object there
  std::string object;  ///< path of its node in the scene
  Location location;   ///< of the object in the scene file
};

struct PictureComparison {
  PictureMeasures measures;  ///< of what was compared; the sizes are those of the whole pictures
  /// If the picture and the reference have different sizes: what the picture was compared with. If
  /// our picture of the scene matches the reference, ours at the size of the picture; otherwise, or
  /// if the picture is a part of the reference, the reference scaled or cropped.
  std::optional<Texture> other_reference;
  bool drawn = false;      ///< `other_reference` is our picture of the scene
  bool resampled = false;  ///< the picture was scaled after drawing, as far as can be seen
  /// What was compared instead of the picture: the part of it that shows the scene, scaled to the
  /// size of the reference if it is larger.
  std::optional<Texture> other_test;
  glm::ivec2 test_size{0};  ///< of the picture under test as a whole
  /// Of `other_reference`: the size of the whole picture of the scene, and where the upper left
  /// corner is in it. 0: it is the whole picture.
  glm::ivec2 whole{0};
  glm::ivec2 corner{0};
  /// Where the whole picture of the scene is in the picture, a screenshot or a part that was cut
  /// out. nullopt if it is the picture itself.
  std::optional<PicturePlace> place;
  std::vector<float> flip_errors;   ///< of the pixels; empty for pictures of different sizes
  std::vector<std::string> broken;  ///< thresholds that were exceeded; empty: the same
  CauseReport causes;               ///< empty if no causes were looked for
  /// The settings of the reference if it is of the assignment Realtime.
  std::optional<RealtimeOptions> realtime;
  std::string drawn_with;       ///< DrawnWay::words of the reference; empty: unknown
  RenderOptions drawn_options;  ///< the same as options, without size; of ray-traced ones
  bool drawn_exactly = true;  ///< `drawn_with` draws the reference within rounding, not only nearly
  std::string contradicted;   ///< the only way that was given, if it contradicts the reference
  bool scene_used = false;    ///< whether the search for causes had a scene
  bool right_at_other_size = false;  ///< the picture under test shows the scene, at another size
  bool exchanged = false;  ///< the picture under test shows the scene, and the reference does not
  /// How the pictures differ, if that is no mistake: words_of_details().
  std::string details = "at edges and by rounding";
  bool other_outlines = false;   ///< nothing explains the difference, and few edges are the same
  bool equal_in_8_bits = false;  ///< only the floats differ; no causes are looked for
  std::optional<PlaceToLook> where;  ///< nullopt if no pixel differs visibly
  /// CompareSettings::asked as a pixel of the whole picture of the scene of size `asked_of`;
  /// nullopt if it is outside of what was compared. causes.asked is its color with the mistakes.
  std::optional<glm::ivec2> asked;
  glm::ivec2 asked_of{0};

  bool other_size() const { return other_reference || other_test; }
  /// Whether our picture of the scene looks like the reference; true without a scene.
  bool scene_fits() const { return !scene_used || causes.share_scene_unlike <= max_share_unlike; }
  /// The two pictures that were compared.
  const Texture& reference_of(const Texture& given) const {
    return other_reference ? *other_reference : given;
  }
  const Texture& test_of(const Texture& given) const { return other_test ? *other_test : given; }
};

/// Compares the pictures, and looks for causes according to settings.look. A picture of another
/// size is never the same, but is compared with our picture of the scene at its size, or after
/// scaling; of a screenshot, the part that shows the scene. `scene`: the scene of the reference
/// with all assets, or null. `go_on` as for find_causes().
PictureComparison compare_pictures(const Texture& reference, const Texture& test,
                                   const LoadedScene* scene = nullptr,
                                   const CompareSettings& settings = {},
                                   const std::function<bool(double done)>& go_on = {});

/// The same for pictures from files, after round_alike(). If both have floats and the same size,
/// their linear values are measured (PictureMeasures::difference); SSIM, FLIP, causes and places
/// are always of 8-bit values.
PictureComparison compare_pictures(const DecodedPicture& reference, const DecodedPicture& test,
                                   const LoadedScene* scene = nullptr,
                                   const CompareSettings& settings = {},
                                   const std::function<bool(double done)>& go_on = {});

/// "12 of its pixels are not finite (NaN or infinite)".
std::string not_finite_text(const DecodedPicture& picture);

/// Of a picture that is DecodedPicture::transparent.
inline constexpr std::string_view transparent_text =
    "all its pixels are transparent (alpha 0): viewers show nothing, but alpha is not compared";

/// "four samples per pixel; this is not a mistake by itself".
std::string no_mistake_text(std::string_view what);

/// The causes as human-readable text.
std::string causes_text(const PictureComparison& found);

/// Where the pictures differ most, as human-readable text: the region, the object there, and how to
/// explain one of its pixels. `command`: of the pixel, or empty.
std::string where_text(const PictureComparison& found,
                       const std::function<std::string(const glm::ivec2& pixel)>& command = {});

/// Adds members to the open object.
void add_measures(Json& json, const PictureMeasures& measures);
void add_claims(Json& json, std::string_view name, const std::vector<Claim>& claims);
void add_comparison(Json& json, const PictureComparison& found);

}  // namespace scenefile
