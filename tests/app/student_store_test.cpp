// The store of grade: the same results as one process without it.

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
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct StudentStore : ::testing::Test {
  StudentStore() {
    // Its cause is found at once; for a picture without a known cause the search takes seconds.
    std::string bright = good_scene;
    bright.replace(bright.find("<diffusecoeff v=\"0.5\""), 21, "<diffusecoeff v=\"1\"");
    render(good_scene, "right.png");
    render(bright, "wrong.png");
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

  void render(const std::string& scene, const std::string& output) const {
    folder.write("scene.xml", scene);
    ASSERT_EQ(run({"render", "scene.xml", "--size", "32x24", "-o", output}).status, 0);
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
  ProgramRun share(int number, int count, const Words& more = {}) const {
    return grade(Words{"--store", "results", "--part",
                       std::to_string(number) + "/" + std::to_string(count)} +
                 more);
  }
  void grade_shares(int count, const Words& more = {}) const {
    for (int number = count; number >= 1; --number) {
      const ProgramRun done = share(number, count, more);
      ASSERT_EQ(done.status, 0) << done.err;
      EXPECT_EQ(done.out, "");
    }
  }
  void forget() const { std::filesystem::remove_all(folder.path("results")); }

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

TEST_F(StudentStore, GivesTheBytesOfOneProcess) {
  for (const Words& options : {Words{}, Words{"--min-psnr", "30"}}) {
    folder.make("whole");
    const ProgramRun whole = grade(options + reports("whole"));
    ASSERT_EQ(whole.status, 1) << whole.err;
    const std::string json = grade(options + Words{"--json"}).out;
    const std::vector<std::string> files = folder.contents("whole");
    ASSERT_EQ(files.size(), 8U);
    const Words store = options + Words{"--store", "results"};
    for (const int count : {0, 1, 2, 5, 9}) {
      SCOPED_TRACE(count);
      forget();
      grade_shares(count, options);
      for (int i = 0; i < 2; ++i) {
        folder.make("made");
        const ProgramRun made = grade(store + reports("made"));
        EXPECT_EQ(made.status, whole.status);
        EXPECT_EQ(made.out, whole.out);
        EXPECT_EQ(made.err, whole.err);
        EXPECT_TRUE(folder.contents("made") == files);
        EXPECT_EQ(grade(store + Words{"--json"}).out, json);
        std::filesystem::remove_all(folder.path("made"));
      }
      EXPECT_EQ(folder.contents("results").size(), 5U);
    }
    forget();
    std::filesystem::remove_all(folder.path("whole"));
  }
}

// The pictures of a large class go next to the report.
TEST_F(StudentStore, WorksForLargeClasses) {
  for (int i = 0; i < 100; ++i) {
    submit("s" + std::to_string(i), "ball", folder.read(i % 30 == 7 ? "wrong.png" : "right.png"));
  }
  std::filesystem::remove(folder.path("refs/ball.xml"));
  folder.make("whole");
  folder.make("made");
  const ProgramRun whole = grade({"--report", "whole/r.html", "--threads", "1"});
  grade_shares(3);
  const ProgramRun made = grade({"--store", "results", "--report", "made/r.html"});
  EXPECT_EQ(made.out, whole.out);
  EXPECT_GT(folder.contents("whole").size(), 5U);
  EXPECT_TRUE(folder.contents("made") == folder.contents("whole"));
}

TEST_F(StudentStore, ListsWhatIsMissing) {
  const auto missing = [&](const Words& more = {}) {
    return grade(Words{"--store", "results", "--missing", "3"} + more);
  };
  EXPECT_EQ(missing().out, "1\n2\n3\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path("results"))) << "nothing is made";
  ASSERT_EQ(share(2, 3).status, 0);
  EXPECT_EQ(missing().out, "1\n3\n");
  EXPECT_EQ(missing().status, 1);
  const ProgramRun json = missing({"--json"});
  EXPECT_EQ(json.status, 1);
  EXPECT_EQ(parse_json(json.out)["store"]["missing"][1].GetInt(), 3);
  grade_shares(5);
  EXPECT_EQ(missing().status, 0);
  EXPECT_EQ(missing().out, "");
}

TEST_F(StudentStore, ResultsAreKeptUntilTheirPicturesChange) {
  grade_shares(2);
  const std::string anna = folder.read("results/anna.json");
  EXPECT_THAT(anna, AllOf(HasSubstr("\"key\": \"scenefile item 1: program="),
                          HasSubstr("\"verdict\": "), HasSubstr("\"base64\": ")));
  const auto written = std::filesystem::last_write_time(folder.path("results/anna.json"));
  const rapidjson::Document again = parse_json(share(1, 2, {"--json"}).out);
  EXPECT_EQ(again["store"]["found"].GetInt(), 2);
  EXPECT_EQ(again["store"]["graded"].GetInt(), 0);
  submit("zoe", "ball", folder.read("right.png"));
  EXPECT_THAT(share(1, 1).err, HasSubstr("share 1 of 1: 1 student graded, 5 found"));
  EXPECT_EQ(std::filesystem::last_write_time(folder.path("results/anna.json")), written);
  const auto refused = [&](const ProgramRun& run, const std::string& why) {
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr(why));
    EXPECT_TRUE(folder.read("results/anna.json") == anna);
  };
  const Words store{"--store", "results"};
  refused(share(1, 2, {"--min-psnr", "20"}), "it was graded with min_psnr = its default, not 20; ");
  refused(share(1, 2, {"--features", "none"}), "it was graded with features.shadows = true, not");
  refused(grade(store + Words{"--csv", "r.csv", "--min-ssim", "0.5"}),
          "with min_ssim = its default");
  EXPECT_FALSE(std::filesystem::exists(folder.path("r.csv")));
  submit("anna", "ball", folder.read("wrong.png"));
  refused(share(1, 2),
          "results/anna.json: it was graded from other pictures; choose another folder");
  submit("anna", "ball", folder.read("right.png"));
  folder.write("refs/ball.xml", std::string(good_scene) + "\n");
  refused(share(1, 2), "it was graded with other references or scenes");
  folder.write("refs/ball.xml", good_scene);
  folder.write("results/ben.json", "{\"mine\": 1}");
  refused(share(1, 2), "results/ben.json: it is not the result of a student");
  EXPECT_EQ(folder.read("results/ben.json"), "{\"mine\": 1}");
}

// Settings that are not given are found in the references, even if they are the defaults.
TEST_F(StudentStore, KeysHaveTheSettingsOfRealtime) {
  folder.make("one/anna");
  folder.write("one/anna/other.png", folder.read("right.png"));
  const auto grade_one = [&](const Words& more) {
    return run(Words{"grade", "one", "--references", "refs", "--store", "results", "--profile",
                     "realtime"} +
               more);
  };
  const Words given{"--parameters", "5,5"};
  EXPECT_EQ(grade_one(given).err, grade_one(given).err);
  EXPECT_THAT(grade_one({}).err,
              HasSubstr("it was graded with parameters_given = true, not false"));
  EXPECT_THAT(grade_one(given + Words{"--filter", "none"}).err,
              HasSubstr("it was graded with filter_given = false, not true"));
  folder.write("refs/references.tsv", "reference\tparameter1\nball.png\t7\n");
  EXPECT_THAT(grade_one(given).err, HasSubstr("it was graded with other references or scenes"));
}

// What a run writes into the folder of the class, and references there, are no students of the
// next.
TEST_F(StudentStore, TheFolderOfTheClassMayContainIt) {
  std::filesystem::rename(folder.path("refs"), folder.path("class/refs"));
  const Words words{"grade", "class", "--references", "class/refs", "--store", "class/graded"};
  for (const char* part : {"1/2", "2/2"}) {
    EXPECT_THAT(run(words + Words{"--part", part}).err,
                AnyOf(HasSubstr("2 students graded, 0"), HasSubstr("3 students graded, 0")));
  }
  const Words last = words + Words{"--pages", "class/out/pages", "--report", "class/report.html",
                                   "--csv-students"};
  EXPECT_EQ(run(last + Words{"a.csv"}).status, 1);
  folder.make("class/report-pictures");
  EXPECT_EQ(run(last + Words{"b.csv"}).status, 1);
  EXPECT_EQ(folder.read("a.csv"), folder.read("b.csv"));
  EXPECT_EQ(folder.contents("class/graded").size(), 5U);
}

// The name of a student's file does not depend on who else is in the class.
TEST_F(StudentStore, AStudentWithASimilarNameMayJoin) {
  submit("Zoe_Lee", "ball", folder.read("right.png"));
  grade_shares(1);
  const std::string zoe = folder.read("results/Zoe_Lee.json");
  submit("Zoe Lee", "ball", folder.read("wrong.png"));
  submit("Zoe?Lee", "ball", folder.read("right.png"));
  const ProgramRun joined = share(1, 1);
  EXPECT_EQ(joined.status, 0);
  EXPECT_THAT(joined.err, HasSubstr("share 1 of 1: 2 students graded, 6 found"));
  EXPECT_TRUE(folder.read("results/Zoe_Lee.json") == zoe);
  std::filesystem::remove_all(folder.path("class/Zoe Lee"));
  EXPECT_THAT(share(1, 1).err, HasSubstr("share 1 of 1: 0 students graded, 7 found"));
}

TEST_F(StudentStore, DamagedResultsAreMadeAgain) {
  grade_shares(1);
  const std::string ben = folder.read("results/ben.json");
  std::string changed = ben;
  changed[ben.size() / 2] ^= 1;
  for (const std::string& damaged : {changed, ben.substr(0, ben.size() - 9), std::string()}) {
    folder.write("results/ben.json", damaged);
    EXPECT_EQ(grade({"--store", "results", "--missing", "5"}).out, "3\n");
    EXPECT_EQ(share(1, 1).status, 0);
    EXPECT_TRUE(folder.read("results/ben.json") == ben);
  }
}

TEST_F(StudentStore, UsageErrorsAreReportedImmediately) {
  EXPECT_EQ(grade({"--part", "1/2"}).status, 2);
  EXPECT_EQ(grade({"--missing", "2"}).status, 2);
  EXPECT_EQ(grade({"--store", "r", "--missing", "2", "--part", "1/2"}).status, 2);
  EXPECT_EQ(grade({"--store", ""}).status, 2);
  EXPECT_EQ(grade({"-o", "x"}).status, 2);
  EXPECT_THAT(share(1, 2, {"--csv", "r.csv"}).err,
              HasSubstr("--csv is for the whole class: leave it out, or --part"));
  folder.write("file", "");
  EXPECT_EQ(grade({"--store", "file"}).status, 3);
  EXPECT_EQ(grade({"--store", "file/below"}).status, 3);
  EXPECT_FALSE(std::filesystem::exists(folder.path("results")));
}

TEST_F(StudentStore, NothingMatchesIsAnErrorInEveryShare) {
  std::filesystem::remove_all(folder.path("class"));
  submit("anna", "cube", folder.read("right.png"));
  submit("ben", "cube", folder.read("right.png"));
  const ProgramRun whole = grade({});
  EXPECT_EQ(whole.status, 3);
  const ProgramRun one = share(2, 2);
  EXPECT_EQ(one.status, 3);
  EXPECT_EQ(one.err, whole.err);
  EXPECT_FALSE(std::filesystem::exists(folder.path("results")));
}

}  // namespace
}  // namespace scenefile
