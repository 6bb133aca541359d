#include "scenefile/verbs/compare_pictures.h"

#include "scenefile/base/text.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/explain/object_names.h"
#include "scenefile/trace/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace scenefile {

namespace {

// Share of pixels. If more differ, the scene or its settings are not those of the reference.
constexpr double max_share_unlike = 0.1;
// If at most this share differs, a picture shows the scene.
constexpr double max_share_right = 0.02;

std::string_view profile_option(Profile profile) {
  return profile == Profile::course ? "--profile course" : "--profile fine";
}

// The sets of features that existing references were rendered with.
void add_feature_sets(RenderOptions render, std::vector<DrawnWay>& ways) {
  const std::string_view profile = profile_option(render.profile);
  const auto add = [&](const char* words, const Features& features) {
    render.features = features;
    ways.push_back({render, fmt::format("{} --features {}", profile, words)});
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
                                  ? fmt::format("{} --features intersect", profile)
                                  : fmt::format("{} --mode {}", profile, mode_word(mode))});
    }
  }
}

RealtimeView realtime_view_of(const LoadedScene& scene, const DrawnWay& way) {
  return {&scene.ready.scene, &scene.assets, &scene.written, *way.realtime};
}

SceneView view_of(const LoadedScene& scene, const DrawnWay& way) {
  return {&scene.ready.scene, &scene.assets, way.options, &scene.written, way.words};
}

// Finds the region where the pictures differ most. `way`: how the scene is drawn, or null.
std::optional<PlaceToLook> place_to_look(const Texture& reference, const Texture& test,
                                         const LoadedScene* scene, const DrawnWay* way) {
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
                      : source_at(view_of(*scene, *way), pixel, size);
    if (source) {
      const WayPoint at = ObjectNames(scene->written, scene->ready.sources).at(*source);
      place.hit = true;
      place.object = at.path;
      place.location = at.location;
    }
  }
  return place;
}

// A word of a command line, quoted for shells.
std::string shell_word(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("._-/+,:=@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) {
    return word;
  }
  std::string quoted = "'";
  for (const char c : word) {
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return quoted + "'";
}

bool explained_by_one(const CauseReport& report) {
  return report.share_different < 0.001 ||
         (report.claims.size() == 1 && report.claims.front().explained > 0.95);
}

// The share of the reference's pixels that differ from our picture drawn this way.
double share_unlike(const Texture& reference, const LoadedScene& scene, const DrawnWay& way) {
  if (way.realtime) {
    return find_realtime_causes(reference, reference, realtime_view_of(scene, way))
        .share_scene_unlike;
  }
  const SceneView view = view_of(scene, way);
  return find_causes(reference, reference, &view).share_scene_unlike;
}

std::vector<DrawnWay> ways_of(const Texture& reference, const LoadedScene& scene,
                              const CompareSettings& settings) {
  return settings.ways.empty() ? std::vector<DrawnWay>{DrawnWay()}
         : settings.ways_fit   ? settings.ways
                               : ways_drawn(reference, scene, settings.ways);
}

// Looks for causes; uses the scene if there are ways to draw it.
void look_for_causes(const Texture& reference, const Texture& test, const LoadedScene* scene,
                     const std::vector<DrawnWay>& ways, const std::function<bool(double)>& go_on,
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
  const SceneView view = view_of(*scene, *way);
  found.causes = find_causes(reference, test, &view, go_on);
  // The program may have drawn with features that the reference does not use.
  for (std::size_t i = 1; i < ways.size() && !explained_by_one(found.causes); ++i) {
    const SceneView other = view_of(*scene, ways[i]);
    CauseReport causes = find_causes(reference, test, &other, go_on, LookFor::single_mistakes);
    if (explained_by_one(causes)) {
      found.causes = std::move(causes);
      way = &ways[i];
    }
  }
  found.drawn_with = way->words;
  found.where = place_to_look(reference, test, scene, way);
  if (found.causes.share_scene_unlike > max_share_unlike) {
    found.exchanged = share_unlike(test, *scene, *way) <= max_share_right;
    if (found.exchanged) {  // so the causes are those of the reference, the wrong way around
      found.causes.claims.clear();
      found.causes.rivals.clear();
      found.causes.partial.clear();
    }
  }
}

// The picture in the size of the reference if only the size differs, not the shape.
std::optional<Texture> scaled_like(const Texture& picture, const Texture& reference) {
  const double across = double(picture.width) * reference.height;
  const double down = double(picture.height) * reference.width;
  if (std::abs(across - down) > 0.02 * across) {
    return std::nullopt;
  }
  return scaled(picture, reference.width, reference.height);
}

// Our picture of the scene in the size of `test`, if our picture matches the reference at its size.
std::optional<Texture> drawn_like(const Texture& test, const Texture& reference,
                                  const LoadedScene& scene, const DrawnWay& way,
                                  const std::function<bool(double)>& go_on) {
  if (test.empty() || way.realtime || share_unlike(reference, scene, way) > max_share_unlike) {
    return std::nullopt;
  }
  RenderOptions options = way.options;
  options.width = test.width;
  options.height = test.height;
  options.crop = {};
  RenderControl control;
  control.progress = go_on ? [&go_on](double) { return go_on(0); } : Progress();
  const RenderResult drawn = render(scene.ready.scene, scene.assets, options, std::move(control));
  if (drawn.status != RenderStatus::complete) {
    return std::nullopt;
  }
  return quantize(drawn.image, rounding_of(options.profile));
}

}  // namespace

std::vector<DrawnWay> possible_ways(std::span<const RenderOptions> profiles, bool features_known) {
  std::vector<DrawnWay> ways;
  for (const RenderOptions& render : profiles) {
    ways.push_back({render, std::string(profile_option(render.profile))});
    if (!features_known) {
      add_feature_sets(render, ways);
    }
  }
  return ways;
}

DrawnWay realtime_way(const RealtimeOptions& panel, const RealtimeUnknowns& unknowns) {
  return {RenderOptions(), realtime_words(panel), panel, unknowns};
}

std::vector<DrawnWay> ways_drawn(const Texture& reference, const LoadedScene& scene,
                                 const std::vector<DrawnWay>& ways) {
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
  std::vector<DrawnWay> found;
  for (const std::size_t i :
       views.empty() ? std::vector<std::size_t>() : equally_alike(reference, views)) {
    // With a mistake, fewer features may be visible than in the first way.
    const auto same = [&](const DrawnWay& way) {
      const Features& a = way.options.features;
      const Features& b = traced[i]->options.features;
      return way.options.mode == traced[i]->options.mode && a.shadows == b.shadows &&
             a.texture == b.texture;
    };
    if (found.size() < 3 && std::none_of(found.begin(), found.end(), same)) {
      found.push_back(*traced[i]);
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

PictureComparison compare_pictures(const Texture& given, const Texture& test,
                                   const LoadedScene* scene, const CompareSettings& settings,
                                   const std::function<bool(double)>& go_on) {
  PictureComparison found;
  const bool drawable = scene != nullptr && scene->usable();
  const bool same_size = test.width == given.width && test.height == given.height;
  std::vector<DrawnWay> ways;  // found only if needed
  if (!same_size && drawable) {
    ways = ways_of(given, *scene, settings);
    found.drawn = drawn_like(test, given, *scene, ways.front(), go_on);
  }
  if (!same_size && !found.drawn) {
    found.scaled = scaled_like(test, given);
  }
  const Texture& reference = found.reference_of(given);
  const Texture& shown = found.test_of(test);
  found.measures = measure(reference, shown, settings.pixel_threshold, &found.flip_errors);
  found.broken = broken_thresholds(settings.thresholds, found.measures);
  if (found.other_size()) {
    found.broken.insert(
        found.broken.begin(),
        fmt::format("the size is {}x{}, expected {}x{}; compared {}", test.width, test.height,
                    given.width, given.height,
                    found.drawn ? "with our picture of the scene at that size" : "after scaling"));
  }
  const bool wanted = !found.broken.empty() ||
                      (settings.look == LookForCauses::always && found.measures.difference.max > 0);
  if (wanted && found.measures.same_size) {
    if (ways.empty() && drawable) {
      ways = ways_of(given, *scene, settings);
    }
    look_for_causes(reference, shown, scene, ways, go_on, found);
    if (found.other_size() && found.causes.claims.empty()) {
      found.right_at_other_size = found.causes.share_different < 0.001;
    }
  }
  return found;
}

std::string causes_text(const PictureComparison& found) {
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
  for (const Claim& claim : report.partial) {
    text += fmt::format("in part: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  if (found.scene_used && report.share_scene_unlike <= max_share_unlike &&
      !found.drawn_with.empty()) {
    text += fmt::format("reference: as drawn with {}\n", found.drawn_with);
  }
  if (found.exchanged) {
    return text +
           "the second picture shows the scene, and the first does not: give the reference "
           "first\n";
  }
  if (found.right_at_other_size) {
    return text + "cause: none; the picture is right, at another size\n";
  }
  if (found.scene_used && report.share_scene_unlike > max_share_unlike) {
    text += fmt::format(
        "the scene does not match the reference: our picture of it differs in {:.0f} % of the "
        "pixels; give the {} that the reference was made with\n",
        100 * report.share_scene_unlike,
        found.realtime ? "--parameters, --near, --far, --filter and --milestone"
                       : "--profile and --features");
  } else if (report.claims.empty() && found.measures.same_size) {
    text += report.share_different < 0.001
                ? "cause: none; the pictures only differ at edges and by rounding\n"
            : found.scene_used ? "cause: no known mistake explains the difference\n"
                               : "cause: none found from the pictures alone; most causes need "
                                 "--scene SCENE, the scene of the pictures\n";
  }
  return text;
}

std::string where_text(const PictureComparison& found, const std::string& scene,
                       const std::string& test) {
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
  } else if (found.scene_used) {
    text += "; it shows nothing of the scene";
  }
  // explain traces rays, and compares with a picture of the same size.
  if (scene.empty() || found.realtime || found.scaled) {
    return text + fmt::format("\n       look at pixel {},{}\n", r.x, r.y);
  }
  return text + fmt::format(
                    "\n       try: scenefile explain {} --pixel {},{} --size {}x{}{}{} --mine {}\n",
                    escaped(shell_word(scene), 4096), r.x, r.y, found.measures.size.x,
                    found.measures.size.y, found.drawn_with.empty() ? "" : " ", found.drawn_with,
                    escaped(shell_word(test), 4096));
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
  json.add("max_difference", m.difference.max);
  json.add("share_over", m.difference.share_over);
  json.add("ssim", m.ssim);
  json.add("flip_mean", m.flip_mean);
  json.add("flip_max", m.flip_max);
}

void add_comparison(Json& json, const PictureComparison& found) {
  json.add("same", found.broken.empty());
  json.add("scaled", found.scaled.has_value());
  json.add("reference_redrawn", found.drawn.has_value());
  json.add("right_at_other_size", found.right_at_other_size);
  json.add("exchanged", found.exchanged);
  add_measures(json, found.measures);
  add_clauses(json, "broken", found.broken);
  add_claims(json, "causes", found.causes.claims);
  add_claims(json, "rivals", found.causes.rivals);
  add_claims(json, "partial", found.causes.partial);
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
  }
}

}  // namespace scenefile
