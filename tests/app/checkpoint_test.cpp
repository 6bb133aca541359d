// Interrupted renders.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A scene with soft shadows everywhere.
constexpr const char* slow_scene = R"(<scenefile>
  <globaldata>
    <ambientcoeff v="0.5"/> <diffusecoeff v="0.5"/> <specularcoeff v="0.5"/>
  </globaldata>
  <cameradata>
    <pos x="0" y="2" z="4"/> <focus x="0" y="0" z="0"/> <up x="0" y="1" z="0"/>
    <heightangle v="40"/>
  </cameradata>
  <lightdata>
    <id v="0"/> <type v="area"/> <color r="1" g="1" b="1"/> <position x="0" y="5" z="0"/>
    <direction x="0" y="-1" z="0"/> <function v1="1" v2="0" v3="0"/> <width v="6"/> <height v="6"/>
  </lightdata>
  <object type="tree" name="root">
    <transblock> <object type="primitive" name="sphere"/> </transblock>
    <transblock>
      <translate x="0" y="-1" z="0"/> <scale x="9" y="1" z="9"/>
      <object type="primitive" name="cube"/>
    </transblock>
  </object>
</scenefile>
)";

// A render that takes much longer than the tests do.
std::vector<std::string> long_render(const std::string& seed = "0") {
  return {"render",    "s.xml", "-o",           "out.png", "--size",        "1600x1200",
          "--threads", "1",     "--samples",    "256",     "--min-samples", "256",
          "--seed",    seed,    "--checkpoint", "ck"};
}

// When to interrupt. With sanitizers, the grace period after a signal may be too short to save the
// state; the test then waits for a regular checkpoint.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool keeps_in_grace = false;
constexpr int interrupted_after_ms = 9000;
#else
constexpr bool keeps_in_grace = true;
constexpr int interrupted_after_ms = 1500;
#endif

class CheckpointTest : public ::testing::Test {
 protected:
  CheckpointTest() { folder_.write("s.xml", slow_scene); }

  ProgramRun run(const std::vector<std::string>& words, int signal = 0, int delay_ms = 0) {
    return run_program(words, {.folder = folder_.path(), .signal = signal, .delay_ms = delay_ms});
  }

  // Interrupts a render so that it leaves a checkpoint.
  void interrupt() {
    const ProgramRun cut = run(long_render(), SIGTERM, interrupted_after_ms);
    ASSERT_EQ(cut.status, 143) << cut.err;
    ASSERT_THAT(folder_.list(), ElementsAre("ck", "s.xml"));
  }

  TempFolder folder_;
};

TEST_F(CheckpointTest, AnInterruptedRenderContinues) {
  interrupt();
  const ProgramRun again = run(long_render(), SIGTERM, interrupted_after_ms);
  EXPECT_EQ(again.status, 143);
  if (keeps_in_grace) {
    EXPECT_THAT(again.err, HasSubstr("the same command continues from the checkpoint"));
  }
  EXPECT_THAT(folder_.list(), ElementsAre("ck", "s.xml"));
}

TEST_F(CheckpointTest, NeverReplacesOtherFiles) {
  const auto words = [](const std::string& checkpoint) {
    return std::vector<std::string>{"render", "s.xml",        "-o",       "out.png",   "--size",
                                    "8x8",    "--checkpoint", checkpoint, "--preview", "./ck.png"};
  };
  for (const std::string name : {"out.png", "./out.png", "s.xml", "ck.png", "-"}) {
    const ProgramRun refused = run(words(name));
    EXPECT_EQ(refused.status, 2) << name;
    EXPECT_EQ(refused.out, "");
    EXPECT_THAT(folder_.list(), ElementsAre("s.xml"));
  }
  EXPECT_EQ(run(words("ck")).status, 0);
  EXPECT_THAT(folder_.list(), ElementsAre("ck.png", "out.png", "s.xml"));
}

TEST_F(CheckpointTest, IsRemovedAtTheEnd) {
  const std::vector<std::string> words{"render", "s.xml", "-o",           "out.png",
                                       "--size", "8x8",   "--checkpoint", "ck"};
  ASSERT_EQ(run(words).status, 0);
  EXPECT_THAT(folder_.list(), ElementsAre("out.png", "s.xml"));
}

TEST_F(CheckpointTest, CheckpointsOfOtherRendersAreRejected) {
  interrupt();
  const std::string good = folder_.read("ck");
  const ProgramRun other_options = run(long_render("1"));
  EXPECT_EQ(other_options.status, 1);
  EXPECT_THAT(other_options.err,
              HasSubstr("ck: the checkpoint was written with other options; remove"));

  folder_.write("ck", good.substr(0, good.size() / 2));
  EXPECT_THAT(run(long_render()).err, HasSubstr("ck: the checkpoint is truncated"));

  std::string damaged = good;
  damaged[good.size() / 3] ^= 1;
  folder_.write("ck", damaged);
  const ProgramRun torn = run(long_render());
  EXPECT_EQ(torn.status, 1);
  EXPECT_THAT(torn.err, HasSubstr("its checksum is wrong"));

  folder_.write("ck", good);
  folder_.write("s.xml", std::string(slow_scene) + "\n");
  EXPECT_THAT(run(long_render()).err, HasSubstr("from another scene, or the scene was changed"));
  EXPECT_EQ(folder_.read("ck"), good);
}

TEST_F(CheckpointTest, UnwritablePathsAreReportedImmediately) {
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
