#pragma once
// The readout of a clicked pixel: its values, how it is computed, and why mine differs. Plain data;
// session_pixel.cpp asks the questions.

#include "scenefile/viewer/background.h"
#include "scenefile/viewer/pixel_question.h"

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <string>

namespace scenefile::viewer {

struct PixelReadout {
  std::optional<glm::dvec2> at;  ///< fractions of the picture's width and height; none: closed
  double aspect = 1;             ///< of the picture, to keep `at` at what was clicked
  glm::ivec2 pixel{0};           ///< in the picture that is explained
  glm::ivec2 size{0};            ///< of that picture
  /// By role; of ours if a complete picture was traced.
  std::array<std::optional<PixelValue>, 3> values{};
  bool asked = false;  ///< the terms, for the current picture
  std::string terms;   ///< empty: not known yet
  Background<std::string> explaining;
};

/// Why mine differs; independent of the pixel.
struct CauseSearch {
  bool asked = false;  ///< for the current settings and pictures
  CauseAnswer answer;  ///< without text: not known yet
  std::shared_ptr<std::atomic<bool>> stopped;
  Background<CauseAnswer> finding;

  ~CauseSearch() { stop(); }
  void stop() {
    if (stopped != nullptr) {
      *stopped = true;
    }
  }
};

}  // namespace scenefile::viewer
