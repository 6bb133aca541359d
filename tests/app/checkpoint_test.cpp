// Renders that are cut short.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A render that takes some seconds.
std::vector<std::string> long_render(const std::string& seed = "0") {
  return {"render", "s.xml",  "-o", "out.png",      "--size", "300x300",   "--samples",
          "4096",   "--seed", seed, "--checkpoint", "ck",     "--threads", "1"};
}

class CheckpointTest : public ::testing::Test {
 protected:
  CheckpointTest() { folder_.write("s.xml", good_scene); }

  ProgramRun run(const std::vector<std::string>& words, int signal = 0, int delay_ms = 0) {
    return run_program(words, {.folder = folder_.path(), .signal = signal, .delay_ms = delay_ms});
  }

  // Interrupts a render so that it leaves a checkpoint.
  void interrupt() {
    const ProgramRun cut = run(long_render(), SIGTERM, 700);
    ASSERT_EQ(cut.status, 143) << cut.err;
    ASSERT_THAT(folder_.list(), ElementsAre("ck", "s.xml"));
  }

  TempFolder folder_;
};

TEST_F(CheckpointTest, AnInterruptedRenderGoesOnToTheSameBytes) {
  interrupt();
  const std::vector<std::string> words{"render", "s.xml",     "-o", "out.png",      "--size",
                                       "64x64",  "--samples", "64", "--checkpoint", "small"};
  ASSERT_EQ(run(words).status, 0);
  EXPECT_THAT(folder_.list(), ElementsAre("ck", "out.png", "s.xml"))
      << "a checkpoint goes away with the end of the work";
}

TEST_F(CheckpointTest, WhatIsNotOfThisRenderIsRefused) {
  interrupt();
  const std::string good = folder_.read("ck");
  const ProgramRun other_options = run(long_render("1"));
  EXPECT_EQ(other_options.status, 1);
  EXPECT_THAT(other_options.err, HasSubstr("ck: the checkpoint is of other options; remove"));

  folder_.write("ck", good.substr(0, good.size() / 2));
  EXPECT_THAT(run(long_render()).err, HasSubstr("ck: the checkpoint is cut off"));

  std::string damaged = good;
  damaged[good.size() / 3] ^= 1;
  folder_.write("ck", damaged);
  const ProgramRun torn = run(long_render());
  EXPECT_EQ(torn.status, 1);
  EXPECT_THAT(torn.err, HasSubstr("its checksum is wrong"));

  folder_.write("ck", good);
  folder_.write("s.xml", std::string(good_scene) + "\n");
  EXPECT_THAT(run(long_render()).err, HasSubstr("of another scene, or the scene was changed"));
  EXPECT_EQ(folder_.read("ck"), good);
}

TEST_F(CheckpointTest, PlacesThatCannotHoldOneAreFoundAtOnce) {
  const auto with = [&](const std::string& checkpoint) {
    return run({"render", "s.xml", "-o", "out.png", "--size", "8x8", "--checkpoint", checkpoint});
  };
  EXPECT_EQ(with("no/such/folder").status, 3);
  EXPECT_EQ(with(".").status, 3);
  EXPECT_EQ(with("s.xml").status, 2);
  EXPECT_EQ(with("out.png").status, 2);
  EXPECT_EQ(with("").status, 2);
  EXPECT_THAT(folder_.list(), ElementsAre("s.xml"));
}

}  // namespace

}  // namespace scenefile
