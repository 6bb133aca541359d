// Feeds text to read_obj(), with high and low limits.

#include "finding_laws.h"
#include "law.h"
#include "scenefile/asset/read_obj.h"
#include "target.h"

#include <cmath>
#include <string_view>

namespace {

using namespace scenefile;
using fuzz::require;
using Corners = std::array<std::uint32_t, 3>;

bool in_range(const Corners& corners, std::size_t size) {
  return corners[0] < size && corners[1] < size && corners[2] < size;
}

// For an index list that may be absent.
void require_indices(const std::vector<Corners>& list, std::size_t triangles, std::size_t size) {
  require(list.empty() || list.size() == triangles, "an index list is empty or complete");
  for (const Corners& corners : list) {
    const bool none = corners == Corners{mesh_no_index, mesh_no_index, mesh_no_index};
    require(none || in_range(corners, size), "indices are in range");
  }
}

void require_surface(const Mesh& mesh, std::uint32_t triangle) {
  for (const bool smooth : {false, true}) {
    const Surface surface = surface_at(mesh, triangle, 0.25, 0.5, smooth);
    require(std::abs(glm::length(surface.normal) - 1) < 1e-6, "normals are unit vectors");
  }
}

void require_valid(const Mesh& mesh) {
  for (const glm::vec3& position : mesh.positions) {
    require(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z),
            "positions are finite");
  }
  require_indices(mesh.triangle_normals, mesh.triangles.size(), mesh.normals.size());
  require_indices(mesh.triangle_uvs, mesh.triangles.size(), mesh.uvs.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    require(in_range(mesh.triangles[i], mesh.positions.size()), "corners exist");
    require_surface(mesh, i);
  }
  require(bounds(mesh).empty() == mesh.triangles.empty(), "a mesh with triangles has a box");
}

void judge(std::string_view text, const Limits& limits) {
  Diagnostics diagnostics(limits);
  std::uint64_t triangles = limits.mesh_triangles;
  std::uint64_t bytes = limits.mesh_bytes;
  const Mesh mesh = read_obj(text, "mesh.obj", limits, triangles, bytes, diagnostics);
  fuzz::require_sound(diagnostics, limits, text);
  require(triangles <= limits.mesh_triangles && bytes <= limits.mesh_bytes, "budgets never grow");
  require(!diagnostics.has_errors() || mesh.triangles.empty(), "an error leaves no mesh");
  require(mesh.triangles.size() <= limits.mesh_triangles - triangles, "triangles are counted");
  require(mesh.positions.size() * sizeof(glm::vec3) <= limits.mesh_bytes - bytes,
          "bytes are counted");
  require_valid(mesh);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  judge(text, {});
  Limits narrow = fuzz::narrow_limits();
  narrow.mesh_triangles = 6;
  narrow.mesh_bytes = 600;
  judge(text, narrow);
  return 0;
}
