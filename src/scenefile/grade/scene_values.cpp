#include "scenefile/grade/scene_values.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/scene/field_places.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace scenefile {

namespace {

std::vector<float*> numbers_of(float& value) {
  return {&value};
}
std::vector<float*> numbers_of(std::optional<float>& value) {
  return value ? std::vector<float*>{&*value} : std::vector<float*>();
}
std::vector<float*> numbers_of(glm::vec3& value) {
  return {&value.x, &value.y, &value.z};
}
template <typename Other>
std::vector<float*> numbers_of(Other& /*value*/) {
  return {};
}

// The numbers in the member of a row; none if it holds text, or nothing.
template <typename Owner>
std::vector<float*> numbers_of(const ValueRow<Owner>& row, Owner& owner) {
  return std::visit(
      [&](const auto& member) {
        if constexpr (std::is_same_v<std::decay_t<decltype(member)>, std::monostate>) {
          return std::vector<float*>();
        } else {
          return numbers_of(owner.*member);
        }
      },
      row.member);
}

// `numbers_in`: finds the numbers in a copy of the scene.
SceneValue value_of(const Scene& scene, ValueEffect effect, std::string name, Location location,
                    std::function<std::vector<float*>(Scene&)> numbers_in) {
  Scene copy = scene;
  SceneValue value{effect, std::move(name), location, {}, {}};
  for (const float* number : numbers_in(copy)) {
    value.numbers.push_back(*number);
  }
  value.set = [numbers_in = std::move(numbers_in)](Scene& changed,
                                                   const std::vector<double>& numbers) {
    const std::vector<float*> places = numbers_in(changed);
    for (std::size_t i = 0; i < places.size(); ++i) {
      *places[i] = static_cast<float>(numbers[i]);
    }
  };
  return value;
}

// Adds the rows that have numbers and an effect. `owner_in`: finds the owner in a copy of the
// scene.
template <typename Owner, std::size_t N, typename OwnerIn, typename EffectOf>
void add_rows(const Scene& scene, const ValueRow<Owner> (&rows)[N], Owner owner, Location place,
              const std::string& of, const OwnerIn& owner_in, const EffectOf& effect_of,
              std::vector<SceneValue>& values) {
  FieldPlaces places(scene.field_places);
  for (const ValueRow<Owner>& row : rows) {
    const std::optional<ValueEffect> effect = effect_of(row);
    if (effect && row.field && !numbers_of(row, owner).empty()) {
      values.push_back(value_of(scene, *effect, fmt::format("the {} of {}", row.name(), of),
                                places.find(place, *row.field), [&row, owner_in](Scene& copy) {
                                  return numbers_of(row, owner_in(copy));
                                }));
      values.back().range = row.range;
      values.back().direction =
          row.field == Field::look || row.field == Field::up || row.field == Field::direction;
    }
  }
}

void add_camera_values(const Scene& scene, std::vector<SceneValue>& values) {
  add_rows(
      scene, camera_rows, *scene.camera, scene.camera->location, "the camera",
      [](Scene& copy) -> Camera& { return *copy.camera; },
      [](const ValueRow<Camera>& row) {
        const bool lens = row.field == Field::aperture || row.field == Field::focal_length;
        return lens ? std::nullopt : std::optional(ValueEffect::camera);
      },
      values);
  // In files with a focus, the direction follows from the position.
  const Camera& camera = *scene.camera;
  const Location place = FieldPlaces(scene.field_places).find(camera.location, Field::position);
  SceneValue aimed =
      value_of(scene, ValueEffect::camera, "the pos of the camera, which looks at the same point,",
               place, [](Scene& copy) { return numbers_of(copy.camera->position); });
  aimed.set = [set = aimed.set, focus = camera.position + camera.look](
                  Scene& changed, const std::vector<double>& numbers) {
    set(changed, numbers);
    changed.camera->look = focus - changed.camera->position;
  };
  values.push_back(std::move(aimed));
  values.push_back(value_of(scene, ValueEffect::camera, "the pose of the camera, pos and look,",
                            place, [](Scene& copy) {
                              std::vector<float*> numbers = numbers_of(copy.camera->position);
                              const std::vector<float*> more = numbers_of(copy.camera->look);
                              numbers.insert(numbers.end(), more.begin(), more.end());
                              return numbers;
                            }));
}

}  // namespace

std::vector<SceneValue> values_of_view(const Scene& scene, const Prepared& prepared) {
  constexpr std::size_t max_lights = 8;
  std::vector<SceneValue> values;
  add_rows(
      scene, global_rows, scene.global, scene.global.location, "the scene",
      [](Scene& copy) -> Global& { return copy.global; },
      [](const ValueRow<Global>& /*row*/) { return ValueEffect::colors; }, values);
  if (scene.camera) {
    add_camera_values(scene, values);
  }
  for (std::size_t i = 0; i < std::min(max_lights, prepared.scene.lights.size()); ++i) {
    const Source source = prepared.sources[prepared.scene.lights[i].source];
    const Light& light = scene.nodes[source.node].lights[source.index];
    add_rows(
        scene, light_rows, light, light.location,
        fmt::format("light {} ({})", i + 1, word_of(light.type)),
        [source](Scene& copy) -> Light& { return copy.nodes[source.node].lights[source.index]; },
        [&](const ValueRow<Light>& row) -> std::optional<ValueEffect> {
          if (!row.used_by_type(light.type)) {
            return std::nullopt;
          }
          return row.kind == ValueKind::color || row.kind == ValueKind::coefficients
                     ? ValueEffect::colors
                     : ValueEffect::light;
        },
        values);
  }
  return values;
}

std::vector<SceneValue> values_of_material(const Scene& scene, const Source& primitive) {
  const Primitive& owner = scene.nodes[primitive.node].primitives[primitive.index];
  std::vector<SceneValue> values;
  add_rows(
      scene, material_rows, owner.material, owner.location,
      fmt::format("the {}", word_of(owner.shape)),
      [primitive](Scene& copy) -> Material& {
        return copy.nodes[primitive.node].primitives[primitive.index].material;
      },
      [](const ValueRow<Material>& /*row*/) { return ValueEffect::surface; }, values);
  return values;
}

std::vector<SceneValue> values_of_transforms(const Scene& scene, NodeId node) {
  std::vector<SceneValue> values;
  const std::vector<Transform>& transforms = scene.nodes[node].transforms;
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const auto add = [&](const char* name, auto numbers) {
      values.push_back(
          value_of(scene, ValueEffect::shapes, fmt::format("the {} of an object", name),
                   transforms[i].location,
                   [=](Scene& copy) { return numbers(copy.nodes[node].transforms[i].map); }));
    };
    using Map = decltype(Transform::map);
    if (std::holds_alternative<Translate>(transforms[i].map)) {
      add("translation", [](Map& map) { return numbers_of(std::get<Translate>(map).by); });
    } else if (std::holds_alternative<Scale>(transforms[i].map)) {
      add("scale", [](Map& map) { return numbers_of(std::get<Scale>(map).by); });
    } else if (std::holds_alternative<Rotate>(transforms[i].map)) {
      add("angle", [](Map& map) { return numbers_of(std::get<Rotate>(map).angle_deg); });
      add("axis", [](Map& map) { return numbers_of(std::get<Rotate>(map).axis); });
      values.back().direction = true;
    }
  }
  return values;
}

}  // namespace scenefile
