#include "scenefile/grade/realtime_causes.h"

#include "scenefile/grade/claims.h"
#include "scenefile/grade/evidence.h"
#include "scenefile/grade/fitted_mistakes.h"
#include "scenefile/grade/realtime_settings.h"
#include "scenefile/grade/simulation.h"
#include "scenefile/grade/undrawn.h"
#include "scenefile/mistakes/realtime_hypotheses.h"
#include "scenefile/trace/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr std::size_t screen = 240;            // points used to screen single mistakes
constexpr std::size_t few_points = 120;        // points used to screen combinations
constexpr std::size_t max_partners = 40;       // mistakes per start that need a new rasterization
constexpr std::size_t min_strict_pixels = 40;  // differing pixels needed to search at edges, too
constexpr double rival_margin = 0.03;
// Stricter than for ray tracers: the rasterizer reproduces a picture nearly exactly.
constexpr double enough_explained = 0.9;
constexpr double enough_pixels = 0.9;
// Several mistakes can imitate almost anything roughly.
constexpr double enough_together = 0.95;
constexpr double necessary = 0.01;  // what each of several mistakes must add to the others
constexpr double promising = 0.02;

struct Tried {
  Combination mistakes;
  Score score;
  double explained = 0;
  double exact = 0;
  double broken = 0;
  bool holds = true;  // any curve among the mistakes holds everywhere: curve_holds()
  double merit() const { return 0.5 * explained + 0.5 * exact - broken; }
  bool good() const {
    return explained >= (mistakes.size() == 1 ? enough_explained : enough_together) &&
           exact >= enough_pixels && broken <= max_broken && holds;
  }
};

class Search {
 public:
  Search(const Texture& reference, const Texture& test, const RealtimeView& view,
         const std::function<bool(double)>& go_on)
      : reference_(reference), test_(test), view_(view), go_on_(go_on), drawn_(view) {}

  CauseReport run() {
    const Pixels pixels = sorted_pixels(reference_, test_);
    const double all = static_cast<double>(test_.width) * test_.height;
    report_.share_different = static_cast<double>(pixels.different.size()) / all;
    report_.only_details = only_details(pixels, test_);
    if (!drawn_.usable()) {
      return report_;
    }
    clean_ =
        find_visible(drawn_.right(), drawn_.shapes(), *view_.assets, test_.width, test_.height);
    report_.share_scene_unlike = share_unlike();
    if (report_.share_scene_unlike > max_unlike ||
        (pixels.off.size() < few_pixels && pixels.different.size() < few_pixels)) {
      return report_;
    }
    if (std::optional<Claim> undrawn = claim_of_undrawn_part(reference_, test_, pixels.different)) {
      report_.claims.push_back(*std::move(undrawn));
      return report_;
    }
    lit_ = *view_.scene;
    drawn_.keep_lights(lit_);
    list_ = realtime_hypotheses(view_, lit_, test_.width, test_.height);
    add_fitted();
    listed_ = list_.size();
    if (pixels.different.size() >= few_pixels) {
      set_points(pixels, false);
      search();
    }
    if (report_.claims.empty() && report_.partial.empty() &&
        pixels.off.size() >= min_strict_pixels && pixels.off.size() > 2 * pixels.different.size()) {
      set_points(pixels, true);
      search();
    }
    return report_;
  }

 private:
  bool step(double done) {
    stopped_ = stopped_ || (go_on_ && !go_on_(done));
    return !stopped_;
  }

  // ---- drawing -----------------------------------------------------------------------------

  RealtimeTrial trial_of(const Combination& mistakes) const {
    RealtimeTrial trial = drawn_.right();
    if (stage_of(mistakes) == RealtimeStage::shapes) {
      trial.scene.scene = lit_;
      apply(mistakes, trial, true);
      drawn_.keep_lights(trial.scene.scene);
    }
    apply(mistakes, trial, false);
    return trial;
  }

  void apply(const Combination& mistakes, RealtimeTrial& trial, bool shapes) const {
    for (const std::uint16_t i : mistakes) {
      if (list_[i].draw && (list_[i].stage == RealtimeStage::shapes) == shapes) {
        list_[i].draw(trial);
      }
    }
  }

  RealtimeStage stage_of(const Combination& mistakes) const {
    RealtimeStage stage = RealtimeStage::picture;
    for (const std::uint16_t i : mistakes) {
      stage = std::max(stage, list_[i].stage);
    }
    return stage;
  }

  // The mistakes that determine which triangles are visible.
  Combination rasterized(const Combination& mistakes) const {
    Combination result;
    for (const std::uint16_t i : mistakes) {
      if (list_[i].stage >= RealtimeStage::raster) {
        result.push_back(i);
      }
    }
    return result;
  }

  std::shared_ptr<const Visibility> visible(const Combination& mistakes) const {
    const RealtimeStage stage = stage_of(mistakes);
    if (stage < RealtimeStage::raster) {
      return clean_;
    }
    const RealtimeTrial trial = trial_of(mistakes);
    const auto shapes =
        stage == RealtimeStage::shapes ? realtime_shapes(trial.scene.scene) : drawn_.shapes();
    return shapes == nullptr
               ? nullptr
               : find_visible(trial, shapes, *view_.assets, test_.width, test_.height);
  }

  // In 1/255.
  Colors colors(const Combination& mistakes, const std::shared_ptr<const Visibility>& visible,
                std::size_t count) const {
    return colors(mistakes, visible, points_, count);
  }

  Colors colors(const Combination& mistakes, const std::shared_ptr<const Visibility>& visible,
                const std::vector<Point>& points, std::size_t count) const {
    const RealtimeTrial trial = trial_of(mistakes);
    const RealtimePicture picture(trial, visible, *view_.assets, test_.width, test_.height);
    Turn turn;
    for (const std::uint16_t i : mistakes) {
      turn.across = turn.across != list_[i].turn.across;
      turn.down = turn.down != list_[i].turn.down;
    }
    Colors result(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Point& p = points[i];
      dvec3 c = picture.pixel(turn.across ? test_.width - 1 - p.x : p.x,
                              turn.down ? test_.height - 1 - p.y : p.y);
      for (const std::uint16_t k : mistakes) {
        if (list_[k].color) {
          c = glm::clamp(list_[k].color(c), dvec3(0), dvec3(1));
        }
      }
      result[i] = 255.0 * c;
    }
    return result;
  }

  double share_unlike() {
    std::mt19937 random(2);
    std::vector<std::uint32_t> pixels(std::size_t(test_.width) * test_.height);
    for (std::uint32_t i = 0; i < pixels.size(); ++i) {
      pixels[i] = i;
    }
    everywhere_.clear();
    add_points(reference_, test_, pixels, 3000, false, true, random, everywhere_);
    points_.clear();
    add_points(test_, reference_, std::move(pixels), 1500, false, false, random, points_);
    const Colors right = colors({}, clean_, points_.size());
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Range range = around(reference_, points_[i].x, points_[i].y);
      unlike += largest_of(outside(right[i], range.low - 6.0, range.high + 6.0)) > 0 ? 1 : 0;
    }
    return static_cast<double>(unlike) /
           static_cast<double>(std::max<std::size_t>(1, points_.size()));
  }

  // ---- scoring -----------------------------------------------------------------------------

  // Repeats three points that differ and one that does not, so that every prefix represents both.
  void set_points(const Pixels& pixels, bool strict) {
    std::mt19937 random(1);
    std::vector<Point> different;
    std::vector<Point> same;
    add_points(reference_, test_, strict ? pixels.off : pixels.different, 1200, true, strict,
               random, different);
    add_points(reference_, test_, pixels.same, 400, false, strict, random, same);
    points_.clear();
    std::size_t s = 0;
    for (std::size_t d = 0; d < different.size() || s < same.size();) {
      for (int i = 0; i < 3 && d < different.size(); ++i) {
        points_.push_back(different[d++]);
      }
      if (s < same.size()) {
        points_.push_back(same[s++]);
      }
    }
    right_ = colors({}, clean_, points_.size());
    list_.resize(listed_);
    std::vector<Hypothesis> curves = fitted_curves(points_, right_);
    if (std::optional<Hypothesis> added = addition_to_objects(points_, right_)) {
      curves.push_back(*std::move(added));
    }
    for (Hypothesis& h : curves) {
      list_.push_back({h.cause, h.what, RealtimeStage::picture, {}, h.turn, h.color});
    }
  }

  // Curves of the finished picture, which are estimated from its colors.
  bool is_curve(std::uint16_t mistake) const { return mistake >= listed_; }

  bool curves_hold(const Combination& mistakes,
                   const std::shared_ptr<const Visibility>& shown) const {
    Combination others;
    std::copy_if(mistakes.begin(), mistakes.end(), std::back_inserter(others),
                 [&](std::uint16_t i) { return !is_curve(i); });
    const std::size_t count = everywhere_.size();
    return others.size() == mistakes.size() ||
           curve_holds(reference_, everywhere_, colors(others, shown, everywhere_, count),
                       colors(mistakes, shown, everywhere_, count));
  }

  Tried rated(Combination mistakes, const Score& s, std::size_t count) const {
    double differs = 0;
    double same = 0;
    for (std::size_t i = 0; i < count; ++i) {
      (points_[i].differs ? differs : same) += points_[i].weight;
    }
    const double before = left_before(count);
    Tried t;
    t.mistakes = std::move(mistakes);
    t.score = s;
    t.explained = before > 0 ? 1 - s.left / before : 0;
    t.exact = differs > 0 ? s.exact / differs : 0;
    t.broken = same > 0 ? s.broken / same : 0;
    return t;
  }

  double left_before(std::size_t count) const { return score(points_, count, right_).left; }

  // Tries each set; sets with the same visible triangles share the rasterization.
  std::vector<Tried> try_all(const std::vector<Combination>& sets, std::size_t count, double from,
                             double to) {
    count = std::min(count, points_.size());
    std::map<Combination, std::vector<std::size_t>> by_raster;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      by_raster[rasterized(sets[i])].push_back(i);
    }
    std::vector<std::pair<Combination, std::vector<std::size_t>>> groups;
    for (auto& [raster, members] : by_raster) {
      // Splits large groups, to use all threads.
      for (std::size_t start = 0; start < members.size(); start += 32) {
        groups.emplace_back(
            raster, std::vector<std::size_t>(
                        members.begin() + std::ptrdiff_t(start),
                        members.begin() + std::ptrdiff_t(std::min(members.size(), start + 32))));
      }
    }
    std::vector<Tried> result(sets.size());
    constexpr std::size_t chunk = 16;
    for (std::size_t start = 0; start < groups.size(); start += chunk) {
      if (!step(from +
                (to - from) * static_cast<double>(start) / static_cast<double>(groups.size()))) {
        break;
      }
      for_each_task(std::min(chunk, groups.size() - start), [&](std::size_t g) {
        const auto& [raster, members] = groups[start + g];
        const std::shared_ptr<const Visibility> shown = visible(raster);
        for (const std::size_t i : members) {
          if (shown != nullptr) {
            result[i] = rated(sets[i], score(points_, count, colors(sets[i], shown, count)), count);
            result[i].holds = count < points_.size() || curves_hold(sets[i], shown);
          }
        }
      });
    }
    std::erase_if(result, [](const Tried& t) { return t.mistakes.empty(); });
    return result;
  }

  static void sort_by_merit(std::vector<Tried>& list) {
    std::stable_sort(list.begin(), list.end(),
                     [](const Tried& a, const Tried& b) { return a.merit() > b.merit(); });
  }

  // ---- searching ---------------------------------------------------------------------------

  void search() {
    std::vector<Combination> sets;
    for (std::uint16_t i = 0; i < list_.size(); ++i) {
      sets.push_back({i});
    }
    std::vector<Tried> ranked = try_all(sets, screen, 0, 0.5);
    sort_by_merit(ranked);
    std::vector<Tried> best = verified(ranked, 16, 0.5, 0.6);
    if (!best.empty() && best.front().good()) {
      claim(completed(best.front(), ranked), best);
      return;
    }
    if (stopped_) {
      return;
    }
    const std::vector<Tried> alone = best;
    std::vector<Combination> starts;
    for (std::size_t i = 0; i < std::min<std::size_t>(8, ranked.size()); ++i) {
      starts.push_back(ranked[i].mistakes);
    }
    std::vector<Tried> pairs = extended(starts, ranked, 0.6, 0.8);
    best = verified(pairs, 12, 0.8, 0.85);
    if (!best.empty() && best.front().good()) {
      claim(completed(without_needless(best.front()), ranked), best);
      return;
    }
    starts.clear();
    for (std::size_t i = 0; i < std::min<std::size_t>(3, pairs.size()); ++i) {
      starts.push_back(pairs[i].mistakes);
    }
    if (!pairs.empty() && pairs.front().merit() > 0.3) {
      best = verified(extended(starts, ranked, 0.85, 0.95), 8, 0.95, 1);
      if (!best.empty() && best.front().good()) {
        claim(without_needless(best.front()), best);
        return;
      }
    }
    if (!alone.empty() && alone.front().explained >= min_partial &&
        alone.front().exact >= min_partial && alone.front().broken <= max_broken &&
        alone.front().holds) {
      const RealtimeHypothesis& h = list_[alone.front().mistakes.front()];
      report_.partial.push_back(
          {h.cause, h.what,
           evidence_of_share(alone.front().explained) + "; something else is wrong, too",
           alone.front().explained});
      report_.asked = asked(alone.front().mistakes);
    }
  }

  // The best screened mistakes at all points; among similar ones the more likely first.
  std::vector<Tried> verified(const std::vector<Tried>& ranked, std::size_t count, double from,
                              double to) {
    std::vector<Combination> sets;
    for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) {
      if (ranked[i].merit() > 0.05) {
        sets.push_back(ranked[i].mistakes);
      }
    }
    std::vector<Tried> result = try_all(sets, points_.size(), from, to);
    std::stable_sort(result.begin(), result.end(),
                     [](const Tried& a, const Tried& b) { return a.score.raw < b.score.raw; });
    if (result.empty()) {
      return result;
    }
    const double limit = tie_limit(result.front().score.raw);
    const auto last = std::find_if(result.begin(), result.end(),
                                   [&](const Tried& t) { return t.score.raw > limit; });
    std::stable_sort(result.begin(), last,
                     [](const Tried& a, const Tried& b) { return a.mistakes < b.mistakes; });
    std::stable_partition(result.begin(), result.end(), [](const Tried& t) { return t.good(); });
    return result;
  }

  // Mistakes that leave at most this difference count as equal to one that leaves `raw`.
  double tie_limit(double raw) const { return 1.1 * raw + 0.0003 * left_before(points_.size()); }

  // Combines each start with single mistakes; of those that need a new rasterization, only the most
  // promising.
  std::vector<Tried> extended(const std::vector<Combination>& starts,
                              const std::vector<Tried>& ranked, double from, double to) {
    std::vector<Combination> sets;
    for (const Combination& start : starts) {
      std::size_t partners = 0;
      for (const Tried& t : ranked) {
        const std::uint16_t other = t.mistakes.front();
        if (list_[other].stage >= RealtimeStage::raster &&
            (partners >= max_partners || (t.exact < promising && t.explained < promising))) {
          continue;
        }
        if (!fits(start, other)) {
          continue;
        }
        partners += list_[other].stage >= RealtimeStage::raster ? 1 : 0;
        Combination mistakes = start;
        mistakes.push_back(other);
        std::sort(mistakes.begin(), mistakes.end());
        sets.push_back(std::move(mistakes));
      }
    }
    std::sort(sets.begin(), sets.end());
    sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
    std::vector<Tried> result = try_all(sets, few_points, from, to);
    sort_by_merit(result);
    return result;
  }

  // Two mistakes of the same kind rarely combine: one replaces the other.
  bool fits(const Combination& start, std::uint16_t other) const {
    return std::none_of(start.begin(), start.end(), [&](std::uint16_t i) {
      const Cause a = list_[i].cause;
      return i == other || (a == list_[other].cause && a != Cause::specular && a != Cause::shapes &&
                            a != Cause::culling && a != Cause::normals);
    });
  }

  // Adds the mistake that explains most of the remaining difference, if any.
  Tried completed(const Tried& found, const std::vector<Tried>& ranked) {
    if (stopped_ || found.score.left < 0.02 * left_before(points_.size()) ||
        found.mistakes.size() > 2) {
      return found;
    }
    const std::vector<Tried> best =
        verified(extended({found.mistakes}, ranked, 0.85, 0.95), 6, 0.95, 1);
    if (!best.empty() && best.front().good() && best.front().score.left < 0.4 * found.score.left) {
      return without_needless(best.front());
    }
    return found;
  }

  Tried without_needless(Tried found) {
    for (std::size_t i = 0; found.mistakes.size() > 1 && i < found.mistakes.size();) {
      Combination fewer = found.mistakes;
      fewer.erase(fewer.begin() + std::ptrdiff_t(i));
      const std::vector<Tried> tried = try_all({fewer}, points_.size(), 1, 1);
      if (!tried.empty() && tried.front().good() &&
          tried.front().explained > found.explained - necessary) {
        found = tried.front();
        i = 0;
      } else {
        ++i;
      }
    }
    return found;
  }

  // The pixel that is asked for, with the mistakes.
  std::optional<MistakenPixel> asked(const Combination& mistakes) const {
    const std::shared_ptr<const Visibility> shown =
        view_.asked ? visible(rasterized(mistakes)) : nullptr;
    if (shown == nullptr) {
      return std::nullopt;
    }
    const Point point{static_cast<int>(view_.asked->x), static_cast<int>(view_.asked->y)};
    return MistakenPixel{colors(mistakes, shown, {point}, 1).front()};
  }

  void claim(const Tried& found, const std::vector<Tried>& others) {
    report_.asked = asked(found.mistakes);
    const double before = left_before(points_.size());
    const double values = 3.0 * test_.width * test_.height;
    for (const std::uint16_t i : found.mistakes) {
      Claim one{list_[i].cause, list_[i].what, {}, found.explained};
      if (found.mistakes.size() == 1) {
        one.evidence = evidence_of_one(found.score.left / values, before / values, found.exact);
      } else {
        Combination rest = found.mistakes;
        std::erase(rest, i);
        const std::vector<Tried> without = try_all({rest}, points_.size(), 1, 1);
        one.evidence =
            evidence_of_several(found.explained, without.empty() ? 0 : without.front().explained);
      }
      report_.claims.push_back(std::move(one));
    }
    if (found.mistakes.size() > 1) {
      return;
    }
    std::vector<std::string> same;
    for (const Tried& t : others) {
      const RealtimeHypothesis& h = list_[t.mistakes.front()];
      const bool listed = h.cause == report_.claims.front().cause ||
                          std::any_of(report_.rivals.begin(), report_.rivals.end(),
                                      [&](const Claim& c) { return c.cause == h.cause; });
      if (t.mistakes.size() == 1 && !listed && t.good() && report_.rivals.size() < 3 &&
          t.score.raw <= found.score.raw + rival_margin * before) {
        report_.rivals.push_back({h.cause, h.what, evidence_of_share(t.explained), t.explained});
        if (t.score.raw <= tie_limit(found.score.raw)) {
          same.push_back(h.what);
          report_.rivals.back().said = true;
        }
      }
    }
    add_alternatives(report_.claims.back(), same);
  }

  // ---- causes estimated from the pictures ----------------------------------------------

  // The settings that fit the test, if they differ from those of the reference.
  void add_fitted() {
    if (!step(0)) {
      return;
    }
    const RealtimeOptions& right = view_.panel;
    RealtimeOptions fitted = fitted_depths(test_, drawn_, right);
    if (fitted.near != right.near || fitted.far != right.far) {
      std::string what;
      if (fitted.near != right.near) {
        what += fmt::format("near is {}, not {}", fitted.near, right.near);
      }
      if (fitted.far != right.far) {
        what +=
            fmt::format("{}far is {}, not {}", what.empty() ? "" : ", and ", fitted.far, right.far);
      }
      list_.push_back({Cause::clipping,
                       what,
                       RealtimeStage::raster,
                       [fitted](RealtimeTrial& t) {
                         t.panel.near = fitted.near;
                         t.panel.far = fitted.far;
                       },
                       {},
                       {}});
    }
    const TessellationParameters parameters = fitted_parameters(test_, drawn_, right);
    if (!(parameters == right.tessellation)) {
      list_.push_back(
          {Cause::tessellation,
           fmt::format("shapes are drawn with the parameters {}, but those of the "
                       "reference with {}",
                       parameters_text(parameters), parameters_text(right.tessellation)),
           RealtimeStage::raster,
           [parameters](RealtimeTrial& t) { t.panel.tessellation = parameters; },
           {},
           {}});
    }
    add_background();
  }

  // The most frequent color at the picture's border.
  void add_background() {
    std::map<std::array<std::uint8_t, 3>, std::size_t> colors;
    std::size_t all = 0;
    const RealtimeTrial trial = drawn_.right();
    const RealtimePicture picture(trial, clean_, *view_.assets, test_.width, test_.height);
    for (int y = 0; y < test_.height; y += 7) {
      for (int x = 0; x < test_.width; x += 7) {
        if (picture.triangle_at(x, y) == Visibility::nothing) {
          const std::uint8_t* t = test_.texel(x, y);
          ++colors[{t[0], t[1], t[2]}];
          ++all;
        }
      }
    }
    if (all == 0) {
      return;
    }
    const auto most =
        std::max_element(colors.begin(), colors.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    const auto& c = most->first;
    if (10 * most->second < 7 * all || c == std::array<std::uint8_t, 3>{0, 0, 0}) {
      return;
    }
    list_.push_back({Cause::background,
                     fmt::format("the background is {} {} {}, not black", c[0], c[1], c[2]),
                     RealtimeStage::shading,
                     [color = dvec3(c[0], c[1], c[2]) / 255.0](RealtimeTrial& t) {
                       t.scene.mistakes.background = color;
                     },
                     {},
                     {}});
  }

  const Texture& reference_;
  const Texture& test_;
  const RealtimeView& view_;
  const std::function<bool(double)>& go_on_;
  const RealtimeDrawn drawn_;
  RenderScene lit_;  // with the lights of the milestone
  std::shared_ptr<const Visibility> clean_;
  std::vector<RealtimeHypothesis> list_;
  std::size_t listed_ = 0;         // size of list_ without curves, which depend on the points
  std::vector<Point> everywhere_;  // spread over the whole picture
  std::vector<Point> points_;
  Colors right_;  // at the points, without mistakes
  bool stopped_ = false;
  CauseReport report_;
};

}  // namespace

CauseReport find_realtime_causes(const Texture& reference, const Texture& test,
                                 const RealtimeView& view,
                                 const std::function<bool(double done)>& go_on) {
  if (reference.width != test.width || reference.height != test.height || reference.empty()) {
    return {};
  }
  CauseReport report = Search(reference, test, view, go_on).run();
  if (report.claims.empty() && report.partial.empty()) {
    // Causes found without the scene, such as a blurred picture.
    CauseReport plain =
        find_causes(reference, test, nullptr, [&](double /*done*/) { return !go_on || go_on(1); });
    const bool curve = std::any_of(plain.claims.begin(), plain.claims.end(), [](const Claim& c) {
      return c.cause == Cause::brightness || c.cause == Cause::gamma;
    });
    if (!curve) {  // the search above has found that no curve holds for the whole picture
      report.claims = std::move(plain.claims);
      report.rivals = std::move(plain.rivals);
    }
  }
  return report;
}

std::optional<std::uint32_t> realtime_source_at(const RealtimeView& view, const glm::ivec2& pixel,
                                                const glm::ivec2& size) {
  const RealtimeDrawn drawn(view);
  if (!drawn.usable()) {
    return std::nullopt;
  }
  const auto visible = find_visible(drawn.right(), drawn.shapes(), *view.assets, size.x, size.y);
  const RealtimePicture picture(drawn.right(), visible, *view.assets, size.x, size.y);
  const std::uint32_t number = picture.triangle_at(pixel.x, pixel.y);
  return number == Visibility::nothing
             ? std::nullopt
             : std::optional(visible->shapes->parts[visible->triangles[number].part].source);
}

}  // namespace scenefile
