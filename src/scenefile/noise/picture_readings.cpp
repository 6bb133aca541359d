#include "scenefile/noise/picture_readings.h"

#include "scenefile/noise/judge_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace scenefile {

namespace {

// Of the difference, what a known mistake may leave without its own noise.
constexpr double most_plain = 0.4;

constexpr std::size_t levels = 256;  // of 8-bit values

// The median factor of blocks, 1 if there is none.
double typical_factor(const TruthBlocks& back, const LinearPicture& picture) {
  std::vector<double> ratios;
  for (std::size_t b = 0; b < back.truth.blocks(); ++b) {
    double mine = 0;
    double truth = 0;
    for_each_pixel(back.truth, b, [&](int, int, std::size_t at) {
      if (picture.usable[at] != 0) {
        mine += luminance(picture.pixels[at]);
        truth += luminance(back.truth.pixels[at]);
      }
    });
    if (back.left_out[b] == 0 && mine > 0 && truth > 0) {
      ratios.push_back(mine / truth);
    }
  }
  return ratios.empty() ? 1 : median_of(std::move(ratios));
}

void add_models(const TruthBlocks& back, Reading& reading) {
  // Under the other curves, samples would have a tone as well as the picture.
  const bool toned = reading.screen.curve == ToneCurve::linear || reading.screen.clamps();
  reading.models = ModelSearch(back, reading.seen, reading.any_exposure).models(toned);
  std::sort(reading.models.begin(), reading.models.end(),
            [](const PathModel& a, const PathModel& b) { return a.score() < b.score(); });
}

void add_pair(const TruthBlocks& back, Reading& reading) {
  if (!reading.differs()) {
    return;
  }
  const double most = reading.models.front().deviance + reading.tie();
  const auto alone = [&](const PathModel& m) {
    return m.edits == 1 && m.deviance < most && reading.is_complete(m);
  };
  if (std::none_of(reading.models.begin(), reading.models.end(), alone)) {
    reading.two = ModelSearch(back, reading.seen, reading.any_exposure).pair(reading.models);
  }
}

// None if the picture shows too little of lamps, or they are clipped.
std::optional<LampFactor> lamp_factor(const TruthBlocks& back, const LinearPicture& picture) {
  constexpr double of_programs = 0.01;
  constexpr std::size_t fewest = 4;
  double sum = 0;
  double weights = 0;
  const std::vector<std::size_t> pixels = lamp_pixels(back);
  for (int c = 0; c < 3; ++c) {
    std::vector<double> ratios;
    std::vector<double> variances;
    for (const std::size_t at : pixels) {
      const double truth = back.truth.pixels[at][c];
      if (picture.usable[at] != 0 && truth > 0) {
        ratios.push_back(picture.pixels[at][c] / truth);
        variances.push_back(picture.rounding[at][c] / (truth * truth));
      }
    }
    if (ratios.size() >= fewest) {
      // All pixels of a lamp are rounded alike, so their number does not reduce the error.
      const double weight = 1 / (1e-12 + median_of(std::move(variances)));
      sum += weight * median_of(std::move(ratios));
      weights += weight;
    }
  }
  std::vector<double> brightest;  // of a pixel's channels
  for (const std::size_t at : pixels) {
    const std::size_t b = block_of(back.truth, at);
    double most = 0;
    for (int c = 0; c < 3; ++c) {
      const double reflected = back.all[b][c] - back.lamp[b][c];
      most = std::max(most, picture.pixels[at][c] / std::max(1e-9, reflected));
    }
    brightest.push_back(most);
  }
  return weights > 0 ? std::optional<LampFactor>(
                           {sum / weights, std::sqrt(of_programs * of_programs + 1 / weights),
                            median_of(std::move(brightest))})
                     : std::nullopt;
}

// Whether the exposure is one of lamps, too: not if these have the brightness of the truth.
bool has_exposure(const Reading& reading) {
  const std::optional<LampFactor>& lamps = reading.lamps;
  return !lamps || is_number(lamps->value, lamps->error, reading.right.factor()) ||
         !is_number(lamps->value, lamps->error, 1 / reading.exposure);
}

// The white of the course's curve for which visible lamps have their emission.
std::optional<double> white_by_lamps(const TruthBlocks& back, const DecodedPicture& mine,
                                     ToneCurve curve) {
  std::vector<double> whites;
  for (const std::size_t at : lamp_pixels(back)) {
    const double bright = luminance(back.truth.pixels[at]);
    const std::uint8_t* rgb = &mine.texture.rgb[3 * at];
    const Color shown = glm::dvec3(rgb[0], rgb[1], rgb[2]) / 255.0;
    const double value = luminance(curve == ToneCurve::course ? shown * shown : shown);
    // value = L (1 + L / w^2) / (1 + L)
    const double square = bright * bright / std::max(1e-9, value * (1 + bright) - bright);
    whites.push_back(value >= 0.99 ? bright : std::max(bright, std::sqrt(std::min(square, 1e12))));
  }
  return whites.size() < 4 ? std::nullopt : std::optional<double>(median_of(whites));
}

// The white for which the picture is most like the truth, or the truth with a factor.
double fitted_white(const TruthBlocks& back, const DecodedPicture& mine, ToneCurve curve,
                    bool any_exposure) {
  double best = 1;
  double least = 1e300;
  for (double white = 0.05; white < 2000; white *= 1.2) {
    Reading reading = read_as(back, mine, {curve, white}, any_exposure);
    reading.models.push_back({ModelKind::mistake,
                              Cause::light_samples,
                              "direct",
                              "",
                              combined(back.lamp, 1, back.hit),
                              {back.sampled}});
    ModelSearch(back, reading.seen, any_exposure).solve(reading.models.front());
    if (reading.cost() < least) {
      least = reading.cost();
      best = white;
    }
  }
  return best;
}

// The same with the best explanations: those that are not factors of direct light bend the white.
double refitted_white(const TruthBlocks& back, const DecodedPicture& mine, const Reading& before) {
  constexpr std::size_t few = 4;
  const std::size_t count = std::min(few, before.models.size());
  double best = before.screen.parameter;
  double least = 1e300;
  double step = 1.1;
  for (int round = 0; round < 2; ++round) {
    const double middle = best;
    for (int i = -10; i <= 10; ++i) {
      const double white = middle * std::pow(step, i);
      Reading reading = read_as(back, mine, {before.screen.curve, white}, before.any_exposure);
      const ModelSearch search(back, reading.seen, before.any_exposure);
      reading.models.assign(before.models.begin(),
                            before.models.begin() + static_cast<std::ptrdiff_t>(count));
      for (PathModel& m : reading.models) {
        m.noise.clear();  // of another factor
        search.solve(m);
      }
      if (reading.cost() < least) {
        least = reading.cost();
        best = white;
      }
    }
    step = 1.01;
  }
  return best;
}

// What is left of the difference by the right picture or a mistake, which needs more evidence, and
// two even more.
double left_of(const Reading& reading) {
  double least = reading.right.chi2;
  for (const PathModel& m : reading.models) {
    // Not what only the noise of the model could explain.
    if (m.plain_chi2 < most_plain * reading.right.chi2) {
      least = std::min(least, 2 * m.chi2);
    }
  }
  if (reading.two) {
    least = std::min(least, 3 * reading.two->chi2);
  }
  return least / reading.values();
}

// Calls visit(curve, any_exposure) for all curves of values for the screen.
template <typename Visit>
void for_each_curve(const TruthBlocks& back, const DecodedPicture& mine, bool any_exposure,
                    const Visit& visit) {
  constexpr std::array others{ScreenCurve{ToneCurve::srgb}, ScreenCurve{ToneCurve::clamp},
                              ScreenCurve{ToneCurve::power, 2.2}, ScreenCurve{ToneCurve::power, 2},
                              ScreenCurve{ToneCurve::power, gamma_twice}};
  for (const ToneCurve curve : {ToneCurve::course, ToneCurve::compressed}) {
    const double white = white_by_lamps(back, mine, curve).value_or(0);
    visit({curve, white > 0 ? white : fitted_white(back, mine, curve, any_exposure)}, any_exposure);
  }
  for (const ToneCurve curve : {ToneCurve::reinhard, ToneCurve::luminance, ToneCurve::film}) {
    for (const double gamma : {2.2, srgb_gamma, 2.0, 1.0}) {
      visit({curve, gamma}, any_exposure);
    }
  }
  for (const ScreenCurve& screen : others) {
    visit(screen, any_exposure);
  }
}

void sort_by_cost(std::vector<Reading>& readings) {
  std::stable_sort(readings.begin(), readings.end(),
                   [](const Reading& a, const Reading& b) { return a.cost() < b.cost(); });
}

// By 8-bit value the factor, piecewise linear, that brings the blocks of the picture nearest to the
// truth, in all channels; empty if there is none.
std::vector<double> curve_factors(const TruthBlocks& back, const DecodedPicture& mine,
                                  const Reading& reading) {
  const BlockColors& weight = reading.seen.measured.weight;
  const auto for_each_value = [&](const auto& visit) {
    for (std::size_t b = 0; b < weight.size(); ++b) {
      for_each_pixel(back.truth, b, [&](int, int, std::size_t at) {
        for (int c = 0; c < 3 && weight[b] != Color(0); ++c) {
          visit(b, c, mine.texture.rgb[3 * at + c], reading.picture.pixels[at][c]);
        }
      });
    }
  };
  // As many values from each knot to the next.
  std::vector<std::uint8_t> values;
  for_each_value([&](std::size_t, int, std::uint8_t v, double) { values.push_back(v); });
  std::sort(values.begin(), values.end());
  constexpr std::size_t parts = 16;
  std::vector<double> knots;
  for (std::size_t k = 0; k <= parts && !values.empty(); ++k) {
    const double knot = values[k * (values.size() - 1) / parts];
    if (knots.empty() || knot > knots.back()) {
      knots.push_back(knot);
    }
  }
  const auto hat = [&](std::size_t k, double v) {
    const double up = k == 0 ? 1 : (v - knots[k - 1]) / (knots[k] - knots[k - 1]);
    const double down = k + 1 == knots.size() ? 1 : (knots[k + 1] - v) / (knots[k + 1] - knots[k]);
    return std::clamp(std::min(up, down), 0.0, 1.0);
  };
  std::vector<BlockColors> lights(knots.size(), back.zero);
  for_each_value([&](std::size_t b, int c, std::uint8_t v, double light) {
    for (std::size_t k = 0; k < knots.size(); ++k) {
      lights[k][b][c] += hat(k, v) * light / back.pixels[b];
    }
  });
  std::vector<const BlockColors*> columns;
  for (const BlockColors& light : lights) {
    columns.push_back(&light);
  }
  const BlockFit found = fit({back.all, weight}, back.zero, columns);
  std::vector<double> factors(found.solved ? levels : 0);
  for (std::size_t v = 0; v < factors.size(); ++v) {
    for (std::size_t k = 0; k < knots.size(); ++k) {
      factors[v] += found.factors[k] * hat(k, double(v));
    }
  }
  return factors;
}

// The rising values that are nearest to these (isotonic regression).
void make_rising(std::vector<double>& values) {
  struct Run {
    double sum = 0;
    double count = 0;
    double mean() const { return sum / count; }
  };
  std::vector<Run> runs;
  for (const double value : values) {
    runs.push_back({value, 1});
    while (runs.size() > 1 && runs[runs.size() - 2].mean() > runs.back().mean()) {
      const Run last = runs.back();
      runs.pop_back();
      runs.back().sum += last.sum;
      runs.back().count += last.count;
    }
  }
  std::size_t at = 0;
  for (const Run& run : runs) {
    for (double i = 0; i < run.count; ++i) {
      values[at++] = run.mean();
    }
  }
}

bool is_mostly_clipped(const TruthBlocks& back, const Reading& reading) {
  const auto candidates = std::count(back.left_out.begin(), back.left_out.end(), 0);
  return 3 * reading.seen.tested <= static_cast<std::size_t>(candidates);
}

}  // namespace

double Reading::explained(const PathModel& m) const {
  const double n = values();
  return right.chi2 > n
             ? std::clamp((right.chi2 - std::max(m.chi2, n)) / (right.chi2 - n), 0.0, 1.0)
             : 0;
}

bool Reading::differs() const {
  return !models.empty() && right.chi2 - models.front().chi2 >= claim_errors * claim_errors;
}

bool Reading::is_like_noise(const PathModel& m) const {
  return explained(m) >= 1 - most_left && m.chi2 < max_noise * values();
}

bool Reading::is_complete(const PathModel& m) const {
  const double plain = m.plain_chi2 / right.chi2;
  // Of a difference far above noise, small differences of programs are far above it, too: a tenth
  // of the most that may be left otherwise is no less evidence.
  constexpr double far_above = most_left / 10;
  return (is_like_noise(m) && plain < most_plain) ||
         (explained(m) >= 1 - far_above && plain < 0.05 && !m.two_mistakes());
}

double Reading::tie() const {
  return std::max(25.0, 0.004 * (right.chi2 - models.front().chi2));
}

double Reading::cost() const {
  // A fitted exposure must explain clearly more, and other curves than the course's.
  const double less_usual = std::log(1.3);
  constexpr double like_noise = 0.2;  // far below 1, less is no better
  return std::log(left_of(*this) + like_noise) + seen.log_variance +
         (any_exposure ? less_usual : 0) + (screen.curve == ToneCurve::course ? 0 : less_usual);
}

bool is_number(double value, double error, double constant) {
  return std::abs(value / constant - 1) < std::max(0.012, 3 * error / constant);
}

std::vector<std::size_t> lamp_pixels(const TruthBlocks& back) {
  const PathTruth& t = back.truth;
  std::vector<std::size_t> pixels;
  for (std::size_t at = 0; at < t.pixels.size(); ++at) {
    const std::size_t block = block_of(t, at);
    const double bright = luminance(t.pixels[at]);
    constexpr double varied = 0.05;  // the most by which its samples differ
    if (luminance(back.lamp[block]) > 0 && bright > 0 &&
        luminance(t.sample_variances[at]) <= varied * varied * bright * bright) {
      pixels.push_back(at);
    }
  }
  return pixels;
}

Reading read_as(const TruthBlocks& back, const DecodedPicture& mine, const ScreenCurve& screen,
                bool any_exposure) {
  Reading reading;
  reading.screen = screen;
  reading.any_exposure = any_exposure;
  reading.picture = linearized(mine, screen);
  const double typical = typical_factor(back, reading.picture);
  if (any_exposure) {
    reading.exposure = typical;
    for (std::size_t at = 0; at < reading.picture.pixels.size(); ++at) {
      reading.picture.pixels[at] /= reading.exposure;
      reading.picture.rounding[at] /= reading.exposure * reading.exposure;
    }
  }
  reading.lamps = lamp_factor(back, reading.picture);
  // Otherwise a mistake with a factor above 1 would seem to leave less noise than the exposure.
  const bool is_exposed =
      screen.curve == ToneCurve::film ||  // of exposures, and shows no lamps
      (reading.lamps && is_number(reading.lamps->value, reading.lamps->error, typical));
  reading.seen =
      observe(back, reading.picture, !any_exposure && is_exposed ? std::max(1.0, typical) : 1);
  reading.right = ModelSearch(back, reading.seen, any_exposure).right();
  return reading;
}

Reading read_again(const TruthBlocks& back, const Reading& before, LinearPicture pixels) {
  Reading reading;
  reading.screen = before.screen;
  reading.any_exposure = before.any_exposure;
  reading.exposure = before.exposure;
  reading.picture = std::move(pixels);
  reading.lamps = lamp_factor(back, reading.picture);
  reading.seen = observe(back, reading.picture);
  reading.right = ModelSearch(back, reading.seen, before.any_exposure).right();
  return reading;
}

std::optional<Reading> read_by_any_curve(const TruthBlocks& back, const DecodedPicture& mine,
                                         const Reading& before) {
  DecodedPicture ramp;
  for (std::size_t v = 0; v < levels; ++v) {
    ramp.texture.rgb.insert(ramp.texture.rgb.end(), 3, static_cast<std::uint8_t>(v));
  }
  const std::vector<Color> grays = linearized(ramp, before.screen).pixels;
  std::vector<double> factors(levels, 1);
  Reading reading = before;
  // Again with the weights of the first curve.
  for (int round = 0; round < 2; ++round) {
    const std::vector<double> more = curve_factors(back, mine, reading);
    if (more.empty()) {
      return std::nullopt;
    }
    std::vector<double> curve(levels);
    for (std::size_t v = 0; v < levels; ++v) {
      curve[v] = factors[v] * more[v] * grays[v].x;
    }
    make_rising(curve);
    for (std::size_t v = 0; v < levels; ++v) {
      factors[v] = grays[v].x > 0 ? curve[v] / grays[v].x : 1;
    }
    LinearPicture pixels = before.picture;
    for (std::size_t at = 0; at < pixels.pixels.size(); ++at) {
      for (int c = 0; c < 3; ++c) {
        const double by = factors[mine.texture.rgb[3 * at + c]];
        pixels.pixels[at][c] *= by;
        pixels.rounding[at][c] *= by * by;
      }
    }
    reading = read_again(back, before, std::move(pixels));
  }
  return reading;
}

std::vector<Reading> readings_of(const TruthBlocks& back, const DecodedPicture& mine) {
  std::vector<Reading> list;
  const auto add = [&](const ScreenCurve& screen, bool any_exposure) {
    Reading reading = read_as(back, mine, screen, any_exposure);
    if (mine.is_linear() ||
        (!is_mostly_clipped(back, reading) && (!any_exposure || has_exposure(reading)))) {
      add_models(back, reading);
      const bool has_white =
          screen.curve == ToneCurve::course || screen.curve == ToneCurve::compressed;
      if (has_white && reading.differs() && !white_by_lamps(back, mine, screen.curve)) {
        const double white = refitted_white(back, mine, reading);
        reading = read_as(back, mine, {screen.curve, white}, any_exposure);
        add_models(back, reading);
      }
      list.push_back(std::move(reading));
    }
  };
  if (mine.is_linear()) {
    add({}, false);
  } else {
    for_each_curve(back, mine, false, add);
    for_each_curve(back, mine, true, add);
  }
  sort_by_cost(list);
  constexpr std::size_t likely = 4;
  for (std::size_t i = 0; i < std::min(likely, list.size()); ++i) {
    add_pair(back, list[i]);
  }
  sort_by_cost(list);
  return list;
}

std::vector<Reading> readings_as_shown(const TruthBlocks& back, const DecodedPicture& mine) {
  std::vector<Reading> list;
  for_each_curve(back, mine, false, [&](const ScreenCurve& screen, bool any_exposure) {
    Reading reading = read_as(back, mine, screen, any_exposure);
    if (!is_mostly_clipped(back, reading)) {
      list.push_back(std::move(reading));
    }
  });
  sort_by_cost(list);
  return list;
}

}  // namespace scenefile
