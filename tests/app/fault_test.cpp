// Failures of the program's environment.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Faults : ProgramFolder {};

TEST_F(Faults, AFullStandardOutputIsStatus3) {
  const std::string scene = folder.write("s.xml", good_scene);
  const std::vector<std::vector<std::string>> all{
      {"check", scene}, {"check", "--json", scene},
      {"info", scene},  {"help"},
      {"--version"},    {"render", scene, "-o", "-", "--size", "8x8"}};
  for (const std::vector<std::string>& words : all) {
    const ProgramRun run = run_program(words, {.out_file = "/dev/full"});
    EXPECT_EQ(run.status, 3) << words[0];
    EXPECT_THAT(run.err, HasSubstr("standard output: cannot write: No space left on device"));
  }
}

TEST_F(Faults, AFullDeviceIsStatus3) {
  const std::string scene = folder.write("s.xml", good_scene);
  const ProgramRun run = run_program({"render", scene, "-o", "/dev/full", "--size", "8x8"});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("/dev/full: cannot write: No space left on device"));
}

TEST_F(Faults, AnInterruptedRenderLeavesNoOutput) {
  folder.write("s.xml", good_scene);
  folder.write("out.png", "old");
  for (const auto& [signal, status] : {std::pair(SIGINT, 130), {SIGTERM, 143}}) {
    for (const int delay : {150, 300, 600}) {
      const ProgramRun run =
          run_program({"render", "s.xml", "-o", "out.png", "--size", "8000x8000"},
                      {.folder = folder.path(), .signal = signal, .delay_ms = delay});
      EXPECT_EQ(run.status, status) << delay;
      EXPECT_EQ(folder.read("out.png"), "old");
      EXPECT_THAT(folder.list(), ElementsAre("out.png", "s.xml"));
    }
  }
}

TEST_F(Faults, EveryLongCommandStopsImmediately) {
  folder.write("s.xml", good_scene);
  std::string huge = good_scene;
  const std::string block = "<transblock><object type=\"primitive\" name=\"cube\"/></transblock>\n";
  const std::size_t at = huge.find("<transblock>");
  std::string blocks;
  for (int i = 0; i < 200'000; ++i) {
    blocks += block;
  }
  folder.write("huge.xml", huge.insert(at, blocks));
  const std::string size = "1200x900";
  for (const std::string name : {"a.png", "b.png"}) {
    ASSERT_EQ(program({"render", "s.xml", "-o", name, "--size", size, "--mode",
                       name == "a.png" ? "ray" : "normals"})
                  .status,
              0);
  }
  for (const std::string name : {"right", "mine"}) {
    std::filesystem::create_directory(folder.path(name));
    folder.write(name + "/a.png", folder.read(name == "right" ? "a.png" : "b.png"));
  }
  folder.write("right/a.xml", good_scene);
  const auto before = folder.list();
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"check", "huge.xml"},
                                             {"convert", "huge.xml", "o.json"},
                                             {"format", "huge.xml"},
                                             {"diff", "huge.xml", "s.xml"},
                                             {"diff", "a.png", "b.png", "--scene", "s.xml"},
                                             {"grade", "mine", "--references", "right"},
                                             {"explain", "huge.xml", "--pixel", "1,1"}}) {
    const ProgramRun run =
        run_program(words, {.folder = folder.path(), .signal = SIGTERM, .delay_ms = 60});
    // CPU time does not depend on what else the machine does.
    EXPECT_LT(run.cpu_to_stop, std::max(1U, std::thread::hardware_concurrency())) << words[0];
    EXPECT_THAT((std::vector{0, 1, 143}), ::testing::Contains(run.status)) << words[0];
    if (run.status == 143) {
      EXPECT_EQ(folder.list(), before) << words[0];
    }
  }
}

TEST_F(Faults, EveryCommandObeysItsTimeout) {
  std::string huge = good_scene;
  const std::string block = "<transblock><object type=\"primitive\" name=\"cube\"/></transblock>\n";
  std::string blocks;
  for (int i = 0; i < 300'000; ++i) {
    blocks += block;
  }
  folder.write("huge.xml", huge.insert(huge.find("<transblock>"), blocks));
  const auto before = folder.list();
  for (std::vector<std::string> words : std::vector<std::vector<std::string>>{
           {"check", "huge.xml"},
           {"info", "huge.xml"},
           {"convert", "huge.xml", "o.json"},
           {"convert", "huge.xml", "o.pov"},
           {"format", "huge.xml"},
           {"diff", "huge.xml", "huge.xml"},
           {"explain", "huge.xml", "--pixel", "1,1"},
           {"render", "huge.xml", "-o", "o.png"},
           {"render", "huge.xml", "-o", "o.png", "--engine=gl"}}) {
    words.insert(words.end(), {"--timeout", "0.02"});
    const ProgramRun run = program(words);
    EXPECT_EQ(run.status, 4) << words[0];
    EXPECT_THAT(run.err, HasSubstr("stopped: not finished within 0.02 s (--timeout)"));
    EXPECT_EQ(folder.list(), before) << words[0];
  }
}

TEST_F(Faults, OutOfMemoryIsStatus3) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need additional address space";
#endif
  folder.write("s.xml", good_scene);
  const ProgramRun run = run_program({"render", "s.xml", "-o", "out.png", "--size", "40000x40000"},
                                     {.folder = folder.path(), .megabytes = 1000});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("out of memory while tracing"));
  EXPECT_THAT(folder.list(), ElementsAre("s.xml"));
}

TEST_F(Faults, ThePictureDoesNotDependOnLocaleOrFolder) {
  const std::string scene = folder.write("s.xml", good_scene);
  const std::vector<std::string> words{"render", scene, "-o", "-", "--size", "20x20"};
  const std::string picture = run_program(words).out;
  EXPECT_FALSE(picture.empty());
  EXPECT_EQ(run_program(words, {.environment = {"LC_ALL=de_DE.UTF-8"}}).out, picture);
  EXPECT_EQ(run_program(words, {.folder = "/"}).out, picture);
}

}  // namespace

}  // namespace scenefile
