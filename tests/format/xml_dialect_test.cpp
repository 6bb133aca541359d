// Spellings of old programs and of students, and the passages where the format's documentation
// contradicts itself or the programs; each with its ruling.

#include "format/reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace scenefile::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

struct Verdict {
  std::string file;                   // in fixtures/format, after "checklist."
  std::vector<std::string> findings;  // exactly these
};

void PrintTo(const Verdict& verdict, std::ostream* out) {
  *out << verdict.file;
}

const std::vector<Verdict> verdicts = {
    {"angle-for-heightangle", {"6:5 warning xml.alias-element"}},
    {"number-for-id", {"3:5 warning xml.alias-element"}},
    {"reflect-and-shine", {"5:9 warning xml.alias-element", "6:9 warning xml.alias-element"}},
    {"bare-float-on-texture", {"5:18 warning xml.texture-blend", "6:18 warning xml.texture-blend"}},
    {"masters-after-root", {"7:3 warning xml.master-after-root"}},
    {"declarations-after-root", {}},
    {"duplicate-names", {"7:23 error xml.duplicate-name"}},
    {"nested-tree-named-root", {"4:27 warning xml.reserved-root"}},
    {"instance-of-root", {"4:7 error xml.reserved-root"}},
    {"second-camera", {"8:3 warning xml.second-camera"}},
    {"master-without-name", {"2:3 error xml.master-name"}},
    {"filename-not-next-to-name", {"4:15 warning xml.attribute-order"}},
    {"lights-0-to-7", {}},
    {"missing-globals-camera-type", {}},
};

class Checklist : public ::testing::TestWithParam<Verdict> {};

TEST_P(Checklist, HasItsVerdict) {
  const std::string text =
      file_text(SCENEFILE_FIXTURES "/format/checklist." + GetParam().file + ".xml");
  ASSERT_FALSE(text.empty());
  EXPECT_EQ(findings(read(text).diagnostics), GetParam().findings);
}

INSTANTIATE_TEST_SUITE_P(All, Checklist, ::testing::ValuesIn(verdicts), [](const auto& verdict) {
  std::string name = verdict.param.file;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

Scene checklist_scene(std::string_view name) {
  return read(file_text(fmt::format("{}/format/checklist.{}.xml", SCENEFILE_FIXTURES, name))).scene;
}

TEST(Checklist, ValuesArriveUnderTheirOtherNames) {
  EXPECT_EQ(checklist_scene("angle-for-heightangle").camera->height_angle_deg, 33);
  EXPECT_EQ(checklist_scene("number-for-id").nodes[0].lights.at(0).id, 5);
  const Scene shiny = checklist_scene("reflect-and-shine");
  EXPECT_EQ(shiny.nodes[1].primitives.at(0).material.reflective, glm::vec3(0.5f));
  EXPECT_EQ(shiny.nodes[1].primitives.at(0).material.shininess, 12);
  EXPECT_EQ(checklist_scene("bare-float-on-texture").nodes[1].primitives.at(0).material.blend,
            0.25f);
  EXPECT_EQ(checklist_scene("filename-not-next-to-name").nodes[1].primitives.at(0).mesh_file,
            "part.obj");
  EXPECT_EQ(checklist_scene("lights-0-to-7").nodes[0].lights.size(), 8u);
}

glm::vec3 translation(const Reading& reading) {
  return std::get<Translate>(reading.scene.nodes.at(1).transforms.at(0).map).by;
}

TEST(XmlDialect, AttributesOfOtherNamesAreReadInTheirOrder) {
  const Reading reading = read(with_transforms("<translate a=\"1\" b=\"2\" c=\"3\"/>"));
  EXPECT_THAT(findings(reading.diagnostics), ElementsAre("4:12 warning xml.positional-attributes"));
  EXPECT_EQ(translation(reading), glm::vec3(1, 2, 3));
}

TEST(XmlDialect, NamesCountBeforeTheOrder) {
  const Reading reading = read(with_transforms("<translate z=\"3\" y=\"2\" x=\"1\"/>"));
  EXPECT_THAT(findings(reading.diagnostics), ElementsAre("4:12 warning xml.attribute-order"));
  EXPECT_THAT(
      messages(reading.diagnostics),
      ElementsAre("4:12 the attributes of <translate> were read by their names; programs that "
                  "use their order differ: write them in the order x, y, z"));
  EXPECT_EQ(translation(reading), glm::vec3(1, 2, 3));
}

TEST(XmlDialect, NamesOfAttributesOfObjectsInAnotherCase) {
  const Reading reading =
      read(in_root("<transblock>\n<object TYPE=\"primitive\" Name=\"cube\"/></transblock>"));
  EXPECT_THAT(findings(reading.diagnostics),
              ElementsAre("4:9 warning xml.name-case", "4:26 warning xml.name-case"));
  EXPECT_EQ(reading.scene.nodes.at(1).primitives.size(), 1u);
}

TEST(XmlDialect, ASceneWithoutARootIsNotCalledEmptyToo) {
  EXPECT_TRUE(read("<scenefile/>").scene.incomplete);
  EXPECT_FALSE(read(in_root("")).scene.incomplete);
}

TEST(XmlDialect, TheOrderOfEqualValuesDoesNotMatter) {
  EXPECT_THAT(findings(read(with_transforms("<scale z=\"2\" y=\"2\" x=\"2\"/>"
                                            "<rotate y=\"0\" x=\"0\" z=\"1\" angle=\"9\"/>"))
                           .diagnostics),
              IsEmpty());
}

TEST(XmlDialect, ObjectsAndTexturesHaveAnOrderToo) {
  EXPECT_THAT(
      findings(read(in_root("<transblock>\n<object name=\"cube\" type=\"primitive\">\n"
                            "<texture u=\"2\" v=\"3\" file=\"a.png\"/></object></transblock>"))
                   .diagnostics),
      ElementsAre("4:9 warning xml.attribute-order", "5:10 warning xml.attribute-order"));
}

TEST(XmlDialect, SomeNamesAreNotEnough) {
  EXPECT_THAT(findings(read(with_transforms("<translate x=\"1\" y=\"2\" w=\"3\"/>")).diagnostics),
              ElementsAre("4:1 error xml.missing-attribute"));
  EXPECT_THAT(messages(read(with_transforms("<translate x=\"1\" y=\"2\" w=\"3\"/>")).diagnostics),
              ElementsAre("4:1 <translate> is missing the attribute z; the unknown attribute w is "
                          "probably meant to be it: write z=\"3\""));
  const auto material = [](std::string_view inside) {
    return messages(read(with_material(inside)).diagnostics);
  };
  EXPECT_THAT(
      material("<diffuse r=\"1\" g=\"1\" blue=\"1\"/>"),
      ElementsAre(::testing::HasSubstr("missing the attribute b; the unknown attribute blue is "
                                       "probably meant to be it: write b=\"1\"")));
  EXPECT_THAT(
      material("<diffuse green=\"1\" r=\"1\" blue=\"1\" shade=\"0\"/>"),
      ElementsAre(::testing::HasSubstr("the unknown attribute green"),
                  ::testing::HasSubstr("the unknown attribute blue"),
                  ::testing::HasSubstr("unknown attribute shade of <diffuse> has no effect")));
  EXPECT_THAT(material("<diffuse r=\"1\" s=\"1\"/>"),
              ElementsAre(::testing::HasSubstr("unknown attribute s of <diffuse> has no effect"),
                          ::testing::HasSubstr("is missing the attributes g, b")));
  EXPECT_THAT(
      messages(read(in_root("<transblock><object kind=\"primitive\" name=\"cube\"/>"
                            "</transblock><transblock><object type=\"primitive\" "
                            "shape=\"cube\"/></transblock>"))
                   .diagnostics),
      ElementsAre(::testing::HasSubstr("missing the attribute type; the unknown attribute kind"),
                  ::testing::HasSubstr("missing the attribute name; the unknown attribute "
                                       "shape")));
  EXPECT_THAT(messages(read(with_transforms("<translate/>")).diagnostics),
              ElementsAre("4:1 <translate> is missing the attributes x, y, z"));
  EXPECT_THAT(messages(read(with_top("<lightdata><id v=\"0\"/><color r=\"1\" g=\"1\" "
                                     "b=\"1\"/><position x=\"0\" y=\"0\" z=\"0\"/>"
                                     "\n<function v1=\"1\" v2=\"0\"/></lightdata>"))
                           .diagnostics),
              ElementsAre("3:1 <function> is missing the attribute v3"));
}

TEST(XmlDialect, AllPartsInOneAttributeSayHowToWriteThem) {
  const auto of = [](const std::string& text) { return messages(read(text).diagnostics); };
  EXPECT_THAT(
      of(with_transforms("<translate v=\"1, 2 ,-3e1\"/>")),
      ElementsAre("4:1 <translate> is missing the attributes x, y, z; write x=\"1\" y=\"2\" "
                  "z=\"-3e1\""));
  EXPECT_THAT(
      of(with_transforms("<scale v=\"2\"/>")),
      ElementsAre("4:1 <scale> is missing the attributes x, y, z; write x=\"2\" y=\"2\" z=\"2\""));
  EXPECT_THAT(
      of(with_material("<diffuse value=\"#ff0033\"/>")),
      ElementsAre(
          "5:1 <diffuse> is missing the attributes r, g, b; write r=\"1\" g=\"0\" b=\"0.2\""));
  for (const std::string value : {"1 2", "1 2 3 4 5", "1 two 3", "", "#ff00"}) {
    EXPECT_THAT(
        findings(read(with_transforms(fmt::format("<translate v=\"{}\"/>", value))).diagnostics),
        ElementsAre("4:12 warning xml.unknown-attribute", "4:1 error xml.missing-attribute"))
        << value;
  }
}

TEST(XmlDialect, ValuesInAWrongPlaceSayWhereTheyBelong) {
  const auto of = [](const std::string& text) { return messages(read(text).diagnostics).back(); };
  EXPECT_EQ(of(with_top("<globaldata ambientcoeff=\"0.5\"/>")),
            "2:13 attribute ambientcoeff of <globaldata> has no effect; write it as an element "
            "inside");
  EXPECT_EQ(of(with_top("<globaldata ka=\"0.5\"/>")),
            "2:13 unknown attribute ka of <globaldata> has no effect");
  EXPECT_THAT(of(in_root("<scale x=\"1\" y=\"1\" z=\"1\"/>")),
              HasSubstr("it was ignored; transforms belong in a transblock"));
  EXPECT_THAT(of(with_transforms("<globaldata/>")), HasSubstr("in <scenefile>"));
  EXPECT_THAT(of(in_root("scale x=\"1\"/>")), HasSubstr("is the < of an element missing?"));
}

TEST(XmlDialect, AMasterAfterTheRootReportsItsUse) {
  const std::string late = "<object type=\"tree\" name=\"late\"/></scenefile>";
  const std::string used =
      "<scenefile><object type=\"tree\" name=\"root\">\n<transblock><object type=\"master\" "
      "name=\"late\"/></transblock>\n</object>" +
      late;
  EXPECT_EQ(messages(read(used).diagnostics).front(),
            "3:10 the master \"late\" is declared after the root, though line 2 uses it");
  EXPECT_EQ(messages(read("<scenefile><object type=\"tree\" name=\"root\"/>\n" + late).diagnostics)
                .front(),
            "2:1 the master \"late\" is declared after the root");
}

TEST(XmlDialect, WordsOfOtherProgramsAreTranslated) {
  const auto of = [](std::string_view object) {
    return messages(read(in_root(fmt::format("<transblock>{}</transblock>", object))).diagnostics);
  };
  EXPECT_THAT(of("<object type=\"primitive\" name=\"Box\"/>"),
              ElementsAre(HasSubstr("it is not drawn; did you mean cube?")));
  EXPECT_THAT(of("<object type=\"primitive\" name=\"torus\"/>"),
              ElementsAre(::testing::EndsWith("mesh); it is not drawn")));
  EXPECT_THAT(of("<object type=\"group\"/>"), ElementsAre(HasSubstr("did you mean tree?")));
  const auto light = [](std::string_view type) {
    return messages(read(with_top(fmt::format("<lightdata><id v=\"0\"/><type v=\"{}\"/><direction "
                                              "x=\"0\" y=\"-1\" z=\"0\"/><color r=\"1\" g=\"1\" "
                                              "b=\"1\"/></lightdata>",
                                              type)))
                        .diagnostics);
  };
  EXPECT_THAT(light("sun"), ElementsAre(HasSubstr("did you mean directional?")));
  EXPECT_THAT(light("laser"), ElementsAre(HasSubstr("the types are point")));
}

TEST(XmlDialect, MixedNames) {
  const Reading reading =
      read(with_top("<lightdata><id v=\"0\"/><color x=\"1\" g=\"2\" b=\"3\"/><position x=\"0\" "
                    "y=\"0\" z=\"0\"/></lightdata>"));
  EXPECT_THAT(findings(reading.diagnostics), ElementsAre("2:30 warning xml.alias-attribute"));
  EXPECT_EQ(reading.scene.nodes[0].lights.at(0).color, glm::vec3(1, 2, 3));
}

TEST(XmlDialect, ASingleValueMayHaveAnyName) {
  for (const std::string_view name : {"value", "val", "n", "amount"}) {
    const Reading reading = read(with_material(fmt::format("<shininess {}=\" 10\"/>", name)));
    EXPECT_THAT(findings(reading.diagnostics), ElementsAre("5:12 warning xml.alias-attribute"))
        << name;
    EXPECT_EQ(reading.scene.nodes.at(1).primitives.at(0).material.shininess, 10);
  }
  EXPECT_TRUE(read(with_material("<shininess a=\"1\" b=\"2\"/>")).diagnostics.has_errors());
}

TEST(XmlDialect, TheTypeOfALightInOtherWords) {
  const auto type_of = [](std::string_view type) {
    const Reading reading =
        read(with_top(fmt::format("<lightdata><id v=\"0\"/>{}<direction x=\"0\" y=\"-1\" "
                                  "z=\"0\"/><color r=\"1\" g=\"1\" b=\"1\"/></lightdata>",
                                  type)));
    EXPECT_EQ(reading.diagnostics.count(Severity::warning), 1u) << type;
    return reading.scene.nodes[0].lights.at(0).type;
  };
  EXPECT_EQ(type_of("<type id=\"directional\"/>"), LightType::directional);
  EXPECT_EQ(type_of("<type thing=\"directional\"/>"), LightType::directional);
  EXPECT_EQ(type_of("<type v=\"Directional\"/>"), LightType::directional);
}

TEST(XmlDialect, TypeAndIdOfALightAsAttributes) {
  const Reading reading =
      read(with_top("<lightdata id=\"4\" type=\"directional\"><direction x=\"0\" y=\"-1\" z=\"0\"/>"
                    "<color r=\"1\" g=\"1\" b=\"1\"/></lightdata>"));
  EXPECT_THAT(findings(reading.diagnostics),
              ElementsAre("2:12 warning xml.alias-attribute", "2:19 warning xml.alias-attribute"));
  EXPECT_EQ(reading.scene.nodes[0].lights.at(0).type, LightType::directional);
  EXPECT_EQ(reading.scene.nodes[0].lights.at(0).id, 4);
}

TEST(XmlDialect, LightIds) {
  const auto id_of = [](std::string_view id) {
    return read(with_top(fmt::format("<lightdata><id v=\"{}\"/></lightdata>", id)))
        .scene.nodes[0]
        .lights.at(0)
        .id;
  };
  EXPECT_EQ(id_of("7"), 7);
  EXPECT_EQ(id_of("-1"), -1);
  EXPECT_EQ(id_of("1.5"), std::nullopt);
  EXPECT_EQ(id_of("5a"), std::nullopt);
  EXPECT_EQ(id_of("99999999999"), std::nullopt);
}

TEST(XmlDialect, ARotationInOtherWords) {
  const auto rotation = [](std::string_view text) { return read(with_transforms(text)); };
  EXPECT_EQ(std::get<Rotate>(rotation("<rotate x=\"0\" y=\"1\" z=\"0\" a=\"60\"/>")
                                 .scene.nodes.at(1)
                                 .transforms.at(0)
                                 .map),
            (Rotate{{0, 1, 0}, 60}));
  EXPECT_EQ(
      std::get<Rotate>(
          rotation("<rotate x=\"0\" y=\"1\" z=\"0\"/>").scene.nodes.at(1).transforms.at(0).map),
      (Rotate{{0, 1, 0}, 0}));
  EXPECT_EQ(std::get<Rotate>(rotation("<rotate ax=\"0\" ay=\"1\" az=\"0\" deg=\"60\"/>")
                                 .scene.nodes.at(1)
                                 .transforms.at(0)
                                 .map),
            (Rotate{{0, 1, 0}, 60}));
  const Reading degrees = rotation("<rotate x=\"0\" y=\"1\" z=\"0\" degrees=\"60\"/>");
  EXPECT_THAT(messages(degrees.diagnostics),
              ElementsAre("4:27 attribute degrees of <rotate> was read as angle"));
  EXPECT_EQ(std::get<Rotate>(degrees.scene.nodes.at(1).transforms.at(0).map),
            (Rotate{{0, 1, 0}, 60}));
  EXPECT_THAT(findings(rotation("<rotate x=\"0\" y=\"1\" z=\"0\" anlge=\"60\"/>").diagnostics),
              ElementsAre("4:27 error xml.misspelled-attribute"));
  EXPECT_TRUE(rotation("<rotate angle=\"60\"/>").scene.nodes.at(1).transforms.empty());
  EXPECT_THAT(messages(rotation("<rotate x=\"1\" angle=\"60\"/>").diagnostics),
              ElementsAre("4:1 <rotate> is missing the attributes y, z"));
  EXPECT_TRUE(rotation("<rotate/>").diagnostics.has_errors());
}

TEST(XmlDialect, TextureFilesInOtherWords) {
  for (const std::string_view attributes :
       {"filename=\"a.png\" u=\"2\" v=\"3\"", "image=\"a.png\" u=\"2\" v=\"3\""}) {
    const Reading reading = read(with_material(fmt::format("<texture {}/>", attributes)));
    EXPECT_THAT(findings(reading.diagnostics), ElementsAre("5:10 warning xml.alias-attribute"));
    EXPECT_EQ(reading.scene.nodes.at(1).primitives.at(0).material.texture,
              (TextureUse{"a.png", 2, 3, {}}));
  }
  EXPECT_TRUE(read(with_material("<texture u=\"1\" v=\"1\"/>")).diagnostics.has_errors());
}

TEST(XmlDialect, ABlendElementBeatsTheTextures) {
  const std::string blend = "<blend v=\"0.75\"/>";
  const std::string texture = "<texture value=\"0.25\" file=\"a.png\"/>";
  for (const std::string& both : {blend + texture, texture + blend}) {
    EXPECT_EQ(read(with_material(both)).scene.nodes.at(1).primitives.at(0).material.blend, 0.75f);
  }
  EXPECT_EQ(read(with_material(texture)).scene.nodes.at(1).primitives.at(0).material.blend, 0.25f);
}

TEST(XmlDialect, MeshFilesInOtherWords) {
  const Reading reading = read(in_root(
      "<transblock><object type=\"primitive\" name=\"mesh\" file=\"a.obj\"/></transblock>"));
  EXPECT_THAT(findings(reading.diagnostics), ElementsAre("3:50 warning xml.alias-attribute"));
  EXPECT_EQ(reading.scene.nodes.at(1).primitives.at(0).mesh_file, "a.obj");
}

TEST(XmlDialect, MisspelledAttributesOfObjects) {
  const auto of = [](std::string_view object) {
    return messages(read(in_root(fmt::format("<transblock>{}</transblock>", object))).diagnostics);
  };
  EXPECT_THAT(of("<object tpye=\"primitive\" name=\"cube\"/>"),
              ElementsAre("3:21 unknown attribute tpye of <object>; did you mean type?"));
  EXPECT_THAT(of("<object type=\"primitive\" nmae=\"cube\"/>"),
              ElementsAre("3:38 unknown attribute nmae of <object>; did you mean name?"));
  EXPECT_THAT(of("<object type=\"primitive\" name=\"mesh\" filenmae=\"a\" x=\"\"/>"),
              ElementsAre("3:50 unknown attribute filenmae of <object>; did you mean filename?",
                          "3:63 unknown attribute x of <object> has no effect"));
  EXPECT_THAT(
      of("<object name=\"cube\"/>"),
      ElementsAre("3:13 <object> is missing the attribute type: tree, master or primitive"));
  EXPECT_THAT(
      of("<object type=\"primitive\"/>"),
      ElementsAre("3:13 <object type=\"primitive\"> is missing the attribute name, the shape"));
}

TEST(XmlDialect, ElementsInAnotherCase) {
  const Reading reading = read(
      "<SceneFile><Object type=\"Tree\" name=\"root\"><TransBlock><Object type=\"primitive\" "
      "name=\"cube\"/></TransBlock></Object></SceneFile>");
  EXPECT_FALSE(reading.diagnostics.has_errors());
  EXPECT_EQ(reading.scene.nodes.size(), 2u);
  EXPECT_EQ(reading.scene.nodes.at(1).primitives.size(), 1u);
}

TEST(XmlDialect, NamespacesHaveNoEffect) {
  EXPECT_THAT(findings(read("<scenefile xmlns=\"urn:x\" xml:lang=\"en\"><object type=\"tree\" "
                            "name=\"root\"/></scenefile>")
                           .diagnostics),
              ElementsAre("1:12 warning xml.unknown-attribute"));
  EXPECT_THAT(
      findings(read("<scenefile xmlns:xsi=\"urn:x\" xsi:noNamespaceSchemaLocation=\"s.xsd\">"
                    "<object type=\"tree\" name=\"root\"/></scenefile>")
                   .diagnostics),
      IsEmpty());
  EXPECT_THAT(findings(read("<s:scenefile xmlns:s=\"urn:x\"/>").diagnostics),
              ElementsAre("1:1 error xml.root-element", "1:1 warning xml.no-root"));
}

TEST(XmlDialect, DashesInCommentsAreForCompatCourse) {
  for (const std::string comment : {"<!-- a -- b -->", "<!-- a --->", "<!---- a -->",
                                    "<!-- a <!-- b -->", "<!-- -- -- --- -->"}) {
    const std::string text = in_root(comment +
                                     "<transblock><object type=\"primitive\" "
                                     "name=\"cube\"/></transblock>");
    EXPECT_THAT(findings(read(text).diagnostics), ElementsAre(HasSubstr("error xml.comment")))
        << comment;
    const Reading compat = read_compat(text);
    EXPECT_THAT(findings(compat.diagnostics), ElementsAre(HasSubstr("warning xml.comment")))
        << comment;
    EXPECT_EQ(compat.scene.nodes[compat.scene.root].children.size(), 1u) << comment;
  }
}

TEST(XmlDialect, FalseCommentsAreForCompatCourse) {
  for (const std::string comment : {"<--> note", "<-- note -->", "<--\nnote\n-->", "<--->"}) {
    const std::string text = in_root(comment +
                                     "<transblock><object type=\"primitive\" "
                                     "name=\"cubo\"/></transblock>");
    EXPECT_THAT(findings(read(text).diagnostics),
                ElementsAre("3:1 error xml.comment", HasSubstr("error xml.misspelled-shape")))
        << comment;
    EXPECT_THAT(findings(read_compat(text).diagnostics),
                ElementsAre("3:1 warning xml.comment", HasSubstr("error xml.misspelled-shape")))
        << comment;
  }
}

// Only in comments: elsewhere the same characters keep their meaning.
TEST(XmlDialect, DashesElsewhereAreNotComments) {
  for (const std::string inside :
       {"<transblock><object type=\"tree\" name=\"a -- <!-- b\"><transblock><object "
        "type=\"primitive\" name=\"cube\"/></transblock></object></transblock>",
        "<![CDATA[ <!-- a -- b --> ]]>", "<?note <!-- a -- b --> ?>"}) {
    const Reading reading = read(in_root(inside));
    for (const Diagnostic& d : reading.diagnostics.list()) {
      EXPECT_NE(d.code->name, "xml.comment") << inside;
    }
  }
}

TEST(XmlDialect, EveryAssumptionIsMarkedAsADialect) {
  for (const std::string& text :
       {with_transforms("<translate a=\"1\" b=\"2\" c=\"3\"/>"),
        with_material("<shininess value=\"1\"/>"), with_material("<shine v=\"1\"/>"),
        with_material("<diffuse x=\"1\" y=\"1\" z=\"1\"/>")}) {
    const Reading reading = read(text);
    ASSERT_EQ(reading.diagnostics.list().size(), 1u);
    EXPECT_TRUE(reading.diagnostics.list()[0].code->kind == CodeKind::dialect);
  }
}

}  // namespace
}  // namespace scenefile::testing
