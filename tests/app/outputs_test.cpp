// No output replaces an input: every command, with every option that writes a file, for every file
// that the command reads.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

// A way to write a file.
struct Writer {
  std::string command;
  std::string option;  // "OUT": an argument
  Words words;         // the whole command line
  std::string target;  // a file that it writes
};

const std::vector<std::string> scene_files{"scene.xml", "image/bricks.png", "mesh/tri.obj",
                                           "mesh/tri.mtl", "mesh/map.png"};
const std::vector<std::string> class_files{"refs/ball.png",    "refs/ball.xml",
                                           "map.csv",          "references.tsv",
                                           "image/bricks.png", "class/ann/sphere.png"};

const Words render{"render", "scene.xml", "--size", "8x6"};
const Words frames{"frames", "scene.xml", "--size", "8x6", "--path", "views.json"};
const Words diff{"diff", "a.png", "b.png", "--scene", "scene.xml"};
const Words grade{"grade", "class", "--references", "refs", "--map", "map.csv"};

const std::vector<Writer> writers{
    {"render", "--output", render + Words{"-o", "out.png"}, "out.png"},
    {"render", "--output", render + Words{"-o", "out.png", "--mode", "intersect"}, "out.png"},
    {"render", "--output", render + Words{"-o", "out.png", "--aov", "depth"}, "out.depth.png"},
    {"render", "--output", render + Words{"-o", "out.png", "--store", "bands"}, "out.png"},
    {"render", "--store", render + Words{"-o", "new.png", "--store", "new"}, "new/00000-00006.exr"},
    {"render", "--store", render + Words{"--part", "1/2", "--store", "new"}, "new/00000-00006.exr"},
    {"frames", "--output", frames + Words{"-o", "f%02d.png"}, "f02.png"},
    {"frames", "--output", frames + Words{"-o", "f%02d.png", "--overwrite"}, "f02.png"},
    {"frames", "--output", frames + Words{"-o", "f%d.png", "--aov", "depth"}, "f2.depth.png"},
    {"frames", "--write-scenes", frames + Words{"--write-scenes", "s%d.xml"}, "s2.xml"},
    {"frames", "--write-scenes", frames + Words{"--write-scenes", "s%d.xml", "--overwrite"},
     "s2.xml"},
    {"frames", "--video", frames + Words{"-o", "f%d.png", "--video", "v.gif"}, "v.gif"},
    {"frames", "--video", frames + Words{"--video", "v.gif"}, "v.gif"},
    {"convert", "OUT", {"convert", "scene.xml", "out.json"}, "out.json"},
    {"convert", "OUT", {"convert", "scene.xml", "out.obj"}, "out.obj"},
    {"convert", "OUT", {"convert", "scene.xml", "out.obj"}, "out.mtl"},
    {"convert", "OUT", {"convert", "scene.xml", "out.obj"}, "out-1.png"},
    {"convert", "OUT", {"convert", "model/box.obj", "out.xml"}, "out.xml"},
    {"convert", "OUT", {"convert", "model/box.obj", "out.xml"}, "out-1.png"},
    {"convert", "OUT", {"convert", "model/box.obj", "out.xml"}, "out-2.obj"},
    {"diff", "--heatmap", diff + Words{"--heatmap", "h.png"}, "h.png"},
    {"diff", "--sheet", diff + Words{"--sheet", "h.png"}, "h.png"},
    {"diff", "--energy", diff + Words{"--energy", "light.svg", "--time", "0.1"}, "light.svg"},
    {"grade", "--store", grade + Words{"--store", "results"}, "results/ann.json"},
    {"grade", "--store", grade + Words{"--part", "1/1", "--store", "results"}, "results/ann.json"},
    {"grade", "--csv", grade + Words{"--store", "graded", "--csv", "g.csv"}, "g.csv"},
    {"grade", "--report", grade + Words{"--report", "r.html"}, "r.html"},
    {"grade", "--pages", grade + Words{"--pages", "pages"}, "pages/ann.html"},
    {"grade", "--csv", grade + Words{"--csv", "r.csv"}, "r.csv"},
    {"grade", "--csv-students", grade + Words{"--csv-students", "s.csv"}, "s.csv"},
    {"grade", "--junit", grade + Words{"--junit", "r.xml"}, "r.xml"},
    {"grade", "--gradescope", grade + Words{"--gradescope", "r.json"}, "r.json"},
    {"view",
     "--screenshot",
     {"view", "scene.xml", "a.png", "--script", "steps.txt", "--screenshot", "w.png"},
     "w.png"},
    {"view",
     "--script",
     {"view", "scene.xml", "--reference", "a.png", "--mine", "b.png", "--script", "steps.txt"},
     "step.png"},
};

std::vector<std::string> inputs_of(const Writer& writer) {
  const auto with = [](std::vector<std::string> files, const std::vector<std::string>& more) {
    files.insert(files.end(), more.begin(), more.end());
    return files;
  };
  const Words& words = writer.words;
  return writer.command == "frames" ? with(scene_files, {"views.json"})
         : writer.command == "diff" ? with(scene_files, {"a.png", "b.png"})
         : writer.command == "view"
             ? with(scene_files, words[2] == "a.png" ? Words{"a.png", "steps.txt"}
                                                     : Words{"a.png", "b.png", "steps.txt"})
         : writer.command == "grade" ? class_files
         : words[1] == "model/box.obj"
             ? std::vector<std::string>{"model/box.obj", "model/box.mtl", "model/bricks.png"}
             : scene_files;
}

struct Outputs : ProgramFolder {
  Outputs() {
    std::string scene = scene_with(
        R"(<diffuse r="1" g="0.5" b="0"/><blend v="1"/><texture file="image/bricks.png" u="1" v="1"/>)");
    folder.write("flat.xml", good_scene);
    EXPECT_EQ(run({"render", "flat.xml", "-o", "a.png", "--size", "8x6"}).status, 0);
    for (const char* const name :
         {"image/bricks.png", "mesh/map.png", "model/bricks.png", "refs/ball.png"}) {
      folder.write(name, folder.read("a.png"));
    }
    folder.write("refs/ball.xml", scene);
    const std::string mesh =
        R"(<object type="primitive" name="mesh" filename="mesh/tri.obj"/></transblock>)";
    scene.replace(scene.find("</transblock>"), 13, "</transblock>\n<transblock>" + mesh);
    folder.write("scene.xml", scene);
    const std::string triangle = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
    folder.write("mesh/tri.obj", "mtllib none.mtl tri.mtl\nusemtl m\n" + triangle);
    folder.write("mesh/tri.mtl", "newmtl m\nKd 1 1 1\nmap_Kd map.png\n");
    folder.write("model/box.obj", "mtllib box.mtl\nusemtl m\n" + triangle);
    folder.write("model/box.mtl", "newmtl m\nKd 1 1 1\nmap_Kd bricks.png\n");
    folder.write("views.json", R"({"fps": 2, "views": [{"time": 0}, {"time": 1,
                                   "position": [0, 1, 4]}]})");
    folder.write("steps.txt", "settle\nscreenshot step.png\n");
    folder.write("map.csv", "sphere,ball\n");
    folder.write("references.tsv", "");
    EXPECT_EQ(run(Words{"render", "scene.xml", "--size", "8x6", "-o", "b.png"}).status, 0);
    folder.write("class/ann/sphere.png", folder.read("a.png"));
    folder.write("bin/ffmpeg", "#!/bin/sh\nfor out; do :; done\necho \"$@\" > \"$out\"\n");
    fs::permissions(folder.path("bin/ffmpeg"), fs::perms::owner_all);
    EXPECT_EQ(run(render + Words{"--store", "bands", "--part", "1/1"}).status, 0);
    EXPECT_EQ(run(grade + Words{"--store", "graded", "--part", "1/1"}).status, 0);
  }

  ProgramRun run(const Words& words) const {
    return run_program(words, {.environment = {"PATH=" + folder.path("bin") + ":/usr/bin:/bin"},
                               .folder = folder.path()});
  }
};

// The words of the usage texts for values that are not files.
const std::set<std::string> other_values{
    "",        "WxH",        "X,Y",     "NAME",   "N",   "LIST", "P1,P2",       "DEPTH",
    "DB",      "CODE",       "PERCENT", "FORMAT", "I/N", "A:B",  "X0,Y0,X1,Y1", "BYTES",
    "SECONDS", "NAME=VALUE", "WHAT",    "SHELL",  "DIR", "P",    "STOPS",       "TEXT"};

TEST(OutputsTable, HasEveryOptionThatNamesAFile) {
  const rapidjson::Document help = parse_json(run_program({"help", "--json"}).out);
  for (const auto& command : help["commands"].GetArray()) {
    const std::string name = command["name"].GetString();
    const auto is_in_table = [&](const auto& matches) {
      return std::any_of(writers.begin(), writers.end(), [&](const Writer& writer) {
        return writer.command == name && matches(writer);
      });
    };
    const auto writes = [&](const std::string& option) {
      return is_in_table([&](const Writer& writer) { return writer.option == option; });
    };
    for (const auto& option : command["options"].GetArray()) {
      const std::string word = option["name"].GetString();
      const std::string value = option["value"].GetString();
      if (value == "OUT" || value == "OUTDIR" || value == "PATTERN") {
        EXPECT_TRUE(writes(word)) << name << " " << word;
      } else if (value == "FILE" || value == "PICTURE" || value == "SCENE") {
        const bool reads = is_in_table([&](const Writer& writer) {
          return std::find(writer.words.begin(), writer.words.end(), word) != writer.words.end();
        });
        EXPECT_TRUE(reads || !is_in_table([](const Writer&) { return true; }))
            << name << " " << word;
      } else {
        EXPECT_EQ(other_values.count(value), 1u)
            << name << " " << word << " " << value << ": is it a file to read or to write?";
      }
    }
    std::istringstream arguments(command["arguments"].GetString());
    for (std::string word; arguments >> word && !word.starts_with('-');) {
      EXPECT_TRUE(word != "OUT" || writes("OUT")) << name;
    }
  }
}

TEST_F(Outputs, ReplaceNoInput) {
  const bool window = fs::exists(fs::path(SCENEFILE_PROGRAM).parent_path() / "scenefile-window");
  bool hard = false;
  for (const Writer& writer : writers) {
    if (writer.command == "view" && !window) {
      continue;
    }
    const std::vector<std::string> inputs = inputs_of(writer);
    // Each input is linked in both ways, by different options.
    hard = inputs.size() % 2 == 0 ? !hard : hard;
    for (const std::string& input : inputs) {
      hard = !hard;
      std::string line;
      for (const std::string& word : writer.words) {
        line += word + " ";
      }
      SCOPED_TRACE(line + "with " + writer.target + " a link to " + input);
      const std::string before = folder.read(input);
      const fs::path link = folder.path(writer.target);
      fs::create_directories(link.parent_path());
      fs::remove(link);  // of another row
      hard ? fs::create_hard_link(folder.path(input), link)
           : fs::create_symlink(folder.path(input), link);
      const ProgramRun refused = run(writer.words);
      EXPECT_EQ(refused.status, 2) << refused.err;
      EXPECT_THAT(
          refused.err,
          AllOf(HasSubstr(fs::path(writer.target).filename()), HasSubstr(" would replace the "),
                HasSubstr(fs::path(input).filename()), HasSubstr("; choose another name\n")));
      EXPECT_TRUE(folder.read(input) == before);
      EXPECT_TRUE(fs::exists(link));
      fs::remove(link);
    }
    if (writer.command != "view") {
      const ProgramRun written = run(writer.words);
      EXPECT_LT(written.status, 2) << writer.option << ": " << written.err;
    }
  }
}

TEST_F(Outputs, ReplaceNoOtherOutput) {
  fs::create_directory(folder.path("web"));
  for (const Words& words : {render + Words{"-o", "bands/00000-00006.exr", "--store", "bands"},
                             render + Words{"-o", "web/00000-00006.exr", "--store", "./web"},
                             frames + Words{"-o", "v%d.png", "--video", "v1.png"},
                             frames + Words{"--write-scenes", "v%d.xml", "--video", "v2.xml"},
                             diff + Words{"--heatmap", "x.png", "--sheet", "image/../x.png"},
                             grade + Words{"--csv", "x", "--junit", "x"},
                             grade + Words{"--store", "graded", "--csv", "graded/ann.json"},
                             grade + Words{"--pages", "web", "--report", "web/ann.html"}}) {
    const ProgramRun refused = run(words);
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(" would replace the "));
    EXPECT_FALSE(fs::exists(folder.path("x.png")) || fs::exists(folder.path("x")) ||
                 fs::exists(folder.path("v1.png")) || !fs::is_empty(folder.path("web")));
  }
}

TEST_F(Outputs, SayBothRolesAndNames) {
  const ProgramRun run_of_scene = run(render + Words{"-o", "image/bricks.png"});
  EXPECT_EQ(run_of_scene.err,
            "scenefile: the output image/bricks.png would replace the texture image/bricks.png of "
            "the scene; choose another name\n");
  const rapidjson::Document answer =
      parse_json(run(render + Words{"-o", "image/bricks.png", "--json"}).out);
  EXPECT_THAT(answer["scene"]["error"].GetString(), HasSubstr("would replace the texture"));
}

TEST_F(Outputs, MayShareDevicesAndReplaceOlderOutputs) {
  EXPECT_EQ(run(grade + Words{"--csv", "/dev/null", "--junit", "/dev/null"}).status, 0);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(run(render + Words{"-o", "bands/x.png", "--store", "bands"}).status, 0);
    EXPECT_EQ(run(grade + Words{"--report", "class/r.html", "--pages", "class/pages"}).status, 0);
    EXPECT_EQ(run({"format", "flat.xml"}).status, 0);  // rewrites its input by design
  }
}

TEST_F(Outputs, OfTheCoursesProgram) {
  for (const std::string output : {"scene.xml", "image/bricks.png", "config.ini"}) {
    folder.write("config.ini",
                 "[IO]\nscene = scene.xml\noutput = " + output +
                     "\n[Canvas]\nwidth = 8\nheight = 6\n[Feature]\ntexture = true\n");
    const std::string before = folder.read(output);
    const std::string program = folder.path("projects_ray");
    fs::create_symlink(SCENEFILE_PROGRAM, program);
    const ProgramRun refused =
        run_program({"config.ini"}, {.folder = folder.path(), .program = program});
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("the output " + output + " would replace the "));
    EXPECT_TRUE(folder.read(output) == before);
    fs::remove(program);
  }
}

}  // namespace
}  // namespace scenefile
