#include "scenefile/format/foreign_names.h"

#include "scenefile/base/text.h"
#include "scenefile/scene/vocabulary.h"

#include <algorithm>
#include <utility>

namespace scenefile {

namespace {

using Pair = std::pair<std::string_view, std::string_view>;

// A foreign word can have several translations; the caller's list of known names decides.
constexpr Pair translations[] = {
    // Elements and keys.
    {"fov", "heightangle"},
    {"fov", "heightAngle"},
    {"fovy", "heightangle"},
    {"fovy", "heightAngle"},
    {"lookat", "focus"},
    {"target", "focus"},
    {"eye", "pos"},
    {"eye", "position"},
    {"attenuation", "function"},
    {"function", "attenuationCoeff"},
    {"pos", "position"},
    {"position", "pos"},
    {"dir", "direction"},
    {"intensity", "color"},
    {"colour", "color"},
    {"color", "diffuse"},
    {"colour", "diffuse"},
    {"albedo", "diffuse"},
    {"refractive", "transparent"},
    {"reflection", "reflective"},
    {"reflect", "reflective"},
    {"shine", "shininess"},
    {"translation", "translate"},
    {"rotation", "rotate"},
    {"scaling", "scale"},
    {"filename", "meshFile"},
    {"children", "groups"},
    {"objects", "groups"},
    {"objects", "primitives"},
    {"shapes", "primitives"},
    {"templates", "templateGroups"},
    {"masters", "templateGroups"},
    // Elements, types of objects.
    {"group", "object"},
    {"group", "tree"},
    {"instance", "master"},
    // Shapes.
    {"box", "cube"},
    {"ball", "sphere"},
    {"globe", "sphere"},
    {"tube", "cylinder"},
    {"model", "mesh"},
    {"obj", "mesh"},
    // Types of lights.
    {"sun", "directional"},
    {"distant", "directional"},
    {"infinite", "directional"},
    {"parallel", "directional"},
    {"directionallight", "directional"},
    {"omni", "point"},
    {"pointlight", "point"},
    {"spotlight", "spot"},
    {"arealight", "area"},
    {"rectangle", "area"},
};

struct Advice {
  std::string_view object;
  std::string_view key;
  std::string_view text;
};

constexpr std::string_view to_the_group = "transforms belong to the group whose list contains this";
constexpr std::string_view into_a_group = "put it into a group of \"groups\"";
constexpr std::string_view to_the_scene =
    "it belongs at the top level of the scene, next to \"groups\"";

constexpr Advice advices[] = {
    {"a light", "position",
     "a light is at the origin of its group: give the group a \"translate\""},
    {"a primitive", "position", to_the_group},
    {"the scene", "lights", into_a_group},
    {"the scene", "primitives", into_a_group},
    {"a group", "templateGroups", to_the_scene},
    {"a template group", "templateGroups", to_the_scene},
    {"a group", "type", "anything with a type belongs in the lists \"primitives\" and \"lights\""},
};

}  // namespace

std::string_view translated_name(std::string_view word, std::span<const std::string_view> known) {
  const auto* const found =
      std::find_if(std::begin(translations), std::end(translations), [&](const Pair& pair) {
        return equal_ignoring_case(pair.first, word) &&
               std::find(known.begin(), known.end(), pair.second) != known.end();
      });
  return found == std::end(translations) ? std::string_view() : found->second;
}

std::string_view json_key_advice(std::string_view object, std::string_view key) {
  if (is_transform(key) && (object == "a light" || object == "a primitive")) {
    return to_the_group;
  }
  const auto* const found = std::find_if(
      std::begin(advices), std::end(advices),
      [&](const Advice& advice) { return advice.object == object && advice.key == key; });
  return found == std::end(advices) ? std::string_view() : found->text;
}

}  // namespace scenefile
