#pragma once
// Materials of mesh faces, from .mtl files (the advanced course's assignment Path): plain data.

#include "scenefile/base/location.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// "No texture", for the maps of a FaceMaterial.
inline constexpr std::uint32_t no_map = 0xffffffffu;

/// Values of FaceMaterial::illum: a perfect mirror, and glass with Fresnel's reflection.
inline constexpr int illum_mirror = 5;
inline constexpr int illum_glass = 7;

/// A material of faces. Colors are linear, as written, finite and not negative; they may exceed 1.
/// The defaults are those of the course's reader. Maps are indices into Assets::textures, or
/// no_map; the textures multiply the color and may be empty() if they could not be used.
struct FaceMaterial {
  std::string name;           ///< of newmtl
  glm::vec3 diffuse{0};       ///< Kd
  glm::vec3 specular{0};      ///< Ks
  glm::vec3 emission{0};      ///< Ke: radiance, emitted on the side of the counterclockwise winding
  glm::vec3 transmission{0};  ///< Tf or Kt
  float shininess = 1;        ///< Ns, not negative
  float ior = 1;              ///< Ni, greater than 0
  int illum = 0;              ///< as written
  std::uint32_t diffuse_map = no_map;
  std::uint32_t specular_map = no_map;
  std::uint32_t emission_map = no_map;
  std::string file;   ///< the .mtl file, as named relative to the scene; for messages
  Location location;  ///< of newmtl in that file
};

/// The face materials of one mesh.
struct MeshMaterials {
  std::vector<FaceMaterial> materials;  ///< those that triangles have
  /// Into `materials`, one per triangle of the mesh; mesh_no_index: the triangle has the object's
  /// own material. Empty if no triangle has a face material.
  std::vector<std::uint32_t> of_triangle;
};

/// How many triangles have each material.
std::vector<std::size_t> triangles_of_materials(const MeshMaterials& mesh);

}  // namespace scenefile
