// Messages about texts that are not valid JSON.

#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"

#include <gtest/gtest.h>

#include <string>

namespace scenefile {
namespace {

Diagnostics diagnostics_of(std::string_view text) {
  Diagnostics diagnostics;
  read_json(text, {}, diagnostics);
  return diagnostics;
}

struct SyntaxCase {
  std::string_view text;
  const Code& code;
  Location location;
  std::string_view mention;
};

void expect_finding(const SyntaxCase& c) {
  const Diagnostics diagnostics = diagnostics_of(c.text);
  ASSERT_FALSE(diagnostics.list().empty()) << c.text;
  const Diagnostic& d = diagnostics.list().front();
  EXPECT_EQ(d.code->name, c.code.name) << c.text << ": " << d.message;
  EXPECT_EQ(d.location.line, c.location.line) << c.text << ": " << d.message;
  EXPECT_EQ(d.location.column, c.location.column) << c.text << ": " << d.message;
  EXPECT_NE(d.message.find(c.mention), std::string::npos) << c.text << ": " << d.message;
}

TEST(JsonSyntax, NumbersSayHowToWriteThem) {
  const SyntaxCase cases[] = {
      {"{\"a\": .6}", "json.number"_code, {1, 7}, "write 0.6"},
      {"{\"a\": -.6}", "json.number"_code, {1, 7}, "write -0.6"},
      {"{\"a\": 1.}", "json.number"_code, {1, 7}, "write 1.0"},
      {"{\"a\": 1.e5}", "json.number"_code, {1, 7}, "write 1.0e5"},
      {"{\"a\": +1}", "json.number"_code, {1, 7}, "write 1.0"},
      {"{\"a\": 007.5}", "json.number"_code, {1, 7}, "write 7.5"},
      {"[01]", "json.number"_code, {1, 2}, "write 1.0"},
      {"{\"a\": 1e}", "json.number"_code, {1, 7}, "write 1.0"},
      {"{\"a\": 0x1F}", "json.number"_code, {1, 7}, "\"0x1F\" is not a JSON number; write 31"},
      {"{\"a\": 45deg}", "json.number"_code, {1, 7}, "\"45deg\" is not a JSON number; write 45"},
      {"{\"a\": [0, 1_000]}", "json.number"_code, {1, 11}, "write 1000"},
      {"{\"a\": --5}", "json.number"_code, {1, 7}, "write -5"},
      {"{\"a\": 1.2.3}", "json.number"_code, {1, 7}, "\"1.2.3\" is not a JSON number"},
      {"{\"a\": -1,5}", "json.number"_code, {1, 7}, "\"-1,5\" is not a JSON number; write -1.5"},
      {"{\"a\": -}", "json.number"_code, {1, 7}, "\"-\" is not a JSON number"},
      {"{\"a\": NaN}", "json.number"_code, {1, 7}, "JSON has no \"NaN\""},
      {"{\"a\": -Infinity}", "json.number"_code, {1, 7}, "JSON has no \"-Infinity\""},
      {"{\"a\": 1e400}", "json.number-range"_code, {1, 7}, "too large"},
  };
  for (const SyntaxCase& c : cases) {
    expect_finding(c);
  }
}

TEST(JsonSyntax, OnlyNumbersAreProposedAndOnlyShortOnes) {
  for (const std::string& word : {std::string("3e38p5"), "1e5" + std::string(3000, 'x'),
                                  std::string(3000, '0') + "1", "." + std::string(3000, '5')}) {
    const Diagnostics diagnostics = diagnostics_of("{\"a\": " + word + "}");
    ASSERT_FALSE(diagnostics.list().empty());
    const std::string& message = diagnostics.list().front().message;
    EXPECT_TRUE(message.ends_with("is not a JSON number")) << message;
    EXPECT_LT(message.size(), 100u);
  }
}

TEST(JsonSyntax, CommasAndBrackets) {
  const SyntaxCase cases[] = {
      {"{\"a\": [1, 2,]}", "json.trailing-comma"_code, {1, 12}, "before the closing ]"},
      {"{\"a\": 1,\n}", "json.trailing-comma"_code, {1, 8}, "before the closing }"},
      {"{\"a\": 1,, \"b\": 2}", "json.syntax"_code, {1, 9}, "two commas"},
      {"[, 1]", "json.syntax"_code, {1, 2}, "a comma before the first"},
      {"{\"a\": 1 \"b\": 2}", "json.syntax"_code, {1, 7}, "expected a comma after this"},
      {"[1 2]", "json.syntax"_code, {1, 2}, "expected a comma after this"},
      {"{\"a\": [1, 2}}", "json.syntax"_code, {1, 12}, "the array that begins at line 1, column 7"},
      {"{\"a\": 1]", "json.syntax"_code, {1, 8}, "the object that begins at line 1, column 1"},
      {"{\"groups\": [\n\"name\": 1]}",
       "json.syntax"_code,
       {2, 7},
       "the { in front of it is missing"},
      {"{\"a\": 0.5; \"b\": 1}", "json.syntax"_code, {1, 10}, "not by semicolons"},
      {"{\"a\" = 1}", "json.syntax"_code, {1, 6}, "not by ="},
      {"{\"a\" 1}", "json.syntax"_code, {1, 6}, "expected a colon"},
      {"{\"a\": (1, 2)}", "json.syntax"_code, {1, 7}, "an array is written in square brackets"},
      {"{\"a\": {{}}}", "json.syntax"_code, {1, 8}, "a list of objects is written in [ ]"},
      {"{\"a\": 1/2}", "json.syntax"_code, {1, 8}, "does not calculate"},
      {"{}}", "json.after-end"_code, {1, 3}, "follows the end"},
      {"{} {}", "json.after-end"_code, {1, 4}, "follows the end"},
  };
  for (const SyntaxCase& c : cases) {
    expect_finding(c);
  }
}

TEST(JsonSyntax, WordsAndQuotes) {
  const SyntaxCase cases[] = {
      {"{a: 1}", "json.syntax"_code, {1, 2}, "the key \"a\" must be in double quotes"},
      {"{'a': 1}", "json.syntax"_code, {1, 2}, "double quotes"},
      {"{\"a\": \"b, \"c\": 1}",
       "json.syntax"_code,
       {1, 12},
       "an earlier string is missing its closing one"},
      {"{\u201Ca\u201D: 1}", "json.syntax"_code, {1, 2}, "a typographic quotation mark"},
      {"{\u00A0\"a\": 1}", "json.syntax"_code, {1, 2}, "a special space character, U+00A0"},
      {"{\"a\": True}", "json.syntax"_code, {1, 7}, "True is written true"},
      {"{\"a\": None}", "json.syntax"_code, {1, 7}, "None is written null"},
      {"{\"a\": tru}", "json.syntax"_code, {1, 7}, "\"tru\" is not a value"},
      {"{\"a\": cube}", "json.syntax"_code, {1, 7}, "\"cube\" is not a value"},
      {"{ // note\n}", "json.comment"_code, {1, 3}, "no comments"},
      {"{\"a\": 1 /* b */}", "json.comment"_code, {1, 9}, "no comments"},
      {"{\"a\": 1\n# b\n}", "json.comment"_code, {2, 1}, "no comments"},
  };
  for (const SyntaxCase& c : cases) {
    expect_finding(c);
  }
}

TEST(JsonSyntax, Strings) {
  using namespace std::string_view_literals;
  const SyntaxCase cases[] = {
      {"{\"a\": \"b\nc\"}", "json.string"_code, {1, 9}, "closing quote is missing"},
      {"{\"a\": \"b\tc\"}", "json.string"_code, {1, 9}, "\"\\t\""},
      {"{\"a\": \"\\q\"}", "json.string"_code, {1, 8}, "unknown escape \"\\q\""},
      {"{\"a\": \"\\u12g4\"}", "json.string"_code, {1, 8}, "\"\\u12g4\""},
      {"{\"a\": \"\\ud800\"}", "json.string"_code, {1, 8}, "surrogate"},
      {"{\"a\": \"\\udc00\"}", "json.string"_code, {1, 7}, "surrogate"},
      {"{\"\\udc00\": 1}", "json.string"_code, {1, 2}, "surrogate"},
      {"{\"a\": \"\xff\"}", "format.encoding"_code, {1, 8}, "not UTF-8"},
      {"{\"a\": \"\xed\xa0\x80\"}", "format.encoding"_code, {1, 8}, "not UTF-8"},
      {"{\"a\": \"x\0y\"}"sv, "json.syntax"_code, {1, 9}, "NUL"},
      {"{}\0"sv, "json.syntax"_code, {1, 3}, "NUL"},
  };
  for (const SyntaxCase& c : cases) {
    expect_finding(c);
  }
}

TEST(JsonSyntax, TheEnd) {
  const SyntaxCase cases[] = {
      {"{\"a\": [1,\n 2",
       "json.truncated"_code,
       {2, 3},
       "inside the array that begins at line 1, column 7"},
      {"{\"a\":", "json.truncated"_code, {1, 6}, "inside the object"},
      {"{\"a\": \"b", "json.truncated"_code, {1, 9}, "inside the object"},
      {"", "json.truncated"_code, {1, 1}, "no JSON value"},
      {"-", "json.truncated"_code, {1, 2}, "in the middle of a value"},
  };
  for (const SyntaxCase& c : cases) {
    expect_finding(c);
  }
}

TEST(JsonSyntax, ConflictMarkersAreNamed) {
  for (const std::string marker : {"<<<<<<< HEAD", "=======", ">>>>>>> theirs"}) {
    const std::string text = "{\"a\": 1,\n" + marker + "\n\"b\": 2}";
    expect_finding({text, "json.conflict-marker"_code, {2, 1}, marker});
  }
}

TEST(JsonSyntax, ColumnsCountCharacters) {
  expect_finding(
      {"{\"\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\": .5}", "json.number"_code, {1, 9}, "0.5"});
}

TEST(JsonSyntax, LinesEndInAnyWay) {
  expect_finding({"{\r\n\"a\":\r\n.5}", "json.number"_code, {3, 1}, "0.5"});
  expect_finding({"{\r\"a\":\r.5}", "json.number"_code, {3, 1}, "0.5"});
  expect_finding({"{\r\n\"a\":\r .5}", "json.number"_code, {3, 2}, "0.5"});
}

TEST(JsonSyntax, NestingIsBounded) {
  ReadOptions options;
  options.limits.nesting = 3;
  Diagnostics fine;
  read_json("[[[]]]", options, fine);
  EXPECT_EQ(fine.list().front().code, &"json.wrong-type"_code);
  Diagnostics deep;
  read_json("[[[\n[]]]]", options, deep);
  ASSERT_EQ(deep.list().size(), 1u);
  EXPECT_EQ(deep.list().front().code, &"json.limit"_code);
  EXPECT_EQ(deep.list().front().location, (Location{2, 1}));
  const Diagnostics very_deep = diagnostics_of(std::string(1'000'000, '['));
  ASSERT_EQ(very_deep.list().size(), 1u);
  EXPECT_EQ(very_deep.list().front().code, &"json.limit"_code);
}

TEST(JsonSyntax, LargeFilesAreRejected) {
  ReadOptions options;
  options.limits.file_bytes = 5;
  Diagnostics diagnostics;
  read_json("{    }", options, diagnostics);
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list().front().code, &"json.limit"_code);
}

// A small scene with a value of each kind.
constexpr std::string_view good_json = R"({
  "name": "\u00e4 \\ \"", "globalData": {"ambientCoeff": 0.5, "diffuseCoeff": 5e-1,
  "specularCoeff": -0.0}, "cameraData": {"position": [0, 0, 5], "up": [0, 1, 0],
  "focus": [0, 0, 0], "heightAngle": 45},
  "templateGroups": [{"name": "t", "primitives": [{"type": "mesh", "meshFile": "a.obj"}]}],
  "groups": [{"translate": [1, 2, 3], "rotate": [0, 1, 0, 30], "scale": [1, 1, 1],
  "matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]], "groups": [{"name": "t"}, null, true]}]})";

TEST(JsonSyntax, EveryPrefixEndsWithAnError) {
  for (std::size_t size = 0; size < good_json.size(); ++size) {
    const Diagnostics diagnostics = diagnostics_of(good_json.substr(0, size));
    ASSERT_TRUE(diagnostics.has_errors()) << size;
    ASSERT_TRUE(diagnostics.list().front().location.known()) << size;
  }
}

TEST(JsonSyntax, DamagedBytesNeverCrash) {
  for (std::size_t at = 0; at < good_json.size(); ++at) {
    for (int byte = 0; byte < 256; ++byte) {
      std::string text(good_json);
      text[at] = static_cast<char>(byte);
      const Diagnostics diagnostics = diagnostics_of(text);
      for (const Diagnostic& d : diagnostics.list()) {
        ASSERT_FALSE(d.message.empty()) << at << " " << byte;
      }
    }
  }
}

}  // namespace
}  // namespace scenefile
