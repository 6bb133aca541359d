#include "app/realtime.h"

#include <fmt/format.h>

#include <string_view>

namespace scenefile::app {

std::optional<RealtimeOptions> realtime_options(const Options& options) {
  if (!options.realtime) {
    return std::nullopt;
  }
  return options.realtime_panel;
}

RealtimeUnknowns realtime_unknowns(const Options& options) {
  return {.parameters = !was_given(options, "--parameters"),
          .near = !was_given(options, "--near"),
          .far = !was_given(options, "--far"),
          .filter = !was_given(options, "--filter"),
          .milestone = !was_given(options, "--milestone")};
}

std::string check_realtime_options(const Options& options) {
  if (!options.realtime) {
    for (const std::string_view name :
         {"--parameters", "--near", "--far", "--filter", "--milestone"}) {
      if (was_given(options, name)) {
        return fmt::format("{} is for --profile realtime", name);
      }
    }
    return {};
  }
  constexpr std::string_view words =
      "--profile realtime draws the course's assignment with OpenGL: leave {} out";
  if (was_given(options, "--engine") && options.engine == Engine::trace) {
    return fmt::format(words, "--engine trace");
  }
  for (const std::string_view name : {"--features", "--mode", "--samples", "--trace"}) {
    if (was_given(options, name)) {
      return fmt::format(words, name);
    }
  }
  const RealtimeOptions& panel = options.realtime_panel;
  return panel.near < panel.far
             ? std::string()
             : fmt::format("--near must be less than --far, and {} is not less than {}", panel.near,
                           panel.far);
}

}  // namespace scenefile::app
