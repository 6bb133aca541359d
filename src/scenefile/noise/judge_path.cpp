#include "scenefile/noise/judge_path.h"

#include "scenefile/noise/growing_light.h"
#include "scenefile/noise/other_view.h"
#include "scenefile/noise/path_meanings.h"
#include "scenefile/noise/picture_readings.h"
#include "scenefile/noise/shared_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>

namespace scenefile {

namespace {

// The standard error of a block, relative to its light, beyond which the noise cannot be measured.
constexpr double too_much_noise = 0.25;

// The most that a right picture leaves, as a multiple of the variance of the noise.
constexpr double most_of_right = 2;

// Of the whole picture. Fewer blocks do not tell many mistakes apart: in a picture of 30, a wrong
// one was named. Other rows, channels, views or curves have fewer rivals.
constexpr std::size_t fewest_blocks = 32;
constexpr std::size_t fewest_blocks_for_file = 17;

// More mistakes that give the same picture are no help.
constexpr std::size_t most_named = 3;

std::string factor_text(double factor, double error) {
  return fmt::format("factor {:.3f} +- {:.3f}", factor, error);
}

// The largest value, if visible lamps have it instead of their emission, and other light does not
// have the same factor.
std::optional<double> cut_off(const TruthBlocks& back, const LinearPicture& picture,
                              const ObservedBlocks& seen) {
  double most = 0;
  for (const Color& pixel : picture.pixels) {
    most = std::max({most, pixel.x, pixel.y, pixel.z});
  }
  std::size_t brighter = 0;
  std::size_t cut = 0;
  double lamp = 0;
  for (const std::size_t at : lamp_pixels(back)) {
    for (int c = 0; c < 3; ++c) {
      if (back.truth.pixels[at][c] > 1.05 * most) {
        ++brighter;
        cut += std::abs(picture.pixels[at][c] / most - 1) < 1e-4 ? 1 : 0;
        lamp = back.truth.pixels[at][c];
      }
    }
  }
  std::vector<double> ratios;
  for (std::size_t b = 0; b < back.all.size(); ++b) {
    if (back.left_out[b] == 0 && luminance(back.all[b]) > 0) {
      ratios.push_back(luminance(seen.measured.mean[b]) / luminance(back.all[b]));
    }
  }
  constexpr std::size_t fewest = 12;
  const bool is_cut = brighter >= fewest &&
                      static_cast<double>(cut) > 0.95 * static_cast<double>(brighter) &&
                      std::abs(median_of(std::move(ratios)) * lamp / most - 1) > 0.1;
  return is_cut ? std::optional<double>(most) : std::nullopt;
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

std::vector<PathPlace> places_of(const TruthBlocks& back, const MeasuredBlocks& measured,
                                 double& chi2) {
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
  const std::vector<const BlockColors*> shifts = gradients(back, measured);
  columns.insert(columns.end(), shifts.begin(), shifts.end());
  const BlockFit found = fit(measured, fixed, columns);
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

// A fitted exposure makes factors relative: to that of direct light, if it is known.
double scale_of(const Reading& reading, const std::vector<PathPlace>& places) {
  const bool is_known = !places.empty() && places.front().name == place_rows.front().name &&
                        places.front().factor > claim_errors * places.front().error;
  return is_known ? places.front().factor : reading.right.factor();
}

// The largest standard error of what is not a small part of the light.
double largest_error(const std::vector<PathPlace>& places) {
  double error = 0;
  for (const PathPlace& place : places) {
    error = std::max(error, place.share > 0.15 ? place.error : 0);
  }
  return error;
}

// Sets how many times as many samples would reduce the error to `limit`. If noise is not what
// hides it, because there are too few blocks, or the truth itself is too noisy, none do.
void count_samples(const TruthBlocks& back, const ObservedBlocks& seen, double error, double limit,
                   PathVerdict& verdict) {
  const auto error_without = [&](double truth_noise) {
    MeasuredBlocks exact{back.all, back.zero};
    for (std::size_t b = 0; b < exact.weight.size(); ++b) {
      for (int c = 0; c < 3 && seen.measured.weight[b] != Color(0); ++c) {
        const double left = seen.unrelated[b][c] - truth_noise * back.truth_noise[b][c];
        exact.weight[b][c] = 1 / std::max(1e-30, left);
      }
    }
    double chi2 = 0;
    return largest_error(places_of(back, exact, chi2));
  };
  const double left = error_without(0);
  verdict.more_samples = std::pow(seen.relative_noise / too_much_noise, 2);
  if (left >= limit) {
    verdict.more_samples = std::numeric_limits<double>::infinity();
    verdict.truth_too_noisy = error_without(1) < limit;
  } else if (error > limit) {
    verdict.more_samples = std::max(verdict.more_samples,
                                    (error * error - left * left) / (limit * limit - left * left));
  }
}

void add_energy(const TruthBlocks& back, const MeasuredBlocks& measured, PathVerdict& verdict) {
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
    if (back.energy(light) > 0) {
      columns.push_back(&light);
    }
  }
  const BlockFit found = fit(measured, back.lamp, columns);
  if (!found.solved) {
    return;
  }
  std::size_t column = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const bool is_fitted = back.energy(lights[i]) > 0;
    verdict.energy_mine.push_back(is_fitted ? found.factors[column] * verdict.energy_truth[i] : 0);
    column += is_fitted ? 1 : 0;
  }
}

void count_fireflies(const TruthBlocks& back, const LinearPicture& picture, PathVerdict& verdict) {
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

// The mean change of the light where the model changes it by more than 2 %.
double effect_of(const TruthBlocks& back, const PathModel& model) {
  double changed = 0;
  double light = 0;
  for (std::size_t b = 0; b < back.zero.size(); ++b) {
    Color value = model.fixed[b];
    for (std::size_t i = 0; i < model.free.size(); ++i) {
      value += model.fit.factors[i] * model.free[i][b];
    }
    for (int c = 0; c < 3; ++c) {  // a mistake may leave the luminance as it is
      const double truth = back.all[b][c];
      const double off = std::abs(value[c] - truth);
      if (back.left_out[b] == 0 && off > 0.02 * truth) {
        changed += off;
        light += truth;
      }
    }
  }
  return light > 0 ? changed / light : 0;
}

const char* kind_of(Cause page) {
  switch (page) {
    case Cause::light_samples:
      return "light samples are wrong";
    case Cause::scattering:
      return "what surfaces scatter is wrong";
    case Cause::specular_paths:
      return "what mirrors or glass show is wrong";
    default:
      return nullptr;
  }
}

// Turns what explains one reading of the picture into claims.
struct Explanation {
  const TruthBlocks& back;
  const Reading& reading;
  PathVerdict& verdict;
  ModelSearch search{back, reading.seen, reading.any_exposure};
  std::optional<LampFactor> whole = reading.any_exposure ? std::nullopt : reading.lamps;

  std::vector<Meaning> meanings_of(const PathModel& m, bool& general) const {
    return meanings(back.truth, m, whole, general);
  }

  bool counts(const PathModel& m) const {
    return std::abs(search.significance(m)) >= claim_errors && effect_of(back, m) >= least_effect;
  }

  // A fitted number may explain most of the difference, although some kind of light does not have
  // the factor that it says.
  bool is_contradicted(const PathModel& m) const {
    constexpr double least_share = 0.05;  // of the light; less is hardly measured
    if (m.parameters == 0) {
      return false;
    }
    double chi2 = 0;
    const std::vector<PathPlace> places = places_of(back, search.measured_by(m), chi2);
    const double scale = reading.any_exposure ? scale_of(reading, places) : 1;
    for (std::size_t i = 0; i < std::min(places.size(), verdict.places.size()); ++i) {
      const PathPlace& place = verdict.places[i];
      const double off = std::abs(place.factor - places[i].factor / scale);
      if (place.share > least_share && off > claim_errors * place.error && off > least_off) {
        return true;
      }
    }
    return false;
  }

  // Numbers may also stand for a tone curve that is not known, if they leave more than noise.
  bool is_complete(const PathModel& m) const {
    const std::size_t exposures = reading.any_exposure ? 1 : 0;
    const bool has_numbers = m.parameters > 0 || m.free.size() > exposures;
    return reading.is_complete(m) && !is_contradicted(m) &&
           (!has_numbers || reading.screen.curve == ToneCurve::linear ||
            m.chi2 < most_of_right * reading.values());
  }

  // No more than the noise, and not worse than the best.
  bool is_near(const PathModel& m) const {
    return m.kind == ModelKind::mistake && reading.is_like_noise(m) && !is_contradicted(m) &&
           m.deviance < reading.models.front().deviance + reading.tie();
  }

  void claim(std::vector<PathClaim>& list, const PathModel& m, const Meaning& name) const {
    const auto same = [&](const PathClaim& c) {
      return c.what == name.what || c.name == name.name;
    };
    if (std::none_of(list.begin(), list.end(), same)) {
      list.push_back(
          {name.page, name.name, name.what,
           fmt::format("explains {:.0f} % of the difference beyond noise; {:.0f} standard errors",
                       100 * reading.explained(m), std::abs(search.significance(m))),
           reading.explained(m)});
    }
  }

  // A mistake that explains as much as free numbers is more likely.
  const PathModel& best() const {
    const double most = reading.models.front().deviance + reading.tie();
    const auto is_known = [&](const PathModel& m) {
      bool general = false;
      static_cast<void>(meanings_of(m, general));
      return !general && m.edits == 1 && m.deviance < most && is_complete(m);
    };
    const auto known = std::find_if(reading.models.begin(), reading.models.end(), is_known);
    return known == reading.models.end() ? reading.models.front() : *known;
  }

  void claim_pair(const PathModel& two) const {
    PathModel fitted = *two.first;
    if (!fitted.free.empty()) {
      fitted.fit = two.fit;
    }
    bool general = false;
    bool ignored = false;
    const Meaning a = meanings_of(fitted, general).front();
    const Meaning b = meanings_of(*two.second, ignored).front();
    const bool first_wrong = fitted.kind != ModelKind::convention;
    const bool second_wrong = two.second->kind != ModelKind::convention;
    if (first_wrong && second_wrong) {
      // A mistake with a free factor beside another one explains much: it need not be there.
      claim(verdict.partial, two,
            fitted.two_mistakes()
                ? Meaning{b.page, b.name, b.what + "; and something else is wrong"}
                : Meaning{a.page, a.name, a.what + "; and " + b.what});
      return;
    }
    claim(!first_wrong                       ? verdict.conventions
          : general || fitted.two_mistakes() ? verdict.partial
                                             : verdict.causes,
          two, a);
    claim(second_wrong ? verdict.causes : verdict.conventions, two, b);
  }

  // And those that explain as much.
  void claim_one(const PathModel& best) const {
    const double tie = reading.tie();
    bool general = false;
    for (const PathModel& m : reading.models) {
      const bool first = &m == &best;
      const bool as_likely =
          m.deviance <= best.deviance + tie && m.plain_chi2 <= best.plain_chi2 + tie;
      // The noise of a simulation says nothing against the mistake.
      const bool as_close = m.chi2 <= best.chi2 && is_complete(m);
      if (m.kind != best.kind || !(as_likely || as_close) ||
          (!first && (general || best.edits > 1 || m.edits > 1))) {
        continue;
      }
      bool this_general = false;
      const std::vector<Meaning> names = meanings_of(m, this_general);
      general = general || (first && this_general);
      if (!first && this_general) {
        continue;  // explains the same with a free number
      }
      for (const Meaning& name : names) {
        claim(best.kind == ModelKind::convention ? verdict.conventions
              : general || best.two_mistakes()   ? verdict.partial
                                                 : verdict.causes,
              m, name);
      }
    }
    if (std::max(verdict.causes.size(), verdict.partial.size()) > most_named) {
      verdict.causes.clear();
      verdict.partial.clear();
    }
  }

  // Conventions are not wrong, so the noise of their simulation must not hide them.
  bool is_rival(const PathModel& m, Cause page) const {
    return m.kind == ModelKind::convention ? reading.is_like_noise(m)
                                           : is_near(m) && m.page != page;
  }

  // Mistakes of one kind that the noise does not tell apart.
  bool claim_kind() const {
    const PathModel& first = reading.models.front();
    const char* const what = kind_of(first.page);
    const bool alone = std::none_of(reading.models.begin(), reading.models.end(),
                                    [&](const PathModel& m) { return is_rival(m, first.page); });
    if (what == nullptr || !alone || !is_near(first) || !counts(first)) {
      return false;
    }
    claim(verdict.partial, first, {first.page, "kind", what});
    return true;
  }

  // A part of the light that has another factor.
  void claim_part() const {
    for (const PathModel& m : reading.models) {
      bool general = false;
      const std::vector<Meaning> names = meanings_of(m, general);
      if (general && m.free.size() <= 1 && counts(m) && is_complete(m)) {
        claim(verdict.partial, m, names.front());
        return;
      }
    }
  }
};

void explain(const TruthBlocks& back, const Reading& reading, PathVerdict& verdict) {
  if (reading.seen.relative_noise > too_much_noise || back.truth.blocks() < fewest_blocks ||
      !reading.differs()) {
    return;
  }
  const Explanation explanation{back, reading, verdict};
  const PathModel& best = explanation.best();
  verdict.chi2_per_value = best.chi2 / reading.values();
  const bool complete = explanation.is_complete(best);
  const std::optional<PathModel>& two = reading.two;
  const bool better =
      two && (!complete || (best.edits > 1 && best.chi2 > most_of_right * reading.values() &&
                            two->score() < best.score()));
  if (better && reading.is_complete(*two) && explanation.counts(*two)) {
    verdict.chi2_per_value = two->chi2 / reading.values();
    explanation.claim_pair(*two);
  } else if (!complete) {
    if (!explanation.claim_kind()) {
      explanation.claim_part();
    }
  } else if (explanation.counts(best)) {
    explanation.claim_one(best);
  }
}

// Kinds of light that have another factor, if that explains most of the difference.
void name_places(const Reading& reading, double chi2, PathVerdict& verdict) {
  const double n = reading.values();
  const double before = reading.right.fit.chi2;
  const bool is_linear = reading.screen.curve == ToneCurve::linear;
  const bool fits = chi2 < (is_linear ? max_noise : most_of_right) * n;
  const bool scale_is_known =
      !reading.any_exposure || (!verdict.places.empty() && verdict.places.front().factor == 1);
  if (chi2 - n > most_left * (before - n) || !fits || !scale_is_known) {
    return;
  }
  const PathPlace* worst = nullptr;
  double most = claim_errors;
  for (const PathPlace& place : verdict.places) {
    const double z = std::abs(place.factor - 1) / std::max(place.error, 1e-9);
    if (z > most && std::abs(place.factor - 1) > least_off) {
      most = z;
      worst = &place;
    }
  }
  if (worst != nullptr) {
    const bool missing = worst->factor < 0.05;
    const char* const relative = reading.any_exposure ? ", relative to direct light" : "";
    verdict.partial.push_back(
        {Cause::scattering, "light",
         missing ? fmt::format("{} is missing", worst->name)
                 : fmt::format("{} has the {}{}", worst->name,
                               factor_text(worst->factor, worst->error), relative),
         fmt::format("{:.0f} standard errors", most), 0});
  }
}

// Whether visible lamps have the bytes of values above 1 that wrap around.
bool wraps_around(const TruthBlocks& back, const DecodedPicture& mine, const Reading& reading) {
  constexpr std::size_t fewest = 12;
  constexpr double rounding = 3;  // of bytes: the truth's noise counts, too
  constexpr std::array<std::pair<double, double>, 3> ways{{{255, 0.5}, {255, 0}, {256, 0}}};
  std::array<std::size_t, ways.size()> same{};
  std::size_t count = 0;
  double low = 256;
  double high = 0;
  for (const std::size_t at : lamp_pixels(back)) {
    for (int c = 0; c < 3; ++c) {
      const double shown = reading.screen.unclamped(reading.exposure * back.truth.pixels[at][c]);
      if (shown < 1.05) {
        continue;
      }
      const double byte = mine.texture.rgb[3 * at + c];
      low = std::min(low, byte);
      high = std::max(high, byte);
      ++count;
      for (std::size_t way = 0; way < ways.size(); ++way) {
        const double expected = ways[way].first * shown + ways[way].second;
        const double off = std::remainder(byte + 0.5 - expected, 256.0);
        same[way] += std::abs(off) < rounding ? 1 : 0;
      }
    }
  }
  // One byte, as of a white lamp, may be that by chance.
  return count >= fewest && high - low > 2 * rounding &&
         static_cast<double>(*std::max_element(same.begin(), same.end())) >
             0.9 * static_cast<double>(count);
}

void name_lamps(const TruthBlocks& back, const DecodedPicture& mine, const Reading& reading,
                PathVerdict& verdict) {
  const bool alone = verdict.causes.empty() && verdict.partial.empty();
  std::vector<PathClaim>& list = alone ? verdict.causes : verdict.partial;
  const auto is_black = [](const PathClaim& claim) { return claim.page == Cause::black; };
  if (!mine.is_linear() && reading.screen.clamps() && wraps_around(back, mine, reading)) {
    list.push_back({Cause::overflow, "wrapped",
                    "values above 1 wrap around: only their lowest 8 bits are kept",
                    "visible lamps", 0});
  } else if (reading.lamps && reading.lamps->is_black() &&
             std::none_of(verdict.causes.begin(), verdict.causes.end(), is_black)) {
    list.push_back({Cause::path_length, "black-lamps",
                    "lamps that the camera sees are black: emission is not added at the first hit",
                    factor_text(reading.lamps->value, reading.lamps->error), 0});
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
bool explains(const TruthBlocks& back, const Reading& before, const Reading& other) {
  return 2 * other.seen.tested > before.seen.tested &&
         other.right.chi2 < max_noise * other.values() &&
         other.right.chi2 / other.values() < 0.05 * before.right.chi2 / before.values() &&
         back.truth.blocks() >= fewest_blocks_for_file;
}

// Whether another view does. Other angles move edges by few pixels, which may leave most blocks as
// they are: then nothing beyond noise may be left of a difference that is far above it.
bool view_explains(const TruthBlocks& back, const Reading& before, const Reading& other) {
  constexpr double far_above = 10;
  const double is = other.right.chi2 / other.values();
  const double was = before.right.chi2 / before.values();
  return explains(back, before, other) ||
         (2 * other.seen.tested > before.seen.tested && was > far_above &&
          is - 1 < 0.05 * (was - 1) && is < max_noise &&
          back.truth.blocks() >= fewest_blocks_for_file);
}

std::string view_words(const PathTruth& t, const ViewScale& view) {
  constexpr double degrees = 180 / std::numbers::pi;
  const double half = std::tan(t.height_angle / 2);
  const double aspect = double(t.width) / t.height;
  const auto angle = [](double tangent) { return 2 * degrees * std::atan(tangent); };
  constexpr double near = 0.01;
  if (std::abs(view.across / view.down - 1) > near) {
    return fmt::format(
        "the picture is stretched: its angle of view is {:.1f} x {:.1f} degrees, that of the scene "
        "{:.1f} x {:.1f}",
        angle(half * aspect / view.across), angle(half / view.down), angle(half * aspect),
        angle(half));
  }
  const double mine = half / view.down;
  std::string what =
      fmt::format("the height of the picture is an angle of {:.1f} degrees, not of {:.1f}",
                  angle(mine), angle(half));
  if (std::abs(mine / std::tan(t.height_angle) - 1) < near) {
    what += ": the angle is not halved";
  } else if (t.width != t.height && std::abs(mine * aspect / half - 1) < near) {
    what += ": that is the angle of the width";
  }
  return what;
}

// Mistakes in what is done with the picture, not in the light.
void explain_file(const TruthBlocks& back, const DecodedPicture& mine,
                  const std::vector<Reading>& readings, PathVerdict& verdict) {
  const Reading& reading = readings.front();
  constexpr std::array<std::tuple<Cause, const char*, const char*>, 3> ways{
      {{Cause::vertical_flip, "vertical-flip", "the picture is upside down"},
       {Cause::horizontal_flip, "horizontal-flip", "the picture is mirrored"},
       {Cause::swapped_channels, "swapped-channels", "red and blue are swapped"}}};
  for (std::size_t how = 0; how < ways.size(); ++how) {
    const DecodedPicture other = rearranged(mine, back.truth, static_cast<int>(how));
    const auto by = [&](const Reading& r) {
      return explains(back, reading, read_as(back, other, r.screen, r.any_exposure));
    };
    if (std::any_of(readings.begin(), readings.end(), by)) {
      const auto& [page, name, what] = ways[how];
      verdict.causes.push_back({page, name, what, "explains the difference", 1});
      return;
    }
  }
  const ViewScale view = fitted_view(back, reading);
  const LinearPicture pixels = with_right_view(back.truth, reading.picture, view);
  if (view_explains(back, reading, read_again(back, reading, pixels))) {
    verdict.causes.push_back(
        {Cause::camera, "view-angle", view_words(back.truth, view), "explains the difference", 1});
    return;
  }
  if (mine.is_linear()) {
    for (const Reading& other : readings_as_shown(back, mine)) {
      if (explains(back, reading, other)) {
        verdict.causes.push_back(
            {Cause::gamma, "gamma",
             fmt::format("the file should be linear, but has values for the screen, by {}",
                         other.screen.words()),
             "explains the difference", 1});
        return;
      }
    }
  }
}

// Whether some curve explains values of 8 bits as well as what was found in part, or far better
// than a cause.
bool has_other_curve(const TruthBlocks& back, const DecodedPicture& mine, const Reading& reading,
                     const PathVerdict& verdict) {
  if (mine.is_linear() || reading.seen.tested < fewest_blocks) {
    return false;
  }
  constexpr double about_as_well = 1.3;
  constexpr double far_better = 0.3;
  const auto left_by = [](const Reading& r) { return r.right.chi2 / r.values(); };
  const std::optional<Reading> other = read_by_any_curve(back, mine, reading);
  const double left = other ? left_by(*other) : 0;
  // A factor is a rising curve, too.
  const double by_exposure = left_by(read_as(back, mine, reading.screen, true));
  const double most =
      verdict.chi2_per_value * (verdict.causes.empty() ? about_as_well : far_better);
  return other && left < max_noise && left < most && about_as_well * left < by_exposure;
}

constexpr const char* growth =
    "light grows from bounce to bounce, as without the cosine, 1 / pi or the density of "
    "directions, or with a wrong probability of going on";

// Where noise hides all means: whether most pixels are too bright. Of skewed noise, as that of
// paths, the median is below the mean.
void name_growth(const TruthBlocks& back, const LinearPicture& picture, PathVerdict& verdict) {
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
  if (factor <= 1.3) {
    return;
  }
  verdict.too_noisy = false;
  const std::vector<GrowthMatch> matches = match_growth(back, picture);
  if (matches.empty() || matches.size() > most_named) {
    verdict.partial.push_back(
        {Cause::scattering, "light",
         fmt::format("most pixels are brighter than the truth, by a factor of at least {:.2f}, and "
                     "the noise is far too large: {}",
                     factor, growth),
         "median of pixels", 0});
    return;
  }
  for (const GrowthMatch& match : matches) {
    verdict.causes.push_back(
        {match.meaning.page, match.meaning.name, match.meaning.what,
         fmt::format("light grows from bounce to bounce: pixels are distributed as with this "
                     "mistake, {:.0f} samples and a probability of {:.2f} of going on",
                     match.samples, match.probability),
         0});
  }
}

// Why no block can be compared, among the claims that it belongs to.
void name_nothing(const TruthBlocks& back, const DecodedPicture& mine, PathVerdict& verdict) {
  double all = 0;  // without lamps
  double clipped = 0;
  double bright = 0;
  for (std::size_t b = 0; b < back.truth.blocks(); ++b) {
    for_each_pixel(back.truth, b, [&](int, int, std::size_t at) {
      if (back.left_out[b] == 0) {
        const auto* const rgb = &mine.texture.rgb[3 * at];
        const Color& truth = back.truth.pixels[at];
        ++all;
        clipped += std::max({rgb[0], rgb[1], rgb[2]}) == 255 ? 1 : 0;
        bright += std::max({truth.x, truth.y, truth.z}) >= 1 ? 1 : 0;
      }
    });
  }
  if (!mine.is_linear() && clipped > 0.05 * all && clipped > 2 * bright) {
    verdict.partial.push_back(
        {Cause::brightness, "clipped",
         fmt::format("{:.0f} % of the picture is as bright as the file can hold, while {:.0f} % of "
                     "the truth is above 1: direct light has too large a factor, or {}",
                     100 * clipped / all, 100 * bright / all, growth),
         "without visible lamps", 0});
  } else {
    verdict.notes.push_back({Cause::brightness, "nothing-to-compare",
                             "nothing can be compared: too many pixels are clipped or not finite, "
                             "or the picture is too "
                             "small, or shows only lamps and what is next to them",
                             "", 0});
  }
}

}  // namespace

PathVerdict judge_path(const PathTruth& truth, const DecodedPicture& mine) {
  PathVerdict verdict;
  const TruthBlocks back(truth);
  const std::vector<Reading> readings = readings_of(back, mine);
  verdict.columns = truth.columns;
  verdict.truth_samples = truth.samples;
  verdict.not_finite = mine.not_finite;
  verdict.significance.resize(truth.blocks());
  verdict.errors.resize(truth.blocks());
  verdict.mine.resize(truth.blocks());
  if (readings.empty() || readings.front().seen.tested == 0) {
    name_nothing(back, mine, verdict);
    return verdict;
  }
  const Reading& reading = readings.front();
  verdict.curve = reading.screen.words();
  verdict.samples = 1 / reading.seen.per_sample;
  verdict.tested = reading.seen.tested;
  verdict.clipped = reading.seen.clipped;
  verdict.critical = critical_value(0.01, reading.values() / 3);
  verdict.chi2_per_value = reading.right.chi2 / reading.values();
  const ModelSearch search(back, reading.seen, reading.any_exposure);
  double chi2 = 0;
  verdict.places = places_of(back, reading.seen.measured, chi2);
  add_energy(back, reading.seen.measured, verdict);
  const double scale = reading.any_exposure ? scale_of(reading, verdict.places) : 1;
  verdict.exposure = reading.any_exposure ? scale * reading.exposure : 1;
  for (PathPlace& place : verdict.places) {
    place.factor /= scale;
    place.error /= scale;
  }
  for (double& energy : verdict.energy_mine) {
    energy /= scale;
  }
  for (std::size_t b = 0; b < truth.blocks(); ++b) {
    const Color weight = reading.seen.cautious[b];
    if (weight == Color(0)) {
      continue;
    }
    const Color rest = search.residual(reading.right, b);
    const double variance = luminance(Color(1) / glm::max(weight, Color(1e-300)));
    verdict.significance[b] = luminance(rest) / std::sqrt(variance);
    verdict.errors[b] = std::sqrt(variance) / scale;
    verdict.mine[b] = reading.seen.measured.mean[b] / scale;
    if (std::abs(verdict.significance[b]) > verdict.largest) {
      verdict.largest = std::abs(verdict.significance[b]);
      verdict.largest_at = middle_of(truth, b);
    }
  }
  count_fireflies(back, reading.picture, verdict);
  const std::optional<double> cut =
      mine.is_linear() ? cut_off(back, reading.picture, reading.seen) : std::nullopt;
  const auto unexplained = [&] {
    return verdict.causes.empty() && verdict.conventions.empty() &&
           verdict.largest > verdict.critical;
  };
  if (!cut) {
    explain(back, reading, verdict);
  }
  const bool light_is_known = !unexplained() || !verdict.partial.empty();
  if (unexplained()) {
    explain_file(back, mine, readings, verdict);
  }
  if (!mine.is_linear() && reading.screen.curve == ToneCurve::power &&
      reading.screen.parameter == gamma_twice && verdict.causes.empty()) {
    verdict.causes.push_back({Cause::gamma, "gamma",
                              "gamma is applied twice: values are those of linear light to the "
                              "power of about 1 / 4.4",
                              "explains the picture as no other curve", 1});
  }
  if (cut && verdict.causes.empty()) {
    verdict.causes.push_back(
        {Cause::overflow, "clamped",
         fmt::format("no value is above {:.3g}: those of samples or pixels are cut off there",
                     *cut),
         "visible lamps", 1});
  }
  if (verdict.causes.empty() && verdict.conventions.empty()) {
    for (const PathModel& m : reading.models) {
      if (m.variant && reading.is_like_noise(m)) {
        verdict.noisy_variants.push_back(*m.variant);
      }
    }
  }
  const bool claims = !verdict.causes.empty() || !verdict.partial.empty();
  const bool other_curve =
      (claims || unexplained()) && has_other_curve(back, mine, reading, verdict);
  if (other_curve) {
    verdict.causes.clear();
    verdict.partial.clear();
    verdict.conventions.clear();
    verdict.places.clear();
    verdict.energy_mine.clear();
    verdict.notes.push_back(
        {Cause::gamma, "tone-curve",
         "the picture fits the truth with a tone curve that is none of those that are known, which "
         "may also hide a mistake; a linear picture (PFM or EXR) would tell",
         "", 0});
  } else if (!verdict.causes.empty()) {
    verdict.partial.clear();
  } else if (verdict.partial.empty() && unexplained()) {
    name_places(reading, chi2, verdict);
    if (verdict.partial.empty() && has_shared_noise(back, reading, verdict, chi2)) {
      verdict.causes.push_back({Cause::samples, "same-numbers",
                                "neighboring pixels have the same noise, as if every pixel used "
                                "the same random numbers",
                                "most blocks differ, to both sides", 0});
    }
  }
  // In a picture that nothing explains, something else may be where lamps should be.
  if (light_is_known || other_curve) {
    name_lamps(back, mine, reading, verdict);
  }
  const bool explained_by_convention = !verdict.conventions.empty();
  const std::vector<const BlockColors*> shifts = gradients(back, reading.seen.measured);
  const auto shift = [&](const BlockColors& gradient) {
    const auto column = std::find(shifts.begin(), shifts.end(), &gradient);
    if (column == shifts.end() || !reading.right.fit.solved) {
      return 0.0;
    }
    const auto at = reading.right.free.size() + static_cast<std::size_t>(column - shifts.begin());
    const double value = reading.right.fit.factors[at];
    return std::abs(value) > 0.25 && std::abs(value) > claim_errors * reading.right.fit.errors[at]
               ? value
               : 0;
  };
  const double right = -shift(back.gradient_x);
  const double down = -shift(back.gradient_y);
  if (verdict.causes.empty() && verdict.partial.empty() && !other_curve &&
      (right != 0 || down != 0)) {
    verdict.conventions.push_back(
        {Cause::half_pixel_shift, "pixel-corners",
         "the picture is shifted by a part of a pixel, as if rays went through the corners of "
         "pixels",
         fmt::format("{:.2f} to the right, {:.2f} down", right, down), 0});
  }
  if (verdict.causes.empty() && verdict.partial.empty()) {
    const double shown =
        explained_by_convention ? verdict.chi2_per_value : reading.right.chi2 / reading.values();
    const double error = largest_error(verdict.places);
    constexpr double hidden = 0.3;                // a factor that noise may hide
    const double limit = 1.5 * verdict.critical;  // caustics have heavy tails
    if (reading.seen.relative_noise > too_much_noise ||
        (claim_errors * error > hidden && shown < most_of_right && verdict.largest < limit)) {
      verdict.too_noisy = true;
      count_samples(back, reading.seen, error, hidden / claim_errors, verdict);
      name_growth(back, reading.picture, verdict);
    } else {
      verdict.right = shown < most_of_right && (explained_by_convention || verdict.largest < limit);
    }
  }
  // Factors of kinds of light that leave more do not describe the picture.
  if (chi2 >= max_noise * reading.values()) {
    verdict.places.clear();
  }
  return verdict;
}

}  // namespace scenefile
