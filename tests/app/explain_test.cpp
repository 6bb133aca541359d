#include "app/run_program.h"
#include "scenefile/asset/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

struct Explain : ProgramFolder {
  Explain() { scene = folder.write("scene.xml", good_scene); }

  ProgramRun explain(const std::string& pixel, std::vector<std::string> more = {},
                     const RunSettings& settings = {}) const {
    std::vector<std::string> words{"explain", scene, "--size", "32x24", "--pixel", pixel};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words, settings);
  }

  std::string scene;
};

TEST_F(Explain, DescribesThePixel) {
  const ProgramRun run = explain("16,12", {"--profile", "course"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, AllOf(HasSubstr("pixel 16,12 of 32x24, profile course"),
                             HasSubstr("hits sphere root/#1 (line 14)"),
                             HasSubstr("in object space"), HasSubstr("directional light (line 9)"),
                             HasSubstr("no occluder"), HasSubstr("sum "), Not(HasSubstr("\x1b"))));
}

TEST_F(Explain, AMissIsExplainedToo) {
  const ProgramRun run = explain("0,0");
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, AllOf(HasSubstr("the background is black"), HasSubstr("= 0 0 0 of 255")));
}

TEST_F(Explain, RealtimeShowsTheTrianglesTerms) {
  const ProgramRun run = explain("16,12", {"--profile", "realtime", "--filter", "invert"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("--profile realtime --parameters 5,5 --filter invert"),
                             HasSubstr("color = 1 - sum of 1 pixel of the frame"),
                             HasSubstr("shows sphere root/#1 (line 14)"), HasSubstr("triangle "),
                             HasSubstr("directional light (line 9)"), HasSubstr("sum ")));
  EXPECT_THAT(explain("0,0", {"--profile", "realtime"}).out, HasSubstr("nothing is drawn here"));
  EXPECT_EQ(explain("16,12", {"--profile", "realtime", "--sample", "1"}).status, 2);
}

TEST_F(Explain, NormalsAreColors) {
  EXPECT_THAT(explain("16,12", {"--mode", "normals"}).out, HasSubstr("(normal + 1) / 2 ="));
  EXPECT_THAT(explain("16,12", {"--mode", "intersect"}).out, HasSubstr("mode intersect"));
}

TEST_F(Explain, NeedsAPixelInsideThePicture) {
  const auto misuse = [&](const ProgramRun& run, const std::string& words) {
    EXPECT_EQ(run.status, 2) << run.out;
    EXPECT_THAT(run.err, HasSubstr(words));
  };
  misuse(run_program({"explain", scene}), "explain needs a pixel: --pixel X,Y");
  misuse(explain("32,0"), "32,0 is not in the picture: 0,0 to 31,23");
  misuse(explain("0,24"), "0,24 is not in the picture");
  misuse(explain("5"), R"("5" is not a pixel such as 320,240)");
  misuse(explain("-1,5"), R"("-1" is not a whole number from 0)");
  misuse(explain("16,12", {"--profile", "course", "--sample", "1"}), "there is no sample 1");
  misuse(explain("16,12", {"--profile", "course", "--samples", "4"}),
         "--samples is for the profile fine");
}

TEST_F(Explain, ShowsTheRequestedSample) {
  EXPECT_THAT(explain("16,12", {"--min-samples", "4", "--sample", "3"}).out,
              HasSubstr("sample 3: "));
}

TEST_F(Explain, ColorsAreForTerminals) {
  RunSettings settings;
  settings.terminal = true;
  settings.environment = {"TERM=xterm", "NO_COLOR=", "COLORTERM="};
  EXPECT_THAT(explain("16,12", {}, settings).out,
              AllOf(HasSubstr("\x1b[1mcolor\x1b[0m"), Not(HasSubstr("\x1b[48;2;"))));
  settings.environment = {"TERM=xterm", "NO_COLOR=", "COLORTERM=truecolor"};
  EXPECT_THAT(explain("16,12", {}, settings).out, HasSubstr("\x1b[48;2;"));
  settings.environment.emplace_back("NO_COLOR=1");
  EXPECT_THAT(explain("16,12", {}, settings).out, Not(HasSubstr("\x1b")));
}

TEST_F(Explain, NamesInTheFileCannotControlTheTerminal) {
  std::string odd = good_scene;
  odd.replace(odd.find("<transblock>"), 0, "<object type=\"tree\" name=\"a&#x9b;31m\">");
  odd.replace(odd.rfind("</object>"), 0, "</object></transblock>");
  odd.replace(odd.find("<object type=\"tree\" name=\"a"), 0, "<transblock>");
  folder.write("scene.xml", odd);
  const ProgramRun run = explain("16,12");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("\\u{9b}31m"), Not(HasSubstr("\xc2\x9b"))));
}

TEST_F(Explain, ABrokenSceneIsAFinding) {
  folder.write("scene.xml", "<scenefile>");
  const ProgramRun run = explain("16,12");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "");
  const ProgramRun json = explain("16,12", {"--json"});
  EXPECT_EQ(json.status, 1);
  const rapidjson::Document report = parse_json(json.out);
  EXPECT_FALSE(report.HasMember("pixel"));
  EXPECT_EQ(report["scene"]["errors"].GetInt(), 1);
}

// A color from a JSON document, with all digits.
struct Rgb {
  double v[3] = {0, 0, 0};

  static Rgb of(const rapidjson::Value& array) {
    return {{array[0].GetDouble(), array[1].GetDouble(), array[2].GetDouble()}};
  }
  Rgb& operator+=(const Rgb& other) {
    for (int c = 0; c < 3; ++c) {
      v[c] += other.v[c];
    }
    return *this;
  }
  friend bool operator==(const Rgb& a, const Rgb& b) {
    return a.v[0] == b.v[0] && a.v[1] == b.v[1] && a.v[2] == b.v[2];
  }
};

TEST_F(Explain, TheDocumentAddsUpToThePicture) {
  folder.write("scene.xml", scene_with(R"(<diffuse r="0.7" g="0.5" b="0.3"/>
      <ambient r="0.1" g="0.2" b="0.3"/><specular r="1" g="1" b="1"/><shininess v="7"/>)"));
  const ProgramRun run = explain("16,11", {"--json"});
  EXPECT_EQ(run.status, 0);
  rapidjson::Document report;
  report.Parse<rapidjson::kParseFullPrecisionFlag>(run.out.c_str());
  ASSERT_FALSE(report.HasParseError());
  EXPECT_STREQ(report["command"].GetString(), "explain");
  const rapidjson::Value& pixel = report["pixel"];
  const rapidjson::Value& ray = pixel["rays"][0];
  EXPECT_STREQ(ray["surface"]["object"][0]["path"].GetString(), "root/#1");
  EXPECT_EQ(ray["surface"]["object"][0]["line"].GetInt(), 14);
  Rgb local = Rgb::of(ray["ambient"]);
  for (const rapidjson::Value& light : ray["lights"].GetArray()) {
    local += Rgb::of(light["contribution"]);
  }
  EXPECT_EQ(local, Rgb::of(ray["local"]));
  EXPECT_EQ(Rgb::of(ray["color"]), Rgb::of(pixel["samples"][pixel["shown"].GetUint()]["color"]));
  Rgb sum;
  for (const rapidjson::Value& sample : pixel["samples"].GetArray()) {
    sum += Rgb::of(sample["color"]);
  }
  for (double& v : sum.v) {
    v /= pixel["samples"].Size();
  }
  EXPECT_EQ(sum, Rgb::of(pixel["color"]));

  run_program({"render", scene, "-o", folder.path("out.png"), "--size", "32x24", "-q"});
  const Result<Texture> picture = decode_image(folder.read("out.png"));
  ASSERT_EQ(error_text(picture), "");
  for (unsigned c = 0; c < 3; ++c) {
    EXPECT_EQ(pixel["value"][c].GetUint(), picture->texel(16, 11)[c]);
  }
}

}  // namespace

}  // namespace scenefile
