#include "scenefile/verbs/compare_pictures.h"

#include "scenefile/verbs/other_size.h"
#include "scenefile/verbs/search_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace scenefile {

namespace {

// Whether colors were probably changed to fit into a palette. With fewer colors, it had room.
bool has_palette(const Texture& picture) {
  std::set<std::uint32_t> colors;
  for (std::size_t i = 0; i + 2 < picture.rgb.size() && colors.size() <= 256; i += 3) {
    colors.insert(std::uint32_t{picture.rgb[i]} << 16 | std::uint32_t{picture.rgb[i + 1]} << 8 |
                  picture.rgb[i + 2]);
  }
  return colors.size() > 128 && colors.size() <= 256;
}

// The region of a part of a picture, in the pixels of the picture.
WorstRegion in_picture(WorstRegion region, const glm::ivec2& corner, double scale) {
  const auto place = [&](int& x, int& y) {
    x = corner.x + static_cast<int>(x * scale);
    y = corner.y + static_cast<int>(y * scale);
  };
  place(region.x0, region.y0);
  place(region.x1, region.y1);
  place(region.x, region.y);
  return region;
}

// Where the picture that is compared is in the picture under test.
struct ShownPlace {
  glm::ivec2 corner{0};
  double scale = 1;  // pixels of the picture under test for one of the other
};

ShownPlace shown_place(const Texture& test, const Texture& shown, const PictureComparison& found) {
  const int width = found.place ? visible(*found.place, test).width() : test.width;
  return {found.place ? glm::max(found.place->corner, glm::ivec2(0)) : glm::ivec2(0),
          static_cast<double>(width) / shown.width};
}

// Where the pixel that is asked for is in the picture that is compared. Sets found.asked.
std::optional<glm::dvec2> place_asked(const CompareSettings& settings, const ShownPlace& part,
                                      const Texture& shown, PictureComparison& found) {
  if (!settings.asked) {
    return std::nullopt;
  }
  const glm::dvec2 place = (glm::dvec2(*settings.asked - part.corner) + 0.5) / part.scale;
  const glm::dvec2 size(shown.width, shown.height);
  if (glm::any(glm::lessThan(place, glm::dvec2(0))) ||
      glm::any(glm::greaterThanEqual(place, size))) {
    return std::nullopt;
  }
  found.asked = glm::ivec2(place) + found.corner;
  found.asked_of = found.whole.x > 0 ? found.whole : glm::ivec2(size);
  return place;
}

// Sets in which way the reference was drawn, with its samples, which the search for causes does not
// need. It depends on the reference only, so that two pictures get the same answer; if the search
// needed other features, a note says so.
void find_drawn_with(const Texture& reference, const LoadedScene& scene,
                     const std::vector<DrawnWay>& ways, const CompareSettings& settings,
                     PictureComparison& found) {
  std::vector<DrawnWay> possible = settings.ways;
  if (!found.contradicted.empty()) {
    RenderOptions usual = default_options(ways.front().options.profile);
    usual.max_depth = ways.front().options.max_depth;
    possible = possible_ways(std::array{usual}, false);
  }
  if (found.drawn_with != ways.front().words && !found.causes.claims.empty()) {
    found.causes.notes.push_back(
        {Cause::features,
         fmt::format("the picture is drawn with {}; the reference looks the same with it",
                     found.drawn_with),
         {},
         0});
  }
  const ReferenceWay drawn = reference_way(reference, scene, ways.front(), possible);
  found.drawn_with = drawn.way.words;
  found.drawn_options = drawn.way.options;
  found.drawn_exactly = drawn.exactly;
}

// `linear`: the difference of the pictures as floats, or null.
PictureComparison compare(const Texture& given, const Texture& test, const ImageDifference* linear,
                          const LoadedScene* scene, const CompareSettings& settings,
                          const std::function<bool(double)>& go_on) {
  PictureComparison found;
  found.test_size = {test.width, test.height};
  const LoadedScene* const drawable = scene != nullptr && scene->usable() ? scene : nullptr;
  std::vector<DrawnWay> ways;  // found only if needed
  if (test.width != given.width || test.height != given.height) {
    if (drawable != nullptr) {
      ways = ways_of(given, *scene, settings);
    }
    make_comparable(given, test, drawable, ways, go_on, found);
  }
  const Texture& reference = found.reference_of(given);
  const Texture& shown = found.test_of(test);
  found.measures = measure(reference, shown, settings.pixel_threshold, &found.flip_errors);
  if (linear != nullptr) {
    found.equal_in_8_bits = found.measures.difference.max == 0 && linear->max > 0;
    found.measures.difference = *linear;
    found.measures.linear = true;
  }
  found.broken = broken_thresholds(settings.thresholds, found.measures);
  found.measures.size = {test.width, test.height};
  found.measures.right_size = {given.width, given.height};
  if (found.other_size()) {
    found.broken.insert(
        found.broken.begin(),
        fmt::format("the size is {}x{}, expected {}x{}; compared {}", test.width, test.height,
                    given.width, given.height, what_was_compared(found)));
  }
  const ShownPlace in_test = shown_place(test, shown, found);
  const std::optional<glm::dvec2> asked =
      found.measures.comparable ? place_asked(settings, in_test, shown, found) : std::nullopt;
  // Several searches, each from the start to the end, are one for the caller.
  double most = 0;
  const std::function<bool(double)> forward = [&](double done) {
    most = std::max(most, done);
    return !go_on || go_on(most);
  };
  const bool wanted = !found.broken.empty() ||
                      (settings.look == LookForCauses::always && found.measures.difference.max > 0);
  if (found.other_size()) {
    found.causes = find_causes(given, test, nullptr);
  }
  if (wanted && found.causes.claims.empty() && found.measures.comparable &&
      !found.equal_in_8_bits) {
    if (ways.empty() && drawable != nullptr) {
      ways = ways_of(given, *scene, settings);
    }
    if (settings.ways.size() == 1 && ways.size() >= 1 && !ways.front().realtime &&
        ways.front().words != settings.ways.front().words) {
      found.contradicted = settings.ways.front().words;
    }
    const ComparedPart part{found.whole, found.corner, 1, {}, asked};
    const bool noisy = settings.lossy || found.resampled || has_palette(shown);
    look_for_causes(reference, shown, drawable, ways, part, noisy, settings, forward, found);
    if (!found.drawn_with.empty() && !found.realtime && !settings.ways_fit && found.scene_fits()) {
      find_drawn_with(given, *drawable, ways, settings, found);
    }
    if (!noisy && (found.causes.only_details || !found.causes.notes.empty())) {
      found.details = words_of_details(reference, shown);
    }
    if (found.where && !found.scene_fits()) {  // the pictures show other objects there
      found.where->hit = false;
    }
    if (found.where) {
      found.where->region = in_picture(found.where->region, in_test.corner, in_test.scale);
    }
    if (found.other_size() && found.causes.claims.empty()) {
      found.right_at_other_size = found.causes.only_details || !found.causes.notes.empty();
    }
  }
  return found;
}

}  // namespace

PictureComparison compare_pictures(const Texture& reference, const Texture& test,
                                   const LoadedScene* scene, const CompareSettings& settings,
                                   const std::function<bool(double)>& go_on) {
  return compare(reference, test, nullptr, scene, settings, go_on);
}

PictureComparison compare_pictures(const DecodedPicture& reference, const DecodedPicture& test,
                                   const LoadedScene* scene, const CompareSettings& settings,
                                   const std::function<bool(double)>& go_on) {
  const bool linear = reference.is_linear() && test.is_linear() &&
                      reference.linear.width == test.linear.width &&
                      reference.linear.height == test.linear.height;
  const ImageDifference difference =
      linear ? compare_images(reference.linear, test.linear, settings.pixel_threshold)
             : ImageDifference();
  return compare(reference.texture, test.texture, linear ? &difference : nullptr, scene, settings,
                 go_on);
}

}  // namespace scenefile
