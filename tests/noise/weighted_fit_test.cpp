#include "scenefile/noise/weighted_fit.h"

#include <gtest/gtest.h>

#include <random>

namespace scenefile {

namespace {

TEST(CriticalValue, IsSidaks) {
  EXPECT_NEAR(critical_value(0.05, 1), 1.959964, 1e-5);
  // 1 - (1 - 0.01)^(1/1000) = 1.005e-5, two-sided
  EXPECT_NEAR(critical_value(0.01, 1000), 4.4161, 1e-3);
}

TEST(WeightedFit, FindsFactorsAndTheirErrors) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  constexpr int blocks = 400;
  constexpr int runs = 200;
  double squares = 0;
  double error = 0;
  for (int run = 0; run < runs; ++run) {
    MeasuredBlocks measured{BlockColors(blocks), BlockColors(blocks)};
    BlockColors fixed(blocks), a(blocks), b(blocks);
    for (int i = 0; i < blocks; ++i) {
      fixed[i] = Color(uniform(random));
      a[i] = Color(uniform(random), uniform(random), uniform(random));
      b[i] = Color(uniform(random), uniform(random), uniform(random));
      const double deviation = 0.1 + uniform(random);
      measured.weight[i] = Color(1 / (deviation * deviation));
      const Color noise(normal(random), normal(random), normal(random));
      measured.mean[i] = fixed[i] + 0.5 * a[i] + 2.0 * b[i] + deviation * noise;
    }
    const std::array<const BlockColors*, 2> free{&a, &b};
    const BlockFit found = fit(measured, fixed, free);
    ASSERT_TRUE(found.solved);
    squares += (found.factors[0] - 0.5) * (found.factors[0] - 0.5);
    error += found.errors[0];
    EXPECT_NEAR(found.factors[1], 2, 8 * found.errors[1]);
    EXPECT_NEAR(found.chi2, 3 * blocks, 250);
  }
  // Never too small; as channels may have the same noise, up to sqrt(3) too large.
  const double actual = std::sqrt(squares / runs);
  EXPECT_GT(error / runs, 0.9 * actual);
  EXPECT_LT(error / runs, 2.1 * actual);
}

TEST(WeightedFit, IsNotSolvedForWhatTheSceneDoesNotHave) {
  const MeasuredBlocks measured{BlockColors(9, Color(1)), BlockColors(9, Color(1))};
  const BlockColors zero(9, Color(0));
  const std::array<const BlockColors*, 1> free{&zero};
  EXPECT_FALSE(fit(measured, zero, free).solved);
}

}  // namespace

}  // namespace scenefile
