// find_realtime_causes() names the mistakes that a student's program (tests/student/student_gl.h)
// makes, and no others.

#include "scenefile/grade/realtime_causes.h"

#include "scenefile/format/read_scene.h"
#include "scenefile/scene/prepare.h"
#include "student/student_gl.h"
#include "view/software_realtime.h"

#include <glm/glm.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace scenefile {
namespace {

using ::testing::HasSubstr;

constexpr int width = 256;
constexpr int height = 192;

constexpr std::string_view text = R"(<scenefile>
<globaldata><ambientcoeff v="0.4"/><diffusecoeff v="0.6"/><specularcoeff v="0.5"/></globaldata>
<cameradata><pos x="2" y="2.5" z="6"/><look x="-2" y="-2.3" z="-6"/><up x="0" y="1" z="0"/>
<heightangle v="32"/></cameradata>
<lightdata><type v="directional"/><color r="0.7" g="0.7" b="0.7"/>
<direction x="-0.8" y="-1" z="-0.6"/></lightdata>
<lightdata><type v="point"/><color r="0.5" g="0.4" b="0.3"/><position x="-3" y="3" z="3"/>
<function v1="0.6" v2="0.05" v3="0.02"/></lightdata>
<object type="tree" name="root">
<transblock><translate x="-1.2" y="0" z="0"/><scale x="1" y="2" z="1"/>
<object type="primitive" name="sphere"><diffuse r="0.8" g="0.3" b="0.2"/><ambient r="0.3" g="0.1" b="0.1"/>
<specular r="0.6" g="0.6" b="0.6"/><shininess v="12"/></object></transblock>
<transblock><translate x="0" y="0.1" z="0.4"/><rotate x="1" y="0" z="0.4" angle="25"/>
<object type="primitive" name="cylinder"><diffuse r="0.2" g="0.7" b="0.3"/><ambient r="0.1" g="0.2" b="0.1"/>
<specular r="0.4" g="0.4" b="0.4"/><shininess v="8"/></object></transblock>
<transblock><translate x="1.3" y="0" z="0"/><scale x="1" y="1.4" z="1.2"/>
<object type="primitive" name="cone"><diffuse r="0.3" g="0.4" b="0.9"/><ambient r="0.1" g="0.1" b="0.3"/>
</object></transblock>
</object></scenefile>)";

struct Fixture {
  Scene written;
  Prepared ready;
  Assets assets;

  Fixture() {
    Diagnostics diagnostics;
    written = read_scene(text, {}, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors());
    ready = prepare(written, Limits());
  }

  RealtimeView view(const RealtimeOptions& panel) const {
    return {&ready.scene, &assets, &written, panel, &ready.sources};
  }

  Texture right(const RealtimeOptions& panel) const {
    return view_test::software_realtime(ready.scene, panel, width, height).picture;
  }

  Texture student(const RealtimeOptions& panel, const std::string& mistake) const {
    student::RealtimeJob job;
    job.width = width;
    job.height = height;
    job.parameter1 = panel.tessellation.parameter1;
    job.parameter2 = panel.tessellation.parameter2;
    job.near = panel.near;
    job.far = panel.far;
    job.filter = std::string(word_of(panel.filter));
    job.action = panel.milestone == Milestone::action;
    if (!mistake.empty()) {
      job.mistakes.insert(mistake);
    }
    return student::draw_realtime(ready.scene, job);
  }

  // What is claimed about a picture, and said in part or as a note, by line.
  std::string said(const RealtimeOptions& panel, const Texture& test,
                   const std::vector<float>& noise = {}) const {
    RealtimeView scene = view(panel);
    scene.noise = noise;
    const CauseReport report = find_realtime_causes(right(panel), test, scene);
    std::string words;
    for (const auto* list : {&report.claims, &report.partial, &report.notes}) {
      for (const Claim& claim : *list) {
        words += claim.what + '\n';
      }
    }
    return words;
  }

  // The right picture of another scene.
  template <typename Change>
  Texture of_changed(const RealtimeOptions& panel, const Change& change) const {
    RenderScene scene = ready.scene;
    change(scene);
    return view_test::software_realtime(scene, panel, width, height).picture;
  }

  // The names of the causes, separated by commas.
  std::string named(const RealtimeOptions& panel, const std::string& mistake) const {
    const CauseReport report =
        find_realtime_causes(right(panel), student(panel, mistake), view(panel));
    EXPECT_LT(report.share_scene_unlike, 0.01);
    std::string words;
    for (const Claim& claim : report.claims) {
      words += (words.empty() ? "" : ",") + std::string(name_of(claim.cause));
    }
    return words;
  }
};

RealtimeOptions panel_of(Milestone milestone, Filter filter = Filter::none) {
  return {{4, 6}, 0.1, 100, filter, milestone};
}

TEST(RealtimeCauses, NamesMistakes) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  for (const auto& [mistake, cause] :
       {std::pair("parameters-exchanged", "tessellation"),
        std::pair("parameters-7-9", "tessellation"), std::pair("flat", "facets"),
        std::pair("gouraud", "facets"), std::pair("normals-by-model", "normals"),
        std::pair("caps-inside-out", "culling"), std::pair("lights-no-point", "lights"),
        std::pair("lights-replace", "lights"), std::pair("viewport-points", "viewport"),
        std::pair("specular-blinn", "blinn"), std::pair("fov-full", "camera"),
        std::pair("picture-upside-down", "vertical-flip")}) {
    EXPECT_EQ(fixture.named(panel, mistake), cause) << mistake;
  }
}

TEST(RealtimeCauses, NamesMistakesOfOneShape) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  for (const auto& [mistake, words] :
       {std::pair("spheres-twice", "spheres are twice as large as they should be"),
        std::pair("sphere-normals-inward", "normals of spheres point inward"),
        std::pair("cylinder-no-top", "cylinders have no top cap"),
        std::pair("cone-level", "normals of cones are horizontal, like those of cylinders")}) {
    EXPECT_THAT(fixture.said(panel, fixture.student(panel, mistake)), HasSubstr(words)) << mistake;
  }
}

// Axes of a view matrix act the other way than those that rays are made of.
TEST(RealtimeCauses, AxesOfTheCameraAreRowsOfTheViewMatrix) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  const Texture test = fixture.of_changed(panel, [](RenderScene& scene) {
    scene.camera.u = glm::cross(glm::dvec3(0, 1, 0), scene.camera.w);
    scene.camera.v = glm::cross(scene.camera.w, scene.camera.u);
  });
  EXPECT_EQ(fixture.said(panel, test),
            "the camera's right axis is not normalized, and up is computed from it\n");
}

TEST(RealtimeCauses, AWeakTermIsNotAMissingOne) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  const auto with = [&](float specular) {
    return fixture.said(panel, fixture.of_changed(panel, [&](RenderScene& scene) {
      scene.global.specular = specular;
    }));
  };
  EXPECT_THAT(with(0), HasSubstr("the specular term is missing"));
  EXPECT_EQ(with(0.05F), "");
}

TEST(RealtimeCauses, OneMistakeIsNotTwo) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  Texture test = fixture.right(panel);
  for (std::uint8_t& value : test.rgb) {
    value = static_cast<std::uint8_t>(std::lround(0.3 * value));
  }
  EXPECT_EQ(fixture.said(panel, test), "the picture is 0.30 times as bright as it should be\n");
}

// Programs may split quads as they like. The other direction of wedges looks the same.
TEST(RealtimeCauses, WhatProgramsMayChooseIsSaidFirst) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  EXPECT_THAT(fixture.said(panel, fixture.student(panel, "other-diagonal")),
              ::testing::StartsWith(
                  "quads are split along their other diagonal (not a mistake by itself)"));
}

TEST(RealtimeCauses, OtherSamplesOfPixelsAreNotMistakes) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::lights_camera);
  const Texture large =
      view_test::software_realtime(fixture.ready.scene, panel, 2 * width, 2 * height).picture;
  Texture test = fixture.right(panel);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        int sum = 2;
        for (int k = 0; k < 4; ++k) {
          sum += large.texel(2 * x + k % 2, 2 * y + k / 2)[c];
        }
        test.rgb[3 * (std::size_t(y) * width + std::size_t(x)) + std::size_t(c)] =
            static_cast<std::uint8_t>(sum / 4);
      }
    }
  }
  EXPECT_EQ(fixture.said(panel, test), "");
}

// As those that compression as a JPEG changes much.
TEST(RealtimeCauses, UncertainPixelsAreNotEvidence) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  Texture test = fixture.student(panel, "sphere-normals-inward");
  std::vector<float> noise(std::size_t(width) * height, 0);
  for (std::size_t i = 0; i < noise.size(); i += 5) {
    noise[i] = std::numeric_limits<float>::infinity();
    test.rgb[3 * i] ^= 0x40;
  }
  EXPECT_EQ(fixture.said(panel, test), "");
  EXPECT_EQ(fixture.said(panel, test, noise), "normals of spheres point inward\n");
}

// The pixel that is asked for, drawn with the mistakes, is that of the picture.
TEST(RealtimeCauses, DrawsAPixelWithTheMistakes) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  const Texture right = fixture.right(panel);
  for (const std::string mistake : {"lights-no-point", "gouraud", "normals-by-model",
                                    "specular-blinn", "picture-upside-down", "caps-inside-out"}) {
    const Texture test = fixture.student(panel, mistake);
    RealtimeView view = fixture.view(panel);
    for (int y = 8; y < height; y += 5) {
      for (int x = 8; x < width; x += 5) {
        const auto color = [&](const Texture& t) {
          const std::uint8_t* p = t.texel(x, y);
          return glm::dvec3(p[0], p[1], p[2]);
        };
        if (glm::distance(color(test), color(right)) > 15) {
          view.asked = glm::dvec2(x, y) + 0.5;
          const CauseReport report = find_realtime_causes(right, test, view);
          ASSERT_TRUE(report.asked) << mistake;
          EXPECT_LT(glm::distance(report.asked->color, color(test)), 4) << mistake;
          y = height;
          break;
        }
      }
    }
    EXPECT_TRUE(view.asked) << mistake;
  }
}

TEST(RealtimeCauses, NamesClippingAndCulling) {
  const Fixture fixture;
  RealtimeOptions panel = panel_of(Milestone::lights_camera);
  panel.near = 6.2;
  panel.far = 7.1;
  EXPECT_EQ(fixture.named(panel, "no-culling"), "culling");
  EXPECT_EQ(fixture.named(panel, "near-ignored"), "clipping");
  EXPECT_EQ(fixture.named(panel, "far-ignored"), "clipping");
}

TEST(RealtimeCauses, NamesFilters) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action, Filter::blur);
  for (const char* mistake : {"no-filter", "blur-unnormalized", "blur-3", "blur-across"}) {
    EXPECT_EQ(fixture.named(panel, mistake), "filter") << mistake;
  }
}

TEST(RealtimeCauses, NamesNothingForCorrectProgramsAndUnknownMistakes) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  for (const char* mistake : {"", "habit-subpixel-4", "habit-other-edges", "habit-no-snapping",
                              "strange-stripes", "strange-bent", "strange-noise"}) {
    EXPECT_EQ(fixture.named(panel, mistake), "") << mistake;
  }
}

TEST(RealtimeCauses, ValuesAddedToThePictureAreNotMistakesOfLighting) {
  const Fixture scene;
  const Texture reference = scene.right(panel_of(Milestone::action));
  const auto causes_of = [&](const auto& change) {
    Texture test = reference;
    for (std::size_t i = 0; i < test.rgb.size(); ++i) {
      test.rgb[i] = static_cast<std::uint8_t>(std::clamp(change(int(test.rgb[i]), i % 3), 0, 255));
    }
    std::string whats;
    for (const Claim& claim :
         find_realtime_causes(reference, test, scene.view(panel_of(Milestone::action))).claims) {
      whats += claim.what + '\n';
    }
    return whats;
  };
  EXPECT_EQ(causes_of([](int v, std::size_t) { return v + 10; }),
            "10 of 255 was added to all values\n");
  EXPECT_EQ(causes_of([](int v, std::size_t) { return v - 12; }),
            "12 of 255 was subtracted from all values\n");
  EXPECT_EQ(causes_of([](int v, std::size_t) { return v + 3; }), "");
  EXPECT_EQ(causes_of([](int v, std::size_t c) { return c == 0 ? v + 10 : v; }), "");
  EXPECT_EQ(causes_of([](int v, std::size_t) { return v / 64 * 64; }), "");
}

// What is claimed about a picture that was edited: `change` gets the place, the channel and the
// color of the pixel before the edit.
template <typename Change>
std::string claims_about(const Change& change) {
  const Fixture scene;
  const Texture reference = scene.right(panel_of(Milestone::action));
  Texture test = reference;
  for (int y = 0; y < test.height; ++y) {
    for (int x = 0; x < test.width; ++x) {
      const std::size_t first = 3 * (std::size_t(y) * std::size_t(test.width) + std::size_t(x));
      const glm::ivec3 before(reference.rgb[first], reference.rgb[first + 1],
                              reference.rgb[first + 2]);
      const glm::ivec3 after = glm::clamp(change(x, y, before), glm::ivec3(0), glm::ivec3(255));
      for (int c = 0; c < 3; ++c) {
        test.rgb[first + std::size_t(c)] = static_cast<std::uint8_t>(after[c]);
      }
    }
  }
  const CauseReport report =
      find_realtime_causes(reference, test, scene.view(panel_of(Milestone::action)));
  std::string whats;
  for (const auto& claims : {report.claims, report.partial}) {
    for (const Claim& claim : claims) {
      whats += claim.what + '\n';
    }
  }
  return whats;
}

TEST(RealtimeCauses, CurvesHoldForTheWholePicture) {
  EXPECT_EQ(
      claims_about([](int, int y, const glm::ivec3& c) { return y % 2 == 0 ? c : c * 7 / 10; }),
      "");
  EXPECT_EQ(claims_about([](int, int, const glm::ivec3& c) {
              return c == glm::ivec3(0) ? c : c + glm::ivec3(10);
            }),
            "10 of 255 was added to all colors but black\n");
}

TEST(RealtimeCauses, AnAreaOfOneColorIsDrawn) {
  const auto lower_rows = [](const glm::ivec3& color) {
    return claims_about(
        [&](int, int y, const glm::ivec3& c) { return y >= height / 2 ? color : c; });
  };
  EXPECT_EQ(lower_rows({231, 228, 17}), "");
  EXPECT_THAT(lower_rows({0, 0, 0}), ::testing::HasSubstr("not drawn"));
}

TEST(RealtimeCauses, FindsTheSettingsOfAReference) {
  const Fixture fixture;
  for (const RealtimeOptions& panel :
       {panel_of(Milestone::action, Filter::blur), panel_of(Milestone::lights_camera),
        panel_of(Milestone::action, Filter::invert)}) {
    const RealtimeOptions found = find_realtime_settings(fixture.right(panel), fixture.view({}),
                                                         {true, true, true, true, true});
    EXPECT_EQ(realtime_words(found), realtime_words(panel));
  }
}

TEST(RealtimeCauses, KeepsGivenSettings) {
  const Fixture fixture;
  const RealtimeOptions panel = panel_of(Milestone::action);
  RealtimeOptions given = panel;
  given.tessellation = {9, 9};
  const RealtimeOptions found =
      find_realtime_settings(fixture.right(panel), fixture.view(given), {.filter = true});
  EXPECT_EQ(found.tessellation, given.tessellation);
  EXPECT_EQ(found.milestone, given.milestone);
}

TEST(RealtimeCauses, SettingsAreCommandLineOptions) {
  EXPECT_EQ(realtime_words({{1, 3}, 9.5, 12, Filter::sharpen, Milestone::action}),
            "--profile realtime --parameters 1,3 --near 9.5 --far 12 --filter sharpen "
            "--milestone action");
  EXPECT_EQ(realtime_words({}), "--profile realtime --parameters 5,5");
}

}  // namespace
}  // namespace scenefile
