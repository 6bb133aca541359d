// For every code of the program: an input that causes it, and a similar one that does not.
// codes_test.cpp covers the codes that `check` reports for scene files; this file covers other
// commands and limits, and tests that no code is missing.

#include "app/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
namespace fs = std::filesystem;

const fs::path fixtures = SCENEFILE_FIXTURES;

// A command that causes the code, and a similar one that does not.
struct Recipe {
  std::function<ProgramRun()> gives;
  std::function<ProgramRun()> near_miss;
};

class AllCodes : public ProgramFolder {
 protected:
  // The file for the code in tests/fixtures/commands.
  static std::string file(const std::string& code, const std::string& ending) {
    for (const std::string syntax : {".xml", ".json", ".ini", ".gltf"}) {
      const fs::path path = fixtures / "commands" / (code + ending + syntax);
      if (fs::exists(path)) {
        return path.string();
      }
    }
    return {};
  }

  static std::string family_of(const std::string& code) { return code.substr(0, code.find('.')); }

  ProgramRun run_family(const std::string& code, const std::string& ending) const {
    const std::string path = file(code, ending);
    EXPECT_NE(path, "") << code << ending;
    const std::string family = family_of(code);
    if (family == "config") {
      return run_program({path},
                         {.folder = folder.path(""),
                          .program = fs::path(SCENEFILE_PROGRAM).parent_path() / "projects_ray"});
    }
    if (family == "render") {
      return run_program({"render", path, "--profile", "course", "--mode", "intersect", "--size",
                          "8x8", "-o", folder.path("p.png")});
    }
    if (family == "realtime") {
      return run_program({"check", path, "--profile", "realtime"});
    }
    if (family == "gl") {
      // In JSON, because render does not print notes.
      return run_program({"render", path, "--engine", "gl", "--size", "8x8", "-o",
                          folder.path("p.png"), "--json"});
    }
    const std::string other = fs::path(path).extension() == ".xml" ? "out.json" : "out.xml";
    const std::string out = family == "pov" ? "out.pov" : family == "export" ? "out.glb" : other;
    return run_program({"convert", path, folder.path(out)});
  }

  // The scene for the code, copied to IN/ and converted to OUT/.
  ProgramRun convert_away(const std::string& code, const std::string& out) const {
    fs::remove_all(folder.path("in"));
    fs::create_directories(folder.path("away"));
    fs::copy(fixtures / "commands/in", folder.path("in"), fs::copy_options::recursive);
    return run_program({"convert", folder.path("in/" + code + ".xml"), folder.path(out)});
  }

  static ProgramRun check(const std::string& path, const std::string& limit) {
    std::vector<std::string> words{"check", (fixtures / path).string()};
    if (!limit.empty()) {
      words.insert(words.end(), {"--limit", limit});
    }
    return run_program(words);
  }

  ProgramRun import(const std::string& limit) const {
    const std::string model = (fixtures / "commands/import.value.ok.gltf").string();
    return run_program({"convert", model, folder.path("m.xml"), "--limit", limit});
  }

  ProgramRun convert_nested(const std::string& limit) const {
    const std::string scene = (fixtures / "commands/write.transforms-nested.xml").string();
    return run_program({"convert", scene, folder.path("n.json"), "--limit", limit});
  }

  Recipe limited(const std::string& path, const std::string& limit) const {
    return {[=] { return check(path, limit); }, [=] { return check(path, ""); }};
  }

  std::map<std::string, Recipe> recipes() const {
    return {
        {"convert.file-renamed",
         {[=, this] { return convert_away("convert.file-renamed", "out.json"); },
          [=, this] { return convert_away("convert.file-renamed", "in/out.json"); }}},
        {"convert.file-left-behind",
         {[=, this] { return convert_away("convert.file-left-behind", "away/out.json"); },
          [=, this] { return convert_away("convert.file-left-behind", "in/out.json"); }}},
        {"import.limit",
         {[=, this] { return import("mesh-bytes=100"); },
          [=, this] { return import("mesh-bytes=10000"); }}},
        {"json.limit", limited("format_json/json.comment.ok.json", "nesting=2")},
        {"light.count-limit", limited("commands/light.count-limit.json", "lights=1")},
        {"mesh.limit", limited("codes/mesh.degenerate.ok.xml", "mesh-triangles=1")},
        {"mtl.limit", limited("codes/mtl.value.ok.xml", "mesh-bytes=600")},
        {"texture.limit", limited("codes/material.texture-without-blend.ok.xml", "texture-side=1")},
        {"tree.nesting-limit",
         limited("codes/tree.used-before-declared.ok.xml", "instance-nesting=1")},
        {"write.nesting-limit",
         {[=, this] { return convert_nested("nesting=6"); },
          [=, this] { return convert_nested("nesting=7"); }}},
        {"xml.attribute-limit", limited("codes/scene.empty.ok.xml", "attributes=2")},
        {"xml.length-limit", limited("codes/scene.empty.ok.xml", "name-bytes=5")},
        {"xml.light-limit", limited("codes/light.many.ok.xml", "lights=3")},
        {"xml.nesting-limit", limited("codes/scene.empty.ok.xml", "nesting=3")},
    };
  }
};

bool says(const ProgramRun& run, const std::string& code) {
  const auto has = [](const std::string& text, const std::string& mark) {
    return text.find(mark) != std::string::npos;
  };
  const std::string mark = "[" + code + "]";
  return has(run.out, mark) || has(run.err, mark) || has(run.out, "\"code\": \"" + code + '"');
}

std::vector<std::string> all_codes() {
  const rapidjson::Document help = parse_json(run_program({"help", "--json"}).out);
  std::vector<std::string> codes;
  for (const auto& code : help["codes"].GetArray()) {
    codes.emplace_back(code["name"].GetString());
  }
  return codes;
}

// Codes that no command can cause, only a program that makes a scene itself, and the tables of
// cases in which rooms test them.
const std::map<std::string, std::string> by_programs{
    {"scene.bad-index", "tests/scene/check_test.cpp"},
    {"scene.not-finite", "tests/scene/check_test.cpp"},
    {"scene.shared-node", "tests/scene/check_test.cpp"},
    {"tree.instance-with-contents", "tests/scene/check_test.cpp"},
    {"write.light-limit", "tests/format/write_scene_test.cpp"}};

bool has_check_fixture(const std::string& code) {
  for (const std::string folder : {"codes", "format", "format_json"}) {
    for (const std::string syntax : {".xml", ".json"}) {
      if (fs::exists(fixtures / folder / (code + syntax))) {
        return true;
      }
    }
  }
  return false;
}

TEST_F(AllCodes, EachIsTriggeredByACommandAndNotByASimilarOne) {
  const auto special = recipes();
  for (const std::string& code : all_codes()) {
    const auto recipe = special.find(code);
    if (recipe != special.end()) {
      EXPECT_TRUE(says(recipe->second.gives(), code)) << code;
      EXPECT_FALSE(says(recipe->second.near_miss(), code)) << code;
    } else if (!has_check_fixture(code) && !by_programs.contains(code) && family_of(code) != "gl") {
      EXPECT_TRUE(says(run_family(code, ""), code)) << code;
      EXPECT_FALSE(says(run_family(code, ".ok"), code)) << code;
    }
  }
}

TEST_F(AllCodes, EachOfOpenGlIsTriggeredByACommandAndNotByASimilarOne) {
  for (const std::string& code : all_codes()) {
    if (family_of(code) != "gl") {
      continue;
    }
    const ProgramRun run = run_family(code, "");
    if (run.status == 3) {
      GTEST_SKIP() << run.err;
    }
    EXPECT_TRUE(says(run, code)) << code;
    EXPECT_FALSE(says(run_family(code, ".ok"), code)) << code;
  }
}

TEST_F(AllCodes, ThoseOfProgramsAreTestedInTheirRooms) {
  const std::vector<std::string> codes = all_codes();
  for (const auto& [code, test] : by_programs) {
    EXPECT_NE(std::find(codes.begin(), codes.end(), code), codes.end()) << code;
    std::ifstream file(fixtures.parent_path().parent_path() / test);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find('"' + code + "\"_code,"), std::string::npos) << code << " in " << test;
  }
}

TEST_F(AllCodes, EachFileBelongsToAnExistingCode) {
  const std::vector<std::string> codes = all_codes();
  for (const auto& entry : fs::recursive_directory_iterator(fixtures / "commands")) {
    std::string name = entry.path().stem().string();
    if (!entry.is_regular_file() || entry.path().extension() == ".png") {
      continue;
    }
    if (name.ends_with(".ok")) {
      name.resize(name.size() - 3);
    }
    EXPECT_NE(std::find(codes.begin(), codes.end(), name), codes.end()) << entry.path();
  }
}

// The severities that `help` lists for a code are exactly those in reports.
TEST_F(AllCodes, SeveritiesAreThoseThatHelpNames) {
  std::map<std::string, std::set<std::string>> named;
  const rapidjson::Document help = parse_json(run_program({"help", "--json"}).out);
  for (const auto& code : help["codes"].GetArray()) {
    std::set<std::string>& severities = named[code["name"].GetString()];
    severities.insert(code["severity"].GetString());
    if (code.HasMember("otherwise")) {
      severities.insert(code["otherwise"].GetString());
    }
  }
  std::map<std::string, std::set<std::string>> reported;
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--compat", "course"}, {"--allow-missing"}}) {
    std::vector<std::string> words{"check", "--json"};
    words.insert(words.end(), options.begin(), options.end());
    for (const std::string part : {"codes", "format", "format_json", "severities"}) {
      for (const auto& entry : fs::directory_iterator(fixtures / part)) {
        const std::string extension = entry.path().extension();
        if (extension == ".xml" || extension == ".json") {
          words.push_back(entry.path());
        }
      }
    }
    const rapidjson::Document report = parse_json(run_program(words).out);
    for (const auto& scene : report["scenes"].GetArray()) {
      for (const auto& finding : scene["findings"].GetArray()) {
        reported[finding["code"].GetString()].insert(finding["severity"].GetString());
      }
    }
  }
  for (const auto& [code, severities] : reported) {
    EXPECT_EQ(severities, named[code]) << code;
  }
}

}  // namespace

}  // namespace scenefile
