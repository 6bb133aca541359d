#pragma once
// How long the window's thread works between two looks at the user's input: the longest that input
// can wait.

#include <cstddef>
#include <string>
#include <vector>

namespace scenefile::viewer {

class FrameLog {
 public:
  FrameLog();

  /// Call it after reading the input.
  void begin();
  /// Call it before reading the input again. `drawn`: whether the frame shows the scene's picture;
  /// `traced`: whether that is the finished ray-traced one.
  void end(bool drawn, bool traced);

  struct Entry {
    double at = 0;    ///< seconds since the log was made
    double wall = 0;  ///< seconds
    double cpu = 0;   ///< seconds of the processor for this thread; other programs do not count
    bool drawn = false;
    bool traced = false;
  };
  const std::vector<Entry>& entries() const { return entries_; }

  /// Lines of at, wall and cpu in milliseconds, drawn and traced, separated by tabs; the first
  /// names them.
  std::string text() const;

 private:
  std::vector<Entry> entries_;
  double start_;
  double wall_ = 0;
  double cpu_ = 0;
};

}  // namespace scenefile::viewer
