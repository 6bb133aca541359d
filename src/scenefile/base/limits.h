#pragma once
// Bounds on the time and memory that a faulty or malicious file may take. Passed to every function
// that reads.

#include <cstddef>
#include <cstdint>

namespace scenefile {

/// Upper bounds; each is checked before memory is allocated and has its own diagnostic.
/// The defaults leave ample room for every scene of the course and of public projects.
struct Limits {
  std::uint64_t file_bytes = std::uint64_t{1} << 30;     ///< of a scene or asset file
  std::uint32_t nesting = 1024;                          ///< depth of nested elements or values
  std::uint32_t attributes = 256;                        ///< of one element
  std::uint32_t name_bytes = 4096;                       ///< names of elements, objects and files
  std::uint32_t value_bytes = 65536;                     ///< any other attribute or string
  std::uint32_t messages_per_code = 100;                 ///< kept; the rest are only counted
  std::uint32_t message_bytes = 1 << 20;                 ///< kept, in total
  std::uint32_t lights = 1024;                           ///< in world space, after instancing
  std::uint32_t texture_side = 16384;                    ///< pixels
  std::uint64_t texture_bytes = std::uint64_t{1} << 30;  ///< decoded, all textures together
  std::uint64_t mesh_triangles = 50'000'000;             ///< all meshes together
  std::uint64_t mesh_bytes = std::uint64_t{2} << 30;     ///< in memory, all meshes together
  std::uint32_t instance_nesting = 1024;                 ///< templates inside templates
  std::uint32_t image_side = 65536;                      ///< of a rendered image, pixels
};

}  // namespace scenefile
