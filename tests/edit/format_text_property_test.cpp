// Laws of lay_out(): it is idempotent; it keeps the scene and its findings; the writers' output is
// already formatted; only white space changes.

#include "format/reading.h"
#include "format/write_random_scene.h"
#include "scenefile/edit/format_text.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/scene/prepare.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

namespace scenefile::testing {
namespace {

constexpr SceneFormat formats[] = {SceneFormat::xml, SceneFormat::json};

std::string written_scene(SceneFormat format) {
  const auto seed = *rc::gen::arbitrary<unsigned>();
  Diagnostics diagnostics;
  std::string text =
      write_scene(RandomScene(seed, *rc::gen::inRange(1, 6), true).make(), format, {}, diagnostics);
  RC_PRE(!diagnostics.has_errors());
  return text;
}

std::string tidied(const std::string& text) {
  Diagnostics diagnostics;
  const std::optional<std::string> result = lay_out(text, {}, diagnostics);
  RC_ASSERT(result.has_value());
  return *result;
}

const std::string& any_of(std::mt19937& random, const std::vector<std::string>& choices) {
  return choices[random() % choices.size()];
}

// Changes insignificant white space inside XML tags, or around JSON punctuation.
std::string disordered_inside(const std::string& text, SceneFormat format, std::mt19937& random) {
  const bool xml = format == SceneFormat::xml;
  std::string result;
  bool in_string = false;
  bool in_tag = !xml;
  for (const char c : text) {
    in_string ^= c == '"' && in_tag;
    in_tag = !xml || (in_string ? in_tag : c == '<' || (in_tag && c != '>'));
    const bool inside = in_tag && !in_string;
    if (inside && xml && c == ' ') {
      result += any_of(random, {" ", "  ", "\n", "\t "});
    } else if (inside && (xml ? c == '=' : c == ':' || c == ',')) {
      result += any_of(random, {"", " ", "\n"}) + c + any_of(random, {"", "  ", "\r\n"});
    } else {
      result += c;
    }
  }
  return result;
}

// The same text as an author could have left it: different white space, empty lines and comments
// between XML tokens, different white space between JSON tokens and inside tags.
std::string disordered(const std::string& text, SceneFormat format) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const std::vector<std::string> xml_gaps = {
      "", " ", "\n", "\n\n\n\t", "\r\n", "<!--c-->", "\n<!-- \n -->", " <!-- a  b --> "};
  const std::vector<std::string> json_gaps = {"", " ", "\n", "\n\n\t", "\r\n"};
  const std::vector<std::string>& gaps = format == SceneFormat::xml ? xml_gaps : json_gaps;
  const std::string inside = disordered_inside(text, format, random);
  std::string result;
  bool in_tag = false;
  for (std::size_t i = 0; i < inside.size();) {
    in_tag = format == SceneFormat::xml && (inside[i] == '<' || (in_tag && inside[i] != '>'));
    if (inside[i] != '\n' || in_tag) {
      result += inside[i++];
      continue;
    }
    result += any_of(random, gaps);
    i = std::min(inside.find_first_not_of(" \n", i), inside.size());
  }
  return result;
}

// All XML comments, including their white space.
std::vector<std::string> comments_of(const std::string& text) {
  std::vector<std::string> comments;
  for (std::size_t at = 0; (at = text.find("<!--", at)) != std::string::npos;) {
    const std::size_t end = text.find("-->", at);
    comments.push_back(text.substr(at, end - at));
    at = end;
  }
  return comments;
}

std::string without_blanks(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(),
                            [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }),
             text.end());
  return text;
}

RC_GTEST_PROP(LayoutLaws, WhatIsWrittenIsLaidOut, ()) {
  for (const SceneFormat format : formats) {
    const std::string text = written_scene(format);
    RC_ASSERT(tidied(text) == text);
  }
}

RC_GTEST_PROP(LayoutLaws, IsIdempotent, ()) {
  for (const SceneFormat format : formats) {
    const std::string once = tidied(disordered(written_scene(format), format));
    RC_ASSERT(tidied(once) == once);
  }
}

RC_GTEST_PROP(LayoutLaws, OnlyWhiteSpaceChanges, ()) {
  for (const SceneFormat format : formats) {
    const std::string text = disordered(written_scene(format), format);
    RC_ASSERT(without_blanks(tidied(text)) == without_blanks(text));
  }
}

RC_GTEST_PROP(LayoutLaws, CommentsStay, ()) {
  const std::string text = disordered(written_scene(SceneFormat::xml), SceneFormat::xml);
  RC_ASSERT(comments_of(tidied(text)) == comments_of(text));
}

RC_GTEST_PROP(LayoutLaws, TheSceneStays, ()) {
  for (const SceneFormat format : formats) {
    const std::string text = disordered(written_scene(format), format);
    const Reading before = read(text);
    const Reading after = read(tidied(text));
    RC_ASSERT(before.scene == after.scene);
    RC_ASSERT(same_meaning(before.scene, after.scene));
    RC_ASSERT(before.diagnostics.list().size() == after.diagnostics.list().size());
  }
}

}  // namespace
}  // namespace scenefile::testing
