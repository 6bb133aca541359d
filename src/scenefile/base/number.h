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
  malformed,     ///< not a decimal number, or something follows it
  out_of_range,  ///< a number, but no finite float can hold it
};

struct ParsedNumber {
  double value = 0;  ///< also under `malformed`: of the longest prefix that is a number, else 0
  NumberError error = NumberError::none;
  std::size_t used = 0;  ///< bytes of the text up to the end of the number; 0: there is none
};

/// Reads a decimal number: optional white space, sign, digits with an optional point (`.5` and
/// `5.` count), optional exponent, optional white space. No hexadecimal, infinity or not-a-number.
/// A value too small for a float is 0 or the nearest one.
ParsedNumber parse_number(std::string_view text);

/// Whether a valid number other than 0 becomes 0 because no float is as small.
bool underflows(std::string_view text, float value);

/// The shortest text that parse_number() reads back as the same float.
std::string number_text(float value);

}  // namespace scenefile
