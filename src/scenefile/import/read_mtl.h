#pragma once
// Materials of OBJ files. Internal to import.

#include "scenefile/scene/scene.h"

#include <map>
#include <string>
#include <string_view>

namespace scenefile {

/// A material; `picture` is the file of map_Kd, which multiplies the diffuse color.
struct MtlMaterial {
  Material material;
  std::string picture;
};

/// Adds the materials of a library by name; the first of a name counts. Skips statements without an
/// equivalent, and invalid numbers.
void read_mtl(std::string_view text, std::map<std::string, MtlMaterial, std::less<>>& materials);

}  // namespace scenefile
