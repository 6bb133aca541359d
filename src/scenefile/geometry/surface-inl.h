// Normals, texture coordinates and tangents of shapes and meshes, for any number of lanes
// (base/one_lane.h). See surface_at(). No include guard: included once for each number of lanes.

#include "scenefile/geometry/mesh.h"
#include "scenefile/geometry/shapes.h"

#include <cmath>
#include <iterator>
#include <numbers>

namespace scenefile::SCENEFILE_LANES {

/// The direction of a point around the y axis; +x for a point on the axis.
struct Around {
  F cosine, sine;
  F distance;  ///< from the axis
};

inline Around around_axis(const V3& p) {
  const F distance = sqrt(p.x * p.x + p.z * p.z);
  const M beside = distance > splat(0);
  return {select(beside, p.x / distance, splat(1)), select(beside, p.z / distance, splat(0)),
          distance};
}

/// For a point on the sphere or near it.
inline V3 sphere_normal(const V3& p, const Around& around) {
  const F size = sqrt(around.distance * around.distance + p.y * p.y);
  const M nonzero = size > splat(0);
  const F up = select(nonzero, p.y / size, splat(0));
  const F out = select(nonzero, around.distance / size, splat(1));
  return {out * around.cosine, up, out * around.sine};
}

inline V3 cylinder_normal(const Around& around) {
  return {around.cosine, splat(0), around.sine};
}

inline V3 cone_normal(const Around& around) {
  const F size = splat(std::sqrt(5.0));
  const M beside = around.distance > splat(0);
  return select(beside,
                V3{splat(2) * around.cosine / size, splat(1) / size, splat(2) * around.sine / size},
                V3{splat(0), splat(1), splat(0)});
}

/// std::atan2(y, x) for finite numbers, to 2 units in the last place; 0 if both are 0. The rational
/// approximation is that of atan() in Cephes (Moshier, 1989).
inline F angle_of(F y, F x) {
  constexpr double half_turn = std::numbers::pi;
  const F longer = max(abs(x), abs(y));
  const F shorter = min(abs(x), abs(y));
  const M steep = shorter > splat(0.66) * longer;
  const F over = select(steep, shorter - longer, shorter);
  const F under = select(steep, shorter + longer, longer);
  const F t = over / select(under > splat(0), under, splat(1));
  const F z = t * t;
  constexpr double above[] = {-8.750608600031904122785e-1, -1.615753718733365076637e1,
                              -7.500855792314704667340e1, -1.228866684490136173410e2,
                              -6.485021904942025371773e1};
  constexpr double below[] = {1,
                              2.485846490142306297962e1,
                              1.650270098316988542046e2,
                              4.328810604912902668951e2,
                              4.853903996359136964868e2,
                              1.945506571482613964425e2};
  const auto polynomial = [&](const auto& factors) {
    F sum = splat(factors[0]);
    for (std::size_t i = 1; i < std::size(factors); ++i) {
      sum = sum * z + splat(factors[i]);
    }
    return sum;
  };
  const F arc = t + t * (z * polynomial(above) / polynomial(below));
  // Adds the low-order part of pi where it matters.
  const F eighth = select(steep, splat(half_turn / 4) + (arc + splat(3.061616997868383e-17)), arc);
  const F quarter = select(abs(y) > abs(x),
                           splat(half_turn / 2) - (eighth - splat(6.123233995736766e-17)), eighth);
  const F half = select(x < splat(0), splat(half_turn) - quarter, quarter);
  return copysign(half, y);
}

/// The u coordinate on round sides.
inline F around_u(const Around& around) {
  const F turn = splat(2 * std::numbers::pi);
  const F phi = angle_of(around.sine, around.cosine);
  return select(phi < splat(0), -phi / turn, splat(1) - phi / turn);
}

/// The v coordinate on the sphere.
inline F sphere_v(F height, const Around& around) {
  const F latitude = angle_of(height, around.distance);
  return clamp(latitude / splat(std::numbers::pi) + splat(0.5), 0, 1);
}

inline M shape_is(F shape, Shape kind) {
  return shape == splat(static_cast<int>(kind));
}

inline M face_is(F face, Face which) {
  return face == splat(static_cast<int>(which));
}

inline V3 zero3() {
  return {splat(0), splat(0), splat(0)};
}

/// A Surface in each lane.
struct SurfaceLanes {
  V3 normal = zero3();
  F u = splat(0);
  F v = splat(0);
  V3 tangent_u = zero3();
  V3 tangent_v = zero3();
};

inline SurfaceLanes select(M m, const SurfaceLanes& yes, const SurfaceLanes& no) {
  return {select(m, yes.normal, no.normal), select(m, yes.u, no.u), select(m, yes.v, no.v),
          select(m, yes.tangent_u, no.tangent_u), select(m, yes.tangent_v, no.tangent_v)};
}

inline V3 shape_normal(F shape, F face, const V3& p) {
  const auto is = [&](Face a, Face b) { return face_is(face, a) | face_is(face, b); };
  const auto axis = [&](M positive, M negative) {
    return select(positive, splat(1), select(negative, splat(-1), splat(0)));
  };
  V3 normal{axis(is(Face::pos_x, Face::pos_x), is(Face::neg_x, Face::neg_x)),
            axis(is(Face::pos_y, Face::top), is(Face::neg_y, Face::bottom)),
            axis(is(Face::pos_z, Face::pos_z), is(Face::neg_z, Face::neg_z))};
  const M round = face_is(face, Face::side);
  if (none(round)) {
    return normal;
  }
  const Around around = around_axis(p);
  static_assert(shape_count == 5, "a new shape needs its normal here and its (u, v) below");
  const auto sides = [&](Shape kind) { return round & shape_is(shape, kind); };
  normal = select(sides(Shape::sphere), sphere_normal(p, around), normal);
  normal = select(sides(Shape::cylinder), cylinder_normal(around), normal);
  return select(sides(Shape::cone), cone_normal(around), normal);
}

// Faces of the cube around the y axis, and faces that are seen from below.
inline M upright(F face) {
  return face_is(face, Face::pos_x) | face_is(face, Face::neg_x) | face_is(face, Face::pos_z) |
         face_is(face, Face::neg_z);
}
inline M seen_from_below(F face) {
  return face_is(face, Face::bottom) | face_is(face, Face::neg_y);
}

inline void set_shape_uv(F shape, F face, const V3& p, SurfaceLanes& surface) {
  F along = select(face_is(face, Face::pos_x), -p.z, p.x);
  along = select(face_is(face, Face::neg_x), p.z, select(face_is(face, Face::neg_z), -p.x, along));
  const F up = select(upright(face), p.y, select(seen_from_below(face), p.z, -p.z));
  surface.u = clamp(along + splat(0.5), 0, 1);
  surface.v = clamp(up + splat(0.5), 0, 1);
  const M round = face_is(face, Face::side);
  if (none(round)) {
    return;
  }
  const Around around = around_axis(p);
  const M ball = round & shape_is(shape, Shape::sphere);
  surface.u = select(round, around_u(around), surface.u);
  surface.v = select(round, clamp(p.y + splat(0.5), 0, 1), surface.v);
  surface.v = select(ball, sphere_v(p.y, around), surface.v);
}

inline void set_shape_tangents(F shape, F face, const V3& p, SurfaceLanes& surface) {
  const auto is = [&](Face which) { return face_is(face, which); };
  const auto number = [](M m, double yes, F no) { return select(m, splat(yes), no); };
  const F zero = splat(0);
  const M sideways = is(Face::pos_x) | is(Face::neg_x);
  surface.tangent_u = {number(sideways, 0, number(is(Face::neg_z), -1, splat(1))), zero,
                       number(is(Face::pos_x), -1, number(is(Face::neg_x), 1, zero))};
  surface.tangent_v = {zero, number(upright(face), 1, zero),
                       number(upright(face), 0, number(seen_from_below(face), 1, splat(-1)))};
  const M round = is(Face::side);
  if (none(round)) {
    return;
  }
  const Around around = around_axis(p);
  const M ball = round & shape_is(shape, Shape::sphere);
  const M cone = round & shape_is(shape, Shape::cone);
  const auto of_latitude = [&](double (*f)(double)) {
    return each(
        ball, [&](double y, double x) { return f(std::atan2(y, x)); }, p.y, around.distance);
  };
  const F up = of_latitude([](double x) { return std::sin(x); });
  const F out = of_latitude([](double x) { return std::cos(x); });
  F radius = select(cone, around.distance, splat(0.5));
  radius = select(ball, select(around.distance > zero, splat(0.5) * out, zero), radius);
  // u decreases as the angle increases.
  const V3 around_u{around.sine, zero, -around.cosine};
  surface.tangent_u =
      select(round, (splat(2 * std::numbers::pi) * radius) * around_u, surface.tangent_u);
  const V3 slope{splat(-0.5) * around.cosine, splat(1), splat(-0.5) * around.sine};
  const V3 meridian{-up * around.cosine, out, -up * around.sine};
  surface.tangent_v = select(round, V3{zero, splat(1), zero}, surface.tangent_v);
  surface.tangent_v = select(cone, slope, surface.tangent_v);
  surface.tangent_v = select(ball, splat(0.5 * std::numbers::pi) * meridian, surface.tangent_v);
}

/// A point on a mesh.
struct MeshPoint {
  const Mesh* mesh = nullptr;
  std::uint32_t triangle = 0;
  double b1 = 0;
  double b2 = 0;
};

struct MeshSurface {
  SurfaceLanes surface;
  V3 flat;  ///< the normal of the triangle
};

// The unit vector along v, or `otherwise` if v is zero. Squared differences of floats neither
// overflow nor underflow a double.
inline V3 direction_or(const V3& v, const V3& otherwise) {
  const F length2 = dot(v, v);
  return select(length2 > splat(0), v / sqrt(length2), otherwise);
}

/// The surfaces at these points; lanes without a mesh return anything.
inline MeshSurface mesh_surface(const MeshPoint (&points)[lanes], bool smooth) {
  alignas(64) double rows[26][lanes] = {};
  unsigned with_normals = 0;
  unsigned with_uvs = 0;
  for (int i = 0; i < lanes; ++i) {
    const MeshPoint& point = points[i];
    if (point.mesh == nullptr) {
      continue;
    }
    const Mesh& mesh = *point.mesh;
    const auto corners_of = [&](const auto& list) {
      return list.empty() || list[point.triangle][0] == mesh_no_index ? nullptr
                                                                      : &list[point.triangle];
    };
    const auto* const normals = smooth ? corners_of(mesh.triangle_normals) : nullptr;
    const auto* const uvs = corners_of(mesh.triangle_uvs);
    for (int corner = 0; corner < 3; ++corner) {
      const glm::vec3& position = mesh.positions[mesh.triangles[point.triangle][corner]];
      for (int axis = 0; axis < 3; ++axis) {
        rows[3 * corner + axis][i] = position[axis];
      }
      for (int axis = 0; axis < 3 && normals != nullptr; ++axis) {
        rows[9 + 3 * corner + axis][i] = mesh.normals[(*normals)[corner]][axis];
      }
      for (int axis = 0; axis < 2 && uvs != nullptr; ++axis) {
        rows[18 + 2 * corner + axis][i] = mesh.uvs[(*uvs)[corner]][axis];
      }
    }
    rows[24][i] = point.b1;
    rows[25][i] = point.b2;
    with_normals |= unsigned(normals != nullptr) << i;
    with_uvs |= unsigned(uvs != nullptr) << i;
  }
  const auto vector = [&](int row) {
    return V3{load(rows[row]), load(rows[row + 1]), load(rows[row + 2])};
  };
  const F b1 = load(rows[24]);
  const F b2 = load(rows[25]);
  const V3 edge1 = vector(3) - vector(0);
  const V3 edge2 = vector(6) - vector(0);
  MeshSurface result;
  SurfaceLanes& s = result.surface;
  result.flat = direction_or(cross(edge1, edge2), {splat(0), splat(1), splat(0)});
  s.normal = result.flat;
  if (with_normals != 0) {
    const auto unit = [&](int row) { return direction_or(vector(row), result.flat); };
    const V3 sum = (splat(1) - b1 - b2) * unit(9) + b1 * unit(12) + b2 * unit(15);
    s.normal = select(of_bits(with_normals), direction_or(sum, result.flat), result.flat);
  }
  if (with_uvs != 0) {
    // Solves edge1 = du1 Pu + dv1 Pv and edge2 = du2 Pu + dv2 Pv for the tangents Pu and Pv.
    const F du1 = load(rows[20]) - load(rows[18]);
    const F dv1 = load(rows[21]) - load(rows[19]);
    const F du2 = load(rows[22]) - load(rows[18]);
    const F dv2 = load(rows[23]) - load(rows[19]);
    s.u = load(rows[18]) + b1 * du1 + b2 * du2;
    s.v = load(rows[19]) + b1 * dv1 + b2 * dv2;
    const F area = du1 * dv2 - dv1 * du2;
    const M spanned = area != splat(0);
    s.tangent_u = select(spanned, (dv2 * edge1 - dv1 * edge2) / area, s.tangent_u);
    s.tangent_v = select(spanned, (du1 * edge2 - du2 * edge1) / area, s.tangent_v);
  }
  return result;
}

}  // namespace scenefile::SCENEFILE_LANES
