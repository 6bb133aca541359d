#include "finding_laws.h"

#include "law.h"
#include "scenefile/base/report.h"
#include "scenefile/base/text.h"

#include <algorithm>
#include <unordered_map>

namespace scenefile::fuzz {

namespace {

constexpr std::size_t max_message_bytes = 2000;

bool visible(std::string_view text) {
  while (!text.empty()) {
    const CodePoint c = first_code_point(text);
    if (c.bytes == 0 || (c.value != U'\n' && is_invisible(c.value))) {
      return false;
    }
    text.remove_prefix(c.bytes);
  }
  return true;
}

bool one_line_of_utf8(std::string_view text) {
  while (!text.empty()) {
    const CodePoint c = first_code_point(text);
    if (c.bytes == 0 || c.value == U'\n' || c.value == U'\r') {
      return false;
    }
    text.remove_prefix(c.bytes);
  }
  return true;
}

void require_bounded(const Diagnostics& diagnostics, const Limits& limits) {
  std::unordered_map<const Code*, std::size_t> kept;
  std::size_t bytes = 0;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    // The first finding of each code is kept, whatever its length.
    if (kept[diagnostic.code]++ != 0) {
      bytes += diagnostic.message.size() + diagnostic.file.size();
    }
    require(diagnostic.code != nullptr, "a finding has a code");
    require(kept[diagnostic.code] <= std::max(limits.messages_per_code, 1u),
            "messages of a kind are bounded");
  }
  require(bytes <= limits.message_bytes, "messages are bounded in all");
}

}  // namespace

Limits narrow_limits() {
  Limits limits;
  limits.nesting = 12;
  limits.attributes = 6;
  limits.name_bytes = 24;
  limits.value_bytes = 32;
  limits.messages_per_code = 2;
  limits.message_bytes = 600;
  limits.lights = 3;
  limits.instance_nesting = 3;
  return limits;
}

void require_sound(const Diagnostics& diagnostics, const Limits& limits, std::string_view text) {
  require_bounded(diagnostics, limits);
  const auto line_ends = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }));
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    require(one_line_of_utf8(diagnostic.message), "a message is one line of UTF-8");
    require(diagnostic.message.size() <= max_message_bytes, "a message is short");
    if (diagnostic.file.empty()) {
      require(diagnostic.location.line <= line_ends + 1, "a line is one of the file");
      require(diagnostic.location.column <= text.size() + 1, "a column is one of the file");
    }
  }
  require(visible(report_text(diagnostics, "scene", text, {.color = false})),
          "a report shows nothing but text");
}

}  // namespace scenefile::fuzz
