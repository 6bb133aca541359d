#include "grade/student_renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile::grade_test {

namespace {

using glm::vec2;
using glm::vec3;

constexpr float far_away = std::numeric_limits<float>::infinity();

struct Crossing {
  float t = far_away;
  vec3 normal{0};  // of the object
  vec3 point{0};   // of the object
  const RenderPrimitive* part = nullptr;
};

void keep(Crossing& best, float t, float least, const vec3& point, const vec3& normal) {
  if (t > least && t < best.t) {
    best.t = t;
    best.point = point;
    best.normal = normal;
  }
}

void sphere(const vec3& o, const vec3& d, float least, Crossing& best) {
  const float a = glm::dot(d, d);
  const float b = 2 * glm::dot(o, d);
  const float c = glm::dot(o, o) - 0.25f;
  const float root = b * b - 4 * a * c;
  if (root >= 0) {
    for (const float sign : {-1.0f, 1.0f}) {
      const float t = (-b + sign * std::sqrt(root)) / (2 * a);
      keep(best, t, least, o + t * d, o + t * d);
    }
  }
}

void cube(const vec3& o, const vec3& d, float least, Crossing& best) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-0.5f, 0.5f}) {
      const float t = (side - o[axis]) / d[axis];
      const vec3 p = o + t * d;
      if (std::abs(p[(axis + 1) % 3]) <= 0.5f && std::abs(p[(axis + 2) % 3]) <= 0.5f) {
        vec3 normal(0);
        normal[axis] = 2 * side;
        keep(best, t, least, p, normal);
      }
    }
  }
}

void cylinder(const vec3& o, const vec3& d, float least, Crossing& best) {
  const float a = d.x * d.x + d.z * d.z;
  const float b = 2 * (o.x * d.x + o.z * d.z);
  const float c = o.x * o.x + o.z * o.z - 0.25f;
  const float root = b * b - 4 * a * c;
  for (const float sign : {-1.0f, 1.0f}) {
    const float t = (-b + sign * std::sqrt(std::max(root, 0.0f))) / (2 * a);
    const vec3 p = o + t * d;
    if (root >= 0 && std::abs(p.y) <= 0.5f) {
      keep(best, t, least, p, {p.x, 0, p.z});
    }
    const float cap = (0.5f * sign - o.y) / d.y;
    const vec3 q = o + cap * d;
    if (q.x * q.x + q.z * q.z <= 0.25f) {
      keep(best, cap, least, q, {0, sign, 0});
    }
  }
}

vec2 cube_uv(const vec3& p, const vec3& n) {
  if (n.x != 0) {
    return {0.5f - n.x * p.z, p.y + 0.5f};
  }
  if (n.z != 0) {
    return {0.5f + n.z * p.x, p.y + 0.5f};
  }
  return {p.x + 0.5f, 0.5f - n.y * p.z};
}

vec2 round_uv(const vec3& p, bool is_sphere, const vec3& n) {
  if (!is_sphere && n.y != 0) {
    return {p.x + 0.5f, 0.5f - n.y * p.z};
  }
  const float angle = std::atan2(p.z, p.x) / 6.28318531f;
  const float v = is_sphere ? std::asin(std::clamp(p.y / 0.5f, -1.0f, 1.0f)) / 3.14159265f : p.y;
  return {angle < 0 ? -angle : 1 - angle, v + 0.5f};
}

class Student {
 public:
  Student(const RenderScene& scene, const Assets& assets, const Plan& plan)
      : scene_(scene), assets_(assets), plan_(plan) {
    for (const RenderPrimitive& part : scene.groups[scene.root].primitives) {
      inverses_.push_back(glm::inverse(part.group_from_object.linear));
    }
  }

  vec3 pixel(int x, int y) const {
    const RenderCamera& camera = scene_.camera;
    const float tangent = std::tan(static_cast<float>(camera.fov_y) / 2);
    const float aspect = static_cast<float>(plan_.width) / static_cast<float>(plan_.height);
    const float across =
        2 * (static_cast<float>(x) + plan_.pixel_x) / static_cast<float>(plan_.width) - 1;
    const float up =
        1 - 2 * (static_cast<float>(y) + plan_.pixel_y) / static_cast<float>(plan_.height);
    const vec3 direction =
        across * tangent * aspect * vec3(camera.u) + up * tangent * vec3(camera.v) - vec3(camera.w);
    return trace(vec3(camera.position), glm::normalize(direction), 0, 0);
  }

 private:
  Crossing closest(const vec3& from, const vec3& direction, float least) const {
    Crossing best;
    const auto& parts = scene_.groups[scene_.root].primitives;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const vec3 o = inverses_[i] * (from - parts[i].group_from_object.offset);
      const vec3 d = inverses_[i] * direction;
      const float before = best.t;
      switch (parts[i].shape) {
        case Shape::sphere:
          sphere(o, d, least, best);
          break;
        case Shape::cylinder:
          cylinder(o, d, least, best);
          break;
        default:
          cube(o, d, least, best);
      }
      if (best.t < before) {
        best.part = &parts[i];
      }
    }
    return best;
  }

  vec3 texture_color(const RenderMaterial& m, const Crossing& c) const {
    const Texture& texture = assets_.textures[m.texture.file];
    const vec2 uv = c.part->shape == Shape::cube
                        ? cube_uv(c.point, c.normal)
                        : round_uv(c.point, c.part->shape == Shape::sphere, c.normal);
    const float u = uv.x * (plan_.repeat ? m.texture.repeat_u : 1);
    const float v = (plan_.texture_up ? uv.y : 1 - uv.y) * (plan_.repeat ? m.texture.repeat_v : 1);
    const auto index = [](float at, int size) {
      const int i = static_cast<int>(std::floor(at * static_cast<float>(size))) % size;
      return i < 0 ? i + size : i;
    };
    const std::uint8_t* p = texture.texel(index(u, texture.width), index(v, texture.height));
    return vec3(p[0], p[1], p[2]) / 255.0f;
  }

  float spot(const RenderLight& light, const vec3& to_light) const {
    const float angle = std::acos(std::clamp(glm::dot(-to_light, light.direction), -1.0f, 1.0f));
    float inner = light.inner_angle;
    float outer = light.outer_angle;
    if (plan_.spot == Plan::Spot::none) {
      return 1;
    }
    if (plan_.spot == Plan::Spot::hard) {
      return angle <= outer ? 1.0f : 0.0f;
    }
    if (plan_.spot == Plan::Spot::outside) {
      outer = 2 * outer - inner;
      inner = light.outer_angle;
    }
    const float x = std::clamp((angle - inner) / (outer - inner), 0.0f, 1.0f);
    return plan_.spot == Plan::Spot::linear ? 1 - x : 1 - x * x * (3 - 2 * x);
  }

  vec3 lit(const RenderLight& light, const vec3& point, const vec3& normal, const vec3& eye,
           const RenderMaterial& m, const vec3& base) const {
    vec3 to_light = -light.direction;
    float distance = far_away;
    float strength = 1;
    if (light.type != LightType::directional) {
      distance = glm::length(light.position - point);
      to_light = (light.position - point) / distance;
      const vec3& c = light.attenuation;
      strength = plan_.attenuation
                     ? std::min(1.0f, 1 / (c.x + c.y * distance + c.z * distance * distance))
                     : 1;
    }
    if (light.type == LightType::spot) {
      strength *= spot(light, to_light);
    }
    if (strength <= 0 ||
        (plan_.shadows && closest(point, to_light, plan_.offset ? 1e-3f : 0).t < distance)) {
      return vec3(0);
    }
    const float cosine = glm::dot(normal, to_light);
    const float shine = plan_.blinn ? glm::dot(normal, glm::normalize(to_light + eye))
                                    : glm::dot(2 * cosine * normal - to_light, eye);
    vec3 color = plan_.diffuse * base * std::max(cosine, 0.0f);
    if (shine > 0 && m.shininess > 0) {
      color += plan_.specular * scene_.global.specular * m.specular * std::pow(shine, m.shininess);
    }
    return strength * light.color * color;
  }

  vec3 trace(const vec3& from, const vec3& direction, float least, int depth) const {
    const Crossing c = closest(from, direction, least);
    if (c.part == nullptr) {
      return vec3(0);
    }
    const RenderMaterial& m = scene_.materials[c.part->material];
    const glm::mat3& linear = c.part->group_from_object.linear;
    const vec3 normal =
        glm::normalize(plan_.inverse_transpose ? glm::transpose(glm::inverse(linear)) * c.normal
                                               : linear * c.normal);
    const vec3 point = from + c.t * direction;
    vec3 base = scene_.global.diffuse * m.diffuse;
    if (m.texture.used()) {
      base = glm::mix(base, texture_color(m, c), m.blend);
    }
    vec3 color = plan_.ambient * scene_.global.ambient * m.ambient;
    for (const RenderLight& light : scene_.lights) {
      color += lit(light, point, normal, -direction, m, base);
    }
    if (m.reflective != vec3(0) && depth < plan_.depth) {
      const vec3 mirrored = glm::reflect(direction, normal);
      color += scene_.global.specular * m.reflective *
               trace(point, mirrored, plan_.offset ? 1e-3f : 0, depth + 1);
    }
    return glm::clamp(color, vec3(0), vec3(1));
  }

  const RenderScene& scene_;
  const Assets& assets_;
  const Plan& plan_;
  std::vector<glm::mat3> inverses_;
};

}  // namespace

Texture draw(const RenderScene& scene, const Assets& assets, const Plan& plan) {
  const Student student(scene, assets, plan);
  Image image(plan.width, plan.height);
  for (int y = 0; y < plan.height; ++y) {
    for (int x = 0; x < plan.width; ++x) {
      const vec3 color = student.pixel(x, y);
      for (int c = 0; c < 3; ++c) {
        image.pixel(x, y)[c] = color[c];
      }
    }
  }
  return quantize(image, plan.round ? Rounding::nearest : Rounding::truncate);
}

}  // namespace scenefile::grade_test
