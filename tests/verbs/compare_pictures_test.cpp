#include "scenefile/verbs/compare_pictures.h"

#include "scenefile/trace/features.h"
#include "support/jpeg_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {
namespace {

constexpr const char* ball = R"(<scenefile>
<globaldata><ambientcoeff v="0.5"/><diffusecoeff v="0.5"/><specularcoeff v="0.5"/></globaldata>
<cameradata><pos x="0" y="1" z="4"/><look x="0" y="-0.2" z="-1"/><up x="0" y="1" z="0"/>
<heightangle v="30"/></cameradata>
<lightdata><type v="directional"/><color r="0.9" g="0.9" b="0.9"/>
<direction x="-1" y="-1" z="-1"/></lightdata>
<object type="tree" name="root"><transblock><object type="primitive" name="sphere">
<diffuse r="0.8" g="0.3" b="0.2"/><ambient r="0.3" g="0.1" b="0.1"/></object></transblock></object>
</scenefile>)";

// Nothing explains it, so that all searches run.
TEST(ComparePictures, ProgressNeverGoesBack) {
  const LoadedScene scene = load_scene("ball.xml", ball, {});
  ASSERT_TRUE(scene.usable());
  RenderOptions options = default_options(Profile::course);
  options.width = 96;
  options.height = 72;
  const Texture reference = quantize(render(scene.ready.scene, scene.assets, options).image,
                                     rounding_of(options.profile));
  Texture strange = reference;
  for (std::size_t i = 0; i < strange.rgb.size(); ++i) {
    strange.rgb[i] = static_cast<std::uint8_t>(std::max(0, strange.rgb[i] - int(i * i % 97)));
  }
  CompareSettings settings;
  settings.ways = possible_ways(std::array{options}, false);
  std::vector<double> progress;
  const PictureComparison found =
      compare_pictures(reference, strange, &scene, settings, [&](double done) {
        progress.push_back(done);
        return true;
      });
  EXPECT_TRUE(found.causes.claims.empty());
  EXPECT_GT(progress.size(), 10u);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_TRUE(found.drawn_exactly);
}

// The text names them with the cause, and JSON says so.
TEST(ComparePictures, RivalsThatTheCauseNamesAreNotSaidTwice) {
  PictureComparison found;
  found.causes.claims = {{Cause::normals, "no normals, or no shadows", "all"}};
  found.causes.rivals = {{Cause::shadows, "no shadows", "all", 1, true},
                         {Cause::ambient, "no ambient term", "most", 0.9}};
  const std::string text = causes_text(found);
  EXPECT_EQ(text.find("[shadows]"), std::string::npos) << text;
  EXPECT_NE(text.find("or: no ambient term [ambient]"), std::string::npos) << text;
  Json json;
  json.begin_object();
  add_claims(json, "rivals", found.causes.rivals);
  json.end_object();
  const std::string rivals = json.text();
  const std::size_t said = rivals.find("\"said\": true");
  EXPECT_LT(said, rivals.find("\"ambient\"")) << rivals;
  EXPECT_EQ(rivals.find("\"said\"", said + 1), std::string::npos) << rivals;
}

Texture drawn_with(const LoadedScene& scene, RenderOptions options) {
  options.width = 160;
  options.height = 120;
  return quantize(render(scene.ready.scene, scene.assets, options).image,
                  rounding_of(options.profile));
}

// With sets of features that draw the same picture, the profile's own, or one with a name.
TEST(ComparePictures, HowAReferenceWasDrawnInTheFewestWords) {
  const LoadedScene scene = load_scene("ball.xml", ball, {});
  std::string two = ball;
  two.insert(two.rfind("</object>"),
             "<transblock><translate x=\"0.5\" y=\"0.5\" z=\"0.5\"/><scale x=\"0.3\" y=\"0.3\" "
             "z=\"0.3\"/><object type=\"primitive\" name=\"cube\"><diffuse r=\"0.2\" g=\"0.5\" "
             "b=\"0.8\"/></object></transblock>");
  const LoadedScene shaded = load_scene("two.xml", two, {});
  const std::vector<DrawnWay> ways = possible_ways(
      std::array{default_options(Profile::course), default_options(Profile::fine)}, false);
  const auto words = [&](const LoadedScene& of, Profile profile, std::string_view features) {
    RenderOptions options = default_options(profile);
    if (!features.empty()) {
      parse_features(features, options);
    }
    const Texture reference = drawn_with(of, options);
    const ReferenceWay found =
        reference_way(reference, of, ways_drawn(reference, of, ways).front(), ways);
    EXPECT_TRUE(found.exactly);
    return found.way.words;
  };
  for (const LoadedScene* const of : {&scene, &shaded}) {
    EXPECT_EQ(words(*of, Profile::course, ""), "--profile course");
    EXPECT_EQ(words(*of, Profile::fine, ""), "--profile fine");
    EXPECT_EQ(words(*of, Profile::course, "illuminate"), "--profile course");
    EXPECT_EQ(words(*of, Profile::course, "all"), "--profile course --features all");
  }
  EXPECT_EQ(words(scene, Profile::course, "none"), "--profile course");
  EXPECT_EQ(words(shaded, Profile::course, "none"), "--profile course --features none");
  EXPECT_EQ(words(shaded, Profile::fine, "none"), "--profile fine --features none");
}

// The edges of the ball are blurred, so that single samples differ from ours nearly everywhere.
TEST(ComparePictures, OurPictureEqualsOursWithAnySamples) {
  std::string blurred = ball;
  blurred.replace(blurred.find("<heightangle"), 0, "<aperture v=\"1.5\"/><focallength v=\"2\"/>");
  const LoadedScene scene = load_scene("ball.xml", blurred, {});
  ASSERT_TRUE(scene.usable());
  const DrawnWay way{default_options(Profile::fine), "--profile fine"};
  Texture picture = drawn_with(scene, way.options);
  EXPECT_GT(share_unlike(picture, scene, way), max_share_same);
  EXPECT_TRUE(equals_ours(picture, scene, way));
  for (std::size_t i = 0; i < picture.rgb.size() / 50; ++i) {
    picture.rgb[i] ^= 0x40;
  }
  EXPECT_FALSE(equals_ours(picture, scene, way));
}

// As many scattered pixels would count as details, but edges do not fill squares.
TEST(ComparePictures, ASmallAreaIsNotADetail) {
  Texture reference{128, 96, {}};
  reference.rgb.assign(std::size_t{3} * 128 * 96, 40);
  Texture scattered = reference;
  Texture area = reference;
  for (std::size_t i = 0; i < 9; ++i) {
    scattered.rgb[3 * (10 + 1000 * i)] = 200;
    area.rgb[3 * (128 * (50 + i / 3) + 60 + i % 3)] = 200;
  }
  EXPECT_TRUE(find_causes(reference, scattered).only_details);
  EXPECT_FALSE(find_causes(reference, area).only_details);
  EXPECT_EQ(find_causes(reference, area).share_different,
            find_causes(reference, scattered).share_different);
}

// Where values differ by more than rounding, though by little, the answer says so.
TEST(ComparePictures, WordsOfDetails) {
  Texture reference{64, 48, {}};
  for (int i = 0; i < 64 * 48; ++i) {
    const auto value = static_cast<std::uint8_t>(i % 64 < 32 ? 40 + i / 64 : 200);  // an edge
    reference.rgb.insert(reference.rgb.end(), {value, value, 90});
  }
  const auto with = [&](auto change) {
    Texture test = reference;
    for (std::size_t i = 0; i < test.rgb.size(); ++i) {
      test.rgb[i] = static_cast<std::uint8_t>(test.rgb[i] + change(i));
    }
    return words_of_details(reference, test);
  };
  EXPECT_EQ(with([](std::size_t i) { return i % 3 == 0   ? 1
                                            : i % 3 == 1 ? -1
                                                         : 0; }),
            "at edges and by rounding");
  EXPECT_EQ(with([](std::size_t i) { return i == 3000 ? 3 : 0; }), "at edges and by rounding");
  EXPECT_EQ(with([](std::size_t i) { return i % 2 == 0 ? 3 : -3; }),
            "at edges, and by up to 3/255 elsewhere");
  EXPECT_EQ(with([](std::size_t) { return -4; }),
            "at edges, and by up to 4/255 elsewhere; nearly all values are lower, on average by "
            "4.0/255");
  EXPECT_EQ(with([](std::size_t) { return 1; }),
            "at edges, and by up to 1/255 elsewhere; nearly all values are higher, on average by "
            "1.0/255");
  EXPECT_EQ(with([&](std::size_t i) { return i % 192 == 93 ? 160 : 0; }),
            "at edges and by rounding");
}

// The ball with a highlight, larger, on a table.
std::string still_life(const std::string& diffuse, const std::string& specular) {
  return R"(<scenefile>
<globaldata><ambientcoeff v="0.5"/><diffusecoeff v=")" +
         diffuse + R"("/><specularcoeff v=")" + specular + R"("/></globaldata>
<cameradata><pos x="0" y="1" z="4"/><look x="0" y="-0.2" z="-1"/><up x="0" y="1" z="0"/>
<heightangle v="30"/></cameradata>
<lightdata><type v="directional"/><color r="0.9" g="0.9" b="0.9"/>
<direction x="-1" y="-1" z="-1"/></lightdata>
<object type="tree" name="root"><transblock><scale x="1.5" y="1.5" z="1.5"/>
<object type="primitive" name="sphere"><diffuse r="0.8" g="0.3" b="0.2"/>
<ambient r="0.3" g="0.1" b="0.1"/><specular r="0.9" g="0.9" b="0.9"/><shininess v="20"/></object>
</transblock><transblock><translate x="0" y="-0.8" z="0"/><scale x="4" y="0.1" z="4"/>
<object type="primitive" name="cube"><diffuse r="0.4" g="0.5" b="0.6"/>
<ambient r="0.1" g="0.1" b="0.1"/></object></transblock></object></scenefile>)";
}

// One mistake changes all surfaces, the other only the highlight, where the noise is large.
TEST(ComparePictures, NamesMistakesInJpegs) {
  const LoadedScene scene = load_scene("right.xml", still_life("0.5", "0.5"), {});
  ASSERT_TRUE(scene.usable());
  RenderOptions options = default_options(Profile::course);
  options.width = 320;
  options.height = 240;
  const auto drawn = [&](const LoadedScene& one) {
    return quantize(render(one.ready.scene, one.assets, options).image,
                    rounding_of(options.profile));
  };
  const Texture reference = drawn(scene);
  CompareSettings settings;
  settings.ways = possible_ways(std::array{options}, false);
  settings.lossy = true;
  const auto causes = [&](const std::string& text, int quality) {
    const Texture mine = drawn(load_scene("mine.xml", text, {}));
    const Result<DecodedPicture> jpeg = decode_picture(testing_support::jpeg_of(mine, quality));
    return compare_pictures(reference, jpeg->texture, &scene, settings).causes;
  };
  for (const int quality : {90, 75}) {
    const CauseReport diffuse = causes(still_life("1", "0.5"), quality);
    ASSERT_EQ(diffuse.claims.size(), 1u) << quality;
    EXPECT_EQ(diffuse.claims.front().cause, Cause::diffuse);
    const CauseReport specular = causes(still_life("0.5", "0"), quality);
    ASSERT_EQ(specular.claims.size(), 1u) << quality;
    EXPECT_EQ(specular.claims.front().cause, Cause::specular);
    EXPECT_TRUE(causes(still_life("0.5", "0.5"), quality).claims.empty()) << quality;
  }
  // Right pictures; that of quality 60 is within the noise of pixels, but not of blocks.
  for (const int quality : {95, 75, 65, 60, 55}) {
    const CauseReport right = causes(still_life("0.5", "0.5"), quality);
    ASSERT_EQ(right.notes.size(), 1u) << quality;
    EXPECT_EQ(right.notes.front().what, "the colors are as inexact as those of JPEGs");
  }
}

// Where many pixels show no light, the contrast is high, so that no single pixel is evidence.
TEST(ComparePictures, NamesAcneInJpegs) {
  std::string unlit_text = still_life("0.5", "0.5");
  const std::size_t lights = unlit_text.find("<lightdata>");
  unlit_text.erase(lights, unlit_text.find("<object") - lights);
  const LoadedScene scene = load_scene("right.xml", still_life("0.5", "0.5"), {});
  RenderOptions options = default_options(Profile::course);
  options.width = 320;
  options.height = 240;
  const auto drawn = [&](const LoadedScene& one) {
    return quantize(render(one.ready.scene, one.assets, options).image,
                    rounding_of(options.profile));
  };
  const Texture lit = drawn(scene);
  const Texture unlit = drawn(load_scene("unlit.xml", unlit_text, {}));
  CompareSettings settings;
  settings.ways = possible_ways(std::array{options}, false);
  settings.lossy = true;
  // `shown`: of the light, by pixel.
  const auto causes = [&](const std::function<double()>& shown, int quality) {
    Texture mine = lit;
    for (std::size_t i = 0; i < mine.rgb.size(); i += 3) {
      const double here = shown();
      for (std::size_t c = i; c < i + 3; ++c) {
        mine.rgb[c] =
            static_cast<std::uint8_t>(std::lround(std::lerp(unlit.rgb[c], lit.rgb[c], here)));
      }
    }
    const Result<DecodedPicture> jpeg = decode_picture(testing_support::jpeg_of(mine, quality));
    return compare_pictures(lit, jpeg->texture, &scene, settings).causes;
  };
  std::mt19937 random(3);
  for (const int quality : {90, 75}) {
    for (const unsigned share : {4u, 2u}) {
      const CauseReport acne = causes([&] { return random() % share == 0 ? 0.0 : 1.0; }, quality);
      ASSERT_EQ(acne.claims.size(), 1u) << quality << " " << share;
      EXPECT_EQ(acne.claims.front().cause, Cause::acne);
    }
    for (const Claim& claim : causes([] { return 0.5; }, quality).claims) {
      EXPECT_NE(claim.cause, Cause::acne) << quality;
    }
  }
}

}  // namespace
}  // namespace scenefile
