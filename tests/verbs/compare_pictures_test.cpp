#include "scenefile/verbs/compare_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
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

}  // namespace
}  // namespace scenefile
