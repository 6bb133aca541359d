// The random choice of points on lamps.

#include "scenefile/path/lamps.h"

#include "path/rooms.h"
#include "path/statistics.h"
#include "scenefile/trace/scene_geometry.h"

#include <numbers>

namespace scenefile::path_test {
namespace {

Lamps lamps_of(const TraceScene& traced) {
  return Lamps(traced.accelerator().geometry(), traced.assets());
}

TEST(PathAlias, ChoosesByWeightAndKeepsTheRestUniform) {
  const std::vector<double> weights{3, 0, 0.5, 1, 7, 1e-6};
  const AliasTable table(weights);
  constexpr int count = 1 << 20;
  std::vector<double> chosen(weights.size());
  std::vector<double> rest(weights.size());
  for (int i = 0; i < count; ++i) {
    double u = (i + 0.5) / count;
    const std::uint32_t index = table.choose(u);
    ASSERT_TRUE(u >= 0 && u < 1);
    chosen[index] += 1;
    rest[index] += u;
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_NEAR(chosen[i] / count, weights[i] / 11.500001, 1e-5) << i;
    if (chosen[i] > 1000) {
      EXPECT_NEAR(rest[i] / chosen[i], 0.5, 1e-3) << i;
    }
  }
}

TEST(PathLamps, PointsAreUniformOnTheirTriangles) {
  Room room;
  Model model;
  const std::uint32_t m = model.material(diffuse(glm::vec3(0), glm::vec3(2)));
  model.mesh.positions = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {0, 0, 5}};
  model.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  model.materials.of_triangle = {m, m};
  room.add(model, scale({1, 2, 1}));
  const TraceScene traced(room.scene, room.assets);
  const Lamps lamps = lamps_of(traced);
  ASSERT_EQ(lamps.size(), 2u);
  const double first = 4 * 6 / 2.0;
  const double second = glm::length(glm::cross(glm::dvec3(1, 6, 0), glm::dvec3(0, 0, 5))) / 2;
  constexpr int count = 50000;
  constexpr int side = 8;
  Uniform random(5);
  std::vector<double> counts(2 * side * side);
  for (int i = 0; i < count; ++i) {
    const LampPoint p = lamps.sample({random(), random()});
    ASSERT_NEAR(p.density, 1 / (first + second), 1e-9);
    ASSERT_EQ(p.emission, Color(2));
    // Barycentric weights of the second and third corner.
    const bool on_first = std::abs(p.position.z) < 1e-9;
    const double b2 = on_first ? p.position.y / 6 : p.position.z / 5;
    const double b1 = on_first ? (p.position.x - b2) / 4 : p.position.x;
    ASSERT_TRUE(b1 > -1e-9 && b2 > -1e-9 && b1 + b2 < 1 + 1e-9);
    EXPECT_NEAR(std::abs(p.normal.z), on_first ? 1 : 0, 1e-9);
    // Folds the triangle to a square of equal areas.
    const double row = (1 - b2) * (1 - b2);
    const double column = b2 < 1 ? b1 / (1 - b2) : 0;
    const auto index = [](double x) { return std::clamp(static_cast<int>(x * side), 0, side - 1); };
    counts[(on_first ? 0 : side * side) + index(row) * side + index(column)] += 1;
  }
  std::vector<double> expected(counts.size(), count * first / (first + second) / (side * side));
  std::fill(expected.begin() + side * side, expected.end(),
            count * second / (first + second) / (side * side));
  EXPECT_LT(std::abs(chi_square_deviate(counts, expected)), sidak_bound(1));
}

TEST(PathLamps, AreChosenByPower) {
  Room room;
  Model model;
  const std::uint32_t dim = model.material(diffuse(glm::vec3(0), glm::vec3(1)));
  const std::uint32_t bright = model.material(diffuse(glm::vec3(0), glm::vec3(9)));
  const std::uint32_t dark = model.material(diffuse(glm::vec3(1)));
  model.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, dim);
  model.quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, bright);
  model.quad({0, 0, 2}, {1, 0, 0}, {0, 1, 0}, dark);
  room.add(model);
  const TraceScene traced(room.scene, room.assets);
  const Lamps lamps = lamps_of(traced);
  EXPECT_EQ(lamps.size(), 4u);
  EXPECT_NEAR(lamps.density(0, dim), 0.1, 1e-12);
  EXPECT_NEAR(lamps.density(0, bright), 0.9, 1e-12);
  EXPECT_EQ(lamps.density(0, dark), 0);
  int counted = 0;
  for (int i = 0; i < 1000; ++i) {
    const LampPoint p = lamps.sample({(i + 0.5) / 1000, 0.4});
    counted += p.position.z > 0.5 ? 1 : 0;
    EXPECT_NEAR(p.density, p.position.z > 0.5 ? 0.9 : 0.1, 1e-12);
  }
  EXPECT_NEAR(counted, 900, 2);
}

TEST(PathLamps, InstancesAreLampsOfTheirOwn) {
  Room room;
  Model model;
  model.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, model.material(diffuse(glm::vec3(0), glm::vec3(1))));
  room.add(model);
  // The group of the mesh becomes a template, used three times, twice at the same place.
  room.scene.groups.emplace_back();
  for (const glm::vec3& at : {glm::vec3(0), glm::vec3(0, 0, 3), glm::vec3(0, 0, 3)}) {
    room.scene.groups[1].instances.push_back(room.instance(0, translate(at)));
  }
  room.scene.root = 1;
  const TraceScene traced(room.scene, room.assets);
  const Lamps lamps = lamps_of(traced);
  EXPECT_EQ(lamps.size(), 4u);
  EXPECT_NEAR(lamps.density(0, 0), 0.5, 1e-12);
}

TEST(PathLamps, CoincidentCopiesShineOnce) {
  Room room;
  Model model;
  model.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, model.material(diffuse(glm::vec3(0), glm::vec3(1))));
  model.mesh.triangles.push_back(model.mesh.triangles[0]);
  model.materials.of_triangle.push_back(0);
  room.add(model);
  room.scene.groups[0].primitives.push_back(room.scene.groups[0].primitives[0]);
  const TraceScene traced(room.scene, room.assets);
  EXPECT_EQ(lamps_of(traced).size(), 2u);
}

TEST(PathLamps, MapsScaleTheirPower) {
  Room room;
  const std::uint32_t map = room.texture(2, 1, {0, 255});
  Model model;
  FaceMaterial mapped = diffuse(glm::vec3(0), glm::vec3(1));
  mapped.emission_map = map;
  model.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, model.material(mapped));
  model.quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, model.material(diffuse(glm::vec3(0), glm::vec3(1))));
  room.add(model);
  const TraceScene traced(room.scene, room.assets);
  const Lamps lamps = lamps_of(traced);
  EXPECT_NEAR(lamps.density(0, 0), 1 / 3.0, 1e-12);
  EXPECT_NEAR(lamps.density(0, 1), 2 / 3.0, 1e-12);
}

TEST(PathLamps, SceneWithoutEmissionHasNone) {
  Room room;
  Model model;
  model.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, model.material(diffuse(glm::vec3(1))));
  room.add(model);
  const TraceScene traced(room.scene, room.assets);
  EXPECT_TRUE(lamps_of(traced).empty());
}

TEST(PathLamps, ParallelogramsHaveBothHalves) {
  Room room;
  Model model;
  model.mesh.positions = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}};
  model.mesh.triangles = {{0, 1, 2}};
  model.materials.of_triangle = {model.material(diffuse(glm::vec3(0), glm::vec3(2)))};
  room.add(model);
  const TraceScene traced(room.scene, room.assets);
  Lamps lamps = lamps_of(traced);
  lamps.cover_parallelograms();
  const LampPoint p = lamps.sample({0.75, 0.5});
  EXPECT_NEAR(glm::distance(p.position, glm::dvec3(3.5, 1.5, 0)), 0, 1e-6);
  EXPECT_NEAR(p.density, 1 / 6.0, 1e-9);
}

}  // namespace
}  // namespace scenefile::path_test
