// Compares ray differentials with the rays of neighboring pixels.

#include "scenefile/trace/adaptive_sampler.h"
#include "scenefile/trace/edges.h"
#include "trace/build_scene.h"
#include "trace/scalar_rays.h"
#include "trace/scalar_surface.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>

namespace scenefile::trace_test {
namespace {

constexpr double step = 1e-4;  // pixels

struct Bent {
  glm::dvec3 position;
  glm::dvec2 uv;
  glm::dvec3 normal;
  glm::dvec3 mirrored;
  glm::dvec3 refracted;
};

// A shape in front of the camera, and the path of a ray through it.
struct OneShape {
  SceneBuilder b;
  Shape shape;
  DAffine object_from_world;
  CameraRays camera;

  OneShape(Shape s, const Affine& world_from_object, double aperture)
      : shape(s), object_from_world(inverse(DAffine(world_from_object))), camera({}, 64, 48) {
    b.material({});
    b.look({0.3f, 0.2f, 4}, {0, 0, 0});
    b.scene.camera.aperture = aperture;
    b.scene.camera.focal_length = aperture > 0 ? 3 : 0;
    camera = CameraRays(b.scene.camera, 64, 48);
  }

  std::optional<SurfacePoint> point_of(const Ray& ray) const {
    const Ray local{object_from_world.point(ray.origin), object_from_world.linear * ray.direction};
    ShapeHit found;
    if (!intersect(shape, local, 0, 1e9, found)) {
      return std::nullopt;
    }
    Hit hit;
    hit.t = found.t;
    hit.shape = shape;
    hit.face = found.face;
    hit.object_from_world = object_from_world;
    hit.object_point = local.origin + found.t * local.direction;
    return surface_point(b.scene, b.assets, ray, hit, true);
  }

  static Bent bend(const Ray& ray, const SurfacePoint& p) {
    Bent bent{p.position, p.object.uv, p.normal, reflect_direction(ray.direction, p.normal), {}};
    refract_direction(ray.direction, p.normal, 1 / 1.5, bent.refracted);
    return bent;
  }
};

void expect_near(const glm::dvec3& expected, const glm::dvec3& step_found, const char* what) {
  const double size = std::max(glm::length(expected), 1e-3);
  EXPECT_LT(glm::length(step_found - expected), 2e-2 * size)
      << what << ": " << expected.x << " " << expected.y << " " << expected.z << ", not "
      << step_found.x << " " << step_found.y << " " << step_found.z;
}

void expect_as_neighbor(const OneShape& scene, const glm::dvec2& pixel, const glm::dvec2& lens,
                        int& compared) {
  const Ray ray = scene.camera.ray(pixel, lens);
  const std::optional<SurfacePoint> point = scene.point_of(ray);
  const Ray beside = scene.camera.ray(pixel + glm::dvec2(step, 0), lens);
  const Ray below = scene.camera.ray(pixel + glm::dvec2(0, step), lens);
  const RayDifferential from_camera = camera_differential(scene.camera, pixel, lens, 1);
  expect_near((beside.direction - ray.direction) / step, from_camera.direction.dx, "camera, right");
  expect_near((below.direction - ray.direction) / step, from_camera.direction.dy, "camera, down");
  const std::optional<SurfacePoint> point_beside = scene.point_of(beside);
  // Edges, and grazing angles, where derivatives are limited.
  if (!point || !point_beside || point->hit.face != point_beside->hit.face ||
      -glm::dot(point->normal, ray.direction) < 0.2) {
    return;
  }
  ++compared;
  const Bent here = OneShape::bend(ray, *point);
  const Bent there = OneShape::bend(beside, *point_beside);
  const PixelDerivatives dp = hit_derivatives(from_camera, ray.direction, *point);
  expect_near((there.position - here.position) / step, dp.dx, "position");
  expect_near((there.normal - here.normal) / step, normal_derivatives(*point, dp).dx, "normal");
  const UvFootprint uv = uv_footprint(*point, dp);
  expect_near(glm::dvec3((there.uv - here.uv) / step, 0), glm::dvec3(uv.right, 0), "uv");
  const RayDifferential mirrored =
      mirrored_differential(from_camera, ray.direction, *point, dp, point->normal);
  expect_near((there.mirrored - here.mirrored) / step, mirrored.direction.dx, "mirrored");
  EXPECT_EQ(mirrored.origin.dx, dp.dx);
  const RayDifferential refracted =
      refracted_differential(from_camera, ray.direction, *point, dp, point->normal, 1 / 1.5);
  expect_near((there.refracted - here.refracted) / step, refracted.direction.dx, "refracted");
}

class Footprint : public testing::TestWithParam<Shape> {};

TEST_P(Footprint, AgreesWithTheNeighboringPixels) {
  std::mt19937 random(static_cast<unsigned>(GetParam()) + 1);
  const auto in = [&](double low, double high) {
    return low + (high - low) * double(random() % 10001) / 10000;
  };
  int compared = 0;
  for (int i = 0; i < 150; ++i) {
    const Affine place = rotate(float(in(0, 360)), {1, 0.7f, float(in(-1, 1))}) *
                         scale({float(in(0.7, 2)), float(in(0.7, 2)), float(in(0.7, 2))});
    const bool lens = i % 3 == 0;
    const OneShape scene(GetParam(), place, lens ? 0.1 : 0);
    expect_as_neighbor(scene, {in(22, 42), in(14, 34)},
                       lens ? glm::dvec2(in(-1, 1), in(-1, 1)) : glm::dvec2(0), compared);
  }
  EXPECT_GT(compared, 20);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Footprint,
                         testing::Values(Shape::cube, Shape::sphere, Shape::cylinder, Shape::cone));

TEST(Edges, TheLargestContrastOfEightNeighbors) {
  std::mt19937 random(3);
  for (const auto& [width, height] :
       {std::pair(1, 1), std::pair(7, 1), std::pair(1, 40), std::pair(37, 35)}) {
    Image image(width, height);
    for (float& value : image.rgb) {
      value = float(random() % 1000) / 700 - 0.1f;
    }
    std::vector<std::uint16_t> surfaces(std::size_t(width) * height);
    for (std::uint16_t& surface : surfaces) {
      surface = static_cast<std::uint16_t>(random() % 2);
    }
    int rows = 0;
    std::vector<Contrast> found(std::size_t(width) * height);
    std::vector<int> seen(static_cast<std::size_t>(height));
    for_each_row_of_contrasts(image, surfaces,
                              [&, width = width](int y, const RowOfContrasts& row) {
                                for (std::size_t x = 0; x < row.most.size(); ++x) {
                                  found[std::size_t(y) * width + x] = {row.most[x], row.edges[x]};
                                }
                                seen[std::size_t(y)] = 1;
                              });
    for (const int s : seen) {
      rows += s;
    }
    EXPECT_EQ(rows, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        Contrast expected;
        for (int y1 = std::max(0, y - 1); y1 <= std::min(y + 1, height - 1); ++y1) {
          for (int x1 = std::max(0, x - 1); x1 <= std::min(x + 1, width - 1); ++x1) {
            const bool one_surface =
                surfaces[std::size_t(y) * width + x] == surfaces[std::size_t(y1) * width + x1];
            raise(expected, image.pixel(x, y), image.pixel(x1, y1), one_surface);
          }
        }
        const Contrast& contrast = found[std::size_t(y) * width + x];
        EXPECT_EQ(contrast.most, expected.most) << x << " " << y;
        EXPECT_EQ(contrast.edges, expected.edges) << x << " " << y;
      }
    }
  }
}

TEST(SamplePlan, StartsAtTheCenterUnlessMoreSamplesAreRequested) {
  RenderOptions options;
  const auto plan = [&](NoiseSource noise_source = NoiseSource::none) {
    return sample_plan(options, noise_source);
  };
  EXPECT_TRUE(plan().two_passes);
  EXPECT_FALSE(plan(NoiseSource::area_lights).centers_first);
  EXPECT_FALSE(plan(NoiseSource::area_lights).two_passes);
  EXPECT_FALSE(plan(NoiseSource::lens).centers_first);
  EXPECT_TRUE(plan(NoiseSource::lens).two_passes);
  EXPECT_LT(plan(NoiseSource::lens).first, plan(NoiseSource::lens).most);
  EXPECT_EQ(plan(NoiseSource::strong_lens).first, plan(NoiseSource::strong_lens).most);
  EXPECT_FALSE(plan(NoiseSource::strong_lens).two_passes);
  options.samples = 1;
  EXPECT_TRUE(plan().centers_first);
  EXPECT_FALSE(plan().two_passes);
  options.samples = 16;
  options.min_samples = 2;
  EXPECT_FALSE(plan().centers_first);
  EXPECT_EQ(plan().first, 2u);
  options.min_samples = 16;
  EXPECT_FALSE(plan(NoiseSource::lens).two_passes);
  options.min_samples = 1;
  options.samples = 4096;
  EXPECT_GT(plan().first, 32u) << "all pixels of a picture to be exact";
}

}  // namespace
}  // namespace scenefile::trace_test
