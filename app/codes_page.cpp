#include "app/codes_page.h"

#include "app/wrap.h"
#include "scenefile/verbs/codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace scenefile::app {

namespace {

constexpr std::string_view introduction =
    "# Diagnostics\n\n"
    "<!-- Made by `scenefile help --markdown`; a test holds it up to date. -->\n\n"
    "Everything that scenefile reports about a scene and its files, by code. `scenefile help CODE` "
    "prints\n"
    "the same text.\n\n"
    "- **error**: the scene cannot be used. Exit status 1, or 4 where a **limit** was reached.\n"
    "- **warning**: the scene is used, as the text says. `--deny warnings` or `--deny CODE` makes "
    "it an error.\n"
    "- **note**: worth knowing; does not count.\n"
    "- **dialect**: a spelling that only some programs read: an error with `--strict`.\n"
    "- **sometimes a warning** (an error, a note): the text says when.\n\n"
    "`--allow CODE` silences a warning or a note.\n";

// "camera" for "camera.look-zero".
std::string_view family_of(const Code& code) {
  return code.name.substr(0, code.name.find('.'));
}

// Escapes text for Markdown.
std::string markdown(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '<' || c == '*' || c == '_' || c == '\\' || c == '[') {
      result += '\\';
    }
    result += c;
  }
  return result;
}

}  // namespace

std::string codes_text(std::size_t terminal_width, std::string_view family) {
  std::string text;
  std::size_t width = 0;
  for (const std::string_view name : code_names()) {
    width = std::max(width, name.size());
  }
  for (const Code* code : all_codes()) {
    if (!family.empty() && family_of(*code) != family) {
      continue;
    }
    const std::string head =
        fmt::format("{:<{}}  {:<7}", code->name, width, severity_name(code->severity));
    const bool fits = head.size() + 2 + code->summary.size() <= terminal_width;
    text += fits ? fmt::format("{}  {}\n", head, code->summary)
                 : fmt::format("{}\n    {}\n", head, wrapped(code->summary, 4, 4, terminal_width));
  }
  return text + "\n\"scenefile help CODE\" says more.\n";
}

std::span<const std::string_view> code_families() {
  static const std::vector<std::string_view> families = [] {
    std::vector<std::string_view> result;
    for (const Code* code : all_codes()) {
      if (result.empty() || result.back() != family_of(*code)) {
        result.push_back(family_of(*code));
      }
    }
    return result;
  }();
  return families;
}

std::string severities_text(const Code& code) {
  std::string text(severity_name(code.severity));
  if (code.otherwise) {
    text += fmt::format(", sometimes {} {}", *code.otherwise == Severity::error ? "an" : "a",
                        severity_name(*code.otherwise));
  }
  if (code.kind == CodeKind::dialect) {
    return text + ", dialect";
  }
  return code.kind == CodeKind::limit ? text + ", limit" : text;
}

std::string codes_markdown() {
  std::string text(introduction);
  std::string_view family;
  for (const Code* code : all_codes()) {
    if (family_of(*code) != family) {
      family = family_of(*code);
      text += fmt::format("\n## {}\n", family);
    }
    text += fmt::format("\n### {}\n\n**{}**: {}. {}\n", code->name, severities_text(*code),
                        markdown(code->summary), markdown(code->help));
  }
  return text;
}

}  // namespace scenefile::app
