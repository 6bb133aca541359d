#include "scenefile/grade/edited_scene.h"

#include "scenefile/base/limits.h"
#include "scenefile/grade/candidates.h"
#include "scenefile/grade/least_squares.h"
#include "scenefile/grade/sampling_causes.h"
#include "scenefile/grade/scene_values.h"
#include "scenefile/trace/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;

// With more shapes, only lights and camera are varied, and not beside other mistakes.
constexpr std::size_t max_parts = 2000;
// Rays of the searches.
constexpr std::uint64_t max_work = 14'000'000;                // of all together
constexpr std::uint64_t min_work = 5'000'000;                 // ... where other searches took many
constexpr std::uint64_t max_work_with_others = 28'000'000;    // with those of other searches
constexpr std::uint64_t max_work_alone = 5'000'000;           // for an edited scene alone
constexpr std::uint64_t max_work_beside = 2'000'000;          // beside each likely mistake
constexpr std::uint64_t max_work_beside_another = 4'000'000;  // beside all others
constexpr std::uint64_t max_work_for_likely = 6'000'000;      // more, where a value explains much

// Squares of the picture, or single pixels, with the mean color of some of their pixels.
struct Cells {
  double size = 1;          // in pixels
  double max_left = 1;      // of the difference, for a value to be tried further
  std::size_t samples = 1;  // pixels of each square that are drawn
  std::vector<Point> pixels;
  Colors test;  // by square
};

struct Drawable {
  Trial trial;
  std::shared_ptr<const ModelShapes> shapes;
};

// Numbers of a value, and what they leave of the difference.
struct Fit {
  std::vector<double> numbers;
  double left = 0;
};

// A value that explains a part of the difference.
struct Promising {
  SceneValue value;
  Fit fit;
  double left = 1;  // share of the difference
};

class Search {
 public:
  // `beside`: mistakes that were made, too.
  // `last_ray`: of the simulation, after which the search ends. If a value explains much, it goes
  // on, at most to `last_of_all`.
  Search(Simulation& sim, Combination beside, std::uint64_t last_ray, std::uint64_t last_of_all)
      : sim_(sim),
        beside_(std::move(beside)),
        last_ray_(std::min(last_ray, last_of_all)),
        last_of_all_(last_of_all) {}

  std::optional<Tried> run();
  // Beside one mistake that is not known yet. After run().
  std::optional<Tried> run_beside_another();

 private:
  std::optional<RenderScene> ready_with(const SceneValue& value,
                                        const std::vector<double>& numbers) const;
  std::optional<Drawable> edited(const SceneValue& value, const std::vector<double>& numbers) const;
  Colors drawn(const Drawable& scene, const Cells& cells) const;
  double left_with(const SceneValue& value, const std::vector<double>& numbers,
                   const Cells& cells) const;
  Cells squares(int size, int across, std::size_t max_count) const;
  Cells pixels(std::size_t max_count) const;
  double step_of(const SceneValue& value, double number, const Cells& cells) const;
  bool improve(const SceneValue& value, Fit& fit, const Cells& cells, int rounds) const;
  void round(const SceneValue& value, Fit& fit) const;
  void measure_bias();
  std::vector<SceneValue> values() const;
  double agreement(const SceneValue& value, const Cells& cells, const Colors& unedited) const;
  double left_at_a_glance(const SceneValue& value) const;
  std::vector<SceneValue> likeliest_first(std::vector<SceneValue> values);
  bool prepare_search();
  std::optional<Fit> fitted(const SceneValue& value, Fit fit, std::size_t first_level);
  std::uint16_t add_to_list(const SceneValue& value, RenderScene ready);
  std::optional<Tried> tried(const SceneValue& value, Fit fit);
  bool convincing(const Tried& t) const;
  bool fits_beside(const SceneValue& value) const;
  Colors drawn_unedited(const std::vector<Point>& places) const;
  bool spent() const { return sim_.rays > last_ray_; }

  Simulation& sim_;
  Combination beside_;
  std::uint64_t last_ray_;
  std::uint64_t last_of_all_;
  Drawable unedited_;           // with the mistakes beside the edit
  Colors before_;               // of the points, unedited
  std::vector<char> differs_;   // which points the test differs from that
  std::vector<ModelHit> hits_;  // of the points
  std::vector<Promising> promising_;
  Prepared prepared_;
  std::vector<Cells> levels_;   // the coarsest first
  std::vector<Cells> glances_;  // few squares of the first two levels
  double distance_ = 1;         // from the camera to what it shows
  dvec3 bias_{0};               // of the test's values, which may be truncated
};

// Errors beyond this count less, because they are probably not of the value that is varied.
double robust(double off, double limit) {
  return off <= limit ? off * off : limit * (2 * off - limit);
}

constexpr double far_off = 40;           // of 255
constexpr double near = 4;               // squared error of a channel that is right
constexpr double max_left_beside = 0.5;  // of the difference, where another mistake was made, too

// Which stage a change of the value affects.
Stage stage_of(const SceneValue& value) {
  switch (value.effect) {
    case ValueEffect::colors:
    case ValueEffect::light:
      return Stage::shading;
    case ValueEffect::camera:
      return Stage::camera;
    case ValueEffect::surface:
    case ValueEffect::shapes:
      return Stage::shapes;
  }
  return Stage::shapes;
}

// Replaces what the value affects.
void replace(Trial& trial, const RenderScene& scene, Stage stage) {
  trial.scene.global = scene.global;
  trial.scene.camera = scene.camera;
  trial.scene.lights = scene.lights;
  if (stage == Stage::shapes) {
    trial.scene.materials = scene.materials;
    trial.scene.groups = scene.groups;
    trial.scene.root = scene.root;
  }
}

std::optional<RenderScene> Search::ready_with(const SceneValue& value,
                                              const std::vector<double>& numbers) const {
  Scene scene = *sim_.view->written;
  value.set(scene, numbers);
  return ready_with_same_files(*sim_.view->scene, scene);
}

std::optional<Drawable> Search::edited(const SceneValue& value,
                                       const std::vector<double>& numbers) const {
  constexpr double too_large = 1e5;
  if (!std::all_of(numbers.begin(), numbers.end(),
                   [](double x) { return std::abs(x) < too_large; })) {
    return std::nullopt;
  }
  const std::optional<RenderScene> scene = ready_with(value, numbers);
  if (!scene) {
    return std::nullopt;
  }
  const Stage stage = std::max(stage_of(value), sim_.stage_of(beside_));
  Drawable result{sim_.right_trial(stage == Stage::shapes), sim_.shapes};
  replace(result.trial, *scene, stage_of(value));
  sim_.make(beside_, result.trial);
  if (stage == Stage::shapes) {
    result.shapes = flatten(result.trial.scene, *sim_.view->assets, sim_.shapes.get());
  }
  return result.shapes == nullptr ? std::nullopt : std::optional(std::move(result));
}

Colors Search::drawn(const Drawable& scene, const Cells& cells) const {
  const Colors colors =
      sim_.finished(beside_, sim_.draw(scene.trial, *scene.shapes, cells.pixels,
                                       cells.pixels.size(), sim_.turn_of(beside_), nullptr));
  Colors means(cells.test.size(), dvec3(0));
  for (std::size_t i = 0; i < colors.size(); ++i) {
    means[i / cells.samples] +=
        (glm::clamp(colors[i], dvec3(0), dvec3(255)) + bias_) / double(cells.samples);
  }
  return means;
}

double left_of(const Colors& colors, const Cells& cells) {
  double left = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      left += robust(std::abs(colors[i][channel] - cells.test[i][channel]), far_off);
    }
  }
  return left;
}

double Search::left_with(const SceneValue& value, const std::vector<double>& numbers,
                         const Cells& cells) const {
  const std::optional<Drawable> scene = edited(value, numbers);
  return scene ? left_of(drawn(*scene, cells), cells) : infinity;
}

// Squares with `across` times `across` of their pixels: those that differ most, and others.
Cells Search::squares(int size, int across, std::size_t max_count) const {
  constexpr std::size_t max_drawn = 8;  // for each square that is returned
  across = std::min(across, size);
  struct Square {
    int x, y;
    double off;
  };
  const auto place = [&](int k) { return (2 * k + 1) * size / (2 * across); };
  const auto mean = [&](const Texture& t, const Square& square) {
    dvec3 sum(0);
    for (int k = 0; k < across * across; ++k) {
      sum += at(t, square.x + place(k % across), square.y + place(k / across));
    }
    return sum / double(across * across);
  };
  std::vector<Square> all;
  std::vector<Point> middles;
  for (int y = 0; y + size <= sim_.test.height; y += size) {
    for (int x = 0; x + size <= sim_.test.width; x += size) {
      Square square{x, y, 0};
      square.off = largest_of(glm::abs(mean(sim_.test, square) - mean(sim_.reference, square)));
      all.push_back(square);
      middles.push_back({x + size / 2, y + size / 2});
    }
  }
  if (!beside_.empty()) {
    // They are drawn to see which differ, so only some of small ones.
    const std::size_t every = std::max<std::size_t>(1, all.size() / (max_drawn * max_count));
    for (std::size_t i = 0; every * i < all.size(); ++i) {
      all[i] = all[every * i];
      middles[i] = middles[every * i];
    }
    all.resize((all.size() + every - 1) / every);
    middles.resize(all.size());
    const Colors colors = drawn_unedited(middles);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const dvec3 c = glm::clamp(colors[i], dvec3(0), dvec3(255));
      all[i].off = largest_of(glm::abs(c - at(sim_.test, middles[i].x, middles[i].y)));
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Square& a, const Square& b) { return a.off > b.off; });
  Cells cells{double(size), 1, std::size_t(across) * std::size_t(across), {}, {}};
  const std::size_t first = std::min(all.size(), max_count * 3 / 4);
  const std::size_t step = std::max<std::size_t>(1, (all.size() - first) / (max_count / 4));
  for (std::size_t i = 0; i < all.size(); i += i < first ? 1 : step) {
    cells.test.push_back(mean(sim_.test, all[i]));
    for (int k = 0; k < across * across; ++k) {
      Point p;
      p.x = all[i].x + place(k % across);
      p.y = all[i].y + place(k / across);
      cells.pixels.push_back(p);
    }
  }
  return cells;
}

Cells Search::pixels(std::size_t max_count) const {
  Cells cells;
  for (std::size_t i = 0; i < std::min(max_count, sim_.points.size()); ++i) {
    cells.pixels.push_back(sim_.points[i]);
    cells.test.push_back(sim_.points[i].test);
  }
  return cells;
}

// Nobody writes a coefficient or color that is so far from the right one.
bool is_absurd(double number, double old) {
  constexpr double most = 10;
  return std::abs(number) > most * std::max(1.0, std::abs(old));
}

// How far to vary a number to see its effect. What moves, moves by about the size of a square.
double Search::step_of(const SceneValue& value, double number, const Cells& cells) const {
  switch (value.effect) {
    case ValueEffect::colors:
    case ValueEffect::surface:
      return 0.02 + 0.05 * std::abs(number);
    case ValueEffect::light:
      return 0.02 + 0.02 * std::abs(number);
    case ValueEffect::camera:
    case ValueEffect::shapes:
      return 2 * distance_ * std::tan(sim_.view->scene->camera.fov_y / 2) * cells.size /
             sim_.whole().y;
  }
  return 1;
}

// Levenberg-Marquardt. Returns whether the value explains much of the difference.
bool Search::improve(const SceneValue& value, Fit& fit, const Cells& cells, int rounds) const {
  constexpr double enough_at_once = 0.9;  // in two rounds
  constexpr double min_reach = 0.03;
  const std::size_t n = fit.numbers.size();
  double damping = 0.01;
  double reach = 1;  // of the steps; small ones are exact, and large ones see beyond edges
  fit.left = left_with(value, fit.numbers, cells);
  const double start = left_with(value, value.numbers, cells);
  for (int k = 0; k < rounds && !spent(); ++k) {
    const std::optional<Drawable> now = edited(value, fit.numbers);
    if (!now) {
      return false;
    }
    const Colors colors = drawn(*now, cells);
    std::vector<double> steps(n);
    std::vector<Colors> change(n);
    for_each_task(n, [&](std::size_t i) {
      steps[i] = reach * step_of(value, fit.numbers[i], cells);
      std::vector<double> numbers = fit.numbers;
      numbers[i] += steps[i];
      const std::optional<Drawable> scene = edited(value, numbers);
      change[i] = scene ? drawn(*scene, cells) : colors;
      for (std::size_t c = 0; c < colors.size(); ++c) {
        change[i][c] -= colors[c];
      }
    });
    // In units of the steps.
    std::vector<std::vector<double>> normal(n, std::vector<double>(n));
    std::vector<double> right(n);
    for (std::size_t c = 0; c < colors.size(); ++c) {
      const dvec3 off = cells.test[c] - colors[c];
      const dvec3 weight = 1.0 / glm::max(dvec3(1), glm::abs(off) / far_off);
      for (std::size_t i = 0; i < n; ++i) {
        right[i] += glm::dot(weight * change[i][c], off);
        for (std::size_t j = 0; j < n; ++j) {
          normal[i][j] += glm::dot(weight * change[i][c], change[j][c]);
        }
      }
    }
    const double before = fit.left;
    for (int attempt = 0; attempt < 4 && fit.left == before; ++attempt) {
      std::vector<std::vector<double>> damped = normal;
      for (std::size_t i = 0; i < n; ++i) {
        damped[i][i] += damping * normal[i][i] + 1e-3;
      }
      Fit next;
      next.numbers = solved(std::move(damped), right);
      if (next.numbers.empty()) {
        break;
      }
      for (std::size_t i = 0; i < n; ++i) {
        next.numbers[i] = fit.numbers[i] + next.numbers[i] * steps[i];
      }
      next.left = left_with(value, next.numbers, cells);
      damping = next.left < fit.left ? std::max(1e-4, damping / 5) : damping * 8;
      if (next.left < fit.left) {
        fit = std::move(next);
      }
    }
    if (k == 1 && fit.left > enough_at_once * start) {
      break;
    }
    if (fit.left > 0.98 * before) {
      if (reach < min_reach) {
        break;
      }
      reach /= 3;
      damping = 0.01;
    }
  }
  return fit.left <= cells.max_left * start ||
         fit.left <= 3 * near * static_cast<double>(cells.test.size());
}

// Of all numbers with the same picture those that are most like the written ones.
void make_likely(const SceneValue& value, std::vector<double>& numbers) {
  const auto length = [](const std::vector<double>& v) {
    return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0));
  };
  const double written = length(value.numbers);
  const double now = length(numbers);
  const double scale = value.direction && written > 0 && now > 0 ? written / now : 1;
  for (double& number : numbers) {
    number = std::clamp(number * scale, value.range.low, value.range.high);
  }
}

// With as few decimals as the picture allows, because people write such numbers.
void Search::round(const SceneValue& value, Fit& fit) const {
  make_likely(value, fit.numbers);
  constexpr double rounding = 0.02;  // squared error
  const double limit = 1.02 * fit.left + rounding * static_cast<double>(levels_.back().test.size());
  for (const double unit : {1.0, 0.1, 0.01, 0.001}) {
    std::vector<double> numbers = fit.numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double old = value.numbers[i];
      numbers[i] =
          std::abs(numbers[i] - old) <= unit / 2 ? old : unit * std::round(numbers[i] / unit);
    }
    if (left_with(value, numbers, levels_.back()) <= limit) {
      fit.numbers = std::move(numbers);
      return;
    }
  }
}

std::string text_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) {
    text += fmt::format("{}{:.3g}", text.empty() ? "" : " ", x == 0 ? 0.0 : x);
  }
  return text;
}

// What moves is found in large squares first.
std::size_t first_level(ValueEffect effect) {
  switch (effect) {
    case ValueEffect::camera:
      return 0;
    case ValueEffect::light:
    case ValueEffect::shapes:
      return 1;
    case ValueEffect::colors:
    case ValueEffect::surface:
      return 3;
  }
  return 0;
}

// The weight of the points on an object, or on all objects of a node.
struct Seen {
  double all = 0;
  double differs = 0;
  // If all of it differs, it is likelier to be the cause.
  double merit() const { return all > 0 ? differs * differs / all : 0; }
};

// Sorted by merit, the highest first; objects that are seen only in mirrors, if at all, come last.
template <typename Key>
std::vector<Key> by_merit(const std::map<Key, Seen>& seen, std::size_t max_count) {
  std::vector<std::pair<double, Key>> ranked;
  for (const auto& [key, s] : seen) {
    if (s.differs > 0 || s.all == 0) {
      ranked.emplace_back(-s.merit(), key);
    }
  }
  std::sort(ranked.begin(), ranked.end());
  ranked.resize(std::min(ranked.size(), max_count));
  std::vector<Key> keys;
  for (const auto& [merit, key] : ranked) {
    keys.push_back(key);
  }
  return keys;
}

std::vector<SceneValue> Search::values() const {
  constexpr std::size_t max_materials = 3;
  constexpr std::size_t max_nodes = 12;
  const Scene& scene = *sim_.view->written;
  std::vector<SceneValue> found = values_of_view(scene, prepared_);
  const bool replaced = std::any_of(beside_.begin(), beside_.end(), [&](std::uint16_t i) {
    return replaces_objects(sim_.list[i]);
  });
  if (replaced || sim_.shapes->parts.size() > max_parts) {
    return found;
  }
  std::vector<NodeId> parent(scene.nodes.size(), scene.root);
  std::map<NodeId, Seen> nodes;
  for (NodeId node = 0; node < scene.nodes.size(); ++node) {
    for (const NodeId child : scene.nodes[node].children) {
      parent[child] = node;
    }
    nodes[node];
  }
  std::map<std::uint32_t, Seen> objects;
  std::map<std::uint32_t, Seen> plain;  // objects that show no others
  Seen all_plain;
  double differs = 0;
  double all = 0;
  for (std::size_t i = 0; i < sim_.points.size(); ++i) {
    const ModelHit& hit = hits_[i];
    const Point& p = sim_.points[i];
    const auto add = [&](Seen& seen) {
      seen.all += p.weight;
      seen.differs += differs_[i] != 0 ? p.weight : 0;
    };
    differs += differs_[i] != 0 ? p.weight : 0;
    all += p.weight;
    if (hit.part == nullptr) {
      add(all_plain);
      continue;
    }
    add(objects[hit.part->source]);
    const RenderMaterial& m = sim_.view->scene->materials[hit.part->material];
    if (m.reflective == glm::vec3(0) && m.transparent == glm::vec3(0)) {
      add(plain[hit.part->source]);
      add(all_plain);
    }
    for (NodeId node = prepared_.sources[hit.part->source].node;; node = parent[node]) {
      add(nodes[node]);
      if (node == scene.root || parent[node] == scene.root) {
        break;
      }
    }
  }
  const auto insert = [&](std::vector<SceneValue>::iterator where, std::vector<SceneValue> more) {
    found.insert(where, std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  for (const std::uint32_t source : by_merit(objects, max_materials)) {
    // A material only changes its object, and what shows it.
    if (all_plain.differs < 0.1 * differs || plain[source].differs > 0.5 * all_plain.differs) {
      // The number of rays is limited, so likelier values come first.
      const bool likely = objects[source].differs > 0.9 * differs;
      insert(likely ? found.begin() : found.end(),
             values_of_material(scene, prepared_.sources[source]));
    }
  }
  for (const NodeId node : by_merit(nodes, max_nodes)) {
    // All pixels of an object that was moved differ, and many others do not.
    const Seen& seen = nodes[node];
    const bool likely = seen.differs > 0.9 * seen.all && differs < 0.5 * all;
    insert(likely ? found.begin() : found.end(), values_of_transforms(scene, node));
  }
  return found;
}

// Whether an edit of the value may be found beside the mistakes that were made, too.
bool Search::fits_beside(const SceneValue& value) const {
  Hypothesis edit;
  edit.cause = Cause::scene_edited;
  edit.stage = stage_of(value);
  return std::none_of(beside_.begin(), beside_.end(),
                      [&](std::uint16_t i) { return hides(sim_.list[i], edit); });
}

// How well the pixels that a change of the value changes are those that differ: 1 if they are the
// same. `cells`: some of the first points.
double Search::agreement(const SceneValue& value, const Cells& cells,
                         const Colors& unedited) const {
  std::vector<bool> changed(cells.pixels.size());
  for (std::size_t k = 0; k < value.numbers.size(); ++k) {
    std::vector<double> numbers = value.numbers;
    numbers[k] += step_of(value, numbers[k], levels_[1]);
    if (const std::optional<Drawable> scene = edited(value, numbers)) {
      const Colors colors = drawn(*scene, cells);
      for (std::size_t i = 0; i < colors.size(); ++i) {
        changed[i] = changed[i] || largest_of(glm::abs(colors[i] - unedited[i])) > 1;
      }
    }
  }
  double both = 0, changes = 0, differs = 0;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    both += changed[i] && differs_[i] != 0 ? 1 : 0;
    changes += changed[i] ? 1 : 0;
    differs += differs_[i] != 0 ? 1 : 0;
  }
  return both > 0 ? both * both / (changes * differs) : 0;
}

// The share of the difference that a few steps leave.
double Search::left_at_a_glance(const SceneValue& value) const {
  constexpr int max_steps = 3;
  const Cells& cells = glances_[first_level(value.effect) > 0 ? 1 : 0];
  Fit fit{value.numbers, 0};
  improve(value, fit, cells, max_steps);
  return fit.left / std::max(1.0, left_with(value, value.numbers, cells));
}

// The number of rays is limited, so values come first that explain much after a few steps, and then
// those that change what differs. Beside mistakes, only these.
std::vector<SceneValue> Search::likeliest_first(std::vector<SceneValue> values) {
  constexpr std::size_t glance = 96;           // points
  constexpr std::size_t max_at_a_glance = 30;  // values
  constexpr double max_left_at_a_glance = 0.95;
  constexpr double likely = 0.6;
  constexpr double one_step = 0.05;  // of agreement; within it, the order remains
  struct Ranked {
    double agreement = 0;  // in steps
    double left = 1;
    std::size_t value = 0;
  };
  std::erase_if(values, [&](const SceneValue& value) { return !fits_beside(value); });
  const Cells cells = pixels(glance);
  const Colors unedited = drawn(unedited_, cells);
  std::vector<Ranked> ranked(values.size());
  for_each_task(values.size(), [&](std::size_t i) {
    ranked[i] = {std::round(agreement(values[i], cells, unedited) / one_step), 1, i};
  });
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Ranked& a, const Ranked& b) { return a.agreement > b.agreement; });
  const std::uint64_t last_glance = std::midpoint(sim_.rays.load(), last_ray_);
  for (std::size_t i = 0; i < std::min(max_at_a_glance, ranked.size()); ++i) {
    if (sim_.rays < last_glance && ranked[i].agreement > 0) {
      ranked[i].left = left_at_a_glance(values[ranked[i].value]);
    }
  }
  const auto unlikely = std::stable_partition(ranked.begin(), ranked.end(), [](const Ranked& one) {
    return one.left < max_left_at_a_glance;
  });
  std::stable_sort(ranked.begin(), unlikely,
                   [](const Ranked& a, const Ranked& b) { return a.left < b.left; });
  if (unlikely != ranked.begin() && ranked.front().left < likely) {
    last_ray_ = std::min(last_ray_ + max_work_for_likely, last_of_all_);
  }
  if (!beside_.empty()) {
    ranked.erase(unlikely, ranked.end());
  }
  std::vector<SceneValue> ordered;
  for (const Ranked& one : ranked) {
    ordered.push_back(std::move(values[one.value]));
  }
  return ordered;
}

// From the numbers in `fit`.
std::optional<Fit> Search::fitted(const SceneValue& value, Fit fit, std::size_t first_level) {
  for (std::size_t i = first_level; i < levels_.size(); ++i) {
    if (!improve(value, fit, levels_[i], 12)) {
      const double left = fit.left / left_with(value, value.numbers, levels_[i]);
      if (left <= max_left_beside) {
        promising_.push_back({value, std::move(fit), left});
      }
      return std::nullopt;
    }
  }
  round(value, fit);
  return fit;
}

// Adds the edit to the list of mistakes, without words.
std::uint16_t Search::add_to_list(const SceneValue& value, RenderScene ready) {
  sim_.list.push_back(
      {Cause::scene_edited,
       {},
       stage_of(value),
       [ready = std::move(ready), stage = stage_of(value)](Trial& t) { replace(t, ready, stage); },
       {},
       {}});
  return static_cast<std::uint16_t>(sim_.list.size() - 1);
}

std::optional<Tried> Search::tried(const SceneValue& value, Fit fit) {
  const std::string before = text_of(value.numbers);
  const bool shade = value.effect == ValueEffect::colors || value.effect == ValueEffect::surface;
  for (std::size_t k = 0; shade && k < fit.numbers.size(); ++k) {
    if (fit.numbers[k] < 0 || is_absurd(fit.numbers[k], value.numbers[k])) {
      return std::nullopt;
    }
  }
  std::optional<RenderScene> ready = ready_with(value, fit.numbers);
  if (!ready) {
    return std::nullopt;
  }
  const std::string where =
      value.location.known() ? fmt::format(" (line {})", value.location.line) : std::string();
  const Combination all = joined(beside_, {add_to_list(value, *std::move(ready))});
  const Tried t =
      sim_.rated(all, sim_.score_of(all, sim_.points.size()), sim_.base(sim_.points.size()));
  // An edited color is exact; other reflectances come near to one.
  if (shade && t.explained < 0.999) {
    return std::nullopt;
  }
  // Many mistakes look nearly like an edit. A picture of an edited scene is equal except for the
  // rounding of the picture and of the edited value. Measured: for the value that was edited, at
  // least 0.83 of the pixels that it changes are equal, for any other value at most 0.6.
  constexpr double most_equal = 0.75;
  const std::size_t count = sim_.points.size();
  const Effect e = effect_of(sim_, sim_.predicted(all, count), sim_.predicted(beside_, count));
  if (e.within_rounding < most_equal * e.changed) {
    return std::nullopt;
  }
  sim_.list.back().what = fmt::format(
      "drawn from an edited scene, or the scene was read wrongly: {} is {} instead of {}{}",
      value.name, text_of(fit.numbers), before, where);
  return t;
}

void Search::measure_bias() {
  Colors off;
  for (std::size_t i = 0; i < sim_.points.size(); ++i) {
    const dvec3 d = sim_.points[i].test - before_[i];
    const dvec3& t = sim_.points[i].test;
    if (differs_[i] == 0 && largest_of(glm::abs(d)) < 1 && std::min({t.x, t.y, t.z}) > 0) {
      off.push_back(d);
    }
  }
  for (const dvec3& d : off) {
    bias_ += d / double(off.size());
  }
}

Colors Search::drawn_unedited(const std::vector<Point>& places) const {
  return sim_.finished(beside_, sim_.draw(unedited_.trial, *unedited_.shapes, places, places.size(),
                                          sim_.turn_of(beside_), nullptr));
}

// Whether the scene can be searched.
bool Search::prepare_search() {
  const SceneView& view = *sim_.view;
  constexpr std::size_t max_nodes = 3000;
  if (view.written == nullptr || view.written->nodes.size() > max_nodes) {
    return false;
  }
  prepared_ = prepare(*view.written, Limits());
  std::vector<double> distances;
  for (const ModelHit& hit : sim_.clean({}).hits) {
    if (hit.part != nullptr) {
      distances.push_back(hit.t);
    }
  }
  if (distances.empty() || !(prepared_.scene == *view.scene)) {
    return false;
  }
  std::nth_element(distances.begin(), distances.begin() + std::ptrdiff_t(distances.size() / 2),
                   distances.end());
  distance_ = distances[distances.size() / 2];
  unedited_.trial = sim_.trial_of(beside_);
  unedited_.shapes = sim_.shapes_of(beside_, unedited_.trial);
  before_ = beside_.empty() ? sim_.clean({}).drawn : drawn_unedited(sim_.points);
  hits_ = sim_.clean(sim_.turn_of(beside_)).hits;
  const Trial& trial = unedited_.trial;
  const Model model(trial.scene, *unedited_.shapes, *view.assets, trial.options, trial.mistakes);
  for (std::size_t i = 0; i < sim_.points.size(); ++i) {
    const Point& p = sim_.points[i];
    const dvec3 c = glm::clamp(before_[i], dvec3(0), dvec3(255));
    differs_.push_back(beside_.empty() ? p.differs
                                       : largest_of(outside(c, p.low, p.high)) > exact_within);
    if (sim_.stage_of(beside_) >= Stage::hits) {
      hits_[i] = model.first_hit(sim_.ray(model, sim_.middle(p, sim_.turn_of(beside_))));
    }
  }
  measure_bias();
  levels_ = {squares(std::max(3, sim_.test.width / 16), 4, 400),
             squares(std::max(3, sim_.test.width / 40), 3, 300), squares(3, 3, 250), pixels(320),
             pixels(sim_.points.size())};
  glances_ = {squares(int(levels_[0].size), 2, 48), squares(int(levels_[1].size), 2, 48)};
  constexpr std::array max_left{0.6, 0.5, 0.2, 0.08, 0.08};
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    levels_[i].max_left = max_left[i];
  }
  return true;
}

bool Search::convincing(const Tried& t) const {
  return sure(t) && t.broken <= max_broken &&
         (t.mistakes.size() == 1 ||
          (leaves_only_rounding(sim_, t.mistakes) && each_needed(sim_, t.mistakes)));
}

std::optional<Tried> Search::run() {
  if (!prepare_search()) {
    return std::nullopt;
  }
  std::optional<Tried> best;
  for (const SceneValue& value : likeliest_first(values())) {
    if (spent() || !sim_.step(0.98)) {
      break;
    }
    const std::optional<Fit> fit = fitted(value, {value.numbers, 0}, first_level(value.effect));
    const std::optional<Tried> t = fit ? tried(value, *fit) : std::nullopt;
    if (t && convincing(*t)) {
      best = !best || t->score.raw < 0.9 * best->score.raw ? t : best;
    } else if (t) {
      promising_.push_back({value, *fit, 1 - t->explained});
    }
    if (best && best->explained > 0.995) {
      break;
    }
  }
  return best;
}

std::optional<Tried> Search::run_beside_another() {
  constexpr std::size_t max_values = 3;
  constexpr std::size_t max_others = 4;
  std::stable_sort(promising_.begin(), promising_.end(),
                   [](const Promising& a, const Promising& b) { return a.left < b.left; });
  promising_.resize(std::min(promising_.size(), max_values));
  for (Cells& level : levels_) {
    level.max_left = 1;
  }
  last_ray_ = std::min(sim_.rays + max_work_beside_another, last_of_all_);
  for (Promising& start : promising_) {
    if (spent()) {
      break;
    }
    for (std::size_t i = 2; i < levels_.size(); ++i) {
      improve(start.value, start.fit, levels_[i], 12);
    }
    std::optional<RenderScene> ready = ready_with(start.value, start.fit.numbers);
    if (!ready || spent() || !sim_.step(0.99)) {
      continue;
    }
    const std::uint16_t edit = add_to_list(start.value, *std::move(ready));
    std::vector<Tried> additions = likely_additions(sim_, {edit});
    additions.resize(std::min(additions.size(), max_others));
    for (const Tried& both : additions) {
      Combination other = both.mistakes;
      std::erase(other, edit);
      Search beside(sim_, other, sim_.rays + max_work_beside, last_ray_);
      if (beside.spent() || !beside.prepare_search()) {
        continue;
      }
      const std::optional<Fit> refined = beside.fitted(start.value, start.fit, 3);
      std::optional<Tried> t = refined ? beside.tried(start.value, *refined) : std::nullopt;
      if (t && convincing(*t)) {
        return t;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Tried> find_edit_beside(Simulation& sim, const Combination& mistakes) {
  return sim.shapes->parts.size() > max_parts || sim.has_noise()
             ? std::nullopt
             : Search(sim, mistakes, sim.rays + max_work_beside, sim.rays + max_work).run();
}

std::optional<Tried> find_edited_scene(Simulation& sim, const std::vector<Combination>& beside) {
  const bool few_values = sim.shapes->parts.size() > max_parts;
  const std::uint64_t last =
      std::clamp(max_work_with_others, sim.rays + min_work, sim.rays + max_work);
  const std::uint64_t last_alone = sim.rays + (few_values ? max_work_alone / 2 : max_work_alone);
  Search alone(sim, {}, last_alone, std::min(last, last_alone + max_work_for_likely / 2));
  std::optional<Tried> found = alone.run();
  if (few_values) {
    return found;
  }
  for (auto it = beside.begin(); !found && it != beside.end() && sim.rays < last; ++it) {
    found = Search(sim, *it, sim.rays + max_work_beside, last).run();
  }
  return found ? found : alone.run_beside_another();
}

}  // namespace scenefile
