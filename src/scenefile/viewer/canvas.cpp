#include "scenefile/viewer/canvas.h"

#include "scenefile/view/draw_options.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scenefile::viewer {

namespace {

// A single selected object is tinted; groups get a box (gui_overlay.cpp).
std::uint32_t highlighted(const Session& session) {
  return session.selected ? session.shown->outline.rows[*session.selected].source : no_index;
}

}  // namespace

std::unique_ptr<Canvas> Canvas::create(GetProcAddress find, std::string& error) {
  std::unique_ptr<GlDevice> device = GlDevice::create(find, error);
  return device == nullptr ? nullptr : std::unique_ptr<Canvas>(new Canvas(std::move(device)));
}

void Canvas::update(Session& session) {
  if (session.shown != nullptr && session.version != version_) {
    version_ = session.version;
    Diagnostics found;
    const OpenedScene& opened = session.shown->opened;
    drawing_.emplace(upload(*device_, opened.ready.scene, opened.assets,
                            upload_options(session.setup.trace), found));
    session.drawing_notes.clear();
    for (const Diagnostic& finding : found.list()) {
      session.drawing_notes.push_back(finding.message);
    }
  }
  if (session.traced && traced_.version() != session.traced_version) {
    traced_.show(quantize(session.traced->image, rounding_of(session.setup.trace.profile)),
                 session.traced_version);
  }
  reference_.show(session.reference, session.reference_version);
  update_thumbnails(session.thumbnails);
  if (session.comparison) {
    difference_.show(session.comparison->difference, session.comparison_version);
    flip_.show(session.comparison->flip, session.comparison_version);
  }
}

void Canvas::update_thumbnails(const Thumbnails& thumbnails) {
  const std::map<std::string, Thumbnail>& all = thumbnails.all();
  std::erase_if(thumbnails_, [&](const auto& entry) { return !all.contains(entry.first); });
  for (const auto& [path, thumbnail] : all) {
    thumbnails_[path].show(thumbnail.picture,
                           static_cast<std::uint64_t>(thumbnail.stamp.modified_ns));
  }
}

unsigned Canvas::thumbnail(const std::string& path) const {
  const auto found = thumbnails_.find(path);
  return found == thumbnails_.end() ? 0 : found->second.name();
}

void Canvas::draw(const Session& session, int framebuffer_height, double scale, int hurry) {
  if (!drawing_) {
    return;
  }
  DrawOptions options = draw_options(session);
  if (hurry > 0) {
    options.samples = 1;
    options.shadows = options.shadows && shadowed_ == version_;
  } else if (!options.course) {
    options.samples = 4;  // fast enough while the camera moves
  }
  options.highlighted = highlighted(session);
  const Box& box = session.picture;
  DrawTarget target;
  target.x = static_cast<int>(std::lround(box.at.x * scale));
  target.width = static_cast<int>(std::lround(box.size.x * scale));
  target.height = static_cast<int>(std::lround(box.size.y * scale));
  target.y = framebuffer_height - static_cast<int>(std::lround(box.at.y * scale)) - target.height;
  if (hurry == 0 && options.shadows) {
    shadowed_ = version_;
  }
  for (int i = 1; i < hurry; ++i) {
    target.width = std::max(1, target.width / 2);
    target.height = std::max(1, target.height / 2);
  }
  Recipe recipe{version_, render_camera(session.camera), std::move(options), target};
  if (recipe_ != recipe) {
    stats_ = scenefile::draw(*device_, *drawing_, recipe.camera, recipe.options, target);
    drawn_.take(target.x, target.y, target.width, target.height);
    recipe_ = std::move(recipe);
  }
}

Texture Canvas::picture_for_reference(const Session& session) {
  if (!drawing_) {
    return {};
  }
  DrawOptions options = draw_options(session);
  if (!options.course) {
    options.samples = 16;
  }
  std::string error;
  const Image image = draw_image(*device_, *drawing_, render_camera(session.camera), options,
                                 session.reference.width, session.reference.height, error);
  return error.empty() ? quantize(image, Rounding::nearest) : Texture();
}

}  // namespace scenefile::viewer
