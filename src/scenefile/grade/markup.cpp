#include "scenefile/grade/markup.h"

#include "scenefile/base/text.h"

#include <algorithm>

namespace scenefile {

std::string markup(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [value, bytes] = first_code_point(text);
    const char c = text.front();
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
      default:
        if ((static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') || value == 0xFFFE ||
            value == 0xFFFF) {
          result += '?';
        } else {
          result += bytes == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, bytes);
        }
    }
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return result;
}

}  // namespace scenefile
