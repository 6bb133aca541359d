#pragma once
// The parts of a scene file with their ranges: for the outline, templates and their uses, colors,
// and what values are. Internal to lsp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class OutlineKind : std::uint8_t { globals, camera, light, group, primitive, instance, tree };

/// All ranges are bytes of the text, [from, to).
struct OutlinePart {
  OutlineKind kind = OutlineKind::group;
  std::string name;
  std::string detail;  ///< a type; may be empty
  std::size_t from = 0;
  std::size_t to = 0;
  std::uint32_t depth = 0;
};

/// The name of a template, where it is declared or used.
struct NameUse {
  std::string name;
  std::size_t from = 0;  ///< inside its quotes
  std::size_t to = 0;
  bool declares = false;
};

struct ColorValue {
  std::array<float, 3> rgb{};
  std::size_t from = 0;  ///< XML: from the first attribute to the last; JSON: the array
  std::size_t to = 0;
};

/// A value in XML that is not just text, as the quotes say: a number, or a word of the format.
struct PlainValue {
  std::size_t from = 0;  ///< inside its quotes
  std::size_t to = 0;
  bool number = false;
};

struct Outline {
  std::vector<OutlinePart> parts;  ///< each before those inside it
  std::vector<NameUse> names;      ///< in the order of the text
  /// Names that would become uses of a template if one had them.
  std::vector<std::string> other_names;
  std::vector<ColorValue> colors;  ///< with components from 0 to 1 only
  std::vector<PlainValue> values;
};

/// Of XML that is not well-formed, what its tags say; of such JSON, nothing.
Outline read_outline(std::string_view text);

/// How a color is written, as the format does: `r="1" g="0.5" b="0"` or `[1, 0.5, 0]`.
std::string color_text(const std::array<double, 3>& rgb, bool xml);

}  // namespace scenefile
