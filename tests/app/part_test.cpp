// Parts: merging gives the same bytes as a single process, and rejects everything else.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct PartTest : ::testing::Test {
  PartTest() {
    folder.write("scene.xml", good_scene);
    std::filesystem::create_directory(folder.path("parts"));
  }

  ProgramRun run(const Words& words) const { return run_program(words, {.folder = folder.path()}); }

  ProgramRun part(int number, int count, const Words& more = {}) const {
    return run(Words{"render", "scene.xml", "--size", "70x50", "-o",
                     "parts/" + std::to_string(number) + ".part", "--part",
                     std::to_string(number) + "/" + std::to_string(count)} +
               more);
  }

  void draw_parts(int count, const Words& more = {}) const {
    for (int number = 1; number <= count; ++number) {
      const ProgramRun done = part(number, count, more);
      ASSERT_EQ(done.status, 0) << done.err;
    }
  }

  TempFolder folder;
};

// Both profiles, layers, denoising and crops, in all formats.
TEST_F(PartTest, MergeToTheBytesOfOneProcess) {
  struct Case {
    int count;
    Words options;
    Words files;  // the output first
  };
  const std::vector<Case> cases{
      {1, {}, {"out.png"}},
      {3, {"--profile", "course", "--mode", "intersect"}, {"out.pfm"}},
      {5,
       {"--aov", "depth,light-1,object-id", "--denoise"},
       {"out.png", "out.depth.png", "out.light-1.png", "out.object-id.png"}},
      {4, {"--aov", "depth,normal,object-id,shadow"}, {"out.exr"}},
      {40, {"--crop", "5,6,69,41", "--samples", "4"}, {"out.exr"}},
  };
  for (const auto& [count, options, files] : cases) {
    SCOPED_TRACE(files.front() + " of " + std::to_string(count));
    std::filesystem::remove_all(folder.path("parts"));
    std::filesystem::create_directory(folder.path("parts"));
    ASSERT_EQ(
        run(Words{"render", "scene.xml", "--size", "70x50", "-o", files.front()} + options).status,
        0);
    std::vector<std::string> whole;
    for (const std::string& file : files) {
      whole.push_back(folder.read(file));
      std::filesystem::remove(folder.path(file));
    }
    draw_parts(count, options);
    const ProgramRun merged = run({"merge", "parts", "-o", files.front()});
    ASSERT_EQ(merged.status, 0) << merged.err;
    for (std::size_t i = 0; i < files.size(); ++i) {
      EXPECT_TRUE(folder.read(files[i]) == whole[i]) << files[i];
    }
  }
}

TEST_F(PartTest, ExistingPartsAreSkipped) {
  ASSERT_EQ(part(2, 3).status, 0);
  const std::string bytes = folder.read("parts/2.part");
  const auto written = std::filesystem::last_write_time(folder.path("parts/2.part"));
  const ProgramRun again = part(2, 3, {"--json"});
  EXPECT_EQ(again.status, 0);
  const rapidjson::Document answer = parse_json(again.out);
  EXPECT_TRUE(answer["part"]["skipped"].GetBool());
  EXPECT_EQ(answer["part"]["number"].GetInt(), 2);
  EXPECT_EQ(answer["part"]["count"].GetInt(), 3);
  EXPECT_EQ(std::filesystem::last_write_time(folder.path("parts/2.part")), written);
  EXPECT_EQ(folder.read("parts/2.part"), bytes);
}

TEST_F(PartTest, PartsOfOtherPicturesAreRejected) {
  ASSERT_EQ(part(2, 3).status, 0);
  const std::string bytes = folder.read("parts/2.part");
  const auto expect_refused = [&](const ProgramRun& refused, const std::string& why) {
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr(why));
    EXPECT_EQ(folder.read("parts/2.part"), bytes);
  };
  expect_refused(part(2, 3, {"--samples", "3"}), "with other options; remove the file");
  expect_refused(part(2, 4), "it is part 2 of 3, not 2 of 4");
  folder.write("scene.xml", std::string(good_scene) + "\n");
  expect_refused(part(2, 3), "another scene, or the scene was changed");
}

TEST_F(PartTest, NoOtherFileIsReplaced) {
  folder.write("parts/2.part", "my notes");
  const ProgramRun refused = part(2, 3);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("not a part"));
  EXPECT_EQ(folder.read("parts/2.part"), "my notes");
}

TEST_F(PartTest, ADamagedPartIsDrawnAgain) {
  ASSERT_EQ(part(2, 3).status, 0);
  const std::string bytes = folder.read("parts/2.part");
  std::string changed = bytes;
  changed[bytes.size() - 9] ^= 4;
  for (const std::string& damaged : {bytes.substr(0, bytes.size() / 2), changed, std::string()}) {
    folder.write("parts/2.part", damaged);
    EXPECT_EQ(part(2, 3).status, 0);
    EXPECT_TRUE(folder.read("parts/2.part") == bytes);
  }
}

TEST_F(PartTest, MergeListsErrorsAndWritesNothing) {
  draw_parts(4);
  ASSERT_EQ(run({"render", "scene.xml", "--size", "70x50", "-o", "parts/foreign", "--part", "1/4",
                 "--samples", "3"})
                .status,
            0);
  std::filesystem::remove(folder.path("parts/3.part"));
  folder.write("parts/2.part", folder.read("parts/2.part").substr(0, 500));
  folder.write("parts/4b.part", folder.read("parts/4.part"));
  folder.write("parts/notes.txt", "mine");
  const ProgramRun merged = run({"merge", "parts", "-o", "out.png"});
  EXPECT_EQ(merged.status, 1);
  EXPECT_THAT(merged.err, HasSubstr("parts/2.part (part 2 of 4): the part is truncated"));
  EXPECT_THAT(merged.err, HasSubstr("parts/4b.part (part 4 of 4): the same part as parts/4.part"));
  EXPECT_THAT(merged.err, HasSubstr("parts/foreign (part 1 of 4): drawn with other options"));
  EXPECT_THAT(merged.err, HasSubstr("missing: 2 of 4: 2, 3"));
  EXPECT_THAT(folder.list(), ElementsAre("parts", "scene.xml"));

  const ProgramRun missing = run({"merge", "parts", "--missing"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(missing.out, "2\n3\n");
  const rapidjson::Document answer =
      parse_json(run({"merge", "parts", "-o", "out.png", "--json"}).out);
  EXPECT_EQ(answer["parts"].GetInt(), 4);
  EXPECT_EQ(answer["missing"][1].GetInt(), 3);
  EXPECT_EQ(answer["damaged"][0]["number"].GetInt(), 2);
  EXPECT_EQ(answer["doubled"][0]["number"].GetInt(), 4);
  EXPECT_EQ(answer["foreign"].Size(), 1U);
  EXPECT_FALSE(answer["written"].GetBool());
}

TEST_F(PartTest, NothingIsMissingFromACompleteSet) {
  draw_parts(2);
  const ProgramRun missing = run({"merge", "parts", "--missing"});
  EXPECT_EQ(missing.status, 0);
  EXPECT_EQ(missing.out, "");
  EXPECT_THAT(missing.err, IsEmpty());
}

TEST_F(PartTest, UsageErrorsAreReportedImmediately) {
  draw_parts(2, {"--aov", "depth"});
  EXPECT_EQ(run({"merge", "parts"}).status, 2);
  EXPECT_EQ(run({"merge", "parts", "-o", "out.pfm"}).status, 2);
  EXPECT_EQ(run({"merge", "parts", "-o", "out.jpg"}).status, 2);
  EXPECT_EQ(run({"merge", "parts", "-o", "no/such/out.png"}).status, 3);
  EXPECT_EQ(run({"merge", "none.part", "-o", "out.png"}).status, 3);
  EXPECT_EQ(run({"merge", ".", "-o", "out.png"}).status, 1);
  EXPECT_EQ(run({"merge", "scene.xml", "-o", "out.png"}).status, 1);
  for (const char* const wrong : {"0/3", "4/3", "1", "1/0", "1/2/3", "-1/3", "1/1000001"}) {
    EXPECT_EQ(run({"render", "scene.xml", "-o", "p", "--part", wrong}).status, 2) << wrong;
  }
  EXPECT_THAT(folder.list(), ElementsAre("parts", "scene.xml"));
}

TEST_F(PartTest, AKilledMergeLeavesNoOutput) {
  draw_parts(2, {"--size", "1200x900", "--samples", "1"});
  for (const int delay_ms : {1, 5, 20, 60}) {
    const ProgramRun killed =
        run_program({"merge", "parts", "-o", "out.exr"},
                    {.folder = folder.path(), .signal = SIGTERM, .delay_ms = delay_ms});
    EXPECT_EQ(std::filesystem::exists(folder.path("out.exr")), killed.status == 0);
    std::filesystem::remove(folder.path("out.exr"));
    EXPECT_THAT(folder.list(), ElementsAre("parts", "scene.xml"));
  }
}

}  // namespace
}  // namespace scenefile
