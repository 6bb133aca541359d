// Every rule of the union of the XML dialects: how it is read, what is reported, and a near miss
// that is read or reported differently.

#include "format/reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace scenefile::testing {
namespace {

using ::testing::ElementsAreArray;

using Frame = std::string (*)(std::string_view);
using Codes = std::vector<std::string>;

std::string in_camera(std::string_view part) {
  return with_top(fmt::format("<cameradata>{}</cameradata>", part));
}

// A complete camera, except that `part` replaces one of its four values.
std::string camera_with(std::string_view part) {
  std::string rest;
  const std::pair<std::string_view, std::string_view> parts[] = {
      {"pos", "<pos x=\"0\" y=\"0\" z=\"5\"/>"},
      {"look", "<look x=\"0\" y=\"0\" z=\"-1\"/>"},
      {"up", "<up x=\"0\" y=\"1\" z=\"0\"/>"},
      {"angle", "<heightangle v=\"45\"/>"}};
  for (const auto& [name, text] : parts) {
    const bool given =
        part.find(name) != part.npos || (name == "look" && part.find("focus") != part.npos);
    rest += given ? "" : text;
  }
  return in_camera(std::string(part) + rest);
}

// A complete point light, except for `part`.
std::string light_with(std::string_view part) {
  std::string rest;
  const std::pair<std::string_view, std::string_view> parts[] = {
      {"<id", "<id v=\"1\"/>"},
      {"<color", "<color r=\"1\" g=\"1\" b=\"1\"/>"},
      {"<position", "<position x=\"0\" y=\"5\" z=\"0\"/>"}};
  for (const auto& [name, text] : parts) {
    rest += part.find(name) == part.npos ? text : "";
  }
  return with_top(fmt::format("<lightdata>{}{}</lightdata>", part, rest));
}

std::string directional_light_with(std::string_view part) {
  return with_top(
      fmt::format("<lightdata><id v=\"1\"/><color r=\"1\" g=\"1\" b=\"1\"/>{}</lightdata>", part));
}

std::string whole(std::string_view text) {
  return std::string(text);
}

std::string in_block(std::string_view object) {
  return in_root(fmt::format("<transblock>{}</transblock>", object));
}

struct Rule {
  const char* name;
  Frame frame;
  const char* spelled;
  const char* meant;  // the same scene in the standard dialect
  Codes said;         // reported for `spelled`
  const char* near_miss;
  Codes said_of_near_miss;
};

void PrintTo(const Rule& rule, std::ostream* out) {
  *out << rule.name;
}

const Codes nothing;
const Codes alias{"warning xml.alias-attribute"};
const Codes positional{"warning xml.positional-attributes"};
const Codes lacking{"error xml.missing-attribute"};
const Codes unknown{"warning xml.unknown-attribute"};
const Codes misspelled{"error xml.misspelled-attribute"};

const std::vector<Rule> rules = {
    {"scene_in_other_case",
     whole,
     "<SceneFile><object type=\"tree\" name=\"root\"/></SceneFile>",
     "<scenefile><object type=\"tree\" name=\"root\"/></scenefile>",
     {"warning xml.name-case"},
     "<scene/>",
     {"error xml.root-element", "warning xml.no-root"}},
    {"coefficient_value", with_top, "<globaldata><ambientcoeff value=\"0.2\"/></globaldata>",
     "<globaldata><ambientcoeff v=\"0.2\"/></globaldata>", alias,
     "<globaldata><ambientcoeff/></globaldata>", lacking},
    {"coefficient_any_name",
     with_top,
     "<globaldata><specularcoeff ks=\"0.2\"/></globaldata>",
     "<globaldata><specularcoeff v=\"0.2\"/></globaldata>",
     alias,
     "<globaldata><specularcoeff ks=\"0.2\" q=\"1\"/></globaldata>",
     {"warning xml.unknown-attribute", "warning xml.unknown-attribute",
      "error xml.missing-attribute"}},
    {"later_globals_win",
     with_top,
     "<globaldata><ambientcoeff v=\"0.1\"/></globaldata>"
     "<globaldata><ambientcoeff v=\"0.2\"/></globaldata>",
     "<globaldata><ambientcoeff v=\"0.2\"/></globaldata>",
     {"warning xml.duplicate-element"},
     "<globaldata/><lightdata><id v=\"0\"/><color r=\"1\" g=\"1\" b=\"1\"/>"
     "<position x=\"0\" y=\"0\" z=\"0\"/></lightdata>",
     nothing},
    {"camera_point_by_order",
     camera_with,
     "<pos a=\"1\" b=\"2\" c=\"3\"/>",
     "<pos x=\"1\" y=\"2\" z=\"3\"/>",
     positional,
     "<pos a=\"1\" b=\"2\"/>",
     {"warning xml.unknown-attribute", "warning xml.unknown-attribute",
      "error xml.missing-attribute"}},
    {"names_before_order", camera_with, "<up z=\"0\" y=\"1\" x=\"0\"/>",
     "<up x=\"0\" y=\"1\" z=\"0\"/>", nothing, "<up u=\"0\" v=\"1\" w=\"0\"/>", positional},
    {"focus_is_a_point",
     camera_with,
     "<pos x=\"0\" y=\"0\" z=\"5\"/><focus x=\"0\" y=\"0\" z=\"4\"/>",
     "<look x=\"0\" y=\"0\" z=\"-1\"/>",
     nothing,
     "<look x=\"0\" y=\"0\" z=\"-1\"/><focus x=\"0\" y=\"0\" z=\"4\"/>",
     {"error xml.look-and-focus"}},
    {"angle_for_heightangle",
     camera_with,
     "<angle v=\"30\"/>",
     "<heightangle v=\"30\"/>",
     {"warning xml.alias-element"},
     "<hieghtangle v=\"30\"/>",
     {"error xml.misspelled-element"}},
    {"heightangle_any_name", camera_with, "<heightangle deg=\"30\"/>", "<heightangle v=\"30\"/>",
     alias, "<heightangle v=\"30\" deg=\"30\"/>", unknown},
    {"aspectratio_is_left_out",
     camera_with,
     "<aspectratio v=\"1\"/><up x=\"0\" y=\"1\" z=\"0\"/>",
     "<up x=\"0\" y=\"1\" z=\"0\"/>",
     {"note xml.ignored-element"},
     "<curve x=\"1\" y=\"1\" z=\"1\"/>",
     {"warning xml.unknown-element"}},
    {"light_type_id", light_with, "<type id=\"point\"/>", "<type v=\"point\"/>", alias, "<type/>",
     lacking},
    {"light_type_thing", light_with, "<type thing=\"point\"/>", "", alias,
     "<type thing=\"point\" v=\"point\"/>", unknown},
    {"light_type_in_other_case",
     light_with,
     "<type v=\"Point\"/>",
     "<type v=\"point\"/>",
     {"warning xml.name-case"},
     "<type v=\"Pont\"/>",
     {"error xml.light-type"}},
    {"light_number",
     light_with,
     "<number v=\"1\"/><id v=\"1\"/>",
     "<id v=\"1\"/>",
     {"warning xml.alias-element", "warning xml.duplicate-element"},
     "<id v=\"one\"/>",
     {"warning xml.light-id"}},
    {"light_id_any_name", light_with, "<id number=\"1\"/>", "<id v=\"1\"/>", alias, "<id/>",
     lacking},
    {"light_color_as_vector",
     light_with,
     "<color x=\"1\" y=\"0\" z=\"0\"/>",
     "<color r=\"1\" g=\"0\" b=\"0\"/>",
     alias,
     "<color x=\"1\" y=\"0\"/>",
     {"warning xml.alias-attribute", "error xml.missing-attribute"}},
    {"light_color_by_order",
     light_with,
     "<color red=\"1\" green=\"0\" blue=\"0\"/>",
     "<color r=\"1\" g=\"0\" b=\"0\"/>",
     positional,
     "<color r=\"1\" green=\"0\" blue=\"0\"/>",
     {"error xml.missing-attribute", "error xml.missing-attribute"}},
    {"function_as_vector", light_with, "<function x=\"1\" y=\"2\" z=\"3\"/>",
     "<function v1=\"1\" v2=\"2\" v3=\"3\"/>", nothing, "<function x=\"1\" y=\"2\"/>", lacking},
    {"function_as_letters", light_with, "<function a=\"1\" b=\"2\" c=\"3\"/>",
     "<function v1=\"1\" v2=\"2\" v3=\"3\"/>", nothing, "<function a=\"1\" b=\"2\" d=\"3\"/>",
     lacking},
    {"function_by_order",
     light_with,
     "<function k=\"1\" l=\"2\" q=\"3\"/>",
     "<function v1=\"1\" v2=\"2\" v3=\"3\"/>",
     positional,
     "<function k=\"1\" l=\"2\"/>",
     {"warning xml.unknown-attribute", "warning xml.unknown-attribute",
      "error xml.missing-attribute"}},
    {"direction_before_type",
     directional_light_with,
     "<direction x=\"0\" y=\"-1\" z=\"0\"/><type v=\"directional\"/>",
     "<type v=\"directional\"/><direction x=\"0\" y=\"-1\" z=\"0\"/>",
     nothing,
     "<direction x=\"0\" y=\"-1\" z=\"0\"/><type v=\"point\"/><position x=\"0\" y=\"0\" z=\"0\"/>",
     {"warning xml.light-unused"}},
    {"position_of_a_directional_light",
     directional_light_with,
     "<type v=\"directional\"/><direction x=\"0\" y=\"-1\" z=\"0\"/>"
     "<position x=\"3\" y=\"3\" z=\"3\"/>",
     "<type v=\"directional\"/><direction x=\"0\" y=\"-1\" z=\"0\"/>"
     "<position x=\"3\" y=\"3\" z=\"3\"/>",
     {"warning xml.light-unused"},
     "<type v=\"point\"/><position x=\"3\" y=\"3\" z=\"3\"/>",
     nothing},
    {"radius_is_left_out",
     light_with,
     "<radius v=\"1\"/>",
     "",
     {"warning xml.ignored-element"},
     "<raduis v=\"1\"/>",
     {"error xml.misspelled-element", "warning xml.ignored-element"}},
    {"type_and_id_of_a_light_as_attributes",
     with_top,
     "<lightdata id=\"1\" type=\"point\"><color r=\"1\" g=\"1\" b=\"1\"/>"
     "<position x=\"0\" y=\"5\" z=\"0\"/></lightdata>",
     "<lightdata><id v=\"1\"/><color r=\"1\" g=\"1\" b=\"1\"/>"
     "<position x=\"0\" y=\"5\" z=\"0\"/></lightdata>",
     {"warning xml.alias-attribute", "warning xml.alias-attribute"},
     "<lightdata name=\"sun\"><id v=\"1\"/><color r=\"1\" g=\"1\" b=\"1\"/>"
     "<position x=\"0\" y=\"5\" z=\"0\"/></lightdata>",
     unknown},
    {"name_in_front_of_type",
     in_block,
     "<object name=\"cube\" type=\"primitive\"/>",
     "<object type=\"primitive\" name=\"cube\"/>",
     {"warning xml.attribute-order"},
     "<object name=\"cube\"/>",
     lacking},
    {"meshfile",
     in_block,
     "<object type=\"primitive\" name=\"mesh\" meshfile=\"a.obj\"/>",
     "<object type=\"primitive\" name=\"mesh\" filename=\"a.obj\"/>",
     nothing,
     "<object type=\"primitive\" name=\"mesh\" meshfile=\"a.obj\" filename=\"b.obj\"/>",
     {"warning xml.mesh-files"}},
    {"mesh_file_any_name", in_block, "<object type=\"primitive\" name=\"mesh\" path=\"a.obj\"/>",
     "<object type=\"primitive\" name=\"mesh\" filename=\"a.obj\"/>", alias,
     "<object type=\"primitive\" name=\"cube\" path=\"a.obj\"/>", unknown},
    {"shape_in_other_case",
     in_block,
     "<object type=\"primitive\" name=\"Cube\"/>",
     "<object type=\"primitive\" name=\"cube\"/>",
     {"warning xml.name-case"},
     "<object type=\"primitive\" name=\"qube\"/>",
     {"error xml.misspelled-shape"}},
    {"object_type_in_other_case",
     in_block,
     "<object type=\"Primitive\" name=\"cube\"/>",
     "<object type=\"primitive\" name=\"cube\"/>",
     {"warning xml.name-case"},
     "<object type=\"primitve\" name=\"cube\"/>",
     {"error xml.object-type"}},
    {"object_without_transblock",
     in_root,
     "<object type=\"primitive\" name=\"cube\"/>",
     "<transblock><object type=\"primitive\" name=\"cube\"/></transblock>",
     {"warning xml.object-without-transblock"},
     "<diffuse r=\"1\" g=\"1\" b=\"1\"/>",
     {"warning xml.misplaced-element"}},
    {"misspelled_transblock",
     in_root,
     "<tranblock><object type=\"primitive\" name=\"cube\"/></tranblock>",
     "<transblock><object type=\"primitive\" name=\"cube\"/></transblock>",
     {"warning xml.misspelled-transblock"},
     "<block><object type=\"primitive\" name=\"cube\"/></block>",
     {"warning xml.unknown-element"}},
    {"name_of_a_transblock", in_root,
     "<transblock name=\"left\"><object type=\"primitive\" name=\"cube\"/></transblock>",
     "<transblock><object type=\"primitive\" name=\"cube\"/></transblock>", unknown,
     "<transblock><object type=\"tree\" name=\"left\"><transblock><object type=\"primitive\" "
     "name=\"cube\"/></transblock></object></transblock>",
     nothing},
    {"vector_by_order",
     with_transforms,
     "<scale sx=\"1\" sy=\"2\" sz=\"3\"/>",
     "<scale x=\"1\" y=\"2\" z=\"3\"/>",
     positional,
     "<scale x=\"1\" sy=\"2\" sz=\"3\"/>",
     {"error xml.misspelled-attribute", "error xml.misspelled-attribute"}},
    {"vector_in_other_case",
     with_transforms,
     "<scale Z=\"3\" Y=\"2\" X=\"1\"/>",
     "<scale x=\"1\" y=\"2\" z=\"3\"/>",
     {"warning xml.name-case", "warning xml.name-case", "warning xml.name-case",
      "warning xml.attribute-order"},
     "<scale Z=\"3\" Y=\"2\" W=\"1\"/>",
     positional},
    {"attribute_beside_a_vector", with_transforms, "<translate id=\"7\" x=\"1\" y=\"2\" z=\"3\"/>",
     "<translate x=\"1\" y=\"2\" z=\"3\"/>", unknown, "<translate x=\"1\" y=\"2\" z=\"3\"/>",
     nothing},
    {"rotate_a", with_transforms, "<rotate x=\"0\" y=\"1\" z=\"0\" a=\"60\"/>",
     "<rotate x=\"0\" y=\"1\" z=\"0\" angle=\"60\"/>", alias,
     "<rotate x=\"0\" y=\"1\" z=\"0\" a=\"60\" angle=\"30\"/>", unknown},
    {"rotate_angle_any_name", with_transforms, "<rotate x=\"0\" y=\"1\" z=\"0\" theta=\"60\"/>",
     "<rotate x=\"0\" y=\"1\" z=\"0\" angle=\"60\"/>", alias,
     "<rotate x=\"0\" y=\"1\" z=\"0\" anle=\"60\"/>", misspelled},
    {"rotate_axis_any_names",
     with_transforms,
     "<rotate angle=\"60\" u=\"0\" v=\"1\" w=\"0\"/>",
     "<rotate x=\"0\" y=\"1\" z=\"0\" angle=\"60\"/>",
     positional,
     "<rotate angle=\"60\" u=\"0\" v=\"1\"/>",
     {"warning xml.unknown-attribute", "warning xml.unknown-attribute", "warning xml.rotate-axis"}},
    {"rotate_by_order",
     with_transforms,
     "<rotate a=\"0\" b=\"1\" c=\"0\" d=\"60\"/>",
     "<rotate x=\"0\" y=\"1\" z=\"0\" angle=\"60\"/>",
     positional,
     "<rotate a=\"0\" y=\"1\" x=\"0\"/>",
     {"warning xml.alias-attribute", "error xml.missing-attribute"}},
    {"rotate_without_angle",
     with_transforms,
     "<rotate x=\"0\" y=\"1\" z=\"0\"/>",
     "<rotate x=\"0\" y=\"1\" z=\"0\" angle=\"0\"/>",
     {"warning xml.rotate-angle"},
     "<rotate x=\"0\" y=\"1\" angle=\"5\"/>",
     lacking},
    {"rotate_without_axis",
     with_transforms,
     "<rotate angle=\"60\"/>",
     "",
     {"warning xml.rotate-axis"},
     "<rotate/>",
     lacking},
    {"matrix_of_any_children",
     with_transforms,
     "<matrix><row0 a=\"1\" b=\"0\" c=\"0\" d=\"2\"/><row1 v1=\"0\" v2=\"1\" v3=\"0\" v4=\"0\"/>"
     "<r a=\"0\" b=\"0\" c=\"1\" d=\"0\"/><row a=\"0\" b=\"0\" c=\"0\" d=\"1\"/></matrix>",
     "<matrix><row a=\"1\" b=\"0\" c=\"0\" d=\"2\"/><row a=\"0\" b=\"1\" c=\"0\" d=\"0\"/>"
     "<row a=\"0\" b=\"0\" c=\"1\" d=\"0\"/><row a=\"0\" b=\"0\" c=\"0\" d=\"1\"/></matrix>",
     nothing,
     "<matrix><row a=\"1\" b=\"0\" c=\"0\" d=\"2\"/><row a=\"0\" b=\"1\" c=\"0\" d=\"0\"/>"
     "<row a=\"0\" b=\"0\" c=\"1\" d=\"0\"/></matrix>",
     {"error xml.matrix-rows"}},
    {"material_color_as_vector",
     with_material,
     "<diffuse x=\"1\" y=\"0\" z=\"0\"/>",
     "<diffuse r=\"1\" g=\"0\" b=\"0\"/>",
     alias,
     "<diffuse b=\"0\" g=\"0\" r=\"1\"/>",
     {"warning xml.attribute-order"}},
    {"material_alpha",
     with_material,
     "<diffuse r=\"1\" g=\"0\" b=\"0\" a=\"1\"/>",
     "<diffuse r=\"1\" g=\"0\" b=\"0\"/>",
     {"note xml.color-alpha"},
     "<diffuse r=\"1\" g=\"0\" b=\"0\" q=\"1\"/>",
     unknown},
    {"reflect",
     with_material,
     "<reflect r=\"1\" g=\"1\" b=\"1\"/>",
     "<reflective r=\"1\" g=\"1\" b=\"1\"/>",
     {"warning xml.alias-element"},
     "<reflectiv r=\"1\" g=\"1\" b=\"1\"/>",
     {"error xml.misspelled-element"}},
    {"shine",
     with_material,
     "<shine v=\"5\"/>",
     "<shininess v=\"5\"/>",
     {"warning xml.alias-element"},
     "<shininesss v=\"5\"/>",
     {"error xml.misspelled-element"}},
    {"shininess_value", with_material, "<shininess value=\"5\"/>", "<shininess v=\"5\"/>", alias,
     "<shininess value=\"5\" v=\"6\"/>", unknown},
    {"blend_value",
     with_material,
     "<blend value=\"1\"/>",
     "<blend v=\"1\"/>",
     alias,
     "<blend value=\"one\"/>",
     {"warning xml.alias-attribute", "error xml.number"}},
    {"ior_any_name", with_material, "<ior n=\"1.5\"/>", "<ior v=\"1.5\"/>", alias, "<ior/>",
     lacking},
    {"texture_filename", with_material, "<texture filename=\"a.png\" u=\"2\" v=\"3\"/>",
     "<texture file=\"a.png\" u=\"2\" v=\"3\"/>", alias, "<texture u=\"2\" v=\"3\"/>", lacking},
    {"texture_without_v",
     with_material,
     "<texture file=\"a.png\" u=\"2\"/>",
     "<texture file=\"a.png\" u=\"2\" v=\"1\"/>",
     nothing,
     "<texture file=\"a.png\" u=\"two\"/>",
     {"error xml.number"}},
    {"texture_blend",
     with_material,
     "<texture value=\"0.5\" file=\"a.png\"/>",
     "<blend v=\"0.5\"/><texture file=\"a.png\"/>",
     {"warning xml.texture-blend"},
     "<texture value=\"0.5\" file=\"a.png\"/><blend v=\"0.25\"/>",
     {"warning xml.texture-blend"}},
    {"emissive_is_left_out",
     with_material,
     "<emissive r=\"1\" g=\"1\" b=\"1\"/>",
     "",
     {"warning xml.ignored-element"},
     "<glow r=\"1\" g=\"1\" b=\"1\"/>",
     {"warning xml.unknown-element"}},
    {"empty_numbers",
     with_material,
     "<diffuse r=\"1\" g=\"\" b=\" \"/>",
     "<diffuse r=\"1\" g=\"0\" b=\"0\"/>",
     {"warning xml.empty-number", "warning xml.empty-number"},
     "<diffuse r=\"1\" g=\"-\" b=\"0\"/>",
     {"error xml.number"}},
    {"text_between",
     in_root,
     "// the cube\n<transblock><object type=\"primitive\" name=\"cube\"/></transblock>",
     "<transblock><object type=\"primitive\" name=\"cube\"/></transblock>",
     {"warning xml.text"},
     "<!-- the cube --><transblock><object type=\"primitive\" name=\"cube\"/></transblock>",
     nothing},
};

Codes codes_of(const Diagnostics& diagnostics) {
  Codes codes;
  for (const Diagnostic& d : diagnostics.list()) {
    codes.push_back(fmt::format("{} {}", severity_text(d.severity), d.code->name));
  }
  return codes;
}

class UnionGrammar : public ::testing::TestWithParam<Rule> {};

TEST_P(UnionGrammar, IsReadAsMeant) {
  const Rule& rule = GetParam();
  const Reading spelled = read(rule.frame(rule.spelled));
  EXPECT_THAT(codes_of(spelled.diagnostics), ElementsAreArray(rule.said));
  EXPECT_EQ(spelled.scene, read(rule.frame(rule.meant)).scene);
}

TEST_P(UnionGrammar, ANearMissIsNot) {
  const Rule& rule = GetParam();
  EXPECT_THAT(codes_of(read(rule.frame(rule.near_miss)).diagnostics),
              ElementsAreArray(rule.said_of_near_miss));
}

INSTANTIATE_TEST_SUITE_P(All, UnionGrammar, ::testing::ValuesIn(rules),
                         [](const auto& rule) { return rule.param.name; });

// --strict rejects what only some programs accept.
TEST(UnionGrammar, SpellingsOfSomeProgramsAreMarkedAsDialect) {
  const std::vector<std::string> dialects = {
      "xml.alias-attribute",       "xml.alias-element",
      "xml.positional-attributes", "xml.name-case",
      "xml.texture-blend",         "xml.object-without-transblock",
      "xml.misspelled-transblock", "xml.attribute-order"};
  std::size_t marked = 0;
  for (const Rule& rule : rules) {
    const Reading spelled = read(rule.frame(rule.spelled));
    for (const Diagnostic& d : spelled.diagnostics.list()) {
      const bool listed =
          std::find(dialects.begin(), dialects.end(), d.code->name) != dialects.end();
      EXPECT_EQ(d.code->kind == CodeKind::dialect, listed) << rule.name << ": " << d.code->name;
      marked += listed;
    }
  }
  EXPECT_GE(marked, 25U);
}

}  // namespace
}  // namespace scenefile::testing
