#include "scenefile/grade/simulation.h"

#include "scenefile/trace/tasks.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace scenefile {

bool Simulation::step(double done) {
  stopped = stopped || (go_on && !go_on(done));
  return !stopped;
}

glm::dvec2 Simulation::middle(const Point& p, const Turn& turn) const {
  const int x = turn.across ? test.width - 1 - p.x : p.x;
  const int y = turn.down ? test.height - 1 - p.y : p.y;
  return {x + 0.5, y + 0.5};
}

glm::dvec2 Simulation::whole() const {
  return view->whole.x > 0 ? view->whole : glm::dvec2(test.width, test.height);
}

ModelRay Simulation::ray(const Model& model, const glm::dvec2& place) const {
  return model.camera_ray(place + view->corner, whole().x, whole().y);
}

Trial Simulation::right_trial(bool with_groups) const {
  Trial trial;
  const RenderScene& scene = *view->scene;
  if (with_groups) {
    trial.scene = scene;
  } else {
    trial.scene.global = scene.global;
    trial.scene.camera = scene.camera;
    trial.scene.lights = scene.lights;
    trial.scene.materials = scene.materials;
  }
  trial.options = view->options;
  return trial;
}

Colors Simulation::draw(const Trial& trial, const ModelShapes& drawn_shapes,
                        const std::vector<Point>& places, std::size_t count, const Turn& turn,
                        const std::vector<ModelHit>* hits, std::uint64_t* work) const {
  const int n = std::max(view->samples, trial.samples);
  const auto color_at = [&](const Model& model, const glm::dvec2& place, const ModelHit* known) {
    if (n == 1) {
      return model.pixel(place, whole().x, whole().y, known, {});
    }
    glm::dvec3 sum(0);
    for (int k = 0; k < n * n; ++k) {
      const glm::dvec2 sample = place + (glm::dvec2(k % n, k / n) + 0.5) / double(n) - 0.5;
      if (trial.black_if_missed &&
          model.first_hit(model.camera_ray(sample, whole().x, whole().y)).part == nullptr) {
        return glm::dvec3(0);
      }
      sum += clamped(model.pixel(sample, whole().x, whole().y, nullptr, {k, n * n}));
    }
    return sum / double(trial.divisor > 0 ? trial.divisor : n * n);
  };
  const auto color_of = [&](const Model& model, std::size_t i) {
    const glm::dvec2 place = middle(places[i], turn) + trial.shift + view->corner;
    const std::vector<double>& weights = trial.filter.weights;
    if (weights.empty()) {
      return 255.0 * color_at(model, place, hits != nullptr ? &(*hits)[i] : nullptr);
    }
    glm::dvec3 sum(0);
    double all = 0;
    for (std::size_t v = 0; v < weights.size(); ++v) {
      for (std::size_t u = 0; u < weights.size(); ++u) {
        const glm::dvec2 step(double(u) - trial.filter.before, double(v) - trial.filter.before);
        const double weight = weights[u] * weights[v];
        sum += weight * clamped(color_at(model, place + step, nullptr));
        all += weight;
      }
    }
    return 255.0 * sum / all;
  };
  Colors colors(count);
  std::atomic<std::uint64_t> all_work{0};
  const auto draw_range = [&](std::size_t first, std::size_t last) {
    const Model model(trial.scene, drawn_shapes, *view->assets, trial.options, trial.mistakes);
    for (std::size_t i = first; i < last; ++i) {
      colors[i] = color_of(model, i);
    }
    all_work += model.rays();
  };
  constexpr std::size_t chunk = 100;  // fewer points are not worth a parallel loop
  if (count <= chunk) {
    draw_range(0, count);
  } else {
    for_each_task((count + chunk - 1) / chunk,
                  [&](std::size_t k) { draw_range(k * chunk, std::min(count, (k + 1) * chunk)); });
  }
  rays += all_work;
  if (work != nullptr) {
    *work = all_work;
  }
  return colors;
}

const std::vector<float>& Simulation::noise() const {
  static const std::vector<float> none;
  return view != nullptr ? view->noise : none;
}

Pixels Simulation::sorted() const {
  return sorted_pixels(reference, test, noise());
}

double Simulation::look_at_scene() {
  if (view == nullptr) {
    return 1;
  }
  shapes = flatten(*view->scene, *view->assets);
  if (shapes == nullptr) {
    return 1;
  }
  std::mt19937 random(2);
  std::vector<std::uint32_t> pixels(std::size_t(test.width) * test.height);
  for (std::uint32_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = i;
  }
  std::vector<Point> everywhere;
  add_points(test, reference, std::move(pixels), 1500, false, false, random, everywhere);
  const auto share_unlike_with = [&](const Colors& colors) {
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < everywhere.size(); ++i) {
      const Range range = around(reference, everywhere[i].x, everywhere[i].y);
      const glm::dvec3 c = glm::clamp(colors[i], glm::dvec3(0), glm::dvec3(255));
      unlike += largest_of(outside(c, range.low - 6.0, range.high + 6.0)) > 0 ? 1 : 0;
    }
    return static_cast<double>(unlike) /
           static_cast<double>(std::max<std::size_t>(1, everywhere.size()));
  };
  Trial trial = right_trial(false);
  double share_unlike =
      share_unlike_with(draw(trial, *shapes, everywhere, everywhere.size(), Turn(), nullptr));
  if (share_unlike > max_unlike && view->samples == 1) {
    // The reference may have several samples per pixel, which differ from one in fine textures.
    constexpr int across = 3;
    Colors means(everywhere.size(), glm::dvec3(0));
    for (int k = 0; k < across * across; ++k) {
      trial.shift = (glm::dvec2(k % across, k / across) + 0.5) / double(across) - 0.5;
      const Colors colors = draw(trial, *shapes, everywhere, everywhere.size(), Turn(), nullptr);
      for (std::size_t i = 0; i < colors.size(); ++i) {
        means[i] += glm::clamp(colors[i], glm::dvec3(0), glm::dvec3(255)) / double(across * across);
      }
    }
    share_unlike = std::min(share_unlike, share_unlike_with(means));
  }
  usable = share_unlike <= max_unlike;
  return share_unlike;
}

void Simulation::drop_what_samples_explain(bool tolerant) {
  if (!usable) {
    return;
  }
  const Colors colors = draw(right_trial(false), *shapes, points, points.size(), Turn(), nullptr);
  std::vector<Point> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    const glm::dvec3 c = glm::clamp(colors[i], glm::dvec3(0), glm::dvec3(255));
    if (largest_of(tolerant ? outside(c, p.low, p.high) : glm::abs(c - p.test)) > 2) {
      kept.push_back(p);
    }
  }
  points = std::move(kept);
}

void Simulation::interleave(std::size_t different) {
  std::vector<Point> mixed;
  std::size_t d = 0;
  std::size_t s = different;
  while (d < different || s < points.size()) {
    for (int i = 0; i < 3 && d < different; ++i) {
      mixed.push_back(points[d++]);
    }
    if (s < points.size()) {
      mixed.push_back(points[s++]);
    }
  }
  points = std::move(mixed);
}

const Simulation::Clean& Simulation::clean(const Turn& turn) const {
  return clean_pictures[(turn.across ? 1 : 0) + (turn.down ? 2 : 0)];
}

void Simulation::prepare_clean() {
  drawn_before.clear();
  for_each_task(clean_pictures.size(), [&](std::size_t i) {
    const Turn turn{(i & 1) != 0, (i & 2) != 0};
    Clean& c = clean_pictures[i];
    c = {};
    for (const Point& p : points) {
      const glm::dvec2 m = middle(p, turn);
      c.reference.push_back(at(reference, static_cast<int>(m.x), static_cast<int>(m.y)));
    }
    if (!usable) {
      return;
    }
    const Trial trial = right_trial(false);
    const Model model(trial.scene, *shapes, *view->assets, trial.options, trial.mistakes);
    for (const Point& p : points) {
      c.hits.push_back(model.first_hit(ray(model, middle(p, turn))));
    }
    c.drawn = draw(trial, *shapes, points, points.size(), turn, &c.hits, &c.work);
    c.work += model.rays();
  });
}

double Simulation::weight_that_differs(std::size_t count) const {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += points[i].differs ? points[i].weight : 0;
  }
  return sum;
}

bool Simulation::significant() const {
  std::size_t count = 0;
  for (const Point& p : points) {
    count += p.differs ? 1 : 0;
  }
  return count >= few_pixels;
}

Simulation::Base Simulation::base(std::size_t count) const {
  count = std::min(count, points.size());
  Base b;
  b.left = score(points, count, clean({}).reference).left;
  if (usable) {
    b.left = std::min(b.left, score(points, count, clean({}).drawn).left);
  }
  for (std::size_t i = 0; i < count; ++i) {
    (points[i].differs ? b.differs : b.same) += points[i].weight;
  }
  return b;
}

std::optional<Colors> Simulation::drawn(const Combination& mistakes, std::size_t count,
                                        const Turn& turn, std::uint64_t* work) const {
  const Stage stage = stage_of(mistakes);
  const bool hits = stage >= Stage::hits;
  if (stage == Stage::picture) {
    return std::nullopt;
  }
  const std::uint16_t one = drawing_member(mistakes);
  if (one != no_member && turn == Turn() && one < cache.size() && cache[one].size() >= count) {
    return Colors(cache[one].begin(), cache[one].begin() + std::ptrdiff_t(count));
  }
  // The judgment of a combination needs it at all points again and again.
  constexpr std::size_t max_drawn_before = 200;
  const bool at_all_points = count == points.size();
  Drawn now{{}, turn, {}, 0};
  std::copy_if(mistakes.begin(), mistakes.end(), std::back_inserter(now.mistakes),
               [&](std::uint16_t i) { return list[i].stage != Stage::picture; });
  if (at_all_points) {
    const std::lock_guard lock(drawn_before_mutex);
    for (const Drawn& d : drawn_before) {
      if (d.mistakes == now.mistakes && d.turn == turn) {
        rays += d.work;  // what is counted must not depend on which thread is first
        return d.colors;
      }
    }
  }
  const Trial trial = trial_of(mistakes);
  const std::shared_ptr<const ModelShapes> drawn_shapes = shapes_of(mistakes, trial);
  now.colors = draw(trial, *drawn_shapes, points, count, turn, hits ? nullptr : &clean(turn).hits,
                    &now.work);
  if (work != nullptr) {
    *work = now.work;
  }
  if (at_all_points) {
    const std::lock_guard lock(drawn_before_mutex);
    drawn_before.push_back(now);
    if (drawn_before.size() > max_drawn_before) {
      drawn_before.pop_front();
    }
  }
  return std::move(now.colors);
}

Stage Simulation::stage_of(const Combination& mistakes) const {
  Stage stage = Stage::picture;
  for (const std::uint16_t i : mistakes) {
    stage = std::max(stage, list[i].stage);
  }
  return stage;
}

void Simulation::make(const Combination& mistakes, Trial& trial) const {
  const auto order = [](const Hypothesis& h) {
    return h.cause == Cause::scene_edited ? 0 : h.stage == Stage::shapes ? 1 : 2;
  };
  for (const int turn : {0, 1, 2}) {
    for (const std::uint16_t i : mistakes) {
      if (list[i].draw && order(list[i]) == turn) {
        list[i].draw(trial);
      }
    }
  }
}

Trial Simulation::trial_of(const Combination& mistakes) const {
  Trial trial = right_trial(stage_of(mistakes) == Stage::shapes);
  make(mistakes, trial);
  return trial;
}

std::shared_ptr<const ModelShapes> Simulation::shapes_of(const Combination& mistakes,
                                                         const Trial& trial) const {
  constexpr std::size_t max_shapes_before = 8;
  Combination changing;
  std::copy_if(mistakes.begin(), mistakes.end(), std::back_inserter(changing),
               [&](std::uint16_t i) { return list[i].stage == Stage::shapes; });
  if (changing.empty()) {
    return shapes;
  }
  {
    const std::lock_guard lock(shapes_before_mutex);
    for (const auto& [made, before] : shapes_before) {
      if (made == changing) {
        return before;
      }
    }
  }
  std::shared_ptr<const ModelShapes> flat = flatten(trial.scene, *view->assets, shapes.get());
  const std::lock_guard lock(shapes_before_mutex);
  shapes_before.emplace_back(std::move(changing), flat);
  if (shapes_before.size() > max_shapes_before) {
    shapes_before.pop_front();
  }
  return flat;
}

Turn Simulation::turn_of(const Combination& mistakes) const {
  Turn turn;
  for (const std::uint16_t i : mistakes) {
    turn.across = turn.across != list[i].turn.across;
    turn.down = turn.down != list[i].turn.down;
  }
  return turn;
}

Colors Simulation::finished(const Combination& mistakes, Colors colors) const {
  for (const std::uint16_t i : mistakes) {
    if (list[i].color) {
      for (glm::dvec3& c : colors) {
        c = 255.0 * list[i].color(c / 255.0);
      }
    }
  }
  return colors;
}

std::optional<MistakenPixel> Simulation::asked(const Combination& mistakes) const {
  if (view == nullptr || !view->asked) {
    return std::nullopt;
  }
  const Point point{static_cast<int>(view->asked->x), static_cast<int>(view->asked->y)};
  const Turn turn = turn_of(mistakes);
  MistakenPixel pixel;
  if (stage_of(mistakes) == Stage::picture) {
    const glm::ivec2 m(middle(point, turn));
    pixel.color = finished(mistakes, {at(reference, m.x, m.y)}).front();
    return pixel;
  }
  // One pixel of the picture before it was made smaller.
  SceneView of_pixel = *view;
  of_pixel.samples = 1;
  const Simulation one{reference, test, &of_pixel, go_on};
  Trial trial = trial_of(mistakes);
  const std::shared_ptr<const ModelShapes> drawn_shapes = shapes_of(mistakes, trial);
  trial.shift +=
      (*view->asked - middle(point, Turn())) * glm::dvec2(turn.across ? -1 : 1, turn.down ? -1 : 1);
  const auto drawn_with = [&](const Trial& with) {
    return one.draw(with, *drawn_shapes, {point}, 1, turn, nullptr).front();
  };
  const glm::dvec3 all = drawn_with(trial);
  pixel.color = finished(mistakes, {all}).front();
  if (pixel.color != all) {
    return pixel;
  }
  // A term is what leaving it out removes.
  for (RenderMaterial& m : trial.scene.materials) {
    m.reflective = glm::vec3(0);
    m.transparent = glm::vec3(0);
  }
  const glm::dvec3 local = drawn_with(trial);
  pixel.followed = all - local;
  Trial dull = trial;
  Trial dark = trial;
  for (std::size_t i = 0; i < trial.scene.materials.size(); ++i) {
    dark.scene.materials[i].ambient = glm::vec3(0);
    dull.scene.materials[i].specular = glm::vec3(0);
  }
  pixel.ambient = local - drawn_with(dark);
  const glm::dvec3 without_highlights = drawn_with(dull);
  glm::dvec3 sum = pixel.ambient + pixel.followed;
  for (std::size_t i = 0; i < trial.scene.lights.size(); ++i) {
    const auto of_light = [&](Trial without) {
      without.scene.lights[i].color = glm::vec3(0);
      return drawn_with(without);
    };
    const glm::dvec3 light = local - of_light(trial);
    const glm::dvec3 diffuse = without_highlights - of_light(dull);
    pixel.lights.push_back({diffuse, light - diffuse});
    sum += light;
  }
  // A mistake may mix terms, such as the color of one light and the direction of another.
  if (largest_of(glm::abs(sum - all)) > 0.5) {
    pixel.lights.clear();
  }
  return pixel;
}

std::uint16_t Simulation::drawing_member(const Combination& mistakes) const {
  std::uint16_t found = no_member;
  for (const std::uint16_t i : mistakes) {
    if (list[i].stage != Stage::picture) {
      if (found != no_member) {
        return no_member;
      }
      found = i;
    }
  }
  return found;
}

void Simulation::fill_cache(std::size_t count, LookFor look_for) {
  // Far less than a mistake has that explains the picture alone.
  constexpr double min_merit = 0.4;
  constexpr std::size_t glance = 32;
  const Base at_a_glance = base(std::min(glance, points.size()));
  const auto unlikely = [&](const Combination& one) {
    return shows_at_edges(list[one.front()]) ||
           rated(one, score_of(one, std::min(glance, points.size())), at_a_glance).merit() <
               min_merit;
  };
  count = std::min(count, points.size());
  const std::size_t first = cache.size();
  std::vector<Colors> drawn_alone(list.size() - first);
  std::vector<std::uint64_t> work(drawn_alone.size());
  for_each_task(drawn_alone.size(), [&](std::size_t i) {
    const Combination one{static_cast<std::uint16_t>(first + i)};
    if (look_for == LookFor::single_mistakes && unlikely(one)) {
      return;
    }
    drawn_alone[i] = drawn(one, count, Turn(), &work[i]).value_or(Colors());
  });
  std::move(drawn_alone.begin(), drawn_alone.end(), std::back_inserter(cache));
  constexpr double max_work = 50;  // relative to that of the right picture; 25 for a wide blur
  const double right = static_cast<double>(clean({}).work) * static_cast<double>(count) /
                       static_cast<double>(std::max<std::size_t>(1, points.size()));
  heavy.resize(list.size());
  for (std::size_t i = 0; i < work.size(); ++i) {
    heavy[first + i] = static_cast<double>(work[i]) > max_work * right;
  }
}

bool Simulation::any_heavy(const Combination& mistakes) const {
  return std::any_of(mistakes.begin(), mistakes.end(),
                     [&](std::uint16_t i) { return i < heavy.size() && heavy[i]; });
}

Colors Simulation::predicted(const Combination& mistakes, std::size_t count) const {
  count = std::min(count, points.size());
  const Turn turn = turn_of(mistakes);
  const Clean& right = clean(turn);
  const auto first = [count](const Colors& colors) {
    return Colors(colors.begin(), colors.begin() + std::ptrdiff_t(count));
  };
  const std::optional<Colors> changed = drawn(mistakes, count, turn);
  if (!changed) {
    Colors of_reference = finished(mistakes, first(right.reference));
    return usable ? closer(std::move(of_reference), finished(mistakes, first(right.drawn)))
                  : of_reference;
  }
  Colors added(count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 now = glm::clamp((*changed)[i], glm::dvec3(0), glm::dvec3(255));
    const glm::dvec3 before = glm::clamp(right.drawn[i], glm::dvec3(0), glm::dvec3(255));
    added[i] = right.reference[i] + now - before;
  }
  return closer(finished(mistakes, std::move(added)), finished(mistakes, *changed));
}

Colors Simulation::closer(Colors a, Colors b) const {
  const Score of_a = score(points, a.size(), a);
  const Score of_b = score(points, b.size(), b);
  const double near = 0.02 * std::min(of_a.left, of_b.left);
  const bool alike = std::abs(of_a.left - of_b.left) <= near;
  return (alike ? of_a.raw <= of_b.raw : of_a.left < of_b.left) ? std::move(a) : std::move(b);
}

Score Simulation::score_of(const Combination& mistakes, std::size_t count) const {
  count = std::min(count, points.size());
  return score(points, count, predicted(mistakes, count));
}

Tried Simulation::rated(Combination mistakes, const Score& s, const Base& b) {
  Tried t;
  t.mistakes = std::move(mistakes);
  t.score = s;
  t.explained = b.left > 0 ? 1 - s.left / b.left : 0;
  t.exact = b.differs > 0 ? s.exact / b.differs : 0;
  // Where nearly all pixels differ, others are equal by chance.
  const double by_chance = 0.1 * b.differs;
  t.broken = b.same > 0 ? s.broken / std::max(b.same, by_chance) : 0;
  // Where few pixels differ, breaking few others is much. Single points may be broken by chance.
  const double many = std::max(0.0, s.broken - 0.005 * b.same);
  t.broken = std::max(t.broken, b.differs > 0 ? 0.1 * many / b.differs : 0);
  return t;
}

std::vector<Tried> Simulation::try_all(const std::vector<Combination>& sets, std::size_t count,
                                       double from, double to) {
  count = std::min(count, points.size());
  const Base b = base(count);
  std::vector<Tried> result(sets.size());
  constexpr std::size_t chunk = 64;
  for (std::size_t start = 0; start < sets.size(); start += chunk) {
    if (!step(from + (to - from) * static_cast<double>(start) / static_cast<double>(sets.size()))) {
      result.resize(start);
      break;
    }
    const std::size_t end = std::min(sets.size(), start + chunk);
    for_each_task(end - start, [&](std::size_t i) {
      const Combination& set = sets[start + i];
      result[start + i] = rated(set, score_of(set, count), b);
    });
  }
  return result;
}
}  // namespace scenefile
