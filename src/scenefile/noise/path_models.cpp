#include "scenefile/noise/path_models.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

struct ChangeRow {
  Change change;
  ModelKind kind;
  Cause page;
  const char* name;
  const char* what;
};

struct VariantRow {
  Variant variant;
  ModelKind kind;
  Cause page;
  const char* name;
  const char* what;
};

constexpr std::array<ChangeRow, change_count> change_rows{{
    {Change::surface_cosine_direct, ModelKind::mistake, Cause::scattering, "surface-cosine",
     "direct light is not multiplied by the cosine at the surface"},
    {Change::surface_cosine_indirect, ModelKind::mistake, Cause::scattering, "surface-cosine",
     "scattered light is not multiplied by the cosine at the surface"},
    {Change::surface_cosine_indirect_twice, ModelKind::mistake, Cause::scattering, "surface-cosine",
     "scattered light is multiplied twice by the cosine at the surface"},
    {Change::surface_cosine, ModelKind::mistake, Cause::scattering, "surface-cosine",
     "light is not multiplied by the cosine at the surface"},
    {Change::surface_cosine_twice, ModelKind::mistake, Cause::scattering, "surface-cosine",
     "direct light is multiplied twice by the cosine at the surface"},
    {Change::eye_cosine, ModelKind::mistake, Cause::scattering, "surface-cosine",
     "direct light is multiplied by the cosine of the direction to the eye, not to the lamp"},
    {Change::lamp_cosine, ModelKind::mistake, Cause::light_samples, "lamp-cosine",
     "light of lamps is not multiplied by the cosine at the lamp"},
    {Change::lamp_cosine_twice, ModelKind::mistake, Cause::light_samples, "lamp-cosine",
     "light of lamps is multiplied twice by the cosine at the lamp"},
    {Change::lamp_cosine_of_surface, ModelKind::mistake, Cause::light_samples, "lamp-cosine",
     "the cosine at the lamp is computed with the normal of the surface"},
    {Change::falloff_distance, ModelKind::mistake, Cause::light_samples, "distance",
     "light of lamps is divided by the distance, not by its square"},
    {Change::falloff_none, ModelKind::mistake, Cause::light_samples, "distance",
     "light of lamps is not divided by the square of the distance"},
    {Change::falloff_cube, ModelKind::mistake, Cause::light_samples, "distance",
     "light of lamps is divided by the third power of the distance"},
    {Change::no_visibility, ModelKind::mistake, Cause::light_samples, "visibility",
     "light samples are not tested for shadows"},
    {Change::glass_visibility, ModelKind::mistake, Cause::light_samples, "visibility",
     "shadow rays go through glass, which adds light to its caustics"},
    {Change::diffuse_missing_direct, ModelKind::mistake, Cause::scattering, "diffuse-color",
     "direct light is not multiplied by Kd"},
    {Change::diffuse_missing_indirect, ModelKind::mistake, Cause::scattering, "diffuse-color",
     "scattered light is not multiplied by Kd"},
    {Change::diffuse_missing, ModelKind::mistake, Cause::scattering, "diffuse-color",
     "light is not multiplied by Kd"},
    {Change::diffuse_twice_direct, ModelKind::mistake, Cause::scattering, "diffuse-color",
     "direct light is multiplied twice by Kd"},
    {Change::diffuse_twice_indirect, ModelKind::mistake, Cause::scattering, "diffuse-color",
     "scattered light is multiplied twice by Kd"},
    {Change::diffuse_twice, ModelKind::mistake, Cause::scattering, "diffuse-color",
     "light is multiplied twice by Kd"},
    {Change::diffuse_without_pi, ModelKind::mistake, Cause::scattering, "pi",
     "Kd is not divided by pi"},
    {Change::glossy_scale, ModelKind::mistake, Cause::scattering, "glossy",
     "the glossy lobe is not multiplied by (Ns + 2) / 2 pi"},
    {Change::glossy_missing, ModelKind::mistake, Cause::scattering, "glossy",
     "the glossy lobe is missing"},
    {Change::glossy_missing_direct, ModelKind::mistake, Cause::scattering, "glossy",
     "the glossy lobe is missing in direct light"},
    {Change::glossy_missing_indirect, ModelKind::mistake, Cause::scattering, "glossy",
     "the glossy lobe is missing in scattered light"},
    {Change::glossy_flat, ModelKind::mistake, Cause::scattering, "glossy",
     "the glossy lobe is not multiplied by the cosine at the surface"},
    {Change::glossy_flat_direct, ModelKind::mistake, Cause::scattering, "glossy",
     "the glossy lobe of direct light is not multiplied by the cosine at the surface"},
    {Change::glossy_blinn, ModelKind::mistake, Cause::scattering, "glossy",
     "the glossy lobe uses the half vector (Blinn) instead of the mirror direction (Phong)"},
    {Change::glossy_eye, ModelKind::mistake, Cause::scattering, "glossy",
     "the glossy lobe is around the direction to the eye instead of the mirror direction"},
    {Change::lobe_alone, ModelKind::convention, Cause::scattering, "lobe-alone",
     "materials whose Ks is larger than Kd have the glossy lobe alone"},
    {Change::uniform_density, ModelKind::mistake, Cause::scattering, "direction-density",
     "directions are distributed by the cosine, but divided by the density 1 / 2 pi"},
    {Change::cosine_density, ModelKind::mistake, Cause::scattering, "direction-density",
     "directions are uniform, but divided by the density cos / pi"},
    {Change::polar_density, ModelKind::mistake, Cause::scattering, "direction-density",
     "directions have uniform angles, which are not uniform directions: too many near the normal"},
    {Change::y_directions, ModelKind::mistake, Cause::scattering, "direction-axis",
     "directions are distributed around the y axis instead of the normal"},
    {Change::z_directions, ModelKind::mistake, Cause::scattering, "direction-axis",
     "directions are distributed around the z axis instead of the normal"},
    {Change::color_roulette, ModelKind::mistake, Cause::path_length, "roulette",
     "paths are not divided by the probability of going on, which is the largest value of Kd + Ks"},
    {Change::gray_by_luminance, ModelKind::mistake, Cause::scattering, "gray-throughput",
     "paths lose color: their throughput is multiplied by the luminance of reflectances"},
    {Change::gray_by_mean, ModelKind::mistake, Cause::scattering, "gray-throughput",
     "paths lose color: their throughput is multiplied by the mean of red, green and blue of "
     "reflectances"},
    {Change::corner_points, ModelKind::mistake, Cause::light_samples, "lamp-points",
     "points on the triangles of lamps are not uniform"},
    {Change::edge_points, ModelKind::mistake, Cause::light_samples, "lamp-points",
     "points on the triangles of lamps are not uniform"},
    {Change::normalized_points, ModelKind::mistake, Cause::light_samples, "lamp-points",
     "points on the triangles of lamps are not uniform: three random numbers divided by their sum"},
    {Change::lamp_area, ModelKind::mistake, Cause::light_samples, "lamp-area",
     "light samples are not multiplied by the area of the triangle"},
    {Change::lamp_area_divided, ModelKind::mistake, Cause::light_samples, "lamp-area",
     "light samples are divided by the area of the triangle instead of multiplied"},
    {Change::lamp_area_of_first, ModelKind::mistake, Cause::light_samples, "lamp-area",
     "light samples are multiplied by the area of the first triangle, whichever they are on"},
    {Change::lamp_area_mean, ModelKind::mistake, Cause::light_samples, "lamp-area",
     "light samples are multiplied by the mean area of triangles, whichever they are on"},
    {Change::lamp_emission, ModelKind::mistake, Cause::light_samples, "lamp-color",
     "light samples are not multiplied by Ke, the emission of the lamp"},
    {Change::lamp_emission_of_first, ModelKind::mistake, Cause::light_samples, "lamp-color",
     "light samples have the Ke of the first lamp, whichever they are on"},
    {Change::lamp_emission_of_last, ModelKind::mistake, Cause::light_samples, "lamp-color",
     "light samples have the Ke of the last lamp, whichever they are on"},
    {Change::first_lamp, ModelKind::mistake, Cause::light_samples, "lamp-choice",
     "only one triangle of the lamps is sampled"},
    {Change::last_lamp, ModelKind::mistake, Cause::light_samples, "lamp-choice",
     "only one triangle of the lamps is sampled"},
    {Change::fresnel_twice, ModelKind::mistake, Cause::specular_paths, "fresnel",
     "glass chooses by Fresnel's reflectance and multiplies by it as well"},
    {Change::no_fresnel, ModelKind::mistake, Cause::specular_paths, "fresnel",
     "glass only refracts, it reflects nothing"},
    {Change::half_fresnel, ModelKind::mistake, Cause::specular_paths, "fresnel",
     "glass reflects and refracts with the same weight, whatever the angle"},
    {Change::only_reflection, ModelKind::mistake, Cause::specular_paths, "fresnel",
     "glass only reflects, it refracts nothing"},
    {Change::swapped_fresnel, ModelKind::mistake, Cause::specular_paths, "fresnel",
     "glass refracts with the probability of reflection"},
    {Change::no_total_reflection, ModelKind::mistake, Cause::specular_paths, "total-reflection",
     "the light of total internal reflection is missing"},
    {Change::schlick, ModelKind::convention, Cause::specular_paths, "schlick",
     "Schlick's approximation of Fresnel's equations"},
    {Change::schlick_without_square, ModelKind::mistake, Cause::specular_paths, "fresnel",
     "in Schlick's approximation, (n - 1) / (n + 1) is not squared"},
    {Change::mirror_cosine, ModelKind::mistake, Cause::specular_paths, "mirror-cosine",
     "mirrors multiply by the cosine"},
    {Change::mirror_without_color, ModelKind::convention, Cause::specular_paths,
     "mirror-without-ks", "mirrors do not multiply by Ks"},
}};

}  // namespace

void ModelSearch::solve(PathModel& model) const {
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
  if (!model.noise.empty()) {
    if (!model.free.empty()) {
      const double scale = model.factor() * model.factor();
      for (Color& noise : model.noise) {
        noise *= scale;
      }
    }
    model.fit = fit(measured_with(model), fixed, columns);
  }
  // No mistake takes more light away than there is.
  bool possible = model.fit.solved;
  for (std::size_t i = 0; possible && i < model.free.size(); ++i) {
    possible = model.fit.factors[i] > -0.1;
  }
  if (!possible) {  // or the scene has none of this light
    model.fit.solved = false;
    model.fit.chi2 = model.chi2 = model.plain_chi2 = model.deviance = 1e300;
    return;
  }
  model.chi2 = model.plain_chi2 = model.deviance = 0;
  for (std::size_t b = 0; b < fixed.size(); ++b) {
    const Color rest = residual(model, b);
    // Of the variance, in units of that without the noise of the model.
    const Color more =
        model.noise.empty() ? Color(1) : Color(1) + seen_.cautious[b] * model.noise[b];
    model.plain_chi2 += glm::dot(seen_.cautious[b] * rest, rest);
    model.chi2 += glm::dot(seen_.cautious[b] / more * rest, rest);
    model.deviance += glm::dot(glm::log(more), Color(1));
  }
  model.deviance += model.chi2;
}

MeasuredBlocks ModelSearch::measured_with(const PathModel& model) const {
  MeasuredBlocks measured = measured_;
  for (std::size_t b = 0; b < model.noise.size(); ++b) {
    measured.weight[b] /= Color(1) + measured.weight[b] * model.noise[b];
  }
  return measured;
}

Color ModelSearch::residual(const PathModel& model, std::size_t b) const {
  Color rest = measured_.mean[b] - model.fixed[b];
  for (std::size_t i = 0; i < model.free.size() + nuisance_.size(); ++i) {
    rest -= model.fit.factors[i] *
            (i < model.free.size() ? model.free[i][b] : (*nuisance_[i - model.free.size()])[b]);
  }
  return rest;
}

PathModel ModelSearch::right() const {
  PathModel model{ModelKind::right, Cause::scattering, "right", "", back_.all, {}, 1, 0, 0};
  solve(model);
  return model;
}

BlockColors ModelSearch::picture_of(const PathModel& model) const {
  BlockColors picture = model.fixed;
  for (std::size_t i = 0; i < model.free.size(); ++i) {
    picture = combined(picture, model.fit.factors[i], model.free[i]);
  }
  return picture;
}

double ModelSearch::significance(const PathModel& model) const {
  const BlockColors step = combined(picture_of(model), -1, back_.all);
  std::vector<const BlockColors*> columns{&step};
  columns.insert(columns.end(), nuisance_.begin(), nuisance_.end());
  if (any_exposure_) {
    columns.push_back(&back_.all);
  }
  const BlockFit found = fit(measured_with(model), back_.all, columns);
  return found.solved ? found.factors[0] / found.errors[0] : 0;
}

std::optional<PathModel> ModelSearch::pair(const std::vector<PathModel>& singles) const {
  const BlockColors light = combined(back_.all, -1, back_.lamp);
  struct Part {
    const PathModel* model;
    BlockColors relative;  // what the light of a block is multiplied by
  };
  std::vector<Part> parts;
  std::vector<const PathModel*> firsts;
  for (const PathModel& m : singles) {
    const BlockColors picture = m.fit.solved ? picture_of(m) : back_.all;
    double change = 0;
    for (const Color& step : combined(picture, -1, back_.all)) {
      change += std::abs(luminance(step));
    }
    if (m.parameters > 0 || change <= 0.001 * back_.energy(light)) {
      continue;
    }
    if (m.free.empty() && m.edits == 1) {
      BlockColors relative = combined(picture, -1, back_.lamp);
      for (std::size_t k = 0; k < relative.size(); ++k) {
        for (int c = 0; c < 3; ++c) {
          relative[k][c] = light[k][c] > 0 ? relative[k][c] / light[k][c] : 1;
        }
      }
      parts.push_back({&m, std::move(relative)});
    }
    if (m.free.size() <= 1 && !any_exposure_) {
      firsts.push_back(&m);
    }
  }
  std::optional<PathModel> best;
  for (const PathModel* const a : firsts) {
    for (const Part& part : parts) {
      const PathModel& b = *part.model;
      // Each pair of two without a factor once.
      if (a->name == b.name || (a->free.empty() && a > &b)) {
        continue;
      }
      PathModel model{a->kind, a->page, a->name, "", a->fixed, a->free, 1, 0, a->edits + 1};
      for (std::size_t k = 0; k < light.size(); ++k) {
        model.fixed[k] = back_.lamp[k] + part.relative[k] * (model.fixed[k] - back_.lamp[k]);
        for (BlockColors& free : model.free) {
          free[k] *= part.relative[k];
        }
      }
      model.first = a;
      model.second = &b;
      solve(model);
      if (model.fit.solved && (!best || model.score() < best->score())) {
        best = std::move(model);
      }
    }
  }
  return best;
}

template <typename At>
PathModel ModelSearch::best_of(double low, double high, const At& at) const {
  std::optional<PathModel> best;
  const double least = std::log(low);
  const double most = std::log(high);
  low = least;
  high = most;
  int steps = 24;
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i <= steps; ++i) {
      PathModel model = at(std::exp(low + (high - low) * i / steps));
      solve(model);
      if (!best || model.fit.chi2 < best->fit.chi2) {
        best = std::move(model);
      }
    }
    const double middle = std::log(best->parameter);
    const double reach = (high - low) / steps;
    low = std::max(least, middle - reach);
    high = std::min(most, middle + reach);
    steps = 8;
  }
  return *best;
}

// `power`: how often the parameter is a factor.
PathModel ModelSearch::by_parameter(Cause page, const char* name, int (*power)(const LightKind&),
                                    bool free_direct) const {
  return best_of(0.02, 12, [&](double p) {
    PathModel model{ModelKind::mistake, page, name, "", {}, {}, p, 1, free_direct ? 2 : 1};
    const auto factor = [&](const LightKind& k) { return std::pow(p, power(k)); };
    BlockColors hits = back_.scaled_kinds(factor, true);
    BlockColors samples = back_.scaled_kinds(factor, false);
    if (free_direct) {
      model.fixed = std::move(hits);
      model.free.push_back(std::move(samples));
    } else {
      model.fixed = combined(hits, 1, samples);
    }
    return model;
  });
}

PathModel ModelSearch::by_throughput(const std::vector<LooseThroughputs>& lights, bool added,
                                     bool divided) const {
  constexpr std::size_t most = LooseThroughputs::most;
  // Far from the camera, bounces differ only by the light that leaves the scene.
  constexpr std::size_t few = 4;
  double near = 0;
  double far = 0;
  for (const LooseThroughputs& light : lights) {
    for (std::size_t n = most + 1 - few; n <= most; ++n) {
      near += back_.energy(light.one[n - few]);
      far += back_.energy(light.one[n]);
    }
  }
  const double stays = near > 0 ? std::min(1.0, std::pow(far / near, 1.0 / few)) : 0;
  const auto picture = [&](const LooseThroughputs& light, double p) {
    BlockColors sum = back_.zero;
    const auto add = [&](double by, const BlockColors& term) {
      for (std::size_t b = 0; b < term.size(); ++b) {
        sum[b] += by * term[b];
      }
    };
    const double left = stays * p;
    for (std::size_t n = 0; n <= most; ++n) {
      // The last few terms stand for those beyond, for which sums of factors grow.
      const bool is_far = n + few > most;
      const double beyond = is_far ? std::pow(left, most + 1 - n) / (1 - left) / few : 0;
      const double grown = is_far ? beyond / double(n) * (most + 1 + left / (1 - left)) : 0;
      const double gone_on = std::pow(p, n);
      const double factor = gone_on * (divided && n > 0 ? 1 / p : 1);
      if (added) {
        add(gone_on * (1 + beyond), light.one[n]);
        add(factor * (1 + grown), light.sum[n]);
      } else {
        add(factor * (1 + beyond), light.last[n]);
      }
    }
    return sum;
  };
  return best_of(0.2, 0.97, [&](double p) {
    PathModel model{
        ModelKind::mistake,
        Cause::scattering,
        added ? "throughput-added" : "throughput-replaced",
        fmt::format("the factor of each direction {} the throughput of the path instead of being "
                    "multiplied by it; the probability of going on is {:.2f}",
                    added ? "is added to" : "replaces", p),
        back_.zero,
        {},
        p,
        1,
        1,
        back_.zero};
    const auto count = static_cast<double>(lights.size());
    std::vector<BlockColors> pictures;
    for (const LooseThroughputs& light : lights) {
      pictures.push_back(picture(light, p));
      model.fixed = combined(model.fixed, 1 / count, pictures.back());
    }
    for (const BlockColors& one : pictures) {
      for (std::size_t b = 0; b < one.size(); ++b) {
        const Color off = one[b] - model.fixed[b];
        model.noise[b] += off * off / (count * (count - 1));
      }
    }
    model.noise = shrunk(model.noise, back_.truth.columns);
    return model;
  });
}

std::vector<PathModel> ModelSearch::models(bool toned) const {
  constexpr auto lamps = Cause::light_samples;
  constexpr auto scattering = Cause::scattering;
  constexpr auto lengths = Cause::path_length;
  constexpr auto specular = Cause::specular_paths;
  std::vector<PathModel> list;
  const auto add = [&](PathModel model) {
    solve(model);
    list.push_back(std::move(model));
  };
  const auto without = [&](Cause page, const char* name, std::string what, const auto& lost) {
    add({ModelKind::mistake,
         page,
         name,
         std::move(what),
         combined(back_.all, -1, back_.sum(lost)),
         {}});
  };
  const BlockColors lamp_and_hit = combined(back_.lamp, 1, back_.hit);
  add({ModelKind::mistake, lamps, "direct", "", lamp_and_hit, {back_.sampled}});
  add({ModelKind::mistake, lamps, "whole", "", back_.zero, {back_.all}});
  const auto colored = [&](Cause page, const char* name, const BlockColors& light) {
    PathModel model{ModelKind::mistake, page, name, "", combined(back_.all, -1, light), {}};
    for (int c = 0; c < 3; ++c) {
      Color channel(0);
      channel[c] = 1;
      model.free.push_back(light);
      for (Color& value : model.free.back()) {
        value *= channel;
      }
    }
    add(std::move(model));
  };
  colored(lamps, "direct-color", back_.sampled);
  colored(scattering, "indirect-color", back_.sum([](const LightKind& k) { return k.rough > 0; }));
  const auto rough = [](const LightKind& k) { return int(k.rough); };
  const auto bounces = [](const LightKind& k) { return k.bounces(); };
  const auto at_glass = [](const LightKind& k) { return int(k.glass); };
  const auto at_specular = [](const LightKind& k) { return k.mirror + k.glass; };
  list.push_back(by_parameter(scattering, "scattered", rough, false));
  list.push_back(by_parameter(scattering, "direct-and-scattered", rough, true));
  list.push_back(by_parameter(lengths, "bounce", bounces, false));
  list.push_back(by_parameter(lengths, "direct-and-bounce", bounces, true));
  for (const std::vector<LooseThroughputs>& lights : back_.truth.throughputs) {
    for (const bool added : {false, true}) {
      for (const bool divided : {false, true}) {
        if (!lights.empty()) {
          list.push_back(by_throughput(lights, added, divided));
        }
      }
    }
  }
  if (back_.truth.glass) {
    list.push_back(by_parameter(specular, "glass-step", at_glass, false));
  }
  if (back_.truth.glass && back_.truth.mirror) {
    list.push_back(by_parameter(specular, "specular-step", at_specular, false));
  }
  if (!back_.truth.lamp_samples.empty() && !any_exposure_) {
    add({ModelKind::mistake, lamps, "lamps", "", lamp_and_hit, back_.truth.lamp_samples});
  }
  constexpr std::array<const char*, sample_tone_count> tone_words{
      "samples are limited to 1 before their mean is taken",
      "samples are mapped by v / (1 + v) before their mean is taken, not the mean",
      "samples are mapped by 1 - exp(-v) before their mean is taken, not the mean"};
  for (std::size_t t = 0; toned && t < sample_tone_count; ++t) {
    add({ModelKind::mistake,
         Cause::samples,
         "toned-samples",
         tone_words[t],
         back_.truth.toned[t],
         {}});
  }
  const auto part = [&](Cause page, const char* name, const auto& holds) {
    const BlockColors some = back_.sum(holds);
    add({ModelKind::mistake, page, name, "", combined(back_.all, -1, some), {some}});
  };
  part(lamps, "first-direct", [](const LightKind& k) { return !k.hit && k.rough == 0; });
  part(scattering, "indirect", [](const LightKind& k) { return k.rough > 0; });
  part(specular, "mirror", [](const LightKind& k) { return k.mirror > 0; });
  part(specular, "glass", [](const LightKind& k) { return k.glass > 0; });
  if (back_.truth.glossy) {
    const ChangedPicture& without_lobe =
        back_.truth.changes[static_cast<std::size_t>(Change::glossy_missing)];
    const BlockColors dull =
        combined(combined(back_.lamp, 1, without_lobe.sampled), 1, without_lobe.hit);
    add({ModelKind::mistake, scattering, "glossy-lobe", "", dull, {combined(back_.all, -1, dull)}});
  }
  part(lengths, "caustics", [](const LightKind& k) { return k.hit && k.rough > 0; });
  for (int n = 0; n <= 6; ++n) {
    without(lengths, n == 0 ? "no-reflected-light" : "depth",
            n == 0   ? "no light is reflected, only lamps are visible: paths end at the first "
                       "surface, or all shadow rays hit the lamp or their own surface"
            : n == 1 ? "only light of one bounce is there: indirect light is missing"
                     : fmt::format("paths end after {} bounces", n),
            [n](const LightKind& k) { return k.bounces() + (k.hit ? 0 : 1) > n; });
  }
  for (int n = 1; n <= 5; ++n) {
    without(lengths, "depth",
            n == 1 ? std::string("indirect light is missing: no scattered directions")
                   : fmt::format("paths end after {} diffuse or glossy bounces", n),
            [n](const LightKind& k) { return k.rough + (k.hit ? 0 : 1) > n; });
  }
  if (back_.truth.mirror || back_.truth.glass) {  // otherwise the same as without indirect light
    without(lamps, "first-surface", "light samples are taken only at the first surface",
            [](const LightKind& k) { return !k.hit && k.bounces() > 0; });
  }
  without(lengths, "emission-after-specular",
          "lamps that are hit after a mirror or glass do not count",
          [](const LightKind& k) { return k.hit && k.bounces() > 0; });
  without(lengths, "emission-after-specular", "lamps that are hit after a mirror do not count",
          [](const LightKind& k) { return k.hit && k.mirror > 0; });
  without(lengths, "emission-after-specular", "lamps that are hit after glass do not count",
          [](const LightKind& k) { return k.hit && k.glass > 0; });
  without(lengths, "caustics",
          "caustics are missing: lamps that are hit through glass or a mirror after a "
          "diffuse or glossy surface do not count",
          [](const LightKind& k) { return k.hit && k.rough > 0; });
  without(specular, "mirror", "mirrors reflect nothing",
          [](const LightKind& k) { return k.mirror > 0; });
  without(specular, "glass", "light after glass is missing",
          [](const LightKind& k) { return k.glass > 0; });
  without(specular, "mirror", "mirrors and glass are black",
          [](const LightKind& k) { return k.mirror + k.glass > 0; });
  const auto beyond_truth = [&](const BlockColors& noise) {
    BlockColors rest = shrunk(noise, back_.truth.columns);
    for (std::size_t b = 0; b < rest.size(); ++b) {
      rest[b] = glm::max(rest[b] - back_.truth_noise[b], Color(0));
    }
    return rest;
  };
  for (const ChangeRow& row : change_rows) {
    const ChangedPicture& changed = back_.truth.changes[static_cast<std::size_t>(row.change)];
    const BlockColors hits = combined(back_.lamp, 1, changed.hit);
    const BlockColors noise = beyond_truth(changed.noise);
    add({row.kind,
         row.page,
         row.name,
         row.what,
         combined(hits, 1, changed.sampled),
         {},
         1,
         0,
         1,
         noise});
    if (row.change == Change::first_lamp || row.change == Change::last_lamp) {
      const auto count = static_cast<double>(back_.truth.lamp_areas.size());
      add({row.kind,
           row.page,
           row.name,
           row.what,
           combined(hits, count, changed.sampled),
           {},
           1,
           0,
           1,
           combined(back_.zero, count * count, noise)});
    } else {
      add({ModelKind::mistake,
           row.page,
           row.name,
           row.what,
           hits,
           {changed.sampled},
           1,
           0,
           2,
           noise});
    }
  }
  constexpr std::array variant_rows{
      VariantRow{Variant::two_sided_lamps, ModelKind::convention, Cause::light_samples, "two-sided",
                 "lamps shine to both sides"},
      VariantRow{Variant::inverted_index, ModelKind::mistake, Cause::specular_paths, "refraction",
                 "the ratio of the indices of refraction is inverted"},
      VariantRow{Variant::always_enters, ModelKind::mistake, Cause::specular_paths, "refraction",
                 "rays that leave glass are refracted as if they entered it"},
      VariantRow{Variant::flat_normals, ModelKind::mistake, Cause::normals, "flat-normals",
                 "normals are those of the triangles, not interpolated"},
      VariantRow{
          Variant::lamp_parallelograms, ModelKind::mistake, Cause::light_samples, "lamp-points",
          "points on lamps are in parallelograms instead of triangles: u + v may be above 1"},
      VariantRow{Variant::all_bounces, ModelKind::mistake, Cause::path_length, "depth",
                 "light of more bounces is there than was asked for, as if directLightingOnly or "
                 "the largest number of bounces had no effect"},
      VariantRow{Variant::shaded_mirrors, ModelKind::mistake, Cause::specular_paths,
                 "shaded-specular",
                 "mirrors are also lit like other surfaces, as if a return were missing"},
      VariantRow{Variant::shaded_glass, ModelKind::mistake, Cause::specular_paths,
                 "shaded-specular",
                 "glass is also lit like other surfaces, as if a return were missing"}};
  for (const VariantPicture& variant : back_.truth.variants) {
    const VariantRow& row = variant_rows[static_cast<std::size_t>(variant.variant)];
    add({row.kind,
         row.page,
         row.name,
         row.what,
         variant.picture,
         {},
         1,
         0,
         1,
         shrunk(variant.noise, back_.truth.columns),
         variant.variant});
  }
  return list;
}

}  // namespace scenefile
