#include "scenefile/edit/edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace scenefile {

namespace {

Result<std::string> camera_set(std::string_view bytes, const Camera& camera,
                               const ReadOptions& options) {
  const Result<Document> document = Document::open(std::string(bytes), options);
  const Result<Edit> edit = document ? set_camera(*document, camera) : document.error();
  return edit ? Result<std::string>(applied(bytes, *edit)) : edit.error();
}

// The edited file; empty if the edit was refused.
std::string edited(std::string_view bytes, const Camera& camera, const ReadOptions& options) {
  const Result<std::string> result = camera_set(bytes, camera, options);
  return result ? *result : std::string();
}

std::string refusal(std::string_view bytes, const Camera& camera, const ReadOptions& options) {
  return error_text(camera_set(bytes, camera, options));
}

using ::testing::HasSubstr;

std::string with_camera(const std::string& camera) {
  return "<?xml version='1.0'?>\n<!-- mine -->\n<scenefile>\n"
         "  <globaldata><ambientcoeff v=\"1\"/><diffusecoeff v=\"1\"/><specularcoeff v=\"1\"/>"
         "</globaldata>\n" +
         camera +
         "\n  <object type=\"tree\" name=\"root\">\n    <transblock>\n"
         "      <object type=\"primitive\" name=\"sphere\"><diffuse r=\"1\" g=\"0\" b=\"0\"/>"
         "</object>\n    </transblock>\n  </object>\n</scenefile>\n";
}

const std::string block =
    "\t<cameradata> <!-- keep -->\r\n\t\t<pos z='3.50' x = \"1.0\"  y=\"2\" />\n"
    "    <look x=\"0\" y=\"0\" z=\"-1\"></look>\n"
    "    <up x=\"0\" y=\"1\" z=\"0\"/><heightangle v=\"45.0\"/>\n  </cameradata>";

Camera camera_at(glm::vec3 position, glm::vec3 look = {0, 0, -1}, float angle = 45) {
  Camera camera;
  camera.position = position;
  camera.look = look;
  camera.up = {0, 1, 0};
  camera.height_angle_deg = angle;
  return camera;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(SetCamera, ChangesTheNumbersThatDifferAndNothingElse) {
  const std::string text = with_camera(block);
  EXPECT_EQ(edited(text, camera_at({1, 2, 3.5F}), {}), text);
  EXPECT_EQ(edited(text, camera_at({1, 2.25F, 3.5F}), {}),
            replaced(text, "y=\"2\" />", "y=\"2.25\" />"));
  EXPECT_EQ(
      edited(text, camera_at({1, 2, 3.5F}, {-1, 0, 0}, 30), {}),
      replaced(replaced(text, "<look x=\"0\" y=\"0\" z=\"-1\">", "<look x=\"-1\" y=\"0\" z=\"0\">"),
               "45.0", "30"));
}

TEST(SetCamera, FocusIsAPoint) {
  const std::string text = with_camera(replaced(block, "<look x=\"0\" y=\"0\" z=\"-1\"></look>",
                                                "<focus x=\"1\" y=\"2\" z=\"0\"/>"));
  EXPECT_EQ(edited(text, camera_at({1, 2, 7}, {0, 0, -7}), {}), replaced(text, "'3.50'", "'7'"));
  EXPECT_EQ(edited(text, camera_at({1, 2, 3.5F}, {0, 1, 0.5F}), {}),
            replaced(text, "<focus x=\"1\" y=\"2\" z=\"0\"/>", "<focus x=\"1\" y=\"3\" z=\"4\"/>"));
}

TEST(SetCamera, FocusIsRoundedOnlyWhereItChanges) {
  const std::string text =
      replaced(with_camera(replaced(block, "<look x=\"0\" y=\"0\" z=\"-1\"></look>",
                                    "<focus x=\"0.1234567\" y=\"2\" z=\"0\"/>")),
               "x = \"1.0\"", "x = \"0\"");
  EXPECT_EQ(edited(text, camera_at({0, 2, 3.5F}, {0.1234567F, 0, -3.5F}), {}), text);
  EXPECT_EQ(edited(text, camera_at({0, 2, 3.5F}, {0.1234567F, 0.1F, -3.2F}), {}),
            replaced(text, "y=\"2\" z=\"0\"/>", "y=\"2.1\" z=\"0.3\"/>"));
}

TEST(SetCamera, OtherSpellings) {
  const std::string text = with_camera(
      "<cameradata><pos a=\"1\" b=\"2\" c=\"3\"/><look x=\"0\" y=\"0\" z=\"-1\"/>"
      "<up x=\"0\" y=\"1\" z=\"0\"/><angle value=\"45\"/></cameradata>");
  const std::string edit = edited(text, camera_at({1, 2, 4}, {0, 0, -1}, 60), {});
  EXPECT_EQ(edit, replaced(replaced(text, "c=\"3\"", "c=\"4\""), "\"45\"", "\"60\""));
}

TEST(SetCamera, TheLastCameraCounts) {
  const std::string text = with_camera(block + "\n" + block);
  const std::string edit = edited(text, camera_at({1, 9, 3.5F}), {});
  EXPECT_EQ(edit, with_camera(block + "\n" + replaced(block, "y=\"2\"", "y=\"9\"")));
}

TEST(SetCamera, MissingValuesAreAddedInTheStyleOfTheirNeighbors) {
  const std::string text = with_camera(
      "  <cameradata>\n    <pos x=\"1\" y=\"2\" z=\"3\"/>\n    <look x=\"0\" y=\"0\" "
      "z=\"-1\"></look>\n  </cameradata>");
  EXPECT_EQ(edited(text, camera_at({1, 2, 3}), {}), text);
  EXPECT_EQ(edited(text, camera_at({1, 2, 3}, {0, 0, -1}, 50), {}),
            replaced(text, "</look>", "</look>\n    <heightangle v=\"50\"/>"));
  const std::string empty = with_camera("  <cameradata>\n  </cameradata>");
  EXPECT_THAT(edited(empty, camera_at({1, 2, 3}), {}),
              HasSubstr("<cameradata>\n    <pos x=\"1\" y=\"2\" z=\"3\"/>\n    <look"));
}

TEST(SetCamera, AFileWithoutCameraGetsOne) {
  const std::string edit = edited(with_camera(""), camera_at({1, 2, 3}), {});
  EXPECT_EQ(edit,
            replaced(with_camera(""), "</globaldata>",
                     "</globaldata>\n  <cameradata>\n    <pos x=\"1\" y=\"2\" z=\"3\"/>\n"
                     "    <look x=\"0\" y=\"0\" z=\"-1\"/>\n    <up x=\"0\" y=\"1\" z=\"0\"/>\n"
                     "    <heightangle v=\"45\"/>\n  </cameradata>"));
}

const std::string camera_json =
    "\xEF\xBB\xBF{ \"name\": \"a\",\n  \"globalData\": {\"ambientCoeff\":1, \"diffuseCoeff\":1,"
    " \"specularCoeff\":1},\n  \"cameraData\": {\"position\": [1.0, 2 ,3], \"up\":[0,1,0],\n"
    "     \"heightAngle\": 4.5e1, \"look\": [0.0, 0, -1]},\n  \"groups\": [\n"
    "    {\"primitives\": [{\"type\":\"sphere\"}]}\n  ]\n}\n";

TEST(SetCamera, OtherErrorsDoNotMatter) {
  const std::string text = replaced(with_camera(block), "sphere", "spheree");
  EXPECT_EQ(edited(text, camera_at({1, 2, 4}), {}), replaced(text, "3.50", "4"));
  EXPECT_EQ(edited("<scenefile><object type=\"tree\" name=\"root\"/></scenefile>",
                   camera_at({1, 2, 3}), {}),
            "<scenefile><cameradata><pos x=\"1\" y=\"2\" z=\"3\"/><look x=\"0\" y=\"0\" "
            "z=\"-1\"/><up x=\"0\" y=\"1\" z=\"0\"/><heightangle v=\"45\"/></cameradata>"
            "<object type=\"tree\" name=\"root\"/></scenefile>");
}

TEST(SetCamera, Json) {
  EXPECT_EQ(edited(camera_json, camera_at({1, 2, 3}), {}), camera_json);
  EXPECT_EQ(edited(camera_json, camera_at({1, -2.5F, 3}, {0, 0, -1}, 20), {}),
            replaced(replaced(camera_json, "2 ,", "-2.5 ,"), "4.5e1", "20"));
}

TEST(SetCamera, JsonFocus) {
  const std::string text = replaced(camera_json, "\"look\": [0.0, 0, -1]", "\"focus\": [1, 2, 0]");
  EXPECT_EQ(edited(text, camera_at({1, 2, 5}, {0, 0, -5}), {}), replaced(text, ",3]", ",5]"));
}

TEST(SetCamera, RejectsWhatItCannotExpress) {
  const Camera camera = camera_at({1, 2, 3});
  EXPECT_THAT(refusal("<scenefile>", camera, {}), HasSubstr("correct that in the text first"));
  EXPECT_EQ(edited("<scenefile>", camera, {}), "");
  std::string wide = "\xFF\xFE";
  for (const char c : with_camera(block)) {
    wide += {c, '\0'};
  }
  EXPECT_THAT(refusal(wide, camera, {}), HasSubstr("UTF-16"));
  const std::string repaired = replaced(camera_json, "4.5e1", "45.");
  const ReadOptions compat{.compat_course = true, .limits = {}};
  EXPECT_THAT(refusal(repaired, camera_at({4, 2, 3}), compat), HasSubstr("45."));
}

TEST(SetCamera, LatinLettersStay) {
  std::string text = "<?xml version='1.0' encoding='iso-8859-1'?><!-- \xE9 -->" +
                     with_camera(block).substr(with_camera(block).find("<scenefile>"));
  EXPECT_EQ(edited(text, camera_at({1, 2, 4}), {}), replaced(text, "3.50", "4"));
}

// The file gets any camera it is given, and setting the old camera restores the same bytes.
RC_GTEST_PROP(SetCamera, ThereAndBack, ()) {
  const auto part = [] { return static_cast<float>(*rc::gen::inRange(-9999, 9999)) / 64; };
  Camera camera = camera_at({part(), part(), part()}, {part(), part(), part()});
  RC_PRE(glm::length(camera.look) > 0.5F && std::abs(camera.look.x) > 0.1F);
  camera.height_angle_deg = 1 + std::abs(part());
  RC_PRE(camera.height_angle_deg < 170);
  const std::string text = *rc::gen::element(with_camera(block), camera_json);
  const Camera before = camera_at(text == camera_json ? glm::vec3{1, 2, 3} : glm::vec3{1, 2, 3.5F});
  const std::string there = edited(text, camera, {});
  RC_ASSERT(!there.empty());
  Diagnostics found;
  RC_ASSERT(*read_scene(there, {}, found).camera == camera);
  const std::string again = edited(there, camera, {});
  RC_ASSERT(again == there);
  const std::string back = edited(there, before, {});
  const std::string twice = edited(back, camera, {});
  RC_ASSERT(twice == there);
}

}  // namespace

}  // namespace scenefile
