#pragma once
// The picture in the window: OpenGL's, the ray tracer's, the reference and their differences.
// Internal to the room; needs the window's context.

#include "scenefile/view/draw.h"
#include "scenefile/viewer/gl_picture.h"
#include "scenefile/viewer/session.h"

#include <memory>
#include <optional>
#include <string>

namespace scenefile::viewer {

class Canvas {
 public:
  /// Null, with `error` set, where the context will not do.
  static std::unique_ptr<Canvas> create(GetProcAddress find, std::string& error);

  /// Takes over what has changed in the session: scenes and pictures go to the graphics card.
  void update(Session& session);

  /// Draws the scene for drawn(), where it is another picture than the last; leaves the window's
  /// back buffer in disorder. `framebuffer_height` in pixels; `scale` pixels to a unit of the
  /// window. `hurry`: 0 for the best picture, 1 for one sample a
  /// pixel, and for each more half as many pixels a side. In a hurry there are no shadows where
  /// none have been drawn yet.
  void draw(const Session& session, int framebuffer_height, double scale, int hurry);

  /// What OpenGL makes of the scene at the size of the reference; empty where that is too large.
  Texture picture_for_reference(const Session& session);

  /// Stands on its head.
  const GlPicture& drawn() const { return drawn_; }
  const GlPicture& traced() const { return traced_; }
  const GlPicture& reference() const { return reference_; }
  const GlPicture& difference() const { return difference_; }
  const GlPicture& flip() const { return flip_; }
  const DrawStats& stats() const { return stats_; }
  const std::string& renderer() const { return device_->renderer(); }

 private:
  explicit Canvas(std::unique_ptr<GlDevice> device) : device_(std::move(device)) {}

  /// All that a picture depends on.
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
  std::uint64_t shadowed_ = 0;    ///< version of the scene that was last drawn with its shadows
  std::optional<Recipe> recipe_;  ///< of `drawn_`
  GlPicture drawn_;
  GlPicture traced_;
  GlPicture reference_;
  GlPicture difference_;
  GlPicture flip_;
  DrawStats stats_;
};

}  // namespace scenefile::viewer
