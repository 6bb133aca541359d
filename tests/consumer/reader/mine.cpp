// Reports what is wrong with a scene.
#include <scenefile/base/report.h>
#include <scenefile/format/read_scene.h>
#include <scenefile/scene/check.h>

#include <fstream>
#include <iostream>
#include <iterator>

int main(int, char** argv) {  // argument: a scene
  using namespace scenefile;
  std::ifstream file(argv[1], std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Diagnostics diagnostics;
  const Scene scene = read_scene(text, {}, diagnostics);
  check(scene, {}, diagnostics);
  std::cout << report_text(diagnostics, argv[1], text, {}) << verdict_text(diagnostics, argv[1])
            << '\n';
  return diagnostics.has_errors() ? 1 : 0;
}
