// The fast reader of simple XML agrees with Expat, or gives up.

#include "format/write_random_scene.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/format/xml_reader.h"
#include "support/plain_agreement.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <string_view>

namespace scenefile::testing {
namespace {

PlainEnd end_of(std::string_view text, const Limits& limits = {}) {
  return plain_events(text, limits).end;
}

TEST(XmlPlain, WhatIsPlain) {
  for (const std::string_view text :
       {"<a/>", "<a></a>", "<a ></a\n>", " \r\n<a b = '1'\tc=\"\"/>\n", "<!-- x - > --><a/><!---->",
        "<?xml version=\"1.0\"?><a/>", "<?xml version=\"1.0\" encoding=\"UTF-8\" ?>\n<a/>",
        "<a:b_ c.d-2='>\"'/>", "<!-- \u00e4 \U0001F600 --><a b='\u00e4'/>"}) {
    EXPECT_EQ(end_of(text), PlainEnd::complete) << text;
    EXPECT_TRUE(agrees_with_expat(std::string(text), {})) << text;
  }
}

TEST(XmlPlain, WhatIsNotIsLeftToExpat) {
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
    EXPECT_EQ(end_of(text), PlainEnd::not_plain) << text;
  }
}

TEST(XmlPlain, LimitsAreLeftToExpat) {
  Limits limits;
  limits.nesting = 2;
  limits.name_bytes = 3;
  limits.value_bytes = 4;
  limits.attributes = 1;
  EXPECT_EQ(end_of("<abc><b abc='1234'/></abc>", limits), PlainEnd::complete);
  for (const std::string_view text :
       {"<a><b><c/></b></a>", "<abcd/>", "<a abcd='1'/>", "<a b='12345'/>", "<a b='1' c='2'/>"}) {
    EXPECT_EQ(end_of(text, limits), PlainEnd::not_plain) << text;
  }
}

TEST(XmlPlain, TheHandlerMayStop) {
  EXPECT_EQ(end_of("<a><stop></a>"), PlainEnd::stopped);
}

RC_GTEST_PROP(XmlPlainLaws, WrittenScenesArePlain, ()) {
  const Scene scene = RandomScene(*rc::gen::arbitrary<unsigned>(), 3, false).make();
  Diagnostics diagnostics;
  const std::string text = write_scene(scene, SceneFormat::xml, {}, diagnostics);
  RC_ASSERT(agrees_with_expat(text, {}));
  RC_CLASSIFY(end_of(text) == PlainEnd::complete);
}

// With pieces of markup in wrong places, and with low limits.
RC_GTEST_PROP(XmlPlainLaws, WhatItSaysIsWhatExpatSays, ()) {
  const auto piece = rc::gen::element<std::string>(
      "<a>", "</a>", "<a/>", "<b c='1'>", "</b>", "<b c=\"1\" d='2'/>", " ", "\n", "\r", "<!--",
      "-->", "--", "-", ">", "<", "/", "=", "\"", "'", "&", "x", "c='1'", " d=''", "<stop>", "?>",
      "<?xml version=\"1.0\"?>", "\u00e4", "\xEF\xBF\xBE", "\xC3", "\x7F", "\x02", "]]>",
      "<![CDATA[");
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

RC_GTEST_PROP(XmlPlainLaws, OneByteMayChangeEverything, ()) {
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
