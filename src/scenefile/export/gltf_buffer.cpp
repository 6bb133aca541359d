#include "scenefile/export/gltf_buffer.h"

#include <fmt/format.h>

#include <bit>
#include <iterator>
#include <vector>

namespace scenefile {

namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

constexpr int vertices = 34962;  // ARRAY_BUFFER
constexpr int elements = 34963;  // ELEMENT_ARRAY_BUFFER
constexpr int float_type = 5126;
constexpr int short_type = 5123;
constexpr int int_type = 5125;

}  // namespace

std::uint32_t GltfBuffer::add_view(const void* data, std::size_t size, int target) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  fmt::format_to(std::back_inserter(views_),
                 R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}{}}})",
                 view_count_ == 0 ? "" : ",\n", bytes_.size(), size,
                 target == 0 ? std::string() : fmt::format(R"(,"target":{})", target));
  bytes_.append(static_cast<const char*>(data), size);
  return view_count_++;
}

std::uint32_t GltfBuffer::add_accessor(std::uint32_t view, std::size_t count, int component,
                                       std::string_view type, std::string_view more) {
  fmt::format_to(std::back_inserter(accessors_),
                 R"({}{{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})",
                 accessor_count_ == 0 ? "" : ",\n", view, component, count, type, more);
  return accessor_count_++;
}

GltfGeometry GltfBuffer::add(const FlatMesh& mesh, const glm::vec2& repeat) {
  GltfGeometry geometry;
  glm::vec3 low = mesh.positions[0];
  glm::vec3 high = low;
  for (const glm::vec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const auto list = [](const glm::vec3& v) {
    return fmt::format("[{},{},{}]", double(v.x), double(v.y), double(v.z));
  };
  const std::size_t count = mesh.positions.size();
  geometry.positions =
      add_accessor(add_view(mesh.positions.data(), count * sizeof(glm::vec3), vertices), count,
                   float_type, "VEC3", fmt::format(R"(,"min":{},"max":{})", list(low), list(high)));
  if (!mesh.normals.empty()) {
    geometry.normals =
        add_accessor(add_view(mesh.normals.data(), count * sizeof(glm::vec3), vertices), count,
                     float_type, "VEC3", "");
  }
  if (!mesh.uvs.empty()) {
    // In glTF, v increases downward.
    std::vector<glm::vec2> uvs;
    for (const glm::vec2& uv : mesh.uvs) {
      uvs.push_back(repeat * glm::vec2(uv.x, 1 - uv.y));
    }
    geometry.uvs = add_accessor(add_view(uvs.data(), count * sizeof(glm::vec2), vertices), count,
                                float_type, "VEC2", "");
  }
  const std::size_t corners = mesh.indices.size();
  if (count < 65535) {
    const std::vector<std::uint16_t> small(mesh.indices.begin(), mesh.indices.end());
    geometry.indices = add_accessor(add_view(small.data(), corners * 2, elements), corners,
                                    short_type, "SCALAR", "");
  } else {
    geometry.indices = add_accessor(add_view(mesh.indices.data(), corners * 4, elements), corners,
                                    int_type, "SCALAR", "");
  }
  return geometry;
}

std::uint32_t GltfBuffer::add(std::string_view file) {
  return add_view(file.data(), file.size(), 0);
}

}  // namespace scenefile
