#pragma once
// Finds the settings of a picture of the assignment Realtime by drawing it with different settings.
// Internal to grade.

#include "scenefile/grade/realtime_causes.h"
#include "scenefile/mistakes/realtime_picture.h"

#include <memory>

namespace scenefile {

/// A trial without mistakes.
class RealtimeDrawn {
 public:
  explicit RealtimeDrawn(const RealtimeView& view);
  /// Whether the scene is small enough to be drawn many times.
  bool usable() const { return shapes_ != nullptr; }
  /// A copy without groups, which only mistakes in shapes need.
  const RealtimeTrial& right() const { return right_; }
  const std::shared_ptr<const RealtimeShapes>& shapes() const { return shapes_; }
  const Assets& assets() const { return *view_.assets; }
  /// Removes the lights that the milestone does not draw.
  void keep_lights(RenderScene& scene) const;
  /// The same with other settings.
  RealtimeTrial with(const RealtimeOptions& panel) const;

 private:
  RealtimeView view_;
  RealtimeTrial right_;
  std::shared_ptr<const RealtimeShapes> shapes_;
};

/// `start` with the near and far planes that the picture shows; planes that clip nothing keep their
/// value.
RealtimeOptions fitted_depths(const Texture& picture, const RealtimeDrawn& drawn,
                              const RealtimeOptions& start);

/// The parameters of the tessellation that fit best; those of `start` if none fits better.
TessellationParameters fitted_parameters(const Texture& picture, const RealtimeDrawn& drawn,
                                         const RealtimeOptions& start);

}  // namespace scenefile
