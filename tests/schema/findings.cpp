// Prints the findings of reader and check, without assets. Reads one path per line and answers each
// with a line: the path, a tab, and the codes of its errors and warnings.

#include "scenefile/format/read_scene.h"
#include "scenefile/scene/check.h"

#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <string>

namespace {

std::set<std::string_view> codes_of(const std::string& text) {
  scenefile::Limits limits;
  limits.message_bytes = std::numeric_limits<std::uint32_t>::max();
  scenefile::ReadOptions options;
  options.limits = limits;
  scenefile::Diagnostics diagnostics(limits);
  const scenefile::Scene scene = scenefile::read_scene(text, options, diagnostics);
  if (!diagnostics.has_errors()) {
    scenefile::check(scene, limits, diagnostics);
  }
  std::set<std::string_view> codes;
  for (const scenefile::Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.severity != scenefile::Severity::note) {
      codes.insert(diagnostic.code->name);
    }
  }
  return codes;
}

}  // namespace

int main() {
  std::string path;
  while (std::getline(std::cin, path)) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
      std::cerr << "cannot open " << path << '\n';
      return 3;
    }
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::cout << path << '\t';
    for (const std::string_view code : codes_of(text)) {
      std::cout << code << ' ';
    }
    std::cout << '\n';
  }
}
