#include "view/software_realtime.h"

#include "scenefile/geometry/realtime_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scenefile::view_test {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::uint32_t background = 0xffffffffu;

struct Vertex {
  dvec3 world;
  dvec3 normal;  // world space, any length
};

Vertex mix(const Vertex& a, const Vertex& b, double t) {
  return {a.world + t * (b.world - a.world), a.normal + t * (b.normal - a.normal)};
}

dvec3 light_of(const RenderLight& light, const dvec3& point, dvec3& to_light) {
  if (light.type == LightType::directional) {
    to_light = -dvec3(light.direction);
    return dvec3(light.color);
  }
  const dvec3 path = dvec3(light.position) - point;
  const double distance = glm::length(path);
  to_light = path / distance;
  const double fade = light.attenuation.x + light.attenuation.y * distance +
                      light.attenuation.z * distance * distance;
  dvec3 color = dvec3(light.color) * std::min(1.0, 1 / fade);
  if (light.type == LightType::spot) {
    const double cosine = -glm::dot(to_light, dvec3(light.direction));
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    if (angle > double(light.outer_angle)) {
      return dvec3(0);
    }
    if (angle > double(light.inner_angle)) {
      const double t = (angle - double(light.inner_angle)) /
                       (double(light.outer_angle) - double(light.inner_angle));
      color *= 1 + t * t * (2 * t - 3);
    }
  }
  return color;
}

class Rasterizer {
 public:
  Rasterizer(const RenderScene& scene, const RealtimeOptions& options, int width, int height,
             const RasterRules& rules)
      : scene_(scene),
        options_(options),
        rules_(rules),
        width_(width),
        height_(height),
        window_(realtime_window(width, height)),
        frame_(options.milestone == Milestone::action ? window_ : RealtimeWindow{width, height}),
        tan_y_(std::tan(scene.camera.fov_y / 2)),
        tan_x_(tan_y_ * window_.width / window_.height) {
    const std::size_t count = std::size_t(frame_.width) * frame_.height;
    depth_.assign(count, 1);
    triangle_.assign(count, background);
    color_.assign(count, {0, 0, 0});
    for (const Shape shape : {Shape::cube, Shape::cone, Shape::cylinder, Shape::sphere}) {
      meshes_[std::size_t(shape)] = realtime_mesh(shape, options.tessellation);
    }
  }

  void draw() { draw_group(scene_.root, DAffine(glm::dmat3(1), dvec3(0))); }

  SoftwarePicture finish() const {
    SoftwarePicture result;
    result.picture.width = width_;
    result.picture.height = height_;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        // The frame's rows count from the bottom.
        const dvec2 place((x + 0.5) / width_ * frame_.width,
                          (height_ - y - 0.5) / height_ * frame_.height);
        const dvec3 filtered = filter(place);
        for (int c = 0; c < 3; ++c) {
          result.picture.rgb.push_back(to_byte(filtered[c]));
        }
        result.near_edge.push_back(near_edge(int(place.x), int(place.y)));
      }
    }
    return result;
  }

 private:
  static std::uint8_t to_byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
  }

  void draw_group(std::uint32_t index, const DAffine& world_from_group) {
    const RenderGroup& group = scene_.groups[index];
    for (const RenderPrimitive& primitive : group.primitives) {
      if (primitive.shape != Shape::mesh) {
        draw_mesh(meshes_[std::size_t(primitive.shape)],
                  world_from_group * DAffine(primitive.group_from_object),
                  scene_.materials[primitive.material]);
      }
    }
    for (const RenderInstance& instance : group.instances) {
      draw_group(instance.group, world_from_group * DAffine(instance.group_from_instance));
    }
  }

  void draw_mesh(const Mesh& mesh, const DAffine& world_from_object,
                 const RenderMaterial& material) {
    const glm::dmat3 normals = glm::transpose(glm::inverse(world_from_object.linear));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      std::vector<Vertex> polygon;
      for (int k = 0; k < 3; ++k) {
        polygon.push_back({world_from_object.linear * dvec3(mesh.positions[mesh.triangles[t][k]]) +
                               world_from_object.offset,
                           normals * dvec3(mesh.normals[mesh.triangle_normals[t][k]])});
      }
      polygon = clip(clip(polygon, options_.near, 1), options_.far, -1);
      for (std::size_t k = 2; k < polygon.size(); ++k) {
        draw_triangle({polygon[0], polygon[k - 1], polygon[k]}, material);
      }
      ++next_triangle_;
    }
  }

  double depth_of(const Vertex& v) const {
    return -glm::dot(v.world - scene_.camera.position, scene_.camera.w);
  }

  // Keeps what is farther than `depth` (side 1) or nearer (side -1).
  std::vector<Vertex> clip(const std::vector<Vertex>& polygon, double depth, int side) const {
    std::vector<Vertex> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vertex& a = polygon[i];
      const Vertex& b = polygon[(i + 1) % polygon.size()];
      const double in_a = side * (depth_of(a) - depth);
      const double in_b = side * (depth_of(b) - depth);
      if (in_a >= 0) {
        result.push_back(a);
      }
      if ((in_a >= 0) != (in_b >= 0)) {
        result.push_back(mix(a, b, in_a / (in_a - in_b)));
      }
    }
    return result;
  }

  dvec2 window(const Vertex& v) const {
    const dvec3 p = v.world - scene_.camera.position;
    const double depth = depth_of(v);
    return {(glm::dot(p, scene_.camera.u) / (depth * tan_x_) + 1) / 2 * width_,
            (glm::dot(p, scene_.camera.v) / (depth * tan_y_) + 1) / 2 * height_};
  }

  void draw_triangle(const std::array<Vertex, 3>& v, const RenderMaterial& material) {
    const double unit = std::exp2(rules_.subpixel_bits);
    std::array<dvec2, 3> p;
    std::array<double, 3> inverse_depth{};
    dvec2 low(1e9);
    dvec2 high(-1e9);
    for (int k = 0; k < 3; ++k) {
      p[k] = glm::round(window(v[k]) * unit) / unit;
      inverse_depth[k] = 1 / depth_of(v[k]);
      low = glm::min(low, p[k]);
      high = glm::max(high, p[k]);
    }
    const double area = cross(p[1] - p[0], p[2] - p[0]);
    if (!(area > 0)) {
      return;  // back face
    }
    const int x1 = std::min(width_ - 1, int(std::floor(high.x)));
    const int y1 = std::min(height_ - 1, int(std::floor(high.y)));
    for (int y = std::max(0, int(std::floor(low.y))); y <= y1; ++y) {
      for (int x = std::max(0, int(std::floor(low.x))); x <= x1; ++x) {
        const dvec2 center(x + 0.5, y + 0.5);
        std::array<double, 3> weight{};
        bool inside = true;
        for (int k = 0; k < 3; ++k) {
          const dvec2& a = p[(k + 1) % 3];
          const dvec2& b = p[(k + 2) % 3];
          weight[k] = cross(b - a, center - a) / area;
          inside = inside && (weight[k] > 0 || (weight[k] == 0 && owns(b - a)));
        }
        if (inside) {
          shade(x, y, v, weight, inverse_depth, material);
        }
      }
    }
  }

  static double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

  // The top-left rule: counterclockwise with y up, left edges go down and top edges go left.
  bool owns(const dvec2& edge) const {
    const bool upper = edge.x < 0;
    return edge.y < 0 || (edge.y == 0 && upper == rules_.upper_edges_own);
  }

  void shade(int x, int y, const std::array<Vertex, 3>& v, const std::array<double, 3>& weight,
             const std::array<double, 3>& inverse_depth, const RenderMaterial& material) {
    const double sum =
        weight[0] * inverse_depth[0] + weight[1] * inverse_depth[1] + weight[2] * inverse_depth[2];
    const double n = options_.near;
    const double f = options_.far;
    const double depth = std::round((f - f * n * sum) / (f - n) * 0xffffff) / 0xffffff;
    const std::size_t pixel = std::size_t(y) * frame_.width + x;
    if (depth >= depth_[pixel]) {
      return;
    }
    Vertex at{dvec3(0), dvec3(0)};
    for (int k = 0; k < 3; ++k) {
      at.world += weight[k] * inverse_depth[k] / sum * v[k].world;
      at.normal += weight[k] * inverse_depth[k] / sum * v[k].normal;
    }
    depth_[pixel] = depth;
    triangle_[pixel] = next_triangle_;
    const dvec3 color = lit(at, material);
    color_[pixel] = {to_byte(color.x), to_byte(color.y), to_byte(color.z)};
  }

  dvec3 lit(const Vertex& at, const RenderMaterial& material) const {
    const RenderGlobal& global = scene_.global;
    const dvec3 normal = glm::normalize(at.normal);
    const dvec3 to_eye = glm::normalize(scene_.camera.position - at.world);
    dvec3 sum = double(global.ambient) * dvec3(material.ambient);
    for (const RenderLight& light : scene_.lights) {
      if (!has_light(options_.milestone, light.type)) {
        continue;
      }
      dvec3 to_light;
      const dvec3 color = light_of(light, at.world, to_light);
      const double cosine = glm::dot(normal, to_light);
      const double mirrored = glm::dot(2 * cosine * normal - to_light, to_eye);
      sum += color * double(global.diffuse) * dvec3(material.diffuse) * std::max(0.0, cosine);
      if (mirrored > 0 && material.shininess > 0) {
        sum += color * double(global.specular) * dvec3(material.specular) *
               std::pow(mirrored, double(material.shininess));
      }
    }
    return sum;
  }

  dvec3 texel(int x, int y) const {
    x = (x % frame_.width + frame_.width) % frame_.width;
    y = (y % frame_.height + frame_.height) % frame_.height;
    const auto& c = color_[std::size_t(y) * frame_.width + x];
    return dvec3(c[0], c[1], c[2]) / 255.0;
  }

  // Linear interpolation between the centers of the frame's pixels, repeating the border.
  dvec3 sample(const dvec2& place) const {
    const dvec2 low = glm::floor(place - 0.5);
    const dvec2 t = place - 0.5 - low;
    const int x = int(low.x);
    const int y = int(low.y);
    const dvec3 lower = texel(x, y) * (1 - t.x) + texel(x + 1, y) * t.x;
    const dvec3 upper = texel(x, y + 1) * (1 - t.x) + texel(x + 1, y + 1) * t.x;
    return lower * (1 - t.y) + upper * t.y;
  }

  dvec3 box(const dvec2& place, int reach) const {
    dvec3 sum(0);
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        sum += sample(place + dvec2(x, y));
      }
    }
    return sum;
  }

  dvec3 filter(const dvec2& place) const {
    const dvec3 color = sample(place);
    switch (options_.filter) {
      case Filter::none:
        break;
      case Filter::invert:
        return 1.0 - color;
      case Filter::grayscale:
        return dvec3(glm::dot(color, dvec3(0.299, 0.587, 0.114)));
      case Filter::blur:
        return box(place, 2) / 25.0;
      case Filter::sharpen:
        return 2.0 * color - box(place, 1) / 9.0;
    }
    return color;
  }

  bool near_edge(int x, int y) const {
    std::uint32_t first = background;
    for (int j = std::max(0, y - 1); j <= std::min(frame_.height - 1, y + 1); ++j) {
      for (int i = std::max(0, x - 1); i <= std::min(frame_.width - 1, x + 1); ++i) {
        const std::uint32_t found = triangle_[std::size_t(j) * frame_.width + i];
        if (j == std::max(0, y - 1) && i == std::max(0, x - 1)) {
          first = found;
        } else if (found != first) {
          return true;
        }
      }
    }
    return false;
  }

  const RenderScene& scene_;
  const RealtimeOptions& options_;
  const RasterRules& rules_;
  int width_;
  int height_;
  RealtimeWindow window_;
  RealtimeWindow frame_;
  double tan_y_;
  double tan_x_;
  std::array<Mesh, 5> meshes_;
  std::uint32_t next_triangle_ = 0;
  std::vector<double> depth_;
  std::vector<std::uint32_t> triangle_;
  std::vector<std::array<std::uint8_t, 3>> color_;
};

}  // namespace

SoftwarePicture software_realtime(const RenderScene& scene, const RealtimeOptions& options,
                                  int width, int height, const RasterRules& rules) {
  Rasterizer rasterizer(scene, options, width, height, rules);
  rasterizer.draw();
  return rasterizer.finish();
}

}  // namespace scenefile::view_test
