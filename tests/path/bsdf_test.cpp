// Sampling, evaluation and density of BSDFs agree, and obey physics.

#include "scenefile/path/bsdf.h"

#include "path/statistics.h"
#include "scenefile/trace/optics.h"

#include <numbers>
#include <string>

namespace scenefile::path_test {
namespace {

using glm::dvec3;
using std::numbers::pi;

struct Rough {
  std::string name;
  Bsdf bsdf;
};

std::vector<Rough> rough_ones() {
  const auto make = [](double kd, double ks, double n) {
    Bsdf b;
    b.diffuse = Color(kd, kd / 2, kd);
    b.glossy = Color(ks);
    b.shininess = n;
    return b;
  };
  return {{"diffuse", make(0.8, 0, 1)},
          {"glossy 0", make(0, 0.7, 0)},
          {"glossy 20", make(0, 0.7, 20)},
          {"both", make(0.4, 0.3, 7.5)},
          {"sharp", make(0.1, 0.8, 200)}};
}

Facing seen_from(double degrees, const dvec3& normal = dvec3(0, 0, 1)) {
  const double a = glm::radians(degrees);
  const dvec3 side = std::abs(normal.x) < 0.9 ? glm::normalize(glm::cross(normal, dvec3(1, 0, 0)))
                                              : dvec3(0, 1, 0);
  return facing_of(normal, normal, normal, std::cos(a) * normal + std::sin(a) * side);
}

// The sphere of directions in cells of equal solid angle.
constexpr int rows = 24;
constexpr int columns = 48;

int cell_of(const dvec3& d) {
  const double turn = std::atan2(d.y, d.x) / (2 * pi) + 0.5;
  const int row = std::min(rows - 1, static_cast<int>((d.z + 1) / 2 * rows));
  return row * columns + std::min(columns - 1, static_cast<int>(turn * columns));
}

dvec3 direction_at(double row, double column) {
  const double z = 2 * row / rows - 1;
  const double angle = (column / columns - 0.5) * 2 * pi;
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// Integrates f(direction) over each cell.
template <typename F>
std::vector<double> integrals(const F& f) {
  constexpr int steps = 24;
  std::vector<double> cells(rows * columns);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      double sum = 0;
      for (int i = 0; i < steps * steps; ++i) {
        sum += f(direction_at(row + (i / steps + 0.5) / steps, column + (i % steps + 0.5) / steps));
      }
      cells[row * columns + column] = sum / (steps * steps) * 4 * pi / (rows * columns);
    }
  }
  return cells;
}

TEST(PathBsdf, SamplesFollowTheirDensity) {
  const std::vector<double> angles{0, 40, 80};
  const double bound = sidak_bound(static_cast<int>(rough_ones().size() * angles.size()));
  for (const auto& [name, bsdf] : rough_ones()) {
    for (const double angle : angles) {
      SCOPED_TRACE(name + " seen from " + std::to_string(angle));
      const Facing facing = seen_from(angle, glm::normalize(dvec3(0.3, -0.5, 0.8)));
      constexpr int count = 100000;
      Uniform random(7);
      std::vector<double> counts(rows * columns);
      for (int i = 0; i < count; ++i) {
        const double lobe = random();
        const BsdfSample s = sample(bsdf, facing, lobe, {random(), random()});
        ASSERT_NEAR(glm::length(s.to_light), 1, 1e-9);
        ASSERT_FALSE(s.specular());
        ++counts[cell_of(s.to_light)];
      }
      std::vector<double> expected = integrals(
          [&, &bsdf = bsdf](const dvec3& d) { return count * evaluate(bsdf, facing, d).density; });
      double sum = 0;
      for (const double e : expected) {
        sum += e;
      }
      EXPECT_NEAR(sum / count, 1, 2e-3);
      EXPECT_LT(std::abs(chi_square_deviate(counts, expected)), bound);
    }
  }
}

TEST(PathBsdf, WeightsAreTheValueOverTheDensity) {
  for (const auto& [name, bsdf] : rough_ones()) {
    const Facing facing = seen_from(30);
    Uniform random(3);
    for (int i = 0; i < 1000; ++i) {
      const double lobe = random();
      const BsdfSample s = sample(bsdf, facing, lobe, {random(), random()});
      const BsdfValue value = evaluate(bsdf, facing, s.to_light);
      ASSERT_NEAR(s.density, value.density, 1e-9 * value.density) << name;
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(s.weight[c] * s.density, value.bsdf_cosine[c], 1e-9 * value.density) << name;
      }
    }
  }
}

double albedo(const Bsdf& bsdf, const Facing& facing) {
  double sum = 0;
  for (const double part :
       integrals([&](const dvec3& d) { return evaluate(bsdf, facing, d).bsdf_cosine.x; })) {
    sum += part;
  }
  return sum;
}

TEST(PathBsdf, AlbedoIsKdAndAtMostKs) {
  for (const double angle : {0.0, 45.0, 85.0}) {
    Bsdf lambert;
    lambert.diffuse = Color(0.8);
    EXPECT_NEAR(albedo(lambert, seen_from(angle)), 0.8, 1e-3);
    for (const double n : {0.0, 5.0, 60.0}) {
      Bsdf phong;
      phong.glossy = Color(0.7);
      phong.shininess = n;
      const double a = albedo(phong, seen_from(angle));
      if (angle == 0) {
        EXPECT_NEAR(a, 0.7, 2e-3) << n;
      } else {
        EXPECT_LT(a, 0.7) << n;
      }
    }
  }
}

TEST(PathBsdf, IsReciprocal) {
  Uniform random(11);
  for (const auto& [name, bsdf] : rough_ones()) {
    for (int i = 0; i < 500; ++i) {
      const auto direction = [&] {
        const double z = 0.05 + 0.95 * random();
        const double angle = 2 * pi * random();
        const double r = std::sqrt(1 - z * z);
        return dvec3(r * std::cos(angle), r * std::sin(angle), z);
      };
      const dvec3 a = direction();
      const dvec3 b = direction();
      const dvec3 up(0, 0, 1);
      const double there = evaluate(bsdf, facing_of(up, up, up, a), b).bsdf_cosine.x / b.z;
      const double back = evaluate(bsdf, facing_of(up, up, up, b), a).bsdf_cosine.x / a.z;
      ASSERT_NEAR(there, back, 1e-9 * (1 + there)) << name;
    }
  }
}

TEST(PathBsdf, NothingIsReflectedThroughTheSurface) {
  for (const auto& [name, bsdf] : rough_ones()) {
    const Facing facing = seen_from(70);
    EXPECT_EQ(evaluate(bsdf, facing, glm::normalize(dvec3(0.2, 0.3, -0.1))).bsdf_cosine, Color(0))
        << name;
    // An interpolated normal that leans toward the light does not let it through either.
    const dvec3 leaning = glm::normalize(dvec3(0.8, 0, 0.6));
    const Facing bent = facing_of(leaning, leaning, {0, 0, 1}, glm::normalize(dvec3(0.5, 0, 0.5)));
    EXPECT_EQ(evaluate(bsdf, bent, glm::normalize(dvec3(0.9, 0, -0.2))).bsdf_cosine, Color(0))
        << name;
  }
}

TEST(PathBsdf, MirrorsReflectInOneDirection) {
  Bsdf bsdf;
  bsdf.mirror = Color(0.5, 0.6, 0.7);
  const Facing facing = seen_from(35);
  const BsdfSample s = sample(bsdf, facing, 0.3, {0.1, 0.9});
  EXPECT_TRUE(s.specular());
  EXPECT_EQ(s.weight, Color(0.5, 0.6, 0.7));
  EXPECT_NEAR(glm::dot(s.to_light, facing.normal), std::cos(glm::radians(35.0)), 1e-12);
  EXPECT_NEAR(
      glm::length(s.to_light + facing.to_eye - 2 * std::cos(glm::radians(35.0)) * facing.normal), 0,
      1e-12);
  EXPECT_FALSE(is_rough(bsdf));
  EXPECT_EQ(evaluate(bsdf, facing, s.to_light).bsdf_cosine, Color(0));
}

TEST(PathBsdf, GlassReflectsByFresnelAndRefractsBySnell) {
  Bsdf bsdf;
  bsdf.glass = Color(1);
  bsdf.ior = 1.5;
  for (const bool outside : {true, false}) {
    for (const double degrees : {0.0, 20.0, 40.0, 60.0, 89.0}) {
      Facing facing = seen_from(degrees);
      facing.outside = outside;
      const double eta = outside ? 1 / 1.5 : 1.5;
      const double cosine = std::cos(glm::radians(degrees));
      const double sine = std::sin(glm::radians(degrees));
      constexpr int count = 10000;
      int reflected = 0;
      for (int i = 0; i < count; ++i) {
        const BsdfSample s = sample(bsdf, facing, (i + 0.5) / count, {0.5, 0.5});
        ASSERT_EQ(s.weight, Color(1));
        if (glm::dot(s.to_light, facing.normal) > 0) {
          ++reflected;
        } else {
          ASSERT_NEAR(glm::length(glm::cross(s.to_light, facing.normal)), eta * sine, 1e-9);
          ASSERT_LE(glm::dot(s.to_light, facing.to_eye), 0);
        }
      }
      const bool total = eta * sine >= 1;
      EXPECT_NEAR(reflected / double(count), total ? 1 : fresnel_reflectance(cosine, eta),
                  2.0 / count)
          << degrees << (outside ? " outside" : " inside");
      EXPECT_EQ(total, !outside && degrees > 41.82);
    }
  }
}

TEST(PathBsdf, FilesNormalsDecideWhatIsInside) {
  const dvec3 up(0, 0, 1);
  EXPECT_TRUE(facing_of(up, up, up, up).outside);
  EXPECT_FALSE(facing_of(up, up, up, -up).outside);
  EXPECT_TRUE(facing_of(up, up, -up, up).outside);  // wound the other way
  const Facing below = facing_of(up, up, up, -up);
  EXPECT_EQ(below.normal, -up);
  EXPECT_EQ(below.geometric, -up);
}

TEST(PathBsdf, UniformDirectionsHaveTheSameMean) {
  Bsdf both = rough_ones()[3].bsdf;
  both.mirror = Color(0.2);
  const Facing facing = seen_from(40);
  Uniform random(7);
  constexpr int count = 1 << 18;
  Color sum(0);
  Color uniform(0);
  for (int i = 0; i < count; ++i) {
    sum += sample(both, facing, random(), {random(), random()}).weight / double(count);
    const BsdfSample s = sample_uniformly(both, facing, random(), {random(), random()});
    uniform += s.weight / double(count);
    ASSERT_GT(glm::dot(s.to_light, facing.normal), 0);
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(uniform[c], sum[c], 0.01 * sum[c]) << c;
  }
}

}  // namespace
}  // namespace scenefile::path_test
