// The part of the pictures that is visible, and the values of pixels.

#include "scenefile/viewer/session.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile::viewer {

namespace {

constexpr double largest_pixel = 4 * pixels_for_values;

void set_zoom(Session& session, double zoom, const glm::dvec2& middle) {
  session.zoom = zoom;
  const double half = 0.5 / zoom;
  session.zoom_at = glm::clamp(middle, half, 1 - half);
}

bool shows_values(const Session& session, const PixelSource& source) {
  return pixel_width(session, source) >= pixels_for_values * session.gui_scale;
}

}  // namespace

Box whole_picture(const Session& session, const Box& view) {
  return {view.at + view.size * (0.5 - session.zoom_at * session.zoom), view.size * session.zoom};
}

glm::dvec2 place_in_picture(const Session& session, const glm::dvec2& at) {
  const Box whole =
      whole_picture(session, session.beside.holds(at) ? session.beside : session.picture);
  return (at - whole.at) / whole.size;
}

void zoom_picture(Session& session, double factor, const glm::dvec2& at) {
  const double one = pixel_width(session, pixels_of(session, role_in_front(session)));
  const double most = std::max(1.0, largest_pixel * session.gui_scale * session.zoom / one);
  const double zoom = std::clamp(session.zoom * factor, 1.0, most);
  set_zoom(session, zoom, at + (session.zoom_at - at) * (session.zoom / zoom));
}

void scroll_picture(Session& session, const glm::dvec2& by) {
  set_zoom(session, session.zoom, session.zoom_at + by);
}

void look_beside(Session& session, const glm::ivec2& direction) {
  const PixelSource source = pixels_of(session, role_in_front(session));
  if (source.bytes == nullptr) {
    return;
  }
  constexpr double share = 1.0 / 16;  // of what is visible
  glm::dvec2 step = 1.0 / glm::dvec2(source.size());
  if (!session.magnifier && !shows_values(session, source)) {
    step = glm::max(step, glm::dvec2(share / session.zoom));
  }
  const glm::dvec2 pixel = glm::dvec2(source.pixel_at(session.looked_at)) + 0.5;
  const glm::dvec2 place = pixel / glm::dvec2(source.size()) + step * glm::dvec2(direction);
  session.looked_at = glm::clamp(place, 0.0, 1.0);
  const double inner = (0.5 - share) / session.zoom;  // it stays away from the edge
  scroll_picture(session, session.looked_at - glm::clamp(session.looked_at, session.zoom_at - inner,
                                                         session.zoom_at + inner));
}

PixelSource pixels_of(const Session& session, Role role) {
  if (const OtherPicture* const picture = picture_of(session, role)) {
    const DecodedPicture& decoded = *picture->decoded;
    return {&decoded.texture, decoded.is_linear() ? &decoded.linear : nullptr};
  }
  if (shows_traced(session)) {
    const TracedPicture& traced = *session.traced;
    return {&traced.picture, traced.linear.rgb.empty() ? nullptr : &traced.linear};
  }
  return {session.drawn.empty() ? nullptr : &session.drawn, nullptr};
}

std::array<std::string, 3> value_texts(const Session& session, const PixelSource& source,
                                       const glm::ivec2& pixel) {
  std::array<std::string, 3> texts;
  for (std::size_t i = 0; i < 3; ++i) {
    const int byte = source.bytes->texel(pixel.x, pixel.y)[i];
    texts[i] = !session.settings.linear_values ? fmt::format("{}", byte)
               : source.linear != nullptr
                   ? fmt::format("{:.3f}", source.linear->pixel(pixel.x, pixel.y)[i])
                   : fmt::format("{:.3f}", byte / 255.0);
  }
  return texts;
}

double pixel_width(const Session& session, const PixelSource& source) {
  return session.picture.size.x * session.zoom / std::max(1, source.size().x);
}

}  // namespace scenefile::viewer
