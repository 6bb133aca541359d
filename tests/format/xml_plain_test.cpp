// Our reader of XML agrees with Expat, which it only asks about XML that is not plain.

#include "format/write_random_scene.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/format/xml_reader.h"
#include "support/plain_agreement.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <string_view>
#include <utility>

namespace scenefile::testing {
namespace {

bool is_read_without_expat(std::string_view text, const Limits& limits = {}) {
  const XmlReading reading = events_of(text, limits).reading;
  return reading.complete && !reading.asked_expat;
}

TEST(XmlPlain, PlainTexts) {
  for (const std::string_view text :
       {"<a/>", "<a></a>", "<a ></a\n>", " \r\n<a b = '1'\tc=\"\"/>\n", "<!-- x - > --><a/><!---->",
        "<?xml version=\"1.0\"?><a/>", "<?xml version=\"1.0\" encoding=\"UTF-8\" ?>\n<a/>",
        "<a:b_ c.d-2='>\"'/>", "<!-- \u00e4 \U0001F600 --><a b='\u00e4'/>"}) {
    EXPECT_TRUE(is_read_without_expat(text)) << text;
    EXPECT_TRUE(agrees_with_expat(std::string(text), {})) << text;
  }
}

TEST(XmlPlain, OtherTextsAreLeftToExpat) {
  for (const std::string_view text : {"",
                                      " ",
                                      "<",
                                      ">",
                                      "</a>",
                                      "<a>",
                                      "<a",
                                      "<a/",
                                      "<a/><b/>",
                                      "<a></b>",
                                      "<a/>x",
                                      "x<a/>",
                                      "<a>x</a>",
                                      "<a><![CDATA[]]></a>",
                                      "<a b=\"&lt;\"/>",
                                      "<a b='1' b='2'/>",
                                      "<a b='1'c='2'/>",
                                      "<a b=1/>",
                                      "<a b/>",
                                      "<a b='<'/>",
                                      "<a b='\n'/>",
                                      "<a b='\t'/>",
                                      "<a b='>",
                                      "<a / >",
                                      "< a/>",
                                      "<a/ >",
                                      "<1/>",
                                      "<a b='\x01'/>",
                                      "<a b='\xFF'/>",
                                      "<a b='\xEF\xBF\xBF'/>",
                                      "<!DOCTYPE a><a/>",
                                      "<?x y?><a/>",
                                      " <?xml version=\"1.0\"?><a/>",
                                      "<?xml version=\"1.0\" encoding=\"_\"?><a/>",
                                      "<?xml version='1.0'?><a/>",
                                      "<!-- -- --><a/>",
                                      "<!-- --->-><a/>",
                                      "<!-->-><a/>",
                                      "<!-- <a/>",
                                      "<!-x--><a/>",
                                      "<\u00e4/>",
                                      "<a></>"}) {
    EXPECT_TRUE(events_of(text, {}).reading.asked_expat) << text;
    EXPECT_TRUE(agrees_with_expat(text, {})) << text;
  }
}

TEST(XmlPlain, LimitsHold) {
  Limits limits;
  limits.nesting = 2;
  limits.name_bytes = 3;
  limits.value_bytes = 4;
  limits.attributes = 1;
  EXPECT_TRUE(is_read_without_expat("<abc><b abc='1234'/></abc>", limits));
  const std::pair<std::string_view, const Code*> cases[] = {
      {"<a><b><c/></b></a>", &"xml.nesting-limit"_code},
      {"<abcd/>", &"xml.length-limit"_code},
      {"<a abcd='1'/>", &"xml.length-limit"_code},
      {"<a b='12345'/>", &"xml.length-limit"_code},
      {"<a b='1' c='2'/>", &"xml.attribute-limit"_code}};
  for (const auto& [text, code] : cases) {
    const Told told = events_of(text, limits);
    EXPECT_FALSE(told.reading.complete) << text;
    ASSERT_EQ(told.diagnostics.list().size(), 1u) << text;
    EXPECT_EQ(told.diagnostics.list().front().code, code) << text;
  }
}

// Expat does not finish markup of this length, so nothing after it may be read.
TEST(XmlPlain, NothingIsReadAfterMarkupThatIsTooLong) {
  const std::string blanks(std::size_t{40} << 20, ' ');
  for (const std::string& text :
       {"<a" + blanks + "></a></a>", "<a" + blanks + ">&#;</a>", "<a" + blanks + "></a>",
        "<a>&" + std::string(std::size_t{40} << 20, 'x') + ";</a>", "<a b='&lt;'" + blanks + "/>",
        "<a>&lt;</a" + blanks + ">"}) {
    const Told told = events_of(text, {});
    EXPECT_FALSE(told.reading.complete) << text.substr(0, 12);
    ASSERT_EQ(told.diagnostics.list().size(), 1u) << text.substr(0, 12);
    EXPECT_EQ(told.diagnostics.list().front().code, &"xml.length-limit"_code) << text.substr(0, 12);
  }
}

TEST(XmlPlain, TheHandlerCanStop) {
  const Told told = events_of("<a><stop></a>", {});
  EXPECT_FALSE(told.reading.complete);
  EXPECT_FALSE(told.reading.asked_expat);
  EXPECT_TRUE(told.diagnostics.list().empty());
}

// Once a text is not plain, our reader decodes it.
TEST(XmlPlain, References) {
  for (const std::string_view text :
       {"<a b='&lt;&gt;&amp;&quot;&apos;'/>", "<a b='&#65;&#x42;&#xe4;&#x1F600;&#10;'/>",
        "<a b=' 1\r\n2\r3\n4\t5\r\n\r\n '/>", "<a b='&#13;&#x20;&#9;' c='ä&#228;'/>",
        "<a>&lt;x</a>", "<a> \r\n x&amp;y\nz<b/>u<!-- -->v</a>", "<a><![CDATA[\n <b> &x; ]]></a>",
        "<a>x<![CDATA[ y ]]>z<?p q?>w</a>", "<a b='&lt;'><c d='1'/><stop></a>",
        "<!DOCTYPE a [<!ELEMENT a (b)> <!-- > ] --> <?p ]>?>]><a b='&#x26;'/>",
        "<a b='&lt;'><b></a>", "<a b='&lt;'>x & y</a>", "<a>x &y; z</a>", "<a>]]></a>",
        "<a>]]\x02</a>",
        // A missing quotation mark in a tag that is not plain is not repaired.
        "<a b='&lt;' c='1/><d/></a>", "<a><b c='1' c='2/><d/></a>", "<a b='&lt;' c='1 d='2'/>"}) {
    EXPECT_TRUE(events_of(text, {}).reading.asked_expat) << text;
    EXPECT_TRUE(agrees_with_expat(text, {})) << text;
  }
}

RC_GTEST_PROP(XmlPlainLaws, WrittenScenesArePlain, ()) {
  const Scene scene = RandomScene(*rc::gen::arbitrary<unsigned>(), 3, false).make();
  Diagnostics diagnostics;
  const std::string text = write_scene(scene, SceneFormat::xml, {}, diagnostics);
  RC_ASSERT(agrees_with_expat(text, {}));
  RC_CLASSIFY(is_read_without_expat(text));
}

// With pieces of markup in wrong places, and with low limits.
RC_GTEST_PROP(XmlPlainLaws, AgreesWithExpat, ()) {
  const auto piece = rc::gen::element<std::string>(
      "<a>", "</a>", "<a/>", "<b c='1'>", "</b>", "<b c=\"1\" d='2'/>", " ", "\n", "\r", "<!--",
      "-->", "--", "-", ">", "<", "/", "=", "\"", "'", "&", "&lt;", "&#10;", "x", "c='1'", " d=''",
      " e=1", "<a f=2>", "</A>", "\u201C", "<stop>", "?>", "<?xml version=\"1.0\"?>", "\u00e4",
      "\xEF\xBF\xBE", "\xC3", "\x7F", "\x02", "]]>", "<![CDATA[", "<!DOCTYPE a", "[", "]",
      "<!ELEMENT a ANY>");
  std::string text;
  for (const std::string& part : *rc::gen::container<std::vector<std::string>>(piece)) {
    text += part;
  }
  Limits limits;
  limits.nesting = *rc::gen::inRange(1u, 5u);
  RC_ASSERT(agrees_with_expat(text, {}));
  RC_ASSERT(agrees_with_expat("<a>" + text + "</a>", limits));
  RC_ASSERT(agrees_with_expat("<!--" + text + "--><a/>", {}));
  RC_ASSERT(agrees_with_expat("<a b='" + text + "'/>", {}));
}

// The events of a text, without their places.
std::string without_places(const std::string& said) {
  std::string text;
  for (std::size_t at = 0; at < said.size();) {
    const std::size_t end = said.find('\n', at) + 1;
    const std::size_t tag = said.find('<', at);
    text += said.substr(tag < end ? tag : at, end - (tag < end ? tag : at));
    at = end;
  }
  return text;
}

RC_GTEST_PROP(XmlPlainLaws, QuotationMarksCanBeMissing, ()) {
  const Scene scene = RandomScene(*rc::gen::arbitrary<unsigned>(), 3, false).make();
  Diagnostics diagnostics;
  const std::string text = write_scene(scene, SceneFormat::xml, {}, diagnostics);
  RC_PRE(is_read_without_expat(text));
  std::string unquoted;
  std::size_t removed = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = std::min(text.find("=\"", at), text.size());
    const std::size_t end = std::min(text.find('"', std::min(open + 2, text.size())), text.size());
    const std::string value = open < text.size() ? text.substr(open + 2, end - open - 2) : "";
    const bool remove =
        !value.empty() && *rc::gen::inRange(0, 3) == 0 &&
        value.find_first_not_of("0123456789.-abcdefghijklmnopqrstuvwxyz") == std::string::npos;
    unquoted += text.substr(at, open - at);
    unquoted += remove ? "=" + value : text.substr(open, std::min(end + 1, text.size()) - open);
    removed += remove;
    at = std::min(end + 1, text.size());
  }
  const Told told = events_of(unquoted, {});
  RC_ASSERT(told.reading.complete);
  RC_ASSERT(told.diagnostics.count(Severity::error) == removed);
  RC_ASSERT(without_places(told.said) == without_places(events_of(text, {}).said));
}

RC_GTEST_PROP(XmlPlainLaws, AgreesAfterAnyChangedByte, ()) {
  const Scene scene = RandomScene(*rc::gen::arbitrary<unsigned>(), 2, false).make();
  Diagnostics diagnostics;
  const std::string text = write_scene(scene, SceneFormat::xml, {}, diagnostics);
  for (int i = 0; i < 50; ++i) {
    std::string changed = text;
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    changed[at] =
        *rc::gen::weightedOneOf<char>({{1, rc::gen::arbitrary<char>()},
                                       {2, rc::gen::elementOf(std::string("<>/='\"& \n-!?a0"))}});
    RC_ASSERT(agrees_with_expat(changed, {}));
  }
}

}  // namespace
}  // namespace scenefile::testing
