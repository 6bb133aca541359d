#include "scenefile/verbs/drawn_ways.h"

#include "scenefile/asset/compare_images.h"
#include "scenefile/base/text.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/trace/features.h"
#include "scenefile/trace/trace_scene.h"
#include "scenefile/verbs/search_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>

namespace scenefile {

namespace {

// The sets of features that existing references were rendered with.
void add_feature_sets(const RenderOptions& render, std::vector<DrawnWay>& ways) {
  const std::string others = options_text(render);
  const auto add = [&](RenderOptions options, std::string_view features, std::string_view words) {
    parse_features(features, options);
    ways.push_back({options, fmt::format("{} {}", others, words)});
  };
  for (const std::string_view features :
       {"shadows,reflect,refract,texture,depthoffield", "shadows,reflect,refract,texture",
        "illuminate", "shadows,reflect", "shadows", "shadows,texture", "reflect,texture", "texture",
        "texture,texture-filter", "shadows,reflect,texture,texture-filter", "none"}) {
    add(render, features, fmt::format("--features {}", features));
  }
  if (render.mode == Mode::ray) {
    add(render, "intersect", "--features intersect");
    RenderOptions normals = render;
    normals.mode = Mode::normals;
    add(normals, "none", "--mode normals");
  }
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

// Our picture of the scene, or of rows of it; empty if it cannot be drawn.
Texture our_rows(const LoadedScene& scene, RenderOptions options, const glm::ivec2& size,
                 const std::optional<PixelRegion>& rows, const TraceScene* traced) {
  options.width = size.x;
  options.height = size.y;
  options.crop = rows;
  RenderControl control;
  control.traced = traced;
  const RenderResult drawn = our_picture(scene, options, std::move(control));
  return drawn.status == RenderStatus::complete
             ? quantize(drawn.image, rounding_of(options.profile))
             : Texture();
}

// The share of the values that differ by at most `within`.
double share_of_values(const Texture& a, const Texture& b, int within) {
  if (a.rgb.size() != b.rgb.size() || a.rgb.empty()) {
    return 0;
  }
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    equal += std::abs(a.rgb[i] - b.rgb[i]) <= within ? 1 : 0;
  }
  return static_cast<double>(equal) / static_cast<double>(a.rgb.size());
}

// With each profile, the features of `way` and those that come first, then the same with the other
// samples of the course.
std::vector<RenderOptions> likely_options(const DrawnWay& way,
                                          const std::vector<DrawnWay>& possible) {
  std::vector<RenderOptions> likely{way.options};
  std::set<Profile> profiles;
  for (const DrawnWay& one : possible) {
    if (!one.realtime && profiles.insert(one.options.profile).second) {
      likely.push_back(one.options);
      likely.back().mode = way.options.mode;
      likely.back().features = way.options.features;
      likely.push_back(one.options);
    }
  }
  for (std::size_t i = 0, count = likely.size(); i < count; ++i) {
    if (likely[i].profile == Profile::course && likely[i].mode == Mode::ray) {
      likely.push_back(likely[i]);
      likely.back().features.super_sample = !likely[i].features.super_sample;
    }
  }
  return likely;
}

// Whether the words list features one by one, instead of naming a set of them.
bool lists_features(const DrawnWay& way) {
  constexpr std::string_view option = "--features ";
  const std::size_t at = way.words.rfind(option);
  const std::size_t start = at == std::string::npos ? way.words.size() : at + option.size();
  Features any;
  return find_feature(any, std::string_view(way.words).substr(
                               start, way.words.find(',', start) - start)) != nullptr;
}

}  // namespace

std::string options_text(const RenderOptions& options) {
  const RenderOptions usual = default_options(options.profile);
  const std::string features = feature_list(options.features);
  const bool ray_caster = options.mode == Mode::intersect && features == "none";
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
    text += " --features " + features;
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

bool equals_ours(const Texture& picture, const LoadedScene& scene, const DrawnWay& way) {
  if (share_unlike(picture, scene, way) <= max_share_same) {
    return true;
  }
  const glm::ivec2 size(picture.width, picture.height);
  return !way.realtime &&
         compare_images(picture, our_rows(scene, way.options, size, std::nullopt, nullptr), 1)
                 .share_over <= max_share_same;
}

ReferenceWay reference_way(const Texture& reference, const LoadedScene& scene, const DrawnWay& way,
                           const std::vector<DrawnWay>& possible) {
  constexpr double nearly_all = 0.98;
  const glm::ivec2 size(reference.width, reference.height);
  const PixelRegion rows = telling_rows(reference);
  const Texture theirs = cut_out(reference, {rows.x0, rows.y0}, {rows.width(), rows.height()});
  const TraceScene traced(scene.ready.scene, scene.assets, {.threads = way.options.threads});
  const auto drawn = [&](const RenderOptions& options) {
    return our_rows(scene, options, size, rows, &traced);
  };
  RenderOptions best = way.options;
  Texture ours;
  double most = nearly_all;
  std::set<std::string> tried;
  for (const RenderOptions& options : likely_options(way, possible)) {
    if (!tried.insert(options_text(options)).second) {
      continue;
    }
    Texture here = drawn(options);
    const bool all = share_of_values(here, theirs, 0) == 1;
    if (const double share = share_of_values(here, theirs, 1); all || share > most) {
      most = share;
      best = options;
      ours = std::move(here);
    }
    if (all) {
      break;
    }
  }
  const bool exactly = !ours.empty();
  if (!exactly) {
    ours = drawn(best);
  }
  for (const bool listed : {false, true}) {
    for (const DrawnWay& one : possible) {
      if (!one.realtime && one.options.profile == best.profile && lists_features(one) == listed &&
          share_of_values(ours, drawn(one.options), 0) == 1) {
        return {one, exactly};
      }
    }
  }
  return {{best, options_text(best)}, exactly};
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

RealtimeView realtime_view_of(const LoadedScene& scene, const DrawnWay& way,
                              const ComparedPart& part) {
  return {&scene.ready.scene, &scene.assets,        &scene.written,
          *way.realtime,      &scene.ready.sources, part.asked};
}

SceneView view_of(const LoadedScene& scene, const DrawnWay& way, const ComparedPart& part) {
  return {&scene.ready.scene, &scene.assets, way.options,  &scene.written,       way.words,
          part.whole,         part.corner,   part.samples, &scene.ready.sources, part.noise,
          part.asked};
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

}  // namespace scenefile
