#pragma once
// A room with all kinds of materials.

#include "path/rooms.h"

namespace scenefile::path_test {

// Diffuse walls with a lamp of two triangles; objects of all kinds.
inline Room full_room(bool lens, bool lights) {
  Room room;
  Model model;
  FaceMaterial both = diffuse({0.3f, 0.4f, 0.2f});
  both.specular = {0.4f, 0.3f, 0.5f};
  both.shininess = 30;
  model.box({-1, 0, -1}, {1, 2, 1}, true, model.material(diffuse({0.7f, 0.6f, 0.5f})));
  model.quad({-0.3f, 1.99f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f},
             model.material(diffuse(glm::vec3(0.5f), {12, 10, 8})));
  model.box({-0.8f, 0, -0.8f}, {-0.3f, 0.9f, -0.3f}, false, model.material(both));
  model.box({-0.2f, 0.1f, -0.3f}, {0.3f, 0.7f, 0.2f}, false, model.material(glass(1.5f)));
  model.box({0.5f, 0, -0.8f}, {0.9f, 1.2f, -0.4f}, false,
            model.material(mirror({0.9f, 0.8f, 0.7f})));
  room.add(model);
  RenderMaterial ball;
  ball.diffuse = {0.2f, 0.3f, 0.4f};
  ball.specular = glm::vec3(0.3f);
  ball.shininess = 12;
  ball.reflective = glm::vec3(0.2f);
  ball.transparent = glm::vec3(0.5f);
  ball.ior = 1.3f;
  room.add(Shape::sphere, Affine{glm::mat3(0.5f), glm::vec3(0.5f, 0.3f, 0.3f)},
           room.material(ball));
  if (lights) {
    room.light(LightType::point, {0.2, 1.5, 0.4}, glm::vec3(0.4f));
    room.light(LightType::point, {-0.5, 1.2, 0.6}, {0.1f, 0.2f, 0.3f});
  }
  room.look({0, 1, 0.95}, {0, 0.7, 0}, 80);
  if (lens) {
    room.scene.camera.aperture = 0.03;
    room.scene.camera.focal_length = 1;
  }
  return room;
}

}  // namespace scenefile::path_test
