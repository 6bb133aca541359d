#pragma once
// The binary part of a glTF file, and the JSON that describes it. Internal to export.

#include "scenefile/export/flat_mesh.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

/// The accessors of a mesh.
struct GltfGeometry {
  std::uint32_t positions = 0;
  std::uint32_t normals = mesh_no_index;
  std::uint32_t uvs = mesh_no_index;
  std::uint32_t indices = 0;
};

class GltfBuffer {
 public:
  /// Adds a mesh; `repeat` multiplies its uvs. The mesh must have triangles.
  GltfGeometry add(const FlatMesh& mesh, const glm::vec2& repeat);
  /// Adds a file as a buffer view, and returns the index of the view.
  std::uint32_t add(std::string_view file);

  const std::string& bytes() const { return bytes_; }
  /// The contents of the JSON arrays bufferViews and accessors.
  const std::string& views() const { return views_; }
  const std::string& accessors() const { return accessors_; }

 private:
  std::uint32_t add_view(const void* data, std::size_t size, int target);
  std::uint32_t add_accessor(std::uint32_t view, std::size_t count, int component,
                             std::string_view type, std::string_view more);

  std::string bytes_;
  std::string views_;
  std::string accessors_;
  std::uint32_t view_count_ = 0;
  std::uint32_t accessor_count_ = 0;
};

}  // namespace scenefile
