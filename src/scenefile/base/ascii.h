#pragma once
// ASCII characters, whatever the locale; short names.

#include <cstddef>
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

/// The same as `a == b`, without a call of memcmp(), which takes longer than comparing a few
/// letters.
inline bool same_name(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] != b[i]) {
      return false;
    }
  }
  return true;
}

}  // namespace scenefile
