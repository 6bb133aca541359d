#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace scenefile {

/// The shapes of the format. A closed set: switches over it have no default, so that adding a shape
/// gives a list of compile errors to fix.
enum class Shape : std::uint8_t { cube, cone, cylinder, sphere, mesh };

/// The lights of the format.
enum class LightType : std::uint8_t { point, directional, spot, area };

/// The format's words for them, indexed by enumerator.
inline constexpr std::array<std::string_view, 5> shape_words{"cube", "cone", "cylinder", "sphere",
                                                             "mesh"};
inline constexpr std::array<std::string_view, 4> light_words{"point", "directional", "spot",
                                                             "area"};

constexpr std::string_view word_of(Shape shape) {
  return shape_words[static_cast<std::size_t>(shape)];
}
constexpr std::string_view word_of(LightType type) {
  return light_words[static_cast<std::size_t>(type)];
}

}  // namespace scenefile
