#include "scenefile/verbs/search_causes.h"

#include "scenefile/compare/sheet.h"
#include "scenefile/explain/object_names.h"
#include "scenefile/verbs/jpeg_noise.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

// If at most this share differs, a picture shows the scene.
constexpr double max_share_right = 0.02;
// If a larger share of the reference differs, it may be wrong.
constexpr double min_share_wrong = 0.003;

// Finds the region where the pictures differ most. `way`: how the scene is drawn, or null.
std::optional<PlaceToLook> place_to_look(const Texture& reference, const Texture& test,
                                         const LoadedScene* scene, const DrawnWay* way,
                                         const ComparedPart& part = {}) {
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
  return report.only_details || explains(report.claims) ||
         (report.claims.empty() && explains(report.notes));
}

// The pictures in which causes are looked for.
struct Looked {
  Texture reference;
  Texture test;
  ComparedPart part;
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
  return report.share_scene_unlike <= max_share_unlike && !report.only_details &&
         report.claims.empty() && report.notes.empty();
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

bool nothing_found(const PictureComparison& found) {
  return found.scene_fits() && found.causes.claims.empty() && found.causes.notes.empty();
}

// Says of a JPEG without a cause if compression explains it.
void note_compression(const Texture& reference, const Texture& test, PictureComparison& found) {
  if (nothing_found(found) && found.causes.partial.empty() &&
      (found.causes.only_details || differ_by_compression(reference, test))) {
    found.causes.notes.push_back(
        {Cause::samples, "the colors are as inexact as those of JPEGs", {}, 1});
    found.causes.route = "jpeg-note";
  }
}

}  // namespace

void look_for_causes(const Texture& reference, const Texture& test, const LoadedScene* scene,
                     const std::vector<DrawnWay>& ways, const ComparedPart& part, bool noisy,
                     const CompareSettings& settings, const std::function<bool(double)>& go_on,
                     PictureComparison& found) {
  if (ways.empty()) {
    found.causes = find_causes(reference, test, nullptr, go_on);
    found.where = place_to_look(reference, test, nullptr, nullptr);
    return;
  }
  found.scene_used = true;
  if (ways.front().realtime) {
    found.realtime = ways.front().realtime;
    found.drawn_with = ways.front().words;
    RealtimeView view = realtime_view_of(*scene, ways.front(), part);
    if (settings.lossy) {
      view.noise = in_calm_blocks({reference, test, part}, contrast_of_blocks(test)).part.noise;
    }
    found.causes = find_realtime_causes(reference, test, view, go_on);
    if (settings.lossy) {
      note_compression(reference, test, found);
    }
    found.where = place_to_look(reference, test, scene, &ways.front());
    return;
  }
  const DrawnWay* way = &ways.front();
  const Looked as_it_is{reference, test, part};
  if (settings.lossy) {
    const std::vector<float> contrast = contrast_of_blocks(test);
    found.causes = causes_of(in_calm_blocks(as_it_is, contrast), *scene, ways, go_on,
                             LookFor::several_at_once, way);
    found.causes.route.insert(0, found.causes.route.empty() ? "" : "calm+");
    if (nothing_found(found)) {
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
  if (settings.lossy) {
    note_compression(reference, test, found);
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

std::vector<DrawnWay> ways_of(const Texture& reference, const LoadedScene& scene,
                              const CompareSettings& settings) {
  return settings.ways.empty() ? std::vector<DrawnWay>{DrawnWay()}
         : settings.ways_fit   ? settings.ways
                               : ways_drawn(reference, scene, settings.ways);
}

RenderResult our_picture(const LoadedScene& scene, const RenderOptions& options,
                         RenderControl control) {
  RenderResult drawn = render(scene.ready.scene, scene.assets, options, std::move(control));
  if (drawn.status == RenderStatus::failed) {
    throw std::bad_alloc();
  }
  return drawn;
}

}  // namespace scenefile
