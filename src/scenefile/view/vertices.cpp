#include "scenefile/view/vertices.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/geometry/tessellate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace scenefile {

namespace {

using Corner = std::array<std::uint32_t, 3>;  // position, normal, uv

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t hash = corner[0];
    hash = hash * 0x9e3779b97f4a7c15u + corner[1];
    hash = hash * 0x9e3779b97f4a7c15u + corner[2];
    return hash ^ (hash >> 32);
  }
};

// Marks normals that the file does not have: those of the triangles.
constexpr std::uint32_t own_normal = 0x80000000u;

std::uint32_t index_or_none(const std::vector<Corner>& lists, std::uint32_t triangle, int corner) {
  return lists.empty() ? mesh_no_index : lists[triangle][corner];
}

class MeshIndexer {
 public:
  MeshIndexer(const Mesh& mesh, bool smooth) : mesh_(mesh), smooth_(smooth) {}

  DrawVertices all() {
    for (const std::uint32_t triangle : distinct_triangles(mesh_)) {
      for (int corner = 0; corner < 3; ++corner) {
        result_.triangles.push_back(vertex(triangle, corner));
      }
    }
    return std::move(result_);
  }

 private:
  std::uint32_t vertex(std::uint32_t triangle, int corner) {
    std::uint32_t normal =
        smooth_ ? index_or_none(mesh_.triangle_normals, triangle, corner) : mesh_no_index;
    if (normal == mesh_no_index) {
      normal = own_normal | triangle;
    }
    const Corner key{mesh_.triangles[triangle][corner], normal,
                     index_or_none(mesh_.triangle_uvs, triangle, corner)};
    const auto [found, fresh] =
        known_.try_emplace(key, static_cast<std::uint32_t>(result_.vertices.size()));
    if (fresh) {
      result_.vertices.push_back(make(key, triangle));
    }
    return found->second;
  }

  DrawVertex make(const Corner& key, std::uint32_t triangle) const {
    DrawVertex vertex;
    vertex.position = mesh_.positions[key[0]];
    const bool own = (key[1] & own_normal) != 0;
    vertex.normal = own ? glm::vec3(surface_at(mesh_, triangle, 0, 0, false).normal)
                        : glm::normalize(mesh_.normals[key[1]]);
    vertex.uv = key[2] == mesh_no_index ? glm::vec2(0) : mesh_.uvs[key[2]];
    return vertex;
  }

  const Mesh& mesh_;
  bool smooth_;
  std::unordered_map<Corner, std::uint32_t, CornerHash> known_;
  DrawVertices result_;
};

// The scale from an inscribed polygon to a polygon with the area of the circle.
double growth(int segments) {
  using std::numbers::pi;
  return std::sqrt(2 * pi / segments / std::sin(2 * pi / segments));
}

// Of the round shapes: whether it ends in a disk.
bool has_flat_end(Shape shape) {
  switch (shape) {
    case Shape::cone:
    case Shape::cylinder:
      return true;
    case Shape::sphere:
    case Shape::cube:
    case Shape::mesh:
      return false;
  }
  return false;
}

}  // namespace

DrawVertices mesh_vertices(const Mesh& mesh, bool smooth) {
  return MeshIndexer(mesh, smooth).all();
}

DrawVertices shape_vertices(Shape shape, int segments) {
  DrawVertices result = mesh_vertices(tessellate(shape, segments), true);
  for (DrawVertex& vertex : result.vertices) {
    const bool curved = has_curved_side(shape);
    const bool cap = has_flat_end(shape) && std::abs(vertex.normal.y) > 0.99f;
    vertex.round = curved && !cap ? 1.0f : 0.0f;
    if (curved) {
      const auto grown = static_cast<float>(growth(segments));
      vertex.position *= glm::vec3(grown, has_flat_end(shape) ? 1 : grown, grown);
    }
  }
  return result;
}

std::vector<std::uint32_t> edges(const std::vector<std::uint32_t>& triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  pairs.reserve(triangles.size());
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      pairs.push_back(std::minmax(triangles[i + k], triangles[i + (k + 1) % 3]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<std::uint32_t> indices;
  for (const auto& [a, b] : pairs) {
    indices.insert(indices.end(), {a, b});
  }
  return indices;
}

std::vector<std::uint32_t> bent_edges(const DrawVertices& data) {
  constexpr float flat = 0.9999f;  // cosine
  struct Side {
    std::uint32_t a;  // the first vertices at their positions, lower index first
    std::uint32_t b;
    glm::vec3 normal;
  };
  std::map<std::array<float, 3>, std::uint32_t> first_at;
  const auto welded = [&](std::uint32_t vertex) {
    const glm::vec3& p = data.vertices[vertex].position;
    return first_at.try_emplace({p.x, p.y, p.z}, vertex).first->second;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i + 2 < data.triangles.size(); i += 3) {
    const std::uint32_t* const corner = &data.triangles[i];
    const glm::vec3& p = data.vertices[corner[0]].position;
    const glm::vec3 normal = glm::normalize(
        glm::cross(data.vertices[corner[1]].position - p, data.vertices[corner[2]].position - p));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax({welded(corner[k]), welded(corner[(k + 1) % 3])});
      sides.push_back({a, b, normal});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& x, const Side& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    bool bent = end == sides.size() || sides[end].a != sides[i].a || sides[end].b != sides[i].b;
    for (; end < sides.size() && sides[end].a == sides[i].a && sides[end].b == sides[i].b; ++end) {
      bent = bent || glm::dot(sides[end].normal, sides[i].normal) < flat;
    }
    if (bent) {
      indices.insert(indices.end(), {sides[i].a, sides[i].b});
    }
    i = end;
  }
  return indices;
}

}  // namespace scenefile
