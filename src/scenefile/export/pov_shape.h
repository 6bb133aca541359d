#pragma once
// Shapes in POV-Ray's language. Internal to export.

#include "scenefile/export/pov_material.h"
#include "scenefile/geometry/mesh.h"

#include <string>
#include <string_view>

namespace scenefile {

/// One primitive in object space, then transformed by `placing`. `mesh_name` is the `#declare`d
/// name of a mesh.
std::string pov_primitive(Shape shape, const PovMaterial& m, std::string_view mesh_name,
                          std::string_view placing);

/// `mesh2 { ... }`, with uvs and normals if the mesh has them.
std::string pov_mesh(const Mesh& mesh);

}  // namespace scenefile
