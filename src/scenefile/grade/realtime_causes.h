#pragma once
// Finds out why a picture of the assignment Realtime differs from its reference, by the same rule
// as causes.h: a mistake is named only if simulating it reproduces the picture.

#include "scenefile/base/realtime.h"
#include "scenefile/grade/causes.h"

#include <functional>
#include <optional>
#include <string>

namespace scenefile {

/// Which settings are not given.
struct RealtimeUnknowns {
  bool parameters = false;
  bool near = false;
  bool far = false;
  bool filter = false;
  bool milestone = false;
  bool any() const { return parameters || near || far || filter || milestone; }
};

/// The settings whose picture of the scene is most similar to the reference. Given settings keep
/// their values from `view.panel`. The others also keep them if no other value fits better.
RealtimeOptions find_realtime_settings(const Texture& reference, const RealtimeView& view,
                                       const RealtimeUnknowns& unknowns);

/// The settings as options of the program: "--profile realtime --parameters 5,5".
std::string realtime_words(const RealtimeOptions& panel);

/// Same as find_causes().
CauseReport find_realtime_causes(const Texture& reference, const Texture& test,
                                 const RealtimeView& view,
                                 const std::function<bool(double done)>& go_on = {});

/// What the scene shows at a pixel of a picture of that size, as source_at() does.
std::optional<std::uint32_t> realtime_source_at(const RealtimeView& view, const glm::ivec2& pixel,
                                                const glm::ivec2& size);

}  // namespace scenefile
