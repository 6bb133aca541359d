#pragma once
// Numbers as text, the same in every locale.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

enum class NumberError : std::uint8_t {
  none,
  empty,         ///< nothing but white space
  malformed,     ///< not a decimal number, or followed by something else
  out_of_range,  ///< a number, but too large for a float
};

struct ParsedNumber {
  double value = 0;  ///< for `malformed`: the longest prefix that is a number, or 0
  NumberError error = NumberError::none;
  std::size_t used = 0;  ///< bytes of the text up to the end of the number; 0 if there is none
};

/// Reads a decimal number: optional white space, sign, digits with an optional point (`.5` and
/// `5.` count), optional exponent, optional white space. No hexadecimal, infinity or not-a-number.
/// A value too small for a float is 0 or the nearest one.
ParsedNumber parse_number(std::string_view text);

/// Whether a valid number other than 0 underflows to 0 as a float.
bool underflows(std::string_view text, float value);

/// The shortest text that parse_number() reads back as the same float.
std::string number_text(float value);

}  // namespace scenefile
