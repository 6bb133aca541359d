#include "scenefile/format/block.h"

#include <glm/glm.hpp>

#include <limits>

namespace scenefile {

bool needs_place(Field field, const glm::vec3& value, const Scene& scene) {
  constexpr std::size_t few = 10'000;
  // A finding about these two is only about their own numbers, not about other values.
  const bool by_itself = field == Field::diffuse || field == Field::ambient;
  return scene.field_places.size() < few || !by_itself ||
         !glm::all(glm::greaterThanEqual(value, glm::vec3(0))) ||
         !glm::all(glm::lessThanEqual(value, glm::vec3(1)));
}

void look_at(const glm::vec3& focus, Camera& camera) {
  if (camera.unread.contains(Field::position)) {
    camera.unread.insert(Field::look);
  }
  if (!camera.unread.contains(Field::look)) {
    // Scaled down if it overflows a float: only the direction matters.
    const glm::vec3 direction = focus - camera.position;
    const bool finite = glm::length(glm::dvec3(direction)) < std::numeric_limits<float>::max();
    camera.look = finite ? direction : focus * 0.25f - camera.position * 0.25f;
  }
}

}  // namespace scenefile
