#pragma once
// Simulates mistakes at sample points of a picture, and measures how much of its difference from
// the reference they explain. Internal to grade.

#include "scenefile/grade/causes.h"
#include "scenefile/grade/evidence.h"
#include "scenefile/mistakes/hypotheses.h"
#include "scenefile/mistakes/model.h"

#include <array>
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace scenefile {

/// One or several mistakes, as sorted indices into Simulation::list.
using Combination = std::vector<std::uint16_t>;

inline constexpr std::uint16_t no_member = 0xffff;

/// A combination and its score.
struct Tried {
  Combination mistakes;
  Score score;
  double explained = 0;  ///< share of the difference that it removes, <= 1
  double exact = 0;      ///< share of the differing points that it reproduces
  double broken = 0;     ///< share of the equal points that it changes
  double merit() const { return 0.5 * explained + 0.5 * exact - broken; }
};

struct Simulation {
  /// The picture without mistakes, by point.
  struct Clean {
    Colors reference;
    Colors drawn;  ///< empty if the scene is not usable
    std::vector<ModelHit> hits;
    std::uint64_t work = 0;  ///< in rays
  };
  /// What is to be explained.
  struct Base {
    double left = 0;
    double differs = 0;
    double same = 0;
  };

  const Texture& reference;
  const Texture& test;
  const SceneView* view = nullptr;
  const std::function<bool(double)>& go_on;
  std::shared_ptr<const ModelShapes> shapes{};  ///< of the view's scene
  std::vector<Hypothesis> list{};               ///< the mistakes to try
  /// From here on, the mistakes in the list have numbers that are estimated from the pictures.
  std::size_t first_fitted = 0;
  std::vector<Point> points{};
  std::array<Clean, 4> clean_pictures{};  ///< by Turn
  std::vector<Colors> cache{};            ///< drawn with one mistake, at the first points
  /// The mistakes that take far more work to draw than the scene without any, such as transforms
  /// that put thousands of shapes in one place. They are tried alone.
  std::vector<bool> heavy{};
  /// What was drawn at all points with some mistakes in drawing.
  struct Drawn {
    Combination mistakes;
    Turn turn;
    Colors colors;
    std::uint64_t work = 0;  ///< in rays
  };
  mutable std::deque<Drawn> drawn_before{};
  mutable std::mutex drawn_before_mutex{};
  /// A cache of the shapes of recent combinations. They do not depend on the points.
  mutable std::deque<std::pair<Combination, std::shared_ptr<const ModelShapes>>> shapes_before{};
  mutable std::mutex shapes_before_mutex{};
  mutable std::atomic<std::uint64_t> rays{0};
  bool usable = false;  ///< whether the scene is that of the reference
  bool stopped = false;
  std::string route{};  ///< CauseReport::route of what is found so far

  /// Reports progress; false: stop.
  bool step(double done);
  /// Whether compression or scaling changed the pictures' colors a little.
  bool has_noise() const { return view != nullptr && (view->samples > 1 || !view->noise.empty()); }
  /// Colors that differ by no more are equal, but for truncating one or both, or compression: of
  /// the pixels without contrast near them in JPEGs of quality 75, 99 % differ by no more than 3.
  double rounding() const { return rounding_with(has_noise()); }
  /// Whether edges say anything: compression changes them the most.
  bool shows_edges() const { return noise().empty(); }
  /// SceneView::noise, also without a view.
  const std::vector<float>& noise() const;
  /// sorted_pixels() of the pictures.
  Pixels sorted() const;
  /// The center of the pixel, as a position in the pictures before the turn.
  glm::dvec2 middle(const Point& p, const Turn& turn) const;
  /// The size of the picture of the scene, of which the pictures may be a part.
  glm::dvec2 whole() const;
  /// The ray through a position in the pictures.
  ModelRay ray(const Model& model, const glm::dvec2& place) const;
  /// The scene without mistakes. Without groups, it cannot be given other shapes.
  Trial right_trial(bool with_groups) const;
  Colors draw(const Trial& trial, const ModelShapes& drawn_shapes, const std::vector<Point>& places,
              std::size_t count, const Turn& turn, const std::vector<ModelHit>* hits,
              std::uint64_t* work = nullptr) const;
  /// Compares our picture of the scene with the reference: the share of pixels that differ, 1
  /// without a scene. Sets `usable`.
  double look_at_scene();
  /// Drops points that match the test with one sample at the pixel's center: they only differ by
  /// sampling.
  void drop_what_samples_explain(bool tolerant);
  /// Mixes both kinds of points in the proportions for screening.
  void interleave(std::size_t different);
  const Clean& clean(const Turn& turn) const;
  /// Draws the points without mistakes. Needed when the points change.
  void prepare_clean();
  double weight_that_differs(std::size_t count) const;
  /// Whether enough points differ to be evidence.
  bool significant() const;
  /// Of the first `count` points, or of all if there are fewer. The same holds for the scores
  /// below.
  Base base(std::size_t count) const;
  /// The picture with these mistakes; nullopt if none affects drawing. Sets `work` if it is drawn
  /// now.
  std::optional<Colors> drawn(const Combination& mistakes, std::size_t count, const Turn& turn,
                              std::uint64_t* work = nullptr) const;
  Stage stage_of(const Combination& mistakes) const;
  /// Edited scenes come first, and then mistakes that change the shapes, because they replace what
  /// others change.
  void make(const Combination& mistakes, Trial& trial) const;
  Trial trial_of(const Combination& mistakes) const;
  /// The shapes with the mistakes, of which `trial` is the trial.
  std::shared_ptr<const ModelShapes> shapes_of(const Combination& mistakes,
                                               const Trial& trial) const;
  /// The flip of all mistakes together.
  Turn turn_of(const Combination& mistakes) const;
  /// Applies the mistakes that change the finished picture to the colors.
  Colors finished(const Combination& mistakes, Colors colors) const;
  /// The place that the view asks for, with these mistakes; nullopt if it does not ask.
  std::optional<MistakenPixel> asked(const Combination& mistakes) const;
  /// The mistake that affects drawing, if it is the only one.
  std::uint16_t drawing_member(const Combination& mistakes) const;
  bool any_heavy(const Combination& mistakes) const;
  /// Draws single mistakes once, to combine each with those that change the finished picture. Adds
  /// those that were listed since the last call. Only for single mistakes, without those that
  /// cannot explain much alone.
  void fill_cache(std::size_t count, LookFor look_for);
  /// The picture with the mistakes at the first points: the changed drawing, or the
  /// reference plus the change, whichever is closer to the test.
  Colors predicted(const Combination& mistakes, std::size_t count) const;
  Colors closer(Colors a, Colors b) const;
  /// At the first `count` points.
  Score score_of(const Combination& mistakes, std::size_t count) const;
  static Tried rated(Combination mistakes, const Score& s, const Base& b);
  /// Tries each set, in parallel if possible.
  std::vector<Tried> try_all(const std::vector<Combination>& sets, std::size_t count, double from,
                             double to);
};

/// Restores the points of a simulation at the end of a scope that replaces them, unless told to
/// keep the new ones.
class PointsRestored {
 public:
  explicit PointsRestored(Simulation& sim)
      : sim_(sim),
        points_(sim.points),
        clean_pictures_(sim.clean_pictures),
        cache_(std::move(sim.cache)),
        drawn_before_(std::move(sim.drawn_before)) {
    sim.cache.clear();
    sim.drawn_before.clear();
  }
  ~PointsRestored() {
    if (keeps_new_) {
      return;
    }
    sim_.points = std::move(points_);
    sim_.clean_pictures = std::move(clean_pictures_);
    sim_.cache = std::move(cache_);
    sim_.drawn_before = std::move(drawn_before_);
  }
  /// Keeps the points that replaced them.
  void keep_new() { keeps_new_ = true; }
  PointsRestored(const PointsRestored&) = delete;
  PointsRestored& operator=(const PointsRestored&) = delete;

 private:
  Simulation& sim_;
  std::vector<Point> points_;
  std::array<Simulation::Clean, 4> clean_pictures_;
  std::vector<Colors> cache_;
  std::deque<Simulation::Drawn> drawn_before_;
  bool keeps_new_ = false;
};

}  // namespace scenefile
