#include "scenefile/verbs/other_size.h"

#include "scenefile/compare/sheet.h"
#include "scenefile/verbs/search_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

// Our picture of the scene where `test` shows it, if our picture matches the reference at its size.
std::optional<Texture> drawn_like(const PicturePlace& place, const Texture& test,
                                  const Texture& reference, const LoadedScene& scene,
                                  const DrawnWay& way, const std::function<bool(double)>& go_on) {
  if (test.empty() || way.realtime || share_unlike(reference, scene, way) > max_share_unlike) {
    return std::nullopt;
  }
  RenderOptions options = way.options;
  options.width = place.size.x;
  options.height = place.size.y;
  options.crop = visible(place, test);
  RenderControl control;
  control.progress = go_on ? [&go_on](double) { return go_on(0); } : Progress();
  const RenderResult drawn = our_picture(scene, options, std::move(control));
  if (drawn.status != RenderStatus::complete) {
    return std::nullopt;
  }
  return quantize(drawn.image, rounding_of(options.profile));
}

// The share of the pixels, by every third row, that are nearly equal.
double share_alike(const Texture& a, const Texture& b) {
  std::size_t alike = 0;
  std::size_t all = 0;
  for (int y = 0; y < a.height; y += 3) {
    for (int x = 0; x < a.width; ++x) {
      const std::uint8_t* p = a.texel(x, y);
      const std::uint8_t* q = b.texel(x, y);
      alike +=
          std::abs(p[0] - q[0]) <= 4 && std::abs(p[1] - q[1]) <= 4 && std::abs(p[2] - q[2]) <= 4;
      ++all;
    }
  }
  return static_cast<double>(alike) / static_cast<double>(std::max<std::size_t>(1, all));
}

// Prepares a picture of another size: drawn at this size, or scaled after drawing, whichever is
// more like the picture. `test`: only the part that shows the scene.
void compare_at_other_size(const PicturePlace& place, const Texture& given, const Texture& test,
                           const LoadedScene* scene, const std::vector<DrawnWay>& ways,
                           const std::function<bool(double)>& go_on, PictureComparison& found) {
  const Texture& shown = found.test_of(test);
  const PixelRegion seen = visible(place, test);
  const glm::ivec2 from(seen.x0, seen.y0);
  const glm::ivec2 part(seen.width(), seen.height());
  found.whole = place.size;
  found.corner = from;
  std::optional<Texture> drawn;
  if (scene != nullptr && place.size != glm::ivec2(given.width, given.height)) {
    drawn = drawn_like(place, test, given, *scene, ways.front(), go_on);
  }
  const double aspects =
      static_cast<double>(place.size.x) * given.height / (double(place.size.y) * given.width);
  if (std::abs(aspects - 1) > 0.02) {  // drawn at this size, if at all
    found.other_reference = std::move(drawn);
    found.drawn = found.other_reference.has_value();
    return;
  }
  if (place.size.x > given.width) {
    // The picture becomes as small as the reference.
    const double by = static_cast<double>(given.width) / place.size.x;
    const glm::ivec2 corner(glm::round(glm::dvec2(from) * by));
    const glm::ivec2 size = glm::min(glm::ivec2(glm::round(glm::dvec2(part) * by)),
                                     glm::ivec2(given.width, given.height) - corner);
    Texture reference = cut_out(given, corner, size);
    Texture smaller = scaled(shown, size.x, size.y);
    if (!drawn || share_alike(reference, smaller) > share_alike(*drawn, shown)) {
      found.other_reference = std::move(reference);
      found.other_test = std::move(smaller);
      found.resampled = true;
      found.whole = {given.width, given.height};
      found.corner = corner;
      return;
    }
  } else {
    Texture reference = cut_out(scaled(given, place.size.x, place.size.y), from, part);
    if (!drawn || share_alike(reference, shown) > share_alike(*drawn, shown)) {
      found.other_reference = std::move(reference);
      found.resampled = place.size.x != given.width;
      return;
    }
  }
  found.other_reference = std::move(drawn);
  found.drawn = true;
}

}  // namespace

PixelRegion visible(const PicturePlace& place, const Texture& test) {
  const glm::ivec2 from = glm::max(-place.corner, glm::ivec2(0));
  const glm::ivec2 to = glm::min(glm::ivec2(test.width, test.height) - place.corner, place.size);
  return {from.x, from.y, to.x, to.y};
}

void make_comparable(const Texture& given, const Texture& test, const LoadedScene* scene,
                     const std::vector<DrawnWay>& ways, const std::function<bool(double)>& go_on,
                     PictureComparison& found) {
  const glm::ivec2 size(given.width, given.height);
  found.place = find_picture(given, test);
  if (found.place) {
    if (const auto other = picture_next_to(*found.place, given, test)) {
      found.place = other;
    }
    // The assignment Realtime is not drawn in parts.
    const bool whole = found.place->size == size &&
                       visible(*found.place, test) == PixelRegion{0, 0, size.x, size.y};
    if (scene != nullptr && ways.front().realtime && !whole) {
      found.place.reset();
    }
  }
  if (found.place) {
    const PixelRegion seen = visible(*found.place, test);
    found.other_test = cut_out(test, found.place->corner + glm::ivec2(seen.x0, seen.y0),
                               {seen.width(), seen.height()});
  }
  const PicturePlace all{{0, 0}, {test.width, test.height}};
  compare_at_other_size(found.place.value_or(all), given, test, scene, ways, go_on, found);
}

std::string what_was_compared(const PictureComparison& found) {
  const std::string whole = found.drawn       ? "with our picture of the scene at that size"
                            : found.resampled ? "after scaling"
                                              : "with the reference";
  if (!found.place) {
    return whole;
  }
  const auto& [corner, size] = *found.place;
  const glm::ivec2 from = glm::max(corner, glm::ivec2(0));
  const glm::ivec2 shown = glm::min(corner + size, found.test_size) - from;
  const std::string part =
      shown == found.test_size
          ? ""
          : fmt::format("its part at {},{} of size {}x{}, ", from.x, from.y, shown.x, shown.y);
  if (shown == size) {
    return part + whole;
  }
  const glm::ivec2 cut = from - corner;
  return part + fmt::format("with the part at {},{} of ", cut.x, cut.y) +
         (found.drawn       ? fmt::format("our picture of the scene at {}x{}", size.x, size.y)
          : found.resampled ? fmt::format("the reference scaled to {}x{}", size.x, size.y)
                            : "the reference");
}

}  // namespace scenefile
