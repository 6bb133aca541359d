#pragma once
// The kinds of values in a scene file, and the numbers that one may have.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace scenefile {

enum class ValueKind : std::uint8_t {
  number,
  vector,        ///< x, y, z: a point or direction
  color,         ///< r, g, b
  coefficients,  ///< constant, linear, quadratic
  rotation,      ///< x, y, z of the axis; degrees
  matrix,        ///< 16 numbers, row by row
  id,            ///< a whole number
  choice,        ///< one of some words
  text,
  file,  ///< name of an image or mesh
  image  ///< its file, and how often it repeats along u and v
};

constexpr std::string_view word_of(ValueKind kind) {
  constexpr std::string_view words[] = {"number",   "vector", "color", "coefficients",
                                        "rotation", "matrix", "id",    "choice",
                                        "text",     "file",   "image"};
  return words[static_cast<std::size_t>(kind)];
}

/// The numbers that a value may have without a warning.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open_low = false;  ///< `low` itself is excluded
  bool open_high = false;

  constexpr bool contains(double value) const {
    return (open_low ? value > low : value >= low) && (open_high ? value < high : value <= high);
  }
};

}  // namespace scenefile
