// Help, version, and errors in the command line.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;

void is_misuse(const std::vector<std::string>& arguments, const std::string& words) {
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_THAT(run.err, HasSubstr(words));
  if (std::find(arguments.begin(), arguments.end(), "--json") == arguments.end()) {
    EXPECT_EQ(run.out, "");
  } else {
    EXPECT_THAT(parse_json(run.out)["error"].GetString(), HasSubstr(words));
  }
}

TEST(Usage, SuggestsASimilarCommand) {
  is_misuse({"chekc", "a.xml"}, R"(unknown command "chekc"; did you mean check?)");
  is_misuse({"qqqqqq"}, R"(unknown command "qqqqqq")");
  is_misuse({"re\x1b[31mnder"}, R"("re\u{1b}[31mnder")");
  is_misuse({}, "scenefile render SCENE");
}

TEST(Usage, SuggestsTopicsOfHelp) {
  is_misuse({"help", "spot"}, R"(unknown topic "spot"; did you mean spot-falloff?)");
  is_misuse({"help", "gama"}, "did you mean gamma?");
  is_misuse({"help", "qqqqqq"}, R"(unknown topic "qqqqqq")");
}

TEST(Usage, ListsTheCodesOfAFamilyThatIsNamedLikeACommand) {
  for (const std::string family : {"render", "convert", "camera"}) {
    const ProgramRun codes = run_program({"help", "codes", family});
    EXPECT_EQ(codes.status, 0);
    EXPECT_THAT("\n" + codes.out, AllOf(HasSubstr("\n" + family + "."), HasSubstr("help CODE")));
    EXPECT_THAT(codes.out, ::testing::Not(HasSubstr("xml.number")));
  }
  EXPECT_THAT(run_program({"help", "render"}).out,
              HasSubstr("\n\"scenefile help codes render\" lists the codes render.*.\n"));
  EXPECT_THAT(run_program({"help", "frames"}).out, ::testing::Not(HasSubstr("help codes")));
  is_misuse({"help", "codes", "camara"}, "there are no codes camara.*; did you mean camera?");
  is_misuse({"help", "render", "frames"}, R"(help explains one topic; unexpected "frames")");
}

TEST(Usage, AcceptsTheOldSpellingOfCodes) {
  const ProgramRun today = run_program({"help", "xml.misspelled-element"});
  EXPECT_THAT(today.out, HasSubstr("xml.misspelled-element: "));
  EXPECT_EQ(run_program({"help", "xml.misspelt-element"}).out, today.out);
  const std::string folder = SCENEFILE_SOURCE "/tests/fixtures/format/";
  const std::string scene = folder + "xml.misspelled-transblock.xml";
  EXPECT_THAT(run_program({"check", scene}).err + run_program({"check", scene}).out,
              HasSubstr("xml.misspelled-transblock"));
  const ProgramRun allowed = run_program({"check", scene, "--allow", "xml.misspelt-transblock"});
  EXPECT_EQ(allowed.status, 0);
  EXPECT_THAT(allowed.out + allowed.err, ::testing::Not(HasSubstr("[xml.misspelled-transblock]")));
  EXPECT_EQ(run_program({"check", scene, "--deny", "xml.misspelt-transblock"}).status, 1);
}

TEST(Usage, SuggestsASimilarOption) {
  is_misuse({"render", "a.xml", "-o", "b.png", "--sise=3x4"},
            "render has no option --sise; did you mean --size?");
  is_misuse({"check", "a.xml", "--size", "3x4"}, "check has no option --size");
}

TEST(Usage, AcceptsFileNamesWithADashAfterTwoDashes) {
  const ProgramRun run = run_program({"check", "--quiet", "--", "-no-such-file.xml"});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("-no-such-file.xml: cannot open"));
  is_misuse({"check", "-no-such-file.xml"}, "check has no option -no-such-file.xml");
  is_misuse({"check", "--nosuch", "--", "a.xml"}, "check has no option --nosuch");
}

TEST(Usage, RejectsTwoOutputsOnStandardOutput) {
  is_misuse({"convert", "a.xml", "-", "--to", "json", "--json"},
            "the file and --json cannot both go to standard output");
  is_misuse({"version", "hello"}, "version takes no arguments; unexpected \"hello\"");
  is_misuse({"render", "a.xml", "-o", "-", "--json"}, "cannot both go to standard output");
  is_misuse({"render", "a.xml", "-o", "/dev/stdout", "--json"},
            "cannot both go to standard output");
}

TEST(Usage, StandardInputIsReadOnlyOnce) {
  const char* const once = "standard input can be read only once";
  is_misuse({"check", "-", "-"}, once);
  is_misuse({"diff", "a.png", "-", "--scene", "-"}, once);
  is_misuse({"explain", "-", "--pixel", "0,0", "--mine", "-"}, once);
  is_misuse({"explain", "a.xml", "--pixel", "0,0", "--mine", "-", "--reference", "-"}, once);
  is_misuse({"frames", "-", "--path", "-", "-o", "f%d.png"}, once);
}

TEST(Usage, WhatSelectsPathTracingIsNamed) {
  is_misuse({"render", "a.xml", "-o", "b.png", "--features", "shadows", "--direct-only"},
            "--features has no effect on paths: leave it out, or --direct-only");
  is_misuse({"explain", "a.xml", "--pixel", "0,0", "--mine", "a.png", "--reference", "b.png",
             "--mode", "path"},
            "--reference has no effect on paths: leave it out, or --mode path");
}

TEST(Usage, ValidatesValues) {
  const auto render = [](const std::string& option, const std::string& value) {
    return std::vector<std::string>{"render", "a.xml", "-o", "b.png", option, value};
  };
  is_misuse(render("--size", "big"), R"(--size: "big" is not a size such as 1024x768)");
  is_misuse(render("--size", "0x5"), R"("0" is not a whole number from 1 to)");
  is_misuse(render("--size", "5x65537"), "5x65537 is more than the limit of 65536 pixels per side");
  is_misuse(render("--size", "4x4x4"), R"("4x4" is not a whole number)");
  is_misuse(render("--profile", "curse"),
            R"(--profile: unknown profile "curse"; did you mean course?)");
  is_misuse(render("--profile", "nice"),
            R"(unknown profile "nice"; known: course, fine, realtime)");
  is_misuse(render("--engine", "embree"), R"(unknown engine "embree"; known: trace, gl)");
  is_misuse(render("--mode", "rays"), "did you mean ray?");
  is_misuse(render("--features", "shadows,reflection"), R"(unknown feature "reflection"; )");
  is_misuse(render("--features", "shadow"), "did you mean shadows?");
  is_misuse(render("--features", "shadows,none"), "--features: none cannot be combined");
  is_misuse(render("--samples", "0"), R"(--samples: "0" is not a whole number from 1)");
  is_misuse(render("--min-samples", "0"), R"(--min-samples: "0" is not a whole number from 1)");
  is_misuse(render("--min-samples", "17"),
            "--min-samples 17: more than the 16 of --samples; add --samples 17");
  is_misuse(render("--max-depth", "65"), "from 0 to 64");
  is_misuse(render("--threads", "-1"), "--threads");
  is_misuse(render("--seed", "1.5"), "--seed");
  is_misuse(render("--compat", "modern"), "course");
  is_misuse(render("--asset-root", "no/such"),
            R"(--asset-root: the folder "no/such" does not exist)");
  is_misuse(render("--asset-root", SCENEFILE_PROGRAM), "does not exist");
  is_misuse({"check", "a.xml", "--deny", "all"}, R"("all" is neither warnings nor a code)");
  is_misuse({"check", "a.xml", "--deny", "xml.numbre"}, "did you mean xml.number?");
  is_misuse({"check", "a.xml", "--json", "--sarif"}, "choose one");
  is_misuse({"check", "a.xml", "--allow", "xml.nosuch"}, R"(unknown code "xml.nosuch")");
}

TEST(Usage, ListsContainNoSpaces) {
  const std::vector<std::string> start{"render", "a.xml", "-o", "b.png"};
  const auto render = [&](std::vector<std::string> words) {
    words.insert(words.begin(), start.begin(), start.end());
    return words;
  };
  is_misuse(render({"--features", "shadows,", "reflect"}),
            R"(write the list "shadows," with commas and without spaces, such as shadows,reflect)");
  is_misuse(render({"--features", "shadows, reflect"}), "with commas and without spaces");
  is_misuse(render({"--features", "shadows,,reflect"}), "with commas and without spaces");
  is_misuse(render({"--aov", "depth,", "normal"}), "with commas and without spaces");
  is_misuse(render({"--crop", "1,", "2,", "3,", "4"}), "such as 100,50,300,200");
  is_misuse({"explain", "a.xml", "--pixel", "3,", "4"}, "such as 320,240");
}

TEST(Usage, ReportsMissingArguments) {
  is_misuse({"check"}, "check needs a scene");
  is_misuse({"render", "-o", "b.png"}, "render needs a scene");
  is_misuse({"render", "a.xml"}, "render needs an output");
  is_misuse({"render", "a.xml", "-o"}, "--output needs a value");
  is_misuse({"render", "a.xml", "b.xml", "-o", "b.png"}, R"(unexpected "b.xml")");
  is_misuse({"render", "a.xml", "-o", "b.jpg"}, "must end in .png, .exr or .pfm");
  is_misuse({"render", "a.xml", "-o", "b.JPEG"}, "JPEG changes colors");
  is_misuse({"render", "a.xml", "-o", "picture"}, "the name must end in .png, .exr or .pfm");
}

TEST(Usage, AnOptionIsNotTheNameOfAFile) {
  is_misuse({"render", "a.xml", "-o", "--size", "320x240"},
            R"(--output needs a value: --output OUT; a file "--size" is ./--size)");
  is_misuse({"grade", "class", "--references", "refs", "--gradescope", "-q"},
            R"(--gradescope needs a value: --gradescope OUT; a file "-q" is ./-q)");
  is_misuse({"diff", "a.png", "b.png", "--scene", "--json"}, "--scene needs a value");
  is_misuse({"check", "a.xml", "--asset-root", "--quiet"}, "--asset-root needs a value");
  is_misuse({"check", "a.xml", "--json=1"}, "--json takes no value");
}

TEST(Usage, TheCourseProfileRejectsSamples) {
  const std::vector<std::string> course{"render", "a.xml", "-o", "b.png", "--profile", "course"};
  for (const std::string option : {"--samples", "--min-samples", "--seed"}) {
    std::vector<std::string> words = course;
    words.insert(words.end(), {option, "3"});
    is_misuse(words, option + " is for the profile fine: leave it out, or --profile course");
  }
}

TEST(Usage, TheCourseProfileRejectsFresnel) {
  is_misuse({"render", "a.xml", "-o", "b.png", "--profile", "course", "--fresnel"},
            "--fresnel is for the profile fine");
}

TEST(Usage, VersionGoesToStandardOutput) {
  for (const std::string word : {"--version", "version"}) {
    const ProgramRun run = run_program({word});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.out, ::testing::MatchesRegex("scenefile " SCENEFILE_VERSION "\n"
                                                 "  build   [A-Za-z]+, [A-Za-z]+ [0-9.]+\n"
                                                 "  Embree  [34][.][0-9]+[.][0-9]+\n"
                                                 "  lanes   [A-Z0-9-]+\n"
                                                 "  docs    .*/docs\n"));
    EXPECT_EQ(run.err, "");
  }
  EXPECT_STREQ(parse_json(run_program({"version", "--json"}).out)["scenefile"].GetString(),
               SCENEFILE_VERSION);
  EXPECT_EQ(parse_json(run_program({"version", "--json"}).out)["embree"].GetString()[1], '.');
}

TEST(Usage, HelpListsTheCodesOfAFamily) {
  const ProgramRun camera = run_program({"help", "camera"});
  EXPECT_EQ(camera.status, 0);
  std::istringstream lines(camera.out);
  int count = 0;
  for (std::string line; std::getline(lines, line) && !line.empty();) {
    EXPECT_TRUE(line.starts_with("camera.") || line.starts_with("    ")) << line;
    count += line.starts_with("camera.") ? 1 : 0;
  }
  EXPECT_GT(count, 5);
  is_misuse({"help", "camra"}, "did you mean camera?");
}

TEST(Usage, HelpHasNoDoubleSpacesInItsFirstLine) {
  EXPECT_TRUE(run_program({"help", "version"}).out.starts_with("scenefile version [options]\n"));
}

TEST(Usage, HelpCoversCommandsAndCodes) {
  EXPECT_THAT(run_program({"help"}).out, HasSubstr("scenefile check SCENE..."));
  EXPECT_EQ(run_program({"--help"}).out, run_program({"help"}).out);
  const ProgramRun render = run_program({"help", "render"});
  EXPECT_EQ(render.status, 0);
  EXPECT_THAT(render.out, AllOf(HasSubstr("--features LIST"), HasSubstr("Examples:")));
  EXPECT_EQ(run_program({"render", "--help"}).out, render.out);
  EXPECT_THAT(run_program({"help", "camera.up-parallel-to-look"}).out,
              HasSubstr("the camera looks along its up direction (error)"));
  EXPECT_THAT(run_program({"help", "codes"}).out, HasSubstr("\nxml.number "));
  is_misuse({"help", "chek"}, "did you mean check?");
  is_misuse({"help", "camera.up-paralel-to-look"}, "did you mean camera.up-parallel-to-look?");
}

TEST(Usage, HelpExplainsWordsOfTheFormat) {
  EXPECT_THAT(run_program({"help", "rotate"}).out,
              AllOf(HasSubstr("<rotate> in XML: Rotates"), HasSubstr("\n  angle       Degrees.\n"),
                    HasSubstr("\"rotate\" in JSON, in group and templateGroup: Rotates")));
  EXPECT_THAT(run_program({"help", "vocabulary"}).out, HasSubstr("Attributes: x y z angle\n"));
  // A mistake, and an element.
  EXPECT_THAT(run_program({"help", "ambient"}).out,
              AllOf(HasSubstr("Where to look: "), HasSubstr("<ambient> in XML: ")));
  const rapidjson::Document rotate = parse_json(run_program({"help", "rotate", "--json"}).out);
  EXPECT_EQ(rotate["xml"].MemberCount(), 1U);
  EXPECT_TRUE(rotate["xml"]["rotate"]["attributes"].HasMember("angle"));
  EXPECT_TRUE(rotate["json"]["group"].HasMember("rotate"));
  EXPECT_FALSE(rotate["json"]["group"].HasMember("scale"));
  const rapidjson::Document blend = parse_json(run_program({"help", "blend", "--json"}).out);
  ASSERT_EQ(blend["values"].Size(), 1U);
  EXPECT_STREQ(blend["values"][0]["xml"].GetString(), "blend");
}

TEST(Usage, PartsOfHelpAreAnsweredInJson) {
  const auto help = [](const Words& words) {
    return parse_json(run_program(Words{"help"} + words + Words{"--json"}).out);
  };
  const rapidjson::Document all = help({});
  EXPECT_EQ(help({"codes"})["codes"], all["codes"]);
  EXPECT_EQ(help({"limits"})["limits"], all["limits"]);
  const rapidjson::Document limits = help({"limits"});
  EXPECT_FALSE(limits.HasMember("codes"));
  const rapidjson::Document rendering = help({"codes", "render"});
  EXPECT_LT(rendering["codes"].Size(), all["codes"].Size());
  for (const auto& code : rendering["codes"].GetArray()) {
    EXPECT_THAT(code["name"].GetString(), ::testing::StartsWith("render."));
  }
}

TEST(Usage, EveryAnswerInJsonBeginsAlike) {
  for (const Words& words : {Words{"help"},
                             {"help", "render"},
                             {"help", "xml.number"},
                             {"help", "shadows"},
                             {"help", "limits"},
                             {"help", "vocabulary"},
                             {"version"}}) {
    const std::string answer = run_program(words + Words{"--json"}).out;
    EXPECT_THAT(answer, ::testing::StartsWith("{\n  \"scenefile\": \"" SCENEFILE_VERSION
                                              "\",\n  \"command\": \"" +
                                              words[0] + "\","));
  }
}

TEST(Usage, HelpFitsATerminal) {
  for (const std::string command :
       {"render", "check", "info", "convert", "diff", "format", "help", "version"}) {
    std::istringstream lines(run_program({"help", command}).out);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 90U) << line;
    }
  }
}

std::size_t longest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) {
    longest = std::max(longest, line.size() - (line.ends_with('\r') ? 1 : 0));
  }
  return longest;
}

TEST(Usage, HelpIsAsWideAsTheTerminal) {
  const rapidjson::Document help = parse_json(run_program({"help", "--json"}).out);
  std::vector<std::vector<std::string>> pages{{"help"},
                                              {"help", "codes"},
                                              {"help", "causes"},
                                              {"help", "normals"},
                                              {"help", "limits"},
                                              {"help", "camera"},
                                              {"help", "xml.alias-attribute"}};
  for (const auto& command : help["commands"].GetArray()) {
    pages.push_back({"help", command["name"].GetString()});
  }
  for (const std::vector<std::string>& page : pages) {
    for (const std::size_t width : {60U, 40U}) {
      const std::string columns = "COLUMNS=" + std::to_string(width);
      const std::string text = run_program(page, {.environment = {columns}}).out;
      EXPECT_LE(longest_line(text), width) << text;
    }
    EXPECT_LE(longest_line(run_program(page, {.environment = {"COLUMNS="}}).out), 80U);
    RunSettings terminal{.environment = {"COLUMNS=", "TERM=xterm"}};
    terminal.terminal = true;
    terminal.columns = 50;
    EXPECT_LE(longest_line(run_program(page, terminal).out), 50U);
  }
  EXPECT_GT(longest_line(run_program({"help", "render"}, {.environment = {"COLUMNS=200"}}).out),
            90U);
}

TEST(Usage, OptionsAreUnderHeadings) {
  const std::string render = run_program({"help", "render"}).out;
  std::size_t last = 0;
  for (const char* heading : {"\nPicture:\n", "\nQuality:\n", "\nLayers:\n", "\nInput:\n",
                              "\nLimits:\n", "\nOutput:\n", "\nExamples:\n"}) {
    const std::size_t at = render.find(heading);
    ASSERT_NE(at, std::string::npos) << heading;
    EXPECT_GT(at, last) << heading;
    last = at;
  }
  const rapidjson::Document help = parse_json(run_program({"help", "--json"}).out);
  for (const auto& command : help["commands"].GetArray()) {
    const std::string text = run_program({"help", command["name"].GetString()}).out;
    EXPECT_THAT(text, ::testing::Not(HasSubstr("\nOther:\n"))) << "give it a heading in help.cpp";
    for (const auto& option : command["options"].GetArray()) {
      const std::string name = option["name"].GetString();
      EXPECT_TRUE(text.find("  " + name) != std::string::npos ||
                  text.find(", " + name) != std::string::npos)
          << name;
    }
  }
}

TEST(Usage, ThePageOfCodesIsUpToDate) {
  std::ifstream file(SCENEFILE_SOURCE "/docs/diagnostics.md", std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(run_program({"help", "--markdown"}).out, page)
      << "make docs updates docs/diagnostics.md";
}

TEST(Usage, EveryCodeHasAPage) {
  const rapidjson::Document help = parse_json(run_program({"help", "--json"}).out);
  ASSERT_GE(help["codes"].Size(), 200U);
  const std::regex form("[a-z]+[.][a-z0-9]+(-[a-z0-9]+)*");
  std::string last;
  for (const auto& code : help["codes"].GetArray()) {
    const std::string name = code["name"].GetString();
    EXPECT_TRUE(std::regex_match(name, form)) << name;
    EXPECT_LT(last, name) << "sorted, and each name once";
    const std::string_view summary = code["summary"].GetString();
    EXPECT_TRUE(summary.size() > 5 && summary.size() < 80) << name;
    EXPECT_FALSE(summary.ends_with('.')) << name;
    const std::string_view text = code["help"].GetString();
    EXPECT_GT(text.size(), 10U) << name;
    EXPECT_TRUE(text.ends_with('.')) << name;
    last = name;
  }
  EXPECT_EQ(help["commands"].Size(), 13U);
}

}  // namespace

}  // namespace scenefile
