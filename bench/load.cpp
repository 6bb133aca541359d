// scenefile_bench_load xml|json|nested [TRANSBLOCKS [FILE]]: the time to read and check a generated
// scene with that many objects (default: a million), compared with only tokenizing the text with
// the XML or JSON library. Interleaved; the minimum of five runs each. With FILE: writes the scene
// there, for measuring the program; for "nested", the number is that of levels.

#include "generated_scene.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/check.h"

#include <expat.h>
#include <fmt/format.h>
#include <rapidjson/reader.h>
#include <rapidjson/stream.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace scenefile;
using namespace scenefile::bench;

constexpr int runs = 5;

void tokenize_xml(std::string& text) {
  XML_Parser parser = XML_ParserCreate("UTF-8");
  XML_SetElementHandler(
      parser, [](void*, const XML_Char*, const XML_Char**) {}, [](void*, const XML_Char*) {});
  XML_SetCharacterDataHandler(parser, [](void*, const XML_Char*, int) {});
  constexpr std::size_t chunk = std::size_t{64} << 10;
  for (std::size_t at = 0; at < text.size(); at += chunk) {
    const std::size_t size = std::min(chunk, text.size() - at);
    XML_Parse(parser, text.data() + at, static_cast<int>(size), at + size == text.size());
  }
  XML_ParserFree(parser);
}

// In place, like the reader: overwrites the text.
template <unsigned numbers>
void tokenize_json(std::string& text) {
  rapidjson::InsituStringStream stream(text.data());
  rapidjson::BaseReaderHandler<> nobody;
  rapidjson::Reader()
      .Parse<rapidjson::kParseIterativeFlag | rapidjson::kParseInsituFlag |
             rapidjson::kParseValidateEncodingFlag | numbers>(stream, nobody);
}

void read_alone(std::string& text) {
  Diagnostics diagnostics;
  read_scene(text, {}, diagnostics);
}

void read_and_check(std::string& text) {
  Diagnostics diagnostics;
  const Scene scene = read_scene(text, {}, diagnostics);
  check(scene, {}, diagnostics);
  if (diagnostics.has_errors()) {
    std::puts("the generated scene has errors");
    std::exit(1);
  }
}

struct Contestant {
  const char* name;
  void (*run)(std::string& text);
  double seconds = 1e30;
};

// CPU time, so that other programs do not count. `text` is a copy because it is overwritten.
double seconds(const Contestant& contestant, std::string text) {
  const std::clock_t start = std::clock();
  contestant.run(text);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::vector<Contestant> contestants(bool json) {
  if (json) {
    return {{"RapidJSON, numbers as text", tokenize_json<rapidjson::kParseNumbersAsStringsFlag>},
            {"RapidJSON, exact numbers", tokenize_json<rapidjson::kParseFullPrecisionFlag>},
            {"read", read_alone},
            {"read and check", read_and_check}};
  }
  return {{"Expat", tokenize_xml}, {"read", read_alone}, {"read and check", read_and_check}};
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = argc > 1 && std::string(argv[1]) == "json";
  const std::size_t count = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1'000'000;
  const bool nested = argc > 3 && std::string(argv[1]) == "nested";
  const std::string text = nested ? nested_scene(static_cast<int>(count))
                           : json ? json_scene(count)
                                  : xml_scene(count);
  if (argc > 3) {
    return (std::ofstream(argv[3], std::ios::binary) << text).flush() ? 0 : 1;
  }
  std::vector<Contestant> all = contestants(json);
  for (int run = 0; run < runs; ++run) {
    for (Contestant& contestant : all) {
      contestant.seconds = std::min(contestant.seconds, seconds(contestant, text));
    }
  }
  std::puts(fmt::format("{:.1f} MB", static_cast<double>(text.size()) / 1e6).c_str());
  for (const Contestant& contestant : all) {
    std::puts(fmt::format("{:<28}{:.3f} s{:>8.2f} times the first", contestant.name,
                          contestant.seconds, contestant.seconds / all[0].seconds)
                  .c_str());
  }
}
