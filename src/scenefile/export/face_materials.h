#pragma once
// Scenes that are lit by faces alone, for formats whose objects have one material each.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/render_scene.h"

namespace scenefile {

/// Changes a scene so that its materials are those of path tracing (docs/path.md), which must be
/// written with the option `path`: each mesh with face materials becomes one mesh for each of them;
/// coefficients become 1, multiplied into the materials; `ambient` is what a surface emits, and
/// `specular` the share of light that its glossy lobe reflects; a texture of blend 1 multiplies
/// `diffuse`. `transparent`: the coefficient to use if the scene gives none. `maps`: use the
/// textures of face materials. What a material cannot express is reported once. Codes:
/// export/codes.h.
void use_face_materials(RenderScene& scene, Assets& assets, float transparent, bool maps,
                        Diagnostics& diagnostics);

/// The strength of Phong's highlight (R.V)^n, as in mode ray, that looks like a lobe that reflects
/// the share 1: (n + 2) / 2. (E. Lafortune and Y. Willems, Using the Modified Phong Reflectance
/// Model for Physically Based Rendering, 1994: the lobe is (n + 2) / (2 pi) (R.V)^n.)
constexpr float highlight_of_lobe(float shininess) {
  return (shininess + 2) / 2;
}

}  // namespace scenefile
