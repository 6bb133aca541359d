#pragma once
// Depth images as the lights see the scene. Internal to the room.
//
// A directional light and a narrow spotlight have one, a point light six about it, an area light
// six about the middle of each of its quarters, or six in all where there are many. They do not
// depend on the camera.

#include "scenefile/view/device.h"
#include "scenefile/view/framing.h"
#include "scenefile/view/light_table.h"

#include <array>
#include <optional>
#include <vector>

namespace scenefile {

/// More lights than have room in so many layers shine without shadows.
inline constexpr std::size_t max_shadow_layers = 96;

/// Which shadow an emitter throws: 2 * its first layer, + 1 for six layers; none where negative.
using ShadowCode = int;

struct ShadowMaps {
  std::vector<Frame> views;       ///< by layer
  std::vector<ShadowCode> codes;  ///< by emitter
  int side = 0;                   ///< of a layer, pixels
  gl::Texture layers;
  gl::Texture table;  ///< of the layers, as shaders/scene.frag reads them
  gl::Framebuffer framebuffer;
  std::optional<DrawOptions> made_for;
};

/// Texels of a layer in the table.
inline constexpr int shadow_texels = 5;

/// Makes the layers, and the drawing's emitters, for these options, where those at hand are for
/// others. Returns how many draw calls that took.
std::uint32_t make_shadows(GlDevice::State& device, Drawing::State& drawing,
                           const DrawOptions& options);

/// Lights that should throw shadows and found no room for their layers.
std::uint32_t count_shadowless(const Drawing::State& drawing);

/// Binds layers and table for a camera that stands at `eye`.
void bind_shadows(const gl::Functions& functions, ShadowMaps& shadows, const glm::dvec3& eye);

/// The views of the emitters, and their codes.
void plan_shadows(const std::vector<Emitter>& emitters, const std::vector<WorldObject>& objects,
                  ShadowMaps& shadows);

}  // namespace scenefile
