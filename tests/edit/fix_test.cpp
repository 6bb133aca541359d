#include "scenefile/edit/fix.h"

#include "scenefile/format/codes.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace scenefile {
namespace {

Diagnostics findings_of(const std::string& text, const ReadOptions& options = {}) {
  Diagnostics findings;
  check(read_scene(text, options, findings), options.limits, findings);
  return findings;
}

// A scene with one transblock, whose contents `object` are.
std::string xml_with(const std::string& object) {
  return R"(<scenefile>
  <globaldata><diffusecoeff v="0.5"/><ambientcoeff v="0.5"/><specularcoeff v="0.5"/></globaldata>
  <cameradata>
    <pos x="5" y="5" z="5"/><look x="-1" y="-1" z="-1"/><up x="0" y="1" z="0"/><heightangle v="45"/>
  </cameradata>
  <lightdata>
    <id v="0"/><type v="point"/><color r="1" g="1" b="1"/><position x="3" y="3" z="3"/>
    <function v1="1" v2="0" v3="0"/>
  </lightdata>
  <object type="tree" name="chair">
    <transblock><object type="primitive" name="cube"><diffuse r="1" g="1" b="1"/></object></transblock>
  </object>
  <object type="tree" name="root">
    <transblock>
<object type="master" name="chair"/>
    </transblock>
    <transblock>
)" + object +
         R"(
    </transblock>
  </object>
</scenefile>
)";
}

std::string json_with(const std::string& group) {
  return R"({
  "globalData": {"ambientCoeff": 0.5, "diffuseCoeff": 0.5, "specularCoeff": 0.5},
  "cameraData": {"position": [5, 5, 5], "look": [-1, -1, -1], "up": [0, 1, 0], "heightAngle": 45},
  "templateGroups": [{"name": "chair", "primitives": [{"type": "cube"}]}],
  "groups": [
    {"lights": [{"type": "directional", "color": [1, 1, 1], "direction": [0, -1, 0]}]},
    {"name": "chair"},
)" + group +
         "\n  ]\n}\n";
}

struct FixCase {
  const char* name;
  std::string before;
  std::string after;  // the same: nothing is certain
};

const std::vector<FixCase> xml_cases{
    {"Element",
     R"(<object type="primitive" name="cube"><difuse r="1" g="0" b="1"></difuse></object>)",
     R"(<object type="primitive" name="cube"><diffuse r="1" g="0" b="1"></diffuse></object>)"},
    {"ClosingTag", R"(<object type="primitive" name="cube"><diffuse r="1" g="0" b="1"/></objekt>)",
     R"(<object type="primitive" name="cube"><diffuse r="1" g="0" b="1"/></object>)"},
    {"ClosedTwice",
     R"(<translate x="1" y="0" z="0"/></translate><object type="master" name="chair"/>)",
     R"(<translate x="1" y="0" z="0"/><object type="master" name="chair"/>)"},
    {"Attribute", R"(<rotate x="0" y="1" z="0" angel="30"/><object type="master" name="chair"/>)",
     R"(<rotate x="0" y="1" z="0" angle="30"/><object type="master" name="chair"/>)"},
    {"LetterCase", R"(<Object type="Primitive" name="SPHERE"></Object>)",
     R"(<object type="primitive" name="sphere"></object>)"},
    {"LetterCaseOfAttributes",
     R"(<scale Z="3" Y="2" X="1"/><object type="primitive" name="cube"><diffuse B="1" G="0" r="1"/><ambient X="1" Y="0" Z="0"/></object>)",
     R"(<scale z="3" y="2" x="1"/><object type="primitive" name="cube"><diffuse b="1" g="0" r="1"/><ambient r="1" g="0" b="0"/></object>)"},
    {"LetterCaseOfRepeats",
     R"(<object type="primitive" name="cube"><texture file="a.png" U="2" V="3"/><bumpmap file="b.png" U="2" v="3"/></object>)",
     R"(<object type="primitive" name="cube"><texture file="a.png" u="2" v="3"/><bumpmap file="b.png" u="2" v="3"/></object>)"},
    {"Comma", R"(<scale x="0,5" y="1" z="1"/><object type="master" name="chair"/>)",
     R"(<scale x="0.5" y="1" z="1"/><object type="master" name="chair"/>)"},
    {"Quotes", "<scale x=2 y='2' z=\u201C3\u201D/><object type=\"master\" name=\"chair\"/>",
     R"(<scale x="2" y='2' z="3"/><object type="master" name="chair"/>)"},
    {"ClosingQuotes",
     R"(<scale x="2 y="3" z='4/><object type="primitive" name="cube filename="a/b.obj/>)",
     R"(<scale x="2" y="3" z="4"/><object type="primitive" name="cube" filename="a/b.obj"/>)"},
    {"Slash",
     R"(<scale x="2" y="3" z="4"> <!-- tall --> <rotate x="0" y="1" z="0" angle="3"><object type="master" name="chair"/>)",
     R"(<scale x="2" y="3" z="4"/> <!-- tall --> <rotate x="0" y="1" z="0" angle="3"/><object type="master" name="chair"/>)"},
    {"OneForAll",
     R"(<scale v="1 2 3"/><rotate x='0, 1, 0, 30'/><object type="primitive" name="cube"><diffuse rgb="1,0,0"/></object>)",
     R"(<scale x="1" y="2" z="3"/><rotate x="0" y="1" z="0" angle="30"/><object type="primitive" name="cube"><diffuse r="1" g="0" b="0"/></object>)"},
    {"Name", R"(<object type="master" name="chiar"/>)", R"(<object type="master" name="chair"/>)"},
    {"Color", R"(<object type="primitive" name="cube"><diffuse x="1" y="0" z="1"/></object>)",
     R"(<object type="primitive" name="cube"><diffuse r="1" g="0" b="1"/></object>)"},
    {"Ampersand",
     R"(<object type="primitive" name="cube"><diffuse r="1" g="1" b="1"/><texture file="a&b.png" u="1" v="1"/><blend v="1"/></object>)",
     R"(<object type="primitive" name="cube"><diffuse r="1" g="1" b="1"/><texture file="a&amp;b.png" u="1" v="1"/><blend v="1"/></object>)"},
    {"Several",
     R"(<trnslate x="1" y="0" z="0"/><object tpye="primitve" name="cilinder"><difuse r="1" g="0,5" b="0"/></object>)",
     R"(<translate x="1" y="0" z="0"/><object type="primitive" name="cylinder"><diffuse r="1" g="0.5" b="0"/></object>)"},
    {"Ampersands",
     R"(<object type="primitive" name="cube"><texture file="a&b&&c.png" u="1" v="1"/><!-- & --></object><object type="primitive" name="cone"><bumpmap file="a & b" u="1" v="1"/></object>)",
     R"(<object type="primitive" name="cube"><texture file="a&amp;b&amp;&amp;c.png" u="1" v="1"/><!-- & --></object><object type="primitive" name="cone"><bumpmap file="a &amp; b" u="1" v="1"/></object>)"},
    // What would join lines.
    {"Lines", "<scale v=\"1\n2\n3\"/><object type=\"master\" name=\"chair\"/>",
     "<scale v=\"1\n2\n3\"/><object type=\"master\" name=\"chair\"/>"},
    // What could mean something else.
    {"Thousand", R"(<scale x="1,000" y="1" z="1"/><object type="master" name="chair"/>)",
     R"(<scale x="1,000" y="1" z="1"/><object type="master" name="chair"/>)"},
    {"LetterForDigit", R"(<scale x="1O" y="1" z="1"/><object type="master" name="chair"/>)",
     R"(<scale x="1O" y="1" z="1"/><object type="master" name="chair"/>)"},
    {"TwoNumbers", R"(<scale x="1,0.5" y="1" z="1"/><object type="master" name="chair"/>)",
     R"(<scale x="1,0.5" y="1" z="1"/><object type="master" name="chair"/>)"},
    {"TwoOrThree", R"(<scale v="1,5 2"/><object type="master" name="chair"/>)",
     R"(<scale v="1,5 2"/><object type="master" name="chair"/>)"},
    {"Gray", R"(<object type="primitive" name="cube"><diffuse v="0.5"/></object>)",
     R"(<object type="primitive" name="cube"><diffuse v="0.5"/></object>)"},
    {"ForeignShape", R"(<object type="primitive" name="box"/>)",
     R"(<object type="primitive" name="box"/>)"},
    {"UnknownElement", R"(<object type="primitive" name="cube"><mood v="1"/></object>)",
     R"(<object type="primitive" name="cube"><mood v="1"/></object>)"},
    {"OpeningTag",
     R"(<object type="tree"><transblock><objct type="primitive" name="cube"></object></transblock></object>)",
     R"(<object type="tree"><transblock><object type="primitive" name="cube"></object></transblock></object>)"},
};

const std::vector<FixCase> json_cases{
    {"Key", R"({"primitives": [{"type": "cube", "difuse": [1, 0, 1]}]})",
     R"({"primitives": [{"type": "cube", "diffuse": [1, 0, 1]}]})"},
    {"Type", R"({"primitives": [{"type": "cilinder"}]})",
     R"({"primitives": [{"type": "cylinder"}]})"},
    {"Number", R"({"translate": [.5, 1., "2"], "primitives": []})",
     R"({"translate": [0.5, 1.0, 2], "primitives": []})"},
    {"DecimalComma", R"({"primitives": [{"type": "cube", "shininess": 1,5}]})",
     R"({"primitives": [{"type": "cube", "shininess": 1.5}]})"},
    {"Quotes", R"({'primitives': [{type: cube}]})", R"({"primitives": [{"type": "cube"}]})"},
    {"TypographicQuotes",
     "{\u201Cprimitives\u201D: [{\u201Ctype\u201D:\u201Ccube\u201D,\u2018name\u2019: \u201Ea "
     "b\u201C}]}",
     R"({"primitives": [{"type":"cube","name": "a b"}]})"},
    // The string may end later.
    {"TypographicApostrophe", "{\"primitives\": [], \"name\": \u2018it\u2019s\u2019}",
     "{\"primitives\": [], \"name\": \u2018it\u2019s\u2019}"},
    {"Commas",
     "{\"translate\": [1, 2, 3]\n \"primitives\": [{\"type\": \"cube\"; \"shininess\": 5,},]}",
     "{\"translate\": [1, 2, 3],\n \"primitives\": [{\"type\": \"cube\", \"shininess\": 5}]}"},
    {"RepeatedNumbers",
     R"({"primitives": [{"type": "cube", "diffuse": [.5, .5,.5], "ambient": [1.,1.,1.]}]})",
     R"({"primitives": [{"type": "cube", "diffuse": [0.5, 0.5,0.5], "ambient": [1.0,1.0,1.0]}]})"},
    {"RepeatedCommas", R"({"primitives": [, ,{"type": "cube",},{"type":"cube",}]})",
     R"({"primitives": [ {"type": "cube"},{"type":"cube"}]})"},
    {"RepeatedQuotes", R"({'primitives':[{'type':'cube'}, {type: 'cone'}]})",
     R"({"primitives":[{"type":"cube"}, {"type": "cone"}]})"},
    // In quotes it would be no number.
    {"WordForNumber", R"({"primitives": [{"type": "cube", "shininess": Math.PI}]})",
     R"({"primitives": [{"type": "cube", "shininess": Math.PI}]})"},
    // Only a warning: an empty group to the course's programs.
    {"Name", R"({"name": "chiar"})", R"({"name": "chiar"})"},
    {"Extension", R"({"name": "leg", "primitives": [], "mood": 1})",
     R"({"name": "leg", "primitives": [], "mood": 1})"},
};

void expect_fixed(const std::vector<FixCase>& cases, std::string (*with)(const std::string&)) {
  for (const FixCase& c : cases) {
    SCOPED_TRACE(c.name);
    const FixedText fixed = fix_text(with(c.before), {});
    EXPECT_EQ(fixed.text, with(c.after));
    EXPECT_EQ(fixed.made.empty(), c.before == c.after);
    EXPECT_TRUE(fix_text(fixed.text, {}).made.empty());
    if (c.before != c.after) {
      EXPECT_FALSE(findings_of(fixed.text).has_errors());
    }
  }
}

TEST(Fix, WritesWhatIsCertainInXml) {
  ASSERT_FALSE(findings_of(xml_with(R"(<object type="master" name="chair"/>)")).has_errors());
  expect_fixed(xml_cases, xml_with);
}

TEST(Fix, WritesWhatIsCertainInJson) {
  ASSERT_FALSE(findings_of(json_with(R"({"name": "chair"})")).has_errors());
  expect_fixed(json_cases, json_with);
}

TEST(Fix, OfTwoNamesThatAreAsNearNoneIsCertain) {
  const std::string text = xml_with(R"(<object type="master" name="chair2"/>)");
  EXPECT_TRUE(fix_text(text, {}).made.empty());  // a digit is not a typing mistake
  const std::string coeff =
      R"(<scenefile><globaldata><kq v="1"/></globaldata></scenefile>)";  // ka, kd, ks?
  EXPECT_TRUE(fix_text(coeff, {}).made.empty());
}

// That one attribute is missing and another unknown does not say that it was meant.
TEST(Fix, AnUnknownAttributeAloneIsNotCertain) {
  const auto fixed = [](const std::string& translate) {
    return fix_text(xml_with(translate + R"(<object type="master" name="chair"/>)"), {});
  };
  EXPECT_TRUE(fixed(R"(<translate y="1" z="1" w="3"/>)").made.empty());
  EXPECT_EQ(fixed(R"(<translate xpos="3" y="1" z="1"/>)").made.size(), 1U);
}

TEST(Fix, KeepsEncodingAndLineEnds) {
  std::string text = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\r\n" +
                     xml_with("<!-- \xe9 --><object type=\"master\" name=\"chiar\"/>");
  for (std::size_t at = 60; (at = text.find('\n', at)) != text.npos; at += 2) {
    text.replace(at, 1, "\r\n");
  }
  std::string right = text;
  right.replace(right.find("chiar"), 5, "chair");
  EXPECT_EQ(fix_text(text, {}).text, right);
}

TEST(Fix, EscapesWhatItWrites) {
  std::string text = xml_with(R"(<object type="master" name='it"s & chiar'/>)");
  text.replace(text.find("name=\"chair\""), 12, "name=\"it&quot;s &amp; chair\"");
  text.replace(text.find("name=\"chair\""), 12, "name=\"it&quot;s &amp; chair\"");
  text.replace(text.find("s & chiar"), 9, "s &amp; chiar");
  const std::string fixed = fix_text(text, {}).text;
  EXPECT_NE(fixed.find("name='it&quot;s &amp; chair'"), fixed.npos) << fixed;
}

TEST(Fix, PlacesAreThoseOfTheOldText) {
  const FixedText fixed = fix_text(
      xml_with(R"(<trnslate x="0,5" y="0" z="0"/><object type="master" name="chiar"/>)"), {});
  ASSERT_EQ(fixed.made.size(), 3U);
  EXPECT_EQ(fixed.made[0].location.column, 1U);
  EXPECT_EQ(fixed.made[1].location.column, 11U);
  EXPECT_EQ(fixed.made[2].location.column, 54U);
  EXPECT_EQ(fixed.made[2].code, &"tree.unknown-template"_code);
}

TEST(Fix, LeavesCodesAloneThatAreIgnored) {
  const std::string text = xml_with(R"(<Object type="master" name="chair"/>)");
  EXPECT_EQ(fix_text(text, {}, {"xml.name-case"}).text, text);
  EXPECT_NE(fix_text(text, {}).text, text);
}

TEST(Fix, CompatCourseKeepsThePrefixThatItReads) {
  const std::string text =
      xml_with(R"(<scale x="0,5" y="1" z="1"/><object type="master" name="chair"/>)");
  EXPECT_EQ(fix_text(text, {.compat_course = true, .limits = {}}).text, text);
}

TEST(Fix, OneFindingAtATime) {
  const std::string text = xml_with(R"(<object type="master" name="chiar"/>)");
  const Diagnostics findings = findings_of(text);
  for (const Diagnostic& d : findings.list()) {
    if (d.code == &"tree.unknown-template"_code) {
      const std::optional<Edit> edit = fix(text, d);
      ASSERT_TRUE(edit);
      EXPECT_EQ(applied(text, *edit), xml_with(R"(<object type="master" name="chair"/>)"));
      const auto changes = replacements(text, {&d});
      ASSERT_EQ(changes[0].size(), 1U);
      EXPECT_EQ(changes[0][0].to.column, changes[0][0].from.column + 5);
      Diagnostic other = d;
      other.file = "mesh.obj";
      EXPECT_FALSE(fix(text, other));
      other = d;
      other.location = {1000, 1};
      EXPECT_FALSE(fix(text, other));
    }
  }
}

// The text with the corrections of the findings of that code.
std::string corrected(const std::string& text, const Code& code) {
  const Diagnostics findings = findings_of(text);
  for (const Diagnostic& d : findings.list()) {
    if (const std::optional<Edit> edit = d.code == &code ? fix(text, d) : std::nullopt) {
      return applied(text, *edit);
    }
  }
  return text;
}

TEST(Fix, WritesAttributesForAWord) {
  EXPECT_EQ(corrected(xml_with("<object type='sphere'/>"), "xml.unknown-object-type"_code),
            xml_with(R"(<object type="primitive" name="sphere"/>)"));
  const std::string named = xml_with("<object type='sphere' name='ball'/>");
  EXPECT_EQ(corrected(named, "xml.unknown-object-type"_code), named);
  EXPECT_EQ(
      corrected(xml_with("<Cone><diffuse r='1' g='1' b='1'/></Cone>"), "xml.unknown-element"_code),
      xml_with(R"(<object type="primitive" name="cone"><diffuse r='1' g='1' b='1'/></object>)"));
}

TEST(Fix, TheWordMayBeAtAnotherPlace) {
  EXPECT_EQ(corrected("<scenefile>\n<object type='tree' name='scene'/>\n</scenefile>",
                      "xml.no-root"_code),
            "<scenefile>\n<object type='tree' name='root'/>\n</scenefile>");
}

TEST(Fix, WritesTheNameOfTheRootInSmallLetters) {
  std::string text = xml_with(R"(<object type="master" name="chair"/>)");
  const std::string fixed = text;
  text.replace(text.find("name=\"root\""), 11, "name=\"Root\"");
  EXPECT_EQ(fix_text(text, {}).text, fixed);
}

TEST(Fix, TheWordMayEqualTheNameOfItsAttribute) {
  EXPECT_EQ(
      corrected("<scenefile>\n<object type='tree' name='name'/>\n</scenefile>", "xml.no-root"_code),
      "<scenefile>\n<object type='tree' name='root'/>\n</scenefile>");
  std::string json = json_with(R"({"name": "name"})");
  json.replace(json.find("chair"), 5, "names");
  EXPECT_EQ(corrected(json, "json.unknown-template"_code).find(R"({"name": "name"})"),
            std::string::npos);
}

TEST(UnifiedDiff, ShowsWhatChanges) {
  EXPECT_EQ(unified_diff("a\nb\n", "a\nb\n", "x"), "");
  EXPECT_EQ(unified_diff("1\n2\n3\n4\na\nb\n7\n8\n9\n10", "1\n2\n3\n4\nA\nB\n7\n8\n9\n!0", "x"),
            "--- x\n+++ x\n@@ -2,9 +2,9 @@\n 2\n 3\n 4\n-a\n-b\n+A\n+B\n 7\n 8\n 9\n-10\n"
            "\\ No newline at end of file\n+!0\n\\ No newline at end of file\n");
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Counts by code and line.
std::map<std::pair<const Code*, std::uint32_t>, int> counts(const Diagnostics& findings) {
  std::map<std::pair<const Code*, std::uint32_t>, int> result;
  for (const Diagnostic& d : findings.list()) {
    ++result[{d.code, d.location.line}];
  }
  return result;
}

// A second run changes nothing; what reading did not stop at shows no finding that was not there;
// every correction finds its word.
TEST(Fix, FixturesStayWhatTheyAre) {
  int changed = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SCENEFILE_FIXTURES)) {
    const std::string ending = entry.path().extension().string();
    if (!entry.is_regular_file() || (ending != ".xml" && ending != ".json") ||
        entry.file_size() > 200'000) {
      continue;
    }
    SCOPED_TRACE(entry.path());
    const std::string text = bytes_of(entry.path());
    for (const bool compat : {false, true}) {
      const ReadOptions options{.compat_course = compat, .limits = {}};
      const Diagnostics before = findings_of(text, options);
      for (const Diagnostic& d : before.list()) {
        EXPECT_TRUE(!d.correction || fix(text, d)) << d.message;
      }
      const FixedText fixed = fix_text(text, options);
      EXPECT_TRUE(fix_text(fixed.text, options).made.empty());
      EXPECT_EQ(fixed.made.empty(), fixed.text == text);
      changed += fixed.text == text ? 0 : 1;
      const bool stopped = std::any_of(fixed.made.begin(), fixed.made.end(), [](const auto& d) {
        return d.code == &"xml.syntax"_code || d.code == &"json.syntax"_code ||
               d.code == &"json.number"_code || d.code == &"json.trailing-comma"_code;
      });
      auto old = counts(before);
      const Diagnostics after = findings_of(fixed.text, options);
      for (const auto& [key, count] : counts(after)) {
        EXPECT_TRUE(stopped || key.first->kind == CodeKind::absence || count <= old[key])
            << key.first->name;
      }
      EXPECT_LE(after.count(Severity::error), before.count(Severity::error) + (stopped ? 100 : 0));
    }
  }
  EXPECT_GT(changed, 20);
}

}  // namespace
}  // namespace scenefile
