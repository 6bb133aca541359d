// With --json, a command that fails also answers in JSON.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::HasSubstr;
using ::testing::Not;

// Whether the value, or a part of it, is an object with an error: "error" of the answer, of a scene
// or of a picture, or a finding that is one.
bool says_error(const rapidjson::Value& value) {
  if (value.IsArray()) {
    for (const auto& element : value.GetArray()) {
      if (says_error(element)) {
        return true;
      }
    }
  } else if (value.IsObject()) {
    for (const auto& member : value.GetObject()) {
      const std::string name = member.name.GetString();
      if ((name == "error" && member.value.IsString() && member.value.GetStringLength() > 0) ||
          (name == "severity" && member.value == "error") || says_error(member.value)) {
        return true;
      }
    }
  }
  return false;
}

struct FailingRun {
  Words words;  // without --json
  int status = 0;
};

const std::vector<FailingRun> failing_runs{
    {{"check", "none.xml"}, 3},
    {{"check", "broken.xml"}, 1},
    {{"check", "binary.xml"}, 1},
    {{"check", "empty.xml"}, 1},
    {{"check", "refs"}, 3},
    {{"check", "good.xml", "--deny", "nothing"}, 2},
    {{"check", "good.xml", "--asset-root", "none"}, 2},
    {{"check", "good.xml", "--limit", "file-bytes=10"}, 4},
    {{"check", "good.xml", "--limit", "nothing=10"}, 2},
    {{"check"}, 2},
    {{"check", "--fix", "-"}, 2},
    {{"check", "good.xml", "--sarif"}, 2},
    {{"info", "none.xml"}, 3},
    {{"info", "broken.xml"}, 1},
    {{"info", "good.png"}, 1},
    {{"info", "refs"}, 3},
    {{"info", "good.xml", "good.xml"}, 2},
    {{"render", "none.xml", "-o", "new.png"}, 3},
    {{"render", "broken.xml", "-o", "new.png"}, 1},
    {{"render", "none.ini"}, 3},
    {{"render", "broken.ini"}, 1},
    {{"render", "binary.ini"}, 1},
    {{"render", "good.xml", "-o", "none/new.png"}, 3},
    {{"render", "good.xml", "-o", "good.xml"}, 2},
    {{"render", "good.xml", "-o", "new.png", "--size", "big"}, 2},
    {{"render", "good.xml", "-o", "new.png", "--size", "9x9", "--crop", "0,0,10,10"}, 2},
    {{"render", "good.xml", "-o", "-"}, 2},
    {{"render", "good.xml", "-o", "new.png", "--timeout", "0.0001"}, 4},
    {{"render", "good.xml", "-o", "new.png", "--part", "1/2"}, 2},
    {{"render", "good.xml", "-o", "new.png", "--no-such-option"}, 2},
    {{"frames", "none.xml", "-o", "f%d.png", "--turntable", "2"}, 3},
    {{"frames", "none.ini", "-o", "f%d.png", "--turntable", "2"}, 3},
    {{"frames", "good.xml", "-o", "f.png", "--turntable", "2"}, 2},
    {{"frames", "good.xml", "-o", "f%d.png", "--path", "none.json"}, 3},
    {{"frames", "good.xml", "-o", "none/f%d.png", "--turntable", "2"}, 3},
    {{"convert", "none.xml", "new.json"}, 3},
    {{"convert", "broken.xml", "new.json"}, 1},
    {{"convert", "none.glb", "new.xml"}, 3},
    {{"convert", "binary.glb", "new.xml"}, 1},
    {{"convert", "binary.glb", "new.obj"}, 2},
    {{"convert", "good.xml", "none/new.json"}, 3},
    {{"convert", "good.xml", "-", "--to", "obj"}, 2},
    {{"convert", "good.xml", "new"}, 2},
    {{"convert", "good.xml"}, 2},
    {{"format", "none.xml"}, 3},
    {{"format", "broken.xml"}, 1},
    {{"format", "-"}, 2},
    {{"explain", "none.xml", "--pixel", "1,1"}, 3},
    {{"explain", "broken.xml", "--pixel", "1,1"}, 1},
    {{"explain", "none.ini", "--pixel", "1,1"}, 3},
    {{"explain", "good.xml"}, 2},
    {{"explain", "good.xml", "--pixel", "1,1", "--mine", "none.png"}, 3},
    {{"explain", "good.xml", "--pixel", "1,1", "--mine", "binary.png"}, 1},
    {{"explain", "good.xml", "--pixel", "9,9", "--mine", "good.png"}, 2},
    {{"explain", "good.xml", "--pixel", "1,1", "--mine", "good.png", "--size", "9x9"}, 2},
    {{"diff", "none.xml", "good.xml"}, 3},
    {{"diff", "broken.xml", "good.xml"}, 1},
    {{"diff", "good.xml"}, 2},
    {{"diff", "good.png"}, 2},
    {{"diff", "none.png", "good.png"}, 3},
    {{"diff", "binary.png", "good.png"}, 1},
    {{"diff", "good.png", "good.xml"}, 1},
    {{"diff", "good.png", "good.png", "--scene", "none.xml"}, 3},
    {{"diff", "good.png", "good.png", "--scene", "broken.xml"}, 1},
    {{"diff", "good.png", "good.png", "--heatmap", "none/h.png"}, 3},
    {{"diff", "good.png", "good.png", "--heatmap", "full.png"}, 3},
    {{"diff", "good.png", "--scene", "good.xml", "--mode", "path", "--time", "0.01", "--sheet",
      "full.png"},
     3},
    {{"diff", "good.png", "good.png", "--min-psnr", "many"}, 2},
    {{"diff", "good.png", "good.png", "--mode", "path"}, 2},
    {{"grade", "none", "--references", "refs"}, 3},
    {{"grade", "class", "--references", "none"}, 3},
    {{"grade", "class", "--references", "refs"}, 1},
    {{"grade", "class", "--references", "refs", "--scenes", "none"}, 3},
    {{"grade", "class", "--references", "refs", "--map", "none.csv"}, 3},
    {{"grade", "class", "--references", "refs", "--map", "map.csv"}, 1},
    {{"grade", "class", "--references", "refs", "--report", "none/r.html"}, 3},
    {{"grade", "class", "--references", "refs", "--csv", "-"}, 2},
    {{"grade", "class"}, 2},
    {{"help", "nothing"}, 2},
    {{"help", "render", "frames"}, 2},
    {{"help", "codes", "nothing"}, 2},
    {{"version", "--nothing"}, 2},
};

// With scenes and pictures, good and bad.
struct JsonFailure : ProgramFolder {
  void SetUp() override {
    folder.write("good.xml", good_scene);
    folder.write("broken.xml", "<scenefile><globaldata>");
    folder.write("binary.xml", std::string("\x7f"
                                           "ELF\0\0\1",
                                           7));
    folder.write("binary.png", std::string("\x89PNG\r\n\x1a\n\0\0", 10));
    folder.write("empty.xml", "");
    folder.write("broken.ini", "[IO]\nscene = good.xml\n");
    folder.write("binary.ini", std::string("\0\1\2\xff", 4));
    folder.write("binary.glb", "glTF");
    folder.write("map.csv", "one,two,three\n");
    folder.write("class/ann/a.png", "no picture");
    std::filesystem::create_symlink("/dev/full", folder.path("full.png"));
    folder.write("refs/a.png", "no picture");
    ASSERT_EQ(program({"render", "good.xml", "-o", "good.png", "--size", "8x6", "--quiet"}).status,
              0);
  }
};

TEST_F(JsonFailure, EveryFailureIsAnsweredWithItsReason) {
  for (const FailingRun& failing : failing_runs) {
    const std::string shown = ::testing::PrintToString(failing.words);
    const ProgramRun run = program(failing.words + Words{"--json"});
    EXPECT_EQ(run.status, failing.status) << shown << run.out << run.err;
    rapidjson::Document answer;
    ASSERT_FALSE(answer.Parse(run.out.c_str()).HasParseError()) << shown << run.out << run.err;
    ASSERT_TRUE(answer.IsObject()) << shown;
    EXPECT_EQ(answer["command"].GetString(), failing.words.front()) << shown;
    EXPECT_STREQ(answer["scenefile"].GetString(), SCENEFILE_VERSION) << shown;
    EXPECT_TRUE(says_error(answer)) << shown << run.out;
    if (failing.words[0] == "check" || failing.words[0] == "format") {
      continue;  // these go on with the next file
    }
    ASSERT_TRUE(answer.HasMember("error")) << shown << run.out;
    EXPECT_THAT(run.err, HasSubstr(answer["error"].GetString())) << shown;
  }
}

TEST_F(JsonFailure, CoversEveryCommandWithThatOption) {
  const rapidjson::Document help = parse_json(run_program({"help", "--json"}).out);
  int with_json = 0;
  for (const auto& command : help["commands"].GetArray()) {
    const std::string name = command["name"].GetString();
    bool has_json = false;
    for (const auto& option : command["options"].GetArray()) {
      has_json = has_json || option["name"] == "--json";
    }
    with_json += has_json ? 1 : 0;
    const ProgramRun run = run_program({name, "--json", "--no-such-option"});
    EXPECT_EQ(run.status, 2) << name;
    if (has_json) {
      EXPECT_THAT(parse_json(run.out)["error"].GetString(),
                  HasSubstr(name + " has no option --no-such-option"));
    } else {
      EXPECT_EQ(run.out, "") << name;
    }
  }
  EXPECT_EQ(with_json, 11);
}

TEST_F(JsonFailure, SaysInOneLineWhatIsSaidToPeople) {
  const auto reason = [&](const Words& words) {
    return std::string(parse_json(program(words).out)["error"].GetString());
  };
  EXPECT_EQ(reason({"render", "none.ini", "--json"}),
            "none.ini: cannot open: No such file or directory");
  EXPECT_EQ(reason({"render", "--json", "good.xml", "-o", "new.png", "--size", "big"}),
            R"(--size: "big" is not a size such as 1024x768)");
  EXPECT_EQ(reason({"check", "good.xml", "--json", "--timeout", "0.0001"}),
            "stopped: not finished within 0.0001 s (--timeout)");
  EXPECT_THAT(reason({"grade", "none", "--references", "refs", "--json"}),
              HasSubstr(R"("none" is not a readable folder or archive)"));
}

TEST_F(JsonFailure, ABrokenConfigurationIsDescribedLikeAScene) {
  const rapidjson::Document answer = parse_json(program({"render", "broken.ini", "--json"}).out);
  EXPECT_STREQ(answer["error"].GetString(), "the configuration cannot be used");
  const rapidjson::Value& configuration = answer["configuration"];
  EXPECT_STREQ(configuration["file"].GetString(), "broken.ini");
  EXPECT_STREQ(configuration["verdict"].GetString(), "errors");
  EXPECT_EQ(configuration["findings"].Size(), configuration["errors"].GetUint());
  EXPECT_STREQ(configuration["findings"][0]["code"].GetString(), "config.missing-key");
}

TEST_F(JsonFailure, OutOfMemoryIsAnswered) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need additional address space";
#endif
  const ProgramRun run =
      run_program({"render", "good.xml", "-o", "out.png", "--size", "40000x40000", "--json"},
                  {.folder = folder.path(), .megabytes = 1000});
  EXPECT_EQ(run.status, 3);
  EXPECT_STREQ(parse_json(run.out)["error"].GetString(), "out of memory while tracing");
}

TEST_F(JsonFailure, NothingIsAddedToAnotherOutput) {
  const ProgramRun converted = program({"convert", "good.xml", "-", "--to", "json", "--json"});
  EXPECT_EQ(converted.status, 2);
  EXPECT_FALSE(parse_json(converted.out).HasMember("groups"));
  // Without the option, or after the end of options, people are told.
  for (const Words& words : {Words{"check", "none.xml"}, {"check", "none.xml", "--", "--json"}}) {
    EXPECT_THAT(program(words).out, Not(HasSubstr("{"))) << words.size();
  }
}

}  // namespace

}  // namespace scenefile
