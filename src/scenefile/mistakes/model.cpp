#include "scenefile/mistakes/model.h"

#include "scenefile/base/shape_traits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace scenefile {

double Curve::at(double x) const {
  const auto above = std::lower_bound(knots.begin(), knots.end(), x);
  if (above == knots.begin()) {
    return values.front();
  }
  if (above == knots.end()) {
    return values.back();
  }
  const auto k = static_cast<std::size_t>(above - knots.begin());
  return values[k - 1] +
         (values[k] - values[k - 1]) * (x - knots[k - 1]) / (knots[k] - knots[k - 1]);
}

namespace {

using glm::dvec2;
using glm::dvec3;

using std::numbers::pi;
constexpr std::uint32_t area_side = 3;

dvec3 unit(const dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : dvec3(0, 1, 0);
}

}  // namespace

dvec3 transformed_normal(const ModelPart& part, const dvec3& normal, NormalMistake mistake) {
  const glm::dmat3& matrix = part.world_from_object.linear;
  const glm::dmat3& inverse = part.object_from_world.linear;
  const dvec3 right = glm::transpose(inverse) * normal;
  switch (mistake) {
    case NormalMistake::by_matrix:
    case NormalMistake::matrix_not_normalized:
      return matrix * normal;
    case NormalMistake::by_inverse:
      return inverse * normal;
    case NormalMistake::by_transpose:
      return glm::transpose(matrix) * normal;
    case NormalMistake::of_object:
      return normal;
    case NormalMistake::translated:
      return part.world_from_object.point(normal);
    case NormalMistake::inverse_translated:
      return part.object_from_world.point(normal);
    case NormalMistake::right_translated:
      return right + part.world_from_object.offset;
    case NormalMistake::four_normalized:
    case NormalMistake::four_normalized_w1: {
      const double w = glm::dot(part.object_from_world.offset, normal) +
                       (mistake == NormalMistake::four_normalized_w1 ? 1 : 0);
      return right / std::sqrt(glm::dot(right, right) + w * w);
    }
    case NormalMistake::inverted:
      return -right;
    case NormalMistake::absolute:
      return glm::abs(right);
    case NormalMistake::none:
    case NormalMistake::toward_eye:
    case NormalMistake::not_normalized:
    case NormalMistake::raw_not_normalized:
    case NormalMistake::gradient_not_normalized:
    case NormalMistake::cone_gradient_not_normalized:
      break;
  }
  return right;
}

bool keeps_length(NormalMistake mistake) {
  return mistake == NormalMistake::not_normalized || mistake == NormalMistake::raw_not_normalized ||
         mistake == NormalMistake::gradient_not_normalized ||
         mistake == NormalMistake::cone_gradient_not_normalized ||
         mistake == NormalMistake::matrix_not_normalized ||
         mistake == NormalMistake::four_normalized || mistake == NormalMistake::four_normalized_w1;
}

struct Model::Surface {
  ModelHit hit;
  const RenderMaterial* material = nullptr;
  dvec3 position{0};
  dvec3 object_point{0};
  dvec3 object_normal{0};
  dvec3 normal{0};
  dvec3 geometric{0};  // unit length, correct
  dvec3 direction{0};  // of the ray
  dvec3 eye{0};        // position of the camera
  dvec2 uv{0};
};

// What a mistake does with the texture, other than to replace the diffuse color.
struct Model::TextureUse {
  bool unlit = false;
  dvec3 over{0};  // to blend with the finished lighting
  double share_over = 0;
  dvec3 times{1};  // to multiply the finished lighting by
  dvec3 times_specular{1};
  dvec3 color{1};    // of the texture
  double blend = 0;  // 0: no texture is used
};

struct Model::Arrival {
  dvec3 to_light{0};  // as used for shading
  dvec3 toward{0};    // unit vector to the light
  double distance = 0;
  double factor = 1;  // attenuation and spot
  double specular_factor = 1;
};

Model::Model(const RenderScene& scene, const ModelShapes& shapes, const Assets& assets,
             const RenderOptions& options, const ModelMistakes& mistakes)
    : scene_(scene),
      shapes_(shapes),
      assets_(assets),
      options_(options),
      m_(mistakes),
      film_(2 * std::tan(scene.camera.fov_y / 2)) {}

ModelRay Model::camera_ray(const dvec2& place, double width, double height) const {
  const RenderCamera& c = scene_.camera;
  const double spread = film_ / height;
  const dvec3 on_film =
      spread * (place.x - width / 2) * c.u - spread * (place.y - height / 2) * c.v;
  if (m_.orthographic > 0) {
    return {c.position + m_.orthographic * on_film, unit(-c.w)};
  }
  const dvec3 direction = on_film - c.w;
  return {c.position, unit(direction)};
}

ModelHit Model::first_hit(const ModelRay& ray) const {
  ModelHit hit;
  return search(ray, 0, infinity, false, nullptr, hit) ? hit : ModelHit();
}

dvec3 Model::color(const ModelRay& ray, const ModelHit* known) const {
  dvec3 color = trace(ray, 0, known, 0, dvec3(1));
  for (int channel = 0; channel < 3; ++channel) {
    if (std::isnan(color[channel])) {
      color[channel] = m_.attenuation == AttenuationMistake::infinite_white ? 1 : 0;
    }
  }
  return color;
}

dvec3 Model::pixel(const dvec2& place, double width, double height, const ModelHit* known,
                   const Sample& sample) const {
  const ModelRay ray = camera_ray(place, width, height);
  const RenderCamera& c = scene_.camera;
  if (!options_.features.depthoffield || !(c.aperture > 0) || !(c.focal_length > 0)) {
    return color(ray, known);
  }
  static constexpr std::array<std::array<double, 2>, 8> lens{
      {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {-0.5, 0}, {0.5, 0}, {0, -0.5}, {0, 0.5}}};
  const dvec3 focus = c.position + ray.direction * (c.focal_length / -glm::dot(ray.direction, c.w));
  const std::size_t step = std::min<std::size_t>(lens.size(), sample.count);
  dvec3 sum(0);
  double count = 0;
  for (std::size_t i = sample.index % step; i < lens.size(); i += step) {
    const dvec3 from = c.position + c.aperture * (lens[i][0] * c.u + lens[i][1] * c.v);
    sum += clamped(color({from, unit(focus - from)}));
    ++count;
  }
  return sum / count;
}

namespace {

// The angle around the y axis, as u.
double around(const dvec3& p) {
  const double u = std::atan2(p.z, p.x) / (2 * pi);
  return u < 0 ? -u : 1 - u;
}

dvec2 flat_uv(int axis, bool low, const dvec3& p) {
  switch (axis) {
    case 0:
      return {0.5 + (low ? p.z : -p.z), p.y + 0.5};
    case 1:
      return {p.x + 0.5, 0.5 + (low ? p.z : -p.z)};
    default:
      return {0.5 + (low ? -p.x : p.x), p.y + 0.5};
  }
}

dvec2 shape_uv(Shape shape, int face, const dvec3& p, UvMistake mistake) {
  dvec2 uv(0);
  bool flat = false;
  bool cap = false;
  switch (shape) {
    case Shape::cube:
      uv = flat_uv((face - 1) / 2, (face - 1) % 2 == 1, p);
      if (mistake == UvMistake::cube_same_faces) {
        uv = flat_uv((face - 1) / 2, (face - 1) / 2 == 0, p);
      } else if (mistake == UvMistake::cube_front) {
        uv = {p.x + 0.5, p.y + 0.5};
      }
      flat = true;
      break;
    case Shape::sphere:
      if (mistake == UvMistake::sphere_planar) {
        return {p.x + 0.5, p.y + 0.5};
      }
      uv = {around(p), mistake == UvMistake::sphere_linear_v
                           ? p.y + 0.5
                           : std::asin(std::clamp(2 * p.y, -1.0, 1.0)) / pi + 0.5};
      break;
    case Shape::cylinder:
    case Shape::cone:
      if (face == 0 && mistake == UvMistake::sides_like_sphere) {
        return {around(p), std::asin(std::clamp(2 * p.y, -1.0, 1.0)) / pi + 0.5};
      }
      cap = face != 0;
      flat = cap && mistake != UvMistake::caps_as_side && mistake != UvMistake::caps_polar;
      // Beyond the ends, where only shapes without ends continue, textures repeat.
      uv = flat ? flat_uv(1, face == 2, p)
                : dvec2(around(p),
                        std::abs(p.y) < 0.5 + 1e-6 ? std::clamp(p.y + 0.5, 0.0, 1.0) : p.y + 0.5);
      break;
    case Shape::mesh:
      break;
  }
  switch (mistake) {
    case UvMistake::flip_u:
      uv.x = 1 - uv.x;
      break;
    case UvMistake::flip_v:
      uv.y = 1 - uv.y;
      break;
    case UvMistake::flip_both:
      uv = 1.0 - uv;
      break;
    case UvMistake::shift_u:
      uv.x += uv.x < 0.5 ? 0.5 : -0.5;
      break;
    case UvMistake::shift_v:
      uv.y += uv.y < 0.5 ? 0.5 : -0.5;
      break;
    case UvMistake::cube_ends_flip_v:
      uv.y = shape == Shape::cube && (face - 1) / 2 == 1 ? 1 - uv.y : uv.y;
      break;
    case UvMistake::quarter:
    case UvMistake::half:
    case UvMistake::three_quarters:
      if (!flat) {
        uv.x += mistake == UvMistake::quarter ? 0.25 : mistake == UvMistake::half ? 0.5 : 0.75;
        uv.x -= std::floor(uv.x);
      }
      break;
    case UvMistake::round_flip_u:
      uv.x = flat ? uv.x : 1 - uv.x;
      break;
    case UvMistake::round_flip_quarter:
    case UvMistake::round_flip_half:
    case UvMistake::round_flip_three_quarters:
      if (!flat) {
        uv.x = (mistake == UvMistake::round_flip_quarter ? 0.25
                : mistake == UvMistake::round_flip_half  ? 0.5
                                                         : 0.75) -
               uv.x;
        uv.x -= std::floor(uv.x);
      }
      break;
    case UvMistake::sphere_flip_v:
      uv.y = shape == Shape::sphere ? 1 - uv.y : uv.y;
      break;
    case UvMistake::caps_flip_v:
      uv.y = cap ? 1 - uv.y : uv.y;
      break;
    case UvMistake::caps_polar:
      uv.y = cap ? 2 * std::hypot(p.x, p.z) : uv.y;
      break;
    case UvMistake::flat_flip_u:
      uv.x = flat ? 1 - uv.x : uv.x;
      break;
    case UvMistake::flat_flip_v:
      uv.y = flat ? 1 - uv.y : uv.y;
      break;
    case UvMistake::none:
    case UvMistake::sides_like_sphere:
    case UvMistake::sphere_linear_v:
    case UvMistake::sphere_planar:
    case UvMistake::cube_same_faces:
    case UvMistake::cube_front:
    case UvMistake::caps_as_side:
    case UvMistake::sphere_missing:
    case UvMistake::cube_missing:
    case UvMistake::cylinder_missing:
    case UvMistake::cone_missing:
    case UvMistake::caps_missing:
      break;
  }
  return uv;
}

bool texture_missing_on(Shape shape, int face, UvMistake mistake) {
  return (mistake == UvMistake::sphere_missing && shape == Shape::sphere) ||
         (mistake == UvMistake::cube_missing && shape == Shape::cube) ||
         (mistake == UvMistake::cylinder_missing && shape == Shape::cylinder) ||
         (mistake == UvMistake::cone_missing && shape == Shape::cone) ||
         (mistake == UvMistake::caps_missing && face != 0 &&
          (shape == Shape::cylinder || shape == Shape::cone));
}

}  // namespace

dvec3 shape_normal(Shape shape, int face, const dvec3& p, ConeNormalMistake cone, bool caps_down,
                   ShapeMistake mistake) {
  if (mistake == ShapeMistake::like_sphere && shape != Shape::mesh) {
    return 2.0 * p;
  }
  switch (shape) {
    case Shape::cube: {
      dvec3 n(0);
      const bool low = (face - 1) % 2 == 1 && mistake != ShapeMistake::cube_normals_positive;
      n[(face - 1) / 2] = low ? -1 : 1;
      return mistake == ShapeMistake::cube_normals_like_sphere ? 2.0 * p
             : mistake == ShapeMistake::cube_normals_inward    ? -n
                                                               : n;
    }
    case Shape::sphere:
      return (mistake == ShapeMistake::sphere_normals_inward ? -2.0 : 2.0) * p;
    case Shape::cylinder:
    case Shape::cone:
      break;
    case Shape::mesh:
      return {0, 1, 0};
  }
  if (face != 0 && mistake != ShapeMistake::cap_normals_like_side) {
    const bool up = face == 1 || mistake == ShapeMistake::cap_normals_up;
    return {0, up == !caps_down ? 1 : -1, 0};
  }
  const bool inward = mistake == ShapeMistake::side_normals_inward ||
                      mistake == (shape == Shape::cylinder ? ShapeMistake::cylinder_normals_inward
                                                           : ShapeMistake::cone_normals_inward);
  const double sign = inward ? -1 : 1;
  if (shape == Shape::cylinder) {
    return sign * dvec3(2 * p.x, mistake == ShapeMistake::cylinder_normal_like_sphere ? 2 * p.y : 0,
                        2 * p.z);
  }
  const double slope = 0.25 * (1 - 2 * p.y);
  switch (cone) {
    case ConeNormalMistake::level:
      return {2 * p.x, 0, 2 * p.z};
    case ConeNormalMistake::like_sphere:
      return 2.0 * p;
    case ConeNormalMistake::half_slope:
      return {2 * p.x, slope / 2, 2 * p.z};
    case ConeNormalMistake::double_slope:
      return {2 * p.x, 2 * slope, 2 * p.z};
    case ConeNormalMistake::four_slopes:
      return {2 * p.x, 4 * slope, 2 * p.z};
    case ConeNormalMistake::slope_down:
      return {2 * p.x, -slope, 2 * p.z};
    case ConeNormalMistake::constant_y:
      return {p.x, 0.5, p.z};
    case ConeNormalMistake::half_constant_y:
      return {p.x, 0.25, p.z};
    case ConeNormalMistake::from_apex:
      return {p.x, p.y - 0.5, p.z};
    case ConeNormalMistake::none:
      break;
  }
  return sign * dvec3(2 * p.x, slope, 2 * p.z);
}

namespace {

dvec3 to_world(const ModelPart& part, const dvec3& raw, bool flat, NormalMistake mistake) {
  // Programs that normalize nothing use points, half as long as gradients, or gradients.
  const bool cone_gradient = mistake == NormalMistake::cone_gradient_not_normalized;
  const bool points = mistake == NormalMistake::raw_not_normalized || cone_gradient;
  const bool as_it_is = mistake == NormalMistake::gradient_not_normalized || (points && flat) ||
                        (cone_gradient && part.shape == Shape::cone);
  const dvec3 n = as_it_is ? raw : points ? 0.5 * raw : unit(raw);
  const dvec3 moved = transformed_normal(part, n, mistake);
  return keeps_length(mistake) ? moved : unit(moved);
}

}  // namespace

Model::Surface Model::surface(const ModelRay& ray, const ModelHit& hit) const {
  Surface s;
  s.hit = hit;
  const ModelPart& part = *hit.part;
  s.material = &scene_.materials[part.material];
  const dvec3 met = ray.origin + hit.t * ray.direction;
  s.position = hit.stretch == 1 ? met : ray.origin + hit.stretch * hit.t * ray.direction;
  s.direction = ray.direction;
  s.eye = scene_.camera.position;
  s.object_point = part.object_from_world.point(met);
  if (m_.directions == DirectionMistake::translated) {
    s.object_point += hit.t * part.object_from_world.offset;
  } else if (m_.directions == DirectionMistake::of_world) {
    s.object_point = part.object_from_world.point(ray.origin) + hit.t * ray.direction;
  }
  if (part.shape == Shape::mesh) {
    const bool smooth = options_.profile != Profile::course;
    const auto at = surface_at(assets_.meshes[part.mesh], hit.triangle, hit.b1, hit.b2, smooth);
    s.object_normal = unit(at.normal);
    s.uv = at.uv;
    s.normal = to_world(part, s.object_normal, true, m_.normals);
    s.geometric = to_world(part, s.object_normal, true, NormalMistake::none);
  } else {
    s.object_normal = shape_normal(part.shape, hit.face, s.object_point, m_.cone_normal,
                                   m_.cap_normals_down, m_.shape);
    s.uv = shape_uv(part.shape, hit.face, s.object_point, m_.uv);
    const bool flat = hit.face != 0;
    const bool by_matrix =
        part.shape == Shape::sphere && m_.shape == ShapeMistake::sphere_normals_by_matrix;
    s.normal =
        to_world(part, s.object_normal, flat, by_matrix ? NormalMistake::by_matrix : m_.normals);
    s.geometric = to_world(part,
                           shape_normal(part.shape, hit.face, s.object_point,
                                        ConeNormalMistake::none, false, ShapeMistake::none),
                           flat, NormalMistake::none);
  }
  if (m_.normals == NormalMistake::toward_eye && glm::dot(s.normal, ray.direction) > 0) {
    s.normal = -s.normal;
  }
  if (m_.object_points) {
    s.position = s.object_point;
  }
  return s;
}

namespace {

dvec3 texel(const Texture& texture, double x, double y, bool wraps) {
  const auto index = [&](double at, int size) {
    const double whole = std::floor(at);
    const double i = wraps ? whole - size * std::floor(whole / size) : whole;
    return static_cast<int>(std::clamp(i, 0.0, size - 1.0));
  };
  const std::uint8_t* p = texture.texel(index(x, texture.width), index(y, texture.height));
  return dvec3(p[0], p[1], p[2]) / 255.0;
}

// Like a mirror at each whole number.
double mirrored_repeat(double x) {
  const double rest = std::abs(x) - 2 * std::floor(std::abs(x) / 2);
  return rest > 1 ? 2 - rest : rest;
}

dvec3 lookup(const Texture& texture, double x, double y, bool filtered, bool wraps) {
  if (!filtered) {
    return texel(texture, x, y, wraps);
  }
  const double fx = x - std::floor(x);
  const double fy = y - std::floor(y);
  const dvec3 top = glm::mix(texel(texture, x, y, wraps), texel(texture, x + 1, y, wraps), fx);
  const dvec3 low =
      glm::mix(texel(texture, x, y + 1, wraps), texel(texture, x + 1, y + 1, wraps), fx);
  return glm::mix(top, low, fy);
}

}  // namespace

dvec3 Model::texture_or_plain(const Surface& s, int depth, TextureUse& use) const {
  const RenderMaterial& material = *s.material;
  dvec3 color(material.diffuse);
  switch (m_.diffuse) {
    case DiffuseMistake::no_color:
      color = dvec3(1);
      break;
    case DiffuseMistake::color_of_ambient:
      color = dvec3(material.ambient);
      break;
    case DiffuseMistake::color_of_specular:
      color = dvec3(material.specular);
      break;
    default:
      break;
  }
  const double kd = m_.diffuse == DiffuseMistake::no_coefficient ? 1 : scene_.global.diffuse;
  const dvec3 plain = kd * color;
  if (options_.mode != Mode::ray || !options_.features.texture || !material.texture.used() ||
      material.blend == 0 || assets_.textures[material.texture.file].empty() ||
      texture_missing_on(s.hit.part->shape, s.hit.face, m_.uv) ||
      (depth > 0 && m_.mirror == MirrorMistake::no_textures)) {
    return plain;
  }
  const Texture& texture = assets_.textures[material.texture.file];
  const bool divided = m_.texture == TextureMistake::divided_repeat;
  double u = divided ? s.uv.x / material.texture.repeat_u : s.uv.x * material.texture.repeat_u;
  double v =
      divided ? (1 - s.uv.y) / material.texture.repeat_v : (1 - s.uv.y) * material.texture.repeat_v;
  if (m_.texture == TextureMistake::swapped_uv) {
    u = s.uv.y * material.texture.repeat_u;
    v = (1 - s.uv.x) * material.texture.repeat_v;
  }
  if (m_.texture == TextureMistake::mirrored_repeat) {
    u = mirrored_repeat(u);
    v = mirrored_repeat(v);
  }
  const bool centered = m_.texture == TextureMistake::filtered_centered;
  const bool filtered =
      (options_.features.texture_filter || centered || m_.texture == TextureMistake::filtered) &&
      m_.texture != TextureMistake::not_filtered;
  const double off = centered ? 0.5 : m_.texture == TextureMistake::to_nearest ? -0.5 : 0;
  const int less = m_.texture == TextureMistake::size_less_one ? 1 : 0;
  dvec3 t = lookup(texture, u * (texture.width - less) - off, v * (texture.height - less) - off,
                   filtered, m_.texture != TextureMistake::lookup_clamped);
  const double blend = material.blend;
  use.color = t;
  use.blend = blend;
  switch (m_.texture) {
    case TextureMistake::blend_ignored:
      return t;
    case TextureMistake::times_coefficient:
      return glm::mix(plain, kd * t, blend);
    case TextureMistake::times_coefficient_no_blend:
      return kd * t;
    case TextureMistake::times_diffuse:
      return glm::mix(plain, plain * t, blend);
    case TextureMistake::times_diffuse_no_blend:
      return plain * t;
    case TextureMistake::blend_reversed:
      return glm::mix(t, plain, blend);
    case TextureMistake::added:
      return plain + blend * t;
    case TextureMistake::averaged:
      return glm::mix(plain, t, 0.5);
    case TextureMistake::unlit:
      use.unlit = true;
      break;
    case TextureMistake::times_lighting:
      use.times = t;
      return plain;
    case TextureMistake::times_lighting_too:
      use.times = t;
      break;
    case TextureMistake::specular_too:
      use.times_specular = t;
      break;
    case TextureMistake::over_lighting:
    case TextureMistake::over_all:
      use.over = t;
      use.share_over = blend;
      return plain;
    case TextureMistake::over_lighting_too:
    case TextureMistake::over_all_too:
      use.over = t;
      use.share_over = blend;
      break;
    case TextureMistake::blue_red:
      std::swap(t.x, t.z);
      break;
    case TextureMistake::integer_division:
      t = glm::floor(t);
      break;
    case TextureMistake::bytes:
      t *= 255.0;
      break;
    case TextureMistake::gray:
      t = dvec3((t.x + t.y + t.z) / 3);
      break;
    case TextureMistake::blend_drops_color:
      return blend * t;
    case TextureMistake::decoded:
      t = glm::pow(t, dvec3(2.2));
      break;
    case TextureMistake::white_rest:
      return glm::mix(dvec3(kd), t, blend);
    case TextureMistake::no_coefficient_on_rest:
      return glm::mix(color, t, blend);
    case TextureMistake::none:
    case TextureMistake::filtered:
    case TextureMistake::filtered_centered:
    case TextureMistake::not_filtered:
    case TextureMistake::lookup_clamped:
    case TextureMistake::divided_repeat:
    case TextureMistake::swapped_uv:
    case TextureMistake::ambient_too:
    case TextureMistake::mirrored_repeat:
    case TextureMistake::size_less_one:
    case TextureMistake::to_nearest:
      break;
  }
  return glm::mix(plain, t, blend);
}

bool Model::counts(const RenderLight& light) const {
  const bool only_intersect =
      options_.mode == Mode::intersect && options_.profile == Profile::course && !m_.all_lights;
  return !only_intersect || is_in_intersect(light.type);
}

double Model::transparency() const {
  return scene_.global.transparent.value_or(options_.profile == Profile::course ? 0.0f : 0.5f);
}

namespace {

double smooth(double t) {
  return t * t * (3 - 2 * t);
}

}  // namespace

double faded(const glm::vec3& coefficients, double d, AttenuationMistake mistake) {
  const glm::dvec3 c(coefficients);
  const double right = c.x + d * (c.y + d * c.z);
  const auto limited = [](double x) { return x > 1 ? 1 / x : 1.0; };
  switch (mistake) {
    case AttenuationMistake::absent:
      return 1;
    case AttenuationMistake::inverse_square:
      return limited(d * d);
    case AttenuationMistake::inverse:
      return limited(d);
    case AttenuationMistake::inverse_square_unlimited:
      return 1 / std::max(d * d, 1e-9);
    case AttenuationMistake::inverse_unlimited:
      return 1 / std::max(d, 1e-9);
    case AttenuationMistake::one_plus_square:
      return 1 / (1 + d * d);
    case AttenuationMistake::no_quadratic:
      return limited(c.x + d * c.y);
    case AttenuationMistake::no_linear:
      return limited(c.x + d * d * c.z);
    case AttenuationMistake::no_constant:
      return limited(d * (c.y + d * c.z));
    case AttenuationMistake::not_clamped:
      return 1 / std::max(right, 1e-9);
    case AttenuationMistake::squared:
      return limited(right) * limited(right);
    case AttenuationMistake::reversed_coefficients:
      return limited(c.z + d * (c.y + d * c.x));
    case AttenuationMistake::multiplied:
      return right;
    case AttenuationMistake::one_plus:
      return limited(1 + right);
    case AttenuationMistake::squared_distance:
      return limited(c.x + d * d * (c.y + d * d * c.z));
    case AttenuationMistake::infinite_white:
    case AttenuationMistake::infinite_black:
      return 1 / right;
    case AttenuationMistake::clamped_below:
      return std::max(1.0, 1 / std::max(right, 1e-9));
    case AttenuationMistake::none:
    case AttenuationMistake::eye_to_point:
    case AttenuationMistake::from_origin:
    case AttenuationMistake::spots_only:
    case AttenuationMistake::points_only:
    case AttenuationMistake::to_eye:
    case AttenuationMistake::diffuse_only:
    case AttenuationMistake::specular_only:
    case AttenuationMistake::specular_only_with_cone:
    case AttenuationMistake::diffuse_only_with_cone:
      break;
  }
  return limited(right);
}

double spot_share(const RenderLight& light, double cosine, SpotMistake mistake) {
  if (mistake == SpotMistake::reversed_axis) {
    cosine = -cosine;
  }
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double inner = light.inner_angle;
  const double outer = light.outer_angle;
  double t = (angle - inner) / (outer - inner);
  if (mistake == SpotMistake::in_cosine || mistake == SpotMistake::linear_in_cosine) {
    t = (std::cos(inner) - cosine) / (std::cos(inner) - std::cos(outer));
  }
  double falling = 1 - smooth(t);
  const bool outside = angle > outer;
  const bool inside = angle <= inner;
  switch (mistake) {
    case SpotMistake::linear:
    case SpotMistake::linear_in_cosine:
      falling = 1 - t;
      break;
    case SpotMistake::inverted:
      return inside ? 0 : outside ? 1 : smooth(t);
    case SpotMistake::penumbra_inverted:
      falling = smooth(t);
      break;
    case SpotMistake::no_limit:
      return inside ? 1 : outside ? std::abs(falling) : falling;
    case SpotMistake::squared:
      falling *= falling;
      break;
    case SpotMistake::quadratic:
      falling = (1 - t) * (1 - t);
      break;
    case SpotMistake::one_minus_square:
      falling = 1 - t * t;
      break;
    case SpotMistake::cosine_power:
      return outside || cosine <= 0 ? 0 : cosine;
    case SpotMistake::inner_only_penumbra:
      return inside ? 1 : 0;
    case SpotMistake::none:
    case SpotMistake::in_cosine:
    case SpotMistake::reversed_axis:
      break;
  }
  return inside ? 1 : outside ? 0 : falling;
}

namespace {

template <typename Key>
const Curve* curve_of(const std::vector<std::pair<Key, Curve>>& curves, const Key& key) {
  const auto found =
      std::find_if(curves.begin(), curves.end(), [&](const auto& one) { return one.first == key; });
  return found == curves.end() ? nullptr : &found->second;
}

}  // namespace

double Model::written_length(const RenderLight& light) const {
  const auto index = static_cast<std::size_t>(&light - scene_.lights.data());
  return index < m_.light_lengths.size() ? m_.light_lengths[index] : 1;
}

bool Model::arrival(const RenderLight& light, const Surface& s, const dvec2& on_light,
                    Arrival& arriving) const {
  const LightVectorMistake mistake = m_.light_vector;
  if (!has_position(light.type)) {
    arriving.toward = -dvec3(light.direction);
    if (mistake == LightVectorMistake::position_as_direction) {
      arriving.toward = unit(-dvec3(light.position));
    }
    const bool reversed = mistake == LightVectorMistake::reversed ||
                          mistake == LightVectorMistake::reversed_directional ||
                          mistake == LightVectorMistake::reversed_shading ||
                          mistake == LightVectorMistake::reversed_directional_shading;
    arriving.to_light = reversed ? -arriving.toward : arriving.toward;
    if (mistake == LightVectorMistake::directional_as_long_as_written ||
        mistake == LightVectorMistake::as_long_as_written) {
      arriving.to_light *= written_length(light);
    }
    arriving.distance = infinity;
    return true;
  }
  dvec3 from(light.position);
  if (has_rectangle(light.type)) {
    from += (2 * on_light.x - 1) * dvec3(light.half_u) + (2 * on_light.y - 1) * dvec3(light.half_v);
  }
  const dvec3 way =
      from - (mistake == LightVectorMistake::from_object_point_all ? s.object_point : s.position);
  arriving.distance = glm::length(way);
  if (!(arriving.distance > 0)) {
    return false;
  }
  arriving.toward = mistake == LightVectorMistake::to_origin_all ? unit(from)
                    : mistake == LightVectorMistake::sum_all     ? unit(from + s.position)
                                                                 : way / arriving.distance;
  const double cosine = -glm::dot(arriving.toward, dvec3(light.direction));
  if (has_rectangle(light.type) && cosine <= 0) {
    return false;
  }
  double along_light = arriving.distance;
  if (m_.attenuation == AttenuationMistake::to_eye) {
    along_light = glm::length(from - s.eye);
  } else if (m_.attenuation == AttenuationMistake::eye_to_point) {
    along_light = glm::length(s.position - s.eye);
  } else if (m_.attenuation == AttenuationMistake::from_origin) {
    along_light = glm::length(from);
  }
  const bool not_faded = m_.attenuation == (has_cone(light.type) ? AttenuationMistake::points_only
                                                                 : AttenuationMistake::spots_only);
  const Curve* const other_fading =
      has_position(light.type) ? curve_of(m_.fading, light.attenuation) : nullptr;
  const double fading = other_fading != nullptr ? other_fading->at(arriving.distance)
                        : not_faded             ? 1
                                    : faded(light.attenuation, along_light, m_.attenuation);
  const bool as_written = mistake == LightVectorMistake::spot_as_long_as_written ||
                          mistake == LightVectorMistake::as_long_as_written;
  const double along = as_written ? cosine * written_length(light) : cosine;
  const Curve* const other_cone =
      has_cone(light.type) ? curve_of(m_.cone, glm::vec2(light.inner_angle, light.outer_angle))
                           : nullptr;
  const double spot = other_cone != nullptr
                          ? other_cone->at(std::acos(std::clamp(cosine, -1.0, 1.0)))
                      : has_cone(light.type) ? spot_share(light, along, m_.spot)
                                             : 1;
  arriving.factor = fading * spot;
  arriving.specular_factor = arriving.factor;
  if (m_.attenuation == AttenuationMistake::diffuse_only) {
    arriving.specular_factor = spot;
  } else if (m_.attenuation == AttenuationMistake::specular_only) {
    arriving.factor = spot;
  } else if (m_.attenuation == AttenuationMistake::specular_only_with_cone) {
    arriving.factor = 1;
  } else if (m_.attenuation == AttenuationMistake::diffuse_only_with_cone) {
    arriving.specular_factor = 1;
  }
  arriving.to_light = arriving.toward;
  switch (mistake) {
    case LightVectorMistake::not_normalized:
      arriving.to_light = way;
      break;
    case LightVectorMistake::reversed:
    case LightVectorMistake::reversed_positional:
    case LightVectorMistake::reversed_shading:
    case LightVectorMistake::reversed_positional_shading:
      arriving.to_light = -arriving.toward;
      break;
    case LightVectorMistake::to_origin:
      arriving.to_light = unit(from);
      break;
    case LightVectorMistake::sum:
      arriving.to_light = unit(from + s.position);
      break;
    case LightVectorMistake::from_object_point:
    case LightVectorMistake::from_object_point_all:
      arriving.to_light = unit(from - s.object_point);
      break;
    case LightVectorMistake::none:
    case LightVectorMistake::to_origin_all:
    case LightVectorMistake::sum_all:
    case LightVectorMistake::reversed_directional:
    case LightVectorMistake::reversed_directional_shading:
    case LightVectorMistake::directional_as_long_as_written:
    case LightVectorMistake::spot_as_long_as_written:
    case LightVectorMistake::as_long_as_written:
    case LightVectorMistake::position_as_direction:
      break;
  }
  return arriving.factor > 0 || arriving.specular_factor > 0;
}

namespace {

// The kind of shape that casts no shadows.
std::optional<Shape> shape_without_shadow(ShadowMistake mistake) {
  switch (mistake) {
    case ShadowMistake::no_spheres:
      return Shape::sphere;
    case ShadowMistake::no_cubes:
      return Shape::cube;
    case ShadowMistake::no_cylinders:
      return Shape::cylinder;
    case ShadowMistake::no_cones:
      return Shape::cone;
    case ShadowMistake::no_meshes:
      return Shape::mesh;
    default:
      return std::nullopt;
  }
}

}  // namespace

bool Model::shadowed(const RenderLight& light, const Surface& s, const Arrival& arriving,
                     int depth) const {
  if (!options_.features.shadows || options_.mode != Mode::ray ||
      (depth > 0 &&
       (m_.shadow == ShadowMistake::only_camera_rays || m_.mirror == MirrorMistake::no_shadows))) {
    return false;
  }
  const bool directional = !has_position(light.type);
  ModelRay ray{s.position, arriving.toward};
  // A wrong light vector is used for shading and for shadow rays.
  if (m_.light_vector == LightVectorMistake::reversed ||
      (m_.light_vector == LightVectorMistake::reversed_directional && directional) ||
      (m_.light_vector == LightVectorMistake::reversed_positional && !directional)) {
    ray.direction = -ray.direction;
  }
  double end = arriving.distance;
  const ModelPart* without = nullptr;
  ModelHit hit;
  switch (m_.shadow) {
    case ShadowMistake::reversed:
      ray.direction = -ray.direction;
      break;
    case ShadowMistake::beyond_light:
      end = infinity;
      break;
    case ShadowMistake::beyond_light_only:
      return search(ray, m_.shadow_bias, infinity, false, without, hit) && hit.t > end;
    case ShadowMistake::first_object_only:
    case ShadowMistake::last_object_only:
      return meet(m_.shadow == ShadowMistake::first_object_only ? shapes_.parts.front()
                                                                : shapes_.parts.back(),
                  ray, m_.shadow_bias, end, true, hit);
    case ShadowMistake::spot_along_axis:
      if (has_cone(light.type)) {
        ray.direction = -dvec3(light.direction);
      }
      break;
    case ShadowMistake::spot_without:
    case ShadowMistake::point_without:
    case ShadowMistake::directional_without:
    case ShadowMistake::directional_only:
      if ((m_.shadow == ShadowMistake::spot_without && light.type == LightType::spot) ||
          (m_.shadow == ShadowMistake::point_without && light.type == LightType::point) ||
          (m_.shadow == ShadowMistake::directional_without && directional) ||
          (m_.shadow == ShadowMistake::directional_only && !directional)) {
        return false;
      }
      break;
    case ShadowMistake::not_own_object:
      without = s.hit.part;
      break;
    case ShadowMistake::first_light_only:
    case ShadowMistake::last_light_only:
      if (&light != (m_.shadow == ShadowMistake::first_light_only ? &scene_.lights.front()
                                                                  : &scene_.lights.back())) {
        return false;
      }
      break;
    case ShadowMistake::any_nearer_than_eye:
    case ShadowMistake::positional_nearer_than_eye:
      if (!directional || m_.shadow == ShadowMistake::any_nearer_than_eye) {
        end = glm::length(s.position - s.eye);
      }
      break;
    case ShadowMistake::unit_length:
    case ShadowMistake::point_as_directional:
      end = directional && m_.shadow == ShadowMistake::point_as_directional ? infinity : 1;
      break;
    case ShadowMistake::direction_unnormalized_far:
      end = directional ? 1 : end;
      break;
    case ShadowMistake::squared_distance:
      end *= end;
      break;
    case ShadowMistake::directional_ends_at_position:
      end = directional ? glm::length(dvec3(light.position) - s.position) : end;
      break;
    case ShadowMistake::light_to_eye:
      end = directional ? end : glm::length(dvec3(light.position) - s.eye);
      break;
    case ShadowMistake::light_from_origin:
      end = directional ? end : glm::length(dvec3(light.position));
      break;
    case ShadowMistake::from_eye:
      ray.origin = s.eye;
      break;
    case ShadowMistake::from_origin:
      ray.origin = dvec3(0);
      break;
    default:
      break;
  }
  ray.origin += m_.shadow_lift * s.normal - m_.shadow_back * s.direction;
  const std::optional<Shape> passed = shape_without_shadow(m_.shadow);
  if (m_.shadow != ShadowMistake::glass_lets_through && !passed) {
    return search(ray, m_.shadow_bias, end, true, without, hit) !=
           (m_.shadow == ShadowMistake::inverted);
  }
  double start = m_.shadow_bias;
  for (int i = 0; i < 16 && search(ray, start, end, false, without, hit); ++i) {
    if (passed ? hit.part->shape != *passed
               : scene_.materials[hit.part->material].transparent == glm::vec3(0)) {
      return true;
    }
    start = hit.t + 1e-4;
  }
  return false;
}

namespace {

double raised(double x, double n) {
  return n == std::floor(n) && n <= 4096 && n >= 0 ? std::pow(x, static_cast<int>(n))
                                                   : std::pow(x, n);
}

// Whether a shadow takes more than the light that casts it.
bool loses_more_than_the_light(ShadowMistake m) {
  switch (m) {
    case ShadowMistake::ambient_only:
    case ShadowMistake::stops:
    case ShadowMistake::black:
    case ShadowMistake::resets:
    case ShadowMistake::no_ambient_if_all:
    case ShadowMistake::first_light_for_all:
      return true;
    default:
      return false;
  }
}

}  // namespace

dvec3 Model::lighting(const Surface& s, const dvec3& to_eye, int depth,
                      std::vector<dvec3>* shares) const {
  const RenderGlobal& global = scene_.global;
  const RenderMaterial& material = *s.material;
  TextureUse use;
  dvec3 base = texture_or_plain(s, depth, use);
  const double ka = global.ambient;
  dvec3 ambient = ka * dvec3(material.ambient);
  if (m_.ambient == AmbientMistake::times_diffuse) {
    ambient *= dvec3(material.diffuse);
  } else if (m_.ambient == AmbientMistake::times_texture) {
    ambient *= use.color;
  } else if (m_.ambient == AmbientMistake::only_texture) {
    ambient = use.blend > 0 ? ka * use.color : ambient;
  } else if (m_.ambient == AmbientMistake::textured) {
    ambient = glm::mix(ambient, ka * use.color, use.blend);
  } else if (m_.texture == TextureMistake::ambient_too && options_.features.texture &&
             options_.mode == Mode::ray && material.texture.used()) {
    ambient = ka * base;
  }
  if (depth > 0 &&
      (m_.ambient == AmbientMistake::no_in_reflections || m_.mirror == MirrorMistake::no_ambient)) {
    ambient = dvec3(0);
  }
  dvec3 faded_ambient(0);  // what each light adds
  switch (m_.ambient) {
    case AmbientMistake::faded:
    case AmbientMistake::faded_colored:
    case AmbientMistake::faded_shadowed:
      std::swap(ambient, faded_ambient);
      break;
    default:
      break;
  }
  dvec3 eye = to_eye;
  switch (m_.specular) {
    case SpecularMistake::mirror_of_view_wrong:
      eye = -eye;
      break;
    case SpecularMistake::eye_at_origin:
      eye = unit(-s.position);
      break;
    case SpecularMistake::looks_along_camera:
      eye = scene_.camera.w;
      break;
    case SpecularMistake::eye_as_direction:
      eye = unit(s.eye);
      break;
    case SpecularMistake::point_as_direction:
      eye = unit(s.position);
      break;
    case SpecularMistake::eye_not_normalized:
      eye = s.eye - s.position;
      break;
    case SpecularMistake::ray_not_normalized:
      eye /= depth == 0 ? glm::dot(eye, scene_.camera.w) : 1.0;
      break;
    default:
      break;
  }
  if (m_.mirror == MirrorMistake::eye_at_camera && depth > 0) {
    eye = unit(s.eye - s.position);
  }
  double ks = m_.specular == SpecularMistake::no_coefficient ? 1 : global.specular;
  ks = m_.specular == SpecularMistake::squared_coefficient ? ks * ks : ks;
  double exponent = m_.exponent.value_or(material.shininess);
  switch (m_.specular) {
    case SpecularMistake::no_exponent:
      exponent = 1;
      break;
    case SpecularMistake::blinn_four:
    case SpecularMistake::exponent_four:
      exponent *= 4;
      break;
    case SpecularMistake::exponent_quarter:
      exponent /= 4;
      break;
    case SpecularMistake::exponent_double:
      exponent *= 2;
      break;
    case SpecularMistake::exponent_half:
      exponent /= 2;
      break;
    default:
      break;
  }
  dvec3 specular_color = m_.specular == SpecularMistake::no_color        ? dvec3(1)
                         : m_.specular == SpecularMistake::diffuse_color ? dvec3(material.diffuse)
                                                                         : dvec3(material.specular);
  if (m_.specular == SpecularMistake::times_diffuse) {
    specular_color *= dvec3(material.diffuse);
  }
  if (m_.specular == SpecularMistake::times_shininess) {
    specular_color *= material.shininess;
  }
  specular_color *= use.times_specular;
  dvec3 sum = ambient;
  bool any_lit = false;
  bool any_shadow = false;
  bool first = true;
  bool first_shadow = false;
  const bool loses_more = loses_more_than_the_light(m_.shadow);
  const auto lit_by = [&](const RenderLight& light, const Arrival& arriving, dvec3& color,
                          dvec3& diffuse_share) {
    const dvec3& n = s.normal;
    const dvec3& l = arriving.to_light;
    double cosine = glm::dot(n, l);
    if (m_.diffuse == DiffuseMistake::absolute_everywhere) {
      cosine = std::abs(cosine);
    } else if (m_.specular == SpecularMistake::clamped_mirror) {
      cosine = std::max(0.0, cosine);
    }
    double weight = std::max(0.0, cosine);
    switch (m_.diffuse) {
      case DiffuseMistake::absolute:
        weight = std::abs(cosine);
        break;
      case DiffuseMistake::not_clamped:
        weight = cosine;
        break;
      case DiffuseMistake::no_cosine:
        weight = 1;
        break;
      case DiffuseMistake::by_view:
        weight = std::max(0.0, glm::dot(n, to_eye));
        break;
      case DiffuseMistake::half_lambert:
        weight = 0.5 * cosine + 0.5;
        break;
      case DiffuseMistake::squared:
        weight *= weight;
        break;
      default:
        break;
    }
    if (!m_.diffuse_response.knots.empty()) {
      weight = m_.diffuse_response.at(cosine);
    }
    weight = use.unlit ? 1 : weight;
    const dvec3 diffuse = m_.diffuse_factor * weight * base;
    double shine = glm::dot(2 * cosine * n - l, eye);
    switch (m_.specular) {
      case SpecularMistake::blinn:
      case SpecularMistake::blinn_four:
        shine = glm::dot(n, unit(l + eye));
        break;
      case SpecularMistake::half_not_normalized:
        shine = glm::dot(n, l + eye);
        break;
      case SpecularMistake::absolute:
        shine = std::abs(shine);
        break;
      case SpecularMistake::by_light_view:
        shine = glm::dot(l, eye);
        break;
      case SpecularMistake::reversed_mirror:
        shine = -shine;
        break;
      case SpecularMistake::by_normal_view:
        shine = glm::dot(n, eye);
        break;
      case SpecularMistake::by_normal_light:
        shine = cosine;
        break;
      case SpecularMistake::mirror_not_doubled:
        shine = glm::dot(cosine * n - l, eye);
        break;
      default:
        break;
    }
    dvec3 shining(0);
    const bool any_sign =
        m_.specular == SpecularMistake::negative_power && exponent == std::floor(exponent);
    if ((shine > 0 || any_sign) && (exponent > 0 || m_.specular == SpecularMistake::zero_shines)) {
      shining = ks * specular_color * raised(shine, exponent);
    }
    for (const auto& other : m_.highlights) {
      if (shine > 0 && exponent == other.first) {
        shining = ks * specular_color * other.second.at(std::acos(std::min(shine, 1.0)));
      }
    }
    if (m_.specular == SpecularMistake::times_cosine) {
      shining *= std::max(0.0, cosine);
    } else if (m_.specular == SpecularMistake::lit_side_only && cosine <= 0) {
      shining = dvec3(0);
    }
    const dvec3 diffuse_light =
        m_.diffuse == DiffuseMistake::no_light_color ? dvec3(1) : dvec3(light.color);
    const dvec3 specular_light =
        m_.specular == SpecularMistake::no_light_color ? dvec3(1) : dvec3(light.color);
    const dvec3 diffuse_part = arriving.factor * diffuse_light * diffuse;
    const dvec3 specular_part = arriving.specular_factor * specular_light * shining;
    color = diffuse_part + specular_part;
    diffuse_share = diffuse_part;
    // What is dark anyway needs no shadow, unless a light that is not shadowed replaces others, or
    // the ambient term depends on it.
    if (color == dvec3(0) && m_.shadow == ShadowMistake::none && m_.light_sum == LightSum::none &&
        m_.ambient != AmbientMistake::lit_only && m_.ambient != AmbientMistake::faded_shadowed) {
      return true;
    }
    bool dark = shadowed(light, s, arriving, depth);
    if (m_.shadow == ShadowMistake::first_light_for_all) {
      first_shadow = first ? dark : first_shadow;
      dark = first_shadow;
    }
    first = false;
    if (!dark) {
      return true;
    }
    switch (m_.shadow) {
      case ShadowMistake::keeps_specular:
        color = specular_part;
        diffuse_share = dvec3(0);
        break;
      case ShadowMistake::keeps_diffuse:
        color = diffuse_part;
        break;
      case ShadowMistake::half:
        color *= 0.5;
        diffuse_share *= 0.5;
        break;
      default:
        diffuse_share *= 0;
        color *= 0;  // infinite light gives NaN, see AttenuationMistake::infinite_white
        break;
    }
    return false;
  };
  dvec3 replaced(0);  // by the next light, see LightSum::replaces_term
  for (const RenderLight& light : scene_.lights) {
    if (!counts(light)) {
      continue;
    }
    const std::uint32_t side = has_rectangle(light.type) ? area_side : 1;
    dvec3 of_light(0);
    dvec3 of_term(0);
    double factor = 0;
    bool lit = false;
    for (std::uint32_t i = 0; i < side * side; ++i) {
      Arrival arriving;
      const dvec2 on_light((i % side + 0.5) / side, (i / side + 0.5) / side);
      dvec3 color(0);
      dvec3 diffuse_share(0);
      const bool arrives = arrival(light, s, on_light, arriving);
      // Outside the cone of a spotlight, a shadow may take what other lights have added.
      if (arrives || (loses_more && arriving.factor == 0)) {
        const bool open = lit_by(light, arriving, color, diffuse_share);
        lit = lit || open;
        of_light += color;
        of_term += m_.summed_term == LightTerm::diffuse ? diffuse_share : color - diffuse_share;
        factor += arriving.factor / double(side * side);
      } else {
        lit = true;
      }
    }
    of_light /= double(side * side);
    of_term /= double(side * side);
    if (m_.ambient != AmbientMistake::faded_shadowed || lit) {
      of_light += factor * faded_ambient *
                  (m_.ambient == AmbientMistake::faded ? dvec3(1) : dvec3(light.color));
    }
    if (shares != nullptr) {
      shares->push_back(of_light);
      continue;
    }
    switch (m_.light_sum) {
      case LightSum::brightest:
        sum = ambient + glm::max(sum - ambient, of_light);
        break;
      case LightSum::last:
        sum = lit ? ambient + of_light : sum;
        break;
      case LightSum::last_of_all:
        sum = lit ? of_light : sum;
        break;
      case LightSum::attenuated_again:
        sum = lit ? factor * sum + of_light : sum;
        break;
      case LightSum::first_of_term:
        sum += &light == &scene_.lights.front() ? of_light : of_light - of_term;
        break;
      case LightSum::last_of_term:
      case LightSum::replaces_term:
        sum += of_light;
        if (lit || m_.light_sum == LightSum::last_of_term) {
          sum -= replaced;
          replaced = of_term;
        }
        break;
      case LightSum::none:
        sum += of_light;
        break;
    }
    any_lit = any_lit || lit;
    any_shadow = any_shadow || !lit;
    if (!lit && m_.shadow == ShadowMistake::ambient_only) {
      return ambient;
    }
    if (!lit && m_.shadow == ShadowMistake::stops) {
      break;
    }
    if (!lit && m_.shadow == ShadowMistake::resets) {
      sum = dvec3(0);
    }
    if (!lit && m_.shadow == ShadowMistake::black) {
      return dvec3(0);
    }
  }
  if (m_.shadow == ShadowMistake::no_ambient_if_all && any_shadow && !any_lit) {
    return dvec3(0);
  }
  if ((m_.ambient == AmbientMistake::lit_only && !any_lit) ||
      (m_.ambient == AmbientMistake::unlit_only && sum != ambient)) {
    sum -= ambient;
  }
  const bool over_lighting = m_.texture == TextureMistake::over_lighting ||
                             m_.texture == TextureMistake::over_lighting_too;
  sum *= use.times;
  return over_lighting ? glm::mix(sum, use.over, use.share_over) : sum;
}

std::vector<dvec3> Model::light_shares(const ModelRay& ray) const {
  std::vector<dvec3> shares;
  const ModelHit hit = first_hit(ray);
  if (hit.part != nullptr) {
    lighting(surface(ray, hit), -ray.direction, 0, &shares);
  }
  return shares;
}

std::vector<dvec3> Model::self_mirrored(const ModelRay& ray, std::uint32_t patterns) const {
  std::vector<dvec3> colors;
  for (std::uint32_t pattern = 0; pattern < patterns; ++pattern) {
    self_hits_ = pattern;
    colors.push_back(color(ray));
  }
  self_hits_ = 0;
  return colors;
}

// The color of the surface without reflection and refraction, but with shadows.
dvec3 Model::surface_color(const Surface& s, const dvec3& to_eye, int depth) const {
  switch (m_.shown) {
    case ShownInstead::normals:
      return 0.5 * (s.normal + 1.0);
    case ShownInstead::absolute_normals:
      return glm::abs(s.normal);
    case ShownInstead::raw_normals:
      return s.normal;
    case ShownInstead::object_normals:
      return 0.5 * (unit(s.object_normal) + 1.0);
    case ShownInstead::flat_diffuse:
      return dvec3(s.material->diffuse);
    case ShownInstead::flat_ambient_diffuse:
      return double(scene_.global.ambient) * dvec3(s.material->ambient) +
             double(scene_.global.diffuse) * dvec3(s.material->diffuse);
    case ShownInstead::white:
      return dvec3(1);
    case ShownInstead::none:
      break;
  }
  return lighting(s, to_eye, depth, nullptr);
}

dvec3 Model::lit(const ShownPoint& point) const {
  Surface s;
  s.material = &scene_.materials[point.material];
  s.position = point.position;
  s.object_normal = point.object_normal;
  s.normal = point.normal;
  s.geometric = unit(point.normal);
  s.eye = scene_.camera.position;
  s.direction = unit(point.position - scene_.camera.position);
  if (m_.normals == NormalMistake::toward_eye && glm::dot(s.normal, s.direction) > 0) {
    s.normal = -s.normal;
  }
  return surface_color(s, -s.direction, 0);
}

dvec3 Model::trace(const ModelRay& ray, int depth, const ModelHit* known, double t_min,
                   const dvec3& chain) const {
  ModelHit hit;
  if (known != nullptr) {
    hit = *known;
  } else if (!search(ray, t_min, infinity, false, nullptr, hit)) {
    hit.part = nullptr;
  }
  if (hit.part == nullptr) {
    return depth > 0 && m_.mirror == MirrorMistake::white_background ? dvec3(1)
           : depth == 0 || m_.background_in_reflections              ? m_.background
                                                                     : dvec3(0);
  }
  const Surface s = surface(ray, hit);
  if (options_.mode == Mode::normals && m_.shown == ShownInstead::none) {
    return 0.5 * (s.normal + 1.0);
  }
  dvec3 color = surface_color(s, -ray.direction, depth);
  if (m_.shown != ShownInstead::none) {
    return color;
  }
  if (options_.mode == Mode::ray) {
    const dvec3 local = color;
    dvec3 kept = color;
    dvec3 reflected = mirrored(s, ray, depth, kept);
    const dvec3 through = refracted(s, ray, depth, kept, reflected);
    color = kept + reflected + through;
    if (m_.texture == TextureMistake::over_all || m_.texture == TextureMistake::over_all_too) {
      TextureUse use;
      texture_or_plain(s, depth, use);
      color = glm::mix(color, use.over, use.share_over);
    }
    if (m_.mirror == MirrorMistake::last_weight_only) {
      return clamped(chain * kept) + reflected + through;
    }
    if (depth > 0 && local != kept && m_.mirror == MirrorMistake::no_local) {
      color = reflected + through;
    }
  }
  if (depth == 0 || m_.mirror == MirrorMistake::clamped_never ||
      options_.profile != Profile::course) {
    return color;
  }
  return clamped(color);
}

dvec3 Model::mirrored(const Surface& s, const ModelRay& ray, int depth, dvec3& local) const {
  const RenderMaterial& material = *s.material;
  const double ks = scene_.global.specular;
  dvec3 factor = ks * dvec3(material.reflective);
  const bool reflects = material.reflective != glm::vec3(0);
  if (!options_.features.reflect) {
    return dvec3(0);
  }
  switch (m_.mirror) {
    case MirrorMistake::coefficient_once:
      factor = depth > 0 ? dvec3(material.reflective) : factor;
      break;
    case MirrorMistake::no_coefficient:
    case MirrorMistake::multiplied_by_color:
      factor = dvec3(material.reflective);
      break;
    case MirrorMistake::color_ignored:
      factor = reflects ? dvec3(ks) : dvec3(0);
      break;
    case MirrorMistake::neither:
      factor = reflects ? dvec3(1) : dvec3(0);
      break;
    case MirrorMistake::specular_color:
      factor = reflects ? ks * dvec3(material.specular) : dvec3(0);
      break;
    case MirrorMistake::all_materials:
      factor = ks * dvec3(material.specular);
      break;
    case MirrorMistake::doubled:
      factor *= 2.0;
      break;
    case MirrorMistake::halved:
      factor *= 0.5;
      break;
    case MirrorMistake::diffuse_coefficient:
      factor = double(scene_.global.diffuse) * dvec3(material.reflective);
      break;
    case MirrorMistake::times_diffuse:
      factor *= dvec3(material.diffuse);
      break;
    case MirrorMistake::blended_plain:
    case MirrorMistake::averaged:
      factor = reflects ? dvec3(m_.mirror == MirrorMistake::averaged ? 0.5 : ks) : dvec3(0);
      break;
    case MirrorMistake::times_cosine:
      factor *= std::max(0.0, glm::dot(s.normal, -ray.direction));
      break;
    default:
      break;
  }
  factor *= m_.mirror_factor;
  if (factor == dvec3(0) || depth + 1 > options_.max_depth) {
    return dvec3(0);
  }
  dvec3 direction = ray.direction - 2 * glm::dot(ray.direction, s.normal) * s.normal;
  switch (m_.mirror) {
    case MirrorMistake::reversed:
      direction = -direction;
      break;
    case MirrorMistake::wrong_sign:
      direction = ray.direction + 2 * glm::dot(ray.direction, s.normal) * s.normal;
      break;
    case MirrorMistake::not_doubled:
      direction = ray.direction - glm::dot(ray.direction, s.normal) * s.normal;
      break;
    case MirrorMistake::along_normal:
      direction = s.normal;
      break;
    case MirrorMistake::straight:
      direction = ray.direction;
      break;
    default:
      break;
  }
  if (m_.mirror == MirrorMistake::no_local) {
    local = dvec3(0);
  }
  const dvec3 weights = factor;
  dvec3 seen;
  const dvec3 start = m_.mirror == MirrorMistake::from_eye ? ray.origin : s.position;
  if ((self_hits_ >> depth & 1) != 0) {
    ModelHit itself = s.hit;
    itself.t = 0;
    seen = trace({s.position, unit(direction)}, depth + 1, &itself, 0, weights);
  } else {
    seen = trace({start, unit(direction)}, depth + 1, nullptr, m_.mirror_bias, weights);
  }
  switch (m_.mirror) {
    case MirrorMistake::blended:
      local *= 1.0 - dvec3(material.reflective);
      factor = dvec3(material.reflective);
      break;
    case MirrorMistake::blended_coefficient:
      local *= 1.0 - factor;
      break;
    case MirrorMistake::blended_all:
    case MirrorMistake::blended_plain:
      local *= 1 - ks;
      break;
    case MirrorMistake::multiplied:
    case MirrorMistake::multiplied_by_color:
      factor *= local;
      local *= 1.0 - weights;
      break;
    case MirrorMistake::averaged:
      local *= 0.5;
      break;
    case MirrorMistake::replaces:
      local = dvec3(0);
      break;
    case MirrorMistake::maximum:
      return glm::max(dvec3(0), factor * seen - local);
    case MirrorMistake::screened:
      return factor * seen * (1.0 - clamped(local));
    case MirrorMistake::last_weight_only:
      return seen;
    case MirrorMistake::not_chained:
      // The weight is applied only once, to the camera ray's result.
      return depth == 0 ? factor * seen : seen;
    default:
      break;
  }
  return factor * seen;
}

dvec3 Model::refracted(const Surface& s, const ModelRay& ray, int depth, dvec3& local,
                       dvec3& reflected) const {
  const RenderMaterial& material = *s.material;
  const double kt = transparency();
  if (!options_.features.refract || material.transparent == glm::vec3(0) ||
      depth + 1 > options_.max_depth) {
    return dvec3(0);
  }
  dvec3 factor = kt * dvec3(material.transparent);
  switch (m_.glass) {
    case GlassMistake::no_coefficient:
    case GlassMistake::blended_by_color:
      factor = dvec3(material.transparent);
      break;
    case GlassMistake::color_ignored:
    case GlassMistake::blended_plain:
      factor = dvec3(kt);
      break;
    case GlassMistake::times_diffuse:
      factor *= dvec3(material.diffuse);
      break;
    case GlassMistake::half:
      factor *= 0.5;
      break;
    case GlassMistake::replaces_all:
      factor = dvec3(1);
      break;
    default:
      break;
  }
  factor *= m_.glass_factor;
  if (factor == dvec3(0)) {
    return dvec3(0);
  }
  const double ior = m_.glass == GlassMistake::ior_one_and_half ? 1.5
                     : m_.glass == GlassMistake::ior_of_water   ? 1.33
                                                                : material.ior;
  const auto bent = [&](const dvec3& direction, dvec3 normal, bool entering, dvec3& out) {
    double eta = (entering || m_.glass == GlassMistake::entering_always) ? 1 / ior : ior;
    const bool inverted = m_.glass == GlassMistake::eta_inverted ||
                          m_.glass == GlassMistake::eta_inverted_black ||
                          m_.glass == GlassMistake::eta_inverted_all_black;
    eta = inverted ? 1 / eta : eta;
    if (glm::dot(direction, normal) > 0) {
      normal = -normal;
    }
    if (m_.glass == GlassMistake::straight || m_.glass == GlassMistake::straight_shaded ||
        (m_.glass == GlassMistake::one_side && !entering)) {
      out = direction;
      return true;
    }
    const double cosine = -glm::dot(direction, normal);
    const double under = 1 - eta * eta * (1 - cosine * cosine);
    if (under < 0) {
      out = direction + 2 * cosine * normal;
      return false;
    }
    const double root = m_.glass == GlassMistake::wrong_sign ? -std::sqrt(under) : std::sqrt(under);
    out = unit(eta * direction + (eta * cosine - root) * normal);
    return true;
  };
  if (m_.glass == GlassMistake::blended || m_.glass == GlassMistake::blended_by_color ||
      m_.glass == GlassMistake::blended_plain) {
    local *= 1.0 - factor;
    reflected *= m_.glass_over_mirror ? 1.0 - factor : dvec3(1);
  } else if (m_.glass == GlassMistake::blended_all) {
    local *= 1 - kt;
    reflected *= m_.glass_over_mirror ? 1 - kt : 1;
  } else if (m_.glass == GlassMistake::replaces_all) {
    local = reflected = dvec3(0);
  } else if (m_.glass == GlassMistake::no_local) {
    local = dvec3(0);
    reflected *= m_.glass_over_mirror ? 0 : 1;
  }
  const dvec3 weights = factor;
  const bool entering = glm::dot(s.geometric, ray.direction) < 0;
  ModelRay inside{s.position, ray.direction};
  bool inside_glass = entering;
  if (m_.glass == GlassMistake::mirrored) {
    inside.direction = ray.direction - 2 * glm::dot(ray.direction, s.normal) * s.normal;
    inside_glass = false;
  } else if (!bent(ray.direction, s.geometric, entering, inside.direction)) {
    if (m_.glass == GlassMistake::no_total_reflection ||
        m_.glass == GlassMistake::eta_inverted_black ||
        m_.glass == GlassMistake::eta_inverted_all_black) {
      return dvec3(0);
    }
    inside_glass = !entering;
  }
  if (!inside_glass || m_.glass == GlassMistake::shaded_inside ||
      m_.glass == GlassMistake::straight_shaded) {
    return factor * trace(inside, depth + 1, nullptr, m_.mirror_bias, weights);
  }
  // Continues inside the object; its back wall is not lit.
  int at = depth + 1;
  for (int i = 0; i < 64; ++i) {
    ModelHit hit;
    if (!search(inside, m_.mirror_bias, infinity, false, nullptr, hit)) {
      return dvec3(0);
    }
    if (hit.part != s.hit.part) {
      return factor * trace(inside, at, &hit, m_.mirror_bias, weights);
    }
    if (m_.glass == GlassMistake::black_inside) {
      return dvec3(0);
    }
    const Surface wall = surface(inside, hit);
    dvec3 direction;
    const bool out = bent(inside.direction, wall.geometric, false, direction);
    inside = {wall.position, direction};
    if (out) {
      return factor * trace(inside, at, nullptr, m_.mirror_bias, weights);
    }
    if (m_.glass == GlassMistake::no_total_reflection ||
        m_.glass == GlassMistake::eta_inverted_all_black || ++at > options_.max_depth) {
      return dvec3(0);
    }
  }
  return dvec3(0);
}

}  // namespace scenefile
