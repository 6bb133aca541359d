#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/surface-inl.h"

namespace scenefile {

namespace {

Surface surface_of(const one::SurfaceLanes& s, const one::V3& flat) {
  const auto vector = [](const one::V3& v) { return glm::dvec3(v.x, v.y, v.z); };
  return {vector(s.normal), vector(flat), {s.u, s.v}, vector(s.tangent_u), vector(s.tangent_v)};
}

}  // namespace

Surface surface_at(Shape shape, Face face, const glm::dvec3& point) {
  const double kind = static_cast<int>(shape);
  const double side = static_cast<int>(face);
  const one::V3 p = one::splat3(point);
  one::SurfaceLanes surface;
  surface.normal = one::shape_normal(kind, side, p);
  one::set_shape_uv(kind, side, p, surface);
  one::set_shape_tangents(kind, side, p, surface);
  return surface_of(surface, surface.normal);
}

Surface surface_at(const Mesh& mesh, std::uint32_t index, double b1, double b2, bool smooth) {
  const one::MeshSurface on_mesh = one::mesh_surface({{&mesh, index, b1, b2}}, smooth);
  return surface_of(on_mesh.surface, on_mesh.flat);
}

}  // namespace scenefile
