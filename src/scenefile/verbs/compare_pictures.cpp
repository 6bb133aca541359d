#include "scenefile/verbs/compare_pictures.h"

#include "scenefile/base/text.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/explain/object_names.h"
#include "scenefile/trace/features.h"
#include "scenefile/trace/render.h"
#include "scenefile/verbs/jpeg_noise.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <new>
#include <set>

namespace scenefile {

namespace {

// If at most this share differs, a picture shows the scene.
constexpr double max_share_right = 0.02;
// If a larger share of the reference differs, it may be wrong.
constexpr double min_share_wrong = 0.003;

// The sets of features that existing references were rendered with.
void add_feature_sets(RenderOptions render, std::vector<DrawnWay>& ways) {
  const std::string others = options_text(render);
  const auto add = [&](const char* words, const Features& features) {
    render.features = features;
    ways.push_back({render, fmt::format("{} --features {}", others, words)});
  };
  Features f = render.features;
  f.super_sample = false;
  f.texture_filter = false;
  add("shadows,reflect,refract,texture,depthoffield", f);
  f.depthoffield = false;
  add("shadows,reflect,refract,texture", f);
  f.refract = false;
  add("illuminate", f);
  f.texture = false;
  add("shadows,reflect", f);
  f.reflect = false;
  add("shadows", f);
  f = {true, false, false, true, false, false, false};
  add("shadows,texture", f);
  f = {false, true, false, true, false, false, false};
  add("reflect,texture", f);
  f = {false, false, false, true, false, false, false};
  add("texture", f);
  f = {false, false, false, true, true, false, false};
  add("texture,texture-filter", f);
  f = {true, true, false, true, true, false, false};
  add("shadows,reflect,texture,texture-filter", f);
  add("none", Features{false, false, false, false, false, false, false});
  if (render.mode == Mode::ray) {
    render.features = Features{false, false, false, false, false, false, false};
    for (const Mode mode : {Mode::intersect, Mode::normals}) {
      render.mode = mode;
      ways.push_back({render, mode == Mode::intersect
                                  ? fmt::format("{} --features intersect", others)
                                  : fmt::format("{} --mode {}", others, mode_word(mode))});
    }
  }
}

RealtimeView realtime_view_of(const LoadedScene& scene, const DrawnWay& way) {
  return {&scene.ready.scene, &scene.assets, &scene.written, *way.realtime, &scene.ready.sources};
}

// The part of the picture of the scene that is compared: SceneView's members of these names.
struct Part {
  glm::dvec2 whole{0};
  glm::dvec2 corner{0};
  int samples = 1;
  std::vector<float> noise = {};
  std::optional<glm::dvec2> asked = std::nullopt;
};

SceneView view_of(const LoadedScene& scene, const DrawnWay& way, const Part& part = {}) {
  return {&scene.ready.scene, &scene.assets, way.options,  &scene.written,       way.words,
          part.whole,         part.corner,   part.samples, &scene.ready.sources, part.noise,
          part.asked};
}

// Finds the region where the pictures differ most. `way`: how the scene is drawn, or null.
std::optional<PlaceToLook> place_to_look(const Texture& reference, const Texture& test,
                                         const LoadedScene* scene, const DrawnWay* way,
                                         const Part& part = {}) {
  const std::optional<WorstRegion> region = worst_region(reference, test);
  if (!region) {
    return std::nullopt;
  }
  PlaceToLook place{*region, false, {}, {}};
  if (way != nullptr) {
    const glm::ivec2 pixel(region->x, region->y);
    const glm::ivec2 size(reference.width, reference.height);
    const std::optional<std::uint32_t> source =
        way->realtime ? realtime_source_at(realtime_view_of(*scene, *way), pixel, size)
                      : source_at(view_of(*scene, *way, part), pixel, size);
    if (source) {
      const WayPoint at = ObjectNames(scene->written, scene->ready.sources).at(*source);
      place.hit = true;
      place.object = at.path;
      place.location = at.location;
    }
  }
  return place;
}

bool explained_by_one(const CauseReport& report) {
  const auto explains = [](const std::vector<Claim>& claims) {
    return claims.size() == 1 && claims.front().explained > 0.95;
  };
  return report.share_different < max_share_same || explains(report.claims) ||
         (report.claims.empty() && explains(report.notes));
}

std::vector<DrawnWay> ways_of(const Texture& reference, const LoadedScene& scene,
                              const CompareSettings& settings) {
  return settings.ways.empty() ? std::vector<DrawnWay>{DrawnWay()}
         : settings.ways_fit   ? settings.ways
                               : ways_drawn(reference, scene, settings.ways);
}

// Sorts all but the first, which is the likeliest way to draw the reference: equally likely ones
// first, and among these, those whose features differ most from the first. A program that lacks one
// of the features of an assignment often lacks all of them.
void most_different_first(std::span<const SceneView> views, std::vector<AlikeView>& best) {
  const Features& first = views[best.front().index].options.features;
  const auto unlike = [&](const AlikeView& one) {
    const Features& f = views[one.index].options.features;
    return int(f.shadows != first.shadows) + int(f.reflect != first.reflect) +
           int(f.refract != first.refract) + int(f.texture != first.texture);
  };
  std::stable_sort(best.begin() + 1, best.end(), [&](const AlikeView& a, const AlikeView& b) {
    return a.equally != b.equally ? a.equally : unlike(a) > unlike(b);
  });
}

// Whether colors were probably changed to fit into a palette. With fewer colors, it had room.
bool has_palette(const Texture& picture) {
  std::set<std::uint32_t> colors;
  for (std::size_t i = 0; i + 2 < picture.rgb.size() && colors.size() <= 256; i += 3) {
    colors.insert(std::uint32_t{picture.rgb[i]} << 16 | std::uint32_t{picture.rgb[i + 1]} << 8 |
                  picture.rgb[i + 2]);
  }
  return colors.size() > 128 && colors.size() <= 256;
}

// The pictures in which causes are looked for.
struct Looked {
  Texture reference;
  Texture test;
  Part part;
};

// The means of 2x2 or 4x4 pixels: the noise of JPEGs, palettes and scaling is small in them.
Looked without_noise(const Looked& look) {
  const auto& [reference, test, part] = look;
  const int k = reference.width >= 600 ? 4 : reference.width >= 240 ? 2 : 1;
  const glm::ivec2 size = glm::ivec2(test.width, test.height) / k;
  const auto smaller = [&](const Texture& t) {
    return scaled(cut_out(t, {0, 0}, k * size), size.x, size.y);
  };
  const glm::dvec2 whole = part.whole.x > 0 ? part.whole : glm::dvec2(test.width, test.height);
  const auto asked = part.asked ? std::optional(*part.asked / double(k)) : std::nullopt;
  return {smaller(reference),
          smaller(test),
          {whole / double(k), part.corner / double(k), 2, {}, asked}};
}

// Only the pixels that compression as a JPEG has hardly changed, because there is little contrast
// near them: of 100, one is off by more than 5/255. `contrast`: contrast_of_blocks() of the test.
Looked in_calm_blocks(Looked look, const std::vector<float>& contrast) {
  constexpr float low_contrast = 20;
  for (const float here : contrast) {
    look.part.noise.push_back(here <= low_contrast ? 0 : std::numeric_limits<float>::infinity());
  }
  return look;
}

// All pixels, as means in which the noise is small; where there is contrast, some of it is left.
Looked with_noise_of_blocks(const Looked& look, const std::vector<float>& contrast) {
  constexpr float share_of_contrast = 0.1F;  // of nine in ten means of 2x2 pixels, at quality 90
  Looked means = without_noise(look);
  const int k = look.test.width / means.test.width;
  for (int y = 0; y < means.test.height; ++y) {
    for (int x = 0; x < means.test.width; ++x) {
      means.part.noise.push_back(share_of_contrast *
                                 contrast[std::size_t(k * y) * look.test.width + k * x]);
    }
  }
  return means;
}

// Whether a report only names some of the mistakes that another one names, and explains less.
bool is_part_of(const CauseReport& report, const CauseReport& other) {
  constexpr double clearly = 0.005;
  return report.claims.size() < other.claims.size() &&
         std::all_of(report.claims.begin(), report.claims.end(), [&](const Claim& claim) {
           return std::any_of(other.claims.begin(), other.claims.end(), [&](const Claim& c) {
             return c.what == claim.what && c.explained > claim.explained + clearly;
           });
         });
}

// Looks for causes. `way`: in which the reference was drawn, and the program probably as well.
CauseReport causes_of(const Looked& look, const LoadedScene& scene,
                      const std::vector<DrawnWay>& ways, const std::function<bool(double)>& go_on,
                      LookFor look_for, const DrawnWay*& way) {
  const SceneView view = view_of(scene, *way, look.part);
  CauseReport found = find_causes(look.reference, look.test, &view, go_on, look_for);
  // The program may have drawn with features that the reference does not use.
  for (std::size_t i = 1; i < ways.size(); ++i) {
    const bool decided_by_a_hair = ways[i].nearly && !found.claims.empty();
    if (explained_by_one(found) && !decided_by_a_hair) {
      continue;
    }
    const SceneView other = view_of(scene, ways[i], look.part);
    CauseReport causes =
        find_causes(look.reference, look.test, &other, go_on, LookFor::single_mistakes);
    const bool better = !decided_by_a_hair || causes.claims.size() < found.claims.size();
    if (explained_by_one(causes) && better && !is_part_of(causes, found)) {
      causes.route = "other-way+" + causes.route;
      found = std::move(causes);
      way = &ways[i];
    }
  }
  return found;
}

bool explains_nothing(const CauseReport& report) {
  return report.share_scene_unlike <= max_share_unlike &&
         report.share_different >= max_share_same && report.claims.empty() && report.notes.empty();
}

// Whether the pictures were probably given in the wrong order: `test` is right, and a mistake
// explains the reference.
bool probably_exchanged(const Texture& reference, const Texture& test, const LoadedScene& scene,
                        const CompareSettings& settings, const std::function<bool(double)>& go_on) {
  const DrawnWay way = ways_of(test, scene, settings).front();
  if (way.realtime || share_unlike(test, scene, way) > max_share_same) {
    return false;
  }
  const SceneView view = view_of(scene, way);
  const CauseReport swapped = find_causes(test, reference, &view, go_on, LookFor::single_mistakes);
  return !swapped.claims.empty() && explained_by_one(swapped);
}

// The rows of a picture with the most contrast.
PixelRegion telling_rows(const Texture& picture) {
  constexpr int max_rows = 24;
  const int rows = std::min(max_rows, picture.height);
  PixelRegion best{0, 0, picture.width, rows};
  std::uint64_t most = 0;
  for (int top = 0; top + rows <= picture.height; top += rows) {
    std::uint64_t contrast = 0;
    for (int y = top; y < top + rows; ++y) {
      const std::uint8_t* row = picture.texel(0, y);
      for (int i = 3; i < 3 * picture.width; ++i) {
        contrast += static_cast<std::uint64_t>(std::abs(row[i] - row[i - 3]));
      }
    }
    if (contrast > most) {
      most = contrast;
      best = {0, top, picture.width, top + rows};
    }
  }
  return best;
}

// Our picture of the scene. If memory runs out, what was found so far would be another answer.
RenderResult our_picture(const LoadedScene& scene, const RenderOptions& options,
                         RenderControl control = {}) {
  RenderResult drawn = render(scene.ready.scene, scene.assets, options, std::move(control));
  if (drawn.status == RenderStatus::failed) {
    throw std::bad_alloc();
  }
  return drawn;
}

// The share of the values in these rows that our picture of the scene has within rounding.
double share_of_equal_values(const Texture& reference, const PixelRegion& rows,
                             const LoadedScene& scene, RenderOptions options) {
  options.width = reference.width;
  options.height = reference.height;
  options.crop = rows;
  const RenderResult drawn = our_picture(scene, options);
  if (drawn.status != RenderStatus::complete) {
    return 0;
  }
  const Texture ours = quantize(drawn.image, rounding_of(options.profile));
  const std::uint8_t* theirs = reference.texel(0, rows.y0);
  std::size_t equal = 0;
  for (std::size_t i = 0; i < ours.rgb.size(); ++i) {
    equal += std::abs(ours.rgb[i] - theirs[i]) <= 1 ? 1 : 0;
  }
  return static_cast<double>(equal) /
         static_cast<double>(std::max<std::size_t>(1, ours.rgb.size()));
}

// Sets in which way the reference was drawn, which includes its samples, and whether exactly so.
// The search for causes needs neither.
void find_drawn_with(const Texture& reference, const LoadedScene& scene, const DrawnWay& way,
                     PictureComparison& found) {
  constexpr double nearly_all = 0.98;
  const PixelRegion rows = telling_rows(reference);
  double most = share_of_equal_values(reference, rows, scene, way.options);
  if (way.options.profile == Profile::course && way.options.mode == Mode::ray) {
    RenderOptions other = way.options;
    other.features.super_sample = !other.features.super_sample;
    if (const double share = share_of_equal_values(reference, rows, scene, other); share > most) {
      most = share;
      found.drawn_with = options_text(other);
      found.drawn_options = other;
    }
  }
  found.drawn_exactly = most >= nearly_all;
}

// Looks for causes; uses the scene if there are ways to draw it.
void look_for_causes(const Texture& reference, const Texture& test, const LoadedScene* scene,
                     const std::vector<DrawnWay>& ways, const Part& part, bool noisy,
                     const CompareSettings& settings, const std::function<bool(double)>& go_on,
                     PictureComparison& found) {
  if (ways.empty()) {
    found.causes = find_causes(reference, test, nullptr, go_on);
    found.where = place_to_look(reference, test, nullptr, nullptr);
    return;
  }
  found.scene_used = true;
  if (ways.front().realtime) {
    found.realtime = true;
    found.drawn_with = ways.front().words;
    found.causes =
        find_realtime_causes(reference, test, realtime_view_of(*scene, ways.front()), go_on);
    found.where = place_to_look(reference, test, scene, &ways.front());
    return;
  }
  const DrawnWay* way = &ways.front();
  const Looked as_it_is{reference, test, part};
  const auto nothing_found = [&] {
    return found.scene_fits() && found.causes.claims.empty() && found.causes.notes.empty();
  };
  if (settings.lossy) {
    const std::vector<float> contrast = contrast_of_blocks(test);
    found.causes = causes_of(in_calm_blocks(as_it_is, contrast), *scene, ways, go_on,
                             LookFor::several_at_once, way);
    found.causes.route.insert(0, found.causes.route.empty() ? "" : "calm+");
    if (nothing_found()) {
      // If several mistakes do not explain the calm pixels that differ, they do not explain all.
      const LookFor look_for =
          explains_nothing(found.causes) ? LookFor::single_mistakes : LookFor::several_at_once;
      found.causes =
          causes_of(with_noise_of_blocks(as_it_is, contrast), *scene, ways, go_on, look_for, way);
    }
  } else {
    found.causes = causes_of(noisy ? without_noise(as_it_is) : as_it_is, *scene, ways, go_on,
                             LookFor::several_at_once, way);
  }
  found.other_outlines = explains_nothing(found.causes) && found.causes.partial.empty() &&
                         have_other_outlines(reference, test);
  if (settings.lossy && nothing_found() && found.causes.partial.empty() &&
      differ_by_compression(reference, test)) {
    found.causes.notes.push_back(
        {Cause::samples, "the colors are as inexact as those of JPEGs", {}, 1});
    found.causes.route = "jpeg-note";
  }
  if (!noisy && explains_nothing(found.causes) && !found.other_outlines) {
    // With several samples per pixel, textures and edges differ, but less so in the means.
    const DrawnWay* other_way = way;
    CauseReport causes = causes_of(without_noise(as_it_is), *scene, ways, go_on,
                                   LookFor::single_mistakes, other_way);
    if (explained_by_one(causes)) {
      causes.share_scene_unlike = found.causes.share_scene_unlike;
      causes.route = "means+" + causes.route;
      found.causes = std::move(causes);
      way = other_way;
    }
  }
  found.drawn_with = way->words;
  found.drawn_options = way->options;
  if (!settings.ways_fit && !found.other_size() && found.scene_fits()) {
    find_drawn_with(reference, *scene, *way, found);
  }
  found.where = place_to_look(reference, test, scene, way, part);
  const double unlike = found.causes.share_scene_unlike;
  found.exchanged = !found.other_size() &&
                    (unlike > max_share_unlike
                         ? share_unlike(test, *scene, *way) <= max_share_right
                         : unlike > min_share_wrong && !settings.ways_fit &&
                               probably_exchanged(reference, test, *scene, settings, go_on));
  if (found.exchanged) {  // so the causes are those of the reference, the wrong way around
    found.causes.claims.clear();
    found.causes.rivals.clear();
    found.causes.partial.clear();
    found.causes.notes.clear();
    found.where.reset();
  }
}

// The pixels of a whole picture of that size that are in `test`.
PixelRegion visible(const PicturePlace& place, const Texture& test) {
  const glm::ivec2 from = glm::max(-place.corner, glm::ivec2(0));
  const glm::ivec2 to = glm::min(glm::ivec2(test.width, test.height) - place.corner, place.size);
  return {from.x, from.y, to.x, to.y};
}

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

// Fills in what is compared if the sizes differ. `scene`: null if it cannot be drawn.
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
  std::string text;
  if (found.place) {
    const glm::ivec2 from = glm::max(found.place->corner, glm::ivec2(0));
    const glm::ivec2 to = glm::min(found.place->corner + found.place->size, found.test_size);
    text = fmt::format("its part at {},{} of size {}x{}, ", from.x, from.y, to.x - from.x,
                       to.y - from.y);
    if (to - from != found.place->size) {
      text += fmt::format("where a picture of size {}x{} is cut off, ", found.place->size.x,
                          found.place->size.y);
    }
  }
  return text + (found.drawn       ? "with our picture of the scene at that size"
                 : found.resampled ? "after scaling"
                                   : "with the reference");
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

}  // namespace

std::string options_text(const RenderOptions& options) {
  const RenderOptions usual = default_options(options.profile);
  Features features = options.features;
  std::vector<std::string_view> words;
  for (const std::string_view word : feature_words()) {
    if (*find_feature(features, word)) {
      words.push_back(word);
    }
  }
  const bool ray_caster = options.mode == Mode::intersect && words.empty();
  std::string text = fmt::format("--profile {}", profile_word(options.profile));
  if (options.max_depth != usual.max_depth) {
    text += fmt::format(" --max-depth {}", options.max_depth);
  }
  if (options.mode != Mode::ray && !ray_caster) {
    text += fmt::format(" --mode {}", mode_word(options.mode));
  }
  if (ray_caster) {
    text += " --features intersect";
  } else if (options.features != usual.features) {
    text +=
        words.empty() ? " --features none" : fmt::format(" --features {}", fmt::join(words, ","));
  }
  return text;
}

std::vector<DrawnWay> possible_ways(std::span<const RenderOptions> profiles, bool features_known) {
  std::vector<DrawnWay> ways;
  for (const RenderOptions& render : profiles) {
    ways.push_back({render, options_text(render)});
    if (!features_known) {
      add_feature_sets(render, ways);
    }
  }
  return ways;
}

double share_unlike(const Texture& picture, const LoadedScene& scene, const DrawnWay& way) {
  if (way.realtime) {
    return find_realtime_causes(picture, picture, realtime_view_of(scene, way)).share_scene_unlike;
  }
  const SceneView view = view_of(scene, way);
  return find_causes(picture, picture, &view).share_scene_unlike;
}

std::vector<DrawnWay> folder_first(std::string_view reference, std::vector<DrawnWay> ways) {
  struct Folder {
    std::string_view word;
    std::string_view way;
  };
  static constexpr std::array folders{Folder{"intersect_normal", "--mode normals"},
                                      Folder{"intersect", "--features intersect"},
                                      Folder{"illuminate", "--features illuminate"}};
  const std::string path = lower_case(reference.substr(0, reference.rfind('/') + 1));
  std::size_t last = 0;
  std::string_view named;
  for (const Folder& folder : folders) {
    const std::size_t at = path.rfind(folder.word);
    if (at != std::string::npos && (named.empty() || at > last)) {
      last = at;
      named = folder.way;
    }
  }
  if (!named.empty()) {
    std::stable_partition(ways.begin(), ways.end(), [named](const DrawnWay& way) {
      return std::string_view(way.words).ends_with(named);
    });
  }
  return ways;
}

DrawnWay realtime_way(const RealtimeOptions& panel, const RealtimeUnknowns& unknowns) {
  return {RenderOptions(), realtime_words(panel), panel, unknowns};
}

std::vector<DrawnWay> ways_drawn(const Texture& reference, const LoadedScene& scene,
                                 const std::vector<DrawnWay>& ways) {
  if (ways.size() == 1 && !ways.front().realtime) {
    RenderOptions any = ways.front().options;
    any.mode = Mode::ray;
    any.features = default_options(any.profile).features;
    any.features.super_sample = false;
    any.features.texture_filter = false;
    const std::vector<DrawnWay> fitting =
        ways_drawn(reference, scene, possible_ways(std::array{any}, false));
    const double given = share_unlike(reference, scene, ways.front());
    constexpr double min_share = 0.01;
    constexpr double max_ratio = 0.5;
    return given > min_share && share_unlike(reference, scene, fitting.front()) < max_ratio * given
               ? fitting
               : ways;
  }
  std::vector<const DrawnWay*> traced;
  std::vector<SceneView> views;
  const DrawnWay* realtime = nullptr;
  for (const DrawnWay& way : ways) {
    if (way.realtime) {
      realtime = &way;
    } else {
      traced.push_back(&way);
      views.push_back(view_of(scene, way));
    }
  }
  std::vector<AlikeView> best = views.empty() ? std::vector<AlikeView>() : alike(reference, views);
  if (!best.empty()) {
    most_different_first(views, best);
  }
  std::vector<DrawnWay> found;
  for (const auto& [i, equally] : best) {
    // With a mistake, fewer features may be visible than in the first way.
    const auto same = [&, i = i, equally = equally](const DrawnWay& way) {
      const Features& a = way.options.features;
      const Features& b = traced[i]->options.features;
      return way.options.mode == traced[i]->options.mode && a.shadows == b.shadows &&
             a.texture == b.texture && (equally || a.refract == b.refract);
    };
    if (found.size() < 3 && std::none_of(found.begin(), found.end(), same)) {
      found.push_back(*traced[i]);
      found.back().nearly = !equally;
    }
  }
  if (realtime == nullptr ||
      (!found.empty() && share_unlike(reference, scene, found.front()) <= max_share_unlike)) {
    return found;
  }
  const DrawnWay fitted = realtime_way(
      find_realtime_settings(reference, realtime_view_of(scene, *realtime), realtime->unknowns),
      {});
  return found.empty() || share_unlike(reference, scene, fitted) <= max_share_unlike
             ? std::vector<DrawnWay>{fitted}
             : found;
}

namespace {

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

// The number of values that are equal in pictures of the same size.
std::size_t equal_values(const Texture& a, const Texture& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    count += a.rgb[i] == b.rgb[i] ? 1 : 0;
  }
  return count;
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
  if (found.other_size()) {
    found.broken.insert(
        found.broken.begin(),
        fmt::format("the size is {}x{}, expected {}x{}; compared {}", test.width, test.height,
                    given.width, given.height, what_was_compared(found)));
  }
  const ShownPlace in_test = shown_place(test, shown, found);
  const std::optional<glm::dvec2> asked =
      found.measures.same_size ? place_asked(settings, in_test, shown, found) : std::nullopt;
  // Several searches, each from the start to the end, are one for the caller.
  double most = 0;
  const std::function<bool(double)> forward = [&](double done) {
    most = std::max(most, done);
    return !go_on || go_on(most);
  };
  const bool wanted = !found.broken.empty() ||
                      (settings.look == LookForCauses::always && found.measures.difference.max > 0);
  if (wanted && found.measures.same_size && !found.equal_in_8_bits) {
    if (ways.empty() && drawable != nullptr) {
      ways = ways_of(given, *scene, settings);
    }
    if (settings.ways.size() == 1 && ways.size() >= 1 && !ways.front().realtime &&
        ways.front().words != settings.ways.front().words) {
      found.contradicted = settings.ways.front().words;
    }
    const Part part{found.whole, found.corner, 1, {}, asked};
    const bool noisy = settings.lossy || found.resampled || has_palette(shown);
    look_for_causes(reference, shown, drawable, ways, part, noisy, settings, forward, found);
    if (found.where && !found.scene_fits()) {  // the pictures show other objects there
      found.where->hit = false;
    }
    if (found.where) {
      found.where->region = in_picture(found.where->region, in_test.corner, in_test.scale);
    }
    if (found.other_size() && found.causes.claims.empty()) {
      found.right_at_other_size =
          found.causes.share_different < max_share_same || !found.causes.notes.empty();
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

void round_alike(DecodedPicture& a, DecodedPicture& b) {
  if (a.is_linear() == b.is_linear()) {
    return;
  }
  DecodedPicture& linear = a.is_linear() ? a : b;
  const Texture& other = a.is_linear() ? b.texture : a.texture;
  Texture truncated = quantize(linear.linear, Rounding::truncate);
  if (truncated.width == other.width && truncated.height == other.height &&
      equal_values(truncated, other) > equal_values(linear.texture, other)) {
    linear.texture = std::move(truncated);
  }
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

std::string not_finite_text(const DecodedPicture& picture) {
  return fmt::format("{} of its pixels {} not finite (NaN or infinite)", picture.not_finite,
                     picture.not_finite == 1 ? "is" : "are");
}

std::string causes_text(const PictureComparison& found) {
  if (found.exchanged) {
    return "the second picture shows the scene, and the first does not: give the reference first\n";
  }
  if (found.equal_in_8_bits) {
    return "cause: none; as 8-bit pictures, both are equal\n";
  }
  const CauseReport& report = found.causes;
  std::string text;
  for (const Claim& claim : report.claims) {
    text += fmt::format("cause: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  for (const Claim& claim : report.rivals) {
    if (claim.said) {
      continue;
    }
    text += fmt::format("   or: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  if (found.right_at_other_size) {
    text += found.place ? "cause: none; the part that was compared is right\n"
                        : "cause: none; the picture is right, at another size\n";
  } else if (report.claims.empty() && found.measures.same_size && found.scene_fits()) {
    text += !report.notes.empty()
                ? "cause: none; the pictures only differ in that, at edges and by rounding\n"
            : report.share_different < max_share_same
                ? "cause: none; the pictures only differ at edges and by rounding\n"
            : found.other_outlines
                ? "cause: no known mistake explains the difference, and few edges match: is this a "
                  "picture of the same scene, from the same camera?\n"
            : found.scene_used ? "cause: no known mistake explains the difference\n"
                               : "cause: none found from the pictures alone; most causes need "
                                 "--scene SCENE, the scene of the pictures\n";
    if (!report.confined.empty()) {
      text += fmt::format("       {}\n", report.confined);
    }
  }
  for (const Claim& claim : report.partial) {
    text += fmt::format("in part: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  for (const Claim& note : report.notes) {
    text += fmt::format(" note: {}; this is not a mistake by itself\n", note.what);
  }
  if (!found.scene_used) {
    return text;
  }
  if (!found.scene_fits()) {
    return text + fmt::format(
                      "the scene does not match the reference: our picture of it differs in "
                      "{:.0f} % of the pixels; is it the right scene, with its textures? If so, "
                      "give the {} that the reference was made with\n",
                      100 * report.share_scene_unlike,
                      found.realtime ? "--parameters, --near, --far, --filter and --milestone"
                                     : "--profile and --features");
  }
  if (!found.drawn_with.empty()) {
    text += fmt::format("reference: {} drawn with {}{}\n", found.drawn_exactly ? "as" : "nearly as",
                        found.drawn_with,
                        found.contradicted.empty()
                            ? ""
                            : fmt::format(", not with {}, which was given", found.contradicted));
  }
  return text;
}

std::string where_text(const PictureComparison& found,
                       const std::function<std::string(const glm::ivec2& pixel)>& command) {
  if (!found.where) {
    return {};
  }
  const PlaceToLook& place = *found.where;
  const WorstRegion& r = place.region;
  std::string text = fmt::format("worst: {},{}..{},{}, {:.0f} % of the difference", r.x0, r.y0,
                                 r.x1, r.y1, 100 * r.share);
  if (place.hit) {
    text +=
        fmt::format("; it shows {}{}", escaped(place.object, 80),
                    place.location.known() ? fmt::format(" (line {})", place.location.line) : "");
  } else if (found.scene_used && found.scene_fits()) {
    text += "; it shows nothing of the scene";
  }
  return text + (command && found.scene_used && found.scene_fits() && !found.realtime
                     ? fmt::format("\n       try: {}\n", command({r.x, r.y}))
                     : fmt::format("\n       look at pixel {},{}\n", r.x, r.y));
}

void add_claims(Json& json, std::string_view name, const std::vector<Claim>& claims) {
  json.begin_array(name);
  for (const Claim& claim : claims) {
    json.begin_object();
    json.add("cause", name_of(claim.cause));
    json.add("what", claim.what);
    json.add("evidence", claim.evidence);
    json.add("explained", claim.explained);
    json.end_object();
  }
  json.end_array();
}

void add_clauses(Json& json, std::string_view name, const std::vector<std::string>& clauses) {
  json.begin_array(name);
  for (const std::string& clause : clauses) {
    json.value(std::string_view(clause));
  }
  json.end_array();
}

void add_measures(Json& json, const PictureMeasures& m) {
  json.add("same_size", m.same_size);
  json.add("psnr_db", m.difference.psnr_db);
  json.add("mean_difference", m.difference.mean);
  if (m.linear) {
    json.add("max_difference", m.difference.max);
  } else {
    json.add("max_difference", static_cast<int>(m.difference.max));
  }
  json.add("share_over", m.difference.share_over);
  json.add("linear", m.linear);
  json.add("ssim", m.ssim);
  json.add("flip_mean", m.flip_mean);
  json.add("flip_max", m.flip_max);
}

void add_comparison(Json& json, const PictureComparison& found) {
  json.add("same", found.broken.empty());
  json.add("scaled", found.resampled);
  json.add("reference_redrawn", found.drawn);
  if (found.place) {
    json.begin_object("place");
    json.add("x", found.place->corner.x);
    json.add("y", found.place->corner.y);
    json.add("width", found.place->size.x);
    json.add("height", found.place->size.y);
    json.end_object();
  }
  json.add("right_at_other_size", found.right_at_other_size);
  json.add("exchanged", found.exchanged);
  json.add("other_outlines", found.other_outlines);
  json.add("equal_in_8_bits", found.equal_in_8_bits);
  json.add("confined", found.causes.confined);
  add_measures(json, found.measures);
  add_clauses(json, "broken", found.broken);
  add_claims(json, "causes", found.causes.claims);
  add_claims(json, "rivals", found.causes.rivals);
  add_claims(json, "partial", found.causes.partial);
  add_claims(json, "notes", found.causes.notes);
  if (found.where) {
    const PlaceToLook& place = *found.where;
    json.begin_object("worst");
    json.add("x0", place.region.x0);
    json.add("y0", place.region.y0);
    json.add("x1", place.region.x1);
    json.add("y1", place.region.y1);
    json.add("x", place.region.x);
    json.add("y", place.region.y);
    json.add("mean_difference", place.region.mean);
    json.add("share", place.region.share);
    if (place.hit) {
      json.add("object", place.object);
      if (place.location.known()) {
        json.add("line", place.location.line);
      }
    }
    json.end_object();
  }
  if (found.scene_used) {
    json.add("share_scene_unlike", found.causes.share_scene_unlike);
    json.add("reference_drawn_with", found.drawn_with);
    json.add("given_way_contradicted", !found.contradicted.empty());
  }
}

}  // namespace scenefile
