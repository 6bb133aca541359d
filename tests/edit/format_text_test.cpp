#include "scenefile/edit/format_text.h"

#include "format/reading.h"
#include "scenefile/format/codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::testing {
namespace {

using ::testing::ElementsAre;

std::string laid_out(std::string_view text) {
  Diagnostics diagnostics;
  const std::optional<std::string> once = lay_out(text, {}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  const std::string result = once.value_or("nothing");
  EXPECT_EQ(lay_out(result, {}, diagnostics), result) << "again";
  return result;
}

std::vector<std::string> faults(std::string_view text) {
  Diagnostics diagnostics;
  EXPECT_EQ(lay_out(text, {}, diagnostics), std::nullopt);
  return findings(diagnostics);
}

TEST(LayoutXml, OneElementPerLine) {
  EXPECT_EQ(laid_out("<scenefile><a  x = '1'\n y=\"2\" /><b><c></c >\n\n</b></scenefile>"),
            "<scenefile>\n"
            "  <a x='1' y=\"2\"/>\n"
            "  <b>\n"
            "    <c></c>\n"
            "  </b>\n"
            "</scenefile>\n");
}

TEST(LayoutXml, CommentsStayWhereTheyAre) {
  EXPECT_EQ(laid_out("<!-- top --><scenefile> <!-- of it -->\n"
                     "<a/><!-- of a -->   <!-- too -->\n"
                     "   <!-- two\n lines --> <b/>\n"
                     "</scenefile><!-- end -->\n\n\n<!-- after -->"),
            "<!-- top -->\n"
            "<scenefile> <!-- of it -->\n"
            "  <a/> <!-- of a --> <!-- too -->\n"
            "  <!-- two\n lines -->\n"
            "  <b/>\n"
            "</scenefile> <!-- end -->\n"
            "\n"
            "<!-- after -->\n");
}

TEST(LayoutXml, OneBlankLineStays) {
  EXPECT_EQ(laid_out("<scenefile>\n\n<a/>\n\n\n\n<b/>\n<c/>\n\n</scenefile>"),
            "<scenefile>\n  <a/>\n\n  <b/>\n  <c/>\n</scenefile>\n");
}

TEST(LayoutXml, ValuesAndTextStayAsWritten) {
  EXPECT_EQ(laid_out("<scenefile><a b='x > \"y\" &amp; &#65;\n /> '/>"
                     "<c>  some\n text </c><d><![CDATA[<e> ]]></d>"
                     "<f xml:space='preserve'> <g/> </f> stray &lt; <h/></scenefile>"),
            "<scenefile>\n"
            "  <a b='x > \"y\" &amp; &#65;\n /> '/>\n"
            "  <c>  some\n text </c>\n"
            "  <d><![CDATA[<e> ]]></d>\n"
            "  <f xml:space='preserve'> <g/> </f>\n"
            "  stray &lt;\n"
            "  <h/>\n"
            "</scenefile>\n");
}

TEST(LayoutXml, InstructionsAndTextGetTheirOwnLines) {
  EXPECT_EQ(laid_out("<scenefile><?php echo \"<x/>\" ?>text <!-- c --><![CDATA[ <a>\n ]]>"
                     "<a/><?q?></scenefile>"),
            "<scenefile>\n"
            "  <?php echo \"<x/>\" ?>\n"
            "  text <!-- c -->\n"
            "  <![CDATA[ <a>\n ]]>\n"
            "  <a/>\n"
            "  <?q?>\n"
            "</scenefile>\n");
}

TEST(LayoutXml, DeclarationsStayAsWritten) {
  const std::string head =
      "<?xml  version='1.0' encoding='ISO-8859-1'?>\n"
      "<!DOCTYPE scenefile [ <!-- it's > ] --> <!ELEMENT a ANY> <?p ]> ?> ]>\n"
      "<?style sheet?>\n";
  EXPECT_EQ(laid_out(head + "<scenefile><a n='\xE4'/></scenefile>"),
            head + "<scenefile>\n  <a n='\xE4'/>\n</scenefile>\n");
}

TEST(LayoutXml, LineEndsAreThoseOfTheFile) {
  EXPECT_EQ(laid_out("<scenefile>\r\n\r\n<a/>\r\n\r\n<b/></scenefile>"),
            "<scenefile>\r\n  <a/>\r\n\r\n  <b/>\r\n</scenefile>\r\n");
  EXPECT_EQ(laid_out("<scenefile>\r<a/></scenefile>"), "<scenefile>\r  <a/>\r</scenefile>\r");
}

TEST(LayoutXml, TheEncodingStays) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(laid_out(mark + "<scenefile><a/></scenefile>"),
            mark + "<scenefile>\n  <a/>\n</scenefile>\n");
  const auto wide = [](std::string_view text, bool little, std::string out) {
    for (const char c : text) {
      // '*' becomes a character that needs a surrogate pair.
      for (const unsigned unit : c == '*' ? std::vector<unsigned>{0xD83Du, 0xDE00u}
                                          : std::vector<unsigned>{static_cast<unsigned>(c)}) {
        out += static_cast<char>(little ? unit & 0xFF : unit >> 8);
        out += static_cast<char>(little ? unit >> 8 : unit & 0xFF);
      }
    }
    return out;
  };
  for (const bool little : {true, false}) {
    for (const std::string& start :
         {std::string(), std::string(little ? "\xFF\xFE" : "\xFE\xFF")}) {
      EXPECT_EQ(laid_out(wide("<scenefile><a n='*'/></scenefile>", little, start)),
                wide("<scenefile>\n  <a n='*'/>\n</scenefile>\n", little, start));
    }
  }
}

TEST(LayoutXml, RejectsOtherFiles) {
  EXPECT_THAT(faults("<scenefile>\n<a></scenefile>"), ElementsAre("2:1 error xml.syntax"));
  EXPECT_THAT(faults("<svg/>"), ElementsAre("0:0 error xml.root-element"));
  EXPECT_THAT(faults("<scenefile/><b/>"), ElementsAre("1:13 error xml.syntax"));
  EXPECT_THAT(faults(" "), ElementsAre("0:0 error format.empty"));
  EXPECT_THAT(faults("scene"), ElementsAre("0:0 error format.unknown"));
}

TEST(LayoutJson, OneMemberPerLine) {
  EXPECT_EQ(
      laid_out(
          R"({"b":[1.50,-2E+3 ,0.0], "cameraData" : {"x":"\u0041 /\/"},"b":[],"c":{ },"d":[[1,2],[{}]]})"),
      "{\n"
      "  \"b\": [1.50, -2E+3, 0.0],\n"
      "  \"cameraData\": {\n"
      "    \"x\": \"\\u0041 /\\/\"\n"
      "  },\n"
      "  \"b\": [],\n"
      "  \"c\": {},\n"
      "  \"d\": [\n"
      "    [1, 2],\n"
      "    [\n"
      "      {}\n"
      "    ]\n"
      "  ]\n"
      "}\n");
}

TEST(LayoutJson, OneBlankLineStays) {
  EXPECT_EQ(laid_out("{\n\n\"globalData\":1,\n\n\n\"b\":[\n\n{}\n\n,{}],\n\"c\":2\n\n}"),
            "{\n  \"globalData\": 1,\n\n  \"b\": [\n    {},\n\n    {}\n  ],\n  \"c\": 2\n}\n");
}

TEST(LayoutJson, LongListsAreBroken) {
  std::string list = "0";
  std::string lines = "    0";
  for (int i = 0; i < 40; ++i) {
    list += ", 10";
    lines += ",\n    10";
  }
  EXPECT_EQ(laid_out("{\"groups\": [" + list + "]}"),
            "{\n  \"groups\": [\n" + lines + "\n  ]\n}\n");
}

TEST(LayoutJson, RejectsOtherFiles) {
  EXPECT_THAT(faults("{\"groups\": .6}"), ElementsAre("1:12 error json.number"));
  EXPECT_THAT(faults("{\"groups\": 1"), ElementsAre("1:13 error json.truncated"));
  EXPECT_THAT(faults("[1]"), ElementsAre("0:0 error json.wrong-type"));
}

TEST(CountComments, CountsThem) {
  EXPECT_EQ(count_comments("<!-- a --><scenefile><!--b--><c n='<!-- no -->'/></scenefile>"), 2U);
  EXPECT_EQ(count_comments("{}"), 0U);
}

}  // namespace
}  // namespace scenefile::testing
