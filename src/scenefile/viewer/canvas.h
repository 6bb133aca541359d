#pragma once
// The pictures in the window: from OpenGL, from the ray tracer, the reference, and their
// differences. Internal to viewer; needs the window's context.

#include "scenefile/view/draw.h"
#include "scenefile/viewer/gl_picture.h"
#include "scenefile/viewer/session.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace scenefile::viewer {

class Canvas {
 public:
  /// Null, with `error` set, if the context is not suitable.
  static std::unique_ptr<Canvas> create(GetProcAddress find, std::string& error);

  /// Uploads scenes and pictures that changed in the session.
  void update(Session& session);

  /// Draws the scene for drawn(), if the picture changed; overwrites the window's back buffer.
  /// `framebuffer_height` is in pixels; `scale` is pixels per unit of the window. `hurry`: 0 for
  /// the best picture, 1 for one sample per pixel, and each further step halves the resolution.
  /// When in a hurry, shadows that have not been drawn yet are skipped.
  void draw(const Session& session, int framebuffer_height, double scale, int hurry);

  /// The OpenGL picture at the size of the reference; empty if that is too large.
  Texture picture_for_reference(const Session& session);

  /// Upside down.
  const GlPicture& drawn() const { return drawn_; }
  const GlPicture& traced() const { return traced_; }
  const GlPicture& reference() const { return reference_; }
  const GlPicture& difference() const { return difference_; }
  const GlPicture& flip() const { return flip_; }
  /// The name of a thumbnail's texture; 0: there is none.
  unsigned thumbnail(const std::string& path) const;
  const DrawStats& stats() const { return stats_; }
  const std::string& renderer() const { return device_->renderer(); }

 private:
  explicit Canvas(std::unique_ptr<GlDevice> device) : device_(std::move(device)) {}

  void update_thumbnails(const Thumbnails& thumbnails);

  /// Everything that a picture depends on.
  struct Recipe {
    std::uint64_t version = 0;
    RenderCamera camera;
    DrawOptions options;
    DrawTarget target;

    friend bool operator==(const Recipe&, const Recipe&) = default;
  };

  std::unique_ptr<GlDevice> device_;
  std::optional<Drawing> drawing_;
  std::uint64_t version_ = 0;     ///< of the scene in `drawing_`
  std::uint64_t shadowed_ = 0;    ///< version of the scene last drawn with shadows
  std::optional<Recipe> recipe_;  ///< of `drawn_`
  GlPicture drawn_;
  GlPicture traced_;
  GlPicture reference_;
  GlPicture difference_;
  GlPicture flip_;
  std::map<std::string, GlPicture> thumbnails_;
  DrawStats stats_;
};

}  // namespace scenefile::viewer
