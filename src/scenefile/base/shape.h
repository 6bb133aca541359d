#pragma once

#include <cstdint>

namespace scenefile {

/// The shapes of the format. A closed set: switches over it have no default, so that a new shape
/// is a list of compile errors to fix.
enum class Shape : std::uint8_t { cube, cone, cylinder, sphere, mesh };

/// The lights of the format.
enum class LightType : std::uint8_t { point, directional, spot, area };

}  // namespace scenefile
