#pragma once
// From a scene to glTF 2.0 (Khronos Group, glTF 2.0 Specification, 2021), which Blender, web pages
// and most other programs open.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/scene.h"

#include <cstddef>
#include <string>

namespace scenefile {

struct GltfOptions {
  bool binary = true;        ///< GLB, one binary file; else JSON with its data inside as base64
  int segments = 64;         ///< of a full turn of round sides; see geometry/tessellate.h
  float transparent = 0.5f;  ///< kt where the scene gives none
  std::size_t most_nodes = 4'000'000;  ///< of the file; templates count once for each copy
};

/// Writes the scene; `ready` is what prepare() made of it, `assets` the textures and meshes of its
/// files. The tree of the scene stays, with its names; a template is copied for each of its
/// instances, but meshes and materials are shared. A transform that shears becomes two nodes.
/// Lights stand beside the objects, in world space. How materials and lights are said in glTF:
/// export/phong_pbr.h, docs/formats.md. Materials and lights also carry the format's own values, in
/// `extras.scenefile`.
///
/// Each thing that glTF says in another way, or not at all, is reported once. Returns nothing and
/// reports an error when the file would have too many nodes, or be larger than GLB can be. Codes:
/// export/codes.h.
std::string write_gltf(const Scene& scene, const Prepared& ready, const Assets& assets,
                       const GltfOptions& options, Diagnostics& diagnostics);

}  // namespace scenefile
