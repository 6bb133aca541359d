#include "generated_scene.h"

#include <fmt/format.h>

#include <iterator>

namespace scenefile::bench {

namespace {

// Numbers as long as those that exporters write.
float coordinate(std::size_t i, unsigned salt) {
  return static_cast<float>((i * 7919 + salt * 104729) % 200000) / 1000.0f - 100.0f;
}

}  // namespace

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

// Instances on a circle, each half as large as the whole.
std::string nested_scene(int levels) {
  constexpr int copies = 10;
  std::string text =
      "<scenefile>\n  <cameradata>\n    <pos x=\"0\" y=\"1.5\" z=\"3\"/>\n"
      "    <focus x=\"0\" y=\"0\" z=\"0\"/>\n    <up x=\"0\" y=\"1\" z=\"0\"/>\n"
      "    <heightangle v=\"45\"/>\n  </cameradata>\n"
      "  <lightdata>\n    <id v=\"0\"/>\n    <type v=\"directional\"/>\n"
      "    <color r=\"1\" g=\"1\" b=\"1\"/>\n    <direction x=\"-1\" y=\"-2\" z=\"-1\"/>\n"
      "  </lightdata>\n";
  for (int level = 0; level <= levels; ++level) {
    const std::string name = level == levels ? "root" : fmt::format("level{}", level);
    fmt::format_to(std::back_inserter(text), "  <object type=\"tree\" name=\"{}\">\n", name);
    for (int i = 0; i < (level == 0 ? 1 : copies); ++i) {
      const std::string object =
          level == 0 ? "<object type=\"primitive\" name=\"sphere\"/>"
                     : fmt::format("<object type=\"master\" name=\"level{}\"/>", level - 1);
      fmt::format_to(std::back_inserter(text),
                     "    <transblock><rotate x=\"0\" y=\"1\" z=\"0\" angle=\"{}\"/>"
                     "<translate x=\"{}\" y=\"{}\" z=\"0\"/><scale x=\"0.5\" y=\"0.5\" "
                     "z=\"0.5\"/>{}</transblock>\n",
                     36 * i, level == 0 ? 0 : 0.5, level == 0 ? 0.0 : 0.1 * (i % 2), object);
    }
    text += "  </object>\n";
  }
  return text + "</scenefile>\n";
}

}  // namespace scenefile::bench
