// The explanation of a pixel is the pixel: all sums, to the last bit.

#include "path/full_room.h"
#include "path/statistics.h"
#include "scenefile/path/explain_path.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

namespace scenefile::path_test {
namespace {

// All sums of a path.
void check_sums(const PathPixel& pixel) {
  const PathRecord& path = pixel.path;
  Color direct(0);
  Color indirect(0);
  Color throughput(1);
  std::uint32_t lights = 0;
  for (std::size_t i = 0; i < path.vertices.size(); ++i) {
    const PathVertex& v = path.vertices[i];
    EXPECT_EQ(v.throughput, throughput);
    EXPECT_EQ(v.emission, v.emission_weight * v.point.emission);
    (i < 2 ? direct : indirect) += throughput * v.emission;
    EXPECT_EQ(v.first_light, lights);
    Color sum(0);
    for (; lights < v.first_light + v.lights; ++lights) {
      const PathLight& l = path.lights[lights];
      EXPECT_EQ(l.unshadowed, l.weight / l.density * l.reflected * l.emission);
      EXPECT_EQ(l.contribution, l.visibility * l.unshadowed);
      EXPECT_EQ(l.shadow_ray, l.unshadowed != Color(0));
      EXPECT_TRUE(l.visibility == Color(1) || !l.shadow_ray || pixel.occluders[lights]);
      sum += l.contribution;
    }
    EXPECT_EQ(v.light, sum);
    (i < 1 ? direct : indirect) += throughput * v.light;
    const bool last = i + 1 == path.vertices.size();
    EXPECT_EQ(v.end == PathEnd::none, !last || path.escaped);
    if (v.next.lobe != BsdfLobe::none && !v.next.specular() && v.next.density > 0) {
      EXPECT_EQ(v.next.weight, v.next.bsdf_cosine / v.next.density);
    }
    throughput = throughput * v.next.weight / v.continuation;
  }
  EXPECT_EQ(lights, path.lights.size());
  EXPECT_EQ(path.direct, direct);
  EXPECT_EQ(path.indirect, indirect);
  EXPECT_EQ(path.light, path.clamp == 1 ? direct + indirect : direct + path.clamp * indirect);
  EXPECT_EQ(path.light, pixel.samples[pixel.shown].light);
  EXPECT_EQ(path.vertices.size(), pixel.samples[pixel.shown].surfaces);
  EXPECT_EQ(pixel.objects.size(), path.vertices.size());
}

void check_pixel(const Room& room, const RenderOptions& options, const Image& picture, int x, int y,
                 std::uint32_t sample) {
  SCOPED_TRACE(std::to_string(x) + "," + std::to_string(y));
  PathPixel pixel;
  ASSERT_EQ(explain_path(room.scene, room.assets, options, x, y, sample, pixel),
            RenderStatus::complete);
  ASSERT_EQ(pixel.samples.size(), static_cast<std::size_t>(options.samples));
  EXPECT_EQ(pixel.shown, sample);
  Color sum(0);
  for (const PathSample& s : pixel.samples) {
    sum += s.light;
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(pixel.picture[c], picture.pixel(x, y)[c]);
    EXPECT_EQ(pixel.picture[c], static_cast<float>(sum[c] / double(options.samples)));
  }
  check_sums(pixel);
}

TEST(PathExplain, IsThePixelToTheLastBit) {
  std::vector<std::pair<std::string, RenderOptions>> all;
  const auto variant = [&](const std::string& name) -> RenderOptions& {
    return all.emplace_back(name, path_options(24, 18, 5)).second;
  };
  variant("default");
  variant("continuation").continuation = 0.8;
  variant("max depth").max_depth = 3;
  variant("direct only").direct_only = true;
  variant("clamp").clamp = 0.05;
  variant("no light samples").light_samples = 0;
  RenderOptions& no_mis = variant("no mis");
  no_mis.mis = false;
  no_mis.light_samples = 3;
  variant("course").convention = Convention::course;
  variant("seed").seed = 12345678901234;
  Uniform random(3);
  for (const bool lens : {false, true}) {
    for (const bool lights : {false, true}) {
      const Room room = full_room(lens, lights);
      for (const auto& [name, options] : all) {
        SCOPED_TRACE(name + (lens ? ", lens" : "") + (lights ? ", lights" : ""));
        const Image picture = draw(room, options).image;
        for (int i = 0; i < 12; ++i) {
          check_pixel(room, options, picture, static_cast<int>(24 * random()),
                      static_cast<int>(18 * random()), static_cast<std::uint32_t>(5 * random()));
        }
      }
    }
  }
}

TEST(PathExplain, MeetsEveryLobeAndEnd) {
  const Room room = full_room(false, true);
  RenderOptions options = path_options(12, 9, 8);
  std::vector<bool> lobes(6);
  std::vector<bool> ends(5);
  for (const int depth : {0, 2}) {
    for (const bool direct : {false, true}) {
      options.max_depth = depth;
      options.direct_only = direct;
      for (int i = 0; i < 108; ++i) {
        PathPixel pixel;
        explain_path(room.scene, room.assets, options, i % 12, i / 12, i % 8, pixel);
        for (const PathVertex& v : pixel.path.vertices) {
          lobes[static_cast<std::size_t>(v.next.lobe)] = true;
          ends[static_cast<std::size_t>(v.end)] = true;
        }
      }
    }
  }
  EXPECT_EQ(lobes, std::vector<bool>(6, true));
  ends[static_cast<std::size_t>(PathEnd::absorbed)] = true;  // rare
  EXPECT_EQ(ends, std::vector<bool>(5, true));
}

TEST(PathExplain, ShowsTheSampleNearestToTheCenterByDefault) {
  const Room room = full_room(false, false);
  PathPixel pixel;
  ASSERT_EQ(explain_path(room.scene, room.assets, path_options(24, 18, 16), 5, 6, {}, pixel),
            RenderStatus::complete);
  const auto off = [](const PathSample& s) { return glm::length(s.point - glm::dvec2(5.5, 6.5)); };
  for (const PathSample& s : pixel.samples) {
    EXPECT_LE(off(pixel.samples[pixel.shown]), off(s));
  }
  EXPECT_GT(pixel.standard_error, 0);
  EXPECT_TRUE(std::isfinite(pixel.standard_error));
}

TEST(PathExplain, TheNoiseOfOneSampleIsUnknown) {
  const Room room = full_room(false, false);
  PathPixel pixel;
  ASSERT_EQ(explain_path(room.scene, room.assets, path_options(24, 18, 1), 5, 6, {}, pixel),
            RenderStatus::complete);
  EXPECT_TRUE(std::isinf(pixel.standard_error));
}

// Of a clear pane, a darker one and what blocks the light.
TEST(PathExplain, NamesTheDarkestOccluder) {
  Room room;
  Model floor;
  floor.quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10}, floor.material(diffuse(glm::vec3(0.5f))));
  room.add(floor);
  room.light(LightType::point, {0, 5, 0}, glm::vec3(1));
  room.look({0, 0.3, 2}, {0, 0, 0}, 1);
  const auto occluder = [&](float transparent, const glm::vec3& at) {
    RenderMaterial m;
    m.transparent = glm::vec3(transparent);
    room.add(Shape::cube, translate(at), room.material(m));
    PathPixel pixel;
    EXPECT_EQ(explain_path(room.scene, room.assets, path_options(1, 1, 1), 0, 0, {}, pixel),
              RenderStatus::complete);
    return pixel.occluders.at(0);
  };
  EXPECT_FALSE(occluder(1, {0, 1, 0}));  // all light arrives
  const std::optional<ObjectRef> dark = occluder(0.25f, {0, 2.1f, 0});
  ASSERT_TRUE(dark);
  EXPECT_EQ(dark->source, 2);
  EXPECT_EQ(occluder(0.5f, {0, 3.2f, 0})->source, 2);
  EXPECT_EQ(occluder(0, {0, 4.3f, 0})->source, 4);
}

// Seen from outside, wherever the bump map turns the normal.
TEST(PathExplain, BumpMapsDoNotTurnGlassInsideOut) {
  Room room;
  RenderMaterial m;
  m.diffuse = glm::vec3(0);
  m.transparent = glm::vec3(1);
  m.ior = 1.5f;
  m.bump_map.file = room.texture(2, 2, {0, 255, 255, 0});
  m.bump_map.repeat_u = m.bump_map.repeat_v = 8;
  room.add(Shape::sphere, {}, room.material(m));
  room.look({0, 0, 2}, {0, 0, 0}, 30);
  for (int i = 0; i < 64; ++i) {
    PathPixel pixel;
    ASSERT_EQ(explain_path(room.scene, room.assets, path_options(8, 8, 1), i % 8, i / 8, {}, pixel),
              RenderStatus::complete);
    if (!pixel.path.vertices.empty()) {
      EXPECT_TRUE(pixel.path.vertices[0].point.facing.outside) << i;
    }
  }
}

TEST(PathExplain, PathsThatMissAreBlack) {
  Room room;
  Model model;
  model.quad({5, 5, 5}, {1, 0, 0}, {0, 1, 0}, model.material(diffuse(glm::vec3(0.5f))));
  room.add(model);
  room.look({0, 0, 0}, {0, 0, -1}, 40);
  PathPixel pixel;
  ASSERT_EQ(explain_path(room.scene, room.assets, path_options(4, 4, 2), 1, 1, {}, pixel),
            RenderStatus::complete);
  EXPECT_TRUE(pixel.path.escaped);
  EXPECT_TRUE(pixel.path.vertices.empty());
  EXPECT_EQ(pixel.path.light, Color(0));
}

}  // namespace
}  // namespace scenefile::path_test
