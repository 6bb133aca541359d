// Pictures of the assignment Realtime, compared with a software rasterizer and known values.

#include "scenefile/asset/compare_images.h"
#include "scenefile/verbs/explain.h"
#include "view/build_scene.h"
#include "view/software_realtime.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace scenefile {

namespace {

using namespace view_test;

constexpr double byte = 1.0 / 255;

using PixelValue = std::array<std::uint8_t, 3>;

class Realtime : public Drawn {
 protected:
  Texture drawn(const SceneBuilder& builder, const RealtimeOptions& realtime, int width = 32,
                int height = 32, DrawMode mode = DrawMode::shaded) {
    DrawOptions options;
    options.mode = mode;
    options.realtime = realtime;
    Drawing drawing = uploaded(builder);
    const Result<Image> image =
        draw_image(*device, drawing, builder.scene.camera, options, width, height, &stats);
    EXPECT_EQ(error_text(image), "");
    return quantize(*image, Rounding::nearest);
  }
};

RenderLight light(LightType type, const glm::vec3& position, const glm::vec3& direction) {
  RenderLight result;
  result.type = type;
  result.position = position;
  result.direction = glm::normalize(direction);
  result.color = glm::vec3(0.8f, 0.7f, 0.6f);
  result.attenuation = {0.9f, 0.05f, 0.01f};
  result.inner_angle = 0.3f;
  result.outer_angle = 0.6f;
  return result;
}

// All shapes, rotated and stretched, one reflected, and all types of lights.
SceneBuilder everything() {
  SceneBuilder builder;
  RenderMaterial material;
  material.ambient = {0.1f, 0.15f, 0.2f};
  material.diffuse = {0.5f, 0.6f, 0.4f};
  material.specular = glm::vec3(0.5f);
  material.shininess = 12;
  builder.scene.materials.push_back(material);
  const Shape shapes[] = {Shape::cube, Shape::cone, Shape::cylinder, Shape::sphere, Shape::sphere};
  for (int i = 0; i < 5; ++i) {
    const float turn = 0.7f * static_cast<float>(i) + 0.4f;
    glm::mat3 linear(std::cos(turn), std::sin(turn), 0.3f, -std::sin(turn), std::cos(turn), 0.1f,
                     0.2f, -0.3f, 1.3f);
    if (i == 4) {
      linear[0] = -linear[0];
    }
    const glm::vec3 offset(1.1f * static_cast<float>(i - 2), 0.4f * static_cast<float>(i % 2),
                           -5 - 0.3f * static_cast<float>(i));
    builder.add(shapes[i], {linear, offset}, 0);
  }
  builder.add(Shape::cube, {glm::mat3(9, 0, 0, 0, 0.2f, 0, 0, 0, 9), {0, -1.5f, -6}}, 0);
  builder.scene.lights = {light(LightType::directional, {}, {1, -2, -1}),
                          light(LightType::point, {-2, 1, -3}, {0, -1, 0}),
                          light(LightType::spot, {2, 3, -4}, {-0.3f, -1, -0.4f}),
                          light(LightType::area, {0, 3, -4}, {0, -1, 0})};
  return builder;
}

struct Apart {
  long over = 0;    // pixels that differ by more than 8/255
  long inside = 0;  // those farther than a pixel from any edge
};

Apart apart(const Texture& a, const SoftwarePicture& b) {
  Apart result;
  for (std::size_t pixel = 0; pixel < b.near_edge.size(); ++pixel) {
    int most = 0;
    for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c) {
      most = std::max(most, std::abs(a.rgb[c] - b.picture.rgb[c]));
    }
    result.over += most > 8 ? 1 : 0;
    result.inside += most > 8 && !b.near_edge[pixel] ? 1 : 0;
  }
  return result;
}

TEST_F(Realtime, AgreesWithASoftwareRasterizer) {
  const SceneBuilder builder = everything();
  for (const Milestone milestone : {Milestone::lights_camera, Milestone::action}) {
    for (const Filter filter :
         {Filter::none, Filter::invert, Filter::grayscale, Filter::blur, Filter::sharpen}) {
      for (const TessellationParameters parameters :
           {TessellationParameters{1, 1}, TessellationParameters{5, 5},
            TessellationParameters{12, 17}}) {
        const RealtimeOptions realtime{parameters, 0.1, 100, filter, milestone};
        const Texture ours = drawn(builder, realtime, 200, 150);
        const SoftwarePicture software = software_realtime(builder.scene, realtime, 200, 150);
        const Apart off = apart(ours, software);
        EXPECT_LE(off.over, 4) << int(filter) << ' ' << parameters.parameter1;
        EXPECT_EQ(off.inside, 0) << int(filter) << ' ' << parameters.parameter1;
        EXPECT_GT(compare_images(ours, software.picture).psnr_db, 50);
      }
    }
  }
}

// The largest difference of a channel, in 1/255.
double largest_difference(const PixelValue& a, const std::uint8_t* b) {
  double most = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    most = std::max(most, std::abs(double(a[c]) - b[c]));
  }
  return most;
}

// Each pixel's terms: they must add up to the frame's pixels, and those to what OpenGL draws.
TEST_F(Realtime, TermsOfAPixelAddUpToWhatIsDrawn) {
  const SceneBuilder builder = everything();
  LoadedScene loaded;
  loaded.ready.scene = builder.scene;
  const glm::ivec2 size(48, 36);
  int compared = 0;
  int off = 0;
  double largest_weight = 0;
  for (const RealtimeOptions& realtime :
       {RealtimeOptions{{5, 5}, 0.1, 100, Filter::none, Milestone::lights_camera},
        RealtimeOptions{{2, 3}, 5.2, 6.5, Filter::none, Milestone::action},
        RealtimeOptions{{7, 4}, 0.1, 100, Filter::invert, Milestone::action},
        RealtimeOptions{{7, 4}, 0.1, 100, Filter::grayscale, Milestone::lights_camera},
        RealtimeOptions{{1, 9}, 0.1, 100, Filter::blur, Milestone::action},
        RealtimeOptions{{12, 17}, 0.1, 100, Filter::sharpen, Milestone::action}}) {
    const Texture drawn_picture = drawn(builder, realtime, size.x, size.y);
    const int step = realtime.filter == Filter::none ? 1 : 3;
    // The kernel of sharpen amplifies the rounding of the frame by 25/9.
    const double rounding = realtime.filter == Filter::sharpen ? 3 : 1;
    for (int y = 0; y < size.y; y += step) {
      for (int x = 0; x < size.x; x += step) {
        const Result<ExplainReport> report = explain_realtime_pixel(loaded, realtime, size, {x, y});
        ASSERT_TRUE(report);
        ++compared;
        const double most = largest_difference(report->pixel.value, drawn_picture.texel(x, y));
        off += most > rounding ? 1 : 0;
        const RealtimePixel& pixel = report->realtime->pixel;
        double weights = 0;
        for (std::size_t i = 0; i < pixel.shares.size(); ++i) {
          weights += pixel.shares[i].weight;
          const RayRecord& ray = report->realtime->shares[i].rays.front();
          glm::dvec3 sum = ray.ambient;
          for (const LightRecord& light : ray.lights) {
            sum += light.contribution;
          }
          EXPECT_LT(glm::length(sum - report->pixel.samples[i].color), 1e-12);
        }
        largest_weight = std::max(largest_weight, std::abs(weights - 1));
      }
    }
  }
  EXPECT_GT(compared, 4000);
  EXPECT_LE(off, 4) << "pixels whose triangle depends on the driver's rounding";
  EXPECT_LT(largest_weight, 1e-9);
}

// A picture with a known mistake, filtered and scaled from the frame: the mistake is named.
TEST_F(Realtime, TheOtherValueIsComparedThroughFilterAndFrame) {
  SceneBuilder builder = everything();
  LoadedScene loaded;
  loaded.ready.scene = builder.scene;
  const glm::ivec2 size(48, 36);
  const RealtimeOptions realtime{{5, 5}, 0.1, 100, Filter::blur, Milestone::action};
  builder.scene.global.ambient = 0;
  const Texture theirs = drawn(builder, realtime, size.x, size.y);
  int explained = 0;
  for (int x = 4; x < 40; x += 6) {
    Result<ExplainReport> report = explain_realtime_pixel(loaded, realtime, size, {x, 20});
    ASSERT_TRUE(report);
    const std::uint8_t* const v = theirs.texel(x, 20);
    add_yours(loaded, {v[0], v[1], v[2]}, *report);
    const auto& fits = report->yours->fits;
    explained += std::any_of(fits.begin(), fits.end(), [](const YoursFit& fit) {
      return fit.what == "without the ambient term";
    });
  }
  EXPECT_EQ(explained, 6);
}

TEST_F(Realtime, AnExplainedPixelNamesItsObjectInsideInstances) {
  SceneBuilder builder;
  builder.add(Shape::cube, place({0, 0, 0}), builder.glowing({1, 0, 0}));
  builder.add(Shape::sphere, place({1.5f, 0, 0}), builder.glowing({0, 1, 0}));
  builder.scene.groups.emplace_back();
  builder.add(Shape::cube, place({0, 50, 0}), 0);
  builder.add_instance(0, place({-2, 0, -6}));
  builder.add_instance(0, place({1, 0, -6}));
  LoadedScene loaded;
  loaded.ready.scene = builder.scene;
  const Texture picture = drawn(builder, {}, 64, 48);
  for (const auto& [x, source, instance] :
       {std::tuple(12, 0u, 3u), std::tuple(25, 1u, 3u), std::tuple(42, 0u, 4u)}) {
    const Result<ExplainReport> report = explain_realtime_pixel(loaded, {}, {64, 48}, {x, 24});
    ASSERT_TRUE(report);
    const auto& object = report->pixel.samples.front().object;
    ASSERT_TRUE(object.has_value()) << x;
    EXPECT_EQ(object->source, source);
    EXPECT_EQ(object->instances, std::vector{instance});
    EXPECT_LE(largest_difference(report->pixel.value, picture.texel(x, 24)), 0);
  }
}

TEST_F(Realtime, NearAndFarClipShapes) {
  const SceneBuilder builder = everything();
  const RealtimeOptions whole{{5, 5}, 0.1, 100};
  const RealtimeOptions cut{{5, 5}, 5.2, 6};
  const Texture ours = drawn(builder, cut, 200, 150);
  const Apart off = apart(ours, software_realtime(builder.scene, cut, 200, 150));
  EXPECT_LE(off.over, 4);
  EXPECT_EQ(off.inside, 0);
  EXPECT_GT(compare_images(ours, drawn(builder, whole, 200, 150)).share_over, 0.1);
}

// A square whose edges pass through pixel centers: which side covers them depends on the driver.
TEST_F(Realtime, EdgesThroughPixelCentersDependOnTheDriver) {
  SceneBuilder builder;
  builder.scene.camera.fov_y = 2 * std::atan(1.0);
  // 16 x 16 pixels; at depth 1, a pixel is an eighth of a world unit high.
  const double aspect = double(realtime_window(16, 16).width) / realtime_window(16, 16).height;
  glm::mat3 linear(1);
  linear[0][0] = static_cast<float>(aspect * 8 / 8);
  builder.add(Shape::cube, {linear, {0.5f * static_cast<float>(aspect) / 8, 0.5f / 8, -1.5f}},
              builder.glowing(glm::vec3(1)));
  const RealtimeOptions realtime{{1, 3}, 0.1, 100};
  const auto count = [](const Texture& picture) {
    long lit = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
      lit += picture.rgb[i] > 0 ? 1 : 0;
    }
    return lit;
  };
  const Texture upper = software_realtime(builder.scene, realtime, 16, 16).picture;
  const Texture lower =
      software_realtime(builder.scene, realtime, 16, 16, {.upper_edges_own = false}).picture;
  EXPECT_EQ(count(upper), 64);
  EXPECT_EQ(count(lower), 64);
  const auto differing = [&](const Texture& a, const Texture& b) {
    return std::lround(compare_images(a, b).share_over * 16 * 16);
  };
  EXPECT_EQ(differing(upper, lower), 16) << "a row of 8 pixels moves";
  const Texture ours = drawn(builder, realtime, 16, 16);
  EXPECT_EQ(count(ours), 64);
  EXPECT_TRUE(ours.rgb == upper.rgb || ours.rgb == lower.rgb);
}

TEST_F(Realtime, LightsCameraUsesOnlyDirectionalLights) {
  SceneBuilder builder = everything();
  const Texture all = drawn(builder, {}, 64, 48);
  const RenderLight directional = builder.scene.lights[0];
  builder.scene.lights = {directional};
  EXPECT_EQ(all.rgb, drawn(builder, {}, 64, 48).rgb);
}

TEST_F(Realtime, ActionUsesAllTypesButAreaLights) {
  SceneBuilder builder = everything();
  RealtimeOptions action;
  action.milestone = Milestone::action;
  const Texture all = drawn(builder, action, 64, 48);
  builder.scene.lights.pop_back();
  EXPECT_EQ(all.rgb, drawn(builder, action, 64, 48).rgb);
  builder.scene.lights.pop_back();
  EXPECT_NE(all.rgb, drawn(builder, action, 64, 48).rgb);
}

SceneBuilder wall(const glm::vec3& color) {
  SceneBuilder builder;
  builder.add(Shape::cube, place({0, 0, -12}, 20), builder.glowing(color));
  return builder;
}

glm::vec3 middle(const Texture& picture) {
  const std::uint8_t* const p = picture.texel(picture.width / 2, picture.height / 2);
  return glm::vec3(p[0], p[1], p[2]) / 255.0f;
}

TEST_F(Realtime, FiltersOfOneColor) {
  const glm::vec3 color(0.8f, 0.4f, 0.2f);
  const SceneBuilder builder = wall(color);
  const auto filtered = [&](Filter filter) {
    RealtimeOptions realtime;
    realtime.filter = filter;
    return middle(drawn(builder, realtime));
  };
  const float gray = 0.299f * 0.8f + 0.587f * 0.4f + 0.114f * 0.2f;
  EXPECT_LT(glm::length(filtered(Filter::none) - color), 0.5 * byte);
  EXPECT_LT(glm::length(filtered(Filter::invert) - (1.0f - color)), 0.5 * byte);
  EXPECT_LT(glm::length(filtered(Filter::grayscale) - glm::vec3(gray)), 2 * byte);
  EXPECT_LT(glm::length(filtered(Filter::blur) - color), 0.5 * byte);
  EXPECT_LT(glm::length(filtered(Filter::sharpen) - color), 0.5 * byte);
}

TEST_F(Realtime, ActionShowsTheSceneAtTheLowerLeft) {
  RealtimeOptions action;
  action.milestone = Milestone::action;
  action.filter = Filter::invert;
  const Texture picture = drawn(wall(glm::vec3(1)), action, 1024, 768);
  const auto red = [&](int x, int y) { return int(picture.texel(x, y)[0]); };
  EXPECT_EQ(red(0, 767), 0);
  EXPECT_EQ(red(959, 48), 0);
  EXPECT_EQ(red(961, 400), 255) << "the background is inverted, too";
  EXPECT_EQ(red(400, 45), 255);
}

TEST_F(Realtime, PickingFindsWhatThePictureShows) {
  const SceneBuilder builder = everything();
  Drawing drawing = uploaded(builder);
  DrawOptions options;
  for (const Milestone milestone : {Milestone::lights_camera, Milestone::action}) {
    options.realtime.emplace();
    options.realtime->milestone = milestone;
    options.mode = DrawMode::object_id;
    const Image ids = *draw_image(*device, drawing, builder.scene.camera, options, 96, 72);
    for (int y = 1; y < 71; y += 5) {
      for (int x = 1; x < 95; x += 5) {
        bool even = true;  // whether the neighboring pixels show the same object
        for (int i = 0; i < 9; ++i) {
          even = even && at(ids, x + i % 3 - 1, y + i / 3 - 1) == at(ids, x, y);
        }
        if (even) {
          const auto found =
              object_at(*device, drawing, builder.scene.camera, options, 96, 72, x, y);
          EXPECT_EQ(found.has_value(), at(ids, x, y) != glm::vec3(0)) << x << ' ' << y;
        }
      }
    }
  }
}

TEST_F(Realtime, CountsItsTriangles) {
  SceneBuilder builder;
  builder.add(Shape::sphere, place({0, 0, -3}), builder.glowing(glm::vec3(1)));
  builder.add(Shape::cube, place({0, 1, -3}), 0);
  drawn(builder, {{4, 7}, 0.1, 100});
  EXPECT_EQ(stats.triangles, 7u * (2 * 4 - 2) + 12 * 4 * 4);
  drawn(builder, {{4, 7}, 0.1, 100}, 32, 32, DrawMode::wireframe);
  EXPECT_EQ(stats.triangles, 7u * (2 * 4 - 2) + 12 * 4 * 4);
}

// The pixels next to an edge reveal the weights of the kernels.
TEST_F(Realtime, FilterKernels) {
  SceneBuilder builder;
  // The left half is lit, up to the center of the picture.
  builder.add(Shape::cube, place({-10, 0, -12}, 20), builder.glowing(glm::vec3(1)));
  RealtimeOptions realtime;
  realtime.filter = Filter::blur;
  const Texture blurred = drawn(builder, realtime);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(blurred.texel(13 + i, 16)[0] / 255.0, std::clamp((5 - i) / 5.0, 0.0, 1.0), byte)
        << i;
  }
  builder.scene.materials[0].ambient = glm::vec3(0.4f);
  realtime.filter = Filter::sharpen;
  const Texture sharp = drawn(builder, realtime);
  EXPECT_NEAR(sharp.texel(14, 16)[0] / 255.0, 0.4, byte);
  EXPECT_NEAR(sharp.texel(15, 16)[0] / 255.0, 0.4 + 0.4 / 3, byte);
  EXPECT_EQ(sharp.texel(16, 16)[0], 0);
}

}  // namespace

}  // namespace scenefile
