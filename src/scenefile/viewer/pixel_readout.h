#pragma once
// The readout of a clicked pixel: its values, how it is computed, and why the picture next to ours
// differs. Plain data; session_pixel.cpp asks the questions.

#include "scenefile/viewer/background.h"
#include "scenefile/viewer/pixel_question.h"

#include <atomic>
#include <memory>
#include <optional>
#include <string>

namespace scenefile::viewer {

struct PixelReadout {
  std::optional<glm::dvec2> at;     ///< fractions of the picture's width and height; none: closed
  glm::ivec2 pixel{0};              ///< in the picture that is explained
  glm::ivec2 size{0};               ///< of that picture
  std::optional<PixelValue> ours;   ///< if a complete picture was traced
  std::optional<PixelValue> other;  ///< of the picture next to ours
  bool asked = false;               ///< the terms, for the current picture
  std::string terms;                ///< empty: not known yet
  Background<std::string> explaining;
};

/// Why the picture next to ours differs; independent of the pixel.
struct CauseSearch {
  bool asked = false;  ///< for the current settings and pictures
  std::string text;    ///< empty: not known yet
  std::shared_ptr<std::atomic<bool>> stopped;
  Background<std::string> finding;

  ~CauseSearch() { stop(); }
  void stop() {
    if (stopped != nullptr) {
      *stopped = true;
    }
  }
};

}  // namespace scenefile::viewer
