#include "scenefile/noise/judge_path.h"

#include "path/full_room.h"
#include "scenefile/noise/block_means.h"
#include "scenefile/noise/linearize.h"
#include "scenefile/path/path_kernel.h"
#include "scenefile/path/render_path.h"
#include "scenefile/path/tone.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace scenefile {

namespace {

using namespace path_test;

// A room of diffuse walls with a lamp and a box.
Room plain_room() {
  Room room;
  Model model;
  model.box({-1, 0, -1}, {1, 2, 1}, true, model.material(diffuse({0.7f, 0.6f, 0.5f})));
  model.quad({-0.3f, 1.98f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f},
             model.material(diffuse(glm::vec3(0), {12, 10, 8})));
  model.box({-0.6f, 0, -0.6f}, {0.1f, 0.9f, 0}, false, model.material(diffuse({0.3f, 0.5f, 0.6f})));
  room.add(model);
  room.look({0, 1, 0.95}, {0, 1.1, 0}, 95);
  return room;
}

// Of two lamps, with a glossy box.
Room lamp_room() {
  Room room;
  Model model;
  FaceMaterial shiny = diffuse({0.2f, 0.1f, 0.1f});
  shiny.specular = glm::vec3(0.7f);
  shiny.shininess = 8;
  model.box({-1, 0, -1}, {1, 2, 1}, true, model.material(diffuse({0.5f, 0.5f, 0.6f})));
  model.box({-0.5f, 0.02f, -0.9f}, {0.5f, 1.4f, -0.4f}, false, model.material(shiny));
  model.quad({-0.7f, 1.98f, -0.6f}, {0.6f, 0, 0}, {0, 0, 0.6f},
             model.material(diffuse(glm::vec3(0), {12, 8, 4})));
  model.quad({0.4f, 1.98f, 0.2f}, {0.3f, 0, 0}, {0, 0, 0.4f},
             model.material(diffuse(glm::vec3(0), {6, 10, 20})));
  room.add(model);
  room.look({0, 1, 0.95}, {0, 1.1, 0}, 95);
  return room;
}

// Of a mirror and glass.
Room specular_room() {
  Room room = plain_room();
  Model model;
  FaceMaterial shiny = mirror({0.9f, 0.9f, 0.9f});
  shiny.diffuse = glm::vec3(0.5f);
  model.quad({0.9f, 0.2f, -0.9f}, {0, 0, 1.2f}, {0, 1.6f, 0}, model.material(shiny));
  room.add(model);
  Model ball;
  ball.box({-0.1f, 1.2f, -0.4f}, {0.6f, 1.5f, 0.3f}, false, ball.material(glass(1.5f)));
  room.add(ball);
  return room;
}

struct Judge : ::testing::Test {
  Room room = plain_room();
  RenderOptions options = path_options(64, 64, 32);
  TraceScene traced{room.scene, room.assets};
  PathTruth truth = drawn_once(*this);

  static const PathTruth& drawn_once(const Judge& test) {
    static const PathTruth truth = [&] {
      PathTruth drawn;
      RenderOptions other = test.options;
      other.seed = 99;
      EXPECT_EQ(draw_truth(test.traced, test.room.scene, other, 0, 24, {}, drawn),
                RenderStatus::complete);
      return drawn;
    }();
    return truth;
  }

  DecodedPicture drawn() const {
    DecodedPicture picture;
    picture.linear = render_path(room.scene, room.assets, options, {.traced = &traced}).image;
    picture.texture = quantize(picture.linear, Rounding::nearest);
    return picture;
  }
  // By block the picture of the change itself.
  DecodedPicture with(Change change, const DecodedPicture& picture) const {
    return with(truth.changes[static_cast<std::size_t>(change)].sampled, picture);
  }
  DecodedPicture with(const BlockColors& sampled, DecodedPicture picture) const {
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const std::size_t block = block_of(truth, std::size_t(64 * y + x));
        Color right(0);
        for (const auto& [kind, light] : truth.kinds) {
          right += kind.hit ? Color(0) : light[block];
        }
        for (int c = 0; c < 3; ++c) {
          picture.linear.pixel(x, y)[c] *= static_cast<float>(sampled[block][c] / right[c]);
        }
      }
    }
    return picture;
  }
  // A picture of `other` instead, whose truth is drawn.
  void move_to(const Room& other, std::uint32_t samples) {
    room = other;
    traced = TraceScene(room.scene, room.assets);
    truth = {};
    RenderOptions of_truth = options;
    of_truth.seed = 99;
    ASSERT_EQ(draw_truth(traced, room.scene, of_truth, 0, samples, {}, truth),
              RenderStatus::complete);
  }
  // The mean of light(path, its light) over `samples` paths of each pixel.
  template <typename Light>
  DecodedPicture by_paths(std::uint32_t samples, const Light& light) {
    options.mis = false;
    return by_paths(PathScene(traced, room.scene, options), samples, light);
  }
  template <typename Light>
  static DecodedPicture by_paths(const PathScene& paths, std::uint32_t samples,
                                 const Light& light) {
    DecodedPicture picture;
    picture.linear = Image(64, 64);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        Color sum(0);
        for (std::uint32_t i = 0; i < samples; ++i) {
          RayCounts counts;
          PathRecord path;
          const Color whole = path_light(paths, x, y, i, counts, &path);
          sum += light(path, whole) / double(samples);
        }
        for (int c = 0; c < 3; ++c) {
          picture.linear.pixel(x, y)[c] = static_cast<float>(sum[c]);
        }
      }
    }
    picture.texture = quantize(picture.linear, Rounding::nearest);
    return picture;
  }
  // Values of 8 bits, by the course's curve, or the power 1 / `gamma` of clamped values.
  static DecodedPicture shown(DecodedPicture picture, double gamma = 0) {
    for (float& value : picture.linear.rgb) {
      value = gamma > 0 ? static_cast<float>(std::pow(std::min(value, 1.0f), 1 / gamma)) : value;
    }
    const Image image = gamma > 0 ? picture.linear : tone_mapped(picture.linear, Tone::course, 0);
    picture.texture = quantize(image, Rounding::nearest);
    picture.linear = Image();
    return picture;
  }
  static std::string names(const std::vector<PathClaim>& claims) {
    std::string text;
    for (const PathClaim& claim : claims) {
      text += claim.name + " ";
    }
    return text;
  }
};

TEST_F(Judge, KindsAddUpToThePicture) {
  Color kinds(0);
  Color pixels(0);
  for (const auto& [kind, light] : truth.kinds) {
    for (const Color& block : light) {
      kinds += block * 64.0;
    }
  }
  for (const Color& pixel : truth.pixels) {
    pixels += pixel;
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(kinds[c], pixels[c], 1e-9 * pixels[c]);
  }
}

TEST_F(Judge, RightPicturesGetNoClaim) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    options.seed = seed;
    const PathVerdict verdict = judge_path(truth, drawn());
    EXPECT_TRUE(verdict.right) << seed;
    EXPECT_EQ(names(verdict.causes) + names(verdict.partial) + names(verdict.conventions), "");
    EXPECT_LT(verdict.largest, verdict.critical);
    EXPECT_NEAR(verdict.places.front().factor, 1, 5 * verdict.places.front().error);
  }
}

TEST_F(Judge, NamesWhatPathsDoNotHave) {
  options.max_depth = 1;
  const PathVerdict verdict = judge_path(truth, drawn());
  EXPECT_FALSE(verdict.right);
  EXPECT_EQ(names(verdict.causes), "depth ");
  EXPECT_NEAR(verdict.energy_mine[1] / verdict.energy_truth[1], 0, 0.05);
}

TEST_F(Judge, NamesFactorsOfDirectLightByTheScene) {
  DecodedPicture picture = drawn();
  DecodedPicture halved = picture;
  for (std::size_t i = 0; i < picture.linear.rgb.size(); i += 3) {
    // All but the lamp.
    for (std::size_t c = i; c < i + 3 && picture.linear.rgb[i] < 11; ++c) {
      halved.linear.rgb[c] = picture.linear.rgb[c] / 2;
    }
  }
  EXPECT_THAT(names(judge_path(truth, halved).causes), ::testing::HasSubstr("lamp-sampling"));
  for (float& value : picture.linear.rgb) {
    value *= 2;
  }
  EXPECT_EQ(names(judge_path(truth, picture).causes), "brightness ");
}

TEST_F(Judge, NamesAMistakeOfTheDistance) {
  EXPECT_EQ(names(judge_path(truth, with(Change::falloff_distance, drawn())).causes), "distance ");
}

TEST_F(Judge, NamesPathsThatLoseColor) {
  for (const Change change : {Change::gray_by_luminance, Change::gray_by_mean}) {
    EXPECT_EQ(names(judge_path(truth, with(change, drawn())).causes), "gray-throughput ");
  }
}

TEST_F(Judge, NamesThroughputsThatAreNoProducts) {
  PathTruth with_throughputs = truth;
  ASSERT_EQ(draw_throughputs(traced, room.scene, options, 2, {}, with_throughputs),
            RenderStatus::complete);
  constexpr double p = 0.7;  // of going on
  options.continuation = p;
  options.mis = false;
  const PathScene paths(traced, room.scene, options);
  for (const bool added : {false, true}) {
    DecodedPicture picture = drawn();
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        RayCounts counts;
        PathRecord path;
        Color light(0);
        for (std::uint32_t i = 0; i < 32; ++i) {
          path_light(paths, x, y, i, counts, &path);
          Color throughput(1);
          for (const PathVertex& v : path.vertices) {
            light += throughput * (v.emission + v.light) / 32.0;
            throughput = v.next.weight / p + (added ? throughput : Color(0));
          }
        }
        for (int c = 0; c < 3; ++c) {
          picture.linear.pixel(x, y)[c] = static_cast<float>(light[c]);
        }
      }
    }
    EXPECT_THAT(names(judge_path(with_throughputs, picture).causes),
                ::testing::HasSubstr(added ? "throughput-added " : "throughput-replaced "));
  }
}

TEST_F(Judge, NamesPointsBesideLamps) {
  PathTruth with_variants = truth;
  ASSERT_EQ(draw_variants(all_variants, room.scene, room.assets, options, 2, {}, with_variants),
            RenderStatus::complete);
  PathScene paths(traced, room.scene, options);
  paths.lamps.cover_parallelograms();
  DecodedPicture picture = drawn();
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      RayCounts counts;
      Color sum(0);
      for (std::uint32_t i = 0; i < 32; ++i) {
        sum += path_light(paths, x, y, i, counts);
      }
      for (int c = 0; c < 3; ++c) {
        picture.linear.pixel(x, y)[c] = static_cast<float>(sum[c] / 32);
      }
    }
  }
  EXPECT_EQ(names(judge_path(with_variants, picture).causes), "lamp-points ");
}

TEST_F(Judge, NamesLightThatWasNotAskedFor) {
  options.direct_only = true;
  PathTruth direct;
  ASSERT_EQ(draw_truth(traced, room.scene, options, 0, 24, {}, direct), RenderStatus::complete);
  ASSERT_EQ(draw_variants(all_variants, room.scene, room.assets, options, 2, {}, direct),
            RenderStatus::complete);
  options.seed = 5;
  EXPECT_EQ(names(judge_path(direct, drawn()).causes), "");
  options.direct_only = false;
  EXPECT_EQ(names(judge_path(direct, drawn()).causes), "depth ");
}

TEST_F(Judge, NamesAnotherAngleOfView) {
  room.look({0, 1, 0.95}, {0, 1.1, 0}, 104);
  const PathVerdict verdict = judge_path(truth, drawn());
  ASSERT_EQ(names(verdict.causes), "view-angle ");
  EXPECT_THAT(verdict.causes[0].what, ::testing::ContainsRegex("10[345].* degrees, not of 95"));
}

TEST_F(Judge, NamesTwoMistakes) {
  options.max_depth = 1;
  DecodedPicture picture = drawn();
  const PathVerdict first = judge_path(truth, with(Change::falloff_distance, picture));
  ASSERT_EQ(first.partial.size(), 1);
  EXPECT_THAT(first.partial[0].what, ::testing::HasSubstr("indirect light is missing"));
  EXPECT_THAT(first.partial[0].what, ::testing::HasSubstr("distance"));
  for (float& value : picture.linear.rgb) {
    value *= value < 8 ? 0.5f : 1;  // all but the lamp
  }
  const PathVerdict second = judge_path(truth, picture);
  ASSERT_EQ(second.partial.size(), 1);
  EXPECT_THAT(second.partial[0].what, ::testing::HasSubstr("indirect light is missing"));
  EXPECT_THAT(second.partial[0].what, ::testing::ContainsRegex("factor 0.(49|50)"));
}

// Two mistakes and a factor explain much: only what needs no factor is named.
TEST_F(Judge, NamesOneOfThreeMistakes) {
  options.max_depth = 1;
  DecodedPicture picture = with(Change::lamp_cosine, drawn());
  for (float& value : picture.linear.rgb) {
    value *= value < 8 ? 0.7f : 1;  // all but the lamp
  }
  const PathVerdict verdict = judge_path(truth, picture);
  ASSERT_EQ(verdict.partial.size(), 1);
  EXPECT_THAT(verdict.partial[0].what, ::testing::HasSubstr("indirect light is missing"));
  EXPECT_THAT(verdict.partial[0].what, ::testing::HasSubstr("something else is wrong"));
}

TEST_F(Judge, NamesColorsOfTheLight) {
  EXPECT_THAT(names(judge_path(truth, with(Change::lamp_emission, drawn())).causes),
              ::testing::HasSubstr("lamp-color "));
  DecodedPicture picture = drawn();
  for (std::size_t i = 0; i < picture.linear.rgb.size(); i += 3) {
    picture.linear.rgb[i] *= picture.linear.rgb[i] < 11 ? 0.4f : 1;  // not of the lamps
  }
  EXPECT_EQ(names(judge_path(truth, picture).partial), "lamp-color ");
}

TEST_F(Judge, FindsValuesThatAreCutOff) {
  DecodedPicture picture = drawn();
  for (float& value : picture.linear.rgb) {
    value = std::min(value, 2.0f);
  }
  EXPECT_EQ(names(judge_path(truth, picture).causes), "clamped ");
}

TEST_F(Judge, FindsGammaInLinearFiles) {
  for (const double gamma : {2.2, 4.4}) {
    DecodedPicture picture = drawn();
    for (float& value : picture.linear.rgb) {
      value = static_cast<float>(std::pow(std::min(value, 1.0f), 1 / gamma));
    }
    EXPECT_EQ(names(judge_path(truth, picture).causes), "gamma ") << gamma;
  }
}

// Each pixel of a patch has the same error.
TEST_F(Judge, NamesNoiseThatPixelsShare) {
  options.width = options.height = 96;
  options.samples = 64;
  PathTruth larger;
  ASSERT_EQ(draw_truth(traced, room.scene, options, 0, 64, {}, larger), RenderStatus::complete);
  options.seed = 5;
  DecodedPicture picture = drawn();
  EXPECT_EQ(names(judge_path(larger, picture).causes), "");
  std::mt19937 random(3);
  std::vector<float> factors(64);
  std::generate(factors.begin(), factors.end(),
                [&] { return std::normal_distribution<float>(1, 0.08f)(random); });
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 96; ++x) {
      for (int c = 0; c < 3; ++c) {
        picture.linear.pixel(x, y)[c] *= factors[y / 12 * 8 + x / 12];
      }
    }
  }
  EXPECT_EQ(names(judge_path(larger, picture).causes), "same-numbers ");
}

TEST_F(Judge, SaysWhenItIsTooNoisy) {
  options.samples = 1;
  options.light_samples = 0;
  const PathVerdict verdict = judge_path(truth, drawn());
  EXPECT_TRUE(verdict.too_noisy);
  EXPECT_GT(verdict.more_samples, 1);
  EXPECT_EQ(names(verdict.causes), "");
}

// Without any noise, a few blocks would not tell, either.
TEST_F(Judge, SaysWhenMoreSamplesDoNotHelp) {
  options.width = options.height = 24;
  PathTruth small;
  ASSERT_EQ(draw_truth(traced, room.scene, options, 0, 256, {}, small), RenderStatus::complete);
  options.samples = 256;
  options.seed = 5;
  const PathVerdict verdict = judge_path(small, drawn());
  EXPECT_TRUE(verdict.too_noisy);
  EXPECT_TRUE(std::isinf(verdict.more_samples));
  EXPECT_FALSE(verdict.truth_too_noisy);
}

// Many mistakes explain few blocks. What is done with the file has fewer alternatives.
TEST_F(Judge, NamesNoMistakeInLightByFewBlocks) {
  options.width = 48;
  options.height = 24;
  PathTruth small;
  ASSERT_EQ(draw_truth(traced, room.scene, options, 0, 256, {}, small), RenderStatus::complete);
  options.samples = 256;
  options.seed = 5;
  DecodedPicture picture = drawn();
  for (float& value : picture.linear.rgb) {
    value = std::pow(value, 1 / 2.2f);
  }
  EXPECT_EQ(names(judge_path(small, picture).causes), "gamma ");
  options.max_depth = 1;
  const PathVerdict direct = judge_path(small, drawn());
  EXPECT_FALSE(direct.right);
  EXPECT_EQ(names(direct.causes), "");
}

TEST_F(Judge, ReadsToneMappedPictures) {
  const PathVerdict verdict = judge_path(truth, shown(drawn()));
  EXPECT_TRUE(verdict.right);
  EXPECT_EQ(verdict.curve, "the tone curve of the course");
}

TEST_F(Judge, ReadsToneMappedPicturesThatAreWrong) {
  const PathVerdict distance = judge_path(truth, shown(with(Change::falloff_distance, drawn())));
  EXPECT_EQ(distance.curve, "the tone curve of the course");
  EXPECT_EQ(names(distance.causes), "distance ");
  EXPECT_EQ(names(judge_path(truth, shown(drawn(), 2.2)).causes), "");
  EXPECT_EQ(names(judge_path(truth, shown(drawn(), 4.4)).causes), "gamma ");
  options.max_depth = 1;
  const PathVerdict direct = judge_path(truth, shown(drawn(), 2.2));
  EXPECT_EQ(direct.curve, "gamma 2.2");
  EXPECT_EQ(names(direct.causes), "depth ");
}

TEST_F(Judge, ReadsOtherGammasOfToneCurves) {
  DecodedPicture picture = drawn();
  for (float& value : picture.linear.rgb) {
    value /= 1 + value;
  }
  const PathVerdict square = judge_path(truth, shown(picture, 2));
  EXPECT_TRUE(square.right);
  EXPECT_EQ(square.curve, "the tone curve v / (1 + v) and gamma 2");
  for (float& value : picture.linear.rgb) {
    value = value <= 0.0031308f ? 12.92f * value
                                : 1.055f * static_cast<float>(std::pow(value, 1 / 2.4)) - 0.055f;
  }
  const PathVerdict srgb = judge_path(truth, shown(picture, 1));
  EXPECT_TRUE(srgb.right);
  EXPECT_EQ(srgb.curve, "the tone curve v / (1 + v) and sRGB");
}

// A factor of all light is an exposure; lamps tell whether it is.
TEST_F(Judge, ReadsExposures) {
  const DecodedPicture picture = drawn();
  for (const float factor : {0.5f, 1.25f, 2.0f}) {
    for (const bool lamps_too : {true, false}) {
      SCOPED_TRACE(::testing::Message() << factor << " " << lamps_too);
      DecodedPicture brighter = picture;
      for (float& value : brighter.linear.rgb) {
        value *= lamps_too || value < 5 ? factor : 1;
        value /= 1 + value;
      }
      const PathVerdict verdict = judge_path(truth, shown(brighter, 2.2));
      EXPECT_EQ(verdict.right, lamps_too);
      EXPECT_NEAR(verdict.exposure, lamps_too ? factor : 1, 0.01 * factor);
      EXPECT_EQ(names(verdict.notes), "");
      EXPECT_EQ(verdict.causes.empty() && verdict.partial.empty(), lamps_too);
    }
  }
}

// With an exposure, all factors are relative to that of direct light.
TEST_F(Judge, SaysFactorsRelativeToDirectLight) {
  options.max_depth = 1;
  DecodedPicture picture = drawn();
  for (float& value : picture.linear.rgb) {
    value *= 0.6f;
    value /= 1 + value;
  }
  const PathVerdict verdict = judge_path(truth, shown(picture, 2.2));
  EXPECT_EQ(names(verdict.causes), "depth ");
  EXPECT_NEAR(verdict.exposure, 0.6, 0.01);
  EXPECT_EQ(verdict.places.front().factor, 1);
  EXPECT_NEAR(verdict.energy_mine[0] / verdict.energy_truth[0], 1, 0.05);
}

// Neighboring pixels of dark colors with little noise are rounded alike.
TEST_F(Judge, ReadsDarkPictures) {
  options.samples = 256;
  DecodedPicture picture = drawn();
  for (float& value : picture.linear.rgb) {
    value = std::min(0.1f * value, 1.0f);
  }
  const PathVerdict verdict = judge_path(truth, shown(picture, 1));
  EXPECT_TRUE(verdict.right) << verdict.chi2_per_value;
  EXPECT_EQ(names(verdict.causes) + names(verdict.partial), "");
}

TEST_F(Judge, ReadsExponentialToneCurves) {
  const DecodedPicture picture = drawn();
  for (const double gamma : {2.2, 1.0}) {
    for (const double exposure : {1.0, 2.0}) {
      DecodedPicture mapped = picture;
      for (float& value : mapped.linear.rgb) {
        value = static_cast<float>(1 - std::exp(-exposure * value));
      }
      const PathVerdict verdict = judge_path(truth, shown(mapped, gamma));
      EXPECT_TRUE(verdict.right) << gamma << " " << exposure;
      EXPECT_EQ(verdict.curve, gamma == 1 ? "the tone curve 1 - exp(-v) and no gamma"
                                          : "the tone curve 1 - exp(-v) and gamma 2.2");
      EXPECT_NEAR(verdict.exposure, exposure, 0.02 * exposure);
    }
  }
}

// Of a tone curve that it does not know, nothing is claimed about light.
TEST_F(Judge, ClaimsNothingByAnUnknownToneCurve) {
  const auto by_film = [](double v) {  // Narkowicz, "ACES Filmic Tone Mapping Curve", 2016
    return std::min(1.0, v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14));
  };
  for (const double gamma : {2.2, 1.0}) {
    SCOPED_TRACE(gamma);
    DecodedPicture picture = drawn();
    for (float& value : picture.linear.rgb) {
      value = static_cast<float>(by_film(value));
    }
    const PathVerdict verdict = judge_path(truth, shown(picture, gamma));
    EXPECT_EQ(names(verdict.causes) + names(verdict.partial) + names(verdict.conventions), "");
    EXPECT_EQ(names(verdict.notes), "tone-curve ");
    EXPECT_TRUE(verdict.places.empty());
  }
  // By a known one, claims stay.
  options.max_depth = 1;
  const PathVerdict two = judge_path(truth, shown(with(Change::falloff_distance, drawn())));
  EXPECT_EQ(names(two.notes), "");
  EXPECT_FALSE(two.partial.empty() && two.causes.empty());
}

TEST_F(Judge, FindsOtherRowsInToneMappedPictures) {
  DecodedPicture picture = shown(drawn());
  for (int y = 0; y < 32; ++y) {
    std::swap_ranges(&picture.texture.rgb[std::size_t(3) * 64 * y],
                     &picture.texture.rgb[std::size_t(3) * 64 * (y + 1)],
                     &picture.texture.rgb[std::size_t(3) * 64 * (63 - y)]);
  }
  EXPECT_EQ(names(judge_path(truth, picture).causes), "vertical-flip ");
}

TEST_F(Judge, SaysWhyNothingCanBeCompared) {
  DecodedPicture picture = shown(drawn());
  std::fill(picture.texture.rgb.begin(), picture.texture.rgb.end(), std::uint8_t(255));
  const PathVerdict white = judge_path(truth, picture);
  EXPECT_EQ(white.tested, 0);
  EXPECT_EQ(names(white.partial), "clipped ");
  DecodedPicture nothing = drawn();
  for (float& value : nothing.linear.rgb) {
    value = std::nanf("");
  }
  const PathVerdict verdict = judge_path(truth, nothing);
  EXPECT_EQ(names(verdict.notes), "nothing-to-compare ");
  EXPECT_FALSE(verdict.right || verdict.too_noisy);
}

TEST_F(Judge, NamesBlackPictures) {
  DecodedPicture picture = drawn();
  std::fill(picture.linear.rgb.begin(), picture.linear.rgb.end(), 0.0f);
  EXPECT_EQ(names(judge_path(truth, picture).causes), "black ");
}

TEST(SmallPictures, AreJudged) {
  const Room room = plain_room();
  for (const int width : {1, 3, 20}) {
    const RenderOptions options = path_options(width, 1, 64);
    const TraceScene traced(room.scene, room.assets);
    PathTruth truth;
    ASSERT_EQ(draw_truth(traced, room.scene, options, 0, 64, {}, truth), RenderStatus::complete);
    DecodedPicture picture;
    picture.linear = render_path(room.scene, room.assets, options, {.traced = &traced}).image;
    picture.texture = quantize(picture.linear, Rounding::nearest);
    const PathVerdict verdict = judge_path(truth, picture);
    EXPECT_TRUE(verdict.causes.empty()) << width;
    EXPECT_LT(verdict.chi2_per_value, 100) << width;
  }
}

TEST_F(Judge, NamesPicturesWithoutReflectedLight) {
  DecodedPicture picture = drawn();
  for (float& value : picture.linear.rgb) {
    value = value < 5 ? 0 : value;
  }
  EXPECT_EQ(names(judge_path(truth, picture).causes), "no-reflected-light ");
}

TEST_F(Judge, NamesBlackLamps) {
  DecodedPicture picture = drawn();
  for (float& value : picture.linear.rgb) {
    value = value < 5 ? value : 0;
  }
  for (const bool screen : {false, true}) {
    const PathVerdict verdict = judge_path(truth, screen ? shown(picture, 2.2) : picture);
    EXPECT_EQ(names(verdict.causes), "black-lamps ") << screen;
    EXPECT_FALSE(verdict.right) << screen;
  }
  EXPECT_EQ(names(judge_path(truth, with(Change::falloff_distance, picture)).causes), "distance ");
  EXPECT_EQ(names(judge_path(truth, with(Change::falloff_distance, picture)).partial),
            "black-lamps ");
}

// In mirrors there is no light, either: paths of other lengths do not explain that.
TEST_F(Judge, NamesLightSamplesOfTheFirstSurfaceOnly) {
  Model model;
  model.quad({0.9f, 0.2f, -0.9f}, {0, 0, 1.2f}, {0, 1.6f, 0},
             model.material(mirror({0.9f, 0.9f, 0.9f})));
  Room mirrors = plain_room();
  mirrors.add(model);
  const TraceScene mirrored(mirrors.scene, mirrors.assets);
  truth = {};
  RenderOptions other = options;
  other.seed = 99;
  ASSERT_EQ(draw_truth(mirrored, mirrors.scene, other, 0, 64, {}, truth), RenderStatus::complete);
  ASSERT_TRUE(truth.mirror);
  options.mis = false;
  const PathScene paths(mirrored, mirrors.scene, options);
  DecodedPicture picture;
  picture.linear = Image(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      Color light(0);
      for (std::uint32_t i = 0; i < 64; ++i) {
        RayCounts counts;
        PathRecord path;
        path_light(paths, x, y, i, counts, &path);
        Color throughput(1);
        for (const PathVertex& v : path.vertices) {
          const bool first = &v == path.vertices.data();
          light += throughput * (v.emission + (first ? v.light : Color(0))) / 64.0;
          throughput *= v.next.weight;
        }
      }
      for (int c = 0; c < 3; ++c) {
        picture.linear.pixel(x, y)[c] = static_cast<float>(light[c]);
      }
    }
  }
  picture.texture = quantize(picture.linear, Rounding::nearest);
  EXPECT_EQ(names(judge_path(truth, picture).causes), "first-surface ");
}

TEST_F(Judge, ReadsToneMappedPicturesWithoutLamps) {
  room.look({0, 1, 0.95}, {0, 0.8, 0}, 80);
  truth = {};
  RenderOptions other = options;
  other.seed = 7;
  ASSERT_EQ(draw_truth(traced, room.scene, other, 0, 32, {}, truth), RenderStatus::complete);
  const PathVerdict verdict = judge_path(truth, shown(drawn()));
  EXPECT_TRUE(verdict.right) << verdict.curve;
  EXPECT_EQ(names(verdict.causes) + names(verdict.partial), "");
}

// Another mistake than a factor of direct light must not bend the white.
TEST_F(Judge, ReadsWrongPicturesWithoutLamps) {
  Room lower = plain_room();
  lower.look({0, 1, 0.95}, {0, 0.8, 0}, 80);
  move_to(lower, 64);
  for (const Change change : {Change::surface_cosine_twice, Change::falloff_cube}) {
    DecodedPicture picture = with(change, drawn());
    picture.linear.pixel(20, 20)[1] = 1.5f;  // the white, far from the others
    const PathVerdict verdict = judge_path(truth, shown(picture));
    EXPECT_EQ(verdict.curve, "the tone curve of the course");
    EXPECT_EQ(names(verdict.causes),
              change == Change::falloff_cube ? "distance " : "surface-cosine ");
  }
}

TEST_F(Judge, NamesTonesOfSamples) {
  constexpr std::array words{"limited to 1", "v / (1 + v)", "1 - exp(-v)"};
  for (const SampleTone tone : {SampleTone::reinhard, SampleTone::film}) {
    const DecodedPicture picture =
        by_paths(64, [&](const PathRecord&, const Color& light) { return toned(tone, light); });
    const PathVerdict verdict = judge_path(truth, shown(picture, 2.2));
    ASSERT_EQ(names(verdict.causes), "toned-samples ") << int(tone);
    EXPECT_THAT(verdict.causes[0].what, ::testing::HasSubstr(words[static_cast<int>(tone)]));
  }
}

TEST_F(Judge, NamesValuesThatWrapAround) {
  const DecodedPicture right = drawn();
  for (const double scale : {255.0, 256.0}) {
    DecodedPicture picture = shown(right, 2.2);
    for (std::size_t i = 0; i < picture.texture.rgb.size(); ++i) {
      const double value = std::pow(double(right.linear.rgb[i]), 1 / 2.2);
      picture.texture.rgb[i] = static_cast<std::uint8_t>(static_cast<int>(scale * value) & 255);
    }
    EXPECT_EQ(names(judge_path(truth, picture).causes), "wrapped ") << scale;
  }
}

TEST_F(Judge, NamesMistakesOfSeveralLampsAndOfTheGlossyLobe) {
  options.samples = 64;
  options.max_depth = 2;
  move_to(lamp_room(), 128);
  ASSERT_EQ(truth.lamp_samples.size(), 4);
  const DecodedPicture picture = drawn();
  constexpr std::array<std::pair<Change, const char*>, 11> rows{{
      {Change::eye_cosine, "surface-cosine "},
      {Change::lamp_cosine_of_surface, "lamp-cosine "},
      {Change::lamp_area_divided, "lamp-area "},
      {Change::lamp_area_of_first, "lamp-area "},
      {Change::lamp_area_mean, "lamp-area "},
      {Change::lamp_emission_of_first, "lamp-color "},
      {Change::lamp_emission_of_last, "lamp-color "},
      {Change::diffuse_without_pi, "pi "},
      {Change::glossy_missing_direct, "glossy "},
      {Change::glossy_flat_direct, "glossy "},
      {Change::glossy_eye, "glossy "},
  }};
  for (const auto& [change, name] : rows) {
    EXPECT_EQ(names(judge_path(truth, with(change, picture)).causes), name) << int(change);
  }
  BlockColors fewer = combined(truth.lamp_samples[0], 1, truth.lamp_samples[1]);
  PathVerdict verdict = judge_path(truth, with(fewer, picture));
  ASSERT_EQ(names(verdict.causes), "lamp-choice ");
  EXPECT_THAT(verdict.causes[0].what, ::testing::HasSubstr("never on 2 of the 4"));
  fewer = combined(combined(fewer, 0.4, truth.lamp_samples[2]), 0.4, truth.lamp_samples[3]);
  EXPECT_EQ(names(judge_path(truth, with(fewer, picture)).partial), "lamp-factors ");
}

// A fitted factor near 1 is not said to be one.
TEST_F(Judge, SaysNoFactorThatTakesTheRest) {
  DecodedPicture picture = with(Change::lamp_cosine, drawn());
  for (float& value : picture.linear.rgb) {
    value *= value < 8 ? 1.07f : 1;  // all but the lamp
  }
  const PathVerdict verdict = judge_path(truth, picture);
  ASSERT_EQ(verdict.partial.size(), 1);
  EXPECT_THAT(verdict.partial[0].what, ::testing::HasSubstr("something else is wrong"));
  EXPECT_THAT(verdict.partial[0].what, ::testing::Not(::testing::HasSubstr("factor")));
}

// Kinds of light do not describe a picture that they explain only in part.
TEST_F(Judge, SaysNoFactorsOfLightThatLeaveMore) {
  options.samples = 256;
  const PathVerdict dark =
      judge_path(truth, by_paths(256, [](const PathRecord& path, const Color&) {
                   Color light(0);
                   for (const PathVertex& v : path.vertices) {
                     light += v.throughput * (v.emission + v.light);
                     if (v.light == Color(0)) {
                       break;
                     }
                   }
                   return light;
                 }));
  EXPECT_EQ(names(dark.causes) + names(dark.partial), "");
  EXPECT_TRUE(dark.places.empty());
  EXPECT_TRUE(judge_path(truth, with(Change::falloff_none, drawn())).places.empty());
}

TEST_F(Judge, NamesMistakesOfMirrorsAndGlass) {
  constexpr std::array shaded_variants{Variant::shaded_mirrors, Variant::shaded_glass};
  constexpr double unlimited = std::numeric_limits<double>::infinity();  // as many as the truth has
  move_to(specular_room(), 128);
  ASSERT_EQ(draw_variants(shaded_variants, room.scene, room.assets, options, unlimited, {}, truth),
            RenderStatus::complete);
  ASSERT_TRUE(truth.mirror && truth.glass);
  const DecodedPicture picture = drawn();
  EXPECT_EQ(names(judge_path(truth, picture).causes), "");
  DecodedPicture clear = picture;
  const BlockColors more =
      combined(truth.changes[static_cast<std::size_t>(Change::glass_visibility)].sampled, -1,
               TruthBlocks(truth).sampled);
  for (std::size_t i = 0; i < clear.linear.rgb.size(); ++i) {
    clear.linear.rgb[i] +=
        static_cast<float>(more[block_of(truth, i / 3)][static_cast<int>(i % 3)]);
  }
  EXPECT_EQ(names(judge_path(truth, clear).causes), "visibility ");
  const PathVerdict steps =
      judge_path(truth, by_paths(128, [](const PathRecord& path, const Color&) {
                   Color light(0);
                   double factor = 1;
                   for (const PathVertex& v : path.vertices) {
                     light += factor * v.throughput * (v.emission + v.light);
                     factor *= v.next.specular() ? 0.7 : 1;
                   }
                   return light;
                 }));
  EXPECT_EQ(names(steps.partial), "specular-factor ");
  options.mis = false;
  PathScene paths(traced, room.scene, options);
  paths.shaded_mirrors = true;
  const DecodedPicture shaded =
      by_paths(paths, 128, [](const PathRecord&, const Color& light) { return light; });
  EXPECT_EQ(names(judge_path(truth, shaded).causes), "shaded-specular ");
}

TEST(Linearize, UndoesTheCoursesCurve) {
  Image image(2, 1);
  image.rgb = {0.2f, 0.4f, 0.1f, 9, 7, 5};
  const Image mapped = tone_mapped(image, Tone::course, 0);
  for (const ToneCurve curve : {ToneCurve::course, ToneCurve::compressed}) {
    Image values = mapped;
    for (float& value : values.rgb) {
      value = curve == ToneCurve::course ? value : value * value;  // without gamma
    }
    DecodedPicture picture;
    picture.texture = quantize(values, Rounding::nearest);
    const LinearPicture found = linearized(picture, {curve, brightest(image.rgb, 0)});
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(found.pixels[0][c], image.rgb[c], 3.5 * std::sqrt(found.rounding[0][c]));
    }
    EXPECT_FALSE(found.usable[1]);
  }
}

}  // namespace

}  // namespace scenefile
