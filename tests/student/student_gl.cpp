#include "student/student_gl.h"

#include "student/made_mistakes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace scenefile::student {

namespace {

using glm::mat3;
using glm::mat4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

constexpr float pi = 3.14159265f;

constexpr KnownMistake mistakes[] = {
    {"parameters-exchanged", "tessellation", "tessellation"},
    {"parameters-ignored", "tessellation", "tessellation"},
    {"parameters-plus-one", "tessellation", "tessellation"},
    {"parameters-7-9", "tessellation", "tessellation"},
    {"sphere-rows-plus-one", "tessellation", "tessellation"},
    {"wedges-clockwise", "tessellation", "tessellation"},
    {"wedges-from-z", "tessellation", "tessellation"},
    {"other-diagonal", "tessellation", "tessellation"},
    {"last-wedge-missing", "tessellation", "tessellation"},
    {"radius-one", "tessellation", "tessellation|shapes"},
    {"flat", "facets", "facets"},
    {"flat-spheres", "facets", "facets"},
    {"flat-provoking", "facets", "facets"},
    {"gouraud", "facets", "facets"},
    {"normals-by-model", "normals", "normals"},
    {"normals-of-object", "normals", "normals"},
    {"normals-inverse", "normals", "normals"},
    {"normals-translated", "normals", "normals"},
    {"normals-not-normalized", "normals", "normals"},
    {"normals-inverted", "normals", "normals"},
    {"cone-tip-up", "normals", "normals"},
    {"cone-level", "normals", "shapes"},
    {"cone-half-slope", "normals", "shapes"},
    {"sphere-normals-inward", "normals", "shapes"},
    {"cube-normals-like-sphere", "normals", "shapes"},
    {"no-culling", "culling", "culling"},
    {"front-culled", "culling", "culling"},
    {"caps-inside-out", "culling", "culling|shapes"},
    {"cones-inside-out", "culling", "culling"},
    {"cylinder-no-caps", "shapes", "shapes|culling"},
    {"cylinder-no-top", "shapes", "shapes|culling"},
    {"spheres-twice", "shapes", "shapes"},
    {"cone-no-cap", "shapes", "shapes|culling"},
    {"no-depth-test", "depth", "nearest-hit"},
    {"depth-reversed", "depth", "nearest-hit"},
    {"planes-ignored", "clipping", "clipping"},
    {"near-ignored", "clipping", "clipping"},
    {"far-ignored", "clipping", "clipping"},
    {"far-7", "clipping", "clipping"},
    {"near-6", "clipping", "clipping"},
    {"no-filter", "filter", "filter"},
    {"invert-objects", "filter", "filter"},
    {"gray-mean", "filter", "filter"},
    {"blur-unnormalized", "filter", "filter"},
    {"blur-3", "filter", "filter"},
    {"blur-7", "filter", "filter"},
    {"blur-gaussian", "filter", "filter"},
    {"blur-across", "filter", "filter"},
    {"blur-step-two", "filter", "filter"},
    {"blur-uncentered", "filter", "filter"},
    {"blur-triangle", "filter", "filter"},
    {"sharpen-unnormalized", "filter", "filter"},
    {"sharpen-5", "filter", "filter"},
    {"border-clamp", "filter", "filter"},
    {"viewport-full", "viewport", "viewport"},
    {"viewport-points", "viewport", "viewport"},
    {"aspect-picture", "viewport", "viewport"},
    {"viewport-exchanged", "viewport", "viewport"},
    {"lights-too", "lights", "lights"},
    {"lights-only-directional", "lights", "lights"},
    {"lights-no-point", "lights", "lights"},
    {"lights-no-spot", "lights", "lights"},
    {"lights-first", "lights", "lights"},
    {"lights-reversed", "lights", "lights"},
    {"lights-white", "lights", "lights"},
    {"lights-replace", "lights", "lights"},
    {"attenuation-none", "lights", "attenuation"},
    {"attenuation-quadratic", "lights", "attenuation"},
    {"spot-linear", "lights", "spot-falloff"},
    {"spot-sharp", "lights", "spot-falloff"},
    {"ambient-missing", "phong", "ambient"},
    {"ambient-each-light", "phong", "ambient"},
    {"diffuse-missing", "phong", "diffuse"},
    {"diffuse-no-coefficient", "phong", "diffuse"},
    {"diffuse-absolute", "phong", "diffuse"},
    {"specular-missing", "phong", "specular"},
    {"specular-blinn", "phong", "blinn"},
    {"specular-no-exponent", "phong", "specular"},
    {"specular-eye-reversed", "phong", "specular"},
    {"specular-no-coefficient", "phong", "specular"},
    {"fov-full", "camera", "camera"},
    {"fov-as-width", "camera", "camera"},
    {"camera-at-origin", "camera", "camera"},
    {"view-rotation-transposed", "camera", "camera"},
    {"picture-upside-down", "output", "vertical-flip"},
    {"picture-mirrored", "output", "horizontal-flip"},
    {"channels-bgr", "output", "swapped-channels"},
    {"gamma", "output", "gamma"},
    {"background-gray", "output", "background"},
    {"habit-subpixel-4", "habits", ""},
    {"habit-other-edges", "habits", ""},
    {"habit-no-snapping", "habits", ""},
    {"habit-normalize-early", "habits", ""},
    {"habit-depth-16", "habits", ""},
    {"habit-truncate", "habits", ""},
    {"strange-toon", "strange", ""},
    {"strange-noise", "strange", ""},
    {"strange-stripes", "strange", ""},
    {"strange-bent", "strange", ""},
    {"strange-fog", "strange", ""},
    {"strange-objects-shifted", "strange", ""},
    {"strange-posterized", "strange", ""},
    {"strange-rim-light", "strange", ""},
};

using Made = MadeMistakes<mistakes>;

struct Vertex {
  vec3 position;
  vec3 normal;
};

// One list of vertices, three per triangle, as in a vertex buffer.
using Buffer = std::vector<Vertex>;

struct Varying {
  vec4 clip;
  vec3 world;
  vec3 normal;
};

class Program {
 public:
  Program(const RenderScene& scene, const RealtimeJob& job)
      : scene_(scene), job_(job), made_(job.mistakes) {
    window_width_ = int(std::lround(job.width * 1092.0 / 1024));
    window_height_ = int(std::lround(job.height * 818.0 / 768));
    frame_width_ = job.action ? window_width_ : job.width;
    frame_height_ = job.action ? window_height_ : job.height;
    view_width_ = job.width;
    view_height_ = job.height;
    if (is("viewport-full")) {
      frame_width_ = job.width;
      frame_height_ = job.height;
    } else if (is("viewport-points")) {
      frame_width_ = 2 * job.width;
      frame_height_ = 2 * job.height;
    } else if (is("viewport-exchanged")) {
      std::swap(view_width_, view_height_);
    }
    frame_.assign(std::size_t(frame_width_) * frame_height_,
                  vec3(is("background-gray") ? 0.25f : 0));
    covered_.assign(frame_.size(), false);
    depth_.assign(frame_.size(), is("depth-reversed") ? 0 : 1);
  }

  Texture run() {
    make_buffers();
    make_camera();
    choose_lights();
    draw_group(scene_.root, mat4(1));
    return finish();
  }

 private:
  bool is(Made::Place mistake) const { return made_.contains(mistake); }

  // ---- tessellation --------------------------------------------------------------------------

  void triangle(Buffer& buffer, const Vertex& a, const Vertex& b, const Vertex& c) const {
    if (a.position == b.position || b.position == c.position || a.position == c.position) {
      return;
    }
    buffer.insert(buffer.end(), {a, b, c});
  }

  void quad(Buffer& buffer, const Vertex& a, const Vertex& b, const Vertex& c,
            const Vertex& d) const {
    if (is("other-diagonal")) {
      triangle(buffer, a, b, d);
      triangle(buffer, b, c, d);
    } else {
      triangle(buffer, a, b, c);
      triangle(buffer, a, c, d);
    }
  }

  vec2 around(float wedge) const {
    const float angle = 2 * pi * wedge / float(wedges_);
    return is("wedges-from-z") ? vec2(std::sin(angle), std::cos(angle))
                               : vec2(std::cos(angle), -std::sin(angle));
  }

  // The side of a shape from profiles (radius, height) and normals (outward, up).
  void side(Buffer& buffer, int rows, const std::function<vec2(int)>& profile,
            const std::function<vec2(int)>& normal, bool pointed) const {
    const int last = is("last-wedge-missing") ? wedges_ - 1 : wedges_;
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < last; ++j) {
        const auto at = [&](int row, int wedge) {
          const vec2 p = profile(row);
          const vec2 n = normal(row);
          const bool tip = pointed && row == 0;
          const vec2 out = around(float(wedge));
          const vec2 facing = tip ? around(float(j) + 0.5f) : out;
          Vertex v{{p.x * out.x, p.y, p.x * out.y},
                   glm::normalize(vec3(n.x * facing.x, n.y, n.x * facing.y))};
          if (tip && is("cone-tip-up")) {
            v.normal = {0, 1, 0};
          }
          if (tip || p.x == 0) {
            v.position = {0, p.y, 0};
          }
          return v;
        };
        quad(buffer, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }

  void cap(Buffer& buffer, int rings, float y) const {
    const int last = is("last-wedge-missing") ? wedges_ - 1 : wedges_;
    for (int i = 0; i < rings; ++i) {
      for (int j = 0; j < last; ++j) {
        const auto at = [&](int ring, int wedge) {
          const vec2 p = 0.5f * float(ring) / float(rings) * around(float(wedge));
          return Vertex{{p.x, y, p.y}, {0, y > 0 ? 1 : -1, 0}};
        };
        const int upper = (y > 0) == !is("caps-inside-out") ? i : i + 1;
        const int lower = (y > 0) == !is("caps-inside-out") ? i + 1 : i;
        quad(buffer, at(upper, j), at(lower, j), at(lower, j + 1), at(upper, j + 1));
      }
    }
  }

  void make_buffers() {
    int p1 = job_.parameter1;
    int p2 = job_.parameter2;
    if (is("parameters-exchanged")) {
      std::swap(p1, p2);
    } else if (is("parameters-ignored")) {
      p1 = p2 = 5;
    } else if (is("parameters-plus-one")) {
      ++p1;
      ++p2;
    } else if (is("parameters-7-9")) {
      p1 = 7;
      p2 = 9;
    }
    wedges_ = std::max(3, p2);
    const int rows = std::max(1, p1);
    const float outward = is("sphere-normals-inward") ? -1.0f : 1.0f;
    const int rings = std::max(2, p1) + (is("sphere-rows-plus-one") ? 1 : 0);
    side(
        buffers_[int(Shape::sphere)], rings,
        [&](int i) {
          return i == 0 || i == rings ? vec2(0, i == 0 ? 0.5f : -0.5f)
                                      : 0.5f * vec2(std::sin(pi * float(i) / float(rings)),
                                                    std::cos(pi * float(i) / float(rings)));
        },
        [&](int i) {
          return outward * (i == 0 || i == rings ? vec2(0, i == 0 ? 1 : -1)
                                                 : vec2(std::sin(pi * float(i) / float(rings)),
                                                        std::cos(pi * float(i) / float(rings))));
        },
        false);
    side(
        buffers_[int(Shape::cylinder)], rows,
        [&](int i) { return vec2(0.5f, 0.5f - float(i) / float(rows)); },
        [](int) { return vec2(1, 0); }, false);
    if (!is("cylinder-no-caps")) {
      if (!is("cylinder-no-top")) {
        cap(buffers_[int(Shape::cylinder)], rows, 0.5f);
      }
      cap(buffers_[int(Shape::cylinder)], rows, -0.5f);
    }
    const float slope = is("cone-level") ? 0.0f : is("cone-half-slope") ? 0.5f : 1.0f;
    side(
        buffers_[int(Shape::cone)], rows,
        [&](int i) { return vec2(0.5f * float(i) / float(rows), 0.5f - float(i) / float(rows)); },
        [&](int) { return vec2(2, slope); }, true);
    if (!is("cone-no-cap")) {
      cap(buffers_[int(Shape::cone)], rows, -0.5f);
    }
    for (const vec3 n : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0),
                         vec3(0, 0, 1), vec3(0, 0, -1)}) {
      const vec3 up = n.y == 0 ? vec3(0, 1, 0) : vec3(0, 0, -n.y);
      const vec3 right = glm::cross(up, n);
      const auto at = [&](int row, int column) {
        const vec3 position = 0.5f * n + (float(column) / float(rows) - 0.5f) * right +
                              (0.5f - float(row) / float(rows)) * up;
        return Vertex{position, is("cube-normals-like-sphere") ? glm::normalize(position) : n};
      };
      for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < rows; ++j) {
          quad(buffers_[int(Shape::cube)], at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
      }
    }
    for (Buffer& buffer : buffers_) {
      const auto index = std::size_t(&buffer - buffers_.data());
      for (std::size_t i = 0; i + 2 < buffer.size(); i += 3) {
        if (is("wedges-clockwise") && Shape(index) != Shape::cube) {
          for (std::size_t k = 0; k < 3; ++k) {
            buffer[i + k].position.z *= -1;
            buffer[i + k].normal.z *= -1;
          }
          std::swap(buffer[i + 1], buffer[i + 2]);
        }
        if (is("flat") || (is("flat-spheres") && Shape(index) == Shape::sphere)) {
          const vec3 n = glm::normalize(glm::cross(buffer[i + 1].position - buffer[i].position,
                                                   buffer[i + 2].position - buffer[i].position));
          buffer[i].normal = buffer[i + 1].normal = buffer[i + 2].normal = n;
        } else if (is("flat-provoking")) {
          buffer[i].normal = buffer[i + 1].normal = buffer[i + 2].normal;
        }
        if (is("cones-inside-out") && Shape(index) == Shape::cone) {
          std::swap(buffer[i + 1], buffer[i + 2]);
        }
        const bool twice =
            is("radius-one") || (is("spheres-twice") && Shape(index) == Shape::sphere);
        for (std::size_t k = 0; k < 3 && twice; ++k) {
          buffer[i + k].position *= 2.0f;
        }
      }
    }
  }

  // ---- matrices and lights -------------------------------------------------------------------

  void make_camera() {
    const RenderCamera& c = scene_.camera;
    const vec3 u(c.u);
    const vec3 v(c.v);
    const vec3 w(c.w);
    mat3 rotation = glm::transpose(mat3(u, v, w));
    if (is("view-rotation-transposed")) {
      rotation = glm::transpose(rotation);
    }
    eye_ = vec3(c.position);
    const vec3 from = is("camera-at-origin") ? vec3(0) : eye_;
    view_ = mat4(rotation) * glm::translate(mat4(1), -from);
    float aspect = float(window_width_) / float(window_height_);
    if (is("aspect-picture")) {
      aspect = float(job_.width) / float(job_.height);
    }
    const float half = float(is("fov-full") ? c.fov_y : c.fov_y / 2);
    float up = std::tan(half);
    float across = up * aspect;
    if (is("fov-as-width")) {
      across = up;
      up = across / aspect;
    }
    near_ = float(job_.near);
    far_ = float(job_.far);
    if (is("planes-ignored") || is("near-ignored")) {
      near_ = 0.1f;
    }
    if (is("planes-ignored") || is("far-ignored")) {
      far_ = 100;
    }
    near_ = is("near-6") ? 6.0f : near_;
    far_ = is("far-7") ? 7.0f : far_;
    projection_ = mat4(0);
    projection_[0][0] = 1 / across;
    projection_[1][1] = 1 / up;
    projection_[2][2] = -(far_ + near_) / (far_ - near_);
    projection_[2][3] = -1;
    projection_[3][2] = -2 * far_ * near_ / (far_ - near_);
  }

  void choose_lights() {
    for (RenderLight light : scene_.lights) {
      const bool directional = light.type == LightType::directional;
      if (light.type == LightType::area || (!directional && !job_.action && !is("lights-too")) ||
          (!directional && is("lights-only-directional")) ||
          (light.type == LightType::point && is("lights-no-point")) ||
          (light.type == LightType::spot && is("lights-no-spot")) ||
          (is("lights-first") && !lights_.empty())) {
        continue;
      }
      if (is("lights-white")) {
        light.color = vec3(1);
      }
      lights_.push_back(light);
    }
  }

  // ---- vertices ------------------------------------------------------------------------------

  void draw_group(std::uint32_t index, const mat4& model) {
    const auto matrix = [](const Affine& a) {
      return mat4(vec4(a.linear[0], 0), vec4(a.linear[1], 0), vec4(a.linear[2], 0),
                  vec4(a.offset, 1));
    };
    const RenderGroup& group = scene_.groups[index];
    for (const RenderPrimitive& p : group.primitives) {
      mat4 placed = model * matrix(p.group_from_object);
      if (is("strange-objects-shifted") && objects_++ % 2 == 1) {
        placed = glm::translate(mat4(1), vec3(0.2f, 0.1f, 0)) * placed;
      }
      draw_buffer(buffers_[std::size_t(p.shape)], placed, scene_.materials[p.material]);
    }
    for (const RenderInstance& i : group.instances) {
      draw_group(i.group, model * matrix(i.group_from_instance));
    }
  }

  vec3 normal_of(const Vertex& v, const mat4& model) const {
    const mat3 linear(model);
    if (is("normals-by-model")) {
      return linear * v.normal;
    }
    if (is("normals-of-object")) {
      return v.normal;
    }
    if (is("normals-inverse")) {
      return glm::inverse(linear) * v.normal;
    }
    if (is("normals-translated")) {
      return vec3(model * vec4(v.normal, 1));
    }
    const vec3 right = glm::transpose(glm::inverse(linear)) * v.normal;
    if (is("habit-normalize-early")) {
      return glm::normalize(right);
    }
    return is("normals-inverted") ? -right : right;
  }

  void draw_buffer(const Buffer& buffer, const mat4& model, const RenderMaterial& material) {
    for (std::size_t i = 0; i + 2 < buffer.size(); i += 3) {
      std::vector<Varying> polygon;
      for (std::size_t k = 0; k < 3; ++k) {
        const vec4 world = model * vec4(buffer[i + k].position, 1);
        polygon.push_back(
            {projection_ * (view_ * world), vec3(world), normal_of(buffer[i + k], model)});
        if (is("gouraud")) {
          polygon.back().normal = phong(polygon.back().world, polygon.back().normal, material);
        }
      }
      polygon = clip(polygon, [](const vec4& c) { return c.z + c.w; });
      polygon = clip(polygon, [](const vec4& c) { return c.w - c.z; });
      for (std::size_t k = 2; k < polygon.size(); ++k) {
        rasterize({polygon[0], polygon[k - 1], polygon[k]}, material);
      }
    }
  }

  static std::vector<Varying> clip(const std::vector<Varying>& polygon,
                                   float (*inside)(const vec4&)) {
    std::vector<Varying> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Varying& a = polygon[i];
      const Varying& b = polygon[(i + 1) % polygon.size()];
      const float in_a = inside(a.clip);
      const float in_b = inside(b.clip);
      if (in_a >= 0) {
        result.push_back(a);
      }
      if ((in_a >= 0) != (in_b >= 0)) {
        const float t = in_a / (in_a - in_b);
        result.push_back({glm::mix(a.clip, b.clip, t), glm::mix(a.world, b.world, t),
                          glm::mix(a.normal, b.normal, t)});
      }
    }
    return result;
  }

  // ---- fragments -----------------------------------------------------------------------------

  // Edge functions in units of 1/256 pixel, like a GPU.
  void rasterize(const std::array<Varying, 3>& corners, const RenderMaterial& material) {
    const double units = is("habit-subpixel-4") ? 16 : is("habit-no-snapping") ? 1 << 24 : 256;
    std::array<std::array<long long, 2>, 3> p{};
    std::array<float, 3> inverse{};
    std::array<float, 3> z{};
    for (std::size_t k = 0; k < 3; ++k) {
      const vec4& c = corners[k].clip;
      if (!(c.w > 0)) {
        return;
      }
      inverse[k] = 1 / c.w;
      z[k] = c.z / c.w * 0.5f + 0.5f;
      p[k] = {std::llround((double(c.x) / c.w * 0.5 + 0.5) * view_width_ * units),
              std::llround((double(c.y) / c.w * 0.5 + 0.5) * view_height_ * units)};
    }
    const auto doubled = [](const auto& a, const auto& b, const auto& c) {
      return __int128(b[0] - a[0]) * (c[1] - a[1]) - __int128(b[1] - a[1]) * (c[0] - a[0]);
    };
    __int128 area = doubled(p[0], p[1], p[2]);
    if (area == 0 || (!is("no-culling") && (area > 0) == is("front-culled"))) {
      return;
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    if (area < 0) {
      std::swap(order[1], order[2]);
      area = -area;
    }
    const auto& a = p[order[0]];
    const auto& b = p[order[1]];
    const auto& c = p[order[2]];
    const auto pixel = [&](long long v) { return int(std::floor(double(v) / units)); };
    const int x0 = std::max(0, pixel(std::min({a[0], b[0], c[0]})));
    const int y0 = std::max(0, pixel(std::min({a[1], b[1], c[1]})));
    const int x1 =
        std::min(std::min(frame_width_, view_width_) - 1, pixel(std::max({a[0], b[0], c[0]})));
    const int y1 =
        std::min(std::min(frame_height_, view_height_) - 1, pixel(std::max({a[1], b[1], c[1]})));
    const auto owns = [&](const auto& from, const auto& to) {
      const long long dx = to[0] - from[0];
      const long long dy = to[1] - from[1];
      return is("habit-other-edges") ? dy > 0 || (dy == 0 && dx > 0)
                                     : dy < 0 || (dy == 0 && dx < 0);
    };
    const std::array<bool, 3> owned{owns(b, c), owns(c, a), owns(a, b)};
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const std::array<long long, 2> center{(long long)((x + 0.5) * units),
                                              (long long)((y + 0.5) * units)};
        const std::array<__int128, 3> e{doubled(b, c, center), doubled(c, a, center),
                                        doubled(a, b, center)};
        if (std::all_of(e.begin(), e.end(), [](__int128 v) { return v >= 0; }) &&
            (e[0] > 0 || owned[0]) && (e[1] > 0 || owned[1]) && (e[2] > 0 || owned[2])) {
          std::array<float, 3> weights{};
          for (std::size_t k = 0; k < 3; ++k) {
            weights[order[k]] = float(double(e[k]) / double(area));
          }
          fragment(x, y, corners, weights, inverse, z, material);
        }
      }
    }
  }

  void fragment(int x, int y, const std::array<Varying, 3>& corners,
                const std::array<float, 3>& weights, const std::array<float, 3>& inverse,
                const std::array<float, 3>& z, const RenderMaterial& material) {
    float depth = weights[0] * z[0] + weights[1] * z[1] + weights[2] * z[2];
    const float steps = is("habit-depth-16") ? 65535.0f : 16777215.0f;
    depth = std::round(depth * steps) / steps;
    const std::size_t pixel = std::size_t(y) * frame_width_ + x;
    if (!is("no-depth-test") &&
        (is("depth-reversed") ? depth <= depth_[pixel] : depth >= depth_[pixel])) {
      return;
    }
    depth_[pixel] = depth;
    const float sum = weights[0] * inverse[0] + weights[1] * inverse[1] + weights[2] * inverse[2];
    vec3 world(0);
    vec3 normal(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const float w = weights[k] * inverse[k] / sum;
      world += w * corners[k].world;
      normal += w * corners[k].normal;
    }
    vec3 color = is("gouraud") ? normal : phong(world, normal, material);
    if (is("strange-stripes") && (x / 9 + y / 13) % 3 == 0) {
      color *= vec3(0.3f, 0.9f, 0.6f);
    }
    if (is("strange-noise")) {
      color *= 0.5f + 0.5f * float((x * 7919 + y * 104729 + x * y * 31) % 256) / 255;
    }
    if (is("strange-fog")) {
      color = glm::mix(color, vec3(0.5f, 0.55f, 0.6f), 1 - std::exp(-0.05f / sum));
    }
    frame_[pixel] = bytes(color);
    covered_[pixel] = true;
  }

  vec3 bytes(const vec3& color) const {
    const vec3 full = 255.0f * glm::clamp(color, vec3(0), vec3(1));
    return (is("habit-truncate") ? glm::floor(full) : glm::round(full)) / 255.0f;
  }

  vec3 phong(const vec3& world, vec3 normal, const RenderMaterial& m) const {
    if (!is("normals-not-normalized")) {
      normal = glm::normalize(normal);
    }
    vec3 to_eye = glm::normalize(eye_ - world);
    if (is("specular-eye-reversed")) {
      to_eye = -to_eye;
    }
    const RenderGlobal& g = scene_.global;
    const float kd = is("diffuse-no-coefficient") ? 1 : g.diffuse;
    const float ks = is("specular-no-coefficient") ? 1 : g.specular;
    const vec3 ambient = is("ambient-missing") ? vec3(0) : g.ambient * m.ambient;
    vec3 color = is("ambient-each-light") ? float(lights_.size()) * ambient : ambient;
    for (const RenderLight& light : lights_) {
      color = is("lights-replace") ? ambient : color;
      vec3 to_light = -light.direction;
      float fade = 1;
      if (light.type != LightType::directional) {
        to_light = light.position - world;
        const float d = glm::length(to_light);
        to_light /= d;
        const vec3 a = light.attenuation;
        fade = is("attenuation-none")        ? 1
               : is("attenuation-quadratic") ? std::min(1.0f, 1 / (d * d))
                                             : std::min(1.0f, 1 / (a.x + d * (a.y + d * a.z)));
      }
      if (light.type == LightType::spot) {
        const float angle =
            std::acos(std::clamp(glm::dot(-to_light, light.direction), -1.0f, 1.0f));
        float t = (angle - light.inner_angle) / (light.outer_angle - light.inner_angle);
        t = std::clamp(t, 0.0f, 1.0f);
        fade *= is("spot-sharp")    ? (angle < light.outer_angle ? 1.0f : 0.0f)
                : is("spot-linear") ? 1 - t
                                    : 1 - t * t * (3 - 2 * t);
      }
      if (is("lights-reversed")) {
        to_light = -to_light;
      }
      float cosine = glm::dot(normal, to_light);
      const vec3 mirrored = 2 * cosine * normal - to_light;
      float shine = glm::dot(mirrored, to_eye);
      if (is("specular-blinn")) {
        shine = glm::dot(normal, glm::normalize(to_light + to_eye));
      }
      float weight = std::max(0.0f, is("diffuse-absolute") ? std::abs(cosine) : cosine);
      if (is("strange-toon")) {
        weight = std::floor(weight * 3) / 3;
      }
      if (!is("diffuse-missing")) {
        color += fade * light.color * kd * m.diffuse * weight;
      }
      if (shine > 0 && m.shininess > 0 && !is("specular-missing")) {
        color += fade * light.color * ks * m.specular *
                 std::pow(shine, is("specular-no-exponent") ? 1.0f : m.shininess);
      }
    }
    if (is("strange-rim-light")) {
      color += vec3(0.5f, 0.3f, 0.1f) * std::pow(1 - std::abs(glm::dot(normal, to_eye)), 3.0f);
    }
    return color;
  }

  // ---- the frame -----------------------------------------------------------------------------

  vec3 texel(int x, int y) const {
    if (is("border-clamp")) {
      x = std::clamp(x, 0, frame_width_ - 1);
      y = std::clamp(y, 0, frame_height_ - 1);
    }
    x = (x + 8 * frame_width_) % frame_width_;
    y = (y + 8 * frame_height_) % frame_height_;
    return frame_[std::size_t(y) * frame_width_ + x];
  }

  // A linear texture lookup.
  vec3 look_up(float u, float v) const {
    const float x = u * float(frame_width_) - 0.5f;
    const float y = v * float(frame_height_) - 0.5f;
    const int i = int(std::floor(x));
    const int j = int(std::floor(y));
    const float s = x - float(i);
    const float t = y - float(j);
    return glm::mix(glm::mix(texel(i, j), texel(i + 1, j), s),
                    glm::mix(texel(i, j + 1), texel(i + 1, j + 1), s), t);
  }

  vec3 kernel(float u, float v, const std::vector<float>& across, const std::vector<float>& up,
              float step, int shift) const {
    vec3 sum(0);
    const int columns = int(across.size());
    const int rows = int(up.size());
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        sum += across[std::size_t(i)] * up[std::size_t(j)] *
               look_up(u + step * float(i - columns / 2 + shift) / float(frame_width_),
                       v + step * float(j - rows / 2 + shift) / float(frame_height_));
      }
    }
    return sum;
  }

  vec3 blurred(float u, float v) const {
    const auto box = [](std::size_t size, float weight) {
      return std::vector<float>(size, weight);
    };
    if (is("blur-unnormalized")) {
      return kernel(u, v, box(5, 1), box(5, 1), 1, 0);
    }
    if (is("blur-3")) {
      return kernel(u, v, box(3, 1 / 3.0f), box(3, 1 / 3.0f), 1, 0);
    }
    if (is("blur-7")) {
      return kernel(u, v, box(7, 1 / 7.0f), box(7, 1 / 7.0f), 1, 0);
    }
    if (is("blur-across")) {
      return kernel(u, v, box(5, 0.2f), box(1, 1), 1, 0);
    }
    if (is("blur-triangle")) {
      const std::vector<float> row{1 / 9.0f, 2 / 9.0f, 3 / 9.0f, 2 / 9.0f, 1 / 9.0f};
      return kernel(u, v, row, row, 1, 0);
    }
    if (is("blur-gaussian")) {
      std::vector<float> row;
      float sum = 0;
      for (int i = -2; i <= 2; ++i) {
        row.push_back(std::exp(-0.5f * float(i * i)));
        sum += row.back();
      }
      for (float& w : row) {
        w /= sum;
      }
      return kernel(u, v, row, row, 1, 0);
    }
    return kernel(u, v, box(5, 0.2f), box(5, 0.2f), is("blur-step-two") ? 2 : 1,
                  is("blur-uncentered") ? 2 : 0);
  }

  vec3 sharpened(float u, float v) const {
    const float su = 1 / float(frame_width_);
    const float sv = 1 / float(frame_height_);
    vec3 sum(0);
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        float weight = i == 0 && j == 0 ? 17.0f / 9 : -1.0f / 9;
        if (is("sharpen-unnormalized")) {
          weight *= 9;
        } else if (is("sharpen-5")) {
          weight = i == 0 && j == 0 ? 5 : i == 0 || j == 0 ? -1 : 0;
        }
        sum += weight * look_up(u + float(i) * su, v + float(j) * sv);
      }
    }
    return sum;
  }

  Texture finish() const {
    Texture picture;
    picture.width = job_.width;
    picture.height = job_.height;
    const std::string filter = is("no-filter") ? "none" : job_.filter;
    for (int row = 0; row < job_.height; ++row) {
      for (int column = 0; column < job_.width; ++column) {
        int x = is("picture-mirrored") ? job_.width - 1 - column : column;
        const int y = is("picture-upside-down") ? row : job_.height - 1 - row;
        if (is("strange-bent")) {
          x = std::clamp(x + int(12 * std::sin(float(y) / 40)), 0, job_.width - 1);
        }
        const float u = (float(x) + 0.5f) / float(job_.width);
        const float v = (float(y) + 0.5f) / float(job_.height);
        vec3 color = look_up(u, v);
        if (filter == "invert") {
          const auto place = std::size_t(v * float(frame_height_)) * frame_width_ +
                             std::size_t(u * float(frame_width_));
          color = is("invert-objects") && !covered_[place] ? color : vec3(1) - color;
        } else if (filter == "grayscale") {
          color = vec3(
              glm::dot(color, is("gray-mean") ? vec3(1 / 3.0f) : vec3(0.299f, 0.587f, 0.114f)));
        } else if (filter == "blur") {
          color = blurred(u, v);
        } else if (filter == "sharpen") {
          color = sharpened(u, v);
        }
        if (is("gamma")) {
          color = glm::pow(glm::clamp(color, vec3(0), vec3(1)), vec3(1 / 2.2f));
        }
        if (is("strange-posterized")) {
          color = glm::round(color * 5.0f) / 5.0f;
        }
        if (is("channels-bgr")) {
          std::swap(color.x, color.z);
        }
        for (int k = 0; k < 3; ++k) {
          picture.rgb.push_back(
              std::uint8_t(std::lround(255 * std::clamp(bytes(color)[k], 0.0f, 1.0f))));
        }
      }
    }
    return picture;
  }

  const RenderScene& scene_;
  const RealtimeJob& job_;
  Made made_;
  int wedges_ = 5;
  int window_width_ = 0;
  int window_height_ = 0;
  int frame_width_ = 0;
  int frame_height_ = 0;
  int view_width_ = 0;
  int view_height_ = 0;
  int objects_ = 0;
  std::array<Buffer, 5> buffers_;
  mat4 view_{1};
  mat4 projection_{1};
  vec3 eye_{0};
  float near_ = 0;
  float far_ = 0;
  std::vector<RenderLight> lights_;
  std::vector<vec3> frame_;  // row 0 is the lowest
  std::vector<bool> covered_;
  std::vector<float> depth_;
};

}  // namespace

std::span<const KnownMistake> known_realtime_mistakes() {
  return mistakes;
}

Texture draw_realtime(const RenderScene& scene, const RealtimeJob& job) {
  return Program(scene, job).run();
}

}  // namespace scenefile::student
