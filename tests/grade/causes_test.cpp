// The student's tracer, which shares no code with the model, makes each mistake on generated
// scenes. Each must be named on three of four scenes, and no mistake may be named for correct
// pictures. `make mistakes-ledger` counts the answers for many more pictures.

#include "scenefile/grade/causes.h"

#include "grade/generated_scene.h"
#include "scenefile/mistakes/hypotheses.h"
#include "scenefile/scene/prepare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace scenefile::grade_test {
namespace {

constexpr std::uint32_t scenes = 4;
constexpr int width = 96;
constexpr int height = 72;

using Mistakes = std::set<std::string, std::less<>>;
using Change = std::function<Texture(const Texture&)>;

SceneView view_of(const GeneratedScene& scene) {
  RenderOptions options = default_options(Profile::course);
  options.features.texture_filter = false;
  return {&scene.builder.scene, &scene.builder.assets, options, nullptr, {}};
}

Texture reference_of(const GeneratedScene& scene, bool super_sample) {
  RenderOptions options = view_of(scene).options;
  options.features.super_sample = super_sample;
  return quantize(scene.builder.picture(width, height, options), Rounding::truncate);
}

std::string said(const CauseReport& report) {
  std::string text = "claims:";
  for (const Claim& claim : report.claims) {
    text +=
        " [" + claim.what + ": " + std::to_string(claim.explained) + ", " + claim.evidence + "]";
  }
  for (const Claim& claim : report.rivals) {
    text += " or [" + claim.what + "]";
  }
  return text;
}

using Draw = std::function<Texture(std::uint32_t seed)>;

// The cause must be the first and only claim for nearly all scenes. `drawn`: the student's picture
// of a scene.
void expect_named_in(Cause cause, const Draw& drawn, bool with_scene = true,
                     std::string_view words = {}) {
  std::uint32_t named = 0;
  std::string others;
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    const GeneratedScene scene(seed);
    const Texture picture = drawn(seed);
    const SceneView view = view_of(scene);
    const CauseReport report =
        find_causes(reference_of(scene, seed % 2 == 0), picture, with_scene ? &view : nullptr);
    const bool right = report.claims.size() == 1 && report.claims.front().cause == cause &&
                       report.claims.front().what.find(words) != std::string::npos;
    named += right ? 1 : 0;
    others += right ? "" : std::to_string(seed) + ": " + said(report) + "\n";
  }
  EXPECT_GE(named, scenes - 1) << name_of(cause) << "\n" << others;
}

void expect_named(Cause cause, const Mistakes& mistakes, const Change& change = {},
                  bool with_scene = true) {
  expect_named_in(
      cause,
      [&](std::uint32_t seed) {
        const Texture picture = GeneratedScene(seed).drawn_by_student(mistakes);
        return change ? change(picture) : picture;
      },
      with_scene);
}

// As drawn by a program without mistakes that reads something else from the file.
void expect_named_if_changed(Cause cause, const std::function<void(RenderScene&)>& change,
                             std::string_view words = {}) {
  const auto drawn = [&](std::uint32_t seed) {
    GeneratedScene scene(seed);
    change(scene.builder.scene);
    return scene.drawn_by_student({});
  };
  expect_named_in(cause, drawn, true, words);
}

const Mistakes nothing;

TEST(Causes, CorrectPicturesHaveNoCauses) {
  for (std::uint32_t seed = 1; seed <= 5 * scenes; ++seed) {
    const GeneratedScene scene(seed);
    const SceneView view = view_of(scene);
    for (const bool super_sample : {false, true}) {
      const Texture reference = reference_of(scene, super_sample);
      const Texture student = scene.drawn_by_student({});
      const CauseReport report = find_causes(reference, student, &view);
      EXPECT_TRUE(report.claims.empty()) << seed << ": " << said(report);
      EXPECT_LT(report.share_scene_unlike, 0.02) << seed;
      EXPECT_TRUE(find_causes(reference, student).claims.empty()) << seed;
    }
  }
}

TEST(Causes, OtherSamplesHaveNoCauses) {
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    const GeneratedScene scene(seed);
    const SceneView view = view_of(scene);
    RenderOptions fine = default_options(Profile::fine);
    fine.features.texture_filter = false;
    const Image drawn = scene.builder.picture(width, height, fine);
    const CauseReport report =
        find_causes(reference_of(scene, false), quantize(drawn, Rounding::truncate), &view);
    EXPECT_TRUE(report.claims.empty()) << seed << ": " << said(report);
  }
}

Texture means_of_four(const Texture& large) {
  Texture small{large.width / 2, large.height / 2, {}};
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int sum = large.texel(2 * x, 2 * y)[c] + large.texel(2 * x + 1, 2 * y)[c] +
                        large.texel(2 * x, 2 * y + 1)[c] + large.texel(2 * x + 1, 2 * y + 1)[c];
        small.rgb.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
    }
  }
  return small;
}

TEST(Causes, FourSamplesAreNotedAndNoMistake) {
  std::size_t noted = 0;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const GeneratedScene scene(seed);
    const SceneView view = view_of(scene);
    const Texture reference = reference_of(scene, false);
    const auto drawn = [&](const SceneView& drawn_view) {
      return means_of_four(quantize(
          scene.builder.picture(2 * width, 2 * height, drawn_view.options), Rounding::truncate));
    };
    const CauseReport right = find_causes(reference, drawn(view), &view);
    EXPECT_TRUE(right.claims.empty()) << seed << ": " << said(right);
    noted += right.notes.empty() ? 0 : 1;
    if (seed > 1) {
      continue;  // the search below takes seconds
    }
    SceneView without = view;
    without.options.features.shadows = false;
    without.options.features.texture = false;
    const CauseReport wrong = find_causes(reference, drawn(without), &view);
    EXPECT_TRUE(wrong.notes.empty() || !wrong.claims.empty()) << seed;
    EXPECT_TRUE(std::none_of(wrong.claims.begin(), wrong.claims.end(),
                             [](const Claim& c) { return c.cause == Cause::samples; }))
        << seed << ": " << said(wrong);
  }
  EXPECT_GE(noted, 2u);
}

TEST(Causes, NoiseHasNoCauses) {
  std::mt19937 random(7);
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    const GeneratedScene scene(seed);
    const SceneView view = view_of(scene);
    const Texture reference = reference_of(scene, false);
    Texture noisy = reference;
    for (std::uint8_t& value : noisy.rgb) {
      value = static_cast<std::uint8_t>(std::clamp(int{value} + int(random() % 31) - 15, 0, 255));
    }
    const CauseReport report = find_causes(reference, noisy, &view);
    EXPECT_TRUE(report.claims.empty()) << seed << ": " << said(report);
  }
}

TEST(Causes, Rounding) {
  expect_named(Cause::rounding, {"habit-rounds"});
}

// Where many values differ by more, it is true, but not why.
TEST(Causes, RoundingIsNoCauseWhereMoreIsWrong) {
  std::mt19937 random(3);
  Texture reference;
  reference.width = reference.height = 128;
  for (int i = 0; i < 3 * 128 * 128; ++i) {
    reference.rgb.push_back(static_cast<std::uint8_t>(20 + i / 3 / 80));
  }
  Texture test = reference;
  for (std::uint8_t& value : test.rgb) {
    value = static_cast<std::uint8_t>(value + (random() % 3 == 0 ? 1 : 0) +
                                      (random() % 5 == 0 ? 3 : 0));
  }
  const CauseReport report = find_causes(reference, test);
  EXPECT_TRUE(report.claims.empty()) << said(report);
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_EQ(report.notes.front().cause, Cause::rounding);
}

// Values that differ by one at some levels of brightness only are not rounded.
TEST(Causes, StepsAtSomeLevelsAreNotRounding) {
  for (const int highest : {60, 254}) {
    Texture reference;
    reference.width = reference.height = 128;
    for (int i = 0; i < 3 * 128 * 128; ++i) {
      reference.rgb.push_back(static_cast<std::uint8_t>(i / 3 / 64));
    }
    Texture test = reference;
    for (std::size_t i = 0; i < test.rgb.size(); i += 2) {
      const int value = reference.rgb[i];
      test.rgb[i] = static_cast<std::uint8_t>(value + (value < highest ? 1 : 0));
    }
    const CauseReport report = find_causes(reference, test);
    EXPECT_EQ(report.claims.size(), highest > 200 ? 1u : 0u) << said(report);
  }
}

Change turned(bool across, bool down) {
  return [=](const Texture& t) {
    Texture result = t;
    for (int y = 0; y < t.height; ++y) {
      for (int x = 0; x < t.width; ++x) {
        const std::uint8_t* from =
            t.texel(across ? t.width - 1 - x : x, down ? t.height - 1 - y : y);
        std::copy_n(from, 3, result.rgb.begin() + 3 * (y * t.width + x));
      }
    }
    return result;
  };
}

TEST(Causes, Flips) {
  for (const bool with_scene : {true, false}) {
    expect_named(Cause::vertical_flip, nothing, turned(false, true), with_scene);
    expect_named(Cause::horizontal_flip, nothing, turned(true, false), with_scene);
  }
}

TEST(Causes, Gamma) {
  for (const double power : {1 / 2.2, 2.2, 1 / 1.8}) {
    expect_named(Cause::gamma, nothing, [=](const Texture& t) {
      Texture result = t;
      for (std::uint8_t& v : result.rgb) {
        v = static_cast<std::uint8_t>(255 * std::pow(v / 255.0, power));
      }
      return result;
    });
  }
}

TEST(Causes, SwappedChannels) {
  expect_named(Cause::swapped_channels, nothing, [](const Texture& t) {
    Texture result = t;
    for (std::size_t i = 0; i < t.rgb.size(); i += 3) {
      std::swap(result.rgb[i], result.rgb[i + 2]);
    }
    return result;
  });
}

Change filled(const std::function<bool(int x, int y)>& chosen) {
  return [=](const Texture& t) {
    Texture result = t;
    for (int y = 0; y < t.height; ++y) {
      for (int x = 0; x < t.width; ++x) {
        if (chosen(x, y)) {
          std::fill_n(result.rgb.begin() + 3 * (y * t.width + x), 3, std::uint8_t{0});
        }
      }
    }
    return result;
  };
}

TEST(Causes, PartsThatAreNotDrawn) {
  for (const bool with_scene : {true, false}) {
    expect_named(Cause::black, nothing, filled([](int, int y) { return y >= height / 2; }),
                 with_scene);
    expect_named(Cause::black, nothing, filled([](int x, int) { return x % 2 == 1; }), with_scene);
    expect_named(Cause::black, nothing, filled([](int x, int y) { return (x + y) % 2 == 0; }),
                 with_scene);
    expect_named(Cause::black, nothing, filled([](int x, int y) { return x % 2 + y % 2 > 0; }),
                 with_scene);
  }
  expect_named(Cause::black, nothing,
               filled([](int x, int y) { return x >= 20 && x < 80 && y >= 16 && y < 64; }));
  const GeneratedScene scene(1);
  const SceneView view = view_of(scene);
  const CauseReport half =
      find_causes(reference_of(scene, false),
                  filled([](int, int y) { return y >= 36; })(scene.drawn_by_student({})), &view);
  ASSERT_EQ(half.claims.size(), 1u);
  EXPECT_EQ(half.claims.front().what, "rows 36 to 71 of 72 are not drawn");
  const CauseReport row =
      find_causes(reference_of(scene, false),
                  filled([](int, int y) { return y == 71; })(scene.drawn_by_student({})), &view);
  ASSERT_EQ(row.claims.size(), 1u);
  EXPECT_EQ(row.claims.front().what, "row 71 of 72 is not drawn");
}

TEST(Causes, MissingShapesAreNotMissingParts) {
  for (const char* shape : {"shape-no-spheres", "shape-no-cubes", "shape-no-cones"}) {
    for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
      const GeneratedScene scene(seed);
      const CauseReport report =
          find_causes(reference_of(scene, false), scene.drawn_by_student({shape}));
      EXPECT_TRUE(report.claims.empty() || report.claims.front().cause != Cause::black)
          << said(report);
    }
  }
}

Change each_value(const std::function<int(const std::uint8_t* pixel, int channel)>& value) {
  return [=](const Texture& t) {
    Texture result = t;
    for (std::size_t i = 0; i < t.rgb.size(); ++i) {
      result.rgb[i] = static_cast<std::uint8_t>(
          std::clamp(value(t.rgb.data() + i / 3 * 3, static_cast<int>(i % 3)), 0, 255));
    }
    return result;
  };
}

TEST(Causes, AConstantAddedToAllValues) {
  for (const int step : {20, -15}) {
    expect_named(
        Cause::brightness, nothing,
        each_value([=](const std::uint8_t* pixel, int channel) { return pixel[channel] + step; }));
  }
}

TEST(Causes, ContrastAndTintOfTheWholePicture) {
  expect_named(Cause::brightness, nothing, each_value([](const std::uint8_t* pixel, int channel) {
                 return static_cast<int>(std::lround(0.8 * pixel[channel] + 26));
               }));
  expect_named(
      Cause::brightness, nothing, each_value([](const std::uint8_t* pixel, int channel) {
        constexpr std::array<double, 3> factors{1.2, 1, 0.75};
        return static_cast<int>(std::lround(factors[std::size_t(channel)] * pixel[channel]));
      }));
}

// The pixel of the picture at a place that is computed from the pixel's own; black outside.
Change moved(const std::function<glm::ivec2(const glm::ivec2&)>& from) {
  return [=](const Texture& t) {
    Texture result = t;
    for (int y = 0; y < t.height; ++y) {
      for (int x = 0; x < t.width; ++x) {
        const glm::ivec2 p = from({x, y});
        const bool inside = p.x >= 0 && p.y >= 0 && p.x < t.width && p.y < t.height;
        for (int k = 0; k < 3; ++k) {
          result.rgb[std::size_t{3} * (y * t.width + x) + k] =
              inside ? t.texel(p.x, p.y)[k] : std::uint8_t(0);
        }
      }
    }
    return result;
  };
}

TEST(Causes, CopiesAtAnotherPlace) {
  for (const bool with_scene : {true, false}) {
    expect_named(Cause::viewport, nothing, moved([](const glm::ivec2& p) {
                   return p.y < height / 2 ? glm::ivec2(-1) : glm::ivec2(2 * p.x, 2 * p.y - height);
                 }),
                 with_scene);
    expect_named(Cause::viewport, nothing,
                 moved([](const glm::ivec2& p) { return p - glm::ivec2(3, -2); }), with_scene);
    expect_named(Cause::viewport, nothing, moved([](const glm::ivec2& p) { return p / 2; }),
                 with_scene);
  }
}

TEST(Causes, QuarterTurnsOfWidePictures) {
  const GeneratedScene scene(1);
  const Texture reference = reference_of(scene, false);
  const auto turned = [&](const std::function<glm::ivec2(int x, int y)>& from) {
    Texture t;
    t.width = reference.height;
    t.height = reference.width;
    for (int y = 0; y < t.height; ++y) {
      for (int x = 0; x < t.width; ++x) {
        const glm::ivec2 p = from(x, y);
        const std::uint8_t* texel = reference.texel(p.x, p.y);
        t.rgb.insert(t.rgb.end(), texel, texel + 3);
      }
    }
    return find_causes(reference, t, nullptr);
  };
  const CauseReport transposed = turned([](int x, int y) { return glm::ivec2(y, x); });
  ASSERT_EQ(transposed.claims.size(), 1u);
  EXPECT_NE(transposed.claims.front().what.find("transposed"), std::string::npos);
  const CauseReport clockwise = turned([](int x, int y) { return glm::ivec2(y, height - 1 - x); });
  ASSERT_EQ(clockwise.claims.size(), 1u);
  EXPECT_TRUE(clockwise.claims.front().what.ends_with(", clockwise"));
  const CauseReport other = turned([](int x, int y) { return glm::ivec2(x, y % height); });
  EXPECT_TRUE(other.claims.empty()) << said(other);
}

TEST(Causes, DiagonalShiftsByOnePixel) {
  const GeneratedScene scene(2);
  const SceneView view = view_of(scene);
  const Texture shifted =
      moved([](const glm::ivec2& p) { return p - glm::ivec2(1, 1); })(scene.drawn_by_student({}));
  const CauseReport report = find_causes(reference_of(scene, true), shifted, &view);
  ASSERT_EQ(report.claims.size(), 1u) << said(report);
  EXPECT_EQ(report.claims.front().what,
            "the picture is shifted by one pixel (right and down): rows or columns are counted "
            "from 1")
      << said(report);
}

TEST(Causes, WrappedValuesKeepTheirFractions) {
  std::size_t found = 0;
  for (const Hypothesis& h : picture_hypotheses()) {
    if (h.what == "values over 1 wrap around to dark: they are not clamped") {
      ++found;
      EXPECT_NEAR(h.color(glm::dvec3(0.7031)).x, 0.7031, 1e-9);
      EXPECT_NEAR(h.color(glm::dvec3(257.5 / 255)).x, 1.5 / 255, 1e-9);
    }
  }
  EXPECT_EQ(found, 1u);
}

TEST(Causes, ExponentsAreFitted) {
  // Of all materials `before`, or those of the scene; and in the test `after`, or so many times.
  const auto with_exponents = [](std::optional<float> before, const std::optional<float>& after) {
    const auto shiny = [](const std::optional<float>& all, float times) {
      GeneratedScene scene(1);
      for (RenderMaterial& m : scene.builder.scene.materials) {
        m.specular = glm::vec3(0.8f);
        m.shininess = times * all.value_or(m.shininess);
      }
      return scene;
    };
    const GeneratedScene scene = shiny(before, 1);
    const GeneratedScene changed = after ? shiny(after, 1) : shiny(before, 3);
    const SceneView view = view_of(scene);
    return find_causes(reference_of(scene, false), changed.drawn_by_student({}), &view);
  };
  const CauseReport times = with_exponents({}, {});
  ASSERT_EQ(times.claims.size(), 1u) << said(times);
  EXPECT_EQ(times.claims.front().what, "the exponents of highlights are 3 times those of the file")
      << said(times);
  const CauseReport number = with_exponents(15, 37);
  ASSERT_EQ(number.claims.size(), 1u) << said(number);
  EXPECT_EQ(number.claims.front().what,
            "the exponent of highlights is about 37, but in the file it is 15")
      << said(number);
}

TEST(Causes, AZoomIsFitted) {
  const GeneratedScene scene(1);
  const SceneView view = view_of(scene);
  GeneratedScene zoomed(1);
  RenderCamera& camera = zoomed.builder.scene.camera;
  camera.fov_y = 2 * std::atan(std::tan(camera.fov_y / 2) / 1.3);
  const CauseReport report =
      find_causes(reference_of(scene, false), zoomed.drawn_by_student({}), &view);
  ASSERT_EQ(report.claims.size(), 1u) << said(report);
  EXPECT_NE(report.claims.front().what.find("objects are 1.3 times as large"), std::string::npos)
      << said(report);
}

TEST(Causes, OneOfSeveralLightsIsLeftOut) {
  expect_named_if_changed(Cause::lights, [](RenderScene& scene) {
    if (scene.lights.size() > 1) {
      scene.lights.erase(scene.lights.begin() + 1);
    }
  });
}

TEST(Causes, ASolidAreaIsNotAcne) {
  for (const std::uint32_t seed : {1u, 2u}) {
    const GeneratedScene scene(seed);
    const SceneView view = view_of(scene);
    const Texture painted = filled([](int x, int y) {
      return x >= 40 && x < 52 && y >= 44 && y < 52;
    })(scene.drawn_by_student({}));
    const CauseReport report = find_causes(reference_of(scene, false), painted, &view);
    EXPECT_TRUE(report.claims.empty() || report.claims.front().cause != Cause::acne)
        << seed << ": " << said(report);
  }
}

TEST(Causes, OnlyOneChannel) {
  expect_named(Cause::swapped_channels, nothing,
               each_value([](const std::uint8_t* pixel, int channel) {
                 return channel == 0 ? pixel[0] : 0;
               }));
  expect_named(Cause::swapped_channels, nothing,
               each_value([](const std::uint8_t* pixel, int) { return pixel[1]; }));
}

TEST(Causes, FactorsOfTerms) {
  expect_named_if_changed(Cause::diffuse, [](RenderScene& s) { s.global.diffuse *= 0.8f; });
  expect_named_if_changed(Cause::specular, [](RenderScene& s) {
    for (RenderMaterial& m : s.materials) {
      m.specular *= 0.7f;
    }
  });
  expect_named_if_changed(Cause::ambient, [](RenderScene& s) { s.global.ambient *= 1.3f; });
}

TEST(Causes, ColorOfALight) {
  expect_named_if_changed(
      Cause::lights, [](RenderScene& s) { s.lights.front().color *= glm::vec3(1, 0.4f, 0.2f); });
}

// Half and twice are mistakes of their own only for terms.
TEST(Causes, ALightIsHalfAsBright) {
  expect_named_if_changed(
      Cause::lights, [](RenderScene& s) { s.lights.front().color *= 0.5f; },
      "is 0.50 times as bright");
}

TEST(Causes, ALitPictureWhereNormalsAreExpected) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const GeneratedScene scene(seed);
    SceneView view = view_of(scene);
    view.options.mode = Mode::normals;
    RenderOptions options = view.options;
    options.features.super_sample = false;
    const Texture reference =
        quantize(scene.builder.picture(width, height, options), Rounding::truncate);
    const CauseReport report = find_causes(reference, scene.drawn_by_student({}), &view);
    ASSERT_EQ(report.claims.size(), 1u) << said(report);
    EXPECT_EQ(report.claims.front().cause, Cause::features);
  }
}

TEST(Causes, HalfPixelShift) {
  expect_named(Cause::half_pixel_shift, {"camera-corners"});
  expect_named(Cause::half_pixel_shift, {"camera-right-edges"});
}

TEST(Causes, Ambient) {
  expect_named(Cause::ambient, {"ambient-missing"});
  expect_named(Cause::ambient, {"ambient-twice"});
  expect_named(Cause::ambient, {"ambient-faded"});
  expect_named(Cause::ambient, {"ambient-in-sum"});
}

TEST(Causes, Diffuse) {
  expect_named(Cause::diffuse, {"diffuse-missing"});
  expect_named(Cause::diffuse, {"diffuse-twice"});
}

TEST(Causes, Specular) {
  expect_named(Cause::specular, {"specular-missing"});
  expect_named(Cause::specular, {"specular-twice"});
}

TEST(Causes, Blinn) {
  expect_named(Cause::blinn, {"specular-blinn"});
}

TEST(Causes, Attenuation) {
  expect_named(Cause::attenuation, {"attenuation-none"});
  expect_named(Cause::attenuation, {"attenuation-of-highlights"});
  expect_named(Cause::attenuation, {"attenuation-of-diffuse"});
}

TEST(Causes, Normals) {
  expect_named(Cause::normals, {"normal-by-matrix"});
  expect_named(Cause::normals, {"normal-like-point"});
}

TEST(Causes, Shapes) {
  std::size_t visible = 0;
  std::size_t named = 0;
  for (const char* mistake : {"shape-square-caps", "shape-endless-cylinders", "shape-double-cones",
                              "shape-cube-normals-positive", "shape-some-missing"}) {
    for (const std::uint32_t seed : {1u, 2u}) {
      const GeneratedScene scene(seed);
      const SceneView view = view_of(scene);
      const CauseReport report =
          find_causes(reference_of(scene, false), scene.drawn_by_student({mistake}), &view);
      if (report.share_different > 0.01) {
        ++visible;
        const bool right = report.claims.size() == 1 && report.claims[0].cause == Cause::shapes;
        named += right ? 1 : 0;
        EXPECT_TRUE(right || report.claims.empty()) << mistake << seed << said(report);
      }
    }
  }
  EXPECT_GE(visible, 3u);
  EXPECT_EQ(named, visible);
}

TEST(Causes, FormsOfTheSameMistakes) {
  static const std::map<std::string, std::set<Cause>> mistakes{
      {"camera-zero-to-one", {Cause::camera}},
      {"camera-up-not-normalized", {Cause::camera}},
      {"normal-absolute", {Cause::normals}},
      {"shape-roots-doubled", {Cause::shapes}},
      {"shape-cap-normals-side", {Cause::shapes}},
      {"shape-cube-face-missing", {Cause::shapes}},
      {"light-replaces", {Cause::lights}},
      {"shadow-of-first-object", {Cause::shadows}},
      {"specular-diffuse-coefficient", {Cause::specular}},
      {"mirror-no-textures", {Cause::reflection}},
      {"mirror-coefficient-once", {Cause::reflection}},
      {"texture-integer-division", {Cause::texture}},
      {"texture-sides-as-sphere", {Cause::texture}},
      {"shape-wide-caps", {Cause::shapes}},
      {"shape-cone-normal-constant", {Cause::shapes}},
      {"light-vector-sum", {Cause::lights}},
      {"attenuation-of-eye-distance", {Cause::attenuation}},
      {"shadow-before-surface", {Cause::shadows}},
      {"shadow-inverted", {Cause::shadows, Cause::lights, Cause::diffuse}},
      {"ambient-times-texture", {Cause::ambient}},
      {"specular-eye-not-normalized", {Cause::specular}},
      {"texture-half-turned-mirrored", {Cause::texture}},
      {"mirror-maximum", {Cause::reflection}},
      {"output-column-order", {Cause::viewport}},
      {"output-one-pixel-off", {Cause::half_pixel_shift}},
      {"output-signed", {Cause::overflow}}};
  std::size_t visible = 0;
  std::size_t named = 0;
  std::string others;
  const GeneratedScene scene(2);
  const SceneView view = view_of(scene);
  const Texture reference = reference_of(scene, false);
  for (const auto& [mistake, causes] : mistakes) {
    const CauseReport report = find_causes(reference, scene.drawn_by_student({mistake}), &view);
    if (report.share_different > 0.01) {
      ++visible;
      const bool right = report.claims.size() == 1 && causes.contains(report.claims[0].cause);
      named += right ? 1 : 0;
      others += right ? "" : mistake + ": " + said(report) + "\n";
    }
  }
  EXPECT_GE(visible, 9u);
  EXPECT_GE(10 * named, 9 * visible) << others;
}

TEST(Causes, MistakesOfOneShapeOrOneTerm) {
  using namespace trace_test;
  std::string others;
  for (const auto& [mistake, cause, words] :
       {std::tuple("normal-gradient-of-cones", Cause::normals, "gradients on cones"),
        std::tuple("shape-square-caps-of-cones", Cause::shapes, "caps of cones are squares"),
        std::tuple("specular-times-diffuse", Cause::specular, "multiplied by the diffuse color"),
        std::tuple("specular-of-first-light", Cause::lights, "only the first light"),
        std::tuple("specular-of-last-light", Cause::lights, "only the last light"),
        std::tuple("diffuse-assigned", Cause::lights, "the diffuse term of each light replaces")}) {
    GeneratedScene scene(2);
    RenderMaterial plain;
    plain.ambient = plain.specular = glm::vec3(0.2f);
    plain.diffuse = {0.8f, 0.5f, 0.3f};
    plain.shininess = 10;
    scene.builder.add(
        Shape::cone,
        translate({-0.6f, 0.4f, 1.5f}) * rotate(110, {1, 0.2f, 0}) * scale({1.1f, 1.5f, 0.8f}),
        scene.builder.material(plain));
    const SceneView view = view_of(scene);
    const CauseReport report =
        find_causes(reference_of(scene, false), scene.drawn_by_student({mistake}), &view);
    const bool right = report.claims.size() == 1 && report.claims[0].cause == cause &&
                       report.claims[0].what.find(words) != std::string::npos;
    others += right ? "" : std::string(mistake) + ": " + said(report) + "\n";
  }
  EXPECT_EQ(others, "");
}

// Known mistakes come near to these, but leave more than rounding.
TEST(Causes, FunctionsOnNoList) {
  for (const auto& [mistake, cause, seed] :
       {std::tuple("attenuation-root", Cause::attenuation, 1u),
        std::tuple("attenuation-exponential", Cause::attenuation, 4u),
        std::tuple("attenuation-late", Cause::attenuation, 1u),
        std::tuple("spot-cosine-cubed", Cause::spot_falloff, 4u),
        std::tuple("spot-powers-swapped", Cause::spot_falloff, 2u),
        std::tuple("spot-from-axis", Cause::spot_falloff, 3u)}) {
    const GeneratedScene scene(seed);
    const SceneView view = view_of(scene);
    const CauseReport report =
        find_causes(reference_of(scene, false), scene.drawn_by_student({mistake}), &view);
    EXPECT_GT(report.share_different, 0.01) << mistake;
    ASSERT_EQ(report.claims.size(), 1u) << mistake << said(report);
    EXPECT_EQ(report.claims.front().cause, cause) << mistake << said(report);
  }
}

TEST(Causes, SaysWhatPixelsWithoutAKnownMistakeHaveInCommon) {
  GeneratedScene scene(2);
  const SceneView view = view_of(scene);
  const Texture reference = reference_of(scene, false);
  scene.builder.scene.global.specular = 0;
  const Texture without = reference_of(scene, false);
  scene.builder.scene.global.specular = GeneratedScene(2).builder.scene.global.specular;
  Texture test = reference;
  for (std::size_t i = 0; i < test.rgb.size(); i += 3) {
    if (test.rgb[i] > without.rgb[i] + 4) {
      test.rgb[i] = static_cast<std::uint8_t>(i * 7 % 256);
    }
  }
  const CauseReport report = find_causes(reference, test, &view);
  EXPECT_TRUE(report.claims.empty()) << said(report);
  EXPECT_NE(report.confined.find("show highlights"), std::string::npos) << report.confined;
}

// Wrong reflections, where the right ones are black.
TEST(Causes, SaysThatPixelsWithoutAKnownMistakeShowMirrors) {
  constexpr std::size_t mirror = 2;  // the material of a sphere
  GeneratedScene scene(2);
  GeneratedScene only_mirror(2);
  for (std::size_t i = 0; i < scene.builder.scene.materials.size(); ++i) {
    scene.builder.scene.materials[i].reflective = glm::vec3(i == mirror ? 0.5f : 0.0f);
    RenderMaterial one;
    one.diffuse = glm::vec3(0);
    one.ambient = glm::vec3(i == mirror ? 1.0f : 0.0f);
    only_mirror.builder.scene.materials[i] = one;
  }
  SceneView view = view_of(scene);
  view.options.max_depth = 0;
  const Texture reference =
      quantize(scene.builder.picture(width, height, view.options), Rounding::truncate);
  const Texture marked = reference_of(only_mirror, false);
  Texture test = reference;
  for (std::size_t i = 0; i < test.rgb.size(); i += 3) {
    if (marked.rgb[i] > 0 && i % 2 == 0) {
      test.rgb[i] = static_cast<std::uint8_t>(i * 7 % 256);
    }
  }
  const CauseReport report = find_causes(reference, test, &view);
  EXPECT_TRUE(report.claims.empty()) << said(report);
  EXPECT_NE(report.confined.find("show an object that reflects"), std::string::npos)
      << report.confined;
}

TEST(Causes, TexturesFilteredHalfATexelOffAreNoted) {
  const GeneratedScene scene(1);
  SceneView view = view_of(scene);
  view.options.features.texture_filter = true;
  const Texture reference =
      quantize(scene.builder.picture(width, height, view.options), Rounding::truncate);
  const CauseReport report =
      find_causes(reference, scene.drawn_by_student({"texture-filtered"}), &view);
  EXPECT_TRUE(report.claims.empty()) << said(report);
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_NE(report.notes.front().what.find("half a texel"), std::string::npos);
}

TEST(Causes, Shadows) {
  expect_named(Cause::shadows, {"shadow-none"});
  expect_named(Cause::shadows, {"shadow-directional-only"});
  expect_named(Cause::shadows, {"shadow-resets"});
}

TEST(Causes, Acne) {
  expect_named(Cause::acne, {"shadow-acne", "mirror-acne"});
}

// A face that lacks light, beside edges of textures that other samples change, is none.
TEST(Causes, SamplesBesideDarkFacesAreNotAcne) {
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    const GeneratedScene scene(seed);
    const SceneView view = view_of(scene);
    const CauseReport report =
        find_causes(reference_of(scene, false),
                    means_of_four(scene.drawn_by_student({"shape-cube-normals-positive"}, 2 * width,
                                                         2 * height)),
                    &view);
    EXPECT_TRUE(std::none_of(report.claims.begin(), report.claims.end(),
                             [](const Claim& c) { return c.cause == Cause::acne; }))
        << seed << ": " << said(report);
  }
}

// Rounding may be the same all over a face, which then shadows itself as a whole.
TEST(Causes, AcneOfAWholeFace) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    GeneratedScene scene(seed);
    for (RenderMaterial& m : scene.builder.scene.materials) {
      m.reflective = glm::vec3(0);
    }
    GeneratedScene unlit = scene;
    unlit.builder.scene.lights.clear();
    GeneratedScene without_wall = unlit;
    std::vector<RenderPrimitive>& shapes = without_wall.builder.scene.groups[0].primitives;
    shapes.erase(shapes.begin() + 1);
    const Texture dark = unlit.drawn_by_student({});
    const Texture other = without_wall.drawn_by_student({});
    Texture picture = scene.drawn_by_student({"shadow-acne"});
    for (int i = 0; i < width * height; ++i) {
      const std::uint8_t* wall = dark.texel(i % width, i / width);
      if (!std::equal(wall, wall + 3, other.texel(i % width, i / width))) {
        std::copy_n(wall, 3, &picture.rgb[std::size_t{3} * i]);
      }
    }
    const SceneView view = view_of(scene);
    const CauseReport report = find_causes(reference_of(scene, false), picture, &view);
    EXPECT_TRUE(report.claims.size() == 1 && report.claims.front().cause == Cause::acne)
        << seed << ": " << said(report);
  }
}

TEST(Causes, TexturesUpsideDown) {
  expect_named(Cause::texture, {"texture-flip-v"});
}

TEST(Causes, TexturesNotRepeated) {
  expect_named(Cause::texture, {"texture-not-repeated"});
}

TEST(Causes, ValuesAboveFullBrightness) {
  std::uint32_t named = 0;
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    GeneratedScene scene(seed);
    for (RenderLight& light : scene.builder.scene.lights) {
      light.color *= 5.0f;
    }
    const SceneView view = view_of(scene);
    const CauseReport report = find_causes(reference_of(scene, false),
                                           scene.drawn_by_student({"light-not-normalized"}), &view);
    named += report.claims.size() == 1 && report.claims.front().cause == Cause::lights ? 1 : 0;
  }
  EXPECT_GE(named, 4u);
}

TEST(Causes, RecursionDepth) {
  expect_named(Cause::recursion_depth, {"mirror-missing"});
  expect_named(Cause::recursion_depth, {"mirror-depth-one"});
}

TEST(Causes, SpotFalloff) {
  for (const char* spot : {"spot-linear", "spot-no-penumbra", "spot-as-point", "spot-outside"}) {
    expect_named(Cause::spot_falloff, {spot});
  }
}

TEST(Causes, MistakesHaveDifferentWords) {
  GeneratedScene scene(1);
  scene.builder.scene.camera.position = {0, 3, 4};  // as far from the origin as rays may be apart
  const Scene written = scene.written();
  SceneView view = view_of(scene);
  view.written = &written;
  std::set<std::string> words;
  for (const Hypothesis& h : drawing_hypotheses(view, width, height)) {
    EXPECT_TRUE(words.insert(h.what).second) << h.what;
  }
}

TEST(Causes, TwoAtOnce) {
  const GeneratedScene scene(3);
  const SceneView view = view_of(scene);
  const Texture reference = reference_of(scene, false);
  Texture picture = scene.drawn_by_student({"shadow-none", "ambient-twice"});
  const auto causes = [](const CauseReport& report) {
    std::set<Cause> found;
    for (const Claim& claim : report.claims) {
      found.insert(claim.cause);
    }
    return found;
  };
  const CauseReport two = find_causes(reference, picture, &view);
  EXPECT_EQ(causes(two), (std::set{Cause::shadows, Cause::ambient})) << said(two);
  picture = turned(false, true)(scene.drawn_by_student({"shadow-none"}));
  const CauseReport turned_too = find_causes(reference, picture, &view);
  EXPECT_EQ(causes(turned_too), (std::set{Cause::shadows, Cause::vertical_flip}))
      << said(turned_too);
  picture = turned(false, true)(scene.drawn_by_student({"shadow-none", "ambient-twice"}));
  const CauseReport three = find_causes(reference, picture, &view);
  EXPECT_EQ(causes(three), (std::set{Cause::shadows, Cause::ambient, Cause::vertical_flip}))
      << said(three);
}

// The causes of all claims, and of the mistakes that give the same picture.
std::set<Cause> all_named(const CauseReport& report) {
  std::set<Cause> found;
  for (const std::vector<Claim>* list : {&report.claims, &report.rivals}) {
    for (const Claim& claim : *list) {
      found.insert(claim.cause);
    }
  }
  return found;
}

using ReportTest = std::function<bool(const CauseReport&)>;

// The pictures that the student's tracer draws of some scenes, changed: at least `least` of the
// reports must be right.
void expect_right(int least, const std::vector<Mistakes>& mistakes,
                  const std::vector<std::uint32_t>& seeds, const Change& change,
                  const ReportTest& is_right) {
  int named = 0;
  std::string others;
  for (const Mistakes& some : mistakes) {
    for (const std::uint32_t seed : seeds) {
      const GeneratedScene scene(seed);
      const SceneView view = view_of(scene);
      const CauseReport report =
          find_causes(reference_of(scene, false), change(scene.drawn_by_student(some)), &view);
      const bool right = is_right(report);
      named += right ? 1 : 0;
      others += right ? ""
                      : ::testing::PrintToString(some) + " " + std::to_string(seed) + ": " +
                            said(report) + "\n";
    }
  }
  EXPECT_GE(named, least) << others;
}

Texture unchanged(const Texture& picture) {
  return picture;
}

TEST(Causes, ACurveTogetherWithAnotherMistake) {
  const Change lifted = each_value([](const std::uint8_t* pixel, int channel) {
    return static_cast<int>(std::lround(0.8 * pixel[channel] + 26));
  });
  expect_right(2, {{"camera-full-angle"}}, {1, 2}, lifted, [](const CauseReport& report) {
    return report.claims.size() == 2 &&
           all_named(report) == std::set{Cause::camera, Cause::brightness};
  });
}

TEST(Causes, AMovedCameraInATurnedPicture) {
  expect_right(
      2, {{"camera-full-angle"}}, {1, 2}, turned(false, true), [](const CauseReport& report) {
        return report.claims.size() == 2 && all_named(report).contains(Cause::vertical_flip) &&
               all_named(report).contains(Cause::camera);
      });
}

TEST(Causes, ASubpixelShiftBesideAnotherMistake) {
  std::vector<Mistakes> mistakes;
  for (const char* mistake : {"normal-not-normalized", "light-not-normalized", "shadow-none",
                              "specular-missing", "diffuse-twice"}) {
    mistakes.push_back({mistake, "camera-corners"});
  }
  expect_right(4, mistakes, {1}, unchanged, [](const CauseReport& report) {
    return report.claims.size() == 2 && all_named(report).contains(Cause::half_pixel_shift);
  });
}

TEST(Causes, AWholePixelBesideAnotherMistake) {
  expect_right(6,
               {{"ambient-missing", "output-one-pixel-off"},
                {"specular-missing", "output-one-pixel-off"},
                {"shadow-none", "output-one-pixel-off"}},
               {1, 2}, unchanged, [](const CauseReport& report) {
                 return report.claims.size() == 2 &&
                        all_named(report).contains(Cause::half_pixel_shift);
               });
}

TEST(Causes, ABackgroundInATurnedPicture) {
  expect_right(2, {{"output-background"}}, {1, 2}, turned(false, true),
               [](const CauseReport& report) {
                 return all_named(report) == std::set{Cause::vertical_flip, Cause::background};
               });
}

TEST(Causes, AFactorOfThePictureBesideAnotherMistake) {
  for (const double factor : {0.7, 1.5}) {
    const Change darker = each_value([factor](const std::uint8_t* pixel, int channel) {
      return static_cast<int>(std::min(255.0, factor * pixel[channel]));
    });
    expect_right(
        3, {{"shadow-none"}, {"normal-of-object"}, {"mirror-missing"}, {"texture-swapped"}},
        {factor < 1 ? 1u : 2u}, darker, [factor](const CauseReport& report) {
          const std::string number = factor < 1 ? "0.70" : "1.50";
          return report.claims.size() == 2 && all_named(report).contains(Cause::brightness) &&
                 said(report).find("is " + number + " times") != std::string::npos;
        });
  }
}

TEST(Causes, BlurBesideAnotherMistake) {
  expect_right(2, {{"shadow-none", "output-blurred"}, {"ambient-twice", "output-blurred"}}, {1},
               unchanged, [](const CauseReport& report) {
                 return report.claims.size() == 2 && all_named(report).contains(Cause::samples);
               });
}

TEST(Causes, MissedSamplesBesideAnotherMistake) {
  expect_right(
      2, {{"specular-missing", "output-misses-black"}, {"shadow-none", "output-misses-black"}}, {1},
      unchanged, [](const CauseReport& report) {
        return report.claims.size() == 2 && all_named(report).contains(Cause::samples);
      });
}

TEST(Causes, AcneBesideAnotherMistake) {
  expect_right(3,
               {{"camera-aspect-ignored", "shadow-acne"},
                {"texture-swapped", "shadow-acne"},
                {"texture-swapped", "mirror-acne"}},
               {3}, unchanged, [](const CauseReport& report) {
                 return report.claims.size() == 2 && all_named(report).contains(Cause::acne);
               });
}

TEST(Causes, AMistakeInPicturesStoredByColumns) {
  const Change by_columns = [](const Texture& picture) {
    Texture changed = picture;
    for (int i = 0; i < width * height; ++i) {
      std::copy_n(picture.texel(i / height, i % height), 3, &changed.rgb[std::size_t{3} * i]);
    }
    return changed;
  };
  expect_right(5, {{"camera-full-angle"}, {"shadow-none"}, {"texture-swapped"}}, {1, 3}, by_columns,
               [](const CauseReport& report) {
                 return report.claims.size() == 2 && report.claims.front().cause == Cause::viewport;
               });
}

TEST(Causes, AnotherFunctionBesideAnotherMistake) {
  expect_right(2,
               {{"attenuation-exponential", "texture-swapped"},
                {"attenuation-exponential", "camera-full-angle"}},
               {1}, unchanged, [](const CauseReport& report) {
                 return report.claims.size() == 2 && all_named(report).contains(Cause::attenuation);
               });
}

TEST(Causes, AddedSamplesBesideAnotherMistake) {
  expect_right(2,
               {{"output-average-side", "shadow-none"}, {"output-average-side", "mirror-missing"}},
               {1}, unchanged, [](const CauseReport& report) {
                 return report.claims.size() == 2 && all_named(report).contains(Cause::brightness);
               });
}

TEST(Causes, ASmallMistakeBesideALargeOne) {
  expect_right(2, {{"output-gamma", "texture-missing-on-caps"}}, {1, 2}, unchanged,
               [](const CauseReport& report) {
                 return report.claims.size() == 2 && all_named(report).contains(Cause::texture);
               });
}

// Each edit changes one value of the file. The claim names it, and no claim names another.
// Rounding decides whether a light in the plane of a face lights it.
TEST(Causes, LightsInThePlaneOfAFaceAreNoEvidenceOfAnEdit) {
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    GeneratedScene scene(seed);
    const RenderPrimitive& wall = scene.builder.scene.groups[0].primitives[1];
    for (RenderLight& light : scene.builder.scene.lights) {
      if (light.type == LightType::point) {
        light.position = glm::vec3(wall.group_from_object.linear * glm::dvec3(3, 1, 0.5) +
                                   wall.group_from_object.offset);
      }
    }
    const SceneView view = view_of(scene);
    const CauseReport report = find_causes(reference_of(scene, false),
                                           scene.drawn_by_student({"diffuse-no-cosine"}), &view);
    EXPECT_FALSE(all_named(report).contains(Cause::scene_edited)) << seed << ": " << said(report);
  }
}

// Beside a steep gradient, as in a highlight, any pixel has the color of some neighbor.
TEST(Causes, ASquareThatDiffersIsNoDetail) {
  Texture reference{48, 48, {}};
  for (int i = 0; i < 48 * 48; ++i) {
    const int x = i % 48;
    reference.rgb.insert(reference.rgb.end(), 3, static_cast<std::uint8_t>(x < 16 ? 15 * x : 240));
  }
  Texture picture = reference;
  EXPECT_TRUE(find_causes(reference, picture).only_details);
  for (int y = 20; y < 26; ++y) {
    for (int x = 5; x < 11; ++x) {
      std::fill_n(&picture.rgb[3 * std::size_t(48 * y + x)], 3, std::uint8_t(15 * x + 10));
    }
  }
  EXPECT_FALSE(find_causes(reference, picture).only_details);
}

// A mistake that explains all that differs, but would also change a part of what is right.
TEST(Causes, WhatBreaksRightPixelsIsNotNamed) {
  constexpr double share_right = 0.25;  // of the pixels that it changes
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    const GeneratedScene scene(seed);
    const SceneView view = view_of(scene);
    const Texture right = scene.drawn_by_student({});
    Texture picture = scene.drawn_by_student({"specular-missing"});
    std::vector<int> changed;  // from left to right
    for (int x = 0; x < width; ++x) {
      for (int y = 0; y < height; ++y) {
        if (!std::equal(right.texel(x, y), right.texel(x, y) + 3, picture.texel(x, y))) {
          changed.push_back(width * y + x);
        }
      }
    }
    changed.resize(std::size_t(share_right * double(changed.size())));
    for (const int i : changed) {
      std::copy_n(&right.rgb[3 * std::size_t(i)], 3, &picture.rgb[3 * std::size_t(i)]);
    }
    const CauseReport report =
        find_causes(reference_of(scene, false), picture, &view, {}, LookFor::single_mistakes);
    EXPECT_FALSE(all_named(report).contains(Cause::specular)) << seed << ": " << said(report);
    EXPECT_TRUE(report.partial.empty()) << seed;
  }
}

TEST(Causes, OneEditedValueOfTheScene) {
  struct Edit {
    const char* name;
    std::function<void(Scene&)> change;
    const char* old_name = "";  ///< another name for the same picture
  };
  const auto object = [](Scene& s, std::size_t i) -> Node& {
    return s.nodes[s.nodes[s.root].children[i]];
  };
  const auto move = [&](Scene& s, std::size_t i, const glm::vec3& by) {
    Transform& t = object(s, i).transforms.front();
    std::get<Translate>(t.map).by += by;
  };
  const std::vector<Edit> edits{
      {"color of light 2 (spot)", [](Scene& s) { s.nodes[s.root].lights[1].color.x *= 0.3f; },
       "color of light 2"},
      {"position of light 1 (point)",
       [](Scene& s) { s.nodes[s.root].lights[0].position += glm::vec3(0.9f, -0.5f, 0.3f); }},
      {"direction of light 3 (directional)",
       [](Scene& s) { s.nodes[s.root].lights[2].direction += glm::vec3(0.6f, 0, 0.3f); }},
      {"the diffuse of the sphere",
       [&](Scene& s) {
         object(s, 2).primitives[0].material.diffuse = {0.1f, 0.9f, 0.2f};
       }},
      {"the blend of the cylinder is 1 instead",
       [&](Scene& s) { object(s, 3).primitives[0].material.blend = 1; }},
      {"the translation of an object",
       [&](Scene& s) {
         move(s, 4, {0.15f, 0.1f, 0.1f});
       }},
      {"the pos of the camera", [](Scene& s) { s.camera->position += glm::vec3(0.2f, 0.15f, 0); }},
      {"the look of the camera", [](Scene& s) { s.camera->look += glm::vec3(0.05f, 0.03f, 0); }}};
  std::uint32_t seed = 0;
  for (const Edit& edit : edits) {
    seed = seed % 2 + 1;
    const GeneratedScene scene(seed);
    Scene written = scene.written();
    for (Node& node : written.nodes) {
      // As people write it.
      if (!node.transforms.empty()) {
        node.transforms.insert(node.transforms.begin(), {Translate(), {}});
      }
    }
    written.camera->location = {7, 1};
    const RenderScene ready = prepare(written, Limits()).scene;
    RenderOptions options = view_of(scene).options;
    const SceneView view{&ready, &scene.builder.assets, options, &written, {}};
    const auto drawn = [&](const Scene& by_student) {
      student::Job job;
      job.width = width;
      job.height = height;
      const std::string name = "ramp.png";
      return student::draw(by_student, scene.builder.assets, {&name, 1}, job);
    };
    Scene changed = written;
    edit.change(changed);
    const CauseReport report = find_causes(drawn(written), drawn(changed), &view);
    EXPECT_EQ(report.claims.size(), 1u) << edit.name << ": " << said(report);
    for (const Claim& claim : report.claims) {
      EXPECT_TRUE(claim.what.find(edit.name) != std::string::npos ||
                  (*edit.old_name != 0 && claim.what.find(edit.old_name) != std::string::npos))
          << edit.name << ": " << said(report);
    }
  }
}

TEST(Causes, FindsTheViewOfTheReference) {
  const GeneratedScene scene(4);
  const SceneView right = view_of(scene);
  SceneView plain = right;
  plain.options.features.texture = false;
  plain.options.features.shadows = false;
  const std::vector<SceneView> views{plain, right};
  EXPECT_EQ(alike(reference_of(scene, true), views).front().index, 1u);
}

TEST(Causes, NamesNoSceneMistakesForAnotherScene) {
  const GeneratedScene scene(1);
  const GeneratedScene other(2);
  const SceneView view = view_of(other);
  const CauseReport report =
      find_causes(reference_of(scene, false), scene.drawn_by_student({"shadow-none"}), &view);
  EXPECT_GT(report.share_scene_unlike, 0.1);
  EXPECT_TRUE(report.claims.empty()) << said(report);
}

TEST(Causes, FineTexturesInAReferenceWithSeveralSamples) {
  GeneratedScene scene(1);
  for (RenderMaterial& m : scene.builder.scene.materials) {
    m.texture.repeat_u *= 30;
    m.texture.repeat_v *= 30;
  }
  const SceneView view = view_of(scene);
  const CauseReport report =
      find_causes(reference_of(scene, true), scene.drawn_by_student({"shadow-none"}), &view);
  EXPECT_LT(report.share_scene_unlike, 0.05);
  ASSERT_FALSE(report.claims.empty());
  EXPECT_EQ(report.claims.front().cause, Cause::shadows) << said(report);
}

TEST(Causes, StopsOnRequest) {
  const GeneratedScene scene(1);
  const SceneView view = view_of(scene);
  const Texture picture = scene.drawn_by_student({"shadow-none"});
  int asked = 0;
  find_causes(reference_of(scene, false), picture, &view, [&](double) { return ++asked < 3; });
  EXPECT_EQ(asked, 3);
}

// Both lights are alike in world space; the one in the template is drawn last.
TEST(Causes, KnowFromWhichWrittenLightALightComes) {
  Scene scene;
  const auto add_light = [&](NodeId node, float length) {
    Light light;
    light.type = LightType::directional;
    light.direction = {0, -length, 0};
    scene.nodes[node].lights.push_back(light);
  };
  add_light(add_template(scene, "lamp"), 3);
  scene.nodes[add_child(scene, scene.root)].instance_of = "lamp";
  add_light(add_child(scene, scene.root), 1);
  const Prepared ready = prepare(scene, Limits());
  const Assets assets;
  SceneView view{&ready.scene, &assets, default_options(Profile::course), &scene, {}};
  view.sources = &ready.sources;
  Trial trial{ready.scene, view.options, {}};
  for (const Hypothesis& hypothesis : drawing_hypotheses(view, width, height)) {
    if (hypothesis.what == "directions of directional lights are not normalized") {
      hypothesis.draw(trial);
    }
  }
  EXPECT_THAT(trial.mistakes.light_lengths, ::testing::ElementsAre(1, 3));
}

}  // namespace
}  // namespace scenefile::grade_test
