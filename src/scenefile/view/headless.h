#pragma once
// An OpenGL context without window or display, through EGL (first Mesa's surfaceless platform, then
// the first device). Works without a graphics card: Mesa then renders in software.

#include "scenefile/base/result.h"
#include "scenefile/view/draw.h"

#include <memory>

namespace scenefile {

/// Current on the thread that created it, which must also destroy it.
class HeadlessContext {
 public:
  /// OpenGL 4.1 core; an error says what is missing.
  static Result<std::unique_ptr<HeadlessContext>> create();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  GetProcAddress get_proc_address() const;

 private:
  struct State;
  explicit HeadlessContext(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// A context and its device.
struct HeadlessDevice {
  std::unique_ptr<HeadlessContext> context;
  std::unique_ptr<GlDevice> device;
};
Result<HeadlessDevice> open_headless_device();

}  // namespace scenefile
