#pragma once
// The shapes and lights of the format. Closed sets: switches over them have no default, and arrays
// are sized by them, so that adding a member gives a list of compile errors to fix.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace scenefile {

/// The shapes of the format.
enum class Shape : std::uint8_t { cube, cone, cylinder, sphere, mesh };

/// The lights of the format.
enum class LightType : std::uint8_t { point, directional, spot, area };

/// The format's word.
constexpr std::string_view word_of(Shape shape) {
  switch (shape) {
    case Shape::cube:
      return "cube";
    case Shape::cone:
      return "cone";
    case Shape::cylinder:
      return "cylinder";
    case Shape::sphere:
      return "sphere";
    case Shape::mesh:
      return "mesh";
  }
  return {};
}
constexpr std::string_view word_of(LightType type) {
  switch (type) {
    case LightType::point:
      return "point";
    case LightType::directional:
      return "directional";
    case LightType::spot:
      return "spot";
    case LightType::area:
      return "area";
  }
  return {};
}

/// The number of enumerators: all that have a word.
template <typename Enum>
constexpr std::size_t count_of() {
  std::size_t count = 0;
  while (!word_of(static_cast<Enum>(count)).empty()) {
    ++count;
  }
  return count;
}
inline constexpr std::size_t shape_count = count_of<Shape>();
inline constexpr std::size_t light_type_count = count_of<LightType>();

/// The words of all enumerators, in their order.
template <typename Enum>
constexpr std::array<std::string_view, count_of<Enum>()> words_of() {
  std::array<std::string_view, count_of<Enum>()> words{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    words[i] = word_of(static_cast<Enum>(i));
  }
  return words;
}
inline constexpr auto shape_words = words_of<Shape>();
inline constexpr auto light_words = words_of<LightType>();

}  // namespace scenefile
