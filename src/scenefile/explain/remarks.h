#pragma once
// Remarks about an explained pixel: common mistakes of people who write their own ray tracer.

#include "scenefile/trace/explain.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class RemarkKind : std::uint8_t {
  clamped,                ///< a sum exceeds 1 and is clamped
  seen_from_behind,       ///< the normal points away from the viewer
  normal_past_horizon,    ///< the shading normal points below the surface
  no_shininess,           ///< a specular color without an exponent
  texture_hidden,         ///< blend is 0
  texture_missing,        ///< the file could not be used
  no_transparent_share,   ///< transparent, but transparentcoeff is 0
  total_reflection,       ///< total internal reflection
  trapped,                ///< reflected inside without end
  too_deep,               ///< max_depth is reached
  too_faint,              ///< not followed, because it cannot be visible
  too_many,               ///< the sample has used up its rays
  light_behind,           ///< the surface faces away from a light
  highlight_from_behind,  ///< a light behind the surface makes a highlight
  shadow_acne,            ///< the shadow ray hits the surface it starts on
  shadow_by_itself,       ///< occluded by another side of the same object
  light_faded,            ///< attenuation leaves no visible light
  light_out_of_reach,     ///< outside the cone, behind the area light, or at its position
  light_of_another_mode,  ///< the course's ray caster only knows directional lights
};

/// "clamped", "seen-from-behind", ...
std::string_view remark_name(RemarkKind kind);

struct Remark {
  RemarkKind kind = RemarkKind::clamped;
  std::uint32_t ray = 0;           ///< index into PixelRecord::rays
  std::uint32_t light = no_index;  ///< into RenderScene::lights, if it is about a light
  std::string text;                ///< a sentence without a period
};

/// In the order of the rays, those about lights last. Empty for pictures of normals.
std::vector<Remark> remarks(const RenderScene& scene, const PixelRecord& pixel);

}  // namespace scenefile
