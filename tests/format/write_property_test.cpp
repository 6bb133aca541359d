// Laws of the writers: the output is read without warnings as a scene with the same meaning; if the
// format can represent a scene directly, as the same scene.

#include "format/write_random_scene.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/format/write_forms.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/prepare.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <sstream>
#include <string>

namespace scenefile::testing {
namespace {

constexpr SceneFormat both_formats[] = {SceneFormat::xml, SceneFormat::json};

Scene any_scene(bool moved_area_lights = true) {
  const auto seed = *rc::gen::arbitrary<unsigned>();
  const int size = *rc::gen::inRange(1, 8);
  Scene scene = RandomScene(seed, size, moved_area_lights).make();
  Diagnostics diagnostics;
  check(scene, {}, diagnostics);
  for (const Diagnostic& d : diagnostics.list()) {
    RC_LOG() << d.message << "\n";
  }
  RC_PRE(!diagnostics.has_errors());  // occasionally more lights than the limit
  return scene;
}

Scene form_of(const Scene& scene, SceneFormat format) {
  Diagnostics ignored;
  return format == SceneFormat::xml ? xml_form(scene, {}, ignored) : json_form(scene, ignored);
}

std::string written(const Scene& scene, SceneFormat format) {
  Diagnostics diagnostics;
  std::string text = write_scene(scene, format, {}, diagnostics);
  RC_ASSERT(!diagnostics.has_errors());
  for (const Diagnostic& d : diagnostics.list()) {
    RC_ASSERT(d.severity == Severity::note || d.code == &"write.light-turned"_code);
  }
  return text;
}

Scene read_silently(const std::string& text) {
  Diagnostics diagnostics;
  Scene scene = read_scene(text, {}, diagnostics);
  for (const Diagnostic& d : diagnostics.list()) {
    RC_LOG() << d.location.line << ": " << d.message << "\n";
  }
  RC_ASSERT(diagnostics.count(Severity::error) + diagnostics.count(Severity::warning) == 0);
  return scene;
}

void assert_equal(const Scene& a, const Scene& b) {
  for (const Scene* scene : {&a, &b}) {
    RC_LOG() << list_scene(*scene, SceneFormat::json).text << "\n";
  }
  RC_ASSERT(a == b);
}

RC_GTEST_PROP(WriteLaws, WrittenTextReadsBackAsTheForm, ()) {
  const Scene scene = any_scene();
  for (const SceneFormat format : both_formats) {
    assert_equal(read_silently(written(scene, format)), form_of(scene, format));
  }
}

RC_GTEST_PROP(WriteLaws, FormsAreIdempotent, ()) {
  const Scene scene = any_scene();
  for (const SceneFormat format : both_formats) {
    const Scene form = form_of(scene, format);
    assert_equal(form_of(form, format), form);
  }
}

RC_GTEST_PROP(WriteLaws, WhatAFormatCanExpressReadsBackEqual, ()) {
  const Scene scene = any_scene();
  for (const SceneFormat format : both_formats) {
    const Scene sayable = form_of(scene, format);
    assert_equal(read_silently(written(sayable, format)), sayable);
  }
}

RC_GTEST_PROP(WriteLaws, MeaningIsKept, ()) {
  const Scene scene = any_scene(false);
  for (const SceneFormat format : both_formats) {
    RC_ASSERT(same_meaning(scene, read_silently(written(scene, format))));
  }
}

// What XML cannot represent of an area light is reported, and nothing else differs.
RC_GTEST_PROP(WriteLaws, AreaLightsMeanTheSameOrAreReported, ()) {
  const Scene scene = any_scene();
  Diagnostics diagnostics;
  const std::string text = write_scene(scene, SceneFormat::xml, {}, diagnostics);
  const bool turned = diagnostics.count(Severity::warning) != 0;
  RC_CLASSIFY(turned);
  RC_ASSERT(same_meaning(scene, read_silently(text)) == !turned);
}

float number_in(int low, int high) {
  return static_cast<float>(*rc::gen::inRange(100 * low, 100 * high)) / 100.0f;
}

Transform even_transform(int kind) {
  const auto number = [] { return number_in(-9, 9); };
  const float factor = number_in(0, 3) + 0.01f;
  switch (kind) {
    case 0:
      return {Translate{{number(), number(), number()}}, {}};
    case 1:
      return {Rotate{{0, 1, 0}, number() * 40}, {}};
    default:
      return {Scale{glm::vec3(factor)}, {}};
  }
}

// With translations, rotations about the vertical and uniform scales, XML can represent the light.
RC_GTEST_PROP(WriteLaws, AreaLightsInEvenGroupsMeanTheSame, ()) {
  Scene scene = any_scene(false);
  scene.nodes[scene.root].transforms.clear();
  const NodeId group = add_child(scene, scene.root);
  for (const int kind : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3))) {
    scene.nodes[group].transforms.push_back(even_transform(kind));
  }
  Light light;
  light.type = LightType::area;
  light.direction = {number_in(-3, 3), number_in(-3, 3), 1};
  light.width = number_in(0, 3) + 0.01f;
  light.height = number_in(0, 3) + 0.01f;
  scene.nodes[group].lights = {light};
  Diagnostics diagnostics;
  check(scene, {}, diagnostics);
  RC_PRE(!diagnostics.has_errors());
  Diagnostics writing;
  const std::string text = write_scene(scene, SceneFormat::xml, {}, writing);
  RC_ASSERT(writing.count(Severity::warning) == 0U);
  RC_ASSERT(same_meaning(scene, read_silently(text)));
}

RC_GTEST_PROP(WriteLaws, MeaningIsKeptThereAndBack, ()) {
  const Scene scene = any_scene(false);
  for (const SceneFormat format : both_formats) {
    const SceneFormat other = format == SceneFormat::xml ? SceneFormat::json : SceneFormat::xml;
    const Scene there = read_silently(written(scene, format));
    RC_ASSERT(same_meaning(scene, read_silently(written(there, other))));
  }
}

RC_GTEST_PROP(WriteLaws, IsIdempotent, ()) {
  const Scene scene = any_scene();
  for (const SceneFormat format : both_formats) {
    const std::string text = written(scene, format);
    RC_ASSERT(written(read_silently(text), format) == text);
  }
}

// The line with the number -0 as 0; a name may be -0, too.
std::string with_one_zero(std::string line) {
  for (std::size_t at = 0; (at = line.find("-0", at)) != line.npos; ++at) {
    const std::string_view before = std::string_view(line).substr(0, at);
    const std::string_view after = std::string_view(line).substr(at + 2);
    const bool begins = before.ends_with(' ') || before.ends_with('[') ||
                        (before.ends_with("=\"") && !before.ends_with("name=\""));
    if (begins && (after.empty() || after.find_first_of("\",]") == 0)) {
      line.erase(at, 1);
    }
  }
  return line;
}

// The lines of a listing are those of the text, in which both zeros are one value, without commas,
// and without what has no effect: the names of the scene and of lights, ids, values of lights that
// their types do not use.
RC_GTEST_PROP(WriteLaws, ListingsAreTheTextWithoutWhatHasNoEffect, ()) {
  Scene scene = any_scene();
  scene.camera.emplace();
  scene.name.clear();
  for (Node& node : scene.nodes) {
    for (Light& light : node.lights) {
      clear_unused(light, false);
      light.name.clear();
    }
  }
  for (const SceneFormat format : both_formats) {
    const std::string text = written(scene, format);
    const SceneListing listing = list_scene(scene, format);
    std::size_t line = 0;
    std::istringstream lines(text);
    for (std::string wanted; std::getline(lines, wanted);) {
      if (wanted.find("<id v=") != wanted.npos) {
        continue;
      }
      wanted.resize(wanted.size() - (wanted.ends_with(',') ? 1 : 0));
      wanted = with_one_zero(wanted);
      RC_ASSERT(line < listing.lines.size());
      RC_ASSERT(std::string(std::size_t{2} * listing.lines[line].depth, ' ') +
                    std::string(listing.line(line)) ==
                wanted);
      ++line;
    }
    RC_ASSERT(line == listing.lines.size());
  }
}

}  // namespace
}  // namespace scenefile::testing
