#include "scenefile/grade/realtime_causes.h"

#include "scenefile/grade/candidates.h"
#include "scenefile/grade/claims.h"
#include "scenefile/grade/evidence.h"
#include "scenefile/grade/fitted_mistakes.h"
#include "scenefile/grade/realtime_settings.h"
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
#include <set>
#include <string_view>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr std::size_t max_partners = 40;       // mistakes per start that need a new rasterization
constexpr std::size_t min_strict_pixels = 40;  // differing pixels needed to search at edges, too
constexpr std::size_t max_same_points = 4000;  // where to look for pixels that a mistake breaks
// Stricter than for ray tracers: the rasterizer reproduces a picture nearly exactly.
constexpr double enough_explained = 0.9;
constexpr double enough_pixels = 0.9;
constexpr double added_by_each = 0.01;  // what each of several mistakes must add to the others
constexpr double promising = 0.02;

struct RealtimeTried : Tried {
  bool judged = false;  // what the scores do not show: Search::holds()
  // Several mistakes can imitate almost anything roughly.
  bool scores() const {
    return explained >= enough_explained && exact >= enough_pixels && broken <= max_broken &&
           (mistakes.size() == 1 || sure(*this));
  }
  bool good() const { return judged && scores(); }
};

class Search {
 public:
  Search(const Texture& reference, const Texture& test, const RealtimeView& view,
         const std::function<bool(double)>& go_on)
      : reference_(reference), test_(test), view_(view), go_on_(go_on), drawn_(view) {}

  CauseReport run() {
    const Pixels pixels = sorted_pixels(reference_, test_, view_.noise);
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
      search(true);
    }
    // Compression changes edges the most.
    if (report_.claims.empty() && report_.partial.empty() && view_.noise.empty() &&
        pixels.off.size() >= min_strict_pixels && pixels.off.size() > 2 * pixels.different.size()) {
      set_points(pixels, true);
      search(false);
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
    if (strict) {
      add_points(reference_, test_, pixels.off, 1200, true, true, random, different);
    } else {
      add_differing_points(reference_, test_, pixels.different, 1200, random, different,
                           view_.noise);
    }
    add_points(reference_, test_, pixels.same, 400, false, strict, random, same, view_.noise);
    unchanged_.clear();
    add_points(reference_, test_, pixels.same, max_same_points, false, false, random, unchanged_,
               view_.noise);
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
    right_unchanged_ = colors({}, clean_, unchanged_, unchanged_.size());
    sources_ = sources_at(points_);
    sources_unchanged_ = sources_at(unchanged_);
    of_reference_.clear();
    for (const Point& p : points_) {
      of_reference_.push_back(at(reference_, p.x, p.y));
    }
    list_.resize(listed_);
    std::vector<Hypothesis> curves = fitted_curves(points_, right_, 0);  // OpenGL rounds
    if (std::optional<Hypothesis> added = addition_to_objects(points_, right_)) {
      curves.push_back(*std::move(added));
    }
    for (Hypothesis& h : curves) {
      list_.push_back({h.cause, h.what, RealtimeStage::picture, {}, h.turn, h.color});
    }
  }

  // Of the objects that the points show without mistakes.
  std::vector<std::uint32_t> sources_at(const std::vector<Point>& points) const {
    const RealtimeTrial trial = drawn_.right();
    const RealtimePicture picture(trial, clean_, *view_.assets, test_.width, test_.height);
    std::vector<std::uint32_t> sources;
    for (const Point& p : points) {
      const std::uint32_t number = picture.triangle_at(p.x, p.y);
      sources.push_back(number == Visibility::nothing
                            ? no_index
                            : clean_->shapes->parts[clean_->triangles[number].part].source);
    }
    return sources;
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

  double rounding() const { return rounding_with(!view_.noise.empty()); }

  Colors without(Combination mistakes, std::size_t member) const {
    mistakes.erase(mistakes.begin() + std::ptrdiff_t(member));
    return drawn_with(mistakes);
  }

  // Whether the mistakes leave nothing but rounding, also in pixels that are not black, and do not
  // break right ones.
  bool holds(const Combination& mistakes, const std::shared_ptr<const Visibility>& shown,
             const Colors& with) const {
    Explanation e{points_, of_reference_, right_, with};
    for (std::size_t k = 0; mistakes.size() > 1 && k < mistakes.size(); ++k) {
      e.without.push_back(without(mistakes, k));
    }
    e.sources = sources_;
    e.rounding = rounding();
    e.noisy = !view_.noise.empty();
    e.inexact = true;
    e.moved = stage_of(mistakes) == RealtimeStage::picture;
    e.finished = view_.panel.filter != Filter::none;
    for (const std::uint16_t i : mistakes) {
      e.fitted = e.fitted || is_curve(i);
      e.finished = e.finished || list_[i].color || list_[i].cause == Cause::filter;
      e.moved = e.moved || !(list_[i].turn == Turn());
    }
    return leaves_only_rounding(e) && shows_bright(with) && !breaks(mistakes, shown, with, false) &&
           curves_hold(mistakes, shown);
  }

  // Whether the picture with the mistakes is not just black: many mistakes make a picture black.
  bool shows_bright(const Colors& with) const {
    Share right;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point& p = points_[i];
      const dvec3 c = glm::clamp(with[i], dvec3(0), dvec3(255));
      if (p.differs && largest_of(p.test) > dark_up_to) {
        right.add(largest_of(glm::abs(c - p.test)) <= right_within + p.noise);
      }
    }
    return right.value() >= 0.5;
  }

  // Whether the mistakes break many pixels, compared with those that differ, or leave many of an
  // object wrong, which other objects that are right may hide. `in_part`: what differs may stay
  // wrong.
  bool breaks(const Combination& mistakes, const std::shared_ptr<const Visibility>& shown,
              const Colors& with, bool in_part) const {
    constexpr double much = 0.1;  // of what differs
    struct Weights {
      double right = 0;
      double wrong = 0;
      std::size_t wrong_points = 0;
    };
    std::map<std::uint32_t, Weights> of_object;
    double broken = 0;
    const auto add = [&](std::uint32_t source, const Point& p, bool right) {
      Weights& object = of_object[source];
      (right ? object.right : object.wrong) += p.weight;
      object.wrong_points += right ? 0 : 1;
    };
    const auto off = [](const dvec3& color, const Point& p) {
      return largest_of(outside(glm::clamp(color, dvec3(0), dvec3(255)), p.low, p.high));
    };
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (points_[i].differs && !in_part) {
        add(sources_[i], points_[i], off(with[i], points_[i]) <= right_within);
      }
    }
    const Colors there = colors(mistakes, shown, unchanged_, unchanged_.size());
    for (std::size_t i = 0; i < unchanged_.size(); ++i) {
      const Point& p = unchanged_[i];
      if (off(right_unchanged_[i], p) <= 0) {
        const bool right = off(there[i], p) <= tolerance;
        broken += right ? 0 : p.weight;
        add(sources_unchanged_[i], p, right);
      }
    }
    return broken > much * base(points_.size()).differs ||
           std::any_of(of_object.begin(), of_object.end(), [](const auto& one) {
             const Weights& w = one.second;
             return w.wrong_points >= few_pixels && w.wrong > much * (w.right + w.wrong);
           });
  }

  Simulation::Base base(std::size_t count) const {
    Simulation::Base b;
    for (std::size_t i = 0; i < count; ++i) {
      (points_[i].differs ? b.differs : b.same) += points_[i].weight;
    }
    b.left = left_before(count);
    return b;
  }

  double left_before(std::size_t count) const { return score(points_, count, right_).left; }

  // Tries each set; sets with the same visible triangles share the rasterization.
  std::vector<RealtimeTried> try_all(const std::vector<Combination>& sets, std::size_t count,
                                     double from, double to) {
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
    std::vector<RealtimeTried> result(sets.size());
    const Simulation::Base b = base(count);
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
            const Colors with = colors(sets[i], shown, count);
            result[i] = {Simulation::rated(sets[i], score(points_, count, with), b)};
            result[i].judged =
                count == points_.size() && result[i].scores() && holds(sets[i], shown, with);
          }
        }
      });
    }
    std::erase_if(result, [](const RealtimeTried& t) { return t.mistakes.empty(); });
    return result;
  }

  static void sort_by_merit(std::vector<RealtimeTried>& list) {
    std::stable_sort(list.begin(), list.end(), [](const RealtimeTried& a, const RealtimeTried& b) {
      return a.merit() > b.merit();
    });
  }

  // ---- searching ---------------------------------------------------------------------------

  // `in_part`: whether a mistake that explains only a part is evidence.
  void search(bool in_part) {
    std::vector<Combination> sets;
    for (std::uint16_t i = 0; i < list_.size(); ++i) {
      sets.push_back({i});
    }
    std::vector<RealtimeTried> ranked = try_all(sets, screen, 0, 0.5);
    sort_by_merit(ranked);
    std::vector<RealtimeTried> best = verified(ranked, 16, 0.5, 0.6);
    if (!best.empty() && best.front().good()) {
      claim(completed(best.front(), ranked), best);
      return;
    }
    if (stopped_) {
      return;
    }
    const std::vector<RealtimeTried> alone = best;
    std::vector<Combination> starts;
    for (std::size_t i = 0; i < std::min<std::size_t>(8, ranked.size()); ++i) {
      starts.push_back(ranked[i].mistakes);
    }
    std::vector<RealtimeTried> pairs = extended(starts, ranked, 0.6, 0.8);
    best = verified(pairs, 12, 0.8, 0.85);
    if (const std::optional<RealtimeTried> found = first_needed(best)) {
      claim(completed(*found, ranked), best);
      return;
    }
    starts.clear();
    for (std::size_t i = 0; i < std::min<std::size_t>(3, pairs.size()); ++i) {
      starts.push_back(pairs[i].mistakes);
    }
    if (!pairs.empty() && pairs.front().merit() > 0.3) {
      best = verified(extended(starts, ranked, 0.85, 0.95), 8, 0.95, 1);
      if (const std::optional<RealtimeTried> found = first_needed(best)) {
        claim(*found, best);
        return;
      }
    }
    for (const RealtimeTried& t : alone) {
      if (in_part && t.explained >= min_partial && t.broken <= max_broken &&
          !is_curve(t.mistakes.front()) && reproduces_its_part(t)) {
        const RealtimeHypothesis& h = list_[t.mistakes.front()];
        report_.partial.push_back(
            {h.cause, h.what, evidence_of_share(t.explained) + "; something else is wrong, too",
             t.explained});
        report_.asked = asked(t.mistakes);
        return;
      }
    }
  }

  // Whether a mistake is right nearly everywhere where it changes the picture, mostly within
  // rounding.
  bool reproduces_its_part(const RealtimeTried& t) const {
    const std::shared_ptr<const Visibility> shown = visible(rasterized(t.mistakes));
    const Colors with = colors(t.mistakes, shown, points_.size());
    const Effect e = effect_of(points_, rounding(), with, right_);
    return scenefile::reproduces_its_part(e, base(points_.size()).differs) && shows_bright(with) &&
           !breaks(t.mistakes, shown, with, true) && curves_hold(t.mistakes, shown);
  }

  // The best screened mistakes at all points; among similar ones the more likely first.
  std::vector<RealtimeTried> verified(const std::vector<RealtimeTried>& ranked, std::size_t count,
                                      double from, double to) {
    std::vector<Combination> sets;
    for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) {
      if (ranked[i].merit() > 0.05) {
        sets.push_back(ranked[i].mistakes);
      }
    }
    std::vector<RealtimeTried> result = try_all(sets, points_.size(), from, to);
    std::stable_sort(
        result.begin(), result.end(),
        [](const RealtimeTried& a, const RealtimeTried& b) { return a.score.raw < b.score.raw; });
    if (result.empty()) {
      return result;
    }
    const double limit = limit_of_tie(result.front().score.raw);
    const auto last = std::find_if(result.begin(), result.end(),
                                   [&](const RealtimeTried& t) { return t.score.raw > limit; });
    // What programs may choose is likelier than a mistake.
    std::stable_sort(result.begin(), last, [&](const RealtimeTried& a, const RealtimeTried& b) {
      const bool allowed = are_allowed(a.mistakes);
      return allowed != are_allowed(b.mistakes) ? allowed : a.mistakes < b.mistakes;
    });
    std::stable_partition(result.begin(), result.end(),
                          [](const RealtimeTried& t) { return t.good(); });
    return result;
  }

  bool are_allowed(const Combination& mistakes) const {
    return std::none_of(mistakes.begin(), mistakes.end(),
                        [&](std::uint16_t i) { return list_[i].mistake; });
  }

  // Mistakes that leave at most this difference count as equal to one that leaves `raw`.
  double limit_of_tie(double raw) const { return tie_limit(raw, left_before(points_.size())); }

  // Combines each start with single mistakes; of those that need a new rasterization, only the most
  // promising.
  std::vector<RealtimeTried> extended(const std::vector<Combination>& starts,
                                      const std::vector<RealtimeTried>& ranked, double from,
                                      double to) {
    std::vector<Combination> sets;
    for (const Combination& start : starts) {
      std::size_t partners = 0;
      for (const RealtimeTried& t : ranked) {
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
    std::vector<RealtimeTried> result = try_all(sets, few_points, from, to);
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
  RealtimeTried completed(const RealtimeTried& found, const std::vector<RealtimeTried>& ranked) {
    if (stopped_ || found.score.left < 0.02 * left_before(points_.size()) ||
        found.mistakes.size() > 2) {
      return found;
    }
    const std::vector<RealtimeTried> best =
        verified(extended({found.mistakes}, ranked, 0.85, 0.95), 6, 0.95, 1);
    const std::optional<RealtimeTried> more = first_needed(best);
    return more && more->score.left < 0.4 * found.score.left ? *more : found;
  }

  // The first good combination, without mistakes that the others do not need.
  std::optional<RealtimeTried> first_needed(const std::vector<RealtimeTried>& best) {
    for (const RealtimeTried& t : best) {
      if (!t.good()) {
        break;
      }
      if (std::optional<RealtimeTried> found = without_needless(t)) {
        return found;
      }
    }
    return std::nullopt;
  }

  // nullopt if a mistake is not needed, but the others are not good.
  std::optional<RealtimeTried> without_needless(RealtimeTried found) {
    for (std::size_t i = 0; found.mistakes.size() > 1 && i < found.mistakes.size();) {
      Combination fewer = found.mistakes;
      fewer.erase(fewer.begin() + std::ptrdiff_t(i));
      const std::vector<RealtimeTried> rest = try_all({fewer}, points_.size(), 1, 1);
      if (rest.empty()) {
        return std::nullopt;
      }
      if (rest.front().explained <= found.explained - added_by_each &&
          is_needed(found.mistakes, i)) {
        ++i;
      } else if (rest.front().good()) {
        found = rest.front();
        i = 0;
      } else {
        return std::nullopt;
      }
    }
    return found;
  }

  bool is_needed(const Combination& mistakes, std::size_t member) const {
    const std::size_t count = points_.size();
    const Effect e =
        effect_of(points_, rounding(), drawn_with(mistakes), without(mistakes, member));
    return needed(e, base(count).differs, list_[mistakes[member]].stage >= RealtimeStage::raster,
                  is_curve(mistakes[member]),
                  std::any_of(mistakes.begin(), mistakes.end(),
                              [&](std::uint16_t i) { return is_curve(i); }));
  }

  Colors drawn_with(const Combination& mistakes) const {
    return colors(mistakes, visible(rasterized(mistakes)), points_.size());
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

  void claim(const RealtimeTried& found, const std::vector<RealtimeTried>& others) {
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
        const std::vector<RealtimeTried> without = try_all({rest}, points_.size(), 1, 1);
        one.evidence =
            evidence_of_several(found.explained, without.empty() ? 0 : without.front().explained);
      }
      report_.claims.push_back(std::move(one));
    }
    if (found.mistakes.size() > 1) {
      return;
    }
    std::vector<std::string> same;
    std::set<std::string_view> words{list_[found.mistakes.front()].what};
    for (const RealtimeTried& t : others) {
      const RealtimeHypothesis& h = list_[t.mistakes.front()];
      if (t.mistakes.size() > 1 || !t.good() || words.contains(h.what)) {
        continue;
      }
      const bool tied = t.score.raw <= limit_of_tie(found.score.raw);
      const bool listed = h.cause == report_.claims.front().cause ||
                          std::any_of(report_.rivals.begin(), report_.rivals.end(),
                                      [&](const Claim& c) { return c.cause == h.cause; });
      if (!listed && report_.rivals.size() < 3 &&
          t.score.raw <= found.score.raw + rival_margin * before) {
        report_.rivals.push_back({h.cause, h.what, evidence_of_share(t.explained), t.explained});
        report_.rivals.back().said = tied;
      } else if (!tied || is_curve(t.mistakes.front())) {
        continue;
      }
      words.insert(h.what);
      if (tied && same.size() + 1 < max_ties) {
        same.push_back(h.what);
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
  std::vector<Point> unchanged_;   // where test and reference are equal
  Colors right_unchanged_;         // there, without mistakes
  std::vector<Point> points_;
  std::vector<std::uint32_t> sources_unchanged_;
  std::vector<std::uint32_t> sources_;  // of the objects at the points
  Colors of_reference_;                 // at the points
  Colors right_;                        // at the points, without mistakes
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
  if (report.claims.empty() && report.partial.empty() && view.noise.empty()) {
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
