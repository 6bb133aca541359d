#include "scenefile/gradebook/markup.h"

#include "scenefile/base/text.h"

#include <fmt/format.h>

namespace scenefile {

std::string markup(std::string_view text) {
  std::string result;
  const std::string valid = valid_utf8(text);
  for (std::string_view rest = valid; !rest.empty();) {
    const auto [value, bytes] = first_code_point(rest);
    const char c = rest.front();
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        if ((static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') || value == 0xFFFE ||
            value == 0xFFFF) {
          result += '?';
        } else {
          result += rest.substr(0, bytes);
        }
    }
    rest.remove_prefix(bytes);
  }
  return result;
}

std::string link_to(std::string_view path) {
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~/";
  std::string result;
  for (const char c : path) {
    result += plain.find(c) != std::string_view::npos
                  ? std::string(1, c)
                  : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return result;
}

}  // namespace scenefile
