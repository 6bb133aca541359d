// The meaning of the elements of a file.

#include "format/reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Node& only_child(const Scene& scene) {
  return scene.nodes.at(scene.nodes.at(scene.root).children.at(0));
}

TEST(XmlScene, AnEmptySceneHasTheDefaults) {
  const Reading reading = read(with_top(""));
  EXPECT_THAT(found(reading), IsEmpty());
  Scene expected;
  expected.nodes[0].name = "root";
  EXPECT_EQ(reading.scene, expected);
}

TEST(XmlScene, Globals) {
  const Reading reading = read(with_top(
      "<globaldata><ambientcoeff v=\"0.1\"/><diffusecoeff v=\"0.2\"/><specularcoeff v=\"0.3\"/>"
      "<transparentcoeff v=\"0.4\"/></globaldata>"));
  EXPECT_THAT(found(reading), IsEmpty());
  EXPECT_EQ(reading.scene.global.ambient, 0.1f);
  EXPECT_EQ(reading.scene.global.diffuse, 0.2f);
  EXPECT_EQ(reading.scene.global.specular, 0.3f);
  EXPECT_EQ(reading.scene.global.transparent, 0.4f);
}

TEST(XmlScene, ASecondGlobaldataReplacesItsValues) {
  const Reading reading =
      read(with_top("<globaldata><ambientcoeff v=\"0.1\"/><diffusecoeff v=\"0.2\"/></globaldata>\n"
                    "<globaldata><ambientcoeff v=\"0.9\"/></globaldata>"));
  EXPECT_THAT(found(reading), ElementsAre("3:1 warning xml.duplicate-element"));
  EXPECT_EQ(reading.scene.global.ambient, 0.9f);
  EXPECT_EQ(reading.scene.global.diffuse, 0.2f);
  EXPECT_FALSE(reading.scene.global.transparent);
}

TEST(XmlScene, Camera) {
  const Reading reading = read(
      with_top("<cameradata><pos x=\"1\" y=\"2\" z=\"3\"/><look x=\"0\" y=\"0\" z=\"-2\"/><up "
               "x=\"0\" y=\"2\" z=\"0\"/>"
               "<heightangle v=\"30\"/><aperture v=\"0.5\"/><focallength v=\"7\"/></cameradata>"));
  EXPECT_THAT(found(reading), IsEmpty());
  ASSERT_TRUE(reading.scene.camera);
  const Camera& camera = *reading.scene.camera;
  EXPECT_EQ(camera.position, glm::vec3(1, 2, 3));
  EXPECT_EQ(camera.look, glm::vec3(0, 0, -2));
  EXPECT_EQ(camera.up, glm::vec3(0, 2, 0));
  EXPECT_EQ(camera.height_angle_deg, 30);
  EXPECT_EQ(camera.aperture, 0.5f);
  EXPECT_EQ(camera.focal_length, 7);
}

TEST(XmlScene, FocusIsAPointInAnyPosition) {
  const Reading reading =
      read(with_top("<cameradata><focus x=\"1\" y=\"1\" z=\"1\"/><pos x=\"1\" y=\"2\" z=\"3\"/><up "
                    "x=\"0\" y=\"1\" z=\"0\"/>"
                    "<heightangle v=\"30\"/></cameradata>"));
  EXPECT_THAT(found(reading), IsEmpty());
  EXPECT_EQ(reading.scene.camera->look, glm::vec3(0, -1, -2));
}

TEST(XmlScene, FocusWithoutAPositionIsSeenFromTheDefaultOne) {
  const Reading reading =
      read(with_top("<cameradata><focus x=\"0\" y=\"0\" z=\"0\"/><up x=\"0\" y=\"1\" "
                    "z=\"0\"/><heightangle v=\"30\"/></cameradata>"));
  EXPECT_THAT(found(reading), ElementsAre("2:1 warning xml.camera-default"));
  EXPECT_EQ(reading.scene.camera->look, glm::vec3(-5));
}

TEST(XmlScene, AnEmptyCameraIsTheDefaultOne) {
  const Reading reading = read(with_top("<cameradata/>"));
  EXPECT_EQ(found(reading), std::vector<std::string>(4, "2:1 warning xml.camera-default"));
  EXPECT_EQ(*reading.scene.camera, Camera{});
}

TEST(XmlScene, TheLastCameraCounts) {
  const std::string rest =
      "<look x=\"0\" y=\"0\" z=\"-1\"/><up x=\"0\" y=\"1\" z=\"0\"/><heightangle "
      "v=\"30\"/></cameradata>";
  const Reading reading =
      read(with_top("<cameradata><pos x=\"1\" y=\"1\" z=\"1\"/><aperture v=\"1\"/>" + rest +
                    "\n<cameradata><pos x=\"2\" y=\"2\" z=\"2\"/>" + rest));
  EXPECT_THAT(found(reading), ElementsAre("3:1 warning xml.second-camera"));
  EXPECT_EQ(reading.scene.camera->position, glm::vec3(2));
  EXPECT_EQ(reading.scene.camera->aperture, 0);
}

Light only_light(const Reading& reading) {
  return reading.scene.nodes.at(reading.scene.root).lights.at(0);
}

TEST(XmlScene, LightsAreAtTheRootWithTheirDefaults) {
  const Reading reading = read(with_top("<lightdata/>"));
  const Light light = only_light(reading);
  EXPECT_EQ(light.type, LightType::point);
  EXPECT_EQ(light.position, glm::vec3(3));
  EXPECT_EQ(light.color, glm::vec3(1));
  EXPECT_EQ(light.attenuation, glm::vec3(1, 0, 0));
  EXPECT_FALSE(light.id);
  EXPECT_THAT(found(reading),
              ElementsAre("2:1 warning xml.light-default", "2:1 warning xml.light-default",
                          "2:1 warning xml.light-id"));
}

TEST(XmlScene, ASpotLight) {
  const Reading reading = read(with_top(
      "<lightdata><direction x=\"0\" y=\"-1\" z=\"0\"/><angle v=\"30\"/><penumbra v=\"10\"/><id "
      "v=\"3\"/>"
      "<position x=\"1\" y=\"2\" z=\"3\"/><color r=\"0.1\" g=\"0.2\" b=\"0.3\"/><type v=\"spot\"/>"
      "<function a=\"1\" b=\"2\" c=\"3\"/></lightdata>"));
  EXPECT_THAT(found(reading), IsEmpty());
  const Light light = only_light(reading);
  EXPECT_EQ(light.type, LightType::spot);
  EXPECT_EQ(light.position, glm::vec3(1, 2, 3));
  EXPECT_EQ(light.direction, glm::vec3(0, -1, 0));
  EXPECT_EQ(light.color, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(light.attenuation, glm::vec3(1, 2, 3));
  EXPECT_EQ(light.angle_deg, 30.f);
  EXPECT_EQ(light.penumbra_deg, 10);
  EXPECT_EQ(light.id, 3);
}

TEST(XmlScene, AnAreaLight) {
  const Reading reading = read(with_top(
      "<lightdata><id v=\"0\"/><type v=\"area\"/><position x=\"1\" y=\"2\" z=\"3\"/><color r=\"1\" "
      "g=\"1\" b=\"1\"/>"
      "<direction x=\"0\" y=\"-1\" z=\"0\"/><width v=\"2\"/><height v=\"4\"/></lightdata>"));
  EXPECT_THAT(found(reading), IsEmpty());
  EXPECT_EQ(only_light(reading).width, 2);
  EXPECT_EQ(only_light(reading).height, 4);
}

TEST(XmlScene, TransformsKeepTheirOrder) {
  const Reading reading = read(with_transforms(
      "<translate x=\"1\" y=\"2\" z=\"3\"/><rotate x=\"0\" y=\"0\" z=\"1\" angle=\"90\"/>"
      "<scale x=\"2\" y=\"2\" z=\"2\"/><translate x=\"4\" y=\"5\" z=\"6\"/>"));
  EXPECT_THAT(found(reading), IsEmpty());
  const std::vector<Transform>& transforms = only_child(reading.scene).transforms;
  ASSERT_EQ(transforms.size(), 4u);
  EXPECT_EQ(std::get<Translate>(transforms[0].map).by, glm::vec3(1, 2, 3));
  EXPECT_EQ(std::get<Rotate>(transforms[1].map), (Rotate{{0, 0, 1}, 90}));
  EXPECT_EQ(std::get<Scale>(transforms[2].map).by, glm::vec3(2));
  EXPECT_EQ(std::get<Translate>(transforms[3].map).by, glm::vec3(4, 5, 6));
}

std::string rows(std::string_view last, std::string_view form = "a b c d") {
  const auto row = [&](std::string_view numbers) {
    std::string text = "<r";
    for (std::size_t i = 0, f = 0; i < numbers.size(); i = numbers.find(' ', i) + 1) {
      const std::size_t end = std::min(numbers.find(' ', i), numbers.size());
      const std::size_t form_end = std::min(form.find(' ', f), form.size());
      text += fmt::format(" {}=\"{}\"", form.substr(f, form_end - f), numbers.substr(i, end - i));
      f = form_end + 1;
      if (end == numbers.size()) {
        break;
      }
    }
    return text + "/>";
  };
  return "<matrix>" + row("1 2 3 4") + row("5 6 7 8") + row("9 10 11 12") + row(last) + "</matrix>";
}

TEST(XmlScene, AMatrixIsReadByRows) {
  for (const std::string_view form : {"a b c d", "v1 v2 v3 v4"}) {
    const Reading reading = read(with_transforms(rows("0 0 0 1", form)));
    EXPECT_THAT(found(reading), IsEmpty());
    const glm::mat4 m = std::get<Matrix>(only_child(reading.scene).transforms.at(0).map).m();
    EXPECT_EQ(m, glm::mat4(1, 5, 9, 0, 2, 6, 10, 0, 3, 7, 11, 0, 4, 8, 12, 1));
  }
}

TEST(XmlScene, AMatrixWithAnotherLastRow) {
  const auto matrix = [](const Reading& reading) {
    return std::get<Matrix>(only_child(reading.scene).transforms.at(0).map).m();
  };
  const Reading halved = read(with_transforms(rows("0 0 0 2")));
  EXPECT_EQ(matrix(halved)[3], glm::vec4(2, 4, 6, 1));
  const Reading projective = read(with_transforms(rows("0 0 1 1")));
  EXPECT_EQ(matrix(projective)[3], glm::vec4(4, 8, 12, 1));
  EXPECT_FALSE(projective.diagnostics.has_errors());
  EXPECT_TRUE(read(with_transforms(rows("0 0 0 0"))).diagnostics.has_errors());
}

TEST(XmlScene, Material) {
  const Reading reading = read(with_material(
      "<diffuse r=\"0.1\" g=\"0.2\" b=\"0.3\"/><ambient r=\"0.4\" g=\"0.5\" b=\"0.6\"/>"
      "<specular r=\"0.7\" g=\"0.8\" b=\"0.9\"/><reflective r=\"1\" g=\"0\" b=\"0\"/>"
      "<transparent r=\"0\" g=\"1\" b=\"0\"/><shininess v=\"20\"/><ior v=\"1.5\"/><blend "
      "v=\"0.25\"/>"
      "<texture file=\"a b.png\" u=\"2\" v=\"3\"/><bumpmap file=\"c.png\"/>"));
  EXPECT_THAT(found(reading), IsEmpty());
  const Material& m = only_child(reading.scene).primitives.at(0).material;
  EXPECT_EQ(m.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(m.ambient, glm::vec3(0.4f, 0.5f, 0.6f));
  EXPECT_EQ(m.specular, glm::vec3(0.7f, 0.8f, 0.9f));
  EXPECT_EQ(m.reflective, glm::vec3(1, 0, 0));
  EXPECT_EQ(m.transparent, glm::vec3(0, 1, 0));
  EXPECT_EQ(m.shininess, 20);
  EXPECT_EQ(m.ior, 1.5f);
  EXPECT_EQ(m.blend, 0.25f);
  EXPECT_EQ(m.texture, (TextureUse{"a b.png", 2, 3, {}}));
  EXPECT_EQ(m.bump_map, (TextureUse{"c.png", 1, 1, {}}));
}

TEST(XmlScene, Shapes) {
  const std::pair<std::string_view, Shape> shapes[] = {{"cube", Shape::cube},
                                                       {"cone", Shape::cone},
                                                       {"cylinder", Shape::cylinder},
                                                       {"sphere", Shape::sphere}};
  for (const auto& [name, shape] : shapes) {
    const Reading reading = read(in_root(
        fmt::format("<transblock><object type=\"primitive\" name=\"{}\"/></transblock>", name)));
    EXPECT_THAT(found(reading), IsEmpty());
    EXPECT_EQ(only_child(reading.scene).primitives.at(0).shape, shape);
  }
}

TEST(XmlScene, MeshesNameTheirFile) {
  for (const std::string_view attribute : {"filename", "meshfile"}) {
    const Reading reading = read(in_root(fmt::format(
        "<transblock><object type=\"primitive\" name=\"mesh\" {}=\"a.obj\"/></transblock>",
        attribute)));
    EXPECT_THAT(found(reading), IsEmpty());
    EXPECT_EQ(only_child(reading.scene).primitives.at(0).shape, Shape::mesh);
    EXPECT_EQ(only_child(reading.scene).primitives.at(0).mesh_file, "a.obj");
  }
}

constexpr std::string_view cube_block =
    "<transblock><object type=\"primitive\" name=\"cube\"/></transblock>";
constexpr std::string_view packet_bvh =
    "<object type=\"tree\" name=\"part\"><transblock><object type=\"primitive\" "
    "name=\"cone\"/></transblock></object>";

TEST(XmlScene, ATreeInATransblockIsItsNode) {
  const Reading reading =
      read(in_root(fmt::format("<transblock><scale x=\"2\" y=\"2\" z=\"2\"/><object type=\"tree\" "
                               "name=\"legs\">{0}{0}</object></transblock>",
                               cube_block)));
  EXPECT_THAT(found(reading), IsEmpty());
  const Node& legs = only_child(reading.scene);
  EXPECT_EQ(legs.name, "legs");
  EXPECT_EQ(legs.transforms.size(), 1u);
  ASSERT_EQ(legs.children.size(), 2u);
  EXPECT_EQ(reading.scene.nodes[legs.children[1]].primitives.size(), 1u);
  EXPECT_EQ(reading.scene.nodes.size(), 4u);
}

TEST(XmlScene, MastersAreTemplates) {
  const Reading reading =
      read(fmt::format("<scenefile>{}<object type=\"tree\" name=\"root\"><transblock><object "
                       "type=\"master\" name=\"part\"/>"
                       "</transblock><transblock><object type=\"tree\" "
                       "name=\"part\"/></transblock></object></scenefile>",
                       packet_bvh));
  EXPECT_THAT(found(reading), IsEmpty());
  const Scene& scene = reading.scene;
  ASSERT_EQ(scene.templates.size(), 1u);
  EXPECT_EQ(scene.nodes[scene.templates[0]].name, "part");
  EXPECT_EQ(scene.nodes[scene.templates[0]].children.size(), 1u);
  for (const NodeId child : scene.nodes[scene.root].children) {
    EXPECT_EQ(scene.nodes[child].instance_of, "part");
    EXPECT_TRUE(scene.nodes[child].name.empty());
  }
}

TEST(XmlScene, AMasterMayComeAfterTheRoot) {
  const Reading reading = read(fmt::format(
      "<scenefile>\n<object type=\"tree\" name=\"root\"><transblock>\n<object type=\"master\" "
      "name=\"part\"/></transblock>"
      "<transblock>\n<object type=\"tree\" name=\"part\"/></transblock></object>\n{}</scenefile>",
      packet_bvh));
  EXPECT_THAT(found(reading), ElementsAre("5:1 warning xml.master-after-root"));
  for (const NodeId child : reading.scene.nodes[reading.scene.root].children) {
    EXPECT_EQ(reading.scene.nodes[child].instance_of, "part");
  }
}

TEST(XmlScene, ATreeInsideATreeMayBeUsedAgain) {
  const Reading reading =
      read(in_root(fmt::format("<transblock><translate x=\"1\" y=\"0\" z=\"0\"/>{}</transblock>\n"
                               "<transblock><object type=\"master\" name=\"part\"/></transblock>",
                               packet_bvh)));
  EXPECT_THAT(found(reading), ElementsAre("4:35 warning xml.nested-master"));
  const Scene& scene = reading.scene;
  ASSERT_EQ(scene.templates.size(), 1u);
  for (const NodeId child : scene.nodes[scene.root].children) {
    EXPECT_EQ(scene.nodes[child].instance_of, "part");
    EXPECT_TRUE(scene.nodes[child].children.empty());
  }
  EXPECT_EQ(scene.nodes[scene.nodes[scene.root].children[0]].transforms.size(), 1u);
}

TEST(XmlScene, AnEmptyTreeIsAnInstanceOfATreeInsideATree) {
  const Reading reading = read(in_root(fmt::format(
      "<transblock>{}</transblock>\n<transblock><object type=\"tree\" name=\"part\"/></transblock>",
      packet_bvh)));
  EXPECT_THAT(found(reading), ElementsAre("4:33 warning xml.nested-master"));
  for (const NodeId child : reading.scene.nodes[reading.scene.root].children) {
    EXPECT_EQ(reading.scene.nodes[child].instance_of, "part");
  }
}

TEST(XmlScene, AnEmptyTreeWithoutAMasterSuggestsOne) {
  const Reading reading =
      read(fmt::format("<scenefile>\n{}<object type=\"tree\" name=\"root\"><transblock>\n"
                       "<object type=\"tree\" name=\"prat\"/></transblock></object></scenefile>",
                       packet_bvh));
  EXPECT_THAT(found(reading), ElementsAre("3:21 warning xml.empty-tree"));
  EXPECT_THAT(reading.diagnostics.list().front().message,
              ::testing::HasSubstr("did you mean \"part\"?"));
  const Scene& scene = reading.scene;
  EXPECT_EQ(scene.nodes[scene.nodes[scene.root].children.at(0)].name, "prat");
}

TEST(XmlScene, DuplicateTreeNamesAreAmbiguous) {
  const Reading reading =
      read(in_root(fmt::format("<transblock>{0}</transblock><transblock>{0}</transblock>"
                               "<transblock><object type=\"master\" name=\"part\"/></transblock>",
                               packet_bvh)));
  EXPECT_TRUE(reading.scene.templates.empty());
}

TEST(XmlScene, RootInAnotherCaseIsTheRoot) {
  const Reading reading =
      read(fmt::format("<scenefile><lightdata><id v=\"0\"/><position x=\"0\" y=\"0\" "
                       "z=\"0\"/><color r=\"1\" g=\"1\" b=\"1\"/></lightdata>\n"
                       "<object type=\"tree\" name=\"Root\">{}</object></scenefile>",
                       cube_block));
  EXPECT_THAT(found(reading), ElementsAre("2:1 warning xml.name-case"));
  EXPECT_TRUE(reading.scene.templates.empty());
  EXPECT_EQ(reading.scene.nodes[reading.scene.root].children.size(), 1u);
  EXPECT_EQ(reading.scene.nodes[reading.scene.root].lights.size(), 1u);
}

TEST(XmlScene, ADuplicateTreeIsStillChecked) {
  const Reading reading = read(
      "<scenefile><object type=\"tree\" name=\"root\"/>\n"
      "<object type=\"tree\" name=\"root\"><transblock>\n"
      "<translate x=\"q\" y=\"0\" z=\"0\"/>" +
      std::string(cube_block).substr(12) + "</object></scenefile>");
  EXPECT_THAT(found(reading),
              ElementsAre("2:21 error xml.duplicate-name", "3:12 error xml.number"));
}

const std::string two_objects = in_root(
    "<transblock><translate x=\"1\" y=\"0\" z=\"0\"/>\n<object type=\"primitive\" name=\"cube\"/>\n"
    "<object type=\"primitive\" name=\"cone\"><nonsense/></object>\n<scale x=\"2\" y=\"2\" "
    "z=\"2\"/></transblock>");

TEST(XmlScene, NothingCountsAfterTheFirstObject) {
  const Reading reading = read(two_objects);
  EXPECT_THAT(found(reading),
              ElementsAre("5:1 warning xml.after-object", "6:1 warning xml.after-object"));
  EXPECT_EQ(only_child(reading.scene).primitives.size(), 1u);
  EXPECT_EQ(only_child(reading.scene).transforms.size(), 1u);
}

TEST(XmlScene, TheCourseUsesAllOfABlock) {
  const Reading reading = read_compat(two_objects);
  EXPECT_THAT(found(reading),
              ElementsAre("5:1 warning xml.after-object-used", "5:38 warning xml.unknown-element",
                          "6:1 warning xml.after-object-used"));
  EXPECT_EQ(only_child(reading.scene).primitives.size(), 2u);
  EXPECT_EQ(only_child(reading.scene).primitives[1].shape, Shape::cone);
  const std::vector<Transform>& transforms = only_child(reading.scene).transforms;
  ASSERT_EQ(transforms.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<Scale>(transforms[1].map));
}

// An instance node has no other contents, so instances next to other objects become children.
TEST(XmlScene, InstancesInABlockOfSeveralObjects) {
  const std::string use = "<object type=\"master\" name=\"part\"/>";
  const std::string cube = "<object type=\"primitive\" name=\"cube\"/>";
  const std::string tree = "<object type=\"tree\">" + std::string(cube_block) + "</object>";
  for (const std::string& objects : {use + cube, cube + use, use + use, tree + use, use + tree}) {
    for (const bool late : {false, true}) {
      const std::string root =
          "<object type=\"tree\" name=\"root\"><transblock>" + objects + "</transblock></object>";
      const Reading reading = read_compat(
          "<scenefile>" + (late ? root + std::string(packet_bvh) : std::string(packet_bvh) + root) +
          "</scenefile>");
      EXPECT_FALSE(reading.diagnostics.has_errors());
      const Scene& scene = reading.scene;
      const Node& block = only_child(scene);
      EXPECT_TRUE(block.instance_of.empty());
      std::size_t instances = 0;
      std::size_t others = block.primitives.size();
      for (const NodeId child : block.children) {
        instances += scene.nodes[child].instance_of == "part";
        others += !scene.nodes[child].primitives.empty();
      }
      EXPECT_EQ(instances, objects == use + use ? 2u : 1u) << objects;
      EXPECT_EQ(instances + others, 2u) << objects;
    }
  }
}

TEST(XmlScene, TheCourseReadsThePrefixOfANumber) {
  const std::string text = with_transforms("<translate x=\"1.5abc\" y=\"..7\" z=\"1,5\"/>");
  EXPECT_EQ(found(read(text)),
            (std::vector<std::string>{"4:12 error xml.number", "4:23 error xml.number",
                                      "4:31 error xml.number"}));
  const Reading reading = read_compat(text);
  EXPECT_EQ(reading.diagnostics.count(Severity::warning), 3u);
  EXPECT_FALSE(reading.diagnostics.has_errors());
  EXPECT_EQ(std::get<Translate>(only_child(reading.scene).transforms.at(0).map).by,
            glm::vec3(1.5f, 0, 1));
}

TEST(XmlScene, AnObjectWithoutATransblockIsReadInOne) {
  const Reading reading =
      read(in_root("<object type=\"primitive\" name=\"cube\"><blend v=\"1\"/></object>\n" +
                   std::string(cube_block)));
  EXPECT_THAT(found(reading), ElementsAre("3:1 warning xml.object-without-transblock"));
  const Node& root = reading.scene.nodes[reading.scene.root];
  ASSERT_EQ(root.children.size(), 2u);
  EXPECT_EQ(reading.scene.nodes[root.children[0]].primitives.at(0).material.blend, 1);
  EXPECT_EQ(reading.scene.nodes[root.children[1]].primitives.size(), 1u);
}

TEST(XmlScene, AnObjectWithoutATransblockThatIsLeftOut) {
  const Reading reading = read(in_root(
      "<object type=\"primitive\" name=\"teapot\"><a/></object>\n" + std::string(cube_block)));
  EXPECT_THAT(found(reading), ElementsAre("3:1 warning xml.object-without-transblock",
                                          "3:26 warning xml.unknown-shape"));
  EXPECT_EQ(reading.scene.nodes[reading.scene.root].children.size(), 2u);
}

TEST(XmlScene, IgnoredElementsAreIgnoredWithTheirContents) {
  const Reading reading = read(with_transforms(
      "<keyframe><translate x=\"q\"/><object><object/></object>text</keyframe><scale x=\"2\" "
      "y=\"2\" z=\"2\"/>"));
  EXPECT_THAT(found(reading), ElementsAre("4:1 warning xml.unknown-element"));
  EXPECT_EQ(only_child(reading.scene).transforms.size(), 1u);
}

TEST(XmlScene, OnlyTreesAreAllowedAtTheTop) {
  EXPECT_THAT(found(read(with_top("<object type=\"primitive\" name=\"cube\"/>"))),
              ElementsAre("2:1 warning xml.misplaced-element"));
  EXPECT_THAT(found(read(with_top("<object type=\"tree\"/>"))),
              ElementsAre("2:1 error xml.master-name"));
  EXPECT_THAT(found(read(with_top(std::string(cube_block)))),
              ElementsAre("2:1 warning xml.misplaced-element"));
}

TEST(XmlScene, ManyBlocks) {
  std::string blocks;
  for (int i = 0; i < 20'000; ++i) {
    blocks += cube_block;
  }
  const Reading reading = read(in_root(blocks));
  EXPECT_THAT(found(reading), IsEmpty());
  EXPECT_EQ(reading.scene.nodes.size(), 20'001u);
  EXPECT_EQ(reading.scene.nodes[reading.scene.root].children.size(), 20'000u);
}

}  // namespace
}  // namespace scenefile::testing
