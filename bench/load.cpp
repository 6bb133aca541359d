// scenefile_bench_load xml|json [TRANSBLOCKS [FILE]]: the time to read and to check a generated
// scene of so many objects (default: a million), against that of the XML or JSON library alone,
// which turns the text into tokens and forgets them. All in turns, of each the least of five. With
// FILE: writes the scene there, for measuring the program.

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
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace scenefile;

constexpr int runs = 5;

// Numbers of the length that exporters write.
float coordinate(std::size_t i, unsigned salt) {
  return static_cast<float>((i * 7919 + salt * 104729) % 200000) / 1000.0f - 100.0f;
}

std::string xml_scene(std::size_t count) {
  std::string text =
      "<scenefile>\n  <cameradata>\n    <pos x=\"0\" y=\"0\" z=\"200\"/>\n"
      "    <look x=\"0\" y=\"0\" z=\"-1\"/>\n    <up x=\"0\" y=\"1\" z=\"0\"/>\n"
      "    <heightangle v=\"60\"/>\n  </cameradata>\n  <object type=\"tree\" name=\"root\">\n";
  for (std::size_t i = 0; i < count; ++i) {
    fmt::format_to(std::back_inserter(text),
                   "    <transblock>\n      <translate x=\"{:.3f}\" y=\"{:.3f}\" z=\"{:.3f}\"/>\n"
                   "      <rotate x=\"0\" y=\"1\" z=\"0\" angle=\"{:.1f}\"/>\n"
                   "      <scale x=\"0.25\" y=\"0.5\" z=\"0.25\"/>\n"
                   "      <object type=\"primitive\" name=\"cube\">\n"
                   "        <diffuse r=\"0.5\" g=\"0.25\" b=\"{:.3f}\"/>\n      </object>\n"
                   "    </transblock>\n",
                   coordinate(i, 1), coordinate(i, 2), coordinate(i, 3), coordinate(i, 4),
                   coordinate(i, 5) * coordinate(i, 5) / 10000);
  }
  return text + "  </object>\n</scenefile>\n";
}

std::string json_scene(std::size_t count) {
  std::string text =
      "{\n  \"globalData\": {\"ambientCoeff\": 0.5, \"diffuseCoeff\": 0.5, \"specularCoeff\": "
      "0.5},\n  \"cameraData\": {\"position\": [0, 0, 200], \"up\": [0, 1, 0], \"look\": [0, 0, "
      "-1], \"heightAngle\": 60},\n  \"groups\": [\n";
  for (std::size_t i = 0; i < count; ++i) {
    fmt::format_to(std::back_inserter(text),
                   "    {}{{\n      \"translate\": [{:.3f}, {:.3f}, {:.3f}],\n"
                   "      \"rotate\": [0, 1, 0, {:.1f}],\n      \"scale\": [0.25, 0.5, 0.25],\n"
                   "      \"primitives\": [{{\"type\": \"cube\", \"diffuse\": [0.5, 0.25, "
                   "{:.3f}]}}]\n    }}\n",
                   i == 0 ? "" : ",", coordinate(i, 1), coordinate(i, 2), coordinate(i, 3),
                   coordinate(i, 4), coordinate(i, 5) * coordinate(i, 5) / 10000);
  }
  return text + "  ]\n}\n";
}

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

// In place, as the reader does it: overwrites the text.
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

// Of the processor, so that other programs do not count. The copy is there to be overwritten.
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
  const std::string text = json ? json_scene(count) : xml_scene(count);
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
