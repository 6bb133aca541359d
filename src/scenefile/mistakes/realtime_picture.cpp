#include "scenefile/mistakes/realtime_picture.h"

#include "scenefile/geometry/realtime_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

using std::numbers::pi;

double cross(const dvec2& a, const dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

dvec3 unit(const dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : v;
}

double to_byte(double value) {
  return std::round(std::clamp(std::isnan(value) ? 0 : value, 0.0, 1.0) * 255) / 255;
}

// ---- shapes ----------------------------------------------------------------------------------

// The face of a triangle, as ModelHit::face: all of its normals are along one axis.
int face_of(Shape shape, const Mesh& mesh, std::size_t triangle) {
  for (int axis = 0; axis < 3 && shape != Shape::sphere; ++axis) {
    const auto& corners = mesh.triangle_normals[triangle];
    const bool along = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t n) {
      return std::abs(std::abs(mesh.normals[n][axis]) - 1) < 1e-6f;
    });
    if (along && shape == Shape::cube) {
      return 2 * axis + (mesh.normals[corners[0]][axis] > 0 ? 1 : 2);
    }
    if (along && axis == 1) {  // of caps
      return mesh.normals[corners[0]].y > 0 ? 1 : 2;
    }
  }
  return 0;
}

// Whether a student's shapes lack the face.
bool lacks_face(Shape shape, int face, const ModelMistakes& m) {
  if (shape == Shape::cube) {
    return face == m.missing_face;
  }
  const bool top = face == 1;
  return face != 0 &&
         ((shape == Shape::cylinder ? m.no_cylinder_caps : m.no_cone_cap) ||
          (top && m.shape == ShapeMistake::no_top_cap) ||
          (!top && m.shape == ShapeMistake::no_bottom_cap) ||
          (!top && m.shape == ShapeMistake::no_cylinder_bottom && shape == Shape::cylinder));
}

// Splits quads, which are two triangles in sequence, along their other diagonal. Triangles at a
// pole follow each other, too, but their corners are not on two circles.
void split_otherwise(Shape shape, Mesh& mesh) {
  const auto on_one_circle = [&](std::uint32_t a, std::uint32_t b) {
    const glm::vec3& p = mesh.positions[a];
    const glm::vec3& q = mesh.positions[b];
    return std::abs(p.y - q.y) < 1e-6f &&
           std::abs(std::hypot(p.x, p.z) - std::hypot(q.x, q.z)) < 1e-6f;
  };
  for (std::size_t i = 0; i + 1 < mesh.triangles.size(); ++i) {
    auto& first = mesh.triangles[i];
    auto& second = mesh.triangles[i + 1];
    if (first[0] == second[0] && first[2] == second[1] &&
        (shape == Shape::cube || on_one_circle(first[0], second[2]))) {
      auto& first_normals = mesh.triangle_normals[i];
      auto& second_normals = mesh.triangle_normals[i + 1];
      // (a, b, c), (a, c, d) become (a, b, d), (b, c, d).
      const std::array corner{first[0], first[1], first[2], second[2]};
      const std::array normal{first_normals[0], first_normals[1], first_normals[2],
                              second_normals[2]};
      first = {corner[0], corner[1], corner[3]};
      second = {corner[1], corner[2], corner[3]};
      first_normals = {normal[0], normal[1], normal[3]};
      second_normals = {normal[1], normal[2], normal[3]};
      ++i;
    }
  }
}

void turn(Mesh& mesh, double angle, bool clockwise) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const auto moved = [&](const glm::vec3& v) {
    const double z = clockwise ? -double(v.z) : double(v.z);
    return glm::vec3(c * v.x + s * z, v.y, -s * v.x + c * z);
  };
  std::transform(mesh.positions.begin(), mesh.positions.end(), mesh.positions.begin(), moved);
  std::transform(mesh.normals.begin(), mesh.normals.end(), mesh.normals.begin(), moved);
  if (clockwise) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
      std::swap(mesh.triangle_normals[i][1], mesh.triangle_normals[i][2]);
    }
  }
}

glm::vec3 cone_normal(const glm::vec3& right, const glm::vec3& position,
                      ConeNormalMistake mistake) {
  const double x = 0.5 * right.x;  // (2 cos, 1, 2 sin) normalized is (x, slope, z) times 4 / sqrt 5
  const double z = 0.5 * right.z;
  const double slope = 0.5 * right.y;
  switch (mistake) {
    case ConeNormalMistake::level:
      return unit({x, 0, z});
    case ConeNormalMistake::like_sphere:
      return unit(dvec3(position));
    case ConeNormalMistake::half_slope:
      return unit({x, slope / 2, z});
    case ConeNormalMistake::double_slope:
      return unit({x, 2 * slope, z});
    case ConeNormalMistake::four_slopes:
      return unit({x, 4 * slope, z});
    case ConeNormalMistake::slope_down:
      return unit({x, -slope, z});
    case ConeNormalMistake::constant_y:
    case ConeNormalMistake::half_constant_y: {
      const double y = mistake == ConeNormalMistake::constant_y ? 0.5 : 0.25;
      return unit({position.x, y, position.z});
    }
    case ConeNormalMistake::from_apex:
      return unit({position.x, position.y - 0.5, position.z});
    case ConeNormalMistake::none:
      break;
  }
  return right;
}

// Changes each side normal of a cone, with the corner that it belongs to.
void change_cone(Mesh& mesh, const RealtimeTrial& trial) {
  const ConeNormalMistake mistake = trial.scene.mistakes.cone_normal;
  if (mistake == ConeNormalMistake::none && !trial.mesh.tip_up && !trial.mesh.tip_of_first) {
    return;
  }
  const std::vector<glm::vec3> right = mesh.normals;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (face_of(Shape::cone, mesh, i) != 0) {
      continue;
    }
    const auto before = mesh.triangle_normals[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 position = mesh.positions[mesh.triangles[i][k]];
      glm::vec3 normal = cone_normal(right[before[k]], position, mistake);
      if (position.y > 0.4999f && trial.mesh.tip_up) {
        normal = {0, 1, 0};
      } else if (position.y > 0.4999f && trial.mesh.tip_of_first) {
        normal = right[before[(k + 1) % 3]];
      }
      mesh.triangle_normals[i][k] = static_cast<std::uint32_t>(mesh.normals.size());
      mesh.normals.push_back(normal);
    }
  }
}

// The normal of a corner with the mistake, or `right`. All normals at a cone's tip are at the same
// position, so those of its side are changed, not computed.
glm::vec3 corner_normal(Shape shape, int face, const glm::vec3& right, const glm::vec3& position,
                        const ModelMistakes& m) {
  if (m.shape == ShapeMistake::none && !m.cap_normals_down) {
    return right;
  }
  if (shape == Shape::cone && face == 0 && m.shape != ShapeMistake::like_sphere) {
    const bool inward = m.shape == ShapeMistake::cone_normals_inward ||
                        m.shape == ShapeMistake::side_normals_inward;
    return inward ? -right : right;
  }
  return unit(
      shape_normal(shape, face, dvec3(position), m.cone_normal, m.cap_normals_down, m.shape));
}

Mesh student_mesh(Shape shape, const RealtimeTrial& trial) {
  const TessellationParameters parameters =
      trial.tessellation[static_cast<std::size_t>(shape)].value_or(trial.panel.tessellation);
  Mesh mesh = realtime_mesh(shape, parameters);
  const MeshMistakes& m = trial.mesh;
  const ModelMistakes& common = trial.scene.mistakes;
  if (m.other_diagonal) {
    split_otherwise(shape, mesh);
  }
  if (m.quarter_turns != 0 || m.half_wedge || m.clockwise) {
    const int wedges = std::max(3, parameters.parameter2);
    if (shape != Shape::cube) {
      turn(mesh, m.quarter_turns * pi / 2 + (m.half_wedge ? pi / wedges : 0), m.clockwise);
    }
  }
  if (shape == Shape::cone) {
    change_cone(mesh, trial);
  }
  const auto index = static_cast<std::size_t>(shape);
  const int wedges = std::max(3, parameters.parameter2);
  const int rows = std::max(shape == Shape::sphere ? 2 : 1, parameters.parameter1);
  Mesh kept = mesh;
  kept.triangles.clear();
  kept.triangle_normals.clear();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const int face = face_of(shape, mesh, i);
    const bool cap = face != 0 && shape != Shape::cube;
    std::array<std::uint32_t, 3> corners = mesh.triangles[i];
    std::array<std::uint32_t, 3> normals = mesh.triangle_normals[i];
    const glm::vec3 center =
        (mesh.positions[corners[0]] + mesh.positions[corners[1]] + mesh.positions[corners[2]]) /
        3.0f;
    double angle = std::atan2(-double(center.z), double(center.x)) / (2 * pi);
    angle -= std::floor(angle);
    const bool last_wedge = shape != Shape::cube && angle > (wedges - 1.0) / wedges;
    const bool last_row =
        shape == Shape::sphere
            ? std::acos(std::clamp(double(center.y) / glm::length(dvec3(center)), -1.0, 1.0)) >
                  pi * (rows - 1.0) / rows
            : shape != Shape::cube && !cap && center.y < -0.5f + 1.0f / float(rows);
    if (lacks_face(shape, face, common) || (m.seam_missing && last_wedge) ||
        (m.last_row_missing && last_row)) {
      continue;
    }
    if (cap ? trial.inside_out.caps[index] : trial.inside_out.sides[index]) {
      std::swap(corners[1], corners[2]);
      std::swap(normals[1], normals[2]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 right = mesh.normals[normals[k]];
      const glm::vec3 normal =
          corner_normal(shape, face, right, mesh.positions[corners[k]], common);
      if (normal != right) {
        kept.normals.push_back(normal);
        normals[k] = static_cast<std::uint32_t>(kept.normals.size() - 1);
      }
    }
    kept.triangles.push_back(corners);
    kept.triangle_normals.push_back(normals);
  }
  if (m.radius_one) {
    for (glm::vec3& p : kept.positions) {
      p *= 2.0f;
    }
  }
  return kept;
}

// ---- rasterization ---------------------------------------------------------------------------

// Coordinates along the camera's axes, which need not be perpendicular: right, up, depth.
struct CameraAxes {
  dvec3 position;
  glm::dmat3 inverse;
  explicit CameraAxes(const RenderCamera& c)
      : position(c.position), inverse(glm::inverse(glm::dmat3(c.u, c.v, -c.w))) {}
  dvec3 of(const dvec3& world) const { return inverse * (world - position); }
};

struct Corner {
  dvec3 at;  // right, up, depth
};

struct Polygon {
  std::array<Corner, 6> corners;
  std::size_t count = 0;
};

// Clips to what is farther than `depth` (side 1) or nearer (side -1).
Polygon clipped(const Polygon& polygon, double depth, double side) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Corner& a = polygon.corners[i];
    const Corner& b = polygon.corners[(i + 1) % polygon.count];
    const double in_a = side * (a.at.z - depth);
    const double in_b = side * (b.at.z - depth);
    if (in_a >= 0) {
      result.corners[result.count++] = a;
    }
    if ((in_a >= 0) != (in_b >= 0)) {
      result.corners[result.count++] = {a.at + in_a / (in_a - in_b) * (b.at - a.at)};
    }
  }
  return result;
}

class Rasterizer {
 public:
  Rasterizer(const RealtimeTrial& trial, const Assets& assets, Visibility& to,
             const PixelRegion& only)
      : trial_(trial),
        assets_(assets),
        to_(to),
        only_(only),
        axes_(trial.scene.scene.camera),
        tan_y_(std::tan(trial.scene.scene.camera.fov_y / 2)),
        tan_x_(tan_y_ * to.aspect) {
    depth_.assign(to.seen.size(), trial.depth == DepthTest::reversed ? -1.0f : 0xffffff);
  }

  void draw(std::uint32_t part_index) {
    const ModelPart& part = to_.shapes->parts[part_index];
    const Mesh& mesh = to_.mesh_of({part_index, 0}, assets_);
    if (part.shape != Shape::mesh && misses(part)) {
      return;
    }
    corners_.clear();
    for (const glm::vec3& p : mesh.positions) {
      corners_.push_back({axes_.of(part.world_from_object.point(dvec3(p)))});
    }
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      Polygon polygon{{corners_[t[0]], corners_[t[1]], corners_[t[2]]}, 3};
      const double nearest =
          std::min({polygon.corners[0].at.z, polygon.corners[1].at.z, polygon.corners[2].at.z});
      const double farthest =
          std::max({polygon.corners[0].at.z, polygon.corners[1].at.z, polygon.corners[2].at.z});
      if (nearest < trial_.panel.near) {
        polygon = clipped(polygon, trial_.panel.near, 1);
      }
      if (farthest > trial_.panel.far) {
        polygon = clipped(polygon, trial_.panel.far, -1);
      }
      const auto number = static_cast<std::uint32_t>(to_.triangles.size());
      bool any = false;
      for (std::size_t k = 2; k < polygon.count; ++k) {
        any = fill(polygon.corners[0], polygon.corners[k - 1], polygon.corners[k], number) || any;
      }
      if (any) {
        to_.triangles.push_back({part_index, i});
      }
    }
  }

 private:
  dvec2 window(const Corner& c) const {
    const dvec2 place((c.at.x / (c.at.z * tan_x_) + 1) / 2 * to_.viewport_width,
                      (c.at.y / (c.at.z * tan_y_) + 1) / 2 * to_.viewport_height);
    return glm::round(place * 256.0) / 256.0;
  }

  // Whether no pixel to be drawn can show the shape.
  bool misses(const ModelPart& part) const {
    const double side = trial_.mesh.radius_one ? 1 : 0.5;
    dvec2 low(1e300);
    dvec2 high(-1e300);
    for (int i = 0; i < 8; ++i) {
      const dvec3 corner((i & 1) != 0 ? side : -side, (i & 2) != 0 ? side : -side,
                         (i & 4) != 0 ? side : -side);
      const Corner c{axes_.of(part.world_from_object.point(corner))};
      if (!(c.at.z > trial_.panel.near)) {
        return false;
      }
      low = glm::min(low, window(c));
      high = glm::max(high, window(c));
    }
    return high.x < only_.x0 || high.y < only_.y0 || low.x > only_.x1 || low.y > only_.y1;
  }

  // The top-left rule: whether a pixel center on the edge belongs to the triangle. Left edges go
  // down, top edges go left.
  static bool owns(const dvec2& edge) { return edge.y < 0 || (edge.y == 0 && edge.x < 0); }

  // Whether a pixel shows the triangle.
  bool fill(const Corner& a, const Corner& b, const Corner& c, std::uint32_t number) {
    std::array<dvec2, 3> p{window(a), window(b), window(c)};
    std::array<double, 3> inverse_depth{1 / a.at.z, 1 / b.at.z, 1 / c.at.z};
    double area = cross(p[1] - p[0], p[2] - p[0]);
    const bool front = area > 0;
    if (!std::isfinite(area) || area == 0 ||
        (front ? trial_.culling == Culling::front : trial_.culling == Culling::back)) {
      return false;
    }
    if (!front) {
      std::swap(p[1], p[2]);
      std::swap(inverse_depth[1], inverse_depth[2]);
      area = -area;
    }
    const dvec2 low = glm::min(glm::min(p[0], p[1]), p[2]);
    const dvec2 high = glm::max(glm::max(p[0], p[1]), p[2]);
    if (!(high.x > only_.x0 && high.y > only_.y0 && low.x < only_.x1 && low.y < only_.y1)) {
      return false;
    }
    const int x0 = low.x > only_.x0 ? static_cast<int>(low.x) : only_.x0;
    const int y0 = low.y > only_.y0 ? static_cast<int>(low.y) : only_.y0;
    const int x1 = high.x < only_.x1 ? static_cast<int>(high.x) : only_.x1 - 1;
    const int y1 = high.y < only_.y1 ? static_cast<int>(high.y) : only_.y1 - 1;
    std::array<dvec2, 3> edge;
    std::array<bool, 3> owned{};
    for (std::size_t k = 0; k < 3; ++k) {
      edge[k] = p[(k + 2) % 3] - p[(k + 1) % 3];
      owned[k] = owns(edge[k]);
    }
    const double n = trial_.panel.near;
    const double f = trial_.panel.far;
    bool any = false;
    for (int y = y0; y <= y1; ++y) {
      const dvec2 start(x0 + 0.5, y + 0.5);
      std::array<double, 3> weight{};
      for (std::size_t k = 0; k < 3; ++k) {
        weight[k] = cross(edge[k], start - p[(k + 1) % 3]);
      }
      // The range of columns where all three barycentric weights are positive, one column wider.
      double first = 0;
      double last = x1 - x0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double slope = -edge[k].y;
        if (slope > 0) {
          first = std::max(first, std::floor(-weight[k] / slope));
        } else if (slope < 0) {
          last = std::min(last, std::ceil(-weight[k] / slope));
        }
      }
      if (!(first <= last)) {
        continue;
      }
      for (int x = x0 + static_cast<int>(first); x <= x0 + static_cast<int>(last); ++x) {
        const double along = x - x0;
        bool inside = true;
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double w = weight[k] - along * edge[k].y;
          inside = inside && (w > 0 || (w == 0 && owned[k]));
          sum += w * inverse_depth[k];
        }
        if (!inside) {
          continue;
        }
        const auto depth =
            static_cast<float>(std::round((f - f * n * sum / area) / (f - n) * 0xffffff));
        float& known = depth_[std::size_t(y) * to_.width + x];
        if (trial_.depth == DepthTest::none ||
            (trial_.depth == DepthTest::less ? depth < known : depth > known)) {
          known = depth;
          to_.seen[std::size_t(y) * to_.width + x] = number;
          any = true;
        }
      }
    }
    return any;
  }

  const RealtimeTrial& trial_;
  const Assets& assets_;
  Visibility& to_;
  const PixelRegion only_;  // inside the viewport
  CameraAxes axes_;
  double tan_y_;
  double tan_x_;
  std::vector<Corner> corners_;
  std::vector<float> depth_;  // 24 bits
};

}  // namespace

bool occurs_in_meshes(ShapeMistake mistake) {
  switch (mistake) {
    case ShapeMistake::none:
    case ShapeMistake::no_top_cap:
    case ShapeMistake::no_bottom_cap:
    case ShapeMistake::no_cylinder_bottom:
    case ShapeMistake::cylinder_normal_like_sphere:
    case ShapeMistake::cube_normals_positive:
    case ShapeMistake::cap_normals_up:
    case ShapeMistake::cap_normals_like_side:
    case ShapeMistake::sphere_normals_by_matrix:
    case ShapeMistake::like_sphere:
    case ShapeMistake::cube_normals_like_sphere:
    case ShapeMistake::sphere_normals_inward:
    case ShapeMistake::cube_normals_inward:
    case ShapeMistake::cylinder_normals_inward:
    case ShapeMistake::cone_normals_inward:
    case ShapeMistake::side_normals_inward:
      return true;
    case ShapeMistake::square_caps:
    case ShapeMistake::endless_cylinder:
    case ShapeMistake::endless_cone:
    case ShapeMistake::double_cone:
    case ShapeMistake::deep_cone:
    case ShapeMistake::endless:
    case ShapeMistake::caps_square_half:
    case ShapeMistake::cylinder_square_half:
    case ShapeMistake::cylinder_sides_wide:
    case ShapeMistake::roots_doubled:
    case ShapeMistake::precedence:
    case ShapeMistake::wide_caps:
    case ShapeMistake::wide_cone:
      return false;
  }
  return false;
}

FilterSteps steps_of(Filter filter) {
  FilterSteps steps;
  switch (filter) {
    case Filter::none:
      break;
    case Filter::invert:
      steps.colors = glm::dmat3(-1);
      steps.added = dvec3(1);
      break;
    case Filter::grayscale:
      steps.colors = glm::dmat3(dvec3(0.299), dvec3(0.587), dvec3(0.114));
      break;
    case Filter::blur:
      steps.columns = steps.rows = 5;
      steps.weights.assign(25, 1 / 25.0);
      break;
    case Filter::sharpen:
      steps.columns = steps.rows = 3;
      steps.weights.assign(9, -1 / 9.0);
      steps.weights[4] = 17 / 9.0;
      break;
  }
  return steps;
}

std::shared_ptr<const RealtimeShapes> realtime_shapes(const RenderScene& scene, double most) {
  if (!(count_virtual_primitives(scene) <= most)) {
    return nullptr;
  }
  auto shapes = std::make_shared<RealtimeShapes>();
  std::vector<std::pair<std::uint32_t, DAffine>> open{{scene.root, DAffine()}};
  while (!open.empty()) {
    const auto [index, world_from_group] = open.back();
    open.pop_back();
    const RenderGroup& group = scene.groups[index];
    for (const RenderPrimitive& p : group.primitives) {
      const DAffine world_from_object = world_from_group * DAffine(p.group_from_object);
      shapes->parts.push_back(
          {world_from_object, inverse(world_from_object), p.shape, p.mesh, p.material, p.source});
      shapes->counts[static_cast<std::size_t>(p.shape)] += 1;
    }
    for (std::size_t i = group.instances.size(); i-- > 0;) {
      const RenderInstance& instance = group.instances[i];
      open.emplace_back(instance.group, world_from_group * DAffine(instance.group_from_instance));
    }
  }
  return shapes;
}

const Mesh& Visibility::mesh_of(const Triangle& t, const Assets& assets) const {
  const ModelPart& part = shapes->parts[t.part];
  return part.shape == Shape::mesh ? assets.meshes[part.mesh]
                                   : meshes[static_cast<std::size_t>(part.shape)];
}

std::array<dvec3, 3> Visibility::corners(const Triangle& t, const Assets& assets) const {
  const Mesh& mesh = mesh_of(t, assets);
  const ModelPart& part = shapes->parts[t.part];
  std::array<dvec3, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = part.world_from_object.point(dvec3(mesh.positions[mesh.triangles[t.index][k]]));
  }
  return result;
}

std::shared_ptr<const Visibility> find_visible(const RealtimeTrial& trial,
                                               std::shared_ptr<const RealtimeShapes> shapes,
                                               const Assets& assets, int width, int height,
                                               const std::optional<PixelRegion>& only) {
  auto visible = std::make_shared<Visibility>();
  Visibility& v = *visible;
  const RealtimeWindow window = realtime_window(width, height);
  const dvec2 picture(width, height);
  const RealtimeWindow framed = realtime_frame(trial.panel.milestone, width, height);
  const dvec2 frame = glm::max(
      dvec2(1), glm::round(trial.frame.frame.value_or(dvec2(framed.width, framed.height))));
  const dvec2 viewport = glm::max(dvec2(1), glm::round(trial.frame.viewport.value_or(picture)));
  v.width = static_cast<int>(frame.x);
  v.height = static_cast<int>(frame.y);
  v.viewport_width = static_cast<int>(viewport.x);
  v.viewport_height = static_cast<int>(viewport.y);
  v.aspect = trial.frame.aspect.value_or(double(window.width) / window.height);
  v.seen.assign(std::size_t(v.width) * v.height, Visibility::nothing);
  v.shapes = std::move(shapes);
  for (std::size_t i = 0; i < shape_count; ++i) {
    const auto shape = static_cast<Shape>(i);
    if (shape != Shape::mesh && v.shapes->counts[i] > 0) {
      v.meshes[i] = student_mesh(shape, trial);
    }
  }
  PixelRegion drawn{0, 0, std::min(v.width, v.viewport_width),
                    std::min(v.height, v.viewport_height)};
  if (only) {
    drawn = {std::max(drawn.x0, only->x0), std::max(drawn.y0, only->y0),
             std::min(drawn.x1, only->x1), std::min(drawn.y1, only->y1)};
  }
  Rasterizer rasterizer(trial, assets, v, drawn);
  for (std::uint32_t i = 0; i < v.shapes->parts.size(); ++i) {
    rasterizer.draw(i);
  }
  return visible;
}

// ---- colors ----------------------------------------------------------------------------------

RealtimePicture::RealtimePicture(const RealtimeTrial& trial,
                                 std::shared_ptr<const Visibility> visible, const Assets& assets,
                                 int width, int height)
    : trial_(trial),
      visible_(std::move(visible)),
      assets_(assets),
      width_(width),
      height_(height),
      filter_(trial.filter ? *trial.filter : steps_of(trial.panel.filter)),
      options_(trial.scene.options) {
  options_.mode = Mode::ray;
  options_.features = {false, false, false, false, false, false, false};
  model_ = std::make_unique<Model>(trial_.scene.scene, no_shapes_, assets_, options_,
                                   trial_.scene.mistakes);
}

dvec3 RealtimePicture::weights_at(int x, int y, const std::array<dvec3, 3>& corners,
                                  dvec3& position) const {
  const RenderCamera& camera = trial_.scene.scene.camera;
  const double tan_y = std::tan(camera.fov_y / 2);
  const double right = ((x + 0.5) / visible_->viewport_width * 2 - 1) * tan_y * visible_->aspect;
  const double up = ((y + 0.5) / visible_->viewport_height * 2 - 1) * tan_y;
  const dvec3 direction = right * camera.u + up * camera.v - camera.w;
  const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double slope = glm::dot(normal, direction);
  const double t = glm::dot(normal, corners[0] - camera.position) / slope;
  if (!std::isfinite(t)) {
    position = (corners[0] + corners[1] + corners[2]) / 3.0;
    return dvec3(1 / 3.0);
  }
  position = camera.position + t * direction;
  const double all = glm::dot(normal, normal);
  const double b = glm::dot(glm::cross(corners[2] - position, corners[0] - position), normal) / all;
  const double c = glm::dot(glm::cross(corners[0] - position, corners[1] - position), normal) / all;
  return {1 - b - c, b, c};
}

dvec3 RealtimePicture::normal_of(const ModelPart& part, const Mesh& mesh, std::uint32_t index,
                                 int corner, dvec3& in_object) const {
  const auto& triangle = mesh.triangles[index];
  Interpolation interpolation = trial_.interpolation;
  if (!trial_.interpolated_shapes[static_cast<std::size_t>(part.shape)]) {
    interpolation = Interpolation::normals;
  }
  if (interpolation == Interpolation::first_corner) {
    corner = 0;
  } else if (interpolation == Interpolation::last_corner) {
    corner = 2;
  }
  const std::uint32_t known =
      mesh.triangle_normals.empty() ? mesh_no_index : mesh.triangle_normals[index][corner];
  if (known == mesh_no_index || interpolation == Interpolation::flat) {
    const dvec3 a(mesh.positions[triangle[0]]);
    in_object = unit(
        glm::cross(dvec3(mesh.positions[triangle[1]]) - a, dvec3(mesh.positions[triangle[2]]) - a));
    // Also of triangles with the wrong winding order.
    if (known != mesh_no_index && glm::dot(in_object, dvec3(mesh.normals[known])) < 0) {
      in_object = -in_object;
    }
  } else {
    in_object = unit(dvec3(mesh.normals[known]));
  }
  const ModelMistakes& m = trial_.scene.mistakes;
  const bool by_matrix =
      part.shape == Shape::sphere && m.shape == ShapeMistake::sphere_normals_by_matrix;
  return transformed_normal(part, in_object, by_matrix ? NormalMistake::by_matrix : m.normals);
}

bool RealtimePicture::normalizes() const {
  return trial_.interpolation != Interpolation::not_normalized &&
         !keeps_length(trial_.scene.mistakes.normals);
}

ShownPoint RealtimePicture::point_at(const glm::ivec2& at) const {
  const Visibility::Triangle& t =
      visible_->triangles[visible_->seen[std::size_t(at.y) * visible_->width + at.x]];
  const ModelPart& part = visible_->shapes->parts[t.part];
  const Mesh& mesh = visible_->mesh_of(t, assets_);
  ShownPoint point;
  point.material = part.material;
  const dvec3 weights = weights_at(at.x, at.y, visible_->corners(t, assets_), point.position);
  for (int k = 0; k < 3; ++k) {
    dvec3 in_object;
    dvec3 normal = normal_of(part, mesh, t.index, k, in_object);
    if (trial_.interpolation == Interpolation::not_normalized) {
      normal = unit(normal);
    }
    point.normal += weights[k] * normal;
    point.object_normal += weights[k] * in_object;
  }
  if (normalizes()) {
    point.normal = unit(point.normal);
  }
  return point;
}

dvec3 RealtimePicture::frame_color(int x, int y) const {
  const std::uint32_t number = visible_->seen[std::size_t(y) * visible_->width + x];
  if (number == Visibility::nothing) {
    return trial_.scene.mistakes.background;
  }
  if (trial_.interpolation != Interpolation::colors) {
    return model_->lit(point_at({x, y}));
  }
  const Visibility::Triangle& t = visible_->triangles[number];
  const ModelPart& part = visible_->shapes->parts[t.part];
  const Mesh& mesh = visible_->mesh_of(t, assets_);
  const std::array<dvec3, 3> corners = visible_->corners(t, assets_);
  dvec3 position;
  const dvec3 weights = weights_at(x, y, corners, position);
  dvec3 color(0);
  for (int k = 0; k < 3; ++k) {
    dvec3 in_object;
    const dvec3 normal = normal_of(part, mesh, t.index, k, in_object);
    color += weights[k] *
             clamped(model_->lit({corners[std::size_t(k)], normalizes() ? unit(normal) : normal,
                                  in_object, part.material}));
  }
  return color;
}

dvec3 RealtimePicture::texel(const glm::ivec2& at) const {
  if (at.x < 0 || at.y < 0) {
    return dvec3(0);
  }
  const dvec3 color = frame_color(at.x, at.y);
  return {to_byte(color.x), to_byte(color.y), to_byte(color.z)};
}

// The pixel of the frame that is read at this place; negative: none.
glm::ivec2 RealtimePicture::in_frame(int x, int y) const {
  const auto wrapped = [&](int at, int size) {
    switch (filter_.border) {
      case FilterBorder::wrap:
        return (at % size + size) % size;
      case FilterBorder::clamp:
        return std::clamp(at, 0, size - 1);
      case FilterBorder::black:
        return at < 0 || at >= size ? -1 : at;
      case FilterBorder::mirror:
        return std::clamp(at < 0 ? -at - 1 : at >= size ? 2 * size - 1 - at : at, 0, size - 1);
    }
    return 0;
  };
  return {wrapped(x, visible_->width), wrapped(y, visible_->height)};
}

// The position in the frame, in pixels from its lower left.
dvec2 RealtimePicture::place_of(int x, int y) const {
  return {(x + 0.5) / width_ * visible_->width, (height_ - y - 0.5) / height_ * visible_->height};
}

// Calls add(pixel of the frame, weight) for all samples of the filter's kernel, each of which is
// interpolated linearly between the centers of the frame's pixels.
template <typename Add>
void RealtimePicture::for_each_share(int x, int y, const Add& add) const {
  for (int j = 0; j < filter_.rows; ++j) {
    for (int i = 0; i < filter_.columns; ++i) {
      const double kernel = filter_.weights[std::size_t(j) * filter_.columns + i];
      if (kernel == 0) {
        continue;
      }
      const dvec2 step(i - filter_.columns / 2, j - filter_.rows / 2);
      const dvec2 place = place_of(x, y) + filter_.offset + step * filter_.step - 0.5;
      const dvec2 low = glm::floor(place);
      const dvec2 t = place - low;
      for (int v = 0; v < 2; ++v) {
        for (int u = 0; u < 2; ++u) {
          const double weight = (u == 0 ? 1 - t.x : t.x) * (v == 0 ? 1 - t.y : t.y);
          if (weight > 1e-9) {
            add(in_frame(static_cast<int>(low.x) + u, static_cast<int>(low.y) + v),
                kernel * weight);
          }
        }
      }
    }
  }
}

std::vector<FrameShare> RealtimePicture::shares(int x, int y) const {
  std::vector<FrameShare> list;
  for_each_share(x, y, [&](const glm::ivec2& at, double weight) {
    const auto known = std::find_if(list.begin(), list.end(),
                                    [&](const FrameShare& share) { return share.at == at; });
    if (known != list.end()) {
      known->weight += weight;
    } else {
      list.push_back({at, weight});
    }
  });
  return list;
}

dvec3 RealtimePicture::pixel(int x, int y) const {
  dvec3 sum(0);
  for_each_share(x, y, [&](const glm::ivec2& at, double weight) { sum += weight * texel(at); });
  if (filter_.background_left && triangle_at(x, y) == Visibility::nothing) {
    return sum;
  }
  return glm::clamp(filter_.colors * sum + filter_.added, dvec3(0), dvec3(1));
}

std::uint32_t RealtimePicture::triangle_at(int x, int y) const {
  const dvec2 place = place_of(x, y);
  return visible_->seen[std::size_t(place.y) * visible_->width + std::size_t(place.x)];
}

double RealtimePicture::depth_at(int x, int y) const {
  const dvec2 place = place_of(x, y);
  const std::uint32_t number = triangle_at(x, y);
  if (number == Visibility::nothing) {
    return 0;
  }
  dvec3 position;
  weights_at(static_cast<int>(place.x), static_cast<int>(place.y),
             visible_->corners(visible_->triangles[number], assets_), position);
  return CameraAxes(trial_.scene.scene.camera).of(position).z;
}

}  // namespace scenefile
