// Feeds JSON text to read_scene(), check() and prepare().

#include "read_and_judge.h"
#include "target.h"

#include <string_view>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos || (text[first] != '{' && text[first] != '[')) {
    return -1;
  }
  scenefile::fuzz::read_and_judge(text);
  return 0;
}
