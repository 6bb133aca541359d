#include "scenefile/noise/path_models.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

namespace scenefile {

namespace {

struct ChangeRow {
  Change change;
  ModelKind kind;
  const char* name;
  const char* what;
};

constexpr std::array<ChangeRow, change_count> change_rows{{
    {Change::surface_cosine_direct, ModelKind::mistake, "surface-cosine",
     "direct light is not multiplied by the cosine at the surface"},
    {Change::surface_cosine_indirect, ModelKind::mistake, "surface-cosine",
     "scattered light is not multiplied by the cosine at the surface"},
    {Change::surface_cosine, ModelKind::mistake, "surface-cosine",
     "light is not multiplied by the cosine at the surface"},
    {Change::surface_cosine_twice, ModelKind::mistake, "surface-cosine",
     "direct light is multiplied twice by the cosine at the surface"},
    {Change::lamp_cosine, ModelKind::mistake, "lamp-cosine",
     "light of lamps is not multiplied by the cosine at the lamp"},
    {Change::lamp_cosine_twice, ModelKind::mistake, "lamp-cosine",
     "light of lamps is multiplied twice by the cosine at the lamp"},
    {Change::falloff_distance, ModelKind::mistake, "distance",
     "light of lamps is divided by the distance, not by its square"},
    {Change::falloff_none, ModelKind::mistake, "distance",
     "light of lamps is not divided by the square of the distance"},
    {Change::falloff_cube, ModelKind::mistake, "distance",
     "light of lamps is divided by the third power of the distance"},
    {Change::no_visibility, ModelKind::mistake, "visibility",
     "light samples are not tested for shadows"},
    {Change::diffuse_missing_direct, ModelKind::mistake, "diffuse-color",
     "direct light is not multiplied by Kd"},
    {Change::diffuse_missing_indirect, ModelKind::mistake, "diffuse-color",
     "scattered light is not multiplied by Kd"},
    {Change::diffuse_missing, ModelKind::mistake, "diffuse-color", "light is not multiplied by Kd"},
    {Change::diffuse_twice_direct, ModelKind::mistake, "diffuse-color",
     "direct light is multiplied twice by Kd"},
    {Change::diffuse_twice_indirect, ModelKind::mistake, "diffuse-color",
     "scattered light is multiplied twice by Kd"},
    {Change::diffuse_twice, ModelKind::mistake, "diffuse-color", "light is multiplied twice by Kd"},
    {Change::glossy_scale, ModelKind::mistake, "glossy",
     "the glossy lobe is not multiplied by (Ns + 2) / 2 pi"},
    {Change::glossy_missing, ModelKind::mistake, "glossy", "the glossy lobe is missing"},
    {Change::glossy_blinn, ModelKind::mistake, "glossy",
     "the glossy lobe uses the half vector (Blinn) instead of the mirror direction (Phong)"},
    {Change::lobe_alone, ModelKind::convention, "lobe-alone",
     "materials whose Ks is larger than Kd have the glossy lobe alone"},
    {Change::uniform_density, ModelKind::mistake, "direction-density",
     "directions are distributed by the cosine, but divided by the density 1 / 2 pi"},
    {Change::cosine_density, ModelKind::mistake, "direction-density",
     "directions are uniform, but divided by the density cos / pi"},
    {Change::polar_density, ModelKind::mistake, "direction-density",
     "directions have uniform angles, which are not uniform directions: too many near the normal"},
    {Change::corner_points, ModelKind::mistake, "lamp-points",
     "points on the triangles of lamps are not uniform"},
    {Change::edge_points, ModelKind::mistake, "lamp-points",
     "points on the triangles of lamps are not uniform"},
    {Change::normalized_points, ModelKind::mistake, "lamp-points",
     "points on the triangles of lamps are not uniform: three random numbers divided by their sum"},
    {Change::lamp_area, ModelKind::mistake, "lamp-area",
     "light samples are not multiplied by the area of the triangle"},
    {Change::first_lamp, ModelKind::mistake, "lamp-choice",
     "only one triangle of the lamps is sampled"},
    {Change::last_lamp, ModelKind::mistake, "lamp-choice",
     "only one triangle of the lamps is sampled"},
    {Change::fresnel_twice, ModelKind::mistake, "fresnel",
     "glass chooses by Fresnel's reflectance and multiplies by it as well"},
    {Change::no_fresnel, ModelKind::mistake, "fresnel", "glass only refracts, it reflects nothing"},
    {Change::half_fresnel, ModelKind::mistake, "fresnel",
     "glass reflects and refracts with the same weight, whatever the angle"},
    {Change::no_total_reflection, ModelKind::mistake, "total-reflection",
     "the light of total internal reflection is missing"},
    {Change::schlick, ModelKind::convention, "schlick",
     "Schlick's approximation of Fresnel's equations"},
    {Change::mirror_cosine, ModelKind::mistake, "mirror-cosine", "mirrors multiply by the cosine"},
    {Change::mirror_without_color, ModelKind::convention, "mirror-without-ks",
     "mirrors do not multiply by Ks"},
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

Color ModelSearch::residual(const PathModel& model, std::size_t b) const {
  Color rest = measured_.mean[b] - model.fixed[b];
  for (std::size_t i = 0; i < model.free.size() + nuisance_.size(); ++i) {
    rest -= model.fit.factors[i] *
            (i < model.free.size() ? model.free[i][b] : (*nuisance_[i - model.free.size()])[b]);
  }
  return rest;
}

PathModel ModelSearch::right() const {
  PathModel model{ModelKind::right, "right", "", back_.all, {}, 1, 0, 0};
  solve(model);
  return model;
}

double ModelSearch::significance(const PathModel& model) const {
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
  const BlockFit found = fit(measured_, back_.all, columns);
  return found.solved ? found.factors[0] / found.errors[0] : 0;
}

// `power`: how often the parameter is a factor.
PathModel ModelSearch::by_parameter(const char* name, int (*power)(const LightKind&),
                                    bool free_direct) const {
  const auto at = [&](double p) {
    PathModel model{ModelKind::mistake, name, "", {}, {}, p, 1, free_direct ? 2 : 1};
    const auto factor = [&](const LightKind& k) { return std::pow(p, power(k)); };
    BlockColors hits = back_.scaled_kinds(factor, true);
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
  std::optional<PathModel> best;
  double low = std::log(0.02);
  double high = std::log(12.0);
  int steps = 24;
  for (int round = 0; round < 4; ++round) {
    double middle = 0;
    for (int i = 0; i <= steps; ++i) {
      const double p = low + (high - low) * i / steps;
      PathModel model = at(std::exp(p));
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

std::vector<PathModel> ModelSearch::models() const {
  std::vector<PathModel> list;
  const auto add = [&](PathModel model) {
    solve(model);
    list.push_back(std::move(model));
  };
  const auto without = [&](const char* name, std::string what, const auto& lost) {
    add({ModelKind::mistake, name, std::move(what), combined(back_.all, -1, back_.sum(lost)), {}});
  };
  const BlockColors lamp_and_hit = combined(back_.lamp, 1, back_.hit);
  add({ModelKind::mistake, "direct", "", lamp_and_hit, {back_.sampled}});
  add({ModelKind::mistake, "whole", "", back_.zero, {back_.all}});
  const auto rough = [](const LightKind& k) { return int(k.rough); };
  const auto bounces = [](const LightKind& k) { return k.bounces(); };
  list.push_back(by_parameter("scattered", rough, false));
  list.push_back(by_parameter("direct-and-scattered", rough, true));
  list.push_back(by_parameter("bounce", bounces, false));
  list.push_back(by_parameter("direct-and-bounce", bounces, true));
  const auto part = [&](const char* name, const auto& holds) {
    const BlockColors some = back_.sum(holds);
    add({ModelKind::mistake, name, "", combined(back_.all, -1, some), {some}});
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
      add({ModelKind::mistake, row.name, row.what, hits, {changed.sampled}, 1, 0, 2});
    }
  }
  for (const VariantPicture& variant : back_.truth.variants) {
    switch (variant.variant) {
      case Variant::two_sided_lamps:
        add({ModelKind::convention, "two-sided", "lamps shine to both sides", variant.picture, {}});
        break;
      case Variant::inverted_index:
        add({ModelKind::mistake,
             "refraction",
             "the ratio of the indices of refraction is inverted",
             variant.picture,
             {}});
        break;
      case Variant::flat_normals:
        add({ModelKind::mistake,
             "flat-normals",
             "normals are those of the triangles, not interpolated",
             variant.picture,
             {}});
        break;
    }
  }
  return list;
}

}  // namespace scenefile
