#pragma once
// An OpenGL context without window or display, through EGL (first Mesa's surfaceless platform, then
// the first device). Works without a graphics card: Mesa then renders in software.

#include "scenefile/view/draw.h"

#include <memory>
#include <string>

namespace scenefile {

/// Current on the thread that created it, which must also destroy it.
class HeadlessContext {
 public:
  /// OpenGL 4.1 core; null if that is not available, and `error` says what is missing.
  static std::unique_ptr<HeadlessContext> create(std::string& error);
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  GetProcAddress get_proc_address() const;

 private:
  struct State;
  explicit HeadlessContext(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scenefile
