#pragma once
// Questions about pictures that the program answers on another thread: how a picture from a file
// was drawn, how the color of a pixel is computed, and why mine differs.

#include "scenefile/asset/image_file.h"
#include "scenefile/base/realtime.h"
#include "scenefile/trace/render_options.h"
#include "scenefile/viewer/opened_scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace scenefile::viewer {

using PixelValue = std::array<std::uint8_t, 3>;

/// How is this picture drawn, as `scenefile diff` finds out?
struct FitQuestion {
  std::shared_ptr<const OpenedScene> scene;
  std::string path;
  std::shared_ptr<const DecodedPicture> picture;
  /// Whether it is right. Of any other picture, missing features may be mistakes.
  bool is_reference = false;
};

struct PictureFit {
  RenderOptions options;  ///< the ways to draw the scene that is most similar to the picture
  std::optional<RealtimeOptions> realtime{};  ///< set: the assignment Realtime
  std::string words;                          ///< the same as options of the command line
  bool equal = false;  ///< whether it then equals the picture, except at edges and by rounding
};

struct PixelQuestion {
  std::shared_ptr<const OpenedScene> scene;
  RenderScene drawn;      ///< the scene with the window's camera, without what is hidden
  RenderOptions options;  ///< of the picture, with its size
  /// Set for the assignment Realtime; then only the size of `options` is used.
  std::optional<RealtimeOptions> realtime;
  glm::ivec2 pixel{0};
  std::optional<PixelValue> mine;
  /// Whether the terms of this pixel may suggest what is wrong with mine: only if the search in the
  /// whole pictures found nothing, so that the two never disagree.
  bool suggest = false;
};

struct CauseQuestion {
  std::shared_ptr<const OpenedScene> scene;
  RenderOptions options;
  /// Set for the assignment Realtime; then `options` is unused.
  std::optional<RealtimeOptions> realtime{};
  std::shared_ptr<const Texture> ours{};  ///< as drawn for the assignment; otherwise null
  std::string reference_path;
  std::shared_ptr<const DecodedPicture> reference;  ///< null: ours is
  std::shared_ptr<const DecodedPicture> mine;
};

struct CauseAnswer {
  std::string text;      ///< of several lines
  bool nothing = false;  ///< the pictures differ, and nothing explains it
};

/// Returns text of several lines, even if there is no answer.
using ExplainPixel = std::function<std::string(const PixelQuestion&)>;
/// Stops soon after `go_on` returns false.
using FindCause =
    std::function<CauseAnswer(const CauseQuestion&, const std::function<bool()>& go_on)>;
/// Nothing if there is not enough memory.
using FitPicture = std::function<std::optional<PictureFit>(const FitQuestion&)>;

}  // namespace scenefile::viewer
