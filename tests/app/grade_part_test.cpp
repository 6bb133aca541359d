// Classes in parts: merging gives the same files as one process, and rejects everything else.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct GradePartTest : ::testing::Test {
  GradePartTest() {
    folder.write("scene.xml", good_scene);
    render("right.png", {});
    render("wrong.png", {"--mode", "normals"});
    folder.make("parts");
    folder.make("refs");
    for (const char* const name : {"ball", "other"}) {
      folder.write(std::string("refs/") + name + ".png", folder.read("right.png"));
    }
    folder.write("refs/ball.xml", good_scene);
    submit("anna", "ball", folder.read("right.png"));
    submit("anna", "other", folder.read("right.png"));
    submit("ben", "ball", folder.read("wrong.png"));
    submit("ben", "other", folder.read("right.png"));
    submit("=cleo, <b>\"", "ball", "no picture");
    folder.make("class/dan");
    submit("eve", "other", folder.read("wrong.png"));
  }

  void render(const std::string& output, const Words& more) const {
    ASSERT_EQ(run(Words{"render", "scene.xml", "--size", "32x24", "-o", output} + more).status, 0);
  }
  void submit(const std::string& student, const std::string& picture,
              const std::string& bytes) const {
    folder.make("class/" + student);
    folder.write("class/" + student + "/" + picture + ".png", bytes);
  }

  ProgramRun run(const Words& words) const { return run_program(words, {.folder = folder.path()}); }
  ProgramRun grade(const Words& more) const {
    return run(Words{"grade", "class", "--references", "refs"} + more);
  }
  ProgramRun part(int number, int count, const Words& more = {}) const {
    return grade(Words{"-o", "parts/" + std::to_string(number) + ".part", "--part",
                       std::to_string(number) + "/" + std::to_string(count)} +
                 more);
  }
  void grade_parts(int count, const Words& more = {}) const {
    std::filesystem::remove_all(folder.path("parts"));
    folder.make("parts");
    for (int number = count; number >= 1; --number) {
      const ProgramRun done = part(number, count, more);
      ASSERT_EQ(done.status, 0) << done.err;
    }
  }

  struct Folder : TempFolder {
    void make(const std::string& name) const { std::filesystem::create_directories(path(name)); }
    // All files below a folder with their contents.
    std::vector<std::string> contents(const std::string& name) const {
      std::vector<std::string> found;
      for (const auto& entry : std::filesystem::recursive_directory_iterator(path(name))) {
        if (entry.is_regular_file()) {
          const std::string file = entry.path().lexically_relative(path("")).string();
          found.push_back(file.substr(file.find('/')) + "\n" + read(file));
        }
      }
      std::sort(found.begin(), found.end());
      return found;
    }
  } folder;
};

Words reports(const std::string& to) {
  return {"--report", to + "/r.html", "--csv",   to + "/r.csv",
          "--junit",  to + "/r.xml",  "--pages", to + "/pages"};
}

TEST_F(GradePartTest, MergeToTheBytesOfOneProcess) {
  for (const Words& options : {Words{}, Words{"--min-psnr", "20"}}) {
    folder.make("whole");
    const ProgramRun whole = grade(options + reports("whole"));
    ASSERT_EQ(whole.status, 1) << whole.err;
    const std::string json = grade(options + Words{"--json"}).out;
    const std::vector<std::string> files = folder.contents("whole");
    ASSERT_EQ(files.size(), 8U);
    for (const int count : {1, 2, 5, 9}) {
      SCOPED_TRACE(count);
      grade_parts(count, options);
      folder.make("merged");
      const ProgramRun merged = run(Words{"merge", "parts"} + reports("merged"));
      EXPECT_EQ(merged.status, whole.status);
      EXPECT_EQ(merged.out, whole.out);
      EXPECT_EQ(merged.err, "");
      EXPECT_TRUE(folder.contents("merged") == files);
      EXPECT_EQ(run({"merge", "parts", "--json"}).out, json);
      EXPECT_EQ(run({"merge", "parts"}).out, whole.out);
      EXPECT_EQ(run({"merge", "parts", "--quiet"}).out, "");
      std::filesystem::remove_all(folder.path("merged"));
    }
    std::filesystem::remove_all(folder.path("whole"));
  }
}

// The pictures of a large class go next to the report.
TEST_F(GradePartTest, LargeClassesToo) {
  for (int i = 0; i < 100; ++i) {
    submit("s" + std::to_string(i), "ball", folder.read(i % 30 == 7 ? "wrong.png" : "right.png"));
  }
  std::filesystem::remove(folder.path("refs/ball.xml"));
  folder.make("whole");
  folder.make("merged");
  const ProgramRun whole = grade({"--report", "whole/r.html", "--threads", "1"});
  grade_parts(3);
  const ProgramRun merged = run({"merge", "parts", "--report", "merged/r.html"});
  EXPECT_EQ(merged.out, whole.out);
  EXPECT_GT(folder.contents("whole").size(), 5U);
  EXPECT_TRUE(folder.contents("merged") == folder.contents("whole"));
}

TEST_F(GradePartTest, AllPassedIsStatus0AndGradescopeIsForOneStudent) {
  for (const char* const name : {"class/ben", "class/=cleo, <b>\"", "class/dan", "class/eve"}) {
    std::filesystem::remove_all(folder.path(name));
  }
  ASSERT_EQ(grade({"--gradescope", "whole.json"}).status, 0);
  grade_parts(3);
  EXPECT_EQ(run({"merge", "parts", "--gradescope", "merged.json"}).status, 0);
  EXPECT_EQ(folder.read("merged.json"), folder.read("whole.json"));
  submit("ben", "ball", folder.read("right.png"));
  grade_parts(3);
  const ProgramRun two = run({"merge", "parts", "--gradescope", "two.json"});
  EXPECT_EQ(two.status, 2);
  EXPECT_THAT(two.err, HasSubstr("the class has 2"));
}

TEST_F(GradePartTest, ExistingPartsAreSkippedAndOtherClassesRejected) {
  grade_parts(2);
  const std::string bytes = folder.read("parts/1.part");
  const auto written = std::filesystem::last_write_time(folder.path("parts/1.part"));
  const rapidjson::Document again = parse_json(part(1, 2, {"--json"}).out);
  EXPECT_TRUE(again["part"]["skipped"].GetBool());
  EXPECT_EQ(again["part"]["students"].GetInt(), 2);
  EXPECT_EQ(std::filesystem::last_write_time(folder.path("parts/1.part")), written);
  const auto expect_refused = [&](const ProgramRun& refused, const std::string& why) {
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr(why));
    EXPECT_TRUE(folder.read("parts/1.part") == bytes);
  };
  expect_refused(part(1, 2, {"--min-psnr", "20"}), "graded with other options; remove the file");
  expect_refused(part(1, 2, {"--features", "none"}), "graded with other options");
  expect_refused(part(1, 3), "it is part 1 of 2, not 1 of 3");
  submit("eve", "ball", folder.read("right.png"));  // of the other part
  EXPECT_EQ(part(1, 2).status, 0);
  submit("anna", "ball", folder.read("wrong.png"));
  expect_refused(part(1, 2), "graded from other pictures");
  submit("zoe", "ball", folder.read("right.png"));
  expect_refused(part(1, 2), "graded for another class, or its students have changed");
  std::filesystem::remove_all(folder.path("class/zoe"));
  folder.write("refs/ball.xml", std::string(good_scene) + "\n");
  expect_refused(part(1, 2), "graded with other references or scenes");
  folder.write("parts/1.part", "my notes");
  EXPECT_THAT(part(1, 2).err, HasSubstr("not a part of a class; remove the file"));
  EXPECT_EQ(folder.read("parts/1.part"), "my notes");
}

TEST_F(GradePartTest, MergeListsErrorsAndWritesNothing) {
  grade_parts(4);
  ASSERT_EQ(grade({"-o", "parts/foreign", "--part", "1/4", "--min-psnr", "20"}).status, 0);
  ASSERT_EQ(grade({"-o", "parts/other", "--part", "1/3"}).status, 0);
  std::filesystem::remove(folder.path("parts/3.part"));
  std::string damaged = folder.read("parts/2.part");
  damaged[damaged.size() / 2] ^= 1;
  folder.write("parts/2.part", damaged);
  folder.write("parts/4b.part", folder.read("parts/4.part"));
  folder.write("parts/notes.txt", "mine");
  const ProgramRun merged = run({"merge", "parts", "--csv", "r.csv"});
  EXPECT_EQ(merged.status, 1);
  EXPECT_EQ(merged.out, "");
  EXPECT_THAT(merged.err, HasSubstr("parts/2.part: the part is damaged"));
  EXPECT_THAT(merged.err, HasSubstr("parts/4b.part (part 4 of 4): the same part as parts/4.part"));
  EXPECT_THAT(merged.err, HasSubstr("parts/foreign (part 1 of 4): graded with other options"));
  EXPECT_THAT(merged.err, HasSubstr("parts/other (part 1 of 3): belongs to the same class, divided "
                                    "into another number of parts"));
  EXPECT_THAT(merged.err, HasSubstr("missing: 2 of 4: 2, 3"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("r.csv")));
  const ProgramRun missing = run({"merge", "parts", "--missing"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(missing.out, "2\n3\n");
  const rapidjson::Document answer = parse_json(run({"merge", "parts", "--json"}).out);
  EXPECT_EQ(answer["parts"].GetInt(), 4);
  EXPECT_FALSE(answer["written"].GetBool());
  for (const char* const file : {"foreign", "other", "4b.part"}) {
    std::filesystem::remove(folder.path(std::string("parts/") + file));
  }
  EXPECT_EQ(part(2, 4).status, 0);  // a damaged part is graded again
  EXPECT_EQ(part(3, 4).status, 0);
  EXPECT_EQ(run({"merge", "parts", "--csv", "r.csv"}).status, 1);
  EXPECT_EQ(run({"merge", "parts", "--missing"}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path("r.csv")));
}

TEST_F(GradePartTest, UsageErrorsAreReportedImmediately) {
  EXPECT_EQ(grade({"--part", "1/2"}).status, 2);
  EXPECT_EQ(grade({"-o", "x.part"}).status, 2);
  EXPECT_EQ(grade({"--part", "1/2", "-o", "-"}).status, 2);
  EXPECT_THAT(grade({"--part", "1/2", "-o", "x", "--csv", "r.csv"}).err,
              HasSubstr("--csv is for the whole class: give it to merge"));
  EXPECT_EQ(grade({"--part", "1/2", "-o", "no/such/x"}).status, 3);
  grade_parts(2);
  EXPECT_THAT(run({"merge", "parts", "-o", "out.png"}).err, HasSubstr("parts of a class"));
  EXPECT_EQ(run({"merge", "parts", "-o", "out.png"}).status, 2);
  EXPECT_EQ(run({"merge", "parts", "--csv", "no/such/r.csv"}).status, 3);
  ASSERT_EQ(run({"render", "scene.xml", "-o", "p", "--part", "1/1", "--size", "9x9"}).status, 0);
  EXPECT_EQ(run({"merge", "p", "--csv", "r.csv"}).status, 2);
  EXPECT_EQ(run({"merge", "p"}).status, 2);
  // A part of a picture among those of a class.
  const ProgramRun mixed = run({"merge", "parts/1.part", "parts/2.part", "p"});
  EXPECT_EQ(mixed.status, 1);
  EXPECT_THAT(mixed.err, HasSubstr("p: the file is not a part of a class"));
}

TEST_F(GradePartTest, NothingMatchesIsAnErrorInEveryPart) {
  std::filesystem::remove_all(folder.path("class"));
  submit("anna", "cube", folder.read("right.png"));
  submit("ben", "cube", folder.read("right.png"));
  const ProgramRun whole = grade({});
  EXPECT_EQ(whole.status, 3);
  const ProgramRun one = part(2, 2);
  EXPECT_EQ(one.status, 3);
  EXPECT_EQ(one.err, whole.err);
  EXPECT_THAT(folder.contents("parts"), IsEmpty());
}

}  // namespace
}  // namespace scenefile
