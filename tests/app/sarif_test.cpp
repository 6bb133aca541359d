// check --sarif: the requirements of SARIF 2.1.0, and additional ones of code hosts.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::HasSubstr;

using Value = rapidjson::Value;

std::string text_of(const Value& message) {
  return message["text"].GetString();
}

struct Sarif : ProgramFolder {
  rapidjson::Document check(std::vector<std::string> arguments, int status) {
    arguments.insert(arguments.begin(), {"check", "--sarif"});
    const ProgramRun run = program(arguments);
    EXPECT_EQ(run.status, status);
    EXPECT_EQ(run.err, "");
    return parse_json(run.out);
  }
};

// Sections 3.13, 3.14, 3.18, 3.19 and 3.27 of the standard.
void expect_valid(const rapidjson::Document& log) {
  EXPECT_STREQ(log["version"].GetString(), "2.1.0");
  ASSERT_EQ(log["runs"].Size(), 1u);
  const Value& run = log["runs"][0];
  const Value& driver = run["tool"]["driver"];
  EXPECT_STREQ(driver["name"].GetString(), "scenefile");
  const std::set<std::string> levels{"none", "note", "warning", "error"};
  std::set<std::string> ids;
  for (const Value& rule : driver["rules"].GetArray()) {
    EXPECT_TRUE(ids.insert(rule["id"].GetString()).second);
    EXPECT_NE(text_of(rule["shortDescription"]), "");
    EXPECT_NE(text_of(rule["fullDescription"]), "");
    EXPECT_NE(text_of(rule["help"]), "");
    EXPECT_TRUE(levels.contains(rule["defaultConfiguration"]["level"].GetString()));
  }
  for (const Value& result : run["results"].GetArray()) {
    const Value& rule = driver["rules"][result["ruleIndex"].GetUint()];
    EXPECT_STREQ(result["ruleId"].GetString(), rule["id"].GetString());
    EXPECT_TRUE(levels.contains(result["level"].GetString()));
    EXPECT_NE(text_of(result["message"]), "");
    EXPECT_NE(result["partialFingerprints"]["codeAndLine/v1"].GetStringLength(), 0u);
    ASSERT_EQ(result["locations"].Size(), 1u);
    const Value& place = result["locations"][0]["physicalLocation"];
    const std::regex uri(R"((file://)?([A-Za-z0-9._~/-]|%[0-9A-F]{2})+)");
    EXPECT_TRUE(std::regex_match(place["artifactLocation"]["uri"].GetString(), uri));
    EXPECT_GE(place["region"]["startLine"].GetInt(), 1);
    if (place["region"].HasMember("startColumn")) {
      EXPECT_GE(place["region"]["startColumn"].GetInt(), 1);
    }
  }
}

TEST_F(Sarif, IsValidWithoutFindings) {
  folder.write("s.xml", good_scene);
  const rapidjson::Document log = check({"s.xml"}, 0);
  expect_valid(log);
  EXPECT_EQ(log["runs"][0]["results"].Size(), 0u);
  EXPECT_TRUE(log["runs"][0]["invocations"][0]["executionSuccessful"].GetBool());
}

TEST_F(Sarif, FindingsHaveLevelsAndPlaces) {
  folder.write("a b/\xc3\xa4.xml", scene_with("<difuse r=\"\xc3\xa4\xff\"/><blend v=\"1\"/>"));
  folder.write("s.json", "{}");
  const rapidjson::Document log = check({"a b/\xc3\xa4.xml", "s.json"}, 1);
  expect_valid(log);
  const Value& run = log["runs"][0];
  EXPECT_STREQ(run["columnKind"].GetString(), "unicodeCodePoints");
  const Value& place = run["results"][0]["locations"][0]["physicalLocation"];
  EXPECT_STREQ(place["artifactLocation"]["uri"].GetString(), "a%20b/%C3%A4.xml");
  EXPECT_STREQ(place["artifactLocation"]["uriBaseId"].GetString(), "%SRCROOT%");
  EXPECT_EQ(run["invocations"][0]["exitCode"].GetInt(), 1);
  EXPECT_EQ(place["region"]["startLine"].GetInt(), 15);
  EXPECT_STREQ(run["results"][0]["level"].GetString(), "error");
}

// Code hosts use them to recognize findings when lines are added or removed before them.
TEST_F(Sarif, FingerprintsDoNotDependOnTheLine) {
  const std::string twice = "<blend v=\"1\"/><difuse/>\n<shine v=\"a\"/>";
  folder.write("s.xml", scene_with(twice));
  const auto prints = [&] {
    std::vector<std::string> result;
    const rapidjson::Document log = check({"s.xml"}, 1);
    for (const Value& found : log["runs"][0]["results"].GetArray()) {
      result.emplace_back(found["partialFingerprints"]["codeAndLine/v1"].GetString());
    }
    return result;
  };
  const std::vector<std::string> before = prints();
  EXPECT_GE(before.size(), 4u);
  EXPECT_EQ(std::set<std::string>(before.begin(), before.end()).size(), before.size());
  folder.write("s.xml", "\n\n" + scene_with(twice));
  EXPECT_EQ(prints(), before);
}

TEST_F(Sarif, FollowsThePolicy) {
  folder.write("s.xml", scene_with(R"(<blend v="1"/>)"));
  EXPECT_STREQ(check({"s.xml"}, 0)["runs"][0]["results"][0]["level"].GetString(), "note");
  const std::string code = "material.blend-without-texture";
  const rapidjson::Document denied = check({"--deny", code, "s.xml"}, 1);
  expect_valid(denied);
  EXPECT_STREQ(denied["runs"][0]["results"][0]["level"].GetString(), "error");
  EXPECT_EQ(check({"--allow", code, "s.xml"}, 0)["runs"][0]["results"].Size(), 0u);
}

TEST_F(Sarif, FindingsInAMeshArePlacedThereAndNameTheScene) {
  folder.write("meshes/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  std::string text = scene_with("");
  const std::string sphere = R"(name="sphere")";
  ASSERT_NE(text.find(sphere), std::string::npos);
  text.replace(text.find(sphere), sphere.size(), R"(name="mesh" filename="t.obj")");
  folder.write("s.xml", text);
  const rapidjson::Document log = check({"s.xml"}, 1);
  expect_valid(log);
  bool found = false;
  for (const Value& result : log["runs"][0]["results"].GetArray()) {
    const Value& place = result["locations"][0]["physicalLocation"];
    const std::string uri = place["artifactLocation"]["uri"].GetString();
    if (!text_of(result["message"]).starts_with("t.obj:4: ")) {
      EXPECT_EQ(uri, "s.xml");
      continue;
    }
    found = true;
    EXPECT_EQ(uri, "meshes/t.obj");
    EXPECT_EQ(place["region"]["startLine"].GetInt(), 4);
    const Value& scene = result["relatedLocations"][0]["physicalLocation"];
    EXPECT_STREQ(scene["artifactLocation"]["uri"].GetString(), "s.xml");
    EXPECT_GT(scene["region"]["startLine"].GetInt(), 1);
  }
  EXPECT_TRUE(found);
  // In text and JSON, the path starts where that of the scene does.
  text.replace(text.find("t.obj"), 5, "u.obj");
  folder.write("a/s.xml", text);
  folder.write("a/meshes/u.obj", "v 0 0 0\nf 1 2 4\n");
  EXPECT_THAT(program({"check", "a/s.xml"}).out, ::testing::HasSubstr("\na/meshes/u.obj:2:"));
  EXPECT_THAT(program({"check", "a/s.xml", "--json"}).out,
              ::testing::HasSubstr("\"path\": \"a/meshes/u.obj\""));
}

TEST_F(Sarif, UnreadableFilesAreNotifications) {
  folder.write("s.xml", good_scene);
  const rapidjson::Document log = check({"none.xml", "s.xml"}, 3);
  expect_valid(log);
  const Value& invocation = log["runs"][0]["invocations"][0];
  EXPECT_FALSE(invocation["executionSuccessful"].GetBool());
  EXPECT_THAT(text_of(invocation["toolExecutionNotifications"][0]["message"]),
              HasSubstr("none.xml: cannot open"));
}

}  // namespace

}  // namespace scenefile
