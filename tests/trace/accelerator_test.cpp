// Compares the accelerator with testing every object.

#include "scenefile/trace/accelerator.h"

#include "scenefile/trace/scene_geometry.h"
#include "trace/build_scene.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace scenefile::trace_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Random = std::mt19937;

/// Whether there is any surface at t_min < t < t_max.
bool occluded(const Accelerator& accelerator, const Ray& ray, double t_min, double t_max) {
  return accelerator.transmittance(ray, t_min, t_max, Transmission({})) == glm::dvec3(0);
}

float between(Random& random, double low, double high) {
  return static_cast<float>(std::uniform_real_distribution<double>(low, high)(random));
}

glm::vec3 point_between(Random& random, double low, double high) {
  return {between(random, low, high), between(random, low, high), between(random, low, high)};
}

Affine random_place(Random& random) {
  const Affine turn =
      rotate(between(random, 0, 360), glm::normalize(point_between(random, 0.1, 1)));
  const Affine size = scale({between(random, 0.2, 1.5) * (random() % 4 == 0 ? -1.0f : 1.0f),
                             between(random, 0.2, 1.5), between(random, 0.2, 1.5)});
  return translate(point_between(random, -3, 3)) * turn * size;
}

Mesh tetrahedron() {
  Mesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return m;
}

// Groups that use earlier groups, with a separate material for each primitive.
SceneBuilder random_scene(Random& random) {
  SceneBuilder b;
  b.scene.groups.clear();
  const std::uint32_t mesh = b.mesh(tetrahedron());
  const int groups = 1 + int(random() % 5);
  for (int g = 0; g < groups; ++g) {
    RenderGroup group;
    const int primitives = int(random() % 12) + (g == 0 ? 1 : 0);
    for (int i = 0; i < primitives; ++i) {
      const auto shape = static_cast<Shape>(random() % 5);
      RenderMaterial m;
      m.transparent = random() % 3 == 0 ? glm::vec3(0) : point_between(random, 0.5, 1);
      RenderPrimitive p = b.primitive(shape, random_place(random), b.material(m));
      p.mesh = shape == Shape::mesh ? mesh : no_index;
      group.primitives.push_back(p);
    }
    const int instances = g == 0 ? 0 : int(random() % 6);
    for (int i = 0; i < instances; ++i) {
      group.instances.push_back(
          b.instance(static_cast<std::uint32_t>(random() % g), random_place(random)));
    }
    b.scene.groups.push_back(group);
  }
  b.scene.root = static_cast<std::uint32_t>(groups - 1);
  return b;
}

struct Found {
  double t = infinity;
  std::uint32_t material = no_index;
};

bool meet_mesh(const Mesh& mesh, const Ray& ray, double t_min, double t_max, double& t) {
  bool found = false;
  for (const auto& corners : mesh.triangles) {
    const glm::dvec3 p0(mesh.positions[corners[0]]);
    const glm::dvec3 e1 = glm::dvec3(mesh.positions[corners[1]]) - p0;
    const glm::dvec3 e2 = glm::dvec3(mesh.positions[corners[2]]) - p0;
    const glm::dvec3 h = glm::cross(ray.direction, e2);
    const double a = glm::dot(e1, h);
    const glm::dvec3 s = ray.origin - p0;
    const double u = glm::dot(s, h) / a;
    const glm::dvec3 q = glm::cross(s, e1);
    const double v = glm::dot(ray.direction, q) / a;
    const double at = glm::dot(e2, q) / a;
    if (u >= 0 && v >= 0 && u + v <= 1 && at > t_min && at < t_max) {
      t = t_max = at;
      found = true;
    }
  }
  return found;
}

// Calls visit(t, material) for the nearest hit of each object.
template <typename F>
void for_each_object(const SceneBuilder& b, std::uint32_t group, const DAffine& world_from_group,
                     const Ray& ray, double t_min, double t_max, const F& visit) {
  for (const RenderPrimitive& p : b.scene.groups[group].primitives) {
    const DAffine object = inverse(world_from_group * DAffine(p.group_from_object));
    const Ray local{object.point(ray.origin), object.vector(ray.direction)};
    ShapeHit hit;
    const bool met = p.shape == Shape::mesh
                         ? meet_mesh(b.assets.meshes[p.mesh], local, t_min, t_max, hit.t)
                         : intersect(p.shape, local, t_min, t_max, hit);
    if (met) {
      visit(hit.t, p.material);
    }
  }
  for (const RenderInstance& i : b.scene.groups[group].instances) {
    for_each_object(b, i.group, world_from_group * DAffine(i.group_from_instance), ray, t_min,
                    t_max, visit);
  }
}

// The nearest hit, with t for meshes computed by the length of the ray's direction in their space.
Found nearest_by_mesh_distance(const SceneBuilder& b, std::uint32_t group,
                               const DAffine& world_from_group, const Ray& ray, double t_min) {
  Found found;
  const auto offer = [&](double t, std::uint32_t material) {
    if (t > t_min && t < found.t) {
      found = {t, material};
    }
  };
  for (const RenderPrimitive& p : b.scene.groups[group].primitives) {
    const DAffine object = inverse(world_from_group * DAffine(p.group_from_object));
    const Ray local{object.point(ray.origin), object.vector(ray.direction)};
    const double length = glm::length(local.direction);
    ShapeHit hit;
    if (p.shape != Shape::mesh && intersect(p.shape, local, t_min, infinity, hit)) {
      offer(hit.t, p.material);
    } else if (p.shape == Shape::mesh &&
               meet_mesh(b.assets.meshes[p.mesh], local, t_min / length, infinity, hit.t)) {
      offer(hit.t * length, p.material);
    }
  }
  for (const RenderInstance& i : b.scene.groups[group].instances) {
    const Found inner = nearest_by_mesh_distance(
        b, i.group, world_from_group * DAffine(i.group_from_instance), ray, t_min);
    offer(inner.t, inner.material);
  }
  return found;
}

Found nearest(const SceneBuilder& b, const Ray& ray, double t_min, double t_max) {
  Found found;
  for_each_object(b, b.scene.root, DAffine(), ray, t_min, t_max,
                  [&](double t, std::uint32_t material) {
                    if (t < found.t) {
                      found = {t, material};
                    }
                  });
  return found;
}

Ray random_ray(Random& random, double distance) {
  const glm::dvec3 direction = glm::normalize(glm::dvec3(point_between(random, -1, 1)));
  const glm::dvec3 through(point_between(random, -4, 4));
  return {through - distance * direction, direction * (random() % 2 == 0 ? 1.0 : 3.0)};
}

// Rays that hit an edge within rounding may differ; more than a small share of them is a bug.
struct Tally {
  int rays = 0;
  int differ = 0;
  int hits = 0;
};

void compare_closest(const SceneBuilder& b, const Accelerator& accelerator, const Ray& ray,
                     double t_min, double t_max, Tally& tally) {
  const Found expected = nearest(b, ray, t_min, t_max);
  Hit hit;
  const bool found = accelerator.closest(ray, t_min, t_max, hit);
  const bool same =
      found == (expected.material != no_index) &&
      (!found || (std::abs(hit.t - expected.t) < 1e-5 && hit.material == expected.material));
  ++tally.rays;
  tally.hits += found ? 1 : 0;
  tally.differ += same ? 0 : 1;
  tally.differ += occluded(accelerator, ray, t_min, t_max) == found ? 0 : 1;
}

RC_GTEST_PROP(Accelerator, FindsWhatLookingAtEveryObjectFinds, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const SceneBuilder b = random_scene(random);
  const Accelerator accelerator(b.scene, b.assets);
  RC_ASSERT(accelerator.status() == AcceleratorStatus::ready);
  Tally tally;
  for (int i = 0; i < 300; ++i) {
    const double distance = i % 3 == 0 ? 1e4 : between(random, 0, 8);
    const Ray ray = random_ray(random, distance);
    const double length = glm::length(ray.direction);
    const double t_min = i % 2 == 0 ? 0 : (distance - 1) / length;
    const double t_max = i % 5 == 0 ? (distance + 1) / length : infinity;
    compare_closest(b, accelerator, ray, std::max(0.0, t_min), t_max, tally);
  }
  RC_ASSERT(tally.differ <= 1);
}

RC_GTEST_PROP(Accelerator, TheClosestObjectIsThatOfTheClosestHit, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const SceneBuilder b = random_scene(random);
  const Accelerator accelerator(b.scene, b.assets);
  const std::vector<Object>& root =
      accelerator.geometry().groups[accelerator.geometry().root].objects;
  for (int i = 0; i < 200; ++i) {
    const Ray ray = random_ray(random, between(random, 0, 8));
    Hit whole;
    Hit quick;
    const bool found = accelerator.closest(ray, 0, infinity, whole);
    RC_ASSERT(accelerator.closest_object(ray, 0, infinity, quick) == found);
    if (!found) {
      continue;
    }
    RC_ASSERT(quick.t == whole.t && quick.face == whole.face && quick.object == whole.object);
    const bool of_root = std::any_of(root.begin(), root.end(), [&](const Object& p) {
      return &p == whole.object && p.kind == ObjectKind::shape;
    });
    RC_ASSERT(of_root || quick.object_point == whole.object_point);
  }
}

RC_GTEST_PROP(Accelerator, MeshesMayCountByTheirOwnDistance, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const SceneBuilder b = random_scene(random);
  const Accelerator accelerator(b.scene, b.assets, {Instances::unnamed, MeshDistance::of_mesh});
  int differ = 0;
  for (int i = 0; i < 200; ++i) {
    Ray ray = random_ray(random, between(random, 0, 8));
    ray.direction = glm::normalize(ray.direction);
    const double t_min = i % 2 == 0 ? 0 : 2;
    const Found expected = nearest_by_mesh_distance(b, b.scene.root, DAffine(), ray, t_min);
    Hit hit;
    const bool found = accelerator.closest(ray, t_min, infinity, hit);
    const bool same =
        found == (expected.material != no_index) &&
        (!found || (std::abs(hit.t - expected.t) < 1e-5 && hit.material == expected.material)) &&
        occluded(accelerator, ray, t_min, infinity) == found;
    differ += same ? 0 : 1;
  }
  RC_ASSERT(differ <= 1);
}

RC_GTEST_PROP(Accelerator, LightPassesEachTransparentObjectOnce, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const SceneBuilder b = random_scene(random);
  const Accelerator accelerator(b.scene, b.assets);
  std::vector<glm::dvec3> factors;
  for (const RenderMaterial& m : b.scene.materials) {
    factors.emplace_back(m.transparent);
  }
  const Transmission transmission(factors);
  int differ = 0;
  for (int i = 0; i < 100; ++i) {
    const Ray ray = random_ray(random, 5);
    glm::dvec3 expected(1);
    for_each_object(b, b.scene.root, DAffine(), ray, 0, infinity,
                    [&](double, std::uint32_t material) { expected *= factors[material]; });
    const glm::dvec3 got = accelerator.transmittance(ray, 0, infinity, transmission);
    differ += glm::length(got - expected) < 1e-3 ? 0 : 1;
  }
  RC_ASSERT(differ <= 1);
}

TEST(Accelerator, AHitCarriesItsPlaceInObjectSpace) {
  SceneBuilder b;
  b.scene.groups.clear();
  RenderGroup inner;
  inner.primitives.push_back(b.primitive(Shape::sphere, translate({1, 0, 0}), b.material({})));
  RenderGroup outer;
  outer.instances.push_back(b.instance(0, rotate(90, {0, 0, 1}) * scale({2, 2, 2})));
  b.scene.groups = {inner, outer};
  b.scene.root = 1;
  const Accelerator accelerator(b.scene, b.assets);
  Hit hit;
  ASSERT_TRUE(accelerator.closest({{5, 2, 0}, {-1, 0, 0}}, 0, infinity, hit));
  EXPECT_NEAR(hit.t, 4, 1e-6);
  EXPECT_LT(glm::length(hit.object_point - glm::dvec3(0, -0.5, 0)), 1e-6);
  EXPECT_LT(glm::length(hit.object_from_world.point({1, 2, 0}) - hit.object_point), 1e-6);
}

TEST(Accelerator, OfEqualDistancesTheLastInTheFileIsHit) {
  SceneBuilder b;
  for (int i = 0; i < 20; ++i) {
    b.add(Shape::cube, translate({0, float(i % 7) - 3, 0}), b.glowing(glm::vec3(1)));
  }
  const std::uint32_t last = b.glowing(glm::vec3(1));
  b.add(Shape::cube, translate({0.25, 0, 0}), last);
  const Accelerator accelerator(b.scene, b.assets);
  Hit hit;
  ASSERT_TRUE(accelerator.closest({{0, 0.1, 5}, {0, 0, -1}}, 0, infinity, hit));
  EXPECT_EQ(hit.material, last);
}

TEST(Accelerator, OfEqualTrianglesTheLastInTheFileIsHit) {
  SceneBuilder b;
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, -9, 0}};
  mesh.triangles.assign(1000, {0, 1, 2});
  mesh.triangles.push_back({0, 1, 3});
  RenderPrimitive p = b.primitive(Shape::mesh, Affine(), b.material({}));
  p.mesh = b.mesh(mesh);
  b.scene.groups[0].primitives.push_back(p);
  const Accelerator accelerator(b.scene, b.assets);
  Hit hit;
  ASSERT_TRUE(accelerator.closest({{0, 0, 5}, {0, 0, -1}}, 0, infinity, hit));
  EXPECT_EQ(hit.triangle, 999u);
}

// The search's distances are in single precision, and less exact the more a ray grazes a triangle.
TEST(Accelerator, AMeshIsHitAgainByGrazingRaysThatEndThere) {
  Random random(11);
  int hits = 0;
  for (int round = 0; round < 100; ++round) {
    SceneBuilder b;
    RenderPrimitive p = b.primitive(Shape::mesh, random_place(random), b.material({}));
    p.mesh = b.mesh(tetrahedron());
    b.scene.groups[0].primitives.push_back(p);
    const Accelerator accelerator(b.scene, b.assets);
    for (int i = 0; i < 100; ++i) {
      // Near the middle of the slanted face, nearly along it.
      const float x = between(random, -0.1, 0.1);
      const float y = between(random, -0.1, 0.1);
      const glm::vec3 in_face = 1.0f / 3 + glm::vec3(x, y, -x - y);
      const glm::vec3 along = glm::vec3(y, -x, x - y) + 0.0002f;
      const glm::dvec3 target(p.group_from_object.linear * in_face + p.group_from_object.offset);
      const glm::dvec3 direction(glm::normalize(p.group_from_object.linear * along));
      const Ray ray{target - 0.01 * direction, direction};
      Hit hit;
      if (accelerator.closest(ray, 0, infinity, hit)) {
        EXPECT_TRUE(accelerator.closest_in(0, ray, 0, std::nextafter(hit.t, infinity), hit));
        ++hits;
      }
    }
  }
  EXPECT_GT(hits, 5000);
}

TEST(Accelerator, DegenerateMeshesAreNotHit) {
  SceneBuilder b;
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, 1, 0}};
  mesh.triangles.assign(1000, {0, 1, 1});
  RenderPrimitive p = b.primitive(Shape::mesh, Affine(), b.material({}));
  p.mesh = b.mesh(mesh);
  b.scene.groups[0].primitives.assign(5, p);
  const Accelerator accelerator(b.scene, b.assets);
  Hit hit;
  EXPECT_FALSE(accelerator.closest({{0, 0, 5}, {0, 0, -1}}, 0, infinity, hit));
}

TEST(Accelerator, FarAwayAndTinyIsExact) {
  SceneBuilder b;
  const glm::vec3 place(1000, 2000, 3000);
  for (int i = 0; i < 10; ++i) {
    b.add(Shape::cube, Affine{glm::mat3(1), place + glm::vec3(0, 0, 2 * i)}, b.material({}));
  }
  const Accelerator accelerator(b.scene, b.assets);
  Hit hit;
  for (const double side : {0.5 - 1e-6, 0.5 + 1e-6}) {
    const Ray ray{glm::dvec3(place) + glm::dvec3(side, 0, 1e7), {0, 0, -1}};
    EXPECT_EQ(accelerator.closest(ray, 0, infinity, hit), side < 0.5) << side;
  }
}

TEST(Accelerator, EnormousScenesAreHitLikeSmallOnes) {
  for (const float size : {1.0f, 1e10f, 1e20f, 1e30f}) {
    SceneBuilder b;
    for (int i = 0; i < 10; ++i) {
      const glm::vec3 place = size * glm::vec3(0, 0, -2 * i);
      b.add(Shape::sphere, translate(place) * scale(glm::vec3(size)), b.material({}));
    }
    RenderPrimitive p =
        b.primitive(Shape::mesh, translate(size * glm::vec3(3, 0, 0)), b.material({}));
    Mesh mesh = tetrahedron();
    for (glm::vec3& corner : mesh.positions) {
      corner *= size;
    }
    p.mesh = b.mesh(mesh);
    b.scene.groups[0].primitives.push_back(p);
    const Accelerator accelerator(b.scene, b.assets);
    const double s = size;
    Hit hit;
    ASSERT_TRUE(accelerator.closest({{0, 0.25 * s, 5 * s}, {0, 0, -1}}, 0, infinity, hit)) << size;
    EXPECT_NEAR(hit.t / s, 5 - std::sqrt(0.1875), 1e-6) << size;
    ASSERT_TRUE(accelerator.closest({{3.25 * s, 0.25 * s, 5 * s}, {0, 0, -1}}, 0, infinity, hit))
        << size;
    EXPECT_NEAR(hit.t / s, 4.5, 1e-6) << size;
    EXPECT_FALSE(occluded(accelerator, {{0, 0.6 * s, 5 * s}, {0, 0, -1}}, 0, infinity)) << size;
  }
}

TEST(Accelerator, RaysThatAreNotFiniteHitNothing) {
  SceneBuilder b;
  b.add(Shape::sphere, scale(glm::vec3(100)), b.material({}));
  const Accelerator accelerator(b.scene, b.assets);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Hit hit;
  EXPECT_FALSE(accelerator.closest({{nan, 0, 0}, {0, 0, 1}}, 0, infinity, hit));
  EXPECT_FALSE(accelerator.closest({{0, 0, 0}, {0, infinity, 1}}, 0, infinity, hit));
  EXPECT_FALSE(accelerator.closest({{0, 0, 0}, {0, 0, 0}}, 0, infinity, hit));
  EXPECT_FALSE(occluded(accelerator, {{0, 0, 0}, {0, nan, 0}}, 0, infinity));
}

TEST(Accelerator, NothingToHit) {
  SceneBuilder b;
  RenderPrimitive p = b.primitive(Shape::mesh, Affine(), b.material({}));
  p.mesh = b.mesh({});
  b.scene.groups[0].primitives.push_back(p);
  const Accelerator missing_mesh(b.scene, b.assets);
  Hit hit;
  EXPECT_FALSE(missing_mesh.closest({{0, 0, 5}, {0, 0, -1}}, 0, infinity, hit));
  const Accelerator no_groups(RenderScene{}, Assets{});
  EXPECT_FALSE(no_groups.closest({{0, 0, 5}, {0, 0, -1}}, 0, infinity, hit));
}

TEST(Accelerator, NoRaySlipsThroughAMesh) {
  // A closed sphere of many triangles, with rays from its center through corners and edges.
  SceneBuilder b;
  Mesh ball;
  constexpr int n = 40;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double theta = glm::pi<double>() * i / n;
      const double phi = 2 * glm::pi<double>() * j / n;
      ball.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                  std::sin(theta) * std::sin(phi));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * n + j;
      const std::uint32_t c = i * n + (j + 1) % n;
      ball.triangles.push_back({a, c, a + n});
      ball.triangles.push_back({c, c + n, a + n});
    }
  }
  RenderPrimitive p = b.primitive(Shape::mesh, translate({0.1f, 0.2f, 0.3f}), b.material({}));
  p.mesh = b.mesh(ball);
  b.scene.groups[0].primitives.push_back(p);
  const Accelerator accelerator(b.scene, b.assets);
  const glm::dvec3 middle(DAffine(p.group_from_object).offset);
  for (const auto& corners : ball.triangles) {
    const glm::dvec3 corner(ball.positions[corners[0]]);
    const glm::dvec3 edge = 0.5 * (corner + glm::dvec3(ball.positions[corners[1]]));
    for (const glm::dvec3& to : {corner, edge}) {
      Hit hit;
      ASSERT_TRUE(accelerator.closest({middle, to}, 0, infinity, hit));
      EXPECT_NEAR(hit.t, 1, 1e-5);
    }
  }
}

}  // namespace
}  // namespace scenefile::trace_test
