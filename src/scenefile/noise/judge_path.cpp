#include "scenefile/noise/judge_path.h"

#include "scenefile/noise/linearize.h"
#include "scenefile/noise/weighted_fit.h"
#include "scenefile/path/lamps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace scenefile {

namespace {

using std::numbers::pi;

// Differences of our model from a right program: the shape of filters, float precision.
constexpr double model_error = 0.004;

// The standard error of a block, relative to its light, beyond which the noise cannot be measured.
constexpr double too_much_noise = 0.25;

struct Extent2 {
  int x0, y0, x1, y1;
};

Extent2 block_at(const PathTruth& truth, std::size_t b) {
  const int x = static_cast<int>(b) % truth.columns * block_side;
  const int y = static_cast<int>(b) / truth.columns * block_side;
  return {x, y, std::min(x + block_side, truth.width), std::min(y + block_side, truth.height)};
}

template <typename Visit>
void for_each_pixel(const PathTruth& truth, std::size_t b, const Visit& visit) {
  const Extent2 e = block_at(truth, b);
  for (int y = e.y0; y < e.y1; ++y) {
    for (int x = e.x0; x < e.x1; ++x) {
      visit(x, y, std::size_t(y) * truth.width + x);
    }
  }
}

double median_of(std::vector<double> values) {
  if (values.empty()) {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

BlockColors combined(const BlockColors& a, double by, const BlockColors& b) {
  BlockColors sum = a;
  for (std::size_t i = 0; i < sum.size() && i < b.size(); ++i) {
    sum[i] += by * b[i];
  }
  return sum;
}

// Half of the value, half of the mean of the blocks around it.
BlockColors shrunk(const BlockColors& values, int columns) {
  const int rows = static_cast<int>(values.size()) / columns;
  BlockColors result = values;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      Color sum(0);
      int count = 0;
      for (int j = std::max(0, y - 1); j <= std::min(rows - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(columns - 1, x + 1); ++i) {
          sum += values[std::size_t(j) * columns + i];
          ++count;
        }
      }
      const std::size_t at = std::size_t(y) * columns + x;
      result[at] = 0.5 * values[at] + 0.5 * sum / double(count);
    }
  }
  return result;
}

// What does not depend on the picture under test.
class Background {
 public:
  explicit Background(const PathTruth& t) : truth(t), zero(t.blocks(), Color(0)) {
    lamp = sum([](const LightKind& k) { return k.hit && k.bounces() == 0; });
    hit = sum([](const LightKind& k) { return k.hit && k.bounces() > 0; });
    sampled = sum([](const LightKind& k) { return !k.hit; });
    all = combined(combined(lamp, 1, hit), 1, sampled);
    variance.resize(t.blocks());
    gradient_x = gradient_y = edge = zero;
    for (std::size_t b = 0; b < t.blocks(); ++b) {
      double count = 0;
      Color steps(0);
      for_each_pixel(t, b, [&](int x, int y, std::size_t at) {
        variance[b] += t.deviations[at];
        const auto pixel = [&](int i, int j) {
          return t.pixels[std::size_t(std::clamp(j, 0, t.height - 1)) * t.width +
                          std::clamp(i, 0, t.width - 1)];
        };
        const Color dx = (pixel(x + 1, y) - pixel(x - 1, y)) / 2.0;
        const Color dy = (pixel(x, y + 1) - pixel(x, y - 1)) / 2.0;
        gradient_x[b] += dx;
        gradient_y[b] += dy;
        // Noise has steps, too.
        const Color noise = t.deviations[at] / t.samples;
        steps += glm::sqrt(glm::max(dx * dx + dy * dy - 4.0 * noise, Color(0)));
        ++count;
      });
      variance[b] /= count;
      pixels.push_back(count);
      gradient_x[b] /= count;
      gradient_y[b] /= count;
      // Samples in the middle of pixels, and other filters, move edges by parts of a pixel.
      edge[b] = steps * steps / (count * count * 12);
    }
    variance = shrunk(variance, t.columns);
    truth_noise = shrunk(t.noise, t.columns);
    left_out.resize(t.blocks());
    for (int y = 0; y < t.rows; ++y) {
      for (int x = 0; x < t.columns; ++x) {
        if (lamp[std::size_t(y) * t.columns + x] != Color(0)) {
          for (int j = std::max(0, y - 1); j <= std::min(t.rows - 1, y + 1); ++j) {
            for (int i = std::max(0, x - 1); i <= std::min(t.columns - 1, x + 1); ++i) {
              left_out[std::size_t(j) * t.columns + i] = 1;
            }
          }
        }
      }
    }
  }

  template <typename Holds>
  BlockColors sum(const Holds& holds) const {
    BlockColors result = zero;
    for (const auto& [kind, light] : truth.kinds) {
      if (holds(kind)) {
        for (std::size_t b = 0; b < result.size(); ++b) {
          result[b] += light[b];
        }
      }
    }
    return result;
  }

  template <typename Factor>
  BlockColors scaled_kinds(const Factor& factor, bool of_hits) const {
    BlockColors result = zero;
    for (const auto& [kind, light] : truth.kinds) {
      if (kind.hit == of_hits) {
        const double by = factor(kind);
        for (std::size_t b = 0; b < result.size(); ++b) {
          result[b] += by * light[b];
        }
      }
    }
    return result;
  }

  // Mean luminance outside of blocks that are left out.
  double energy(const BlockColors& light) const {
    double sum_of = 0;
    for (std::size_t b = 0; b < light.size(); ++b) {
      sum_of += left_out[b] == 0 ? luminance(light[b]) : 0;
    }
    return sum_of;
  }

  const PathTruth& truth;
  BlockColors zero;
  BlockColors lamp;  // seen by the camera
  BlockColors hit;   // other hits
  BlockColors sampled;
  BlockColors all;
  BlockColors variance;  // of a sample of a pixel
  BlockColors truth_noise;
  BlockColors gradient_x;
  BlockColors gradient_y;
  BlockColors edge;  // variance by edges
  std::vector<double> pixels;
  std::vector<char> left_out;
};

// The picture as means of blocks.
struct Observed {
  Measured measured;
  BlockColors cautious;       // weights that also know how much the picture itself varies
  double per_sample = 1;      // variance of a pixel, relative to that of a sample of the truth
  double relative_noise = 0;  // median of the blocks: standard error / mean
  std::size_t clipped = 0;
  std::size_t tested = 0;
};

Observed observe(const Background& back, const LinearPicture& picture) {
  const PathTruth& truth = back.truth;
  Observed result;
  Measured& m = result.measured;
  m.mean.resize(truth.blocks());
  m.weight.resize(truth.blocks());
  result.cautious.resize(truth.blocks());
  BlockColors rounding(truth.blocks(), Color(0));
  BlockColors own(truth.blocks(), Color(0));  // variances of means as seen in the picture
  std::vector<double> ratios;
  std::vector<char> bad = back.left_out;
  for (std::size_t b = 0; b < truth.blocks(); ++b) {
    double unusable = 0;
    double count = 0;
    Color sum(0);
    Color truth_sum(0);
    for_each_pixel(truth, b, [&](int, int, std::size_t at) {
      if (picture.usable[at] == 0) {
        ++unusable;
        return;
      }
      ++count;
      sum += picture.pixels[at];
      truth_sum += truth.pixels[at];
      rounding[b] += picture.rounding[at];
    });
    result.clipped += static_cast<std::size_t>(unusable);
    if (unusable > 0.02 * back.pixels[b] || count < 2) {
      bad[b] = 1;
      continue;
    }
    m.mean[b] = sum / count;
    rounding[b] /= count * count;
    // How much pixels vary beyond the pattern of the truth.
    const double scale = luminance(truth_sum) > 0 ? luminance(sum) / luminance(truth_sum) : 1;
    double squares = 0;
    for_each_pixel(truth, b, [&](int, int, std::size_t at) {
      if (picture.usable[at] != 0) {
        const double off = luminance(picture.pixels[at]) - scale * luminance(truth.pixels[at]);
        squares += off * off;
      }
    });
    const double variance = luminance(back.variance[b]);
    const double truth_part = variance / truth.samples * scale * scale;
    const double varied = squares / (count - 1);
    // Of the truth's samples, stratified ones, less may be left.
    const double beyond = std::max(varied / 2, varied - truth_part);
    own[b] = Color(beyond / count);
    if (bad[b] == 0 && variance > 0) {
      ratios.push_back(beyond / variance);
    }
  }
  own = shrunk(own, truth.columns);
  result.per_sample = std::max(1e-7, median_of(ratios));
  std::vector<double> relative;
  for (std::size_t b = 0; b < truth.blocks(); ++b) {
    if (bad[b] != 0) {
      continue;
    }
    const Color systematic = model_error * (back.all[b] + m.mean[b]) / 2.0;
    const Color noise = result.per_sample / back.pixels[b] * back.variance[b];
    const Color others = back.truth_noise[b] + rounding[b] + back.edge[b] + systematic * systematic;
    const double more = luminance(noise) > 0 ? std::max(1.0, own[b].x / luminance(noise)) : 1;
    // In a dark color, noise may only not have been seen.
    const double floor = luminance(noise + others) * 0.05;
    for (int c = 0; c < 3; ++c) {
      const double v = std::max(noise[c] + others[c], floor);
      m.weight[b][c] = v > 0 ? 1 / v : 0;
      result.cautious[b][c] = v > 0 ? 1 / std::max(more * noise[c] + others[c], floor) : 0;
    }
    ++result.tested;
    if (luminance(m.mean[b]) > 0) {
      relative.push_back(std::sqrt(luminance(more * noise)) / luminance(m.mean[b]));
    }
  }
  result.relative_noise = median_of(std::move(relative));
  return result;
}

enum class Kind : std::uint8_t { right, mistake, convention };

// A picture that may explain the one under test: fixed + factors * free.
struct Model {
  Kind kind = Kind::mistake;
  std::string name;
  std::string what;
  BlockColors fixed;
  std::vector<BlockColors> free;
  double parameter = 1;  // found by search
  int parameters = 0;    // how many of those
  int edits = 1;
  Fit fit = {};
  double chi2 = 0;  // by the cautious weights

  double factor() const { return fit.factors.empty() ? 1 : fit.factors.front(); }
  // Two mistakes, unless one of them has both effects.
  bool two_mistakes() const { return edits > 1 && parameters == 0; }
  double score() const {
    return chi2 + 12.0 * (static_cast<double>(free.size()) + parameters + 2 * edits);
  }
};

// Finds explanations of one linearization of the picture.
class Search {
 public:
  Search(const Background& back, const Observed& seen, bool any_exposure)
      : back_(back), seen_(seen), measured_(seen.measured), any_exposure_(any_exposure) {
    nuisance_ = {&back.gradient_x, &back.gradient_y};
  }

  void solve(Model& model) const {
    std::vector<const BlockColors*> columns;
    BlockColors fixed = model.fixed;
    if (any_exposure_ && model.free.empty()) {
      model.free.push_back(fixed);
      fixed = back_.zero;
      model.fixed = back_.zero;
    }
    for (const BlockColors& f : model.free) {
      columns.push_back(&f);
    }
    columns.insert(columns.end(), nuisance_.begin(), nuisance_.end());
    model.fit = fit(measured_, fixed, columns);
    if (!model.fit.solved) {  // the scene has none of this light
      model.fit.chi2 = model.chi2 = 1e300;
      return;
    }
    model.chi2 = 0;
    for (std::size_t b = 0; b < fixed.size(); ++b) {
      const Color rest = residual(model, b);
      model.chi2 += glm::dot(seen_.cautious[b] * rest, rest);
    }
  }

  // What the model leaves of a block.
  Color residual(const Model& model, std::size_t b) const {
    Color rest = measured_.mean[b] - model.fixed[b];
    for (std::size_t i = 0; i < model.free.size() + nuisance_.size(); ++i) {
      rest -= model.fit.factors[i] *
              (i < model.free.size() ? model.free[i][b] : (*nuisance_[i - model.free.size()])[b]);
    }
    return rest;
  }

  Model right() const {
    Model model{Kind::right, "right", "", back_.all, {}, 1, 0, 0};
    solve(model);
    return model;
  }

  // `power`: how often the parameter is a factor.
  template <typename Power>
  Model by_parameter(const char* name, const Power& power, bool free_direct) const {
    const auto at = [&](double p) {
      Model model{Kind::mistake, name, "", {}, {}, p, 1, free_direct ? 2 : 1};
      const auto factor = [&](const LightKind& k) { return std::pow(p, power(k)); };
      BlockColors hits = combined(back_.scaled_kinds(factor, true), 0, back_.zero);
      BlockColors samples = back_.scaled_kinds(factor, false);
      if (free_direct) {
        model.fixed = std::move(hits);
        model.free.push_back(std::move(samples));
      } else {
        model.fixed = combined(hits, 1, samples);
      }
      solve(model);
      return model;
    };
    std::optional<Model> best;
    double low = std::log(0.02);
    double high = std::log(12.0);
    int steps = 24;
    for (int round = 0; round < 4; ++round) {
      double middle = 0;
      for (int i = 0; i <= steps; ++i) {
        const double p = low + (high - low) * i / steps;
        Model model = at(std::exp(p));
        if (!best || model.fit.chi2 < best->fit.chi2) {
          best = std::move(model);
        }
      }
      middle = std::log(best->parameter);
      const double reach = (high - low) / steps;
      low = middle - reach;
      high = middle + reach;
      steps = 8;
    }
    return *best;
  }

  std::vector<Model> models() const;

  // How much of the step from the right picture to the model the picture makes, in standard errors.
  double significance(const Model& model) const {
    BlockColors step = back_.zero;
    for (std::size_t b = 0; b < step.size(); ++b) {
      Color value = model.fixed[b];
      for (std::size_t i = 0; i < model.free.size(); ++i) {
        value += model.fit.factors[i] * model.free[i][b];
      }
      step[b] = value - back_.all[b];
    }
    std::vector<const BlockColors*> columns{&step};
    columns.insert(columns.end(), nuisance_.begin(), nuisance_.end());
    if (any_exposure_) {
      columns.push_back(&back_.all);
    }
    const Fit found = fit(measured_, back_.all, columns);
    return found.solved ? found.factors[0] / found.errors[0] : 0;
  }

  const Background& back_;
  const Observed& seen_;
  const Measured& measured_;
  bool any_exposure_;
  std::vector<const BlockColors*> nuisance_;
};

struct ChangeRow {
  Change change;
  Kind kind;
  const char* name;
  const char* what;
};

constexpr std::array<ChangeRow, change_count> change_rows{{
    {Change::surface_cosine_direct, Kind::mistake, "surface-cosine",
     "direct light is not multiplied by the cosine at the surface"},
    {Change::surface_cosine_indirect, Kind::mistake, "surface-cosine",
     "scattered light is not multiplied by the cosine at the surface"},
    {Change::surface_cosine, Kind::mistake, "surface-cosine",
     "light is not multiplied by the cosine at the surface"},
    {Change::surface_cosine_twice, Kind::mistake, "surface-cosine",
     "direct light is multiplied twice by the cosine at the surface"},
    {Change::lamp_cosine, Kind::mistake, "lamp-cosine",
     "light of lamps is not multiplied by the cosine at the lamp"},
    {Change::lamp_cosine_twice, Kind::mistake, "lamp-cosine",
     "light of lamps is multiplied twice by the cosine at the lamp"},
    {Change::falloff_distance, Kind::mistake, "distance",
     "light of lamps is divided by the distance, not by its square"},
    {Change::falloff_none, Kind::mistake, "distance",
     "light of lamps is not divided by the square of the distance"},
    {Change::falloff_cube, Kind::mistake, "distance",
     "light of lamps is divided by the third power of the distance"},
    {Change::no_visibility, Kind::mistake, "visibility",
     "light samples are not tested for shadows"},
    {Change::diffuse_missing_direct, Kind::mistake, "diffuse-color",
     "direct light is not multiplied by Kd"},
    {Change::diffuse_missing_indirect, Kind::mistake, "diffuse-color",
     "scattered light is not multiplied by Kd"},
    {Change::diffuse_missing, Kind::mistake, "diffuse-color", "light is not multiplied by Kd"},
    {Change::diffuse_twice_direct, Kind::mistake, "diffuse-color",
     "direct light is multiplied twice by Kd"},
    {Change::diffuse_twice_indirect, Kind::mistake, "diffuse-color",
     "scattered light is multiplied twice by Kd"},
    {Change::diffuse_twice, Kind::mistake, "diffuse-color", "light is multiplied twice by Kd"},
    {Change::glossy_scale, Kind::mistake, "glossy",
     "the glossy lobe is not multiplied by (Ns + 2) / 2 pi"},
    {Change::glossy_missing, Kind::mistake, "glossy", "the glossy lobe is missing"},
    {Change::glossy_blinn, Kind::mistake, "glossy",
     "the glossy lobe uses the half vector (Blinn) instead of the mirror direction (Phong)"},
    {Change::lobe_alone, Kind::convention, "lobe-alone",
     "materials whose Ks is larger than Kd have the glossy lobe alone"},
    {Change::uniform_density, Kind::mistake, "direction-density",
     "directions are distributed by the cosine, but divided by the density 1 / 2 pi"},
    {Change::cosine_density, Kind::mistake, "direction-density",
     "directions are uniform, but divided by the density cos / pi"},
    {Change::polar_density, Kind::mistake, "direction-density",
     "directions have uniform angles, which are not uniform directions: too many near the normal"},
    {Change::corner_points, Kind::mistake, "lamp-points",
     "points on the triangles of lamps are not uniform"},
    {Change::edge_points, Kind::mistake, "lamp-points",
     "points on the triangles of lamps are not uniform"},
    {Change::normalized_points, Kind::mistake, "lamp-points",
     "points on the triangles of lamps are not uniform: three random numbers divided by their sum"},
    {Change::lamp_area, Kind::mistake, "lamp-area",
     "light samples are not multiplied by the area of the triangle"},
    {Change::first_lamp, Kind::mistake, "lamp-choice", "only one triangle of the lamps is sampled"},
    {Change::last_lamp, Kind::mistake, "lamp-choice", "only one triangle of the lamps is sampled"},
    {Change::fresnel_twice, Kind::mistake, "fresnel",
     "glass chooses by Fresnel's reflectance and multiplies by it as well"},
    {Change::no_fresnel, Kind::mistake, "fresnel", "glass only refracts, it reflects nothing"},
    {Change::half_fresnel, Kind::mistake, "fresnel",
     "glass reflects and refracts with the same weight, whatever the angle"},
    {Change::no_total_reflection, Kind::mistake, "total-reflection",
     "the light of total internal reflection is missing"},
    {Change::schlick, Kind::convention, "schlick",
     "Schlick's approximation of Fresnel's equations"},
    {Change::mirror_cosine, Kind::mistake, "mirror-cosine", "mirrors multiply by the cosine"},
    {Change::mirror_without_color, Kind::convention, "mirror-without-ks",
     "mirrors do not multiply by Ks"},
}};

std::vector<Model> Search::models() const {
  std::vector<Model> list;
  const auto add = [&](Model model) {
    solve(model);
    list.push_back(std::move(model));
  };
  const auto without = [&](const char* name, std::string what, const auto& lost) {
    add({Kind::mistake, name, std::move(what), combined(back_.all, -1, back_.sum(lost)), {}});
  };
  const BlockColors lamp_and_hit = combined(back_.lamp, 1, back_.hit);
  add({Kind::mistake, "direct", "", lamp_and_hit, {back_.sampled}});
  add({Kind::mistake, "whole", "", back_.zero, {back_.all}});
  const auto rough = [](const LightKind& k) { return int(k.rough); };
  const auto bounces = [](const LightKind& k) { return k.bounces(); };
  list.push_back(by_parameter("scattered", rough, false));
  list.push_back(by_parameter("direct-and-scattered", rough, true));
  list.push_back(by_parameter("bounce", bounces, false));
  list.push_back(by_parameter("direct-and-bounce", bounces, true));
  const auto part = [&](const char* name, const auto& holds) {
    const BlockColors some = back_.sum(holds);
    add({Kind::mistake, name, "", combined(back_.all, -1, some), {some}});
  };
  part("first-direct", [](const LightKind& k) { return !k.hit && k.rough == 0; });
  part("indirect", [](const LightKind& k) { return k.rough > 0; });
  part("mirror", [](const LightKind& k) { return k.mirror > 0; });
  part("glass", [](const LightKind& k) { return k.glass > 0; });
  part("caustics", [](const LightKind& k) { return k.hit && k.rough > 0; });
  for (int n = 0; n <= 6; ++n) {
    without(n == 0 ? "no-reflected-light" : "depth",
            n == 0   ? "no light is reflected, only lamps are visible: paths end at the first "
                       "surface, or all shadow rays hit the lamp or their own surface"
            : n == 1 ? "only light of one bounce is there: indirect light is missing"
                     : fmt::format("paths end after {} bounces", n),
            [n](const LightKind& k) { return k.bounces() + (k.hit ? 0 : 1) > n; });
  }
  for (int n = 1; n <= 5; ++n) {
    without("depth",
            n == 1 ? std::string("indirect light is missing: no scattered directions")
                   : fmt::format("paths end after {} diffuse or glossy bounces", n),
            [n](const LightKind& k) { return k.rough + (k.hit ? 0 : 1) > n; });
  }
  without("emission-after-specular", "lamps that are hit after a mirror or glass do not count",
          [](const LightKind& k) { return k.hit && k.bounces() > 0; });
  without("emission-after-specular", "lamps that are hit after a mirror do not count",
          [](const LightKind& k) { return k.hit && k.mirror > 0; });
  without("emission-after-specular", "lamps that are hit after glass do not count",
          [](const LightKind& k) { return k.hit && k.glass > 0; });
  without("caustics",
          "caustics are missing: lamps that are hit by glass or a mirror after a "
          "diffuse or glossy surface do not count",
          [](const LightKind& k) { return k.hit && k.rough > 0; });
  without("mirror", "mirrors reflect nothing", [](const LightKind& k) { return k.mirror > 0; });
  without("glass", "light after glass is missing", [](const LightKind& k) { return k.glass > 0; });
  for (const ChangeRow& row : change_rows) {
    const ChangedPicture& changed = back_.truth.changes[static_cast<std::size_t>(row.change)];
    const BlockColors hits = combined(back_.lamp, 1, changed.hit);
    add({row.kind, row.name, row.what, combined(hits, 1, changed.sampled), {}});
    if (row.change == Change::first_lamp || row.change == Change::last_lamp) {
      const auto count = static_cast<double>(back_.truth.lamp_areas.size());
      add({row.kind, row.name, row.what, combined(hits, count, changed.sampled), {}});
    } else {
      add({Kind::mistake, row.name, row.what, hits, {changed.sampled}, 1, 0, 2});
    }
  }
  for (const VariantPicture& variant : back_.truth.variants) {
    switch (variant.variant) {
      case Variant::two_sided_lamps:
        add({Kind::convention, "two-sided", "lamps shine to both sides", variant.picture, {}});
        break;
      case Variant::inverted_index:
        add({Kind::mistake,
             "refraction",
             "the ratio of the indices of refraction is inverted",
             variant.picture,
             {}});
        break;
      case Variant::flat_normals:
        add({Kind::mistake,
             "flat-normals",
             "normals are those of the triangles, not interpolated",
             variant.picture,
             {}});
        break;
    }
  }
  return list;
}

// Whether a fitted number is a constant within its error.
bool is(double value, double error, double constant) {
  return std::abs(value / constant - 1) < std::max(0.012, 3 * error / constant);
}

struct Number {
  double value = 1;
  std::string name;
  std::string what;
};

// What the factor of all reflected light can mean.
std::vector<Number> meanings_of_direct(const PathTruth& truth, double factor, double error) {
  std::vector<Number> known;
  const double n = static_cast<double>(truth.lamp_areas.size());
  double area = 0;
  for (const double a : truth.lamp_areas) {
    area += a;
  }
  const bool equal =
      n > 0 && *std::min_element(truth.lamp_areas.begin(), truth.lamp_areas.end()) >
                   0.99 * *std::max_element(truth.lamp_areas.begin(), truth.lamp_areas.end());
  known.push_back(
      {2, "direct-twice",
       "direct light counts twice: by light samples and by hits of lamps, or for both sides"});
  known.push_back({pi, "pi", "Kd is not divided by pi in direct light"});
  known.push_back({1 / pi, "pi", "Kd is divided twice by pi in direct light"});
  if (n > 1) {
    known.push_back(
        {1 / n, "lamp-sampling",
         fmt::format("a lamp triangle is chosen without dividing by the probability 1/{:.0f}", n)});
    known.push_back(
        {n, "lamp-sampling",
         fmt::format(
             "light samples are multiplied once too often by the number of lamp triangles, {:.0f}",
             n)});
  }
  if (equal && n > 0) {
    known.push_back(
        {n / area, "lamp-area",
         fmt::format("light samples are not multiplied by the area of the triangle, {:.4g}",
                     area / n)});
    known.push_back(
        {n * n / area / area, "lamp-area",
         fmt::format("light samples are divided by the area of the triangle, {:.4g}", area / n)});
  }
  if (area > 0) {
    known.push_back(
        {1 / area, "lamp-area",
         fmt::format("light samples are not multiplied by the area of all lamps, {:.4g}", area)});
  }
  known.push_back({0.5, "self-shadow", "half of the shadow rays hit the surface they start on"});
  std::vector<Number> found;
  for (Number& k : known) {
    if (is(factor, error, k.value)) {
      found.push_back(std::move(k));
    }
  }
  if (found.empty() || is(factor, error, 2)) {
    for (int count = 2; count <= 16; ++count) {
      if (is(factor, error, count)) {
        found.push_back({double(count), "lamp-sampling",
                         fmt::format("{} light samples are added, not averaged", count)});
      } else if (is(factor, error, 1.0 / count) && found.empty()) {
        found.push_back({1.0 / count, "lamp-sampling",
                         fmt::format("light samples are divided by {} once too often", count)});
      }
    }
  }
  return found;
}

std::string factor_text(double factor, double error) {
  return fmt::format("factor {:.3f} +- {:.3f}", factor, error);
}

// The names and phrases for a model that explains the picture: several if they give the same
// picture. `whole`: the factor of visible lamps, if known.
std::vector<Number> meanings(const PathTruth& truth, const Model& m, std::optional<double> whole,
                             bool& general) {
  general = false;
  const double f = m.factor();
  const double error = m.fit.errors.empty() ? 0 : m.fit.errors.front();
  const double p = m.parameter;
  const double p_error = 0.01 * p;
  if (m.name == "direct" || m.name == "whole") {
    if (whole && is(*whole, 0.01, f)) {
      return {{f, "brightness", fmt::format("everything, lamps too, has the factor {:.3f}", f)}};
    }
    std::vector<Number> found = meanings_of_direct(truth, f, error);
    general = found.empty();
    if (general) {
      found.push_back(
          {f, "direct-factor",
           fmt::format(
               "all light that surfaces reflect has the factor {:.3f}: from direct light on", f)});
    } else if (!whole) {
      found.push_back({f, "brightness", "the brightness of the picture or the lamps"});
    }
    return found;
  }
  if (m.name == "direct-and-scattered" || m.name == "direct-and-bounce") {
    if (m.name == "direct-and-scattered" && is(f, error, p)) {
      if (is(p, p_error, pi)) {
        return {{p, "pi", "Kd is not divided by pi"}};
      }
      if (is(p, p_error, 1 / pi)) {
        return {{p, "pi", "Kd is divided twice by pi"}};
      }
    }
    general = true;  // two free numbers fit much
    return {};
  }
  if (m.name == "scattered" || m.name == "bounce") {
    std::vector<Number> found;
    const bool specular = truth.mirror || truth.glass;
    if (m.name == "scattered" || !specular) {
      if (is(p, p_error, pi)) {
        found.push_back({p, "pi", "Kd is not divided by pi in scattered light"});
      }
      if (is(p, p_error, 1 / pi)) {
        found.push_back({p, "pi", "Kd is divided twice by pi in scattered light"});
      }
      if (is(p, p_error, 1 / (2 * pi))) {
        found.push_back(
            {p, "direction-density",
             "scattered light is not divided by the density of the direction, 1 / 2 pi"});
      }
      if (is(p, p_error, 0.5)) {
        found.push_back(
            {p, "scattered-factor",
             "scattered light has the factor 1/2, as if half of the directions were lost"});
      }
      if (is(p, p_error, 2)) {
        found.push_back({p, "scattered-factor", "scattered light counts twice at each bounce"});
      }
    }
    if (found.empty() && m.name == "scattered" && specular) {
      general = true;
      return {{p, "scattered-factor",
               fmt::format(
                   "light has the factor {:.3f} for each diffuse or glossy bounce after the first",
                   p)}};
    }
    if (p < 0.05) {
      general = true;  // another name says that this light is missing
    }
    if (found.empty() || m.name == "bounce") {
      found.push_back({p, "roulette",
                       p < 1 ? fmt::format("paths are not divided by the probability {:.2f} of "
                                           "going on: each bounce has this factor",
                                           p)
                             : fmt::format("each bounce after the first has the factor {:.3f}, as "
                                           "if divided by a wrong probability of going on",
                                           p)});
    }
    return found;
  }
  if (m.name == "first-direct" || m.name == "indirect" || m.name == "mirror" || m.name == "glass" ||
      m.name == "caustics") {
    if (!m.free.empty()) {
      general = true;
      const char* const place = m.name == "first-direct"
                                    ? "direct light, also in mirrors and glass,"
                                : m.name == "indirect" ? "indirect light"
                                : m.name == "mirror"   ? "light after a mirror"
                                : m.name == "glass"    ? "light after glass"
                                                       : "light of caustics";
      return {{f, m.name + "-factor", fmt::format("{} has the factor {:.3f}", place, f)}};
    }
  }
  std::string what = m.what;
  if (!m.free.empty() && m.edits == 2) {
    what += fmt::format(", and light samples have the factor {:.3f}", f);
  }
  return {{f, m.name, what}};
}

// The factor of lamps that the camera sees: of blocks that show nothing else.
std::optional<double> lamp_factor(const Background& back, const LinearPicture& picture) {
  const PathTruth& t = back.truth;
  std::vector<double> ratios;
  for (int y = 1; y + 1 < t.height; ++y) {
    for (int x = 1; x + 1 < t.width; ++x) {
      const std::size_t at = std::size_t(y) * t.width + x;
      const std::size_t block = std::size_t(y / block_side) * t.columns + x / block_side;
      const double bright = luminance(t.pixels[at]);
      if (luminance(back.lamp[block]) == 0 || picture.usable[at] == 0 || bright <= 0 ||
          luminance(t.deviations[at]) > 1e-4 * bright * bright) {
        continue;
      }
      ratios.push_back(luminance(picture.pixels[at]) / bright);
    }
  }
  return ratios.size() < 4 ? std::nullopt : std::optional<double>(median_of(ratios));
}

struct PlaceRow {
  const char* name;
  bool (*holds)(const LightKind&);
};

constexpr std::array<PlaceRow, 6> place_rows{{
    {"direct light", [](const LightKind& k) { return !k.hit && k.bounces() == 0; }},
    {"light of the second bounce",
     [](const LightKind& k) { return !k.hit && k.rough == 1 && k.mirror + k.glass == 0; }},
    {"light of further bounces",
     [](const LightKind& k) { return !k.hit && k.rough > 1 && k.mirror + k.glass == 0; }},
    {"light after a mirror",
     [](const LightKind& k) { return k.mirror > 0 && k.glass == 0 && !(k.hit && k.rough > 0); }},
    {"light after glass",
     [](const LightKind& k) { return k.glass > 0 && !(k.hit && k.rough > 0); }},
    {"caustics", [](const LightKind& k) { return k.hit && k.rough > 0; }},
}};

std::vector<PathPlace> places_of(const Background& back, const Measured& measured, double& chi2) {
  std::vector<PathPlace> places;
  std::vector<BlockColors> lights;
  BlockColors fixed = back.lamp;
  const double total = back.energy(back.all) - back.energy(back.lamp);
  for (const PlaceRow& row : place_rows) {
    BlockColors light = back.sum(row.holds);
    const double share = total > 0 ? back.energy(light) / total : 0;
    if (share < 0.005) {
      fixed = combined(fixed, 1, light);
      continue;
    }
    places.push_back({row.name, share, 1, 0});
    lights.push_back(std::move(light));
  }
  std::vector<const BlockColors*> columns;
  for (const BlockColors& light : lights) {
    columns.push_back(&light);
  }
  columns.push_back(&back.gradient_x);
  columns.push_back(&back.gradient_y);
  const Fit found = fit(measured, fixed, columns);
  chi2 = found.chi2;
  for (std::size_t i = 0; i < places.size() && found.solved; ++i) {
    places[i].factor = found.factors[i];
    places[i].error = found.errors[i];
  }
  if (!found.solved) {
    places.clear();
  }
  return places;
}

void add_energy(const Background& back, const Measured& measured, PathVerdict& verdict) {
  constexpr int most = 4;
  std::vector<BlockColors> lights;
  std::vector<const BlockColors*> columns;
  for (int n = 1; n <= most; ++n) {
    lights.push_back(back.sum([n](const LightKind& k) {
      const int bounces = k.bounces() + (k.hit ? 0 : 1);
      return n == most ? bounces >= n : bounces == n;
    }));
    verdict.energy_truth.push_back(back.energy(lights.back()) /
                                   static_cast<double>(back.truth.blocks()));
  }
  for (const BlockColors& light : lights) {
    columns.push_back(&light);
  }
  const Fit found = fit(measured, back.lamp, columns);
  for (std::size_t i = 0; i < lights.size() && found.solved; ++i) {
    verdict.energy_mine.push_back(found.factors[i] * verdict.energy_truth[i]);
  }
}

void count_fireflies(const Background& back, const LinearPicture& picture, PathVerdict& verdict) {
  const PathTruth& t = back.truth;
  double energy = 0;
  double bright = 0;
  for (int y = 0; y < t.height; ++y) {
    for (int x = 0; x < t.width; ++x) {
      if (back.left_out[std::size_t(y / block_side) * t.columns + x / block_side] != 0) {
        continue;
      }
      const double value = luminance(picture.pixels[std::size_t(y) * t.width + x]);
      energy += value;
      std::vector<double> around;
      for (int j = std::max(0, y - 2); j <= std::min(t.height - 1, y + 2); ++j) {
        for (int i = std::max(0, x - 2); i <= std::min(t.width - 1, x + 2); ++i) {
          around.push_back(luminance(picture.pixels[std::size_t(j) * t.width + i]));
        }
      }
      const double middle = median_of(around);
      if (value < 3 * middle) {
        continue;
      }
      for (double& v : around) {
        v = std::abs(v - middle);
      }
      if (value > middle + 8 * 1.4826 * median_of(around)) {
        ++verdict.fireflies;
        bright += value - middle;
      }
    }
  }
  verdict.firefly_energy = energy > 0 ? bright / energy : 0;
}

// One way to linearize the picture, and what the search found then.
struct Reading {
  Curve curve = Curve::linear;
  bool any_exposure = false;
  LinearPicture picture;
  Observed seen;
  Model right;
  std::vector<Model> models;  // the best first

  double values() const { return 3.0 * static_cast<double>(std::max<std::size_t>(1, seen.tested)); }
  double left() const {
    return std::min(right.chi2, models.empty() ? 1e300 : models.front().chi2) / values();
  }
};

Reading read_as(const Background& back, const DecodedPicture& mine, Curve curve, double white,
                bool any_exposure) {
  Reading reading;
  reading.curve = curve;
  reading.any_exposure = any_exposure;
  reading.picture = linearized(mine, curve, white);
  reading.seen = observe(back, reading.picture);
  const Search search(back, reading.seen, any_exposure);
  reading.right = search.right();
  reading.models = search.models();
  std::sort(reading.models.begin(), reading.models.end(),
            [](const Model& a, const Model& b) { return a.score() < b.score(); });
  return reading;
}

// The white of the curve `course` for which visible lamps have their emission.
std::optional<double> white_by_lamps(const Background& back, const DecodedPicture& mine) {
  const PathTruth& t = back.truth;
  std::vector<double> whites;
  for (std::size_t at = 0; at < t.pixels.size(); ++at) {
    const std::size_t block = at / t.width / block_side * t.columns + at % t.width / block_side;
    const double bright = luminance(t.pixels[at]);
    if (luminance(back.lamp[block]) == 0 || bright <= 0 ||
        luminance(t.deviations[at]) > 1e-4 * bright * bright) {
      continue;
    }
    const std::uint8_t* rgb = &mine.texture.rgb[3 * at];
    const Color shown = glm::dvec3(rgb[0], rgb[1], rgb[2]) / 255.0;
    const double value = luminance(shown * shown);
    // value = L (1 + L / w^2) / (1 + L)
    const double square = bright * bright / std::max(1e-9, value * (1 + bright) - bright);
    whites.push_back(value >= 0.99 ? bright : std::sqrt(std::clamp(square, bright * bright, 1e12)));
  }
  return whites.size() < 4 ? std::nullopt : std::optional<double>(median_of(whites));
}

// The white for which the picture is most like the truth, or the truth with a factor.
double fitted_white(const Background& back, const DecodedPicture& mine, bool any_exposure) {
  double best = 1;
  double least = 1e300;
  for (double white = 1; white < 2000; white *= 1.3) {
    const Observed seen = observe(back, linearized(mine, Curve::course, white));
    const Search search(back, seen, any_exposure);
    Model scaled{Kind::mistake, "direct", "", combined(back.lamp, 1, back.hit), {back.sampled}};
    search.solve(scaled);
    const double chi2 =
        std::min(search.right().chi2, scaled.chi2) / static_cast<double>(seen.tested + 1);
    if (chi2 < least) {
      least = chi2;
      best = white;
    }
  }
  return best;
}

// The likeliest first. `as_shown`: floats, too, may be values for the screen.
std::vector<Reading> readings_of(const Background& back, const DecodedPicture& mine,
                                 bool as_shown) {
  std::vector<Reading> list;
  if (mine.is_linear() && !as_shown) {
    list.push_back(read_as(back, mine, Curve::linear, 1, false));
    return list;
  }
  const double white = white_by_lamps(back, mine).value_or(0);
  const auto add = [&](Curve curve, double white, bool any_exposure) {
    Reading reading = read_as(back, mine, curve, white, any_exposure);
    if (3 * reading.seen.tested > back.truth.blocks()) {
      list.push_back(std::move(reading));
    }
  };
  for (const bool any_exposure : {false, true}) {
    add(Curve::course, white > 0 ? white : fitted_white(back, mine, any_exposure), any_exposure);
  }
  for (const Curve curve :
       {Curve::reinhard, Curve::power22, Curve::srgb, Curve::power2, Curve::clamp}) {
    add(curve, 1, false);
    add(curve, 1, true);
  }
  // A fitted exposure must explain clearly more.
  std::stable_sort(list.begin(), list.end(), [](const Reading& a, const Reading& b) {
    return a.left() * (a.any_exposure ? 1.3 : 1) < b.left() * (b.any_exposure ? 1.3 : 1);
  });
  return list;
}

// The mean change of the light where the model changes it by more than 2 %.
double effect_of(const Background& back, const Model& model) {
  double changed = 0;
  double light = 0;
  for (std::size_t b = 0; b < back.zero.size(); ++b) {
    Color value = model.fixed[b];
    for (std::size_t i = 0; i < model.free.size(); ++i) {
      value += model.fit.factors[i] * model.free[i][b];
    }
    const double truth = luminance(back.all[b]);
    const double off = std::abs(luminance(value) - truth);
    if (back.left_out[b] == 0 && off > 0.02 * truth) {
      changed += off;
      light += truth;
    }
  }
  return light > 0 ? changed / light : 0;
}

void explain(const Background& back, const Reading& reading, PathVerdict& verdict) {
  const Search search(back, reading.seen, reading.any_exposure);
  const double n = reading.values();
  const double before = reading.right.chi2;
  if (reading.seen.relative_noise > too_much_noise || reading.models.empty() ||
      before - reading.models.front().chi2 < claim_errors * claim_errors) {
    return;
  }
  const Model& best = reading.models.front();
  const std::optional<double> whole =
      reading.any_exposure ? std::nullopt : lamp_factor(back, reading.picture);
  const auto explained = [&](const Model& m) {
    return before > n ? std::clamp((before - std::max(m.chi2, n)) / (before - n), 0.0, 1.0) : 0;
  };
  const double z = std::abs(search.significance(best));
  const double effect = effect_of(back, best);
  verdict.chi2_per_value = best.chi2 / n;
  if (z < claim_errors || effect < least_effect) {
    return;
  }
  const double tie = std::max(25.0, 0.004 * (before - best.chi2));
  const bool complete = explained(best) >= 0.9 && (best.chi2 < 3 * n || explained(best) >= 0.985);
  bool general = false;
  for (const Model& m : reading.models) {
    const bool first = &m == &best;
    if (!complete || m.chi2 > best.chi2 + tie ||
        (!first && (general || best.edits > 1 || m.edits > 1))) {
      continue;
    }
    bool this_general = false;
    const std::vector<Number> names = meanings(back.truth, m, whole, this_general);
    general = general || (first && this_general);
    if (!first && this_general) {
      continue;  // explains the same with a free number
    }
    std::vector<PathClaim>& list = best.kind == Kind::convention    ? verdict.conventions
                                   : general || best.two_mistakes() ? verdict.partial
                                                                    : verdict.causes;
    for (const Number& name : names) {
      const auto same = [&](const PathClaim& c) {
        return c.what == name.what || c.name == name.name;
      };
      if (std::none_of(list.begin(), list.end(), same)) {
        list.push_back({name.name, name.what,
                        fmt::format("explains {:.0f} % of the difference beyond noise; {:.0f} "
                                    "standard errors",
                                    100 * explained(m), z),
                        explained(m)});
      }
    }
  }
  constexpr std::size_t most_named = 3;
  if (verdict.causes.size() > most_named || verdict.partial.size() > most_named) {
    verdict.causes.clear();
    verdict.partial.clear();
  }
}

// Kinds of light that have another factor, if that explains at least half of the difference.
void name_places(const Reading& reading, double chi2, PathVerdict& verdict) {
  const double n = reading.values();
  const double before = reading.right.fit.chi2;
  if (before - chi2 < 0.5 * (before - std::min(n, before))) {
    return;
  }
  const PathPlace* worst = nullptr;
  double most = claim_errors;
  for (const PathPlace& place : verdict.places) {
    const double z = std::abs(place.factor - 1) / std::max(place.error, 1e-9);
    if (z > most && std::abs(place.factor - 1) > 0.1) {
      most = z;
      worst = &place;
    }
  }
  if (worst != nullptr) {
    const bool missing = worst->factor < 0.05;
    verdict.partial.push_back({"light",
                               missing ? fmt::format("{} is missing", worst->name)
                                       : fmt::format("{} has the {}", worst->name,
                                                     factor_text(worst->factor, worst->error)),
                               fmt::format("{:.0f} standard errors", most), 0});
  }
}

// The picture with other rows, columns or channels.
DecodedPicture rearranged(const DecodedPicture& mine, const PathTruth& t, int how) {
  DecodedPicture other = mine;
  for (int y = 0; y < t.height; ++y) {
    for (int x = 0; x < t.width; ++x) {
      const int i = how == 1 ? t.width - 1 - x : x;
      const int j = how == 0 ? t.height - 1 - y : y;
      for (int c = 0; c < 3; ++c) {
        const std::size_t from = 3 * (std::size_t(j) * t.width + i) + (how == 2 ? 2 - c : c);
        const std::size_t to = 3 * (std::size_t(y) * t.width + x) + c;
        other.texture.rgb[to] = mine.texture.rgb[from];
        if (mine.is_linear()) {
          other.linear.rgb[to] = mine.linear.rgb[from];
        }
      }
    }
  }
  return other;
}

// Whether another reading of the file explains nearly all of the difference.
bool explains(const Background& back, const Reading& before, const Reading& other) {
  return 2 * other.seen.tested > before.seen.tested && other.right.chi2 < 3 * other.values() &&
         other.right.chi2 / other.values() < 0.05 * before.right.chi2 / before.values() &&
         back.truth.blocks() > 16;
}

// Mistakes in what is done with the picture, not in the light.
void explain_file(const Background& back, const DecodedPicture& mine, const Reading& reading,
                  PathVerdict& verdict) {
  constexpr std::array<std::pair<const char*, const char*>, 3> ways{
      {{"vertical-flip", "the picture is upside down"},
       {"horizontal-flip", "the picture is mirrored"},
       {"swapped-channels", "red and blue are swapped"}}};
  for (int how = 0; how < 3; ++how) {
    if (explains(back, reading,
                 read_as(back, rearranged(mine, back.truth, how), reading.curve, 1,
                         reading.any_exposure))) {
      verdict.causes.push_back({ways[how].first, ways[how].second, "explains the difference", 1});
      return;
    }
  }
  if (mine.is_linear()) {
    for (const Reading& other : readings_of(back, mine, true)) {
      if (!other.any_exposure && explains(back, reading, other)) {
        verdict.causes.push_back(
            {"gamma",
             fmt::format("the file should be linear, but has values for the screen, by {}",
                         curve_words[static_cast<std::size_t>(other.curve)]),
             "explains the difference", 1});
        return;
      }
    }
  }
}

// Where noise hides all means: whether most pixels are too bright. Of skewed noise, as that of
// paths, the median is below the mean.
void name_growth(const Background& back, const LinearPicture& picture, PathVerdict& verdict) {
  std::vector<double> ratios;
  for (std::size_t b = 0; b < back.truth.blocks(); ++b) {
    std::vector<double> values;
    for_each_pixel(back.truth, b, [&](int, int, std::size_t at) {
      values.push_back(luminance(picture.pixels[at]));
    });
    if (back.left_out[b] == 0 && luminance(back.all[b]) > 0) {
      ratios.push_back(median_of(std::move(values)) / luminance(back.all[b]));
    }
  }
  const double factor = median_of(ratios);
  if (factor > 1.3) {
    verdict.partial.push_back(
        {"light",
         fmt::format("most pixels are brighter than the truth, by a factor of at least {:.2f}, and "
                     "the noise is far too large: light grows from bounce to bounce, as without "
                     "1 / pi or the density of directions",
                     factor),
         "median of pixels", 0});
    verdict.too_noisy = false;
  }
}

}  // namespace

PathVerdict judge_path(const PathTruth& truth, const DecodedPicture& mine) {
  PathVerdict verdict;
  const Background back(truth);
  std::vector<Reading> readings = readings_of(back, mine, false);
  verdict.columns = truth.columns;
  verdict.truth_samples = truth.samples;
  verdict.not_finite = mine.not_finite;
  verdict.significance.resize(truth.blocks());
  if (readings.empty()) {
    verdict.too_noisy = true;
    verdict.notes.push_back({"clipped", "most of the picture is clipped", "", 0});
    return verdict;
  }
  const Reading& reading = readings.front();
  verdict.curve = curve_words[static_cast<std::size_t>(reading.curve)];
  verdict.exposure = reading.any_exposure ? reading.right.factor() : 1;
  verdict.samples = 1 / reading.seen.per_sample;
  verdict.tested = reading.seen.tested;
  verdict.clipped = reading.seen.clipped;
  verdict.critical = critical_value(0.01, reading.values() / 3);
  verdict.chi2_per_value = reading.right.chi2 / reading.values();
  const Search search(back, reading.seen, reading.any_exposure);
  for (std::size_t b = 0; b < truth.blocks(); ++b) {
    const Color weight = reading.seen.cautious[b];
    if (weight == Color(0)) {
      continue;
    }
    const Color rest = search.residual(reading.right, b);
    const double variance = luminance(Color(1) / glm::max(weight, Color(1e-300)));
    verdict.significance[b] = luminance(rest) / std::sqrt(variance);
    verdict.largest = std::max(verdict.largest, std::abs(verdict.significance[b]));
  }
  double chi2 = 0;
  verdict.places = places_of(back, reading.seen.measured, chi2);
  add_energy(back, reading.seen.measured, verdict);
  count_fireflies(back, reading.picture, verdict);
  explain(back, reading, verdict);
  if (verdict.causes.empty() && verdict.partial.empty() && verdict.conventions.empty() &&
      verdict.largest > verdict.critical) {
    explain_file(back, mine, reading, verdict);
    if (verdict.causes.empty()) {
      name_places(reading, chi2, verdict);
    }
  }
  const bool explained_by_convention = !verdict.conventions.empty();
  const auto shift = [&](std::size_t axis) {
    const std::size_t at = reading.right.free.size() + axis;
    const double value = reading.right.fit.factors[at];
    return std::abs(value) > 0.25 && std::abs(value) > claim_errors * reading.right.fit.errors[at]
               ? value
               : 0;
  };
  if (verdict.causes.empty() && verdict.partial.empty() && (shift(0) != 0 || shift(1) != 0)) {
    verdict.conventions.push_back(
        {"pixel-corners",
         "the picture is shifted by a part of a pixel, as if rays went through the corners of "
         "pixels",
         fmt::format("{:.2f} to the right, {:.2f} down", -shift(0), -shift(1)), 0});
  }
  if (verdict.causes.empty() && verdict.partial.empty()) {
    const double shown =
        (explained_by_convention ? reading.models.front() : reading.right).chi2 / reading.values();
    double error = 0;
    for (const PathPlace& place : verdict.places) {
      error = std::max(error, place.share > 0.15 ? place.error : 0);
    }
    constexpr double hidden = 0.3;  // a factor that noise may hide
    if (claim_errors * error > hidden || reading.seen.relative_noise > too_much_noise) {
      verdict.too_noisy = true;
      verdict.more_samples = std::pow(claim_errors * error / hidden, 2);
      name_growth(back, reading.picture, verdict);
    } else {
      verdict.right =
          shown < 2 && (explained_by_convention || verdict.largest < 2 * verdict.critical);
    }
  }
  return verdict;
}

}  // namespace scenefile
