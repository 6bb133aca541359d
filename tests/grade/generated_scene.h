#pragma once
// Generated scenes with every feature that a mistake can affect.

#include "student/student_tracer.h"
#include "trace/build_scene.h"

#include <random>
#include <set>
#include <string>

namespace scenefile::grade_test {

/// A floor, a wall, stretched shapes with textures, mirrors; a point light, a spotlight and a
/// directional light.
class GeneratedScene {
 public:
  explicit GeneratedScene(std::uint32_t seed) : random_(seed) {
    builder.scene.global.ambient = uniform(0.3f, 0.7f);
    builder.scene.global.diffuse = uniform(0.5f, 0.8f);
    builder.scene.global.specular = uniform(0.5f, 0.8f);
    const std::uint32_t image = make_texture();
    add_room(image);
    add_shapes(image);
    add_lights();
    builder.look({uniform(-2, 2), uniform(2, 3.5f), uniform(5.5f, 7)},
                 {uniform(-0.3f, 0.3f), 0.3f, 0}, uniform(40, 50));
  }

  trace_test::SceneBuilder builder;

  /// The scene in its written form, before prepare().
  Scene written() const {
    const RenderScene& ready = builder.scene;
    Scene scene;
    scene.global.ambient = ready.global.ambient;
    scene.global.diffuse = ready.global.diffuse;
    scene.global.specular = ready.global.specular;
    Camera camera;
    camera.position = glm::vec3(ready.camera.position);
    camera.look = glm::vec3(-ready.camera.w);
    camera.up = glm::vec3(ready.camera.v);
    camera.height_angle_deg = static_cast<float>(glm::degrees(ready.camera.fov_y));
    scene.camera = camera;
    for (const RenderPrimitive& part : ready.groups[ready.root].primitives) {
      const Affine& a = part.group_from_object;
      glm::mat4 matrix(a.linear);
      matrix[3] = glm::vec4(a.offset, 1);
      Node& node = scene.nodes[add_child(scene, scene.root)];
      node.transforms.push_back({Matrix(matrix), {}});
      Primitive& primitive = node.primitives.emplace_back();
      primitive.shape = part.shape;
      primitive.material = written(ready.materials[part.material]);
    }
    for (const RenderLight& light : ready.lights) {
      Light l;
      l.type = light.type;
      l.color = light.color;
      l.position = light.position;
      l.direction = light.direction;
      l.attenuation = light.attenuation;
      l.angle_deg = glm::degrees(light.outer_angle);
      l.penumbra_deg = glm::degrees(light.outer_angle - light.inner_angle);
      scene.nodes[scene.root].lights.push_back(l);
    }
    return scene;
  }

  /// The scene as the student's tracer draws it with these mistakes.
  Texture drawn_by_student(std::set<std::string, std::less<>> mistakes, int width = 96,
                           int height = 72) const {
    student::Job job;
    job.width = width;
    job.height = height;
    job.mistakes = std::move(mistakes);
    const std::string name = "ramp.png";
    return student::draw(written(), builder.assets, {&name, 1}, job);
  }

 private:
  Material written(const RenderMaterial& ready) const {
    Material m;
    m.ambient = ready.ambient;
    m.diffuse = ready.diffuse;
    m.specular = ready.specular;
    m.reflective = ready.reflective;
    m.shininess = ready.shininess;
    m.blend = ready.blend;
    if (ready.texture.used()) {
      m.texture = TextureUse{builder.scene.texture_files[ready.texture.file].name,
                             ready.texture.repeat_u,
                             ready.texture.repeat_v,
                             {}};
    }
    return m;
  }

  float uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(random_() % 10001) / 10000.0f;
  }

  glm::vec3 color(float low, float high) {
    const float r = uniform(low, high);
    const float g = uniform(low, high);
    return {r, g, uniform(low, high)};
  }

  // Different on all four sides: a ramp with a dark corner.
  std::uint32_t make_texture() {
    Texture t;
    t.width = t.height = 16;
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        const bool corner = x < 6 && y < 6;
        t.rgb.push_back(static_cast<std::uint8_t>(corner ? 20 : 60 + 12 * x));
        t.rgb.push_back(static_cast<std::uint8_t>(corner ? 30 : 240 - 10 * y));
        t.rgb.push_back(static_cast<std::uint8_t>(corner ? 90 : 100));
      }
    }
    builder.assets.textures.push_back(t);
    builder.scene.texture_files.push_back({"ramp.png", {}});
    return 0;
  }

  RenderMaterial plain() {
    RenderMaterial m;
    m.ambient = color(0.1f, 0.3f);
    m.diffuse = color(0.3f, 0.9f);
    m.specular = color(0.3f, 0.8f);
    m.shininess = uniform(6, 25);
    return m;
  }

  void add_room(std::uint32_t image) {
    using namespace trace_test;
    RenderMaterial floor = plain();
    floor.specular = glm::vec3(0.2f);
    floor.texture = {image, 2, 3};
    floor.reflective = color(0.2f, 0.4f);
    floor.blend = uniform(0.5f, 0.9f);
    builder.add(Shape::cube, translate({0, -1, 0}) * scale({7, 0.2f, 6}), builder.material(floor));
    builder.add(Shape::cube, translate({0, 1, -3}) * scale({7, 4, 0.2f}),
                builder.material(plain()));
  }

  void add_shapes(std::uint32_t image) {
    using namespace trace_test;
    const Shape shapes[] = {Shape::sphere, Shape::cylinder, Shape::cube, Shape::sphere,
                            Shape::sphere};
    int index = 0;
    for (const Shape shape : shapes) {
      RenderMaterial m = plain();
      if (index % 2 == 0) {
        m.reflective = color(0.4f, 0.8f);
      } else {
        m.texture = {image, 2, 2};
        m.blend = uniform(0.4f, 0.9f);
      }
      const float x = -2.2f + 1.1f * static_cast<float>(index);
      const Affine place = translate({x, uniform(-0.4f, 0.3f), uniform(-1, 1.2f)}) *
                           rotate(uniform(0, 90), color(0.1f, 1)) *
                           scale({uniform(0.6f, 0.9f), uniform(1.1f, 1.6f), uniform(0.6f, 1)});
      builder.add(shape, place, builder.material(m));
      ++index;
    }
  }

  void add_lights() {
    RenderLight& point = builder.light(
        LightType::point, {uniform(-3, -2), uniform(3, 4), uniform(2, 4)}, glm::vec3(0.9f));
    point.attenuation = {0.6f, uniform(0.08f, 0.15f), 0.01f};
    RenderLight& spot =
        builder.light(LightType::spot, {uniform(1, 2), 4, uniform(1, 3)}, color(0.5f, 0.9f));
    spot.direction = glm::normalize(glm::vec3(0.2f, 0, 0) - spot.position);
    spot.attenuation = {0.8f, 0.05f, 0};
    spot.outer_angle = glm::radians(uniform(24, 32));
    spot.inner_angle = spot.outer_angle - glm::radians(uniform(10, 16));
    builder.light(LightType::directional,
                  glm::normalize(glm::vec3(uniform(-0.5f, 0.5f), -1, -0.6f)), glm::vec3(0.25f));
  }

  std::mt19937 random_;
};

}  // namespace scenefile::grade_test
