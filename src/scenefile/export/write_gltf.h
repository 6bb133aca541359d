#pragma once
// Export to glTF 2.0 (Khronos Group, glTF 2.0 Specification, 2021), which Blender, web pages and
// many other programs read.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/scene.h"

#include <cstddef>
#include <string>

namespace scenefile {

struct GltfOptions {
  bool binary = true;        ///< GLB, one binary file; otherwise JSON with embedded base64 data
  int segments = 64;         ///< per full turn on round sides; see geometry/tessellate.h
  float transparent = 0.5f;  ///< transparentcoeff if the scene gives none
  bool path = false;  ///< the scene is as use_face_materials() left it (export/face_materials.h)
  std::size_t max_nodes = 4'000'000;  ///< in the file; templates count once per instance
};

/// Writes the scene. `ready` is the result of prepare(), `assets` the textures and meshes of its
/// files. Keeps the tree of nodes with its names. Templates are copied for each instance, but
/// meshes and materials are shared. A transform with shear becomes two nodes. Lights are added at
/// the top level, in world space. The conversion of materials and lights is described in
/// export/phong_pbr.h and docs/convert.md; they also carry the format's own values in
/// `extras.scenefile`.
///
/// Everything that glTF represents differently, or not at all, is reported once. Returns an empty
/// text and reports an error if the file would have too many nodes or exceed the size limit of GLB.
/// Codes: export/codes.h.
std::string write_gltf(const Scene& scene, const Prepared& ready, const Assets& assets,
                       const GltfOptions& options, Diagnostics& diagnostics);

}  // namespace scenefile
