#include "scenefile/grade/causes.h"

#include "scenefile/grade/claims.h"
#include "scenefile/grade/evidence.h"
#include "scenefile/grade/hypotheses.h"
#include "scenefile/grade/model.h"
#include "scenefile/grade/undrawn.h"
#include "scenefile/trace/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double enough_shift = 0.6;  // share of edges that a subpixel shift must explain
constexpr double necessary = 0.01;    // share of the difference that each of several changes
constexpr double nearly_all = 0.95;   // share of pixels where a single mistake leaves no doubt
constexpr double rival_margin = 0.03;
constexpr double most_for_rounding = 0.05;   // share of pixels that differ by more
constexpr double least_for_several = 0.001;  // share of pixels that must differ
constexpr std::size_t screen = 240;          // points used to screen single mistakes
constexpr std::size_t few_points = 100;      // ... and several
constexpr std::size_t most_edited = 2000;    // with more shapes: no combinations of shape changes
constexpr std::uint64_t work_for_pairs = 12'000'000;  // rays

// Several mistakes at once, as indices into the list.
using Together = std::vector<std::uint16_t>;

struct Tried {
  Together together;
  Score score;
  double explained = 0;
  double exact = 0;
  double broken = 0;
  double merit() const { return 0.5 * explained + 0.5 * exact - broken; }
};

class Search {
 public:
  Search(const Texture& reference, const Texture& test, const SceneView* view,
         const std::function<bool(double)>& go_on, LookFor look_for)
      : reference_(reference), test_(test), view_(view), go_on_(go_on), look_for_(look_for) {}

  CauseReport run() {
    const Pixels pixels = sorted_pixels(reference_, test_);
    const double all = static_cast<double>(test_.width) * test_.height;
    report_.share_different = static_cast<double>(pixels.different.size()) / all;
    look_at_scene();
    if (pixels.off.size() < few_pixels && pixels.different.size() < few_pixels) {
      return report_;
    }
    if (std::optional<Claim> undrawn = claim_of_undrawn_part(reference_, test_, pixels.different)) {
      report_.claims.push_back(*std::move(undrawn));
      return report_;
    }
    list_ = picture_hypotheses();
    if (usable_) {
      std::vector<Hypothesis> drawn =
          drawing_hypotheses(*view_, reference_.width, reference_.height);
      std::move(drawn.begin(), drawn.end(), std::back_inserter(list_));
    }
    std::mt19937 random(1);
    add_points(reference_, test_, pixels.different, 1200, true, false, random, points_);
    drop_what_samples_explain(true);
    const std::size_t different = points_.size();
    add_points(reference_, test_, pixels.same, 400, false, false, random, points_);
    interleave(different);
    prepare_clean();
    first_measured_ = list_.size();
    add_curves();
    if (usable_) {
      add_background();
      add_factors();
    }
    if (significant()) {
      search();
    }
    if (report_.claims.empty() && !stopped_ && !claim_blur(pixels) && usable_ &&
        !claim_missed_samples()) {
      search_shifts(pixels);
    }
    return report_;
  }

 private:
  bool step(double done) {
    stopped_ = stopped_ || (go_on_ && !go_on_(done));
    return !stopped_;
  }

  // ---- drawing -----------------------------------------------------------------------------

  dvec2 middle(const Point& p, const Turn& turn) const {
    const int x = turn.across ? test_.width - 1 - p.x : p.x;
    const int y = turn.down ? test_.height - 1 - p.y : p.y;
    return {x + 0.5, y + 0.5};
  }

  Trial right_trial(bool with_groups) const {
    Trial trial;
    const RenderScene& scene = *view_->scene;
    if (with_groups) {
      trial.scene = scene;
    } else {
      trial.scene.global = scene.global;
      trial.scene.camera = scene.camera;
      trial.scene.lights = scene.lights;
      trial.scene.materials = scene.materials;
    }
    trial.options = view_->options;
    return trial;
  }

  Colors draw(const Trial& trial, const ModelShapes& shapes, const std::vector<Point>& points,
              std::size_t count, const Turn& turn, const std::vector<ModelHit>* hits) const {
    const Model model(trial.scene, shapes, *view_->assets, trial.options, trial.mistakes);
    Colors colors(count);
    for (std::size_t i = 0; i < count; ++i) {
      const ModelHit* const known = hits != nullptr ? &(*hits)[i] : nullptr;
      colors[i] = 255.0 * model.pixel(middle(points[i], turn) + trial.shift, test_.width,
                                      test_.height, known);
    }
    rays_ += model.rays();
    return colors;
  }

  void look_at_scene() {
    if (view_ == nullptr) {
      return;
    }
    shapes_ = flatten(*view_->scene, *view_->assets);
    if (shapes_ == nullptr) {
      return;
    }
    std::mt19937 random(2);
    std::vector<std::uint32_t> pixels(std::size_t(test_.width) * test_.height);
    for (std::uint32_t i = 0; i < pixels.size(); ++i) {
      pixels[i] = i;
    }
    std::vector<Point> points;
    add_points(test_, reference_, std::move(pixels), 1500, false, false, random, points);
    const Colors colors =
        draw(right_trial(false), *shapes_, points, points.size(), Turn(), nullptr);
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Range range = around(reference_, points[i].x, points[i].y);
      const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
      unlike += largest_of(outside(c, range.low - 6.0, range.high + 6.0)) > 0 ? 1 : 0;
    }
    report_.share_scene_unlike =
        static_cast<double>(unlike) / static_cast<double>(std::max<std::size_t>(1, points.size()));
    usable_ = report_.share_scene_unlike <= most_unlike;
  }

  // Drops points that match the test with one sample at the pixel's center: they only differ by
  // sampling.
  void drop_what_samples_explain(bool tolerant) {
    if (!usable_) {
      return;
    }
    const Colors colors =
        draw(right_trial(false), *shapes_, points_, points_.size(), Turn(), nullptr);
    std::vector<Point> kept;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point& p = points_[i];
      const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
      if (largest_of(tolerant ? outside(c, p.low, p.high) : glm::abs(c - p.test)) > 2) {
        kept.push_back(p);
      }
    }
    points_ = std::move(kept);
  }

  // Mixes both kinds of points in the proportions for screening.
  void interleave(std::size_t different) {
    std::vector<Point> mixed;
    std::size_t d = 0;
    std::size_t s = different;
    while (d < different || s < points_.size()) {
      for (int i = 0; i < 3 && d < different; ++i) {
        mixed.push_back(points_[d++]);
      }
      if (s < points_.size()) {
        mixed.push_back(points_[s++]);
      }
    }
    points_ = std::move(mixed);
  }

  struct Clean {
    Colors reference;
    Colors drawn;
    std::vector<ModelHit> hits;
  };

  const Clean& clean(const Turn& turn) const {
    return clean_[(turn.across ? 1 : 0) + (turn.down ? 2 : 0)];
  }

  void prepare_clean() {
    for (const bool down : {false, true}) {
      for (const bool across : {false, true}) {
        const Turn turn{across, down};
        Clean& c = clean_[(across ? 1 : 0) + (down ? 2 : 0)];
        c = {};
        for (const Point& p : points_) {
          const dvec2 m = middle(p, turn);
          c.reference.push_back(at(reference_, static_cast<int>(m.x), static_cast<int>(m.y)));
        }
        if (!usable_) {
          continue;
        }
        const Trial trial = right_trial(false);
        const Model model(trial.scene, *shapes_, *view_->assets, trial.options, trial.mistakes);
        for (const Point& p : points_) {
          c.hits.push_back(
              model.first_hit(model.camera_ray(middle(p, turn), test_.width, test_.height)));
        }
        c.drawn = draw(trial, *shapes_, points_, points_.size(), turn, &c.hits);
      }
    }
  }

  // ---- scoring -----------------------------------------------------------------------------

  double weight_that_differs(std::size_t count) const {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      sum += points_[i].differs ? points_[i].weight : 0;
    }
    return sum;
  }

  bool significant() const {
    std::size_t count = 0;
    for (const Point& p : points_) {
      count += p.differs ? 1 : 0;
    }
    return count >= few_pixels;
  }

  struct Base {
    double left = 0;
    double differs = 0;
    double same = 0;
  };

  Base base(std::size_t count) const {
    Base b;
    b.left = score(points_, count, clean({}).reference).left;
    if (usable_) {
      b.left = std::min(b.left, score(points_, count, clean({}).drawn).left);
    }
    for (std::size_t i = 0; i < count; ++i) {
      (points_[i].differs ? b.differs : b.same) += points_[i].weight;
    }
    return b;
  }

  // The picture with these mistakes; nullopt if none affects drawing.
  std::optional<Colors> drawn(const Together& together, std::size_t count, const Turn& turn) const {
    const Touches touches = touched_by(together);
    const bool hits = touches >= Touches::hits;
    if (touches == Touches::picture) {
      return std::nullopt;
    }
    const std::uint16_t one = drawing_member(together);
    if (one != no_member && turn == Turn() && one < cache_.size() && cache_[one].size() >= count) {
      return Colors(cache_[one].begin(), cache_[one].begin() + std::ptrdiff_t(count));
    }
    const Trial trial = trial_of(together);
    const std::shared_ptr<const ModelShapes> shapes = shapes_of(trial, touches);
    return draw(trial, *shapes, points_, count, turn, hits ? nullptr : &clean(turn).hits);
  }

  Touches touched_by(const Together& together) const {
    Touches touches = Touches::picture;
    for (const std::uint16_t i : together) {
      touches = std::max(touches, list_[i].touches);
    }
    return touches;
  }

  // Mistakes that change the shapes come first, because they replace what others change.
  Trial trial_of(const Together& together) const {
    Trial trial = right_trial(touched_by(together) == Touches::shapes);
    for (const Touches kind : {Touches::shapes, Touches::shading}) {
      for (const std::uint16_t i : together) {
        if (list_[i].draw && (list_[i].touches == Touches::shapes) == (kind == Touches::shapes)) {
          list_[i].draw(trial);
        }
      }
    }
    return trial;
  }

  std::shared_ptr<const ModelShapes> shapes_of(const Trial& trial, Touches touches) const {
    return touches == Touches::shapes ? flatten(trial.scene, *view_->assets) : shapes_;
  }

  Turn turn_of(const Together& together) const {
    Turn turn;
    for (const std::uint16_t i : together) {
      turn.across = turn.across != list_[i].turn.across;
      turn.down = turn.down != list_[i].turn.down;
    }
    return turn;
  }

  // Applies the mistakes that change the finished picture to the colors.
  Colors finished(const Together& together, Colors colors) const {
    for (const std::uint16_t i : together) {
      if (list_[i].color) {
        for (dvec3& c : colors) {
          c = 255.0 * list_[i].color(c / 255.0);
        }
      }
    }
    return colors;
  }

  static constexpr std::uint16_t no_member = 0xffff;

  // The mistake that affects drawing, if it is the only one.
  std::uint16_t drawing_member(const Together& together) const {
    std::uint16_t found = no_member;
    for (const std::uint16_t i : together) {
      if (list_[i].touches != Touches::picture) {
        if (found != no_member) {
          return no_member;
        }
        found = i;
      }
    }
    return found;
  }

  // Draws single mistakes once, to combine each with those that change the finished picture.
  void fill_cache(std::size_t count) {
    cache_.clear();
    count = std::min(count, points_.size());
    std::vector<Colors> cache(list_.size());
    for_each_task(list_.size(), [&](std::size_t i) {
      const std::optional<Colors> colors = drawn({static_cast<std::uint16_t>(i)}, count, Turn());
      cache[i] = colors ? *colors : Colors();
    });
    cache_ = std::move(cache);
  }

  // The picture with the mistakes at the first points: the changed drawing, or the
  // reference plus the change, whichever is closer to the test.
  Colors predicted(const Together& together, std::size_t count) const {
    const Turn turn = turn_of(together);
    const Clean& right = clean(turn);
    const auto first = [count](const Colors& colors) {
      return Colors(colors.begin(), colors.begin() + std::ptrdiff_t(count));
    };
    const std::optional<Colors> changed = drawn(together, count, turn);
    if (!changed) {
      Colors of_reference = finished(together, first(right.reference));
      return usable_ ? closer(std::move(of_reference), finished(together, first(right.drawn)))
                     : of_reference;
    }
    Colors added(count);
    for (std::size_t i = 0; i < count; ++i) {
      const dvec3 now = glm::clamp((*changed)[i], dvec3(0), dvec3(255));
      const dvec3 before = glm::clamp(right.drawn[i], dvec3(0), dvec3(255));
      added[i] = right.reference[i] + now - before;
    }
    return closer(finished(together, std::move(added)), finished(together, *changed));
  }

  Colors closer(Colors a, Colors b) const {
    const Score of_a = score(points_, a.size(), a);
    const Score of_b = score(points_, b.size(), b);
    const double near = 0.02 * std::min(of_a.left, of_b.left);
    const bool alike = std::abs(of_a.left - of_b.left) <= near;
    return (alike ? of_a.raw <= of_b.raw : of_a.left < of_b.left) ? std::move(a) : std::move(b);
  }

  Score score_of(const Together& together, std::size_t count) const {
    return score(points_, count, predicted(together, count));
  }

  Tried rated(Together together, const Score& s, const Base& b) const {
    Tried t;
    t.together = std::move(together);
    t.score = s;
    t.explained = b.left > 0 ? 1 - s.left / b.left : 0;
    t.exact = b.differs > 0 ? s.exact / b.differs : 0;
    t.broken = b.same > 0 ? s.broken / b.same : 0;
    return t;
  }

  // Tries each set, in parallel if possible.
  std::vector<Tried> try_all(const std::vector<Together>& sets, std::size_t count, double from,
                             double to) {
    count = std::min(count, points_.size());
    const Base b = base(count);
    std::vector<Tried> result(sets.size());
    constexpr std::size_t chunk = 64;
    for (std::size_t start = 0; start < sets.size(); start += chunk) {
      if (!step(from +
                (to - from) * static_cast<double>(start) / static_cast<double>(sets.size()))) {
        result.resize(start);
        break;
      }
      const std::size_t end = std::min(sets.size(), start + chunk);
      for_each_task(end - start, [&](std::size_t i) {
        const Together& set = sets[start + i];
        result[start + i] = rated(set, score_of(set, count), b);
      });
    }
    return result;
  }

  static void sort_by_merit(std::vector<Tried>& list) {
    std::stable_sort(list.begin(), list.end(),
                     [](const Tried& a, const Tried& b) { return a.merit() > b.merit(); });
  }

  bool good(const Tried& t) const {
    return t.explained >= enough && t.exact >= enough_exact && t.broken <= most_broken;
  }

  // ---- searching ---------------------------------------------------------------------------

  void search() {
    std::vector<Together> singles;
    for (std::uint16_t i = 0; i < list_.size(); ++i) {
      singles.push_back({i});
    }
    if (usable_) {
      fill_cache(screen);
    }
    std::vector<Tried> ranked = try_all(singles, screen, 0, 0.3);
    sort_by_merit(ranked);
    const std::vector<Tried> alone = verified(ranked, 16, 0.3, 0.4);
    if (stopped_ && alone.empty()) {
      return;
    }
    std::optional<Tried> found;
    if (!alone.empty() && good(alone.front())) {
      if (alone.front().exact < nearly_all && claim_acne({}, alone.front().exact)) {
        return;
      }
      found = completed(alone.front());
    } else if (claim_acne({}, 0)) {
      return;
    }
    if (look_for_ == LookFor::several_at_once && !(found && sure(*found)) &&
        report_.share_different >= least_for_several) {
      std::optional<Tried> more = usable_ ? several(ranked, alone) : several_of_picture(ranked);
      if (!report_.claims.empty()) {
        return;
      }
      if (more && (!found || more->score.left < 0.6 * found->score.left)) {
        found = std::move(more);
      }
    }
    if (found && shows_much(*found) && (sure(*found) || causes_as_good(*found, alone) < 3)) {
      claim(with_shift(*found), alone);
      return;
    }
    if (!alone.empty() && alone.front().explained >= part && alone.front().exact >= part &&
        alone.front().broken <= most_broken) {
      const Hypothesis& h = list_[alone.front().together.front()];
      report_.partial.push_back(
          {h.cause, h.what,
           evidence_of_share(alone.front().explained) + "; something else is wrong, too",
           alone.front().explained});
    }
  }

  // The number of causes that give the same picture as one mistake. If it is large, the picture
  // contains almost no evidence.
  std::size_t causes_as_good(const Tried& found, const std::vector<Tried>& others) const {
    std::set<Cause> causes;
    for (const Tried& t : others) {
      if (found.together.size() == 1 && t.together.size() == 1 && good(t) &&
          t.score.raw <= tie_limit(found.score.raw, base(points_.size()).left)) {
        causes.insert(list_[t.together.front()].cause);
      }
    }
    return causes.size();
  }

  // Whether the picture with the mistakes is not just black: many mistakes make a picture black.
  bool shows_much(const Tried& t) const {
    double bright = 0;
    double matched = 0;
    const Colors colors = predicted(t.together, points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point& p = points_[i];
      if (p.differs && largest_of(p.test) > 16) {
        bright += p.weight;
        const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
        matched += largest_of(outside(c, p.low, p.high)) <= exact_within ? p.weight : 0;
      }
    }
    return matched >= 0.5 * bright;
  }

  // Whether the claim explains nearly everything, so that the search can stop.
  bool sure(const Tried& t) const { return t.explained >= 0.98 && t.exact >= nearly_all; }

  // Tries combinations of two or three mistakes. Adds claims for combinations with acne directly.
  std::optional<Tried> several(const std::vector<Tried>& ranked, const std::vector<Tried>& alone) {
    const Frame plain = frame({}, screen);
    std::vector<Frame> moved;  // after mistakes in the camera or the shapes
    for (const Together& made : likely_places(ranked)) {
      if (rays_ < work_for_pairs && step(0.45)) {
        moved.push_back(frame(made, few_points));
      }
    }
    std::vector<Tried> pairs = approximate_pairs(plain, Together(), plain.members, 120);
    pairs = tried_again(pairs, 120, 0.5, 0.55);
    std::vector<std::pair<double, const Frame*>> by_merit;
    for (const Frame& f : moved) {
      const std::vector<Tried> found = besides(f);
      by_merit.emplace_back(found.empty() ? 0 : -found.front().merit(), &f);
      append(pairs, found);
    }
    std::stable_sort(by_merit.begin(), by_merit.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
    by_merit.resize(std::min<std::size_t>(by_merit.size(), 2));
    append(pairs, with_picture(plain));
    sort_by_merit(pairs);
    std::vector<Tried> best = verified(pairs, 16, 0.6, 0.65);
    const std::optional<Tried> pair = first_good(best);
    if (pair && sure(*pair)) {
      return pair;
    }
    for (const std::vector<Tried>* list : {&alone, &std::as_const(best)}) {
      std::size_t left = 4;
      for (const Tried& t : *list) {
        if (left > 0 && t.merit() > 0.15 && t.together.size() < 3) {
          --left;
          if (claim_acne(t.together, 0)) {
            return std::nullopt;
          }
        }
      }
    }
    if (pairs.empty() || pairs.front().merit() < 0.3 || rays_ > work_for_pairs) {
      return pair;
    }
    std::vector<Tried> triples = approximate_triples(plain, pairs);
    for (const auto& [merit, f] : by_merit) {
      append(triples, approximate_pairs(*f, Together(), f->members, 40));
    }
    append(triples, pairs_with_picture(plain, pairs));
    sort_by_merit(triples);
    triples = tried_again(triples, 150, 0.7, 0.9);
    best = verified(triples, 12, 0.9, 1);
    const std::optional<Tried> triple = first_good(best);
    return triple && (!pair || triple->score.left < 0.6 * pair->score.left) ? triple : pair;
  }

  // Without the scene: only mistakes that change the finished picture.
  std::optional<Tried> several_of_picture(const std::vector<Tried>& ranked) {
    std::vector<Together> starts;
    for (std::size_t i = 0; i < std::min<std::size_t>(6, ranked.size()); ++i) {
      starts.push_back(ranked[i].together);
    }
    return first_good(verified(extended(starts, few_points, 0.4, 0.9), 12, 0.9, 1));
  }

  // When other mistakes are present, a factor that fits the rest proves little.
  bool any_measured(const Together& together) const {
    return together.size() > 1 && std::any_of(together.begin(), together.end(), [&](std::size_t i) {
             return i >= first_measured_ && list_[i].cause != Cause::background;
           });
  }

  std::optional<Tried> first_good(const std::vector<Tried>& best) {
    std::size_t left = 6;
    for (const Tried& t : best) {
      if (!good(t) || left-- == 0) {
        break;
      }
      const Tried fewer = without_needless(t);
      if (good(fewer) && (sure(fewer) || !any_measured(fewer.together))) {
        return completed(fewer);
      }
    }
    return std::nullopt;
  }

  // The picture with some mistakes, and with each single mistake in addition.
  struct Frame {
    Together made;
    std::size_t count = 0;
    Colors colors;
    std::vector<std::uint16_t> members;  // mistakes that change these colors
    std::vector<Colors> with;            // by mistake; empty: not a member
  };

  Frame frame(const Together& made, std::size_t count) {
    Frame f;
    f.made = made;
    f.count = std::min(count, points_.size());
    const Turn turn = turn_of(made);
    const Colors& right = clean(turn).drawn;
    f.colors = drawn(made, f.count, turn)
                   .value_or(Colors(right.begin(), right.begin() + std::ptrdiff_t(f.count)));
    f.with.resize(list_.size());
    for_each_task(list_.size(), [&](std::size_t i) {
      const auto other = static_cast<std::uint16_t>(i);
      if (list_[i].touches != Touches::picture && fits(made, other)) {
        if (std::optional<Colors> colors = drawn(joined(made, {other}), f.count, turn)) {
          f.with[i] = *std::move(colors);
        }
      }
    });
    for (std::uint16_t i = 0; i < list_.size(); ++i) {
      bool changes = false;
      for (std::size_t k = 0; k < f.with[i].size() && !changes; ++k) {
        const dvec3 now = glm::clamp(f.with[i][k], dvec3(0), dvec3(255));
        const dvec3 before = glm::clamp(f.colors[k], dvec3(0), dvec3(255));
        changes = largest_of(glm::abs(now - before)) > tolerance;
      }
      if (changes) {
        f.members.push_back(i);
      } else {
        f.with[i].clear();
      }
    }
    return f;
  }

  static Together joined(Together a, const Together& b) {
    a.insert(a.end(), b.begin(), b.end());
    std::sort(a.begin(), a.end());
    return a;
  }

  static void append(std::vector<Tried>& list, const std::vector<Tried>& more) {
    list.insert(list.end(), more.begin(), more.end());
  }

  // The correlation between the colors and those of the test.
  double likeness(const Colors& colors) const {
    double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < colors.size(); ++i) {
      const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
      for (int k = 0; k < 3; ++k) {
        const double x = c[k];
        const double y = points_[i].test[k];
        n += 1;
        a += x;
        b += y;
        aa += x * x;
        bb += y * y;
        ab += x * y;
      }
    }
    const double spread = (n * aa - a * a) * (n * bb - b * b);
    return spread > 0 ? (n * ab - a * b) / std::sqrt(spread) : 0;
  }

  // Mistakes to combine with all others: those that move objects closer to where the test shows
  // them, and those that explain most.
  std::vector<Together> likely_places(const std::vector<Tried>& ranked) const {
    std::vector<Together> result;
    std::vector<std::pair<double, std::uint16_t>> places;
    const std::size_t count = std::min(screen, points_.size());
    const auto first = [count](const Colors& colors) {
      return Colors(colors.begin(), colors.begin() + std::ptrdiff_t(count));
    };
    const double least = likeness(first(clean({}).drawn)) + 0.003;
    for (std::uint16_t i = 0; i < list_.size(); ++i) {
      const Hypothesis& h = list_[i];
      const bool turns = h.turn != Turn();
      if (turns || (h.touches >= Touches::hits && cache_[i].size() >= count &&
                    h.cause != Cause::half_pixel_shift)) {
        if (turns) {
          result.push_back({i});
        } else if (const double like = likeness(first(cache_[i])); like > least) {
          places.emplace_back(-like, i);
        }
      }
    }
    std::stable_sort(places.begin(), places.end());
    for (std::size_t i = 0; i < std::min<std::size_t>(6, places.size()); ++i) {
      result.push_back({places[i].second});
    }
    const auto add_first = [&](const std::vector<Tried>& list, std::size_t count_of_them) {
      for (std::size_t i = 0; i < std::min(count_of_them, list.size()); ++i) {
        const Together& t = list[i].together;
        if (list[i].merit() > 0.1 && list_[t.front()].touches != Touches::picture &&
            std::find(result.begin(), result.end(), t) == result.end()) {
          result.push_back(t);
        }
      }
    };
    add_first(ranked, 4);
    std::vector<Tried> by_exact = ranked;
    std::stable_sort(by_exact.begin(), by_exact.end(),
                     [](const Tried& x, const Tried& y) { return x.exact > y.exact; });
    add_first(by_exact, 2);
    return result;
  }

  // The frame's mistakes combined with each single one in addition.
  std::vector<Tried> besides(const Frame& f) const {
    const Base b = base(f.count);
    std::vector<Tried> result;
    for (const std::uint16_t i : f.members) {
      const Together together = joined(f.made, {i});
      result.push_back(rated(together, score(points_, f.count, finished(together, f.with[i])), b));
    }
    sort_by_merit(result);
    result.resize(std::min<std::size_t>(result.size(), 30));
    return result;
  }

  // Approximates pairs of mistakes by adding or multiplying their changes; then applies
  // `on_picture`.
  std::vector<Tried> approximate_pairs(const Frame& f, const Together& on_picture,
                                       const std::vector<std::uint16_t>& members,
                                       std::size_t most) const {
    const std::size_t count = std::min(f.count, few_points);
    const Base b = base(count);
    std::vector<std::vector<Tried>> found(members.size());
    for_each_task(members.size(), [&](std::size_t i) {
      Colors sum(count);
      Colors product(count);
      for (std::size_t j = i + 1; j < members.size(); ++j) {
        if (!fits({members[i]}, members[j])) {
          continue;
        }
        const Colors& x = f.with[members[i]];
        const Colors& y = f.with[members[j]];
        for (std::size_t k = 0; k < count; ++k) {
          const dvec3& c = f.colors[k];
          sum[k] = x[k] + y[k] - c;
          for (int channel = 0; channel < 3; ++channel) {
            product[k][channel] =
                c[channel] > 2 ? x[k][channel] * y[k][channel] / c[channel] : sum[k][channel];
          }
        }
        const Score of_sum = score(points_, count, finished(on_picture, sum));
        const Score of_product = score(points_, count, finished(on_picture, product));
        found[i].push_back(
            rated(joined(joined(f.made, on_picture), joined({members[i]}, {members[j]})),
                  of_sum.left <= of_product.left ? of_sum : of_product, b));
      }
      sort_by_merit(found[i]);
      found[i].resize(std::min(found[i].size(), most));
    });
    std::vector<Tried> result;
    for (const std::vector<Tried>& list : found) {
      append(result, list);
    }
    sort_by_merit(result);
    result.resize(std::min(result.size(), most));
    return result;
  }

  // Evaluates the best candidates exactly, by drawing them.
  std::vector<Tried> tried_again(const std::vector<Tried>& list, std::size_t most, double from,
                                 double to) {
    std::vector<Together> sets;
    for (const Tried& t : list) {
      if (sets.size() < most && std::find(sets.begin(), sets.end(), t.together) == sets.end()) {
        sets.push_back(t.together);
      }
    }
    std::vector<Tried> result = try_all(sets, few_points, from, to);
    sort_by_merit(result);
    return result;
  }

  std::vector<std::uint16_t> color_changes() const {
    std::vector<std::uint16_t> result;
    for (std::uint16_t i = 0; i < list_.size(); ++i) {
      if (list_[i].color) {
        result.push_back(i);
      }
    }
    return result;
  }

  // Combines each change of the finished picture's colors with each single mistake.
  std::vector<Tried> with_picture(const Frame& f) const {
    const std::vector<std::uint16_t> changes = color_changes();
    const std::size_t count = std::min(f.count, few_points);
    const Base b = base(count);
    std::vector<std::vector<Tried>> found(changes.size());
    for_each_task(changes.size(), [&](std::size_t p) {
      for (const std::uint16_t i : f.members) {
        if (fits({changes[p]}, i)) {
          const Colors colors(f.with[i].begin(), f.with[i].begin() + std::ptrdiff_t(count));
          const Together together = joined({changes[p]}, {i});
          found[p].push_back(rated(together, score(points_, count, finished(together, colors)), b));
        }
      }
      sort_by_merit(found[p]);
      found[p].resize(std::min<std::size_t>(found[p].size(), 60));
    });
    std::vector<Tried> result;
    for (const std::vector<Tried>& list : found) {
      append(result, list);
    }
    for (const std::uint16_t p : changes) {
      for (std::uint16_t i = 0; i < list_.size(); ++i) {
        if (list_[i].touches == Touches::picture && i != p && fits({p}, i)) {
          const Together together = joined({p}, {i});
          result.push_back(rated(together, score_of(together, count), b));
        }
      }
    }
    return result;
  }

  // Combines the most promising changes of the finished picture with two other mistakes.
  std::vector<Tried> pairs_with_picture(const Frame& f, const std::vector<Tried>& pairs) const {
    std::vector<Tried> result;
    std::map<std::uint16_t, std::vector<std::uint16_t>> members;
    for (const Tried& t : pairs) {
      if (t.together.size() != 2) {
        continue;
      }
      for (const bool second : {false, true}) {
        const std::uint16_t p = t.together[second ? 1 : 0];
        const std::uint16_t other = t.together[second ? 0 : 1];
        if (list_[p].color && !f.with[other].empty() &&
            (members.size() < 3 || members.contains(p)) && members[p].size() < 50) {
          members[p].push_back(other);
        }
      }
    }
    for (const auto& [p, others] : members) {
      append(result, approximate_pairs(f, {p}, others, 40));
    }
    return result;
  }

  // Approximates the best pairs combined with a third mistake.
  std::vector<Tried> approximate_triples(const Frame& f, const std::vector<Tried>& pairs) const {
    std::vector<Together> starts;
    for (const Tried& t : pairs) {
      const bool on_picture =
          std::any_of(t.together.begin(), t.together.end(),
                      [&](std::uint16_t i) { return list_[i].touches == Touches::picture; });
      if (t.together.size() == 2 && !on_picture && starts.size() < 24) {
        starts.push_back(t.together);
      }
    }
    const std::size_t count = std::min(f.count, few_points);
    const Base b = base(count);
    std::vector<std::vector<Tried>> found(starts.size());
    for_each_task(starts.size(), [&](std::size_t s) {
      const std::optional<Colors> start = drawn(starts[s], count, Turn());
      for (const std::uint16_t i : f.members) {
        if (!start || !fits(starts[s], i) ||
            std::find(starts[s].begin(), starts[s].end(), i) != starts[s].end()) {
          continue;
        }
        Colors colors(count);
        for (std::size_t k = 0; k < count; ++k) {
          colors[k] = (*start)[k] + f.with[i][k] - f.colors[k];
        }
        found[s].push_back(rated(joined(starts[s], {i}), score(points_, count, colors), b));
      }
    });
    std::vector<Tried> result;
    for (const std::vector<Tried>& list : found) {
      append(result, list);
    }
    sort_by_merit(result);
    result.resize(std::min<std::size_t>(result.size(), 120));
    return result;
  }

  // The best screened mistakes, evaluated at all points; among similar ones the more likely first.
  std::vector<Tried> verified(const std::vector<Tried>& ranked, std::size_t count, double from,
                              double to) {
    std::vector<Together> sets;
    for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) {
      if (ranked[i].merit() > 0.05) {
        sets.push_back(ranked[i].together);
      }
    }
    std::vector<Tried> result = try_all(sets, points_.size(), from, to);
    const double all = base(points_.size()).left;
    std::stable_sort(result.begin(), result.end(),
                     [&](const Tried& a, const Tried& b) { return a.score.raw < b.score.raw; });
    if (result.empty()) {
      return result;
    }
    // Among those with the same remaining difference, the first in the list.
    const double limit = tie_limit(result.front().score.raw, all);
    auto last = result.begin();
    while (last != result.end() && last->score.raw <= limit) {
      ++last;
    }
    std::stable_sort(result.begin(), last,
                     [](const Tried& a, const Tried& b) { return a.together < b.together; });
    std::stable_partition(result.begin(), result.end(), [&](const Tried& t) { return good(t); });
    return result;
  }

  // Combines each start with each single mistake that it does not contain.
  std::vector<Tried> extended(const std::vector<Together>& starts, std::size_t count, double from,
                              double to) {
    std::vector<Together> sets;
    for (const Together& start : starts) {
      for (std::uint16_t i = 0; i < list_.size(); ++i) {
        Together together = start;
        if (std::find(start.begin(), start.end(), i) == start.end() && fits(start, i)) {
          together.push_back(i);
          std::sort(together.begin(), together.end());
          sets.push_back(together);
        }
      }
    }
    std::sort(sets.begin(), sets.end());
    sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
    std::vector<Tried> result = try_all(sets, count, from, to);
    sort_by_merit(result);
    return result;
  }

  // Two mistakes of the same kind rarely combine: one replaces the other.
  bool fits(const Together& start, std::uint16_t other) const {
    if (list_[other].touches == Touches::shapes && shapes_->parts.size() > most_edited) {
      return false;
    }
    return std::none_of(start.begin(), start.end(), [&](std::uint16_t i) {
      const Hypothesis& a = list_[i];
      const Hypothesis& b = list_[other];
      const bool shift = a.cause == Cause::half_pixel_shift || b.cause == Cause::half_pixel_shift;
      return shift ||
             (a.cause == b.cause && a.cause != Cause::specular && a.cause != Cause::texture &&
              a.cause != Cause::shapes) ||
             (a.touches == Touches::shapes && b.touches == Touches::shapes &&
              a.cause == Cause::transforms);
    });
  }

  // Adds the mistake that explains most of the remaining difference, if any.
  Tried completed(const Tried& found) {
    const Base b = base(points_.size());
    if (stopped_ || found.together.size() > 2) {
      return found;
    }
    std::vector<Point> points = points_;
    std::array<Clean, 4> clean_before = clean_;
    std::vector<Colors> cache = std::move(cache_);
    const std::optional<Tried> more = with_one_more(found, b);
    points_ = std::move(points);
    clean_ = std::move(clean_before);
    cache_ = std::move(cache);
    return more ? completed(*more) : found;
  }

  std::optional<Tried> with_one_more(const Tried& found, const Base& b) {
    const std::size_t count = look_first_at_rest(found.together);
    if (count < few_pixels) {
      return std::nullopt;
    }
    std::vector<Together> sets;
    for (std::uint16_t i = 0; i < list_.size(); ++i) {
      if (std::find(found.together.begin(), found.together.end(), i) == found.together.end() &&
          fits(found.together, i)) {
        sets.push_back(joined(found.together, {i}));
      }
    }
    std::vector<Tried> more = try_all(sets, count, 0.7, 0.9);
    std::stable_sort(more.begin(), more.end(),
                     [](const Tried& x, const Tried& y) { return x.score.left < y.score.left; });
    more.resize(std::min<std::size_t>(more.size(), 8));
    for (const Tried& t : more) {
      const Tried whole = rated(t.together, score_of(t.together, points_.size()), b);
      if (whole.score.left < 0.6 * found.score.left && good(whole) && each_needed(whole.together)) {
        return whole;
      }
    }
    return std::nullopt;
  }

  // Moves points that the mistakes do not explain to the front, with one right point in four.
  // Returns their number.
  std::size_t look_first_at_rest(const Together& together) {
    const Colors colors = predicted(together, points_.size());
    std::vector<Point> wrong;
    std::vector<Point> right;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point& p = points_[i];
      const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
      (largest_of(outside(c, p.low, p.high)) > exact_within ? wrong : right).push_back(p);
    }
    const std::size_t count = std::min<std::size_t>(wrong.size(), screen);
    points_.clear();
    std::size_t r = 0;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      points_.push_back(wrong[i]);
      if (i % 3 == 2 && r < right.size()) {
        points_.push_back(right[r++]);
      }
    }
    points_.insert(points_.end(), right.begin() + std::ptrdiff_t(r), right.end());
    cache_.clear();
    prepare_clean();
    return count + count / 3;
  }

  bool each_needed(const Together& together) const {
    for (std::size_t i = 0; i < together.size(); ++i) {
      if (!needed(together, i)) {
        return false;
      }
    }
    return true;
  }

  // Whether one of several mistakes is needed: where it changes the picture, the picture is right
  // with it and wrong without it.
  bool needed(const Together& together, std::size_t member) const {
    Together fewer = together;
    fewer.erase(fewer.begin() + std::ptrdiff_t(member));
    const std::size_t count = points_.size();
    const Colors with = predicted(together, count);
    const Colors without = predicted(fewer, count);
    double changed = 0;
    double gained = 0;
    double shown = 0;  // of what is gained: not darkness
    for (std::size_t i = 0; i < count; ++i) {
      const Point& p = points_[i];
      const dvec3 a = glm::clamp(with[i], dvec3(0), dvec3(255));
      const dvec3 b = glm::clamp(without[i], dvec3(0), dvec3(255));
      if (largest_of(glm::abs(a - b)) > right_within) {
        double gain = largest_of(outside(a, p.low, p.high)) <= exact_within ? p.weight : 0;
        gain -= largest_of(outside(b, p.low, p.high)) <= exact_within ? p.weight : 0;
        changed += p.weight;
        gained += gain;
        shown += largest_of(p.test) > 16 ? gain : 0;
      }
    }
    // Whatever moves everything out of sight gives darkness.
    const bool moves = list_[together[member]].touches >= Touches::camera;
    return changed >= necessary * weight_that_differs(count) && gained >= 0.4 * changed &&
           (!moves || shown >= 0.1 * gained);
  }

  Tried without_needless(Tried found) {
    const Base b = base(points_.size());
    for (std::size_t i = 0; found.together.size() > 1 && i < found.together.size();) {
      if (needed(found.together, i)) {
        ++i;
        continue;
      }
      Together fewer = found.together;
      fewer.erase(fewer.begin() + std::ptrdiff_t(i));
      found = rated(fewer, score_of(fewer, points_.size()), b);
      i = 0;
    }
    return found;
  }

  void claim(const Tried& found, const std::vector<Tried>& others) {
    const Base b = base(points_.size());
    const double values = 3.0 * test_.width * test_.height;
    for (const std::uint16_t i : found.together) {
      Claim one{list_[i].cause, list_[i].what, {}, found.explained};
      if (found.together.size() == 1) {
        one.evidence = evidence_of_one(found.score.left / values, b.left / values, found.exact);
      } else {
        const Tried alone = rated({i}, score_of({i}, points_.size()), b);
        one.evidence = evidence_of_several(found.explained, alone.explained);
      }
      report_.claims.push_back(std::move(one));
    }
    if (found.together.size() > 1) {
      return;
    }
    std::string same;
    for (const Tried& t : others) {
      const Hypothesis& h = list_[t.together.front()];
      const bool listed = h.cause == list_[found.together.front()].cause ||
                          std::any_of(report_.rivals.begin(), report_.rivals.end(),
                                      [&](const Claim& c) { return c.cause == h.cause; });
      if (t.together.size() == 1 && !listed && good(t) && report_.rivals.size() < 3 &&
          t.score.raw <= found.score.raw + rival_margin * b.left) {
        report_.rivals.push_back({h.cause, h.what, evidence_of_share(t.explained), t.explained});
        if (t.score.raw <= tie_limit(found.score.raw, b.left)) {
          report_.rivals.back().said = true;
          same += "; or " + h.what;
        }
      }
    }
    if (!same.empty()) {
      report_.claims.back().what += same + ": the pictures are the same";
    }
  }

  // Mistakes that leave at most this difference count as equal to one that leaves `raw` of `all`.
  static double tie_limit(double raw, double all) { return 1.1 * raw + 0.0003 * all; }

  // ---- causes that are estimated, not simulated -------------------------------------------

  // A uniform color where nothing is hit.
  void add_background() {
    std::map<std::array<int, 3>, double> colors;
    double all = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (clean({}).hits[i].part == nullptr && points_[i].differs) {
        const dvec3& t = points_[i].test;
        colors[{int(t.x), int(t.y), int(t.z)}] += points_[i].weight;
        all += points_[i].weight;
      }
    }
    if (all == 0) {
      return;
    }
    const auto most =
        std::max_element(colors.begin(), colors.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most->second < 0.7 * all) {
      return;
    }
    const dvec3 color = dvec3(most->first[0], most->first[1], most->first[2]) / 255.0;
    for (const bool in_reflections : {false, true}) {
      list_.push_back(
          {Cause::background,
           fmt::format("the background is {} {} {}, not black{}", most->first[0], most->first[1],
                       most->first[2], in_reflections ? ", and reflections show it" : ""),
           Touches::shading,
           [=](Trial& t) {
             t.mistakes.background = color;
             t.mistakes.background_in_reflections = in_reflections;
           },
           {},
           {}});
    }
  }

  // The value that most of `found` agree on, if they do.
  static std::optional<double> common_value(std::vector<double>& found) {
    if (found.size() < 3 * few_pixels) {
      return std::nullopt;
    }
    const auto middle = found.begin() + std::ptrdiff_t(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    const double value = *middle;
    const auto close = std::count_if(found.begin(), found.end(), [&](double x) {
      return std::abs(x - value) <= 0.04 * std::max(std::abs(value), 0.25);
    });
    return 2 * static_cast<std::size_t>(close) >= found.size() ? std::optional(value)
                                                               : std::nullopt;
  }

  // The brightness, the gamma, or a number that was added, estimated from the pictures.
  void add_curves() {
    std::vector<double> factors;
    std::vector<double> powers;
    std::vector<double> steps;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const dvec3& r = clean({}).reference[i];
      const dvec3& t = points_[i].test;
      for (int channel = 0; points_[i].differs && channel < 3; ++channel) {
        if (r[channel] > 20 && r[channel] < 235 && t[channel] > 4 && t[channel] < 250) {
          factors.push_back((t[channel] + 0.5) / (r[channel] + 0.5));
          powers.push_back(std::log((t[channel] + 0.5) / 255) / std::log((r[channel] + 0.5) / 255));
        }
        if (points_[i].differs && t[channel] > 0 && t[channel] < 255) {
          steps.push_back(t[channel] - r[channel]);
        }
      }
    }
    if (const std::optional<double> n = common_value(steps); n && std::abs(*n) > 4) {
      list_.push_back({Cause::brightness,
                       fmt::format("{:.0f} of 255 was {} all values", std::abs(*n),
                                   *n > 0 ? "added to" : "subtracted from"),
                       Touches::picture,
                       {},
                       {},
                       [n = *n / 255](const dvec3& c) { return n + clamped(c); }});
    }
    if (const std::optional<double> k = common_value(factors); k && std::abs(*k - 1) > 0.05) {
      list_.push_back({Cause::brightness,
                       fmt::format("the picture is {:.2f} times as bright as it should be", *k),
                       Touches::picture,
                       {},
                       {},
                       [k = *k](const dvec3& c) { return k * glm::clamp(c, dvec3(0), dvec3(1)); }});
    }
    if (const std::optional<double> p = common_value(powers); p && std::abs(*p - 1) > 0.05) {
      list_.push_back(
          {Cause::gamma,
           *p < 1 ? fmt::format("gamma {:.2f} was applied, but the format has no gamma correction",
                                1 / *p)
                  : fmt::format("values were taken to the power of {:.2f}", *p),
           Touches::picture,
           {},
           {},
           [p = *p](const dvec3& c) {
             return glm::pow(glm::clamp(c, dvec3(0), dvec3(1)), dvec3(p));
           }});
    }
  }

  bool any_texture() const {
    return view_->options.mode == Mode::ray && view_->options.features.texture &&
           std::any_of(view_->scene->materials.begin(), view_->scene->materials.end(),
                       [](const RenderMaterial& m) { return m.texture.used() && m.blend != 0; });
  }

  // Terms and lights that are too bright or too dark by a factor, estimated from the pictures.
  void add_factors() {
    using Change = std::function<void(Trial&, double)>;
    const auto try_factor = [&](Cause cause, const std::string& what, const Change& change) {
      Trial without = right_trial(false);
      change(without, 0);
      const std::size_t count = std::min<std::size_t>(points_.size(), 300);
      const Colors dark = draw(without, *shapes_, points_, count, Turn(), &clean({}).hits);
      std::vector<double> found;
      for (std::size_t i = 0; i < count; ++i) {
        const dvec3 term = clean({}).drawn[i] - dark[i];
        for (int channel = 0; points_[i].differs && channel < 3; ++channel) {
          const double t = points_[i].test[channel];
          if (std::abs(term[channel]) > 12 && t > 1 && t < 254) {
            found.push_back(1 + (t + 0.5 - clean({}).drawn[i][channel]) / term[channel]);
          }
        }
      }
      const std::optional<double> k = common_value(found);
      if (k && *k > 0.03 && *k < 12 && std::abs(*k - 1) > 0.05 && std::abs(*k - 0.5) > 0.01 &&
          std::abs(*k - 2) > 0.03) {
        list_.push_back({cause,
                         fmt::format("{} {:.2f} times as bright as in the reference", what, *k),
                         Touches::shading,
                         [change, k = *k](Trial& t) { change(t, k); },
                         {},
                         {}});
      }
    };
    if (view_->options.mode == Mode::normals) {
      return;
    }
    try_factor(Cause::ambient, "the ambient term is",
               [](Trial& t, double k) { t.scene.global.ambient *= static_cast<float>(k); });
    try_factor(Cause::diffuse, "the diffuse term is",
               [](Trial& t, double k) { t.mistakes.diffuse_factor *= k; });
    if (any_texture()) {
      try_factor(Cause::diffuse, "the diffuse term, but for textures, is",
                 [](Trial& t, double k) { t.scene.global.diffuse *= static_cast<float>(k); });
    }
    try_factor(Cause::specular, "the specular term is", [](Trial& t, double k) {
      for (RenderMaterial& m : t.scene.materials) {
        m.specular *= static_cast<float>(k);
      }
    });
    try_factor(Cause::reflection, "reflections are",
               [](Trial& t, double k) { t.mistakes.mirror_factor *= k; });
    try_factor(Cause::refraction, "refraction is",
               [](Trial& t, double k) { t.mistakes.glass_factor *= k; });
    const std::size_t lights = view_->scene->lights.size();
    try_factor(Cause::lights, "the light of all lights is", [](Trial& t, double k) {
      for (RenderLight& light : t.scene.lights) {
        light.color *= static_cast<float>(k);
      }
    });
    for (std::size_t i = 0; lights > 1 && i < std::min<std::size_t>(lights, 8); ++i) {
      try_factor(Cause::lights,
                 fmt::format("light {} ({}) is", i + 1, word_of(view_->scene->lights[i].type)),
                 [i](Trial& t, double k) {
                   if (i < t.scene.lights.size()) {
                     t.scene.lights[i].color *= static_cast<float>(k);
                   }
                 });
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(lights, 8); ++i) {
      add_color_of_light(i);
    }
  }

  // The color of a light, estimated from the pictures by channel.
  void add_color_of_light(std::size_t light) {
    Trial without = right_trial(false);
    without.scene.lights[light].color = glm::vec3(0);
    const std::size_t count = std::min<std::size_t>(points_.size(), 400);
    const Colors dark = draw(without, *shapes_, points_, count, Turn(), &clean({}).hits);
    dvec3 factors(1);
    for (int channel = 0; channel < 3; ++channel) {
      std::vector<double> found;
      for (std::size_t i = 0; i < count; ++i) {
        const double term = clean({}).drawn[i][channel] - dark[i][channel];
        const double t = points_[i].test[channel];
        if (points_[i].differs && std::abs(term) > 12 && t < 254) {
          found.push_back(1 + (t + 0.5 - clean({}).drawn[i][channel]) / term);
        }
      }
      factors[channel] = common_value(found).value_or(1);
    }
    const glm::vec3 color = glm::max(view_->scene->lights[light].color * glm::vec3(factors), 0.0f);
    const double spread = largest_of(factors) - std::min({factors.x, factors.y, factors.z});
    if (spread < 0.1 || largest_of(factors) > 12) {
      return;
    }
    list_.push_back(
        {Cause::lights,
         fmt::format("the color of light {} ({}) is {:.2g} {:.2g} {:.2g}", light + 1,
                     word_of(view_->scene->lights[light].type), color.x, color.y, color.z),
         Touches::shading,
         [light, color](Trial& t) {
           if (light < t.scene.lights.size()) {
             t.scene.lights[light].color = color;
           }
         },
         {},
         {}});
  }

  // Pixels are black if any of their samples hits nothing, which gives black outlines, one pixel
  // wide.
  bool claim_missed_samples() {
    const Trial trial = right_trial(false);
    const Model model(trial.scene, *shapes_, *view_->assets, trial.options, trial.mistakes);
    std::size_t partly = 0;
    std::size_t black = 0;
    std::size_t whole = 0;
    std::size_t bright = 0;
    std::size_t candidates = 0;
    const std::size_t all = std::size_t(test_.width) * test_.height;
    std::mt19937 random(5);
    for (std::size_t i = 0; i < all && candidates < 3000; ++i) {
      const auto x = static_cast<int>(i % std::size_t(test_.width));
      const auto y = static_cast<int>(i / std::size_t(test_.width));
      const Range range = around(reference_, x, y);
      if (range.calm() || largest_of(range.low) > 4 || largest_of(at(reference_, x, y)) < 24) {
        continue;
      }
      ++candidates;
      int hits = 0;
      for (int k = 0; k < 4; ++k) {
        const dvec2 place(x + 0.25 + 0.5 * (k % 2), y + 0.25 + 0.5 * (k / 2));
        hits += model.first_hit(model.camera_ray(place, test_.width, test_.height)).part != nullptr;
      }
      if (hits > 0 && hits < 4) {
        ++partly;
        black += largest_of(at(test_, x, y)) <= 3 ? 1 : 0;
      } else if (hits == 4) {
        ++whole;
        bright += largest_of(at(test_, x, y)) > 3 ? 1 : 0;
      }
    }
    if (partly < few_pixels || static_cast<double>(black) < 0.9 * static_cast<double>(partly) ||
        whole < few_pixels || static_cast<double>(bright) < 0.9 * static_cast<double>(whole)) {
      return false;
    }
    report_.claims.push_back(
        {Cause::samples, "pixels stay black where one of several samples misses everything",
         fmt::format("{} of the pixels that objects cover partly are black",
                     percent(static_cast<double>(black) / static_cast<double>(partly))),
         static_cast<double>(black) / static_cast<double>(partly)});
    return true;
  }

  // The mean of the pixels around, by weights of columns and rows.
  dvec3 mean_around(int x, int y, const std::vector<double>& weights, int before) const {
    dvec3 sum(0);
    double all = 0;
    for (int v = 0; v < static_cast<int>(weights.size()); ++v) {
      for (int u = 0; u < static_cast<int>(weights.size()); ++u) {
        const int column = std::clamp(x + u - before, 0, test_.width - 1);
        const int row = std::clamp(y + v - before, 0, test_.height - 1);
        const double w =
            weights[static_cast<std::size_t>(u)] * weights[static_cast<std::size_t>(v)];
        sum += w * at(reference_, column, row);
        all += w;
      }
    }
    return sum / all;
  }

  bool claim_blur(const Pixels& pixels) {
    std::vector<Point> points;
    std::mt19937 random(6);
    add_points(reference_, test_, pixels.off, 800, true, true, random, points);
    add_points(reference_, test_, pixels.same, 300, false, true, random, points);
    struct Filter {
      const char* what;
      std::vector<double> weights;
      int before;
    };
    static const std::array<Filter, 6> filters{{{"3 by 3 pixels", {1, 1, 1}, 1},
                                                {"5 by 5 pixels", {1, 1, 1, 1, 1}, 2},
                                                {"2 by 2 pixels", {1, 1}, 0},
                                                {"2 by 2 pixels", {1, 1}, 1},
                                                {"3 by 3 pixels, weighted", {1, 2, 1}, 1},
                                                {"5 by 5 pixels, weighted", {1, 4, 6, 4, 1}, 2}}};
    for (const Filter& filter : filters) {
      Colors predicted;
      Colors before;
      for (const Point& p : points) {
        predicted.push_back(mean_around(p.x, p.y, filter.weights, filter.before));
        before.push_back(at(reference_, p.x, p.y));
      }
      const Score s = score(points, points.size(), predicted);
      const Score b = score(points, points.size(), before);
      double differs = 0;
      double same = 0;
      for (const Point& p : points) {
        (p.differs ? differs : same) += p.weight;
      }
      if (differs > 0 && s.left < (1 - enough) * b.left && s.exact >= enough_exact * differs &&
          s.broken <= most_broken * same) {
        report_.claims.push_back(
            {Cause::samples,
             fmt::format("the picture is blurred: each pixel is the mean of {}", filter.what),
             evidence_of_share(1 - s.left / b.left), 1 - s.left / b.left});
        return true;
      }
    }
    return false;
  }

  // Whether the test's color is `full` without some of the lights, after applying `shown`.
  template <typename Shown>
  static bool lacks_lights(const dvec3& test, const dvec3& full, const std::vector<dvec3>& shares,
                           const Shown& shown) {
    const std::size_t count = std::min<std::size_t>(shares.size(), 5);
    for (unsigned subset = 1; subset < 1u << count; ++subset) {
      dvec3 c = full;
      for (std::size_t i = 0; i < count; ++i) {
        c -= (subset >> i & 1) != 0 ? shares[i] : dvec3(0);
      }
      if (largest_of(glm::abs(shown(c) - test)) <= 4) {
        return true;
      }
    }
    return false;
  }

  // Acne, in addition to the mistakes `made`. `least`: the share of the differing pixels
  // that it must explain.
  bool claim_acne(const Together& made, double least) {
    if (!usable_ || !view_->options.features.shadows || view_->options.mode != Mode::ray ||
        turn_of(made) != Turn()) {
      return false;
    }
    const Trial trial = trial_of(made);
    const std::shared_ptr<const ModelShapes> shapes = shapes_of(trial, touched_by(made));
    const Model model(trial.scene, *shapes, *view_->assets, trial.options, trial.mistakes);
    Trial unlit = trial;
    unlit.scene.lights.clear();
    const Model dark(unlit.scene, *shapes, *view_->assets, unlit.options, unlit.mistakes);
    const auto shown = [&](const dvec3& c) {
      return glm::clamp(finished(made, {255.0 * c}).front(), dvec3(0), dvec3(255));
    };
    std::size_t looked_at = 0;
    std::size_t differing = 0;
    std::size_t between = 0;
    std::size_t scattered = 0;
    std::size_t dull = 0;
    std::size_t lacking = 0;
    std::size_t mirrors = 0;
    std::size_t seeing_themselves = 0;
    std::size_t beside_right = 0;
    for (std::size_t i = 0; i < points_.size() && looked_at < 400; ++i) {
      const Point& p = points_[i];
      if (!p.differs) {
        continue;
      }
      const ModelRay ray = model.camera_ray(middle(p, {}) + trial.shift, test_.width, test_.height);
      const ModelHit hit = made.empty() ? clean({}).hits[i] : model.first_hit(ray);
      ++differing;
      const dvec3 full = made.empty() ? clean({}).drawn[i] / 255.0 : model.color(ray, &hit);
      if (hit.part == nullptr ||
          (!made.empty() && largest_of(outside(shown(full), p.low, p.high)) <= exact_within)) {
        continue;
      }
      ++looked_at;
      const dvec3 a = shown(dark.color(ray));
      const dvec3 b = shown(full);
      between += largest_of(outside(p.test, glm::min(a, b) - 4.0, glm::max(a, b) + 4.0)) <= 0;
      const bool beside = made.empty() ? right_beside(p) : drawn_beside(p, model, trial, shown);
      scattered += beside ? 1 : 0;
      const RenderMaterial& m = trial.scene.materials[hit.part->material];
      // Mirrors with self-intersections may show anything.
      if (m.reflective == glm::vec3(0) && m.transparent == glm::vec3(0)) {
        ++dull;
        // If little light is missing, some set of lights always fits.
        lacking += largest_of(glm::abs(b - p.test)) > 8 &&
                           lacks_lights(p.test, full, model.light_shares(ray), shown)
                       ? 1
                       : 0;
      } else if (m.transparent == glm::vec3(0) && mirrors < 150) {
        ++mirrors;
        const std::vector<dvec3> seen = model.self_mirrored(ray, 16);
        seeing_themselves += std::any_of(seen.begin(), seen.end(), [&](const dvec3& c) {
          return largest_of(glm::abs(shown(c) - p.test)) <= 3;
        });
        beside_right += beside ? 1 : 0;
      }
    }
    const auto share = [](std::size_t part_of, std::size_t whole) {
      return static_cast<double>(part_of) / static_cast<double>(std::max<std::size_t>(1, whole));
    };
    // The other mistakes must explain the pixels outside the spots.
    if (!made.empty() && (share(looked_at, differing) > 0.75 || share(scattered, looked_at) < 0.4 ||
                          !each_needed(made))) {
      return false;
    }
    if (made.empty() && mirrors >= 3 * few_pixels && share(seeing_themselves, mirrors) >= 0.85 &&
        share(beside_right, mirrors) >= 0.25 && 4 * mirrors > 3 * (mirrors + dull) &&
        share(seeing_themselves, mirrors) >= least) {
      report_.claims.push_back(
          {Cause::acne,
           "reflected rays hit the surface that they start from, in spots (acne): offset their "
           "start from the surface",
           fmt::format("{} of the pixels that differ on mirrors show the mirror itself",
                       percent(share(seeing_themselves, mirrors))),
           share(seeing_themselves, mirrors)});
      return true;
    }
    if (looked_at < few_pixels || dull < few_pixels ||
        share(scattered, looked_at) < (share(lacking, dull) < 0.97 ? 0.4 : 0.25) ||
        share(lacking, dull) < std::max(0.85, least) ||
        share(between, looked_at) < (share(lacking, dull) < 0.95 ? 0.85 : 0.5)) {
      return false;
    }
    for (const std::uint16_t i : made) {
      report_.claims.push_back(
          {list_[i].cause, list_[i].what,
           fmt::format(
               "simulating this mistake explains {} of the pixels that differ; the others are "
               "spots",
               percent(1 - share(looked_at, differing))),
           1 - share(looked_at, differing)});
    }
    report_.claims.push_back(
        {Cause::acne,
         "surfaces shadow themselves in spots (shadow acne): offset the start of shadow rays from "
         "the surface",
         fmt::format("{} of the pixels that differ{} on surfaces without reflections lack exactly "
                     "the contribution of one or more lights, and correct pixels lie between them",
                     percent(share(lacking, dull)), made.empty() ? "" : " still"),
         share(between, looked_at)});
    return true;
  }

  // Whether a neighboring pixel has the color drawn with the mistakes.
  template <typename Shown>
  bool drawn_beside(const Point& p, const Model& model, const Trial& trial,
                    const Shown& shown) const {
    for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, test_.height - 1); ++y) {
      for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, test_.width - 1); ++x) {
        const dvec3 c = shown(model.color(
            model.camera_ray(dvec2(x + 0.5, y + 0.5) + trial.shift, test_.width, test_.height)));
        if (largest_of(glm::abs(c - at(test_, x, y))) <= 3) {
          return true;
        }
      }
    }
    return false;
  }

  bool right_beside(const Point& p) const {
    int right = 0;
    for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, test_.height - 1); ++y) {
      for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, test_.width - 1); ++x) {
        right += largest_of(glm::abs(at(test_, x, y) - at(reference_, x, y))) <= 3 ? 1 : 0;
      }
    }
    return right >= 1;
  }

  // Adds a claim of a subpixel shift if the edges of the picture show one.
  Tried with_shift(const Tried& found) {
    if (!usable_ || touched_by(found.together) >= Touches::camera || found.together.size() > 2) {
      return found;
    }
    std::vector<Point> points = points_;
    std::array<Clean, 4> clean_before = clean_;
    std::vector<Colors> cache = std::move(cache_);
    const std::optional<std::uint16_t> shift = shift_at_edges(found.together);
    points_ = std::move(points);
    clean_ = std::move(clean_before);
    cache_ = std::move(cache);
    if (!shift) {
      return found;
    }
    const Together together = joined(found.together, {*shift});
    return rated(together, score_of(together, points_.size()), base(points_.size()));
  }

  std::optional<std::uint16_t> shift_at_edges(const Together& together) {
    points_.clear();
    cache_.clear();
    std::vector<std::uint32_t> edges;
    for (int y = 1; y + 1 < reference_.height; ++y) {
      for (int x = 1; x + 1 < reference_.width; ++x) {
        if (!around(reference_, x, y).calm()) {
          edges.push_back(static_cast<std::uint32_t>(y * reference_.width + x));
        }
      }
    }
    std::mt19937 random(7);
    add_points(reference_, test_, edges, 800, true, true, random, points_);
    prepare_clean();
    const std::size_t count = points_.size();
    const Colors before = predicted(together, count);
    std::vector<std::uint16_t> shifts;
    for (std::uint16_t i = 0; i < list_.size(); ++i) {
      if (list_[i].cause == Cause::half_pixel_shift) {
        shifts.push_back(i);
      }
    }
    std::optional<std::uint16_t> best;
    double most = 0.5;
    for (const std::uint16_t i : shifts) {
      const Colors after = predicted(joined(together, {i}), count);
      double changed = 0;
      double gained = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const auto off = [&](const dvec3& c) {
          return largest_of(glm::abs(glm::clamp(c, dvec3(0), dvec3(255)) - points_[k].test));
        };
        if (largest_of(glm::abs(after[k] - before[k])) > right_within) {
          changed += 1;
          gained += off(after[k]) <= exact_within ? 1 : 0;
          gained -= off(before[k]) <= exact_within ? 1 : 0;
        }
      }
      if (changed >= 2 * few_pixels && gained > most * changed) {
        most = gained / changed;
        best = i;
      }
    }
    return best;
  }

  // Subpixel shifts are only visible at edges.
  void search_shifts(const Pixels& pixels) {
    points_.clear();
    std::mt19937 random(3);
    add_points(reference_, test_, pixels.off, 1500, true, true, random, points_);
    const std::size_t before = points_.size();
    drop_what_samples_explain(false);
    if (points_.size() < few_pixels || points_.size() < before / 4) {
      return;
    }
    const std::size_t different = points_.size();
    add_points(reference_, test_, pixels.same, 500, false, true, random, points_);
    interleave(different);
    prepare_clean();
    std::vector<Together> shifts;
    for (std::uint16_t i = 0; i < list_.size(); ++i) {
      if (list_[i].cause == Cause::half_pixel_shift || list_[i].touches == Touches::camera) {
        shifts.push_back({i});
      }
    }
    std::vector<Tried> tried = try_all(shifts, points_.size(), 0.95, 1);
    std::stable_sort(tried.begin(), tried.end(),
                     [](const Tried& a, const Tried& b) { return a.score.raw < b.score.raw; });
    if (tried.empty()) {
      return;
    }
    // Only a subpixel shift leaves this much of the edges unexplained.
    const Tried& best = tried.front();
    const bool by_less = list_[best.together.front()].cause == Cause::half_pixel_shift;
    if (by_less ? best.explained >= enough_shift && best.exact >= 0.5 : good(best)) {
      claim(best, {});
    }
  }

  const Texture& reference_;
  const Texture& test_;
  const SceneView* view_;
  const std::function<bool(double)>& go_on_;
  LookFor look_for_;
  std::shared_ptr<const ModelShapes> shapes_;
  std::vector<Hypothesis> list_;
  std::vector<Point> points_;
  std::array<Clean, 4> clean_;
  std::vector<Colors> cache_;  // by single mistake, at the first points
  mutable std::atomic<std::uint64_t> rays_ = 0;
  std::size_t first_measured_ = 0;  // in the list: factors estimated from the pictures
  bool usable_ = false;
  bool stopped_ = false;
  CauseReport report_;
};

// Counts of values that are one higher, one lower, or differ by more.
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
std::optional<Claim> find_rounding(const Texture& reference, const Texture& test,
                                   double share_different) {
  const Steps steps = count_steps(reference, test);
  const auto values = static_cast<double>(test.rgb.size());
  const auto near = static_cast<double>(steps.up + steps.down);
  const auto larger = static_cast<double>(std::max(steps.up, steps.down));
  if (near < 0.05 * values || larger < 0.9 * near || static_cast<double>(steps.far) > near ||
      share_different > most_for_rounding) {
    return std::nullopt;
  }
  const bool up = steps.up > steps.down;
  return Claim{Cause::rounding,
               up ? "values are rounded where the reference truncates (not a mistake by itself)"
                  : "values are truncated where the reference rounds (not a mistake by itself)",
               fmt::format("{} of all values are off by one, {} of those to the {} side",
                           percent(near / values), percent(larger / near), up ? "bright" : "dark"),
               near / (near + static_cast<double>(steps.far))};
}

}  // namespace

std::string_view name_of(Cause cause) {
  static constexpr std::array<std::string_view, cause_count> names{
      "vertical-flip",    "horizontal-flip", "gamma",      "rounding",   "swapped-channels",
      "half-pixel-shift", "ambient",         "diffuse",    "specular",   "blinn",
      "attenuation",      "normals",         "shadows",    "acne",       "texture",
      "recursion-depth",  "spot-falloff",    "camera",     "transforms", "shapes",
      "nearest-hit",      "lights",          "reflection", "refraction", "overflow",
      "background",       "brightness",      "black",      "features",   "samples",
      "tessellation",     "facets",          "culling",    "clipping",   "filter",
      "viewport"};
  return names[static_cast<std::size_t>(cause)];
}

std::optional<std::uint32_t> source_at(const SceneView& view, const glm::ivec2& pixel,
                                       const glm::ivec2& size) {
  const auto shapes = flatten(*view.scene, *view.assets);
  if (shapes == nullptr) {
    return std::nullopt;
  }
  const ModelMistakes right;
  const Model model(*view.scene, *shapes, *view.assets, view.options, right);
  const ModelHit hit = model.first_hit(model.camera_ray(glm::dvec2(pixel) + 0.5, size.x, size.y));
  return hit.part == nullptr ? std::nullopt : std::optional(hit.part->source);
}

SceneView most_alike(const Texture& reference, std::span<const SceneView> views) {
  return views[equally_alike(reference, views).front()];
}

std::vector<std::size_t> equally_alike(const Texture& reference, std::span<const SceneView> views) {
  const auto shapes = flatten(*views.front().scene, *views.front().assets);
  if (shapes == nullptr || views.size() == 1) {
    return {0};
  }
  std::mt19937 random(4);
  std::vector<std::uint32_t> pixels(std::size_t(reference.width) * reference.height);
  for (std::uint32_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = i;
  }
  std::vector<Point> points;
  add_points(reference, reference, std::move(pixels), 1200, false, false, random, points);
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const ModelMistakes right;
    const Model model(*views[i].scene, *shapes, *views[i].assets, views[i].options, right);
    Colors colors;
    for (const Point& p : points) {
      colors.push_back(
          255.0 * model.pixel({p.x + 0.5, p.y + 0.5}, reference.width, reference.height, nullptr));
    }
    const double left = score(points, points.size(), colors).left;
    if (left < least) {
      best.clear();
    }
    if (left <= least) {
      least = left;
      best.push_back(i);
    }
  }
  return best;
}

CauseReport find_causes(const Texture& reference, const Texture& test, const SceneView* view,
                        const std::function<bool(double done)>& go_on, LookFor look_for) {
  if (reference.width != test.width || reference.height != test.height || reference.empty()) {
    return {};
  }
  const ThreadLimit limit(view != nullptr ? view->options.threads : 0);
  CauseReport report = Search(reference, test, view, go_on, look_for).run();
  if (report.claims.empty() && report.partial.empty()) {
    if (std::optional<Claim> rounding = find_rounding(reference, test, report.share_different)) {
      report.claims.push_back(*std::move(rounding));
    }
  }
  return report;
}

}  // namespace scenefile
