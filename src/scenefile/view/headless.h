#pragma once
// An OpenGL context without window or display, through EGL (surfaceless Mesa platform first, then
// the first device). Such contexts exist without a graphics card: Mesa draws in software.

#include "scenefile/view/draw.h"

#include <memory>
#include <string>

namespace scenefile {

/// A context that is current on the thread that made it, until destroyed there.
class HeadlessContext {
 public:
  /// OpenGL 4.1 core; null, with `error` saying what is missing, where there is none.
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
