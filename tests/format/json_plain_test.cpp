// The reader of plain JSON makes the tape that RapidJSON makes, or none.

#include "scenefile/format/json_plain.h"

#include "format/write_random_scene.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/write_scene.h"
#include "support/plain_agreement.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace scenefile::testing {
namespace {

bool is_plain(std::string_view text, std::uint32_t max_depth = 100) {
  JsonTape tape;
  return read_plain_json(text, max_depth, tape);
}

TEST(JsonPlain, WhatIsPlain) {
  for (const std::string text :
       {"{}", "[]", " \r\n\t[ ]\n", "{\"a\":1}", "{ \"a\" : [ { } , [ ] , \"\" ] , \"b\" : null }",
        "[0,-0,0.5,-10.25,1e-5,1.5E-07,true,false,null]", "[\"}]{[,:\x7f\u00e4\U0001F600\"]",
        "{\"}\":{\"]\":\"}\"}}"}) {
    EXPECT_TRUE(is_plain(text)) << text;
    EXPECT_TRUE(agrees_with_rapidjson(text)) << text;
  }
}

TEST(JsonPlain, WhatIsNotIsLeftToRapidjson) {
  for (const std::string_view text : {"",
                                      " ",
                                      "1",
                                      "\"\"",
                                      "[",
                                      "]",
                                      "{",
                                      "}",
                                      "[}",
                                      "{]",
                                      "[]]",
                                      "[[]",
                                      "[] []",
                                      "[]x",
                                      "x[]",
                                      "[1 2]",
                                      "[1,]",
                                      "[,1]",
                                      "[,]",
                                      "{\"a\"}",
                                      "{\"a\":}",
                                      "{\"a\" 1}",
                                      "{\"a\":1,}",
                                      "{a:1}",
                                      "{1:1}",
                                      "{,}",
                                      "[01]",
                                      "[1.]",
                                      "[.5]",
                                      "[+1]",
                                      "[-]",
                                      "[--1]",
                                      "[1e]",
                                      "[1e-]",
                                      "[1e+5]",
                                      "[1e5]",
                                      "[0x1]",
                                      "[nul]",
                                      "[True]",
                                      "[NaN]",
                                      "[\"a]",
                                      "[\"a\n\"]",
                                      "[\"\\n\"]",
                                      "[\"\xff\"]",
                                      "[\"\xed\xa0\x80\"]",
                                      "['a']",
                                      "[//\n]",
                                      "[1\v]",
                                      "[\"]",
                                      "[\"}",
                                      "[tru",
                                      "[\"a\"\"b\"]",
                                      "[[]1]",
                                      "{\"a\":{}\"b\":1}"}) {
    EXPECT_FALSE(is_plain(text)) << text;
  }
  EXPECT_FALSE(is_plain(std::string_view("[\"\0\"]", 5)));
  EXPECT_FALSE(is_plain('[' + std::string(400, '9') + ']'));
}

TEST(JsonPlain, TheDepthIsLimited) {
  EXPECT_TRUE(is_plain("[{\"a\":0}]", 2));
  EXPECT_FALSE(is_plain("[{\"a\":[]}]", 2));
}

RC_GTEST_PROP(JsonPlainLaws, OneByteMayChangeEverything, ()) {
  const Scene scene = RandomScene(*rc::gen::arbitrary<unsigned>(), 2, true).make();
  Diagnostics diagnostics;
  const std::string text = write_scene(scene, SceneFormat::json, {}, diagnostics);
  RC_PRE(!text.empty());
  RC_ASSERT(agrees_with_rapidjson(text));
  for (int i = 0; i < 50; ++i) {
    std::string changed = text;
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    changed[at] = *rc::gen::weightedOneOf<char>(
        {{1, rc::gen::arbitrary<char>()},
         {2, rc::gen::elementOf(std::string("{}[],:\"\\-+.eE0123456789tfn \n"))}});
    RC_ASSERT(agrees_with_rapidjson(changed));
  }
}

// With pieces in the wrong places.
RC_GTEST_PROP(JsonPlainLaws, WhatItMakesIsWhatRapidjsonMakes, ()) {
  const auto piece = rc::gen::element<std::string>(
      "{", "}", "[", "]", "{}", "[]", ",", ":", " ", "\n", "\"", "\"a\"", "\"a\":", "\"a\":1,", "0",
      "-", "12", ".5", "e-3", "e3", "true", "null", "\\", "\u00e4", "\xC3", "\x01", "1,2");
  std::string text;
  for (const std::string& part : *rc::gen::container<std::vector<std::string>>(piece)) {
    text += part;
  }
  RC_ASSERT(agrees_with_rapidjson(text));
  RC_ASSERT(agrees_with_rapidjson('[' + text + ']', 3));
  RC_ASSERT(agrees_with_rapidjson("{\"a\":[\"" + text + "\"]}"));
}

}  // namespace
}  // namespace scenefile::testing
