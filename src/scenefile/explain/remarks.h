#pragma once
// Facts about an explained pixel that people trip over who write a ray tracer of their own.

#include "scenefile/trace/explain.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class RemarkKind : std::uint8_t {
  clamped,                ///< a sum exceeds 1 and is cut
  seen_from_behind,       ///< the normal points away from the viewer
  normal_past_horizon,    ///< shading normal and surface face different sides
  no_shininess,           ///< a highlight without exponent
  texture_hidden,         ///< blend is 0
  texture_missing,        ///< the file could not be used
  no_transparent_share,   ///< transparent, but kt is 0
  total_reflection,       ///< no light passes a surface
  trapped,                ///< mirrored inside without end
  too_deep,               ///< max_depth is reached
  too_faint,              ///< not followed: it cannot show
  too_many,               ///< the sample has spent its rays
  light_behind,           ///< the surface faces away from a light
  highlight_from_behind,  ///< a light behind the surface makes a highlight
  shadow_acne,            ///< the shadow ray meets the surface it starts on
  shadow_by_itself,       ///< another side of the object is in the way
  light_faded,            ///< attenuation leaves less than shows
  light_out_of_reach,     ///< outside the cone, behind the area, or at the light
  light_of_another_mode,  ///< the course's ray caster knows directional lights alone
};

/// "clamped", "seen-from-behind", ...
std::string_view remark_name(RemarkKind kind);

struct Remark {
  RemarkKind kind = RemarkKind::clamped;
  std::uint32_t ray = 0;           ///< index into PixelRecord::rays
  std::uint32_t light = no_index;  ///< into RenderScene::lights, where it is about one
  std::string text;                ///< a sentence without a period
};

/// In the order of the rays, those about lights last. None for pictures of normals.
std::vector<Remark> remarks(const RenderScene& scene, const PixelRecord& pixel);

}  // namespace scenefile
