#pragma once
// Shadow maps. Internal to view.
//
// A directional light or a narrow spotlight has one map, a point light a cube of six. An area light
// has a cube at the center of each of its quarters, or a single cube if there are many. They do not
// depend on the camera.

#include "scenefile/view/device.h"
#include "scenefile/view/framing.h"
#include "scenefile/view/light_table.h"

#include <array>
#include <optional>
#include <vector>

namespace scenefile {

/// If lights need more layers, the rest have no shadows.
inline constexpr std::size_t max_shadow_layers = 96;

/// The shadow maps of an emitter: 2 * its first layer, + 1 for a cube; negative: no shadow.
using ShadowCode = int;

struct ShadowMaps {
  std::vector<Frame> views;       ///< by layer
  std::vector<ShadowCode> codes;  ///< by emitter
  int side = 0;                   ///< of a layer, pixels
  gl::Texture layers;
  gl::Texture table;  ///< of the layers, as read by shaders/scene.frag
  gl::Framebuffer framebuffer;
  std::optional<DrawOptions> made_for;
};

/// Texels per layer in the table.
inline constexpr int shadow_texels = 5;

/// Creates the layers and the drawing's emitters for these options, unless the existing ones match.
/// Returns the number of draw calls.
std::uint32_t make_shadows(GlDevice::State& device, Drawing::State& drawing,
                           const DrawOptions& options);

/// The number of lights without shadows because their layers did not fit.
std::uint32_t count_shadowless(const Drawing::State& drawing);

/// Binds layers and table for a camera at `eye`.
void bind_shadows(const gl::Functions& functions, ShadowMaps& shadows, const glm::dvec3& eye);

/// Assigns views to the emitters, and their codes.
void plan_shadows(const std::vector<Emitter>& emitters, const std::vector<WorldObject>& objects,
                  ShadowMaps& shadows);

}  // namespace scenefile
