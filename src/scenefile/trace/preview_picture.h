#pragma once
// The picture for Preview.

#include "scenefile/trace/film.h"
#include "scenefile/trace/wavefront.h"

#include <chrono>

namespace scenefile {

/// Must be used by one thread at a time.
class PreviewPicture {
 public:
  /// Both must outlive the object.
  PreviewPicture(const Preview& preview, const Film& film);

  /// If false, call nothing else.
  bool wanted() const { return preview_.show != nullptr; }
  /// Traces one ray for each block of pixels, before the first pass.
  void start(const Tracer& tracer);
  /// Copies the pixels finished in this pass.
  void update() { copy_done(film_, shown_); }
  /// Shows the picture if the interval has passed.
  void show_in_time();

 private:
  void start_blocks(const WavefrontScene& scene, int x0, int y0, WavefrontMemory& memory);
  void fill(int x0, int y0, const Color& color);
  void show();

  const Preview& preview_;
  const Film& film_;
  Image shown_;  // of the region
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace scenefile
