#pragma once
// Draws scenes with OpenGL on its own thread, with its own context, so that the user's input never
// waits for a picture. Internal to viewer.

#include "scenefile/base/result.h"
#include "scenefile/view/draw.h"
#include "scenefile/viewer/opened_scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scenefile::viewer {

/// The context of the thread. Both are called on it.
struct PaintContext {
  /// Makes the context current.
  std::function<Result<GetProcAddress>()> begin;
  std::function<void()> end;
};

/// A context without a window, for Mesa's software renderer: it shares its threads among the
/// contexts of a display, so that panels would wait for the scene. `otherwise` is used if there is
/// none, or if `otherwise` is a graphics card's.
PaintContext own_threads(const PaintContext& otherwise);

/// Everything that a picture depends on.
struct PaintRecipe {
  std::uint64_t version = 0;  ///< of the scene and its upload options
  RenderCamera camera;
  DrawOptions options;
  int width = 1;
  int height = 1;
  int coarseness = 0;  ///< how coarse the picture is, for the caller

  friend bool operator==(const PaintRecipe&, const PaintRecipe&) = default;
};

/// Two pictures can be requested independently of each other.
enum class Painting : std::uint8_t { shown, compared };

struct PaintJob {
  PaintRecipe recipe;
  std::shared_ptr<const OpenedScene> scene;
  UploadOptions upload;
  bool refines = false;  ///< better than what is visible, and may be interrupted
};

struct Painted {
  PaintRecipe recipe;
  Texture picture;  ///< empty: it could not be drawn
  DrawStats stats;
  std::vector<std::string> notes;  ///< findings of drawing the scene
  double seconds = 0;              ///< for drawing, without uploading
};

/// Must be used from one thread.
class ScenePainter {
 public:
  /// Fails if the thread or its context cannot be created. `wake` is called from the thread
  /// whenever there is a picture to take.
  static Result<std::unique_ptr<ScenePainter>> create(PaintContext context,
                                                      std::function<void()> wake);
  /// Interrupts the current picture, and waits for the thread to end.
  ~ScenePainter();
  ScenePainter(const ScenePainter&) = delete;
  ScenePainter& operator=(const ScenePainter&) = delete;

  /// The driver's name of the renderer.
  const std::string& renderer() const;

  /// Requests a picture; `compared` is drawn after `shown`. Replaces an earlier request of its kind
  /// that is still waiting; a new one for `shown` interrupts the current picture if that only
  /// refines.
  void ask(PaintJob job, Painting which = Painting::shown);

  /// The newest picture of its kind that was not taken yet, if any. `wait`: after what was asked
  /// for `shown` is drawn.
  std::optional<Painted> take(Painting which = Painting::shown, bool wait = false);

  /// Whether a picture is being drawn, or waits to be.
  bool busy() const;

 private:
  struct Impl;
  explicit ScenePainter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace scenefile::viewer
