#pragma once
// A picture on its way: what is needed to go on with it.

#include "scenefile/asset/image.h"
#include "scenefile/trace/tiles.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The picture is made in one or two passes over all pieces; the second goes over some pixels
/// again. Threads write pixels of pieces that are not done; bytes() reads others alone, so it may
/// be called at any time during a pass.
struct PictureState {
  /// `two_passes`: room for marks. `canvas`: a black image of this size, or any other to be left
  /// alone.
  PictureState(int width, int height, bool two_passes, Image canvas = {});

  /// All that restore() needs, in a form of this build.
  std::string bytes() const;
  /// Takes the state over. False: the bytes are of no picture of this size and kind; nothing has
  /// changed.
  bool restore(std::string_view bytes);

  /// Begins the second pass, when the marks are complete.
  void start_second_pass();

  Image image;
  Pieces pieces;                     ///< done in this pass
  std::uint32_t pass = 0;            ///< 0 or 1
  std::vector<std::uint8_t> marked;  ///< by pixel: the second pass goes over it; empty: one pass

 private:
  std::size_t byte_count() const;
};

}  // namespace scenefile
