// Ray differentials through reflections and refractions, and texture footprints, for any number of
// lanes (base/one_lane.h). After Igehy, "Tracing Ray Differentials", 1999. No include guard:
// included once for each number of lanes.

#include "scenefile/trace/camera_rays.h"

#include <numbers>

namespace scenefile::SCENEFILE_LANES {

/// Derivatives by x and y of the picture: for one step to the right and one step down.
struct Derivatives {
  V3 dx, dy;
};

inline Derivatives no_derivatives() {
  const V3 none{splat(0), splat(0), splat(0)};
  return {none, none};
}

/// Below this cosine, at grazing angles, derivatives do not grow any further.
inline constexpr double min_cosine = 1.0 / 64;

/// The derivatives of the unit direction of a camera ray; a step is `width` pixels.
inline Derivatives camera_derivatives(const CameraFrame& camera, F x, F y, F lens_x, F lens_y,
                                      F width) {
  V3 forward = pinhole_forward(camera, x, y);
  F step = width * splat(camera.pixel);
  if (camera.has_lens()) {
    forward = splat(camera.focal_length) * forward -
              splat(camera.aperture) * (lens_x * splat3(camera.u) + lens_y * splat3(camera.v));
    step = splat(camera.focal_length) * step;
  }
  const F size = length(forward);
  const V3 direction = forward / size;
  const auto turned = [&](const V3& change) {
    return (change - dot(change, direction) * direction) / size;
  };
  return {turned(step * splat3(camera.u)), turned(-(step * splat3(camera.v)))};
}

/// The derivatives of the point where a ray hits a surface with this normal, at distance t.
inline Derivatives hit_derivatives(const Derivatives& origin, const Derivatives& direction,
                                   const V3& ray, const V3& normal, F t) {
  const F cosine = dot(ray, normal);
  const F slant = copysign(max(abs(cosine), splat(min_cosine)), cosine);
  const auto on_surface = [&](const V3& d_origin, const V3& d_direction) {
    const V3 moved = d_origin + t * d_direction;
    return moved - (dot(moved, normal) / slant) * ray;
  };
  return {on_surface(origin.dx, direction.dx), on_surface(origin.dy, direction.dy)};
}

/// The derivative of a shape's object-space normal for a step on its surface at p.
inline V3 object_normal_derivative(F shape, F face, const V3& p, const V3& step) {
  const V3 still{splat(0), splat(0), splat(0)};
  const M round =
      face_is(face, Face::side) & (shape_is(shape, Shape::sphere) |
                                   shape_is(shape, Shape::cylinder) | shape_is(shape, Shape::cone));
  if (none(round)) {
    return still;
  }
  const auto across = [](const V3& out, const V3& v) { return v - dot(out, v) * out; };
  const F size = length(p);
  const V3 ball = across(p / size, step) / size;
  const Around around = around_axis(p);
  const V3 flat_step{step.x, splat(0), step.z};
  const V3 tube = across({around.cosine, splat(0), around.sine}, flat_step) / around.distance;
  const V3 cone = splat(2 / 2.2360679774997896964) * tube;
  const M beside = round & (around.distance > splat(0));
  V3 dn = select(beside & shape_is(shape, Shape::cylinder), tube, still);
  dn = select(beside & shape_is(shape, Shape::cone), cone, dn);
  return select(round & shape_is(shape, Shape::sphere) & (size > splat(0)), ball, dn);
}

/// The derivative of a shape's unit normal in world space for a step on its surface. `x`, `y`, `z`:
/// columns of the linear map from world to object space; `normal`: in object space.
inline V3 world_normal_derivative(const V3& x, const V3& y, const V3& z, F shape, F face,
                                  const V3& p, const V3& normal, const V3& step) {
  const V3 object_step{x.x * step.x + y.x * step.y + z.x * step.z,
                       x.y * step.x + y.y * step.y + z.y * step.z,
                       x.z * step.x + y.z * step.y + z.z * step.z};
  const V3 object_dn = object_normal_derivative(shape, face, p, object_step);
  const V3 scaled{dot(x, normal), dot(y, normal), dot(z, normal)};
  const V3 dn{dot(x, object_dn), dot(y, object_dn), dot(z, object_dn)};
  const F size = length(scaled);
  const V3 unit = scaled / size;
  const M known = (size > splat(0)) & finite(size);
  return select(known, (dn - dot(unit, dn) * unit) / size, V3{splat(0), splat(0), splat(0)});
}

/// Derivatives of the normal `geometric`, flipped if `wanted` points to its other side.
inline Derivatives on_side(const Derivatives& dn, const V3& geometric, const V3& wanted) {
  const M other = dot(geometric, wanted) < splat(0);
  return {select(other, -dn.dx, dn.dx), select(other, -dn.dy, dn.dy)};
}

/// The derivatives of a reflected direction. `dn`: of the normal.
inline Derivatives mirrored_derivatives(const V3& ray, const V3& normal,
                                        const Derivatives& direction, const Derivatives& dn) {
  const F cosine = dot(ray, normal);
  const auto mirrored = [&](const V3& d, const V3& n) {
    return d - splat(2) * (cosine * n + (dot(d, normal) + dot(ray, n)) * normal);
  };
  return {mirrored(direction.dx, dn.dx), mirrored(direction.dy, dn.dy)};
}

/// The derivatives of a refracted direction; see refraction().
inline Derivatives refracted_derivatives(const V3& ray, const V3& normal, F eta,
                                         const Derivatives& direction, const Derivatives& dn) {
  const F cosine = -dot(ray, normal);
  const F squared = splat(1) - eta * eta * (splat(1) - cosine * cosine);
  const F out = sqrt(max(squared, splat(min_cosine * min_cosine)));
  const F along = eta * cosine - out;
  const F rate = eta - eta * eta * cosine / out;
  const auto refracted = [&](const V3& d, const V3& n) {
    const F change = -(dot(d, normal) + dot(ray, n));
    return eta * d + along * n + (rate * change) * normal;
  };
  return {refracted(direction.dx, dn.dx), refracted(direction.dy, dn.dy)};
}

/// A derivative of (u, v).
struct UvDerivative {
  F u, v;
};

/// Of a shape at p for a step on its surface, all in object space. At a pole, where all u meet, 1.
inline UvDerivative shape_uv_derivative(F shape, F face, const V3& p, const V3& step) {
  const auto is = [&](Face f) { return face_is(face, f); };
  const M on_side = is(Face::pos_x) | is(Face::neg_x) | is(Face::pos_z) | is(Face::neg_z);
  const M below = is(Face::bottom) | is(Face::neg_y);
  F u = select(is(Face::pos_x), -step.z, step.x);
  u = select(is(Face::neg_x), step.z, select(is(Face::neg_z), -step.x, u));
  F v = select(on_side, step.y, select(below, step.z, -step.z));
  const M round = is(Face::side);
  if (none(round)) {
    return {u, v};
  }
  const F squared = p.x * p.x + p.z * p.z;
  const F around = (p.z * step.x - p.x * step.z) / squared / splat(2 * std::numbers::pi);
  // Also false for NaN.
  const M off_pole = (around >= splat(-1)) & (around <= splat(1));
  u = select(round, select(off_pole, around, splat(1)), u);
  const F distance = sqrt(squared);
  const F outward = select(distance > splat(0), (p.x * step.x + p.z * step.z) / distance, splat(0));
  const F up =
      (distance * step.y - p.y * outward) / (squared + p.y * p.y) / splat(std::numbers::pi);
  v = select(round, select(shape_is(shape, Shape::sphere), up, step.y), v);
  return {u, v};
}

/// The same on a triangle with these tangents; 1 across the whole texture where they are unknown.
inline UvDerivative mesh_uv_derivative(const V3& tangent_u, const V3& tangent_v, const V3& step) {
  const V3 area = cross(tangent_u, tangent_v);
  const F squared = dot(area, area);
  const M known = squared > splat(1e-30) * dot(tangent_u, tangent_u) * dot(tangent_v, tangent_v);
  return {select(known, dot(cross(step, tangent_v), area) / squared, splat(1)),
          select(known, dot(cross(tangent_u, step), area) / squared, splat(0))};
}

/// The footprint of a pixel in a texture, in texels: a parallelogram around the lookup point.
struct TexelFootprint {
  F right_x, right_y;  ///< for the step to the right
  F down_x, down_y;
};

/// Texel coordinates: x right and y down.
inline F texel_x(F u, F repeat, F width) {
  return u * repeat * width;
}
inline F texel_y(F v, F repeat, F height) {
  return (splat(1) - v) * repeat * height;
}

inline TexelFootprint texel_footprint(const UvDerivative& right, const UvDerivative& down,
                                      F repeat_u, F repeat_v, F width, F height) {
  const F across = repeat_u * width;
  const F along = -(repeat_v * height);
  return {right.u * across, right.v * along, down.u * across, down.v * along};
}

/// The maximum number of lookups along an elongated footprint; more would cost more than they show.
inline constexpr double max_taps = 16;

/// The index of a texel, wrapped around to 0 .. size - 1.
inline F wrapped(F index, F size) {
  const F inside = index - size * floor(index / size);
  return select(inside >= splat(0), min(inside, size - splat(1)), splat(0));
}

inline V3 mix(const V3& a, const V3& b, F share) {
  return (splat(1) - share) * a + share * b;
}

/// Interpolates between the four texels around (x, y); `texels(x, y)` looks up one by its indices.
template <typename Texels>
V3 bilinear(F width, F height, F x, F y, const Texels& texels) {
  const F left = floor(x);
  const F top = floor(y);
  const F x0 = wrapped(left, width);
  const F y0 = wrapped(top, height);
  const auto next = [](F at, F size) {
    return select(at + splat(1) == size, splat(0), at + splat(1));
  };
  const F x1 = next(x0, width);
  const F y1 = next(y0, height);
  const V3 above = mix(texels(x0, y0), texels(x1, y0), x - left);
  const V3 below = mix(texels(x0, y1), texels(x1, y1), x - left);
  return mix(above, below, y - top);
}

/// Averages over footprints around (x, y), in texels of the largest mip level. `textures` provides
///   F levels()                                   number of mip levels
///   V3 smooth(F level, M wanted, F x, F y)       the color at a point, interpolated in that level
/// `grid`: 1, or 2 for four lookups in the quarters of the footprint, like four samples would make.
/// Lanes outside of `wanted` return any color.
template <typename Textures>
V3 filtered(const Textures& textures, F x, F y, const TexelFootprint& pixel, F grid, M wanted) {
  const auto size = [](F a, F b) { return sqrt(a * a + b * b); };
  const F right = size(pixel.right_x, pixel.right_y);
  const F below = size(pixel.down_x, pixel.down_y);
  const M limited = finite(right + below);
  const M rightward = right >= below;
  // For a footprint much smaller than a texel, one lookup is as good as four.
  const M quarters = limited & (grid > splat(1)) & (max(right, below) > splat(0.25));
  const F part = splat(1) / grid;
  const F longer = part * select(rightward, right, below);
  const F shorter = part * select(rightward, below, right);
  const F major_x = part * select(rightward, pixel.right_x, pixel.down_x);
  const F major_y = part * select(rightward, pixel.right_y, pixel.down_y);
  const F width = max(max(shorter, longer / splat(max_taps)), splat(1));
  // Chooses the level whose texels are about as wide as the footprint.
  const F last = textures.levels() - splat(1);
  F level = splat(0);
  F texel = splat(1.5);
  for (M wider = wanted; any(wider); texel = texel + texel) {
    wider = wider & (level < last) & !(width < texel);
    level = select(wider, level + splat(1), level);
  }
  const F taps = select(limited, clamp(-floor(-(longer / width)), 1, max_taps), splat(1));
  V3 sum{splat(0), splat(0), splat(0)};
  for (int quarter = 0; quarter < 4; ++quarter) {
    const M here = quarter == 0 ? wanted : wanted & quarters;
    const F right_share = select(quarters, splat(quarter % 2 == 0 ? -0.25 : 0.25), splat(0));
    const F down_share = select(quarters, splat(quarter / 2 == 0 ? -0.25 : 0.25), splat(0));
    const F at_x = x + right_share * pixel.right_x + down_share * pixel.down_x;
    const F at_y = y + right_share * pixel.right_y + down_share * pixel.down_y;
    for (int i = 0;; ++i) {
      const M active = here & (taps > splat(i));
      if (none(active)) {
        break;
      }
      const F along = select(taps > splat(1), splat(i + 0.5) / taps - splat(0.5), splat(0));
      const V3 color = textures.smooth(level, active, select(limited, at_x + along * major_x, x),
                                       select(limited, at_y + along * major_y, y));
      sum = sum + select(active, color, V3{splat(0), splat(0), splat(0)});
    }
  }
  return sum / (taps * select(quarters, splat(4), splat(1)));
}

/// The height of white above black in bump maps, in object space units.
inline constexpr double bump_height = 1.0 / 16;

/// The object-space normal, not of unit length, of a surface displaced along its normal by
/// bump_height times the mean of red, green and blue. Slopes are central differences over one texel
/// of the map, or over the footprint if that is wider. `color(u, v, wanted)` looks up the map;
/// `wanted` loses the lanes where it has no effect.
template <typename Lookup>
V3 bumped_normal(const SurfaceLanes& surface, const UvDerivative& right, const UvDerivative& down,
                 F columns, F rows, M& wanted, const Lookup& color) {
  const V3& n = surface.normal;
  const V3& tangent_u = surface.tangent_u;
  const V3& tangent_v = surface.tangent_v;
  const F area = dot(cross(tangent_u, tangent_v), n);
  const F flat = splat(1e-12) * length(tangent_u) * length(tangent_v);
  wanted = wanted & (abs(area) > flat) & (columns != splat(0)) & (rows != splat(0));
  const auto width = [](F texels, F right_step, F down_step) {
    const F reach = max(abs(right_step), abs(down_step));
    return max(splat(1) / abs(texels), select(finite(reach), min(reach, splat(0.25)), splat(0.25)));
  };
  const F du = width(columns, right.u, down.u);
  const F dv = width(rows, right.v, down.v);
  const auto height = [&](F u, F v) {
    const V3 c = color(u, v, wanted);
    return splat(bump_height) * (c.x + c.y + c.z) / splat(3);
  };
  const F slope_u =
      (height(surface.u + du, surface.v) - height(surface.u - du, surface.v)) / (splat(2) * du);
  const F slope_v =
      (height(surface.u, surface.v + dv) - height(surface.u, surface.v - dv)) / (splat(2) * dv);
  return n - (slope_u * cross(tangent_v, n) + slope_v * cross(n, tangent_u)) / area;
}

}  // namespace scenefile::SCENEFILE_LANES
