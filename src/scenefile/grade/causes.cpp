#include "scenefile/grade/causes.h"

#include "scenefile/grade/acne.h"
#include "scenefile/grade/hypotheses.h"
#include "scenefile/grade/likeness.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <optional>

namespace scenefile {

namespace {

constexpr double enough_alone = 0.6;     // share of the difference that a single mistake explains
constexpr double enough_together = 0.8;  // ... that two explain
constexpr double left_by_second = 0.4;   // what a second mistake may leave of what the first leaves
constexpr double least_left = 0.02;      // ... which must be worth a look
constexpr double worth_pairing = 0.2;    // what the better of two mistakes explains alone
constexpr double rival_margin = 0.03;
constexpr double most_unlike = 0.1;  // share of pixels where the scene may not be the reference
constexpr std::size_t few_pixels = 12;

// Large pictures are looked at in every third or fifth pixel across and down.
int step_for(int width) {
  return width <= 400 ? 1 : width <= 1200 ? 3 : 5;
}

// The camera of a thinned picture: its rays are those of the pixels that were kept.
RenderCamera thinned_camera(const RenderCamera& full, const Texture& picture, const Texture& thin,
                            int step, const glm::dvec2& shift) {
  const double tangent = std::tan(full.fov_y / 2);
  const double spread = 2 * tangent / picture.height;
  const double right = (step * thin.width - picture.width) / 2.0 + shift.x;
  const double down = (step * thin.height - picture.height) / 2.0 + shift.y;
  RenderCamera camera = full;
  camera.fov_y = 2 * std::atan(tangent * step * thin.height / picture.height);
  camera.w -= spread * (right * full.u - down * full.v);
  return camera;
}

// One ray a pixel; nothing when the scene cannot be drawn.
std::optional<Texture> drawn(const Trial& trial, const Assets& assets, const Texture& full,
                             const Texture& thin, int step) {
  RenderOptions options = trial.options;
  options.features.super_sample = false;
  options.samples = 4;
  options.width = thin.width;
  options.height = thin.height;
  RenderScene scene = trial.scene;
  scene.camera = thinned_camera(scene.camera, full, thin, step, trial.shift);
  const RenderResult result = render(scene, assets, options);
  if (result.status == RenderStatus::failed) {
    throw std::bad_alloc();
  }
  if (result.status != RenderStatus::complete) {
    return std::nullopt;
  }
  return quantize(result.image, rounding_of(options.profile));
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

// Pictures that the test may be, if a mistake was made.
using Predictions = std::vector<Texture>;

struct Tried {
  const Hypothesis* hypothesis = nullptr;
  Predictions predictions;
  double strict = 0;  // shares of the difference that are explained
  double tolerant = 0;

  bool geometric() const { return hypothesis->cause == Cause::half_pixel_shift; }
  double explained() const { return geometric() ? strict : tolerant; }
};

class Search {
 public:
  Search(const Texture& reference, const Texture& test, const SceneView* view,
         const std::function<bool(double)>& go_on)
      : full_(reference),
        step_(step_for(reference.width)),
        reference_(thinned(reference, step_)),
        test_(thinned(test, step_)),
        view_(view),
        go_on_(go_on),
        on_pictures_(picture_hypotheses()) {}

  CauseReport run() {
    clean_ = {reference_};
    base_strict_ = strict_distance(test_, reference_);
    base_tolerant_ = tolerant_distance(test_, reference_);
    look_at_scene();
    report_.share_different = share(base_tolerant_);
    if (base_strict_.pixels < few_pixels) {
      return report_;
    }
    if (usable_) {
      on_drawings_ = drawing_hypotheses(*view_);
    }
    try_each();
    choose();
    return report_;
  }

 private:
  double share(const Distance& distance) const {
    return static_cast<double>(distance.pixels) / (static_cast<double>(test_.rgb.size()) / 3);
  }

  bool significant() const { return base_tolerant_.pixels >= few_pixels; }

  bool step(double done) {
    stopped_ = stopped_ || (go_on_ && !go_on_(done));
    return !stopped_;
  }

  std::optional<Texture> draw(const Trial& trial) const {
    return drawn(trial, *view_->assets, full_, reference_, step_);
  }

  Trial right_trial() const { return {*view_->scene, view_->options, {}}; }

  void look_at_scene() {
    if (view_ == nullptr) {
      return;
    }
    const std::optional<Texture> drawn = draw(right_trial());
    if (!drawn) {
      return;
    }
    const Distance unlike = tolerant_distance(reference_, *drawn);
    report_.share_scene_unlike = share(unlike);
    usable_ = report_.share_scene_unlike <= most_unlike;
    if (usable_) {
      clean_.push_back(*drawn);
      const Distance strict = strict_distance(test_, *drawn);
      const Distance tolerant = tolerant_distance(test_, *drawn);
      base_strict_ = strict.sum < base_strict_.sum ? strict : base_strict_;
      base_tolerant_ = tolerant.sum < base_tolerant_.sum ? tolerant : base_tolerant_;
    }
  }

  // What the test would be: the changed drawing, or the reference with the change added to it.
  Predictions predict(const Texture& drawn) const {
    Texture changed = reference_;
    for (std::size_t i = 0; i < changed.rgb.size(); ++i) {
      const int value = int{reference_.rgb[i]} + drawn.rgb[i] - clean_[1].rgb[i];
      changed.rgb[i] = static_cast<std::uint8_t>(std::clamp(value, 0, 255));
    }
    return {drawn, changed};
  }

  // The picture of several hypotheses at once; nothing when it cannot be drawn.
  Predictions predict(const std::vector<const Hypothesis*>& together) const {
    Predictions predictions = clean_;
    if (std::any_of(together.begin(), together.end(),
                    [](const Hypothesis* h) { return bool(h->draw); })) {
      Trial trial = right_trial();
      for (const Hypothesis* hypothesis : together) {
        if (hypothesis->draw) {
          hypothesis->draw(trial);
        }
      }
      const std::optional<Texture> drawn = draw(trial);
      predictions = drawn ? predict(*drawn) : Predictions();
    }
    for (const Hypothesis* hypothesis : together) {
      if (hypothesis->picture) {
        std::transform(predictions.begin(), predictions.end(), predictions.begin(),
                       hypothesis->picture);
      }
    }
    return predictions;
  }

  double explained(const Predictions& predictions, const Distance& base,
                   Distance (*distance)(const Texture&, const Texture&)) const {
    double least = base.sum;
    for (const Texture& prediction : predictions) {
      least = std::min(least, distance(test_, prediction).sum);
    }
    return base.sum > 0 ? 1 - least / base.sum : 0;
  }

  Tried tried(const Hypothesis& hypothesis) const {
    Tried result{&hypothesis, predict({&hypothesis}), 0, 0};
    result.strict = explained(result.predictions, base_strict_, strict_distance);
    if (significant()) {
      result.tolerant = explained(result.predictions, base_tolerant_, tolerant_distance);
    }
    return result;
  }

  void try_each() {
    const double count = static_cast<double>(on_pictures_.size() + on_drawings_.size());
    for (const std::vector<Hypothesis>* list : {&on_pictures_, &on_drawings_}) {
      for (const Hypothesis& hypothesis : *list) {
        if (step(0.8 * static_cast<double>(tried_.size()) / count)) {
          tried_.push_back(tried(hypothesis));
        }
      }
    }
  }

  void choose() {
    std::stable_sort(tried_.begin(), tried_.end(),
                     [](const Tried& a, const Tried& b) { return a.explained() > b.explained(); });
    prefer_geometry_by_the_strict_measure();
    if (tried_.empty()) {
      return;
    }
    const double best = tried_.front().explained();
    if (significant() && best < 1 - least_left && (claim_acne(best) || claim_pair(best))) {
      return;
    }
    if (best >= enough_alone) {
      report_.claims.push_back(claim(tried_.front(), best));
      add_rivals(best);
    }
  }

  // Shifts are measured by edges, which the tolerant measure does not see; what explains edges and
  // all goes first.
  void prefer_geometry_by_the_strict_measure() {
    const auto shift =
        std::find_if(tried_.begin(), tried_.end(), [](const Tried& t) { return t.geometric(); });
    if (shift == tried_.end()) {
      return;
    }
    const bool beaten = std::any_of(tried_.begin(), tried_.end(), [&](const Tried& t) {
      return !t.geometric() && t.tolerant >= enough_alone && t.strict > shift->strict;
    });
    if (beaten || shift->strict < enough_alone) {
      tried_.erase(std::remove_if(tried_.begin(), tried_.end(),
                                  [](const Tried& t) { return t.geometric(); }),
                   tried_.end());
    } else {
      std::rotate(tried_.begin(), shift, shift + 1);
    }
  }

  Claim claim(const Tried& t, double share) const {
    const Distance& base = t.geometric() ? base_strict_ : base_tolerant_;
    const double values = static_cast<double>(test_.rgb.size());
    const std::string where = t.geometric() ? "" : " beyond edges and rounding";
    return {
        t.hypothesis->cause, t.hypothesis->what,
        fmt::format("made on purpose, it leaves {:.3f}/255 of a mean difference of {:.3f}/255{}",
                    (1 - share) * base.sum / values, base.sum / values, where),
        share};
  }

  void add_rivals(double best) {
    for (std::size_t i = 1; i < tried_.size() && report_.rivals.size() < 3; ++i) {
      const Tried& t = tried_[i];
      const bool other = t.hypothesis->cause != tried_.front().hypothesis->cause;
      if (other && !t.geometric() && t.tolerant >= std::max(best - rival_margin, enough_alone)) {
        report_.rivals.push_back(claim(t, t.tolerant));
      }
    }
  }

  bool claim_acne(double best) {
    if (!usable_ || !view_->options.features.shadows || view_->options.mode != Mode::ray) {
      return false;
    }
    Trial dark = right_trial();
    dark.scene.lights.clear();
    const std::optional<Texture> drawn = draw(dark);
    if (!drawn) {
      return false;
    }
    const AcneEvidence evidence = look_for_acne(test_, clean_[1], *drawn);
    if (evidence.between < 0.85 || evidence.scattered < 0.4 || evidence.between < best) {
      return false;
    }
    report_.claims.push_back(
        {Cause::acne,
         "surfaces shadow themselves in spots (shadow acne): start rays off the surface",
         fmt::format("{} of the pixels that differ lie between the lit and the shadowed surface, "
                     "scattered among right ones",
                     percent(evidence.between)),
         evidence.between});
    return true;
  }

  // Two mistakes at once: where one alone explains much, that one with any other; else one that
  // changes the finished picture with any other, or two of the best.
  bool claim_pair(double best) {
    std::vector<const Hypothesis*> pair;
    double most = std::max(enough_together, 1 - left_by_second * (1 - best));
    const auto attempt = [&](const Hypothesis& a, const Hypothesis& b, const Predictions& p) {
      const double share = explained(p, base_tolerant_, tolerant_distance);
      if (a.cause != b.cause && share > most) {
        most = share;
        pair = {&a, &b};
      }
    };
    const Hypothesis* const only = best >= enough_alone ? tried_.front().hypothesis : nullptr;
    pair_with_pictures(only, attempt);
    if (best >= worth_pairing && (only == nullptr || only->draw)) {
      pair_drawings(only == nullptr ? 3 : 1, attempt);
    }
    for (const Hypothesis* hypothesis : pair) {
      const auto alone = std::find_if(tried_.begin(), tried_.end(),
                                      [&](const Tried& t) { return t.hypothesis == hypothesis; });
      Claim one = claim(*alone, alone->tolerant);
      one.evidence = fmt::format("together they explain {} of the difference; alone {}",
                                 percent(most), percent(std::max(0.0, alone->tolerant)));
      report_.claims.push_back(std::move(one));
    }
    return !pair.empty();
  }

  template <typename F>
  void pair_with_pictures(const Hypothesis* only, const F& attempt) const {
    for (const Tried& t : tried_) {
      for (const Hypothesis& last : on_pictures_) {
        const bool wanted = only == nullptr || only == t.hypothesis || only == &last;
        if (wanted && t.hypothesis->draw && !t.geometric()) {
          Predictions predictions = t.predictions;
          std::transform(predictions.begin(), predictions.end(), predictions.begin(), last.picture);
          attempt(*t.hypothesis, last, predictions);
        }
      }
    }
  }

  template <typename F>
  void pair_drawings(std::size_t firsts, const F& attempt) {
    std::vector<const Hypothesis*> drawn;
    for (const Tried& t : tried_) {
      if (t.hypothesis->draw && !t.geometric()) {
        drawn.push_back(t.hypothesis);
      }
    }
    for (std::size_t i = 0; i < std::min(drawn.size(), firsts); ++i) {
      for (std::size_t j = i + 1; j < drawn.size() && step(0.9); ++j) {
        attempt(*drawn[i], *drawn[j], predict({drawn[i], drawn[j]}));
      }
    }
  }

  const Texture& full_;
  int step_;
  Texture reference_;
  Texture test_;
  const SceneView* view_;
  const std::function<bool(double)>& go_on_;
  std::vector<Hypothesis> on_pictures_;
  std::vector<Hypothesis> on_drawings_;
  std::vector<Tried> tried_;
  Predictions clean_;  // the reference, and our drawing where it is like it
  Distance base_strict_;
  Distance base_tolerant_;
  bool usable_ = false;
  bool stopped_ = false;
  CauseReport report_;
};

// Values that are one off, to the one side and the other, and those further off.
struct Steps {
  std::size_t up = 0;
  std::size_t down = 0;
  std::size_t far = 0;
};

Steps count_steps(const Texture& reference, const Texture& test) {
  Steps steps;
  for (std::size_t i = 0; i < test.rgb.size(); ++i) {
    const int step = int{test.rgb[i]} - reference.rgb[i];
    (step == 1 ? steps.up : step == -1 ? steps.down : steps.far) += step != 0 ? 1 : 0;
  }
  return steps;
}

// The sign is the evidence: rounded values are never below truncated ones.
std::optional<Claim> find_rounding(const Texture& reference, const Texture& test) {
  const Steps steps = count_steps(reference, test);
  const auto values = static_cast<double>(test.rgb.size());
  const auto near = static_cast<double>(steps.up + steps.down);
  const auto larger = static_cast<double>(std::max(steps.up, steps.down));
  if (near < 0.05 * values || larger < 0.9 * near || static_cast<double>(steps.far) > near) {
    return std::nullopt;
  }
  const bool up = steps.up > steps.down;
  return Claim{Cause::rounding,
               up ? "values are rounded where the reference truncates (no mistake by itself)"
                  : "values are truncated where the reference rounds (no mistake by itself)",
               fmt::format("{} of all values are off by one, {} of those to the {} side",
                           percent(near / values), percent(larger / near), up ? "bright" : "dark"),
               near / (near + static_cast<double>(steps.far))};
}

}  // namespace

std::string_view name_of(Cause cause) {
  static constexpr std::array<std::string_view, 17> names{
      "vertical-flip",    "horizontal-flip", "gamma",   "rounding", "swapped-channels",
      "half-pixel-shift", "ambient",         "diffuse", "specular", "blinn",
      "attenuation",      "normals",         "shadows", "acne",     "texture",
      "recursion-depth",  "spot-falloff"};
  return names[static_cast<std::size_t>(cause)];
}

SceneView most_alike(const Texture& reference, std::span<const SceneView> views) {
  const int step = step_for(reference.width);
  const Texture thin = thinned(reference, step);
  SceneView best = views.front();
  double least = std::numeric_limits<double>::infinity();
  for (const SceneView& view : views) {
    const std::optional<Texture> picture =
        drawn({*view.scene, view.options, {}}, *view.assets, reference, thin, step);
    const double sum = picture ? tolerant_distance(thin, *picture).sum : least;
    if (sum < least) {
      least = sum;
      best = view;
    }
  }
  return best;
}

CauseReport find_causes(const Texture& reference, const Texture& test, const SceneView* view,
                        const std::function<bool(double done)>& go_on) {
  if (reference.width != test.width || reference.height != test.height || reference.empty()) {
    return {};
  }
  CauseReport report = Search(reference, test, view, go_on).run();
  if (report.claims.empty()) {
    if (std::optional<Claim> rounding = find_rounding(reference, test)) {
      report.claims.push_back(*std::move(rounding));
    }
  }
  return report;
}

}  // namespace scenefile
