#include "scenefile/verbs/codes.h"

#include "scenefile/asset/codes.h"
#include "scenefile/export/codes.h"
#include "scenefile/format/codes.h"
#include "scenefile/import/codes.h"
#include "scenefile/placement/codes.h"
#include "scenefile/scene/codes.h"
#include "scenefile/view/codes.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <vector>

namespace scenefile {

namespace {

std::vector<const Code*> collect() {
  std::vector<const Code*> codes;
  for (const std::span<const Code> room : std::initializer_list<std::span<const Code>>{
           asset_codes, export_codes, format_codes, import_codes, placement_codes, scene_codes,
           verbs_codes, view_codes}) {
    for (const Code& code : room) {
      codes.push_back(&code);
    }
  }
  std::sort(codes.begin(), codes.end(),
            [](const Code* a, const Code* b) { return a->name < b->name; });
  return codes;
}

}  // namespace

std::span<const Code* const> all_codes() {
  static const std::vector<const Code*> codes = collect();
  return codes;
}

std::span<const std::string_view> code_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> result;
    for (const Code* code : all_codes()) {
      result.push_back(code->name);
    }
    return result;
  }();
  return names;
}

const Code* find_code(std::string_view name) {
  // Older versions spelled "misspelled" in codes this way.
  static constexpr std::string_view old_word = "misspelt";
  std::string today(name);
  if (const std::size_t at = today.find(old_word); at != std::string::npos) {
    today.replace(at, old_word.size(), "misspelled");
  }
  const auto codes = all_codes();
  const auto found =
      std::find_if(codes.begin(), codes.end(), [&](const Code* c) { return c->name == today; });
  return found == codes.end() ? nullptr : *found;
}

std::string_view severity_name(Severity severity) {
  static constexpr std::array<std::string_view, 3> names{"note", "warning", "error"};
  return names[static_cast<std::size_t>(severity)];
}

}  // namespace scenefile
