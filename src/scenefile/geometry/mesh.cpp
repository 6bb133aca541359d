#include "scenefile/geometry/mesh.h"

#include <cmath>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;
using Corners = std::array<std::uint32_t, 3>;

// The unit vector along v, or `otherwise` if v is zero. Squared differences of floats neither
// overflow nor underflow a double.
dvec3 direction_or(const dvec3& v, const dvec3& otherwise) {
  const double length2 = glm::dot(v, v);
  return length2 > 0 ? v / std::sqrt(length2) : otherwise;
}

const Corners* corners_of(const std::vector<Corners>& list, std::uint32_t index) {
  return list.empty() || list[index][0] == mesh_no_index ? nullptr : &list[index];
}

dvec3 interpolated_normal(const Mesh& mesh, const Corners& corners, double b1, double b2,
                          const dvec3& geometric) {
  const auto unit = [&](int corner) {
    return direction_or(dvec3(mesh.normals[corners[corner]]), geometric);
  };
  return direction_or((1 - b1 - b2) * unit(0) + b1 * unit(1) + b2 * unit(2), geometric);
}

// Solves edge1 = du1 Pu + dv1 Pv and edge2 = du2 Pu + dv2 Pv for the tangents Pu and Pv.
void set_uv(const Mesh& mesh, const Corners& corners, double b1, double b2, const dvec3& edge1,
            const dvec3& edge2, Surface& surface) {
  const dvec2 uv0(mesh.uvs[corners[0]]);
  const dvec2 d1 = dvec2(mesh.uvs[corners[1]]) - uv0;
  const dvec2 d2 = dvec2(mesh.uvs[corners[2]]) - uv0;
  surface.uv = uv0 + b1 * d1 + b2 * d2;
  const double area = d1.x * d2.y - d1.y * d2.x;
  if (area != 0) {
    surface.tangent_u = (d2.y * edge1 - d1.y * edge2) / area;
    surface.tangent_v = (d1.x * edge2 - d2.x * edge1) / area;
  }
}

}  // namespace

Surface surface_at(const Mesh& mesh, std::uint32_t index, double b1, double b2, bool smooth) {
  const Corners& corners = mesh.triangles[index];
  const dvec3 origin(mesh.positions[corners[0]]);
  const dvec3 edge1 = dvec3(mesh.positions[corners[1]]) - origin;
  const dvec3 edge2 = dvec3(mesh.positions[corners[2]]) - origin;
  Surface surface;
  surface.normal = direction_or(glm::cross(edge1, edge2), surface.normal);
  const Corners* normals = smooth ? corners_of(mesh.triangle_normals, index) : nullptr;
  if (normals != nullptr) {
    surface.normal = interpolated_normal(mesh, *normals, b1, b2, surface.normal);
  }
  if (const Corners* uvs = corners_of(mesh.triangle_uvs, index)) {
    set_uv(mesh, *uvs, b1, b2, edge1, edge2, surface);
  }
  return surface;
}

Bounds bounds(const Mesh& mesh) {
  Bounds box;
  for (const Corners& corners : mesh.triangles) {
    for (const std::uint32_t corner : corners) {
      box = unite(box, dvec3(mesh.positions[corner]));
    }
  }
  return box;
}

}  // namespace scenefile
