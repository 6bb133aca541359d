// The store of render: the same bytes as one process without it, and nothing is lost.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

struct Store : ProgramFolder {
  Store() { folder.write("scene.xml", good_scene); }
  void SetUp() override {
    if (SCENEFILE_OPENEXR == 0) {
      GTEST_SKIP() << "this build has no OpenEXR";
    }
  }

  ProgramRun render(const Words& more) const {
    return program(Words{"render", "scene.xml", "--size", "70x90"} + more);
  }
  ProgramRun store(const Words& more) const { return render(Words{"--store", "bands"} + more); }
  ProgramRun share(int number, int count, const Words& more = {}) const {
    return store(Words{"--part", std::to_string(number) + "/" + std::to_string(count)} + more);
  }
  void draw_shares(int count, const Words& more = {}) const {
    for (int number = count; number >= 1; --number) {
      const ProgramRun done = share(number, count, more);
      ASSERT_EQ(done.status, 0) << done.err;
    }
  }
  std::vector<std::string> bands() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path("bands"))) {
      names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  void forget() const { fs::remove_all(folder.path("bands")); }
};

// Both profiles, layers, denoising, paths and crops, in all formats.
TEST_F(Store, GivesTheBytesOfOneProcess) {
  struct Case {
    std::vector<int> counts;  // of shares, one set after the other
    Words options;
    Words files;  // the output first
  };
  const std::vector<Case> cases{
      {{}, {}, {"out.png"}},
      {{3}, {"--profile", "course", "--mode", "intersect"}, {"out.pfm"}},
      {{5},
       {"--aov", "depth,light-1,object-id", "--denoise"},
       {"out.png", "out.depth.png", "out.light-1.png", "out.object-id.png"}},
      {{4, 6}, {"--aov", "depth,normal,object-id,shadow"}, {"out.exr"}},
      {{40}, {"--crop", "5,6,69,81", "--samples", "4"}, {"out.exr"}},
      {{2, 3}, {"--mode", "path", "--samples", "4", "--exposure", "0.3"}, {"out.png"}},
      {{2}, {"--mode", "path", "--samples", "4"}, {"out.exr"}},
  };
  for (const auto& [counts, options, files] : cases) {
    SCOPED_TRACE(files.front() + " " + std::to_string(counts.size()));
    forget();
    ASSERT_EQ(render(Words{"-o", files.front()} + options).status, 0);
    std::vector<std::string> whole;
    for (const std::string& file : files) {
      whole.push_back(folder.read(file));
    }
    for (const int count : counts) {
      draw_shares(count, options);
    }
    for (int i = 0; i < 2; ++i) {
      for (const std::string& file : files) {
        fs::remove(folder.path(file));
      }
      const ProgramRun made = store(Words{"-o", files.front()} + options);
      ASSERT_EQ(made.status, 0) << made.err;
      for (std::size_t k = 0; k < files.size(); ++k) {
        EXPECT_TRUE(folder.read(files[k]) == whole[k]) << files[k];
      }
    }
  }
}

TEST_F(Store, OneStoreServesAllFormats) {
  ASSERT_EQ(store({"-o", "a.exr"}).status, 0);
  const rapidjson::Document answer = parse_json(store({"-o", "a.png", "--json"}).out);
  EXPECT_EQ(answer["store"]["drawn"].GetInt(), 0);
  EXPECT_EQ(answer["store"]["found"].GetInt(), static_cast<int>(bands().size()));
  EXPECT_TRUE(answer["written"].GetBool());
  ASSERT_EQ(render({"-o", "b.png"}).status, 0);
  EXPECT_TRUE(folder.read("a.png") == folder.read("b.png"));
  EXPECT_EQ(store({"-o", "-"}).out, folder.read("a.png"));
}

TEST_F(Store, BandsSayWhatTheyAre) {
  ASSERT_EQ(share(2, 3).status, 0);
  ASSERT_THAT(bands(), ElementsAre("00032-00064.exr"));
  const std::string band = folder.read("bands/00032-00064.exr");
  EXPECT_THAT(band, HasSubstr("scenefile item 1: program="));
  EXPECT_THAT(band, HasSubstr(" width=70 height=90 profile=fine "));
  // Other programs show it at its place.
  ASSERT_EQ(render({"-o", "whole.exr"}).status, 0);
  const ProgramRun differs = program({"diff", "whole.exr", "bands/00032-00064.exr", "--json"});
  EXPECT_EQ(differs.status, 1);
  EXPECT_FALSE(fs::exists(folder.path("out.png")));
}

TEST_F(Store, ListsWhatIsMissing) {
  const auto missing = [&](const Words& more = {}) {
    return store(Words{"--missing", "4"} + more);
  };
  EXPECT_EQ(missing().out, "1\n2\n3\n4\n");
  EXPECT_EQ(missing().err, "");
  EXPECT_FALSE(fs::exists(folder.path("bands"))) << "nothing is made";
  ASSERT_EQ(share(2, 4).status, 0);
  EXPECT_EQ(missing({"-o", "out.png"}).out, "1\n3\n4\n");
  EXPECT_EQ(missing().status, 1);
  const ProgramRun json = missing({"--json"});
  EXPECT_EQ(json.status, 1);
  EXPECT_EQ(parse_json(json.out)["store"]["missing"][1].GetInt(), 3);
  draw_shares(2);
  EXPECT_EQ(missing().status, 0);
  EXPECT_EQ(missing().out, "");
  EXPECT_THAT(folder.list(), ElementsAre("bands", "scene.xml"));
}

TEST_F(Store, ExistingBandsAreKept) {
  draw_shares(2);
  const std::string name = "bands/" + bands().front();
  const auto written = fs::last_write_time(folder.path(name));
  const rapidjson::Document answer = parse_json(share(1, 2, {"--json"}).out);
  EXPECT_EQ(answer["store"]["drawn"].GetInt(), 0);
  EXPECT_FALSE(answer["written"].GetBool());
  EXPECT_EQ(fs::last_write_time(folder.path(name)), written);
}

TEST_F(Store, AForeignStoreIsNotTouched) {
  draw_shares(2);
  const std::string name = "bands/" + bands().front();
  const std::string bytes = folder.read(name);
  fs::remove(folder.path("bands/" + bands().back()));
  const auto refused = [&](const Words& more, const std::string& why) {
    for (const Words& words :
         {Words{"-o", "out.png"}, Words{"--part", "2/2"}, Words{"--missing", "2"}}) {
      const ProgramRun run = store(words + more);
      EXPECT_EQ(run.status, 1);
      EXPECT_EQ(run.out, "");
      EXPECT_THAT(run.err, HasSubstr(name + ": " + why));
      EXPECT_THAT(run.err, HasSubstr("; choose another folder, or remove the file\n"));
    }
    EXPECT_EQ(folder.read(name), bytes);
    EXPECT_EQ(bands().size(), 1U);
    EXPECT_FALSE(fs::exists(folder.path("out.png")));
  };
  refused({"--samples", "3"}, "it was drawn with samples = 16, not 3");
  refused({"--size", "70x91"}, "it was drawn with height = 90, not 91");
  refused({"--limit", "lights=9"}, "it was drawn with limit.lights = its default, not 9");
  folder.write("scene.xml", std::string(good_scene) + "\n");
  refused({}, "it was drawn from another scene, or the scene was changed");
  folder.write("scene.xml", good_scene);
  std::string other = bytes;
  const std::size_t program = other.find("program=") + 8;
  other[program] = other[program] == '1' ? '2' : '1';
  folder.write(name, other);
  EXPECT_EQ(share(1, 2).status, 0) << "not a foreign band, but a damaged one";
  folder.write(name, "my notes");
  EXPECT_THAT(store({"-o", "out.png"}).err, HasSubstr(name + ": it is not a band"));
  EXPECT_EQ(folder.read(name), "my notes");
}

TEST_F(Store, DamagedBandsAreDrawnAgain) {
  draw_shares(2);
  ASSERT_EQ(render({"-o", "whole.png"}).status, 0);
  const std::string name = "bands/" + bands().back();
  const std::string bytes = folder.read(name);
  std::vector<std::string> all{"",
                               bytes.substr(0, 2),
                               bytes.substr(0, 300),
                               bytes.substr(0, bytes.size() - 1),
                               bytes + "x",
                               folder.read("bands/" + bands().front())};
  for (std::size_t i = 0; i < bytes.size(); i += bytes.size() / 9) {
    all.push_back(bytes);
    all.back()[i] ^= 4;
  }
  for (const std::string& damaged : all) {
    folder.write(name, damaged);
    EXPECT_EQ(store({"--missing", "1"}).out, "1\n");
    EXPECT_EQ(store({"-o", "out.png"}).status, 0);
    EXPECT_TRUE(folder.read(name) == bytes);
    EXPECT_TRUE(folder.read("out.png") == folder.read("whole.png"));
  }
}

TEST_F(Store, OtherFilesInTheFolderStay) {
  fs::create_directory(folder.path("bands"));
  for (const char* const name : {"notes.txt", "picture.exr", "0-16.exr", "00000-00016.exr.tmp"}) {
    folder.write(std::string("bands/") + name, "mine");
  }
  EXPECT_EQ(store({"-o", "out.png"}).status, 0);
  EXPECT_EQ(folder.read("bands/picture.exr") + folder.read("bands/0-16.exr"), "minemine");
}

TEST_F(Store, AnInterruptedRenderContinues) {
  const Words words{"render",        "scene.xml", "--size",  "400x300", "--samples", "64",
                    "--threads",     "1",         "--store", "bands",   "-o",        "out.png",
                    "--min-samples", "64"};
  const ProgramRun cut =
      run_program(words, {.folder = folder.path(), .signal = SIGTERM, .delay_ms = 300});
  ASSERT_THAT(cut.status, AnyOf(143, 0)) << cut.err;
  if (cut.status == 143) {
    EXPECT_THAT(cut.err, AnyOf("", HasSubstr("interrupted; the same command continues")));
    EXPECT_FALSE(fs::exists(folder.path("out.png")));
  }
  ASSERT_EQ(program(words).status, 0);
  for (const std::string& name : bands()) {
    EXPECT_TRUE(name.ends_with(".exr")) << name;
  }
  Words plain = words;
  plain.erase(plain.begin() + 8, plain.begin() + 10);
  plain[9] = "plain.png";
  ASSERT_EQ(program(plain).status, 0);
  EXPECT_TRUE(folder.read("plain.png") == folder.read("out.png"));
}

TEST_F(Store, UsageErrorsAreReportedImmediately) {
  const std::vector<std::pair<Words, std::string>> cases{
      {{"--part", "1/2"}, "--part needs the folder of the work: --store DIR"},
      {{"--missing", "2"}, "--missing needs the folder of the work"},
      {{"--store", "b"}, "-o"},
      {{"--store", "b", "--part", "1/2", "--missing", "2"}, "choose one"},
      {{"--store", "b", "-o", "x.png", "--engine", "gl"}, "--store is for the ray tracer"},
      {{"--store", "b", "-o", "x.png", "--profile", "realtime"}, "leave it out, or --profile real"},
      {{"--store", "b", "-o", "x.png", "--mode", "path", "--time", "1"}, "cannot be combined"},
      {{"--store", "", "-o", "x.png"}, "the name is empty"},
      {{"--store", "b", "--missing", "0"}, "--missing"},
      {{"--store", "b", "-o", "x.pfm", "--aov", "depth"}, "--aov needs an output"},
      {{"--store", "b", "--part", "1/2", "--aov", "light-7"}, "the scene has no light-7"},
  };
  for (const auto& [words, why] : cases) {
    const ProgramRun refused = render(words);
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(why));
  }
  for (const char* const wrong : {"0/3", "4/3", "1", "1/0", "1/2/3", "-1/3", "1/1000001"}) {
    EXPECT_EQ(store({"--part", wrong}).status, 2) << wrong;
  }
  for (const char* const gone : {"--checkpoint", "--preview"}) {
    EXPECT_EQ(render({"-o", "x.png", gone, "y.png"}).status, 2);
  }
  EXPECT_EQ(program({"merge", "parts", "-o", "x.png"}).status, 2);
  EXPECT_THAT(folder.list(), ElementsAre("scene.xml"));
}

TEST_F(Store, AFolderThatCannotBeUsedIsAnError) {
  folder.write("file", "mine");
  for (const char* const name : {"file", "file/below"}) {
    const ProgramRun failed = render({"--store", name, "-o", "x.png"});
    EXPECT_EQ(failed.status, 3);
    EXPECT_THAT(failed.err, HasSubstr("the folder of --store"));
  }
  EXPECT_EQ(render({"--store", "b", "-o", "no/such/x.png"}).status, 3);
  EXPECT_THAT(folder.list(), ElementsAre("file", "scene.xml"));
}

TEST_F(Store, NoSpaceLosesNothing) {
  draw_shares(2);
  const std::vector<std::string> before = bands();
  fs::remove(folder.path("bands/" + before.back()));
  // The limit of file sizes has the same effect as a full disk.
  const ProgramRun full = run_program(
      {"-c", "ulimit -f 1; exec \"$0\" render scene.xml --size 70x90 --store bands -o x.png",
       SCENEFILE_PROGRAM},
      {.folder = folder.path(), .program = "/bin/sh"});
  EXPECT_EQ(full.status, 3) << full.err;
  EXPECT_THAT(full.err, HasSubstr("cannot write"));
  EXPECT_EQ(bands().size(), before.size() - 1) << "no temporary file, no part of a band";
  EXPECT_FALSE(fs::exists(folder.path("x.png")));
  EXPECT_EQ(store({"-o", "x.png"}).status, 0);
}

}  // namespace
}  // namespace scenefile
