#pragma once
// Material libraries of OBJ files. Source of the format: Wavefront, "Material Library (.mtl)";
// tinyobjloader 1.1, which the course's path tracer uses, adds Ke, Kt, Tr and the maps of
// physically based materials. Internal to asset and import.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A material as written; what its library does not give is empty. Colors and numbers are finite
/// and not negative, Ni is greater than 0, d is between 0 and 1.
struct MtlMaterial {
  std::string name;
  Location location;                      ///< of newmtl
  std::optional<glm::vec3> ambient;       ///< Ka
  std::optional<glm::vec3> diffuse;       ///< Kd
  std::optional<glm::vec3> specular;      ///< Ks
  std::optional<glm::vec3> emission;      ///< Ke
  std::optional<glm::vec3> transmission;  ///< Tf or Kt
  std::optional<float> shininess;         ///< Ns
  std::optional<float> ior;               ///< Ni
  std::optional<float> opacity;           ///< d, otherwise 1 - Tr
  std::optional<int> illum;
  FileReference diffuse_map;  ///< map_Kd; without a name if there is none
  FileReference specular_map;
  FileReference emission_map;
  bool has_alpha_map = false;  ///< map_d and other names for it; no picture is read
  bool has_bump_map = false;   ///< bump, norm, disp, ...; likewise
};

/// Reads the text of a library: the materials in its order, without those whose name an earlier one
/// has. A name is the rest of its line and may hold blanks. A value that cannot be used is left
/// out. Findings carry `file_name`; codes: asset/codes.h, all of them warnings or notes.
/// `byte_budget` is what remains of limits.mesh_bytes and is reduced by the materials; when it is
/// spent, the rest of the library is skipped. Time and memory are linear in the size of the text.
std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& file_name,
                                  const Limits& limits, std::uint64_t& byte_budget,
                                  Diagnostics& diagnostics);

}  // namespace scenefile
