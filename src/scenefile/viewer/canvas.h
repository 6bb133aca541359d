#pragma once
// The pictures in the window: from OpenGL, from the ray tracer, from files, and their differences.
// Internal to viewer; needs the window's context.

#include "scenefile/viewer/gl_picture.h"
#include "scenefile/viewer/gui.h"
#include "scenefile/viewer/scene_painter.h"
#include "scenefile/viewer/session.h"

#include <memory>
#include <optional>

namespace scenefile::viewer {

class Canvas {
 public:
  explicit Canvas(std::unique_ptr<ScenePainter> painter) : painter_(std::move(painter)) {}

  /// Draws a tiny scene, so that the driver compiles its shaders while the first scene is read.
  void warm_up(const Session& session);

  /// Uploads pictures that changed in the session; of large ones only a part, unless `whole`.
  /// Returns false if parts are left for the next frame.
  bool update(Session& session, bool whole);
  /// Takes a picture of the scene that has been drawn. Returns false if there is none.
  bool take(Session& session);

  /// Requests the picture of the scene, unless it is there. While the camera moves, and for the
  /// first picture of a large scene, its resolution depends on how long recent pictures took; at
  /// rest it gets better step by step. Coarse pictures skip shadow maps that have not been drawn
  /// yet.
  void draw(const Session& session);
  /// Draws the best picture, and waits for it.
  void finish(Session& session);
  /// Whether the best picture is shown.
  bool settled(const Session& session) const;
  /// Whether a picture is being drawn.
  bool busy() const { return painter_->busy(); }

  /// The OpenGL picture at the size of the picture from a file: asked for, and taken once it is
  /// drawn. Empty if it is too large.
  void ask_to_compare(const Session& session);
  std::optional<Texture> take_to_compare(const Session& session);

  /// Sets what a frame shows of the pictures.
  void describe(GuiFrame& frame) const;

 private:
  int hurry_for(const Session& session, bool moving) const;
  /// `coarseness`: 0 for the best picture, 1 for one sample per pixel, and each further step halves
  /// the resolution.
  PaintRecipe recipe_for(const Session& session, int coarseness) const;
  void ask(const Session& session, PaintRecipe recipe, bool refines);
  void accept(Session& session, Painted painted);

  std::unique_ptr<ScenePainter> painter_;
  std::optional<PaintRecipe> asked_;           ///< last
  Painted painted_;                            ///< last, without its picture
  int moving_coarseness_ = 0;                  ///< for pictures while the camera moves
  std::uint64_t painted_count_ = 0;            ///< how many pictures were painted
  std::uint64_t shadowed_ = 0;                 ///< version of the scene last drawn with shadows
  std::optional<PaintRecipe> compared_asked_;  ///< by ask_to_compare()
  GlPicture drawn_;
  GlPicture traced_;
  GlPicture reference_;
  GlPicture mine_;
  GlPicture difference_;
  GlPicture flip_;
};

}  // namespace scenefile::viewer
