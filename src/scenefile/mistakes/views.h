#pragma once
// The scene of a reference, and how the reference was drawn.

#include "scenefile/base/realtime.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/scene.h"
#include "scenefile/trace/render.h"

#include <glm/glm.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace scenefile {

/// The scene of the reference, and how it was drawn: profile, mode, features and depth. Size
/// and samples of the options are not used.
struct SceneView {
  const RenderScene* scene = nullptr;
  const Assets* assets = nullptr;
  RenderOptions options;
  const Scene* written = nullptr;  ///< the written scene; null: transforms are not tried
  std::string said;                ///< a description; may be empty
  /// If the pictures are a part of the picture of the scene: its size, and where their upper left
  /// corner is in it, in their pixels. 0: they are the whole picture.
  glm::dvec2 whole{0};
  glm::dvec2 corner{0};
  int samples = 1;  ///< of a pixel, across and down; more for pictures that were scaled down
  /// That `scene` refers to; needed with `written`.
  const std::vector<Source>* sources = nullptr;
  /// By pixel of the picture, by how much compression may have changed its color, in 1/255;
  /// infinite: the color is no evidence. Empty: there was no compression.
  std::vector<float> noise = {};
  /// A place in the pictures, in their pixels, for CauseReport::asked.
  std::optional<glm::dvec2> asked = std::nullopt;
};

/// The scene of a reference, and the settings that it was drawn with.
struct RealtimeView {
  const RenderScene* scene = nullptr;
  const Assets* assets = nullptr;
  const Scene* written = nullptr;  ///< the written scene; null: transforms are not tried
  RealtimeOptions panel;
  const std::vector<Source>* sources = nullptr;  ///< that `scene` refers to; needed with `written`
  std::optional<glm::dvec2> asked = std::nullopt;  ///< as SceneView::asked
  std::vector<float> noise = {};                   ///< as SceneView::noise
};

}  // namespace scenefile
