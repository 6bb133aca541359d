#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string textured =
    R"(<diffuse r="1" g="0.5" b="0"/><blend v="1"/><texture file="image/no.png" u="1" v="1"/>)";

struct Check : ProgramFolder {};

TEST_F(Check, AFineSceneIsReportedAsFine) {
  const std::string scene = folder.write("good.xml", good_scene);
  const ProgramRun run = run_program({"check", scene});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, scene + ": fine\n");
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run_program({"check", "--quiet", scene}).out, "");
}

TEST_F(Check, AMistakeIsShownInItsLine) {
  folder.write("bad.xml", scene_with(R"(<diffuse r="red" g="0.5" b="0"/>)"));
  const ProgramRun run = program({"check", "bad.xml"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("bad.xml:15:"));
  EXPECT_THAT(run.out, HasSubstr("[xml.number]\n"
                                 "   15 |         <diffuse r=\"red\" g=\"0.5\" b=\"0\"/>\n"
                                 "      |"));
  EXPECT_THAT(run.out, HasSubstr("bad.xml: 1 error\n"));
}

TEST_F(Check, LinesAreShownInAnyEncoding) {
  std::string utf16 = "\xFF\xFE";
  for (const char c : scene_with(R"(<diffuse r="red" g="0.5" b="0"/>)")) {
    utf16 += {c, '\0'};
  }
  folder.write("utf16.xml", utf16);
  EXPECT_THAT(program({"check", "utf16.xml"}).out,
              HasSubstr("   15 |         <diffuse r=\"red\" g=\"0.5\" b=\"0\"/>\n"
                        "      |                  ^\n"));
  folder.write("mark.xml", "\xEF\xBB\xBF<scene/>");
  EXPECT_THAT(program({"convert", "mark.xml", "o.xml"}).err, Not(HasSubstr("feff")));
}

TEST_F(Check, NoColorWithoutATerminal) {
  folder.write("bad.xml", scene_with("<difuse/>"));
  EXPECT_THAT(run_program({"check", folder.path("bad.xml")}).out, Not(HasSubstr("\x1b")));
}

TEST_F(Check, ReadsStandardInput) {
  for (const std::string name : {"-", "/dev/stdin"}) {
    const ProgramRun run = run_program({"check", name}, {.input = good_scene});
    EXPECT_EQ(run.status, 0) << run.err;
  }
  EXPECT_EQ(run_program({"check", "-"}, {.input = good_scene}).out, "<stdin>: fine\n");
}

TEST_F(Check, TheWorstInputDeterminesTheStatus) {
  const std::string good = folder.write("good.xml", good_scene);
  const std::string bad = folder.write("bad.xml", "<scenefile>");
  const ProgramRun two = run_program({"check", good, bad});
  EXPECT_EQ(two.status, 1);
  EXPECT_THAT(two.out, AllOf(HasSubstr(good + ": fine"), HasSubstr(bad + ": 1 error")));
  const ProgramRun three = run_program({"check", bad, folder.path("none.xml"), good});
  EXPECT_EQ(three.status, 3);
  EXPECT_THAT(three.err, HasSubstr("none.xml: cannot open: No such file or directory"));
  EXPECT_THAT(three.out, HasSubstr(good + ": fine"));
}

TEST_F(Check, UnreadableFilesAreStatus3) {
  for (const std::string& path :
       {folder.path("none.xml"), folder.path(), std::string("/dev/zero")}) {
    const ProgramRun run = run_program({"check", path});
    EXPECT_EQ(run.status, 3) << path;
    EXPECT_THAT(run.err, HasSubstr(path));
    EXPECT_EQ(run.out, "");
  }
}

TEST_F(Check, AFolderStandsForTheScenesInIt) {
  for (const char* name : {"class/b10.xml", "class/b9.xml", "class/anna/x.json",
                           "class/.hidden/y.xml", "class/__MACOSX/z.xml", "class/notes.txt"}) {
    folder.write(name, good_scene);
  }
  folder.write("class/anna/x.json", R"({"groups": []})");
  folder.write("class/results.xml", "<testsuites/>");
  folder.write("class/ben/bad.xml", "<scenefile>");
  const ProgramRun run = program({"check", "class"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "class: skipped one file that is not a scene: class/results.xml\n");
  std::vector<std::size_t> places;
  for (const char* line : {"class/b9.xml: fine\n", "class/b10.xml: fine\n",
                           "class/anna/x.json: ", "class/ben/bad.xml: 1 error\n", "\n4 scenes: "}) {
    places.push_back(run.out.find(line));
    EXPECT_NE(places.back(), std::string::npos) << line << run.out;
  }
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end())) << run.out;
  const ProgramRun json = program({"check", "--json", "class"});
  EXPECT_EQ(parse_json(json.out)["scenes"].Size(), 4U);
  EXPECT_EQ(json.err, "");
}

TEST_F(Check, AFolderWithoutScenesCannotBeRead) {
  folder.write("class/notes.txt");
  const ProgramRun run = program({"check", "class"});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("class: there is no scene in this folder"));
}

TEST_F(Check, LimitsAreStatus4) {
  std::string deep = "<scenefile>";
  for (int i = 0; i < 2000; ++i) {
    deep += "<object type=\"tree\"><transblock>";
  }
  EXPECT_EQ(run_program({"check", "-"}, {.input = deep}).status, 4);
}

TEST_F(Check, FindsTexturesByTheRules) {
  const std::string scene = folder.write("scenes/s.xml", scene_with(textured));
  const ProgramRun missing = run_program({"check", scene});
  EXPECT_EQ(missing.status, 0);
  EXPECT_THAT(missing.out, AllOf(HasSubstr("s.xml:15:"), HasSubstr("image/no.png")));
  EXPECT_EQ(run_program({"check", "--no-assets", scene}).out, scene + ": fine\n");
}

TEST_F(Check, PolicyRaisesAndRemoves) {
  const std::string scene = folder.write("s.xml", scene_with(textured));
  const rapidjson::Document report = parse_json(run_program({"check", "--json", scene}).out);
  const std::string code = report["scenes"][0]["findings"][0]["code"].GetString();
  EXPECT_EQ(run_program({"check", "--deny", "warnings", scene}).status, 1);
  const ProgramRun allowed = run_program({"check", "--deny", "warnings", "--allow", code, scene});
  EXPECT_EQ(allowed.status, 0);
  EXPECT_EQ(allowed.out, scene + ": fine\n");
}

TEST_F(Check, SingleCodesAreDenied) {
  const std::string scene =
      folder.write("s.xml", scene_with(R"(<diffuse r="1" g="1" b="1"/><blend v="0.5"/>)"));
  const std::string code = "material.blend-without-texture";
  EXPECT_EQ(run_program({"check", scene}).status, 0);
  EXPECT_EQ(run_program({"check", "--deny", "xml.text", scene}).status, 0);
  const ProgramRun denied = run_program({"check", "--deny", "xml.text", "--deny", code, scene});
  EXPECT_EQ(denied.status, 1);
  EXPECT_THAT(denied.out, HasSubstr("error: "));
  EXPECT_EQ(run_program({"check", "--deny", code, "--allow", code, scene}).status, 0);
}

TEST_F(Check, ADeniedLimitOfATextureIsAnError) {
  const std::string scene = folder.write("s.xml", scene_with(textured));
  std::string huge = "BM";
  huge.resize(54);
  const auto put = [&](std::size_t at, unsigned value) {
    for (std::size_t i = 0; i < 4; ++i) {
      huge[at + i] = static_cast<char>(value >> 8 * i);
    }
  };
  put(10, 54);
  put(14, 40);
  put(18, 100'000);
  put(22, 100'000);
  put(26, 1 + (24 << 16));
  folder.write("image/no.png", huge);
  const ProgramRun run = run_program({"check", "--deny", "warnings", scene});
  EXPECT_THAT(run.out, HasSubstr("[texture.limit]"));
  EXPECT_EQ(run.status, 1);
}

TEST_F(Check, SeveralScenesEndWithACount) {
  const std::string good = folder.write("good.xml", good_scene);
  const std::string warned = folder.write("warned.xml", scene_with(textured));
  const std::string bad = folder.write("bad.xml", "<scenefile>");
  EXPECT_THAT(
      run_program({"check", good, warned, bad, folder.path("none.xml"), good}).out,
      ::testing::EndsWith("\n5 scenes: 2 fine, 1 with warnings, 1 with errors, 1 unreadable\n"));
  EXPECT_EQ(run_program({"check", "--quiet", good, good}).out, "");
}

// A name that cannot be read is not a missing one.
TEST_F(Check, AWrongNameOfATemplateIsReportedOnce) {
  for (const std::string& name : {std::string("5"), '"' + std::string(5000, 'x') + '"'}) {
    folder.write("a.json", R"({"templateGroups": [{"name": )" + name + "}]}");
    EXPECT_THAT(program({"check", "a.json"}).out,
                AllOf(HasSubstr("a.json:1:22: error: "), Not(HasSubstr("[tree."))));
  }
  folder.write("a.json", R"({"templateGroups": [{}]})");
  EXPECT_THAT(program({"check", "a.json"}).out, HasSubstr("[tree.template-without-name]"));
}

TEST_F(Check, FindingsAreSortedByPlace) {
  // The reader reports line 15 before check() reports line 4.
  std::string text = scene_with("<frobnicate/>");
  text.replace(text.find("<up "), 3, "<up a=\"1\"");
  const std::string scene = folder.write("s.xml", text);
  const rapidjson::Document report = parse_json(run_program({"check", "--json", scene}).out);
  int last = 0;
  for (const auto& finding : report["scenes"][0]["findings"].GetArray()) {
    EXPECT_LE(last, finding["line"].GetInt());
    last = finding["line"].GetInt();
  }
  EXPECT_EQ(last, 15);
  EXPECT_STREQ(report["scenes"][0]["verdict"].GetString(), "warnings");
}

TEST_F(Check, StrictRejectsDialects) {
  const std::string scene = folder.write("s.xml", scene_with(R"(<shininess value="3"/>)"));
  EXPECT_EQ(run_program({"check", scene}).status, 0);
  EXPECT_EQ(run_program({"check", "--strict", scene}).status, 1);
}

TEST_F(Check, AnErrorCannotBeAllowed) {
  const ProgramRun run = run_program({"check", "--allow", "xml.number", "a.xml"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("a scene that has it cannot be used"));
}

TEST_F(Check, CompatCourseReadsWhatTheCourseRead) {
  const std::string scene = folder.write("s.xml", scene_with(R"(<diffuse r="1'" g="0" b="0"/>)"));
  EXPECT_EQ(run_program({"check", scene}).status, 1);
  const ProgramRun run = run_program({"check", "--compat", "course", scene});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("warning"));
}

TEST_F(Check, JsonIsOneCompleteDocument) {
  const std::string good = folder.write("good.xml", good_scene);
  const std::string bad = folder.write("bad.xml", scene_with("<difuse r=\"\xff\x1b[31m\"/>"));
  const std::string none = folder.path("no\nne.xml");
  const ProgramRun run = run_program({"check", "--json", good, bad, none});
  EXPECT_THAT(run.out, HasSubstr("\n    {\n      \"file\": "));
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err, "");
  const rapidjson::Document report = parse_json(run.out);
  ASSERT_EQ(report["scenes"].Size(), 3U);
  EXPECT_EQ(report["scenes"][0]["errors"].GetInt(), 0);
  EXPECT_STREQ(report["scenes"][0]["file"].GetString(), good.c_str());
  const auto& finding = report["scenes"][1]["findings"][0];
  EXPECT_EQ(finding["line"].GetInt(), 15);
  EXPECT_STREQ(finding["severity"].GetString(), "error");
  EXPECT_THAT(report["scenes"][2]["error"].GetString(), HasSubstr("No such file"));
}

TEST_F(Check, NamesCannotForgeLines) {
  const std::string scene = folder.write("a\nforged.xml: fine\x1b[31m.xml", "<scenefile>");
  const ProgramRun run = run_program({"check", scene});
  EXPECT_THAT(run.out, AllOf(HasSubstr("a\\nforged.xml: fine"), Not(HasSubstr("\x1b"))));
}

TEST_F(Check, LeavesNoFiles) {
  folder.write("s.xml", scene_with(textured));
  program({"check", "s.xml"});
  EXPECT_THAT(folder.list(), ::testing::ElementsAre("s.xml"));
  EXPECT_EQ(folder.read("s.xml"), scene_with(textured));
}

}  // namespace

}  // namespace scenefile
