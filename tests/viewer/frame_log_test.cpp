#include "scenefile/viewer/frame_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace scenefile::viewer {

namespace {

TEST(FrameLog, TellsWaitingFromWork) {
  FrameLog log;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  log.begin();
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  log.end(false, false);
  log.begin();
  log.end(true, true);
  ASSERT_EQ(log.entries().size(), 2U);
  EXPECT_GE(log.entries()[0].at, 0.005);
  EXPECT_GE(log.entries()[0].wall, 0.03);
  EXPECT_LT(log.entries()[0].cpu, log.entries()[0].wall);
  EXPECT_GE(log.entries()[1].at, 0.035);
  EXPECT_THAT(log.text(), ::testing::MatchesRegex("at_ms\twall_ms\tcpu_ms\tdrawn\ttraced\n"
                                                  "[0-9.\t]+\t0\t0\n[0-9.\t]+\t1\t1\n"));
}

}  // namespace

}  // namespace scenefile::viewer
