#include "scenefile/grade/confined.h"

#include "scenefile/grade/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr std::size_t max_points_shown = 500;
constexpr double visible = 2;              // in 1/255
constexpr double nearly_all_of_it = 0.98;  // share of the pixels that differ
constexpr double min_outside = 0.1;        // share of the objects' pixels that must be outside
constexpr double max_of_others = 0.5;      // share of the others that may be in the place: chance

std::size_t points_of(const Simulation& sim) {
  return std::min(max_points_shown, sim.points.size());
}

// Weights of points.
struct Place {
  std::string words;  // after "the pixels that differ"
  double differing = 0;
  double all = 0;
};

// `in_place`: by point.
Place measured(const Simulation& sim, std::string words, const std::vector<bool>& in_place) {
  Place place{std::move(words)};
  for (std::size_t i = 0; i < in_place.size(); ++i) {
    const Point& p = sim.points[i];
    place.all += in_place[i] ? p.weight : 0;
    place.differing += in_place[i] && p.differs ? p.weight : 0;
  }
  return place;
}

// The points that change without a term. `drop` removes it from the scene.
std::vector<bool> shows(const Simulation& sim, const std::function<void(Trial&)>& drop) {
  Trial without = sim.right_trial(false);
  drop(without);
  const Simulation::Clean& right = sim.clean({});
  const std::size_t count = points_of(sim);
  const Colors dark = sim.draw(without, *sim.shapes, sim.points, count, Turn(), &right.hits);
  std::vector<bool> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = largest_of(glm::abs(glm::clamp(right.drawn[i], dvec3(0), dvec3(255)) -
                                    glm::clamp(dark[i], dvec3(0), dvec3(255)))) > visible;
  }
  return result;
}

std::vector<Place> places_in(const Simulation& sim) {
  const RenderScene& scene = *sim.view->scene;
  const RenderOptions& options = sim.view->options;
  std::vector<Place> places;
  const auto add = [&](std::string words, const std::function<void(Trial&)>& drop) {
    places.push_back(measured(sim, std::move(words), shows(sim, drop)));
  };
  if (options.mode != Mode::normals) {
    add("show highlights", [](Trial& t) { t.scene.global.specular = 0; });
    add("show diffuse light", [](Trial& t) { t.scene.global.diffuse = 0; });
  }
  if (options.mode == Mode::ray) {
    add("show reflections", [](Trial& t) { t.options.features.reflect = false; });
    add("show something through glass", [](Trial& t) { t.options.features.refract = false; });
    add("show a texture", [](Trial& t) { t.options.features.texture = false; });
    add("are in shadow of a light, or show such a point",
        [](Trial& t) { t.options.features.shadows = false; });
  }
  constexpr std::size_t max_lights = 8;
  for (std::size_t i = 0; i < std::min(max_lights, scene.lights.size()); ++i) {
    add(fmt::format("are lit by light {} ({})", i + 1, word_of(scene.lights[i].type)),
        [i](Trial& t) { t.scene.lights[i].color = glm::vec3(0); });
  }
  const std::vector<ModelHit>& hits = sim.clean({}).hits;
  const auto add_objects = [&](std::string words, const auto& is_one) {
    std::vector<bool> in_place;
    for (std::size_t i = 0; i < points_of(sim); ++i) {
      in_place.push_back(hits[i].part != nullptr && is_one(*hits[i].part));
    }
    places.push_back(measured(sim, std::move(words), in_place));
  };
  // A wrong term may show where the right one is black.
  if (options.mode != Mode::normals && scene.global.specular > 0) {
    add_objects("show an object that can have highlights", [&](const ModelPart& part) {
      const RenderMaterial& m = scene.materials[part.material];
      return m.specular != glm::vec3(0) && m.shininess > 0;
    });
  }
  if (options.mode == Mode::ray && options.features.reflect && scene.global.specular > 0) {
    add_objects("show an object that reflects", [&](const ModelPart& part) {
      return scene.materials[part.material].reflective != glm::vec3(0);
    });
  }
  std::set<Shape> shapes;
  for (std::size_t i = 0; i < points_of(sim); ++i) {
    if (hits[i].part != nullptr) {
      shapes.insert(hits[i].part->shape);
    }
  }
  for (const Shape shape : shapes) {
    add_objects(fmt::format("show a {}", word_of(shape)),
                [shape](const ModelPart& part) { return part.shape == shape; });
  }
  return places;
}

}  // namespace

std::string confined_to(const Simulation& sim) {
  if (!sim.usable) {
    return {};
  }
  const double differing = sim.weight_that_differs(points_of(sim));
  double objects = 0;
  for (std::size_t i = 0; i < points_of(sim); ++i) {
    objects += sim.clean({}).hits[i].part != nullptr ? sim.points[i].weight : 0;
  }
  const Place* best = nullptr;
  const std::vector<Place> places = places_in(sim);
  for (const Place& place : places) {
    if (place.differing >= nearly_all_of_it * differing &&
        place.all - place.differing <= max_of_others * (objects - differing) &&
        objects - place.all >= min_outside * objects &&
        (best == nullptr || place.all < best->all)) {
      best = &place;
    }
  }
  return best == nullptr
             ? std::string()
             : fmt::format(
                   "{} of the pixels that differ {}; so do {} of the others",
                   percent(best->differing / differing), best->words,
                   percent((best->all - best->differing) / std::max(1.0, objects - differing)));
}

}  // namespace scenefile
