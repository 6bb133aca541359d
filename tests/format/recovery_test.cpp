// After an error the rest is still checked, without false findings.

#include "format/reading.h"
#include "scenefile/format/codes.h"
#include "scenefile/scene/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace scenefile::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Diagnostics all_findings(std::string_view text) {
  Reading reading = read(text);
  check(reading.scene, Limits{}, reading.diagnostics);
  return reading.diagnostics;
}

constexpr std::string_view xml_scene = R"(<scenefile>
 <globaldata>
  <ambientcoeff v="0.5"/> <diffusecoeff v="0.6"/> <specularcoeff v="0.5"/>
  <transparentcoeff v="0.4"/>
 </globaldata>
 <cameradata>
  <pos x="5" y="4" z="3"/> <focus x="0" y="0" z="0"/> <up x="0" y="1" z="0"/>
  <heightangle v="30"/> <aperture v="0.1"/> <focallength v="7"/>
 </cameradata>
 <lightdata>
  <id v="0"/> <type v="point"/> <color r="1" g="1" b="1"/> <function v1="1" v2="0.5" v3="0"/>
  <position x="3" y="3" z="3"/>
 </lightdata>
 <lightdata>
  <id v="1"/> <type v="directional"/> <color r="1" g="1" b="1"/> <direction x="1" y="-1" z="1"/>
 </lightdata>
 <lightdata>
  <id v="2"/> <type v="spot"/> <color r="1" g="1" b="1"/> <direction x="1" y="-1" z="1"/>
  <position x="3" y="3" z="3"/> <angle v="30"/> <penumbra v="10"/> <function v1="1" v2="1" v3="1"/>
 </lightdata>
 <object type="tree" name="wheel">
  <transblock>
   <rotate x="1" y="1" z="1" angle="30"/>
   <object type="primitive" name="cylinder">
    <diffuse r="1" g="0" b="0"/> <ambient r="1" g="0" b="0"/>
    <specular r="0.5" g="0.5" b="0.5"/> <shininess v="20"/>
    <transparent r="1" g="1" b="1"/> <ior v="1.5"/>
   </object>
  </transblock>
 </object>
 <object type="tree" name="root">
  <transblock>
   <translate x="1" y="1" z="1"/> <scale x="2" y="2" z="2"/>
   <matrix>
    <row a="1" b="1" c="0" d="0"/> <row a="0" b="1" c="0" d="0"/>
    <row a="0" b="0" c="1" d="0"/> <row a="0" b="0" c="0" d="1"/>
   </matrix>
   <object type="master" name="wheel"/>
  </transblock>
  <transblock>
   <object type="primitive" name="sphere">
    <diffuse r="1" g="1" b="1"/> <texture file="a.png" u="1" v="1"/> <blend v="0.5"/>
    <reflective r="0.5" g="0.5" b="0.5"/>
   </object>
  </transblock>
  <transblock>
   <object type="primitive" name="mesh" filename="a.obj"/>
  </transblock>
 </object>
</scenefile>
)";

constexpr std::string_view json_scene = R"({
 "name": "all",
 "globalData": {"ambientCoeff": 0.5, "diffuseCoeff": 0.5, "specularCoeff": 0.5,
  "transparentCoeff": 0.5},
 "cameraData": {"position": [5, 4, 3], "up": [0, 1, 0], "look": [-5, -4, -3],
  "heightAngle": 30, "aperture": 0.1, "focalLength": 5},
 "templateGroups": [
  {"name": "wheel", "rotate": [1, 1, 1, 30], "primitives": [
   {"type": "cylinder", "diffuse": [1, 0, 0], "specular": [1, 1, 1], "shininess": 5,
    "transparent": [1, 1, 1], "ior": 1.5}]}],
 "groups": [
  {"translate": [1, 1, 1], "scale": [2, 2, 2], "groups": [{"name": "wheel"}]},
  {"lights": [
    {"type": "point", "color": [1, 1, 1], "attenuationCoeff": [1, 0, 1]},
    {"type": "directional", "color": [1, 1, 1], "direction": [1, -1, 1]},
    {"type": "spot", "color": [1, 1, 1], "direction": [1, -1, 1], "angle": 30, "penumbra": 9,
     "attenuationCoeff": [1, 0, 0]}]},
  {"primitives": [
   {"type": "sphere", "textureFile": "a.png", "textureU": 1, "textureV": 1, "blend": 0.5},
   {"type": "mesh", "meshFile": "a.obj", "reflective": [0.5, 0.5, 0.5]}]}]
}
)";

// A scene with one mistake, and a description of the mistake.
struct Mistake {
  std::string text;
  std::string what;
};

Mistake replaced(std::string_view text, std::size_t at, std::size_t size, std::string_view by) {
  Mistake mistake{std::string(text), {}};
  mistake.text.replace(at, size, by);
  const std::size_t line = text.rfind('\n', at) + 1;
  mistake.what = mistake.text.substr(line, mistake.text.find('\n', line) - line);
  return mistake;
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_number_part(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
}

// Calls `use` for each long enough run of such characters between two of `borders`.
template <typename Is>
void for_each_word(std::string_view text, Is is, std::size_t shortest, const auto& use) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is(text[end])) {
      ++end;
    }
    if (end - at >= shortest) {
      use(at, end - at);
    }
    at = std::max(end, at + 1);
  }
}

std::vector<Mistake> bad_numbers(std::string_view text, std::string_view bad) {
  std::vector<Mistake> mistakes;
  for_each_word(text, is_number_part, 1, [&](std::size_t at, std::size_t size) {
    const char before = text[at - 1];
    if (before == '"' || before == ' ' || before == '[') {
      mistakes.push_back(replaced(text, at, size, bad));
    }
  });
  return mistakes;
}

// Removes the second last letter of each word, which keeps the meaning clear; not of `kept` words.
std::vector<Mistake> misspellings(std::string_view text, const std::vector<std::string>& kept) {
  std::vector<Mistake> mistakes;
  for_each_word(text, is_letter, 4, [&](std::size_t at, std::size_t size) {
    const std::string word(text.substr(at, size));
    if (std::find(kept.begin(), kept.end(), word) == kept.end()) {
      mistakes.push_back(replaced(text, at + size - 2, 1, ""));
    }
  });
  return mistakes;
}

void expect_one_finding(const std::vector<Mistake>& mistakes) {
  ASSERT_GT(mistakes.size(), 20u);
  for (const Mistake& mistake : mistakes) {
    const Diagnostics found = all_findings(mistake.text);
    EXPECT_EQ(found.list().size(), 1u) << mistake.what << "\n"
                                       << ::testing::PrintToString(messages(found));
  }
}

TEST(Recovery, TheOriginalScenesHaveNoFindings) {
  EXPECT_THAT(messages(all_findings(xml_scene)), IsEmpty());
  EXPECT_THAT(messages(all_findings(json_scene)), IsEmpty());
}

TEST(Recovery, OneBadNumberGivesOneFinding) {
  std::vector<Mistake> xml = bad_numbers(xml_scene, "1x");
  // Ids have no effect, so an invalid id is not an error.
  std::erase_if(xml, [](const Mistake& m) { return m.what.find("<id v=\"1x\"") != m.what.npos; });
  expect_one_finding(xml);
  for (const std::string_view bad : {"\"1\"", ".5", "NaN", "true", "null", "1e999"}) {
    std::vector<Mistake> json = bad_numbers(json_scene, bad);
    // An invalid repeat counts as 1.
    std::erase_if(json, [](const Mistake& m) { return m.what.find("texture") != m.what.npos; });
    expect_one_finding(json);
  }
}

TEST(Recovery, OneMisspellingGivesOneFinding) {
  // Skips elements that have end tags, and arbitrary names.
  expect_one_finding(misspellings(xml_scene, {"scenefile", "globaldata", "cameradata", "lightdata",
                                              "object", "transblock", "matrix", "root", "wheel"}));
  expect_one_finding(misspellings(json_scene, {"wheel"}));
}

TEST(Recovery, OneMissingCommaGivesOneFinding) {
  std::vector<Mistake> mistakes;
  for (std::size_t at = json_scene.find(','); at != json_scene.npos;
       at = json_scene.find(',', at + 1)) {
    mistakes.push_back(replaced(json_scene, at, 1, ""));
  }
  expect_one_finding(mistakes);
}

// Removes each element without an end tag: only findings about what needs it are reported.
TEST(Recovery, CutOffFilesAreCheckedAsFarAsTheyGo) {
  for (std::size_t size = 1; size < xml_scene.size() - 1; ++size) {
    const Diagnostics found = all_findings(xml_scene.substr(0, size));
    EXPECT_THAT(findings(found), ElementsAre(::testing::HasSubstr("error"))) << size;
  }
}

}  // namespace
}  // namespace scenefile::testing
