#include "scenefile/grade/realtime_settings.h"

#include "scenefile/geometry/realtime_mesh.h"
#include "scenefile/grade/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr double max_triangles_to_fit = 400000;
constexpr int max_fitted_parameter = 40;  // largest parameter that is tried
constexpr double fits_well = 0.002;       // share of the colors that may differ

double triangles_of(const RealtimeShapes& shapes, const TessellationParameters& parameters) {
  double sum = 0;
  for (std::size_t i = 0; i < shape_count; ++i) {
    const auto shape = static_cast<Shape>(i);
    const double count = shape == Shape::mesh ? 0 : shapes.counts[i];
    sum += count > 0
               ? count * static_cast<double>(realtime_mesh(shape, parameters).triangles.size())
               : 0;
  }
  return sum;
}

// A picture at some points: pixels at edges, which show the tessellation, and others.
class Fit {
 public:
  Fit(const Texture& picture, const RealtimeDrawn& drawn) : picture_(picture), drawn_(drawn) {
    std::vector<std::uint32_t> edges;
    std::vector<std::uint32_t> all;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const auto index = static_cast<std::uint32_t>(y * picture.width + x);
        all.push_back(index);
        if (!around(picture, x, y).calm()) {
          edges.push_back(index);
        }
      }
    }
    std::mt19937 random(7);
    add_points(picture, picture, std::move(edges), 500, true, true, random, points_);
    add_points(picture, picture, std::move(all), 400, true, true, random, points_);
    for (Point& p : points_) {
      p.weight = 1;
    }
  }

  /// The mean error of colors, divided by the largest error that counts.
  double error(const RealtimeOptions& panel) const {
    if (triangles_of(*drawn_.shapes(), panel.tessellation) > max_triangles_to_fit) {
      return 1;
    }
    const RealtimeTrial trial = drawn_.with(panel);
    const auto visible =
        find_visible(trial, drawn_.shapes(), drawn_.assets(), picture_.width, picture_.height);
    const RealtimePicture drawn(trial, visible, drawn_.assets(), picture_.width, picture_.height);
    Colors colors;
    for (const Point& p : points_) {
      colors.push_back(255.0 * drawn.pixel(p.x, p.y));
    }
    return score(points_, points_.size(), colors).left /
           (192.0 * static_cast<double>(std::max<std::size_t>(1, points_.size())));
  }

 private:
  const Texture& picture_;
  const RealtimeDrawn& drawn_;
  std::vector<Point> points_;
};

// Coordinate descent: changes one parameter at a time, until none improves.
TessellationParameters best_parameters(const Fit& fit, RealtimeOptions panel) {
  double least = fit.error(panel);
  const auto try_one = [&](const TessellationParameters& p) {
    RealtimeOptions other = panel;
    other.tessellation = p;
    const double error = fit.error(other);
    if (error < 0.98 * least) {
      least = error;
      panel.tessellation = p;
    }
  };
  if (least <= fits_well) {
    return panel.tessellation;
  }
  for (const auto& [p1, p2] :
       {std::pair(5, 5), std::pair(1, 3), std::pair(2, 3), std::pair(3, 3), std::pair(1, 1),
        std::pair(3, 5), std::pair(10, 10), std::pair(20, 20), std::pair(25, 25), std::pair(50, 50),
        std::pair(100, 100)}) {
    if (least > fits_well) {
      try_one({p1, p2});
    }
  }
  for (int round = 0; round < 3 && least > fits_well; ++round) {
    const TessellationParameters before = panel.tessellation;
    for (int p2 = 3; p2 <= max_fitted_parameter && least > fits_well; ++p2) {
      try_one({panel.tessellation.parameter1, p2});
    }
    for (int p1 = 1; p1 <= max_fitted_parameter && least > fits_well; ++p1) {
      try_one({p1, panel.tessellation.parameter2});
    }
    if (before == panel.tessellation) {
      break;
    }
  }
  return panel.tessellation;
}

// The number in [low, high] with the fewest digits.
double round_number(double low, double high) {
  for (const double step : {100.0, 50.0, 10.0, 5.0, 1.0, 0.5, 0.1, 0.05, 0.01, 0.005, 0.001}) {
    const double value = std::ceil(low / step) * step;
    if (value <= high && value > 0) {
      return std::round(value * 1000) / 1000;
    }
  }
  return (low + high) / 2;
}

// The depth of what is drawn at a pixel, and whether the picture shows it.
struct PixelDepth {
  double depth = 0;
  bool shown = false;
};

std::vector<PixelDepth> depths_of(const Texture& picture, const RealtimeDrawn& drawn,
                                  const RealtimeOptions& open) {
  const RealtimeTrial trial = drawn.with(open);
  const auto visible =
      find_visible(trial, drawn.shapes(), drawn.assets(), picture.width, picture.height);
  const RealtimePicture ours(trial, visible, drawn.assets(), picture.width, picture.height);
  std::vector<PixelDepth> depths;
  const int step = std::max(1, picture.width / 256);
  for (int y = 0; y < picture.height; y += step) {
    for (int x = 0; x < picture.width; x += step) {
      if (ours.triangle_at(x, y) == Visibility::nothing) {
        continue;
      }
      const double off = largest_of(glm::abs(at(picture, x, y) - 255.0 * ours.pixel(x, y)));
      if (off <= 4 || off > 8) {
        depths.push_back({ours.depth_at(x, y), off <= 4});
      }
    }
  }
  std::sort(depths.begin(), depths.end(),
            [](const PixelDepth& a, const PixelDepth& b) { return a.depth < b.depth; });
  return depths;
}

// The range of indices, [first, last), that holds as many shown and as few missing pixels as
// possible.
std::pair<std::size_t, std::size_t> shown_range(const std::vector<PixelDepth>& depths) {
  std::pair<std::size_t, std::size_t> best{0, 0};
  long most = 0;
  long sum = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    sum += depths[i].shown ? 1 : -1;
    if (sum > most) {
      most = sum;
      best = {start, i + 1};
    } else if (sum < 0) {
      sum = 0;
      start = i + 1;
    }
  }
  return best;
}

}  // namespace

RealtimeDrawn::RealtimeDrawn(const RealtimeView& view) : view_(view) {
  right_.panel = view.panel;
  right_.scene.options.features = {false, false, false, false, false, false, false};
  right_.scene.scene.global = view.scene->global;
  right_.scene.scene.camera = view.scene->camera;
  right_.scene.scene.materials = view.scene->materials;
  right_.scene.scene.lights = view.scene->lights;
  keep_lights(right_.scene.scene);
  shapes_ = realtime_shapes(*view.scene);
  if (shapes_ != nullptr &&
      triangles_of(*shapes_, view.panel.tessellation) > max_triangles_to_fit) {
    shapes_ = nullptr;
  }
}

void RealtimeDrawn::keep_lights(RenderScene& scene) const {
  std::erase_if(scene.lights,
                [&](const RenderLight& l) { return !has_light(view_.panel.milestone, l.type); });
}

RealtimeTrial RealtimeDrawn::with(const RealtimeOptions& panel) const {
  RealtimeTrial trial = right_;
  trial.panel = panel;
  return trial;
}

RealtimeOptions fitted_depths(const Texture& picture, const RealtimeDrawn& drawn,
                              const RealtimeOptions& start) {
  const RealtimeOptions defaults;
  RealtimeOptions open = start;
  open.near = std::min(start.near, defaults.near);
  open.far = std::max(start.far, defaults.far);
  const std::vector<PixelDepth> depths = depths_of(picture, drawn, open);
  const auto [first, last] = shown_range(depths);
  // Planes that cut off only a few pixels are not evidence.
  if (last > first && first >= 3 * few_pixels) {
    open.near = round_number(depths[first - 1].depth, depths[first].depth);
  }
  if (last > first && depths.size() - last >= 3 * few_pixels) {
    open.far = round_number(depths[last - 1].depth, depths[last].depth);
  }
  const Fit fit(picture, drawn);
  return open.near < open.far && fit.error(open) < 0.7 * fit.error(start) ? open : start;
}

TessellationParameters fitted_parameters(const Texture& picture, const RealtimeDrawn& drawn,
                                         const RealtimeOptions& start) {
  return best_parameters(Fit(picture, drawn), start);
}

RealtimeOptions find_realtime_settings(const Texture& reference, const RealtimeView& view,
                                       const RealtimeUnknowns& unknowns) {
  RealtimeOptions best = view.panel;
  if (!unknowns.any() || reference.empty()) {
    return best;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Milestone milestone : {Milestone::lights_camera, Milestone::action}) {
    if (!unknowns.milestone && milestone != view.panel.milestone) {
      continue;
    }
    RealtimeView of_milestone = view;
    of_milestone.panel.milestone = milestone;
    const RealtimeDrawn drawn(of_milestone);
    if (!drawn.usable()) {
      return view.panel;
    }
    const Fit fit(reference, drawn);
    RealtimeOptions panel = of_milestone.panel;
    double error = fit.error(panel);
    // With the wrong parameters another filter may fit better, so it is determined again in each
    // round.
    const auto fit_filter = [&] {
      for (std::size_t i = 0; unknowns.filter && error > fits_well && i < filter_words.size();
           ++i) {
        RealtimeOptions one = panel;
        one.filter = static_cast<Filter>(i);
        if (const double e = fit.error(one); e < error) {
          error = e;
          panel = one;
        }
      }
    };
    fit_filter();
    for (int round = 0; round < 2 && error > fits_well; ++round) {
      const RealtimeOptions before = panel;
      if (unknowns.near || unknowns.far) {
        const RealtimeOptions fitted = fitted_depths(reference, drawn, panel);
        panel.near = unknowns.near ? fitted.near : panel.near;
        panel.far = unknowns.far ? fitted.far : panel.far;
      }
      if (unknowns.parameters) {
        panel.tessellation = best_parameters(fit, panel);
      }
      error = fit.error(panel);
      fit_filter();
      if (panel == before) {
        break;
      }
    }
    // If both fit, as in a picture without lights, the first one.
    if (error < 0.95 * least - 1e-6) {
      least = error;
      best = panel;
    }
    if (least <= fits_well) {
      break;
    }
  }
  return best;
}

std::string realtime_words(const RealtimeOptions& panel) {
  const RealtimeOptions defaults;
  std::string words = fmt::format("--profile realtime --parameters {},{}",
                                  panel.tessellation.parameter1, panel.tessellation.parameter2);
  if (panel.near != defaults.near) {
    words += fmt::format(" --near {}", panel.near);
  }
  if (panel.far != defaults.far) {
    words += fmt::format(" --far {}", panel.far);
  }
  if (panel.filter != defaults.filter) {
    words += fmt::format(" --filter {}", word_of(panel.filter));
  }
  if (panel.milestone != defaults.milestone) {
    words += fmt::format(" --milestone {}", word_of(panel.milestone));
  }
  return words;
}

}  // namespace scenefile
