#pragma once
// Classes of ASCII characters, whatever the locale.

#include <string_view>

namespace scenefile {

/// White space of XML and JSON.
inline constexpr std::string_view blanks = " \t\r\n";

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// A letter A to Z as a lower-case letter; other characters as they are.
inline char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace scenefile
