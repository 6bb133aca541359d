#pragma once
// The picture on the way, as Preview wants it.

#include "scenefile/trace/picture_state.h"
#include "scenefile/trace/tracer.h"

#include <chrono>

namespace scenefile {

/// Used by one thread at a time.
class PreviewPicture {
 public:
  /// Both must outlive it.
  PreviewPicture(const Preview& preview, const PictureState& picture);

  /// Nothing else may be called where nobody looks.
  bool wanted() const { return preview_.show != nullptr; }
  /// One ray for each block of pixels, before the first pass.
  void start(const Tracer& tracer);
  /// Takes over what is done in this pass.
  void update() { copy_done(picture_, shown_); }
  /// Shows the picture when it is time.
  void show_in_time();

 private:
  void fill(int x0, int y0, const Color& color);
  void show();

  const Preview& preview_;
  const PictureState& picture_;
  Image shown_;  // of the region
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace scenefile
