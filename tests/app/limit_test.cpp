// Limits on time and memory.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string deep_scene(int levels) {
  std::string text = "<scenefile><object name=\"root\" type=\"tree\">";
  for (int i = 0; i < levels; ++i) {
    text += "<transblock><object type=\"tree\">";
  }
  text += "<transblock><object type=\"primitive\" name=\"sphere\"/></transblock>";
  for (int i = 0; i < levels; ++i) {
    text += "</object></transblock>";
  }
  return text + "</object></scenefile>";
}

// A scene with ten instances of a group with ten instances of a group ... of a sphere.
std::string template_bomb(int levels) {
  std::string text = "<scenefile>";
  std::string last = "<object type=\"primitive\" name=\"sphere\"/>";
  for (int i = 0; i < levels; ++i) {
    text += "<object type=\"tree\" name=\"t" + std::to_string(i) + "\">";
    for (int k = 0; k < 10; ++k) {
      text += "<transblock><translate x=\"" + std::to_string(k) + "\" y=\"0\" z=\"0\"/>" + last +
              "</transblock>";
    }
    text += "</object>";
    last = "<object type=\"master\" name=\"t" + std::to_string(i) + "\"/>";
  }
  return text + "<object type=\"tree\" name=\"root\"><transblock>" + last +
         "</transblock></object></scenefile>";
}

// A chain of templates, each with one instance of the next.
std::string template_chain(int levels) {
  std::string text = "<scenefile>";
  std::string last = "<object type=\"primitive\" name=\"sphere\"/>";
  for (int i = 0; i <= levels; ++i) {
    const std::string name = i == levels ? "root" : "t" + std::to_string(i);
    text += "<object type=\"tree\" name=\"" + name + "\"><transblock>" + last +
            "</transblock></object>";
    last = "<object type=\"master\" name=\"" + name + "\"/>";
  }
  return text + "</scenefile>";
}

// Every command that reads a scene, with each kind of output.
std::vector<std::vector<std::string>> all_uses(const std::string& scene) {
  return {{"check", scene},
          {"check", "--json", scene},
          {"check", "--sarif", scene},
          {"info", "--tree", scene},
          {"convert", scene, "o.xml"},
          {"convert", scene, "o.json"},
          {"convert", scene, "o.pov"},
          {"format", "--check", scene},
          {"diff", scene, scene},
          {"diff", scene, "good.xml"},
          {"diff", "good.xml", scene},
          {"explain", scene, "--pixel", "1,1", "--size", "4x3"},
          {"render", scene, "-o", "o.png", "--size", "4x3"},
          {"render", scene, "-o", "o.exr", "--size", "4x3", "--aov", "depth,normal,object-id"},
          {"render", scene, "-o", "o.png", "--size", "4x3", "--profile", "course"},
          {"render", scene, "-o", "o.png", "--size", "4x3", "--mode", "intersect"},
          {"render", scene, "-o", "o.png", "--size", "4x3", "--engine", "gl"}};
}

struct ProgramLimits : ProgramFolder {};

TEST_F(ProgramLimits, NestingUpToTheLimitNeedsNoStack) {
  folder.write("good.xml", good_scene);
  // 1,024 nested elements, and 1,000 nested templates.
  folder.write("deep.xml", deep_scene(510));
  folder.write("chain.xml", template_chain(1000));
  for (const std::string scene : {"deep.xml", "chain.xml"}) {
    for (const std::vector<std::string>& words : all_uses(scene)) {
      const ProgramRun run = run_program(words, {.folder = folder.path(), .stack_kilobytes = 256});
      // 1: the files differ, or could be formatted better. 3: this machine has no OpenGL. 4: JSON
      // would need deeper nesting than allowed.
      EXPECT_THAT((std::set{0, 1, 3, 4}), ::testing::Contains(run.status))
          << ::testing::PrintToString(words) << run.err;
    }
  }
}

TEST_F(ProgramLimits, TemplateBombsEndEveryCommand) {
  folder.write("good.xml", good_scene);
  folder.write("bomb.xml", template_bomb(40));
  for (std::vector<std::string> words : all_uses("bomb.xml")) {
    // The OpenGL driver needs additional memory.
    const bool gl = words.back() == "gl";
    words.insert(words.end(), {"--max-memory", gl ? "2G" : "512M", "--timeout", "100"});
    const ProgramRun run = program(words);
    EXPECT_THAT((std::set{0, 1, 3, 4}), ::testing::Contains(run.status))
        << ::testing::PrintToString(words) << run.err;
  }
}

TEST_F(ProgramLimits, EachIsSetByName) {
  const std::string scene = folder.write("deep.xml", deep_scene(50));
  EXPECT_EQ(run_program({"check", scene}).status, 0);
  const ProgramRun run = run_program({"check", scene, "--limit", "nesting=40"});
  EXPECT_EQ(run.status, 4);
  EXPECT_THAT(run.out, HasSubstr("deeper than the limit of 40"));
  EXPECT_THAT(run.out, HasSubstr("help limits"));
  EXPECT_EQ(run_program({"check", scene, "--limit", "file-bytes=1K"}).status, 4);
  EXPECT_EQ(run_program({"check", folder.write("deeper.xml", deep_scene(600))}).status, 4);
  EXPECT_EQ(run_program({"check", folder.path("deeper.xml"), "--limit=nesting=2000"}).status, 0);
}

TEST_F(ProgramLimits, TheSizeOfPicturesMattersToCommandsThatDraw) {
  const std::string scene = folder.write("a.xml", good_scene);
  EXPECT_EQ(run_program({"check", scene, "--limit", "image-side=500"}).status, 0);
  const ProgramRun drawn =
      run_program({"render", scene, "-o", folder.path("a.png"), "--limit", "image-side=500"});
  EXPECT_EQ(drawn.status, 2);
  EXPECT_THAT(drawn.err, HasSubstr("--size: 1024x768, the default, is more than the limit of 500"));
}

TEST_F(ProgramLimits, AreListedWithTheirDefaults) {
  const ProgramRun run = run_program({"help", "limits"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("  nesting                 1024  nested elements"));
  EXPECT_THAT(run.out, HasSubstr("  file-bytes                1G  "));
}

TEST_F(ProgramLimits, InvalidLimitsAreUsageErrors) {
  const auto mistake = [](const std::string& option, const std::string& value) {
    const ProgramRun run = run_program({"check", "a.xml", option, value});
    EXPECT_EQ(run.status, 2) << value;
    return run.err;
  };
  EXPECT_THAT(mistake("--limit", "nestin=3"), HasSubstr("did you mean nesting?"));
  EXPECT_THAT(mistake("--limit", "nesting"), HasSubstr("NAME=VALUE"));
  EXPECT_THAT(mistake("--limit", "nesting=0"), HasSubstr("not a whole number from 1 to"));
  EXPECT_THAT(mistake("--limit", "nesting=3M"), HasSubstr("not a whole number"));
  EXPECT_THAT(mistake("--limit", "file-bytes=99999999999G"), HasSubstr("not a number of bytes"));
  EXPECT_THAT(mistake("--max-memory", "1"), HasSubstr("not a number of bytes"));
  EXPECT_THAT(mistake("--max-memory", "G"), HasSubstr("not a number of bytes"));
  EXPECT_THAT(mistake("--timeout", "0"), HasSubstr("not a number of seconds"));
  EXPECT_THAT(mistake("--timeout", "soon"), HasSubstr("not a number of seconds"));
}

TEST_F(ProgramLimits, TemplateBombsAreCountedAndRenderedAsInstances) {
  const std::string scene = folder.write("bomb.xml", template_bomb(40));
  EXPECT_THAT(run_program({"info", scene}).out, HasSubstr("about 1e+40"));
  const ProgramRun run = run_program({"render", scene, "-o", folder.path("o.png"), "--size", "8x6",
                                      "--max-memory", "512M", "--timeout", "200"});
  EXPECT_THAT((std::set{0, 4}), ::testing::Contains(run.status)) << run.err;
}

TEST_F(ProgramLimits, TheTimeoutLeavesNoOutput) {
  folder.write("s.xml", good_scene);
  folder.write("out.png", "old");
  const ProgramRun run =
      program({"render", "s.xml", "-o", "out.png", "--size", "8000x8000", "--timeout", "0.3"});
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(run.err, "scenefile: stopped: not finished within 0.3 s (--timeout)\n");
  EXPECT_EQ(folder.read("out.png"), "old");
  EXPECT_THAT(folder.list(), ElementsAre("out.png", "s.xml"));
}

TEST_F(ProgramLimits, AGenerousTimeoutChangesNothing) {
  const std::string scene = folder.write("s.xml", good_scene);
  EXPECT_EQ(run_program({"check", scene, "--timeout", "100", "--max-memory", "2G"}).status, 0);
}

TEST_F(ProgramLimits, ExceedingTheMemoryLimitIsStatus4) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need additional memory";
#endif
  folder.write("s.xml", good_scene);
  const ProgramRun run = program(
      {"render", "s.xml", "-o", "out.png", "--size", "20000x20000", "--max-memory", "300M"});
  EXPECT_EQ(run.status, 4);
  EXPECT_THAT(run.err, HasSubstr("more memory than --max-memory 314572800 is needed for tracing"));
  EXPECT_THAT(folder.list(), ElementsAre("s.xml"));
}

}  // namespace

}  // namespace scenefile
