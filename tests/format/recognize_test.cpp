#include "scenefile/format/recognize.h"

#include <gtest/gtest.h>

namespace scenefile {

namespace {

using namespace std::string_view_literals;

TEST(Recognize, ScenesByName) {
  EXPECT_TRUE(is_scene_name("a/b.xml"));
  EXPECT_TRUE(is_scene_name("B.JSON"));
  EXPECT_FALSE(is_scene_name("b.png"));
  EXPECT_FALSE(is_scene_name("xml"));
}

TEST(Recognize, ScenesByContent) {
  for (const std::string_view text :
       {"<scenefile/>"sv, "<?xml version='1.0'?><!-- a --><SceneFile>"sv, "<scene><globaldata/>"sv,
        "<scenefile><a></b>"sv, "<s:scenefile xmlns:s='x'/>"sv, "{\"globalData\": {}}"sv,
        "{\"name\": \"a\", \"groups\": []}"sv, "<scenfile>"sv, "<object><transblock/>"sv,
        "\"cameraData\": {"sv, "// a\n{\"CAMERADATA\": {}, }"sv,
        "{\"x\": [1, {\"y\": \"}\"}], \"templateGroups\":"sv,
        "\xff\xfe<\0s\0c\0e\0n\0e\0"
        "f\0i\0l\0e\0/\0>\0"sv}) {
    EXPECT_TRUE(may_be_scene(text)) << text;
  }
}

TEST(Recognize, FilesOfOtherPrograms) {
  for (const std::string_view text :
       {"<testsuites><testsuite/></testsuites>"sv,
        "<project xmlns='x'><scene/>scenefile</project>"sv,
        "{\"name\": \"tool\", \"scripts\": {\"groups\": 1}}"sv, "[]"sv, "{}"sv,
        "{\"groups\": [], \"realm\": 1}"sv, "<scenery/>"sv, "<a b='<'/><scene/>"sv,
        "[{\"groups\": []}]"sv, "{\"a\": \"\\\"\", \"b\": \"groups\\\"\"}"sv, "{\""sv}) {
    EXPECT_FALSE(may_be_scene(text)) << text;
  }
}

TEST(Recognize, BrokenFilesAreLeftToTheReader) {
  for (const std::string_view text :
       {""sv, " \n"sv, "scenefile>"sv, "<!DOCTYPE html><html>"sv, "\xff\xff<"sv,
        "version https://git-lfs.github.com/spec/v1"sv}) {
    EXPECT_TRUE(may_be_scene(text)) << text;
  }
}

}  // namespace

}  // namespace scenefile
