#include "scenefile/base/shape_traits.h"
#include "scenefile/mistakes/hypothesis_list.h"
#include "scenefile/scene/world_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scenefile {

using glm::dvec3;

namespace {

bool is_infinitely_far(LightType type) {
  return !has_position(type);
}
bool is_plain_point(LightType type) {
  return is_at_a_point(type) && !has_cone(type);
}

// A light as written in the file, in world space, for a light of the render scene.
struct WrittenLight {
  dvec3 position{0};
  double length = 1;            // of the direction
  bool no_attenuation = false;  // all coefficients are 0
};

// Like the lights of the view: instances of one light are in the order of world_lights().
std::vector<WrittenLight> lights_as_written(const SceneView& view) {
  const std::vector<RenderLight>& ready = view.scene->lights;
  std::vector<WrittenLight> result;
  world_lights(*view.written, [&](const WorldLight& at) {
    if (result.size() == ready.size()) {
      return false;
    }
    const Source& source = (*view.sources)[ready[result.size()].source];
    const Light& light = view.written->nodes[at.node].lights[at.index];
    if (source.node == at.node && source.index == at.index &&
        ready_light(light, at.world_from_node)) {
      result.push_back({at.world_from_node.point(dvec3(light.position)),
                        glm::length(at.world_from_node.vector(dvec3(light.direction))),
                        has_position(light.type) && light.attenuation == glm::vec3(0)});
    }
    return true;
  });
  result.resize(ready.size());
  return result;
}

void change_lights(HypothesisList& list, Cause cause, std::string_view what,
                   std::function<void(RenderLight&)> change) {
  list.add(cause, what, [change = std::move(change)](Trial& t) {
    std::for_each(t.scene.lights.begin(), t.scene.lights.end(), change);
  });
}

}  // namespace

void add_lights(HypothesisList& list) {
  using L = LightVectorMistake;
  const bool positional = list.any_type(is_at_a_point);
  const bool directional = list.any_type(is_infinitely_far);
  const auto put = [&](std::initializer_list<Row<L>> rows) {
    list.set_each(Cause::lights, &ModelMistakes::light_vector, rows);
  };
  list.add(Cause::lights,
           std::string("no light contributes: only the ambient term is left") +
               (list.shadows() ? ", as if every shadow ray hit the surface that it starts on" : ""),
           [](Trial& t) { t.scene.lights.clear(); });
  for (const LightType type : list.types) {
    if (list.types.size() > 1) {
      list.add(
          Cause::lights, fmt::format("{} lights are left out", word_of(type)), [type](Trial& t) {
            std::erase_if(t.scene.lights, [type](const RenderLight& l) { return l.type == type; });
          });
    }
  }
  if (list.types.size() > 2) {
    for (const LightType type : list.types) {
      list.add(Cause::lights, fmt::format("all lights but the {} ones are left out", word_of(type)),
               [type](Trial& t) {
                 std::erase_if(t.scene.lights,
                               [type](const RenderLight& l) { return l.type != type; });
               });
    }
  }
  if (list.scene.lights.size() > 1) {
    list.add(Cause::lights, "only the first light is used",
             [](Trial& t) { t.scene.lights.resize(1); });
    list.add(Cause::lights, "only the last light is used", [](Trial& t) {
      t.scene.lights.erase(t.scene.lights.begin(), t.scene.lights.end() - 1);
    });
    static constexpr std::size_t max_lights = 24;
    const std::size_t count = list.scene.lights.size();
    for (std::size_t n = 2; n < std::min<std::size_t>(count - 1, 9); ++n) {
      list.add(Cause::lights, fmt::format("only the first {} lights are used", n),
               [n](Trial& t) { t.scene.lights.resize(std::min(n, t.scene.lights.size())); });
    }
    for (std::size_t i = 0; i < std::min(count, max_lights); ++i) {
      list.add(Cause::lights,
               i == 0           ? std::string("the first light is left out")
               : i + 1 == count ? std::string("the last light is left out")
                                : fmt::format("light {} ({}) is left out", i + 1,
                                              word_of(list.scene.lights[i].type)),
               [i](Trial& t) { t.scene.lights.erase(t.scene.lights.begin() + std::ptrdiff_t(i)); });
    }
  }
  if (positional) {
    put({{L::not_normalized, "vectors to point lights and spotlights are not normalized"}});
  }
  if (positional && directional) {
    put({{L::reversed, "vectors to all lights point the wrong way"}});
  }
  if (directional) {
    put({{L::reversed_directional, "directional lights shine the wrong way"}});
    change_lights(
        list, Cause::lights, "directional lights are used as point lights at their position",
        [](RenderLight& l) { l.type = is_infinitely_far(l.type) ? LightType::point : l.type; });
    for (const float sign : {1.0F, -1.0F}) {
      change_lights(
          list, Cause::lights,
          sign > 0 ? "the position of directional lights is used as their direction"
                   : "directional lights shine from their position to the origin",
          [sign](RenderLight& l) {
            // The course's parser has a default.
            const glm::vec3 written = l.position == glm::vec3(0) ? glm::vec3(3) : l.position;
            l.direction = is_infinitely_far(l.type) ? sign * glm::normalize(written) : l.direction;
          });
    }
    for (const float sign : {1.0f, -1.0f}) {
      change_lights(list, Cause::lights,
                    sign > 0
                        ? "the direction of directional lights is used as a position"
                        : "the direction of directional lights, negated, is used as a position",
                    [sign](RenderLight& l) {
                      if (is_infinitely_far(l.type)) {
                        l.type = LightType::point;
                        l.position = sign * l.direction;
                      }
                    });
    }
  }
  if (positional) {
    put({{L::reversed_positional, "vectors to point lights and spotlights point away from them"},
         {L::to_origin, "point lights shine along one direction everywhere"},
         {L::to_origin_all,
          "point lights and spotlights shine along one direction everywhere, also in shadow rays"},
         {L::from_object_point,
          "vectors to point lights and spotlights start at the object-space point"},
         {L::from_object_point_all,
          "vectors and distances to point lights and spotlights, and shadow rays, start at the "
          "object-space point"},
         {L::sum,
          "vectors to point lights and spotlights are sums of light and point, not "
          "differences"},
         {L::sum_all,
          "vectors to point lights and spotlights are sums of light and point, not differences, "
          "also in shadow rays"}});
  }
  if (list.scene.lights.size() > 1) {
    const auto sum = [&](LightSum value, const std::string& what) {
      list.set(Cause::lights, &ModelMistakes::light_sum, value, what);
    };
    const std::string lit = list.shadows() ? ", where it is not shadowed" : "";
    sum(LightSum::brightest,
        "only the brightest light counts: the maximum of the lights, not their sum");
    sum(LightSum::last, "each light replaces those before it" + lit);
    sum(LightSum::last_of_all, "each light replaces those before it and the ambient term" + lit);
    const auto sum_of = [&](LightTerm term, LightSum value, std::string_view what) {
      list.add(Cause::lights, what, [=](Trial& t) {
        t.mistakes.light_sum = value;
        t.mistakes.summed_term = term;
      });
    };
    for (const auto& [term, name] :
         {std::pair(LightTerm::diffuse, "diffuse"), std::pair(LightTerm::specular, "specular")}) {
      sum_of(term, LightSum::first_of_term,
             fmt::format("only the first light has a {} term", name));
      sum_of(term, LightSum::last_of_term, fmt::format("only the last light has a {} term", name));
      if (list.shadows()) {
        sum_of(term, LightSum::replaces_term,
               fmt::format("the {} term of each light replaces those before it{}", name, lit));
      }
    }
    change_lights(list, Cause::lights, "the light is divided by the number of lights",
                  [n = float(list.scene.lights.size())](RenderLight& l) { l.color /= n; });
  }
  change_lights(list, Cause::lights, "the color of lights is ignored: they are white",
                [](RenderLight& l) { l.color = glm::vec3(1); });
  change_lights(list, Cause::lights, "colors of lights are normalized like vectors",
                [](RenderLight& l) {
                  const float length = glm::length(l.color);
                  l.color /= length > 0 ? length : 1;
                });
  change_lights(list, Cause::lights, "colors of lights are scaled to a maximum of 1",
                [](RenderLight& l) {
                  const float most = std::max({l.color.x, l.color.y, l.color.z});
                  l.color /= most > 0 ? most : 1;
                });
  change_lights(list, Cause::lights, "colors of lights are limited to 1",
                [](RenderLight& l) { l.color = glm::min(l.color, glm::vec3(1)); });
  change_lights(
      list, Cause::lights, "lights are gray: the mean of their color is used",
      [](RenderLight& l) { l.color = glm::vec3((l.color.x + l.color.y + l.color.z) / 3); });
  change_lights(list, Cause::lights, "lights only have the red of their color",
                [](RenderLight& l) { l.color = glm::vec3(l.color.x); });
}

void add_brightness_of_light(HypothesisList& list) {
  list.set(Cause::diffuse, &ModelMistakes::diffuse_factor, 0.5, "the diffuse term is halved");
  if (list.scene.global.diffuse != 1) {
    list.add(Cause::diffuse, "the coefficient of the diffuse term is squared",
             [](Trial& t) { t.scene.global.diffuse *= t.scene.global.diffuse; });
  }
  change_lights(list, Cause::lights, "lights are twice as bright",
                [](RenderLight& l) { l.color *= 2; });
  change_lights(list, Cause::lights, "lights are half as bright",
                [](RenderLight& l) { l.color /= 2; });
}

void add_reversed_shading(HypothesisList& list) {
  using L = LightVectorMistake;
  const bool positional = list.any_type(is_at_a_point);
  const bool directional = list.any_type(is_infinitely_far);
  const auto put = [&](std::initializer_list<Row<L>> rows) {
    list.set_each(Cause::lights, &ModelMistakes::light_vector, rows);
  };
  if (positional && directional) {
    put({{L::reversed_shading,
          "vectors to all lights point the wrong way in the lighting; shadow rays are right"}});
  }
  if (directional) {
    put({{L::reversed_directional_shading,
          "directional lights shine the wrong way in the lighting; shadow rays are right"}});
  }
  if (positional) {
    put({{L::reversed_positional_shading,
          "vectors to point lights and spotlights point away from them in the lighting; shadow "
          "rays are "
          "right"}});
    change_lights(list, Cause::lights, "lights are at the world's origin",
                  [](RenderLight& l) { l.position = glm::vec3(0); });
    change_lights(list, Cause::lights, "the position of lights is negated",
                  [](RenderLight& l) { l.position = -l.position; });
  }
}

// Mistakes about lights that need the written file, because the prepared scene lacks that
// information.
void add_written_lights(HypothesisList& list) {
  if (list.view.written == nullptr || list.view.sources == nullptr) {
    return;
  }
  const std::vector<WrittenLight> written = lights_as_written(list.view);
  std::vector<double> lengths;
  bool longer = false;
  bool placed = false;
  for (std::size_t i = 0; i < written.size(); ++i) {
    lengths.push_back(has_direction(list.scene.lights[i].type) ? written[i].length : 1);
    longer = longer || std::abs(lengths.back() - 1) > 0.01;
    placed = placed || (is_infinitely_far(list.scene.lights[i].type) &&
                        glm::length(written[i].position) > 1e-3);
  }
  using L = LightVectorMistake;
  const auto put = [&](L value, const char* what) {
    list.add(Cause::lights, what, [value, lengths](Trial& t) {
      t.mistakes.light_vector = value;
      t.mistakes.light_lengths = lengths;
    });
  };
  if (longer && list.any_type(is_infinitely_far)) {
    put(L::directional_as_long_as_written, "directions of directional lights are not normalized");
  }
  if (longer && list.any_type(has_cone)) {
    put(L::spot_as_long_as_written, "directions of spotlights are not normalized");
  }
  if (longer && list.any_type(is_infinitely_far) && list.any_type(has_cone)) {
    put(L::as_long_as_written, "directions of lights are not normalized");
  }
  if (std::any_of(written.begin(), written.end(),
                  [](const WrittenLight& l) { return l.no_attenuation; })) {
    using A = AttenuationMistake;
    for (const auto& [value, what] :
         {std::pair(A::infinite_white,
                    "the attenuation is not clamped to 1: dividing by 0 gives infinite light, and "
                    "white pixels in shadow"),
          std::pair(A::infinite_black,
                    "the attenuation is not clamped to 1: dividing by 0 gives values that are not "
                    "numbers, drawn black")}) {
      list.add(Cause::attenuation, what, [value = value, written](Trial& t) {
        t.mistakes.attenuation = value;
        for (std::size_t i = 0; i < t.scene.lights.size() && i < written.size(); ++i) {
          if (written[i].no_attenuation) {
            t.scene.lights[i].attenuation = glm::vec3(0);
          }
        }
      });
    }
  }
  if (placed) {
    list.add(Cause::lights, "the direction of directional lights is read from the position",
             [written](Trial& t) {
               t.mistakes.light_vector = L::position_as_direction;
               for (std::size_t i = 0; i < t.scene.lights.size() && i < written.size(); ++i) {
                 if (is_infinitely_far(t.scene.lights[i].type)) {
                   t.scene.lights[i].position = glm::vec3(written[i].position);
                 }
               }
             });
  } else if (list.any_type(is_infinitely_far)) {
    list.set(Cause::lights, &ModelMistakes::light_vector, L::position_as_direction,
             "the direction of directional lights is read from the position");
  }
}

void add_attenuation(HypothesisList& list) {
  if (!list.any_light([](const RenderLight& l) { return has_position(l.type); })) {
    return;
  }
  using A = AttenuationMistake;
  const auto put = [&](std::initializer_list<Row<A>> rows) {
    list.set_each(Cause::attenuation, &ModelMistakes::attenuation, rows);
  };
  const bool fades = list.any_light([](const RenderLight& l) {
    return has_position(l.type) && l.attenuation != glm::vec3(1, 0, 0);
  });
  put({{A::inverse_square, "lights fade by 1 / d^2; their coefficients are ignored"},
       {A::inverse, "lights fade by 1 / d; their coefficients are ignored"},
       {A::inverse_square_unlimited,
        "lights fade by 1 / d^2, not limited to 1; their coefficients are ignored"},
       {A::inverse_unlimited,
        "lights fade by 1 / d, not limited to 1; their coefficients are ignored"},
       {A::one_plus_square, "lights fade by 1 / (1 + d^2); their coefficients are ignored"}});
  if (!fades) {
    return;
  }
  put({{A::absent, "lights do not fade with distance"}});
  if (list.any_light([](const RenderLight& l) { return l.attenuation.z != 0; })) {
    put({{A::no_quadratic, "the quadratic term of the attenuation is missing"}});
  }
  if (list.any_light([](const RenderLight& l) { return l.attenuation.y != 0; })) {
    put({{A::no_linear, "the linear term of the attenuation is missing"}});
  }
  if (list.any_light([](const RenderLight& l) { return l.attenuation.x != 0; })) {
    put({{A::no_constant, "the constant term of the attenuation is missing"}});
  }
  put({{A::not_clamped, "the attenuation is not clamped to 1"},
       {A::squared, "the attenuation is applied twice"},
       {A::multiplied, "light is multiplied by the attenuation polynomial instead of divided"},
       {A::reversed_coefficients, "the coefficients of the attenuation are read in reverse order"},
       {A::diffuse_only, "highlights do not fade with distance"},
       {A::specular_only, "the diffuse term does not fade with distance"},
       {A::to_eye, "the attenuation uses the distance from the light to the eye"},
       {A::eye_to_point, "the attenuation uses the distance from the eye to the point"},
       {A::from_origin, "the attenuation uses the distance from the world's origin to the light"},
       {A::one_plus, "1 is added to the attenuation polynomial"},
       {A::squared_distance, "the attenuation uses the squared distance as the distance"},
       {A::clamped_below, "the attenuation is clamped to at least 1 instead of at most 1"}});
  list.set(Cause::attenuation, &ModelMistakes::light_sum, LightSum::attenuated_again,
           "the attenuation of each light is also applied to what was added before it");
  if (list.any_type(has_cone)) {
    put({{A::specular_only_with_cone,
          "attenuation and the falloff of spotlights multiply only the specular term, not the sum "
          "of both terms"},
         {A::diffuse_only_with_cone,
          "attenuation and the falloff of spotlights multiply only the diffuse term, not the sum "
          "of both terms"}});
  }
  if (list.any_type(has_cone) && list.any_type(is_plain_point)) {
    put({{A::spots_only, "point lights do not fade with distance; spotlights do"},
         {A::points_only, "spotlights do not fade with distance; point lights do"}});
  }
}

void add_spots(HypothesisList& list) {
  if (!list.any_type(has_cone)) {
    return;
  }
  using S = SpotMistake;
  const auto put = [&](std::initializer_list<Row<S>> rows) {
    list.set_each(Cause::spot_falloff, &ModelMistakes::spot, rows);
  };
  const auto spot = [&](const char* what, void (*change)(RenderLight&)) {
    change_lights(list, Cause::spot_falloff, what, [change](RenderLight& l) {
      if (has_cone(l.type)) {
        change(l);
      }
    });
  };
  spot("spotlights shine in all directions", [](RenderLight& l) { l.type = LightType::point; });
  spot("spotlights have no penumbra: full light up to the outer angle",
       [](RenderLight& l) { l.inner_angle = l.outer_angle; });
  put({{S::linear, "spotlights fall off linearly instead of by the smoothstep"},
       {S::quadratic, "spotlights fall off by (1 - t)^2 instead of by the smoothstep"},
       {S::one_minus_square, "spotlights fall off by 1 - t^2 instead of by the smoothstep"}});
  spot("spotlights end at their inner angle",
       [](RenderLight& l) { l.outer_angle = l.inner_angle; });
  spot("the penumbra is outside the angle of the spotlight, not inside", [](RenderLight& l) {
    const float penumbra = l.outer_angle - l.inner_angle;
    l.inner_angle = l.outer_angle;
    l.outer_angle += penumbra;
  });
  spot("the penumbra is used as the inner angle", [](RenderLight& l) {
    l.inner_angle = std::min(l.outer_angle - l.inner_angle, l.outer_angle);
  });
  spot("inner and outer angle of spotlights are mixed up: angle and penumbra are swapped",
       [](RenderLight& l) {
         const float penumbra = l.outer_angle - l.inner_angle;
         const float outer = l.outer_angle;
         l.outer_angle = penumbra;
         l.inner_angle = std::max(0.0f, penumbra - outer);
       });
  for (const float factor : {2.0f, 0.5f}) {
    change_lights(list, Cause::spot_falloff,
                  factor == 2 ? "the penumbra of spotlights is twice as wide as it should be"
                              : "the penumbra of spotlights is half as wide as it should be",
                  [factor](RenderLight& l) {
                    if (has_cone(l.type)) {
                      l.inner_angle = l.outer_angle - factor * (l.outer_angle - l.inner_angle);
                    }
                  });
  }
  spot("spotlights are aimed at the world's origin", [](RenderLight& l) {
    if (glm::length(l.position) > 0) {
      l.direction = -glm::normalize(l.position);
    }
  });
  spot("spotlights are too wide by half of the penumbra: it is centered on the outer angle",
       [](RenderLight& l) {
         const float half = (l.outer_angle - l.inner_angle) / 2;
         l.inner_angle += half;
         l.outer_angle += half;
       });
  spot("spotlights fall off from their axis, not from the inner angle",
       [](RenderLight& l) { l.inner_angle = 0; });
  spot("the angle of the spotlight is used as the full angle of the cone", [](RenderLight& l) {
    const float penumbra = l.outer_angle - l.inner_angle;
    l.outer_angle /= 2;
    l.inner_angle = std::max(0.0f, l.outer_angle - penumbra);
  });
  spot("both angles of the spotlight are halved", [](RenderLight& l) {
    l.inner_angle /= 2;
    l.outer_angle /= 2;
  });
  spot("both angles of the spotlight are doubled", [](RenderLight& l) {
    l.inner_angle *= 2;
    l.outer_angle *= 2;
  });
  put({{S::in_cosine, "the falloff of spotlights is between cosines, not between angles"},
       {S::linear_in_cosine, "spotlights fall off linearly between cosines"},
       {S::inverted, "spotlights are dark inside and bright outside"},
       {S::penumbra_inverted, "the falloff of spotlights runs the wrong way in the penumbra"},
       {S::no_limit, "spotlights shine beyond their outer angle"},
       {S::squared, "the falloff of spotlights is applied twice"},
       {S::cosine_power, "spotlights fall off by the cosine"},
       {S::reversed_axis, "spotlights shine backward"}});
  spot("spotlights shine along the opposite direction",
       [](RenderLight& l) { l.direction = -l.direction; });
}

void add_shadows(HypothesisList& list) {
  if (!list.shadows()) {
    return;
  }
  list.add(Cause::shadows, "there are no shadows",
           [](Trial& t) { t.options.features.shadows = false; });
  using S = ShadowMistake;
  const auto put = [&](std::initializer_list<Row<S>> rows) {
    list.set_each(Cause::shadows, &ModelMistakes::shadow, rows);
  };
  const bool positional = list.any_type(is_at_a_point);
  if (positional) {
    put({{S::beyond_light,
          "objects behind a light cast shadows too: the distance is not compared"}});
  }
  if (list.scene.lights.size() > 1) {
    put({{S::first_light_only, "only the first light casts shadows"},
         {S::last_light_only, "only the last light casts shadows"}});
  }
  if (list.shapes.size() > 1) {
    constexpr std::array without{
        std::pair(Shape::sphere, S::no_spheres), std::pair(Shape::cube, S::no_cubes),
        std::pair(Shape::cylinder, S::no_cylinders), std::pair(Shape::cone, S::no_cones),
        std::pair(Shape::mesh, S::no_meshes)};
    static_assert(without.size() == shape_count);
    for (const auto& [shape, value] : without) {
      if (list.shapes.contains(shape)) {
        list.set(
            Cause::shadows, &ModelMistakes::shadow, value,
            fmt::format("{}{} cast no shadows", word_of(shape), shape == Shape::mesh ? "es" : "s"));
      }
    }
  }
  if (list.scene.lights.size() > 1) {
    put({{S::ambient_only,
          "where one light is shadowed, all are lost: only the ambient term is left"},
         {S::stops, "lights after the first shadowed one are lost"},
         {S::resets,
          "where a light is shadowed, the ambient term and the lights before it are lost, too"},
         {S::first_light_for_all, "the shadow of the first light counts for all"}});
  }
  put({{S::reversed, "shadow rays point away from the light"},
       {S::black, "shadows are black: the ambient term is lost"},
       {S::no_ambient_if_all, "where every light is shadowed, the ambient term is lost, too"},
       {S::keeps_specular, "shadows remove only the diffuse term"},
       {S::keeps_diffuse, "shadows remove only the specular term"},
       {S::half, "shadows remove only half of the light"},
       {S::inverted,
        "the test for shadows is inverted: lights only shine where they are shadowed"}});
  if (list.any_type(has_cone)) {
    put({{S::spot_along_axis, "shadow rays of spotlights run along the axis of the spotlight"},
         {S::spot_without, "spotlights cast no shadows"}});
  }
  if (list.any_type(is_plain_point)) {
    put({{S::point_without, "point lights cast no shadows"}});
  }
  if (list.any_type(is_infinitely_far)) {
    put({{S::directional_without, "directional lights cast no shadows"},
         {S::direction_unnormalized_far, "shadows of directional lights are only 1 unit long"}});
    if (list.any_type(has_cone) && list.any_type(is_plain_point)) {
      put({{S::directional_only, "only directional lights cast shadows"}});
    }
  }
  if (list.any_material([](const RenderMaterial& m) { return m.transparent != glm::vec3(0); })) {
    put({{S::glass_lets_through, "transparent objects cast no shadows"}});
  }
  put({{S::not_own_object, "objects cast no shadow on themselves"},
       {S::any_nearer_than_eye,
        "the distance of occluders is compared with the distance to the eye"},
       {S::unit_length, "only objects nearer than 1 unit cast shadows"},
       {S::point_as_directional, "shadows of point lights are only 1 unit long"},
       {S::from_eye, "shadow rays start at the eye"},
       {S::from_origin, "shadow rays start at the world's origin"},
       {S::squared_distance,
        "the distance of occluders is compared with the square of the light's distance"},
       {S::object_distance, "distances along shadow rays are measured in object space"}});
  if (list.any_type(is_infinitely_far)) {
    put({{S::directional_ends_at_position,
          "shadow rays of directional lights end at the light's position"}});
    if (positional) {
      put({{S::positional_nearer_than_eye,
            "for point lights and spotlights, the distance of occluders is compared with the "
            "distance to the eye"}});
    }
  }
  if (positional) {
    put({{S::beyond_light_only,
          "only objects behind the light cast shadows: the comparison of distances is reversed"}});
  }
  if (count_virtual_primitives(list.scene) > 1) {
    put({{S::last_object_only,
          "only the last object casts shadows: its result replaces those before it"},
         {S::first_object_only, "only the first object casts shadows"}});
  }
  put({{S::light_from_origin, "the light's distance is measured from the world's origin"},
       {S::light_to_eye,
        "the distance of occluders is compared with the distance from the light to the eye"}});
  for (const double bias :
       {0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.75, 1.0, 2.0}) {
    list.set(Cause::shadows, &ModelMistakes::shadow_bias, bias,
             fmt::format("shadow rays start too far from the surface (about {} units)", bias));
  }
  for (const double lift : {0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 1.0}) {
    list.set(
        Cause::shadows, &ModelMistakes::shadow_lift, lift,
        fmt::format("shadow rays start too far from the surface (about {} units along the normal)",
                    lift));
  }
  for (const double back : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
    list.set(
        Cause::shadows, &ModelMistakes::shadow_back, back,
        fmt::format("shadow rays start before the surface (about {} units toward the eye)", back));
  }
}

}  // namespace scenefile
