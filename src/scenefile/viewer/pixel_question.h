#pragma once
// Questions about a picture that the program answers on another thread: how the color of a pixel
// is computed, and why the picture next to ours differs.

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

struct PixelQuestion {
  std::shared_ptr<const OpenedScene> scene;
  RenderScene drawn;      ///< the scene with the window's camera, without what is hidden
  RenderOptions options;  ///< of the picture, with its size
  /// Set for the assignment Realtime; then only the size of `options` is used.
  std::optional<RealtimeOptions> realtime;
  glm::ivec2 pixel{0};
  std::optional<PixelValue> other;  ///< of the picture next to ours
};

struct CauseQuestion {
  std::shared_ptr<const OpenedScene> scene;
  RenderOptions options;
  /// Set for the assignment Realtime; then `options` is unused.
  std::optional<RealtimeOptions> realtime;
  std::shared_ptr<const Texture> ours;   ///< as drawn for the assignment; otherwise null
  std::shared_ptr<const Texture> other;  ///< the picture next to ours
};

/// Both return text of several lines, even if there is no answer.
using ExplainPixel = std::function<std::string(const PixelQuestion&)>;
/// Stops soon after `go_on` returns false.
using FindCause =
    std::function<std::string(const CauseQuestion&, const std::function<bool()>& go_on)>;

}  // namespace scenefile::viewer
