// The output and the findings of the writers.

#include "scenefile/format/write_scene.h"

#include "format/codes_of.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/prepare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

namespace scenefile {
namespace {

struct Written {
  std::string text;
  Diagnostics diagnostics;

  bool gives(const Code& code) const {
    return std::any_of(diagnostics.list().begin(), diagnostics.list().end(),
                       [&](const Diagnostic& d) { return d.code == &code; });
  }
};

Written write(const Scene& scene, SceneFormat format, const Limits& limits = {}) {
  Written written;
  written.text = write_scene(scene, format, limits, written.diagnostics);
  return written;
}

Scene read(const std::string& text) {
  Diagnostics diagnostics;
  Scene scene = read_scene(text, {}, diagnostics);
  EXPECT_EQ(diagnostics.count(Severity::error) + diagnostics.count(Severity::warning), 0u)
      << text << diagnostics.list().front().message;
  return scene;
}

Primitive primitive(Shape shape) {
  Primitive result;
  result.shape = shape;
  return result;
}

Light light(LightType type) {
  Light result;
  result.type = type;
  result.direction = type == LightType::point ? glm::vec3(0) : glm::vec3(0, -1, 0);
  return result;
}

// A camera, a light and a cube, which both formats represent without a note.
Scene plain_scene() {
  Scene scene;
  scene.camera.emplace();
  add_child(scene, scene.root);
  scene.nodes[1].primitives.push_back(primitive(Shape::cube));
  return scene;
}

// Everything once.
Scene example() {
  Scene scene;
  scene.name = "desk";
  scene.global.transparent = 0.25f;
  Camera& camera = scene.camera.emplace();
  camera.aperture = 0.125f;
  camera.focal_length = 4;
  const NodeId leg = add_template(scene, "leg");
  const NodeId inside = add_child(scene, leg);
  scene.nodes[inside].transforms = {{Translate{{0, 0.5f, 0}}, {}}, {Scale{{0.1f, 1, 0.1f}}, {}}};
  scene.nodes[inside].primitives.push_back(primitive(Shape::cylinder));
  const NodeId lamp = add_child(scene, scene.root);
  scene.nodes[lamp].transforms = {{Translate{{1, 2, 3}}, {}}};
  Light spot = light(LightType::spot);
  spot.angle_deg = 20;
  spot.penumbra_deg = 5;
  scene.nodes[lamp].lights.push_back(spot);
  const NodeId copy = add_child(scene, scene.root);
  scene.nodes[copy].instance_of = "leg";
  const NodeId top = add_child(scene, scene.root);
  scene.nodes[top].name = "top & \"bottom\"";
  scene.nodes[top].transforms = {{Rotate{{0, 1, 0}, 45}, {}}};
  Primitive mesh = primitive(Shape::mesh);
  mesh.mesh_file = "models\\top.obj";
  mesh.material.diffuse = {1, 0.5f, 0};
  mesh.material.shininess = 10;
  mesh.material.blend = 1;
  mesh.material.texture = TextureUse{"wood.png", 2, 1, {}};
  scene.nodes[top].primitives.push_back(mesh);
  return scene;
}

TEST(WriteScene, Xml) {
  const Written written = write(example(), SceneFormat::xml);
  EXPECT_EQ(written.text, R"(<scenefile>
  <globaldata>
    <ambientcoeff v="0.5"/>
    <diffusecoeff v="0.5"/>
    <specularcoeff v="0.5"/>
    <transparentcoeff v="0.25"/>
  </globaldata>
  <cameradata>
    <pos x="5" y="5" z="5"/>
    <look x="-1" y="-1" z="-1"/>
    <up x="0" y="1" z="0"/>
    <heightangle v="45"/>
    <aperture v="0.125"/>
    <focallength v="4"/>
  </cameradata>
  <lightdata>
    <id v="0"/>
    <type v="spot"/>
    <color r="1" g="1" b="1"/>
    <function v1="1" v2="0" v3="0"/>
    <position x="1" y="2" z="3"/>
    <direction x="0" y="-1" z="0"/>
    <penumbra v="5"/>
    <angle v="20"/>
  </lightdata>
  <object type="tree" name="leg">
    <transblock>
      <translate x="0" y="0.5" z="0"/>
      <scale x="0.1" y="1" z="0.1"/>
      <object type="primitive" name="cylinder"/>
    </transblock>
  </object>
  <object type="tree" name="root">
    <transblock>
      <object type="master" name="leg"/>
    </transblock>
    <transblock>
      <rotate x="0" y="1" z="0" angle="45"/>
      <object type="tree" name="top &amp; &quot;bottom&quot;">
        <transblock>
          <object type="primitive" name="mesh" filename="models\top.obj">
            <diffuse r="1" g="0.5" b="0"/>
            <shininess v="10"/>
            <texture file="wood.png" u="2" v="1"/>
            <blend v="1"/>
          </object>
        </transblock>
      </object>
    </transblock>
  </object>
</scenefile>
)");
  EXPECT_TRUE(same_meaning(read(written.text), example()));
}

TEST(WriteScene, Json) {
  const Written written = write(example(), SceneFormat::json);
  EXPECT_EQ(written.text, R"({
  "name": "desk",
  "globalData": {
    "ambientCoeff": 0.5,
    "diffuseCoeff": 0.5,
    "specularCoeff": 0.5,
    "transparentCoeff": 0.25
  },
  "cameraData": {
    "position": [5, 5, 5],
    "up": [0, 1, 0],
    "look": [-1, -1, -1],
    "heightAngle": 45,
    "aperture": 0.125,
    "focalLength": 4
  },
  "templateGroups": [
    {
      "name": "leg",
      "groups": [
        {
          "translate": [0, 0.5, 0],
          "scale": [0.1, 1, 0.1],
          "primitives": [
            {
              "type": "cylinder"
            }
          ]
        }
      ]
    }
  ],
  "groups": [
    {
      "translate": [1, 2, 3],
      "lights": [
        {
          "type": "spot",
          "color": [1, 1, 1],
          "attenuationCoeff": [1, 0, 0],
          "direction": [0, -1, 0],
          "penumbra": 5,
          "angle": 20
        }
      ]
    },
    {
      "name": "leg"
    },
    {
      "name": "top & \"bottom\"",
      "rotate": [0, 1, 0, 45],
      "primitives": [
        {
          "type": "mesh",
          "meshFile": "models\\top.obj",
          "diffuse": [1, 0.5, 0],
          "shininess": 10,
          "textureFile": "wood.png",
          "textureU": 2,
          "textureV": 1,
          "blend": 1
        }
      ]
    }
  ]
}
)");
  EXPECT_EQ(read(written.text), example());
}

TEST(WriteScene, TransformsInAnyOrderBecomeGroupsInGroups) {
  Scene scene = plain_scene();
  const Transform move = {Translate{{1, 0, 0}}, {}};
  const Transform turn = {Rotate{{0, 1, 0}, 90}, {}};
  const Transform grow = {Scale{{2, 2, 2}}, {}};
  scene.nodes[1].transforms = {turn, move, grow, grow};
  scene.nodes[1].name = "arm";
  const Scene back = read(write(scene, SceneFormat::json).text);
  const Node& outer = back.nodes[back.nodes[back.root].children.at(0)];
  const Node& middle = back.nodes[outer.children.at(0)];
  const Node& inner = back.nodes[middle.children.at(0)];
  EXPECT_EQ(outer.name, "arm");
  EXPECT_EQ(outer.transforms, std::vector{turn});
  EXPECT_EQ(middle.transforms, (std::vector{move, grow}));
  EXPECT_EQ(inner.transforms, std::vector{grow});
  EXPECT_EQ(inner.primitives.size(), 1u);
  EXPECT_TRUE(same_meaning(scene, back));
}

TEST(WriteScene, SeveralObjectsOfANodeGetATransblockEach) {
  Scene scene = plain_scene();
  scene.nodes[1].primitives.push_back(primitive(Shape::cone));
  scene.nodes[add_child(scene, 1)].primitives.push_back(primitive(Shape::sphere));
  const Scene back = read(write(scene, SceneFormat::xml).text);
  const Node& node = back.nodes[back.nodes[back.root].children.at(0)];
  ASSERT_EQ(node.children.size(), 3u);
  EXPECT_EQ(back.nodes[node.children[0]].primitives.at(0).shape, Shape::cube);
  EXPECT_EQ(back.nodes[node.children[1]].primitives.at(0).shape, Shape::cone);
  EXPECT_EQ(back.nodes[node.children[2]].primitives.at(0).shape, Shape::sphere);
}

TEST(WriteScene, LightsOfATemplateAreWrittenForEachCopy) {
  Scene scene = plain_scene();
  const NodeId lamp = add_template(scene, "lamp");
  scene.nodes[lamp].transforms = {{Scale{{2, 2, 2}}, {}}};
  Light bulb = light(LightType::point);
  bulb.position = {0, 1, 0};
  scene.nodes[lamp].lights.push_back(bulb);
  for (const float x : {10.0f, 20.0f}) {
    const NodeId copy = add_child(scene, scene.root);
    scene.nodes[copy].instance_of = "lamp";
    scene.nodes[copy].transforms = {{Translate{{x, 0, 0}}, {}}};
  }
  const Scene back = read(write(scene, SceneFormat::xml).text);
  const auto& lights = back.nodes[back.root].lights;
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_EQ(lights[0].position, glm::vec3(10, 2, 0));
  EXPECT_EQ(lights[1].position, glm::vec3(20, 2, 0));
  EXPECT_EQ(lights[0].id, 0);
  EXPECT_EQ(lights[1].id, 1);
}

TEST(WriteScene, TemplatesFollowTheTemplatesTheyUse) {
  Scene scene = plain_scene();
  const NodeId a = add_template(scene, "a");
  const NodeId b = add_template(scene, "b");
  scene.nodes[add_child(scene, a)].instance_of = "b";
  scene.nodes[add_child(scene, b)].primitives.push_back(primitive(Shape::cube));
  scene.nodes[add_child(scene, scene.root)].instance_of = "a";
  for (const SceneFormat format : {SceneFormat::xml, SceneFormat::json}) {
    const Scene back = read(write(scene, format).text);
    ASSERT_EQ(back.templates.size(), 2u);
    EXPECT_EQ(back.nodes[back.templates[0]].name, "b");
  }
}

TEST(WriteScene, ATemplateCalledRootGetsAnotherNameInXml) {
  constexpr std::string_view json = R"({
    "globalData": {"ambientCoeff": 0.5, "diffuseCoeff": 0.5, "specularCoeff": 0.5},
    "cameraData": {"position": [0, 0, 5], "up": [0, 1, 0], "look": [0, 0, -1], "heightAngle": 45},
    "templateGroups": [{"name": "root", "primitives": [{"type": "cube"}]}],
    "groups": [{"name": "root"}]})";
  Diagnostics reading;
  const Scene scene = read_scene(json, {}, reading);
  check(scene, {}, reading);
  EXPECT_FALSE(reading.has_errors());
  Diagnostics writing;
  const std::string xml = write_scene(scene, SceneFormat::xml, {}, writing);
  ASSERT_EQ(writing.list().size(), 1u);
  EXPECT_EQ(writing.list()[0].code, &"write.renamed"_code);
  EXPECT_TRUE(same_meaning(scene, read_scene(xml, {}, reading)));
  EXPECT_FALSE(reading.has_errors());
}

TEST(WriteScene, DeepScenesNeedNoStack) {
  Scene scene = plain_scene();
  NodeId node = 1;
  for (int i = 0; i < 200'000; ++i) {
    node = add_child(scene, node);
  }
  scene.nodes[node].primitives.push_back(primitive(Shape::cube));
  for (const SceneFormat format : {SceneFormat::xml, SceneFormat::json}) {
    scene.nodes[node].primitives.resize(2);
    EXPECT_TRUE(write(scene, format).gives("write.nesting-limit"_code));
  }
}

TEST(WriteScene, TheNestingLimitIsThatOfTheReader) {
  for (const SceneFormat format : {SceneFormat::xml, SceneFormat::json}) {
    Scene scene = plain_scene();
    NodeId node = 1;
    for (int depth = 0; depth < 20; ++depth) {
      node = add_child(scene, node);
      scene.nodes[node].primitives.push_back(primitive(Shape::cube));
      ReadOptions options;
      options.limits.nesting = 20;
      const Written written = write(scene, format, options.limits);
      Diagnostics diagnostics;
      read_scene(written.text, options, diagnostics);
      EXPECT_EQ(written.gives("write.nesting-limit"_code), diagnostics.has_errors()) << depth;
    }
  }
}

TEST(WriteScene, BrokenScenesAreWrittenAllTheSame) {
  Scene scene = plain_scene();
  scene.nodes[1].children = {1, 0, 77};
  scene.templates = {1, 99, 0};
  scene.nodes[1].instance_of = "nothing";
  scene.nodes[0].transforms = {{Scale{{std::numeric_limits<float>::quiet_NaN(), 1, 1}}, {}}};
  for (const SceneFormat format : {SceneFormat::xml, SceneFormat::json}) {
    EXPECT_FALSE(write(scene, format).text.empty());
    scene.root = 1234;
    EXPECT_FALSE(write(scene, format).text.empty());
  }
}

TEST(WriteScene, TemplatesThatContainThemselvesEnd) {
  Scene scene = plain_scene();
  const NodeId a = add_template(scene, "a");
  scene.nodes[a].lights.push_back(light(LightType::point));
  scene.nodes[add_child(scene, a)].instance_of = "a";
  scene.nodes[add_child(scene, a)].instance_of = "a";
  scene.nodes[add_child(scene, scene.root)].instance_of = "a";
  for (const SceneFormat format : {SceneFormat::xml, SceneFormat::json}) {
    EXPECT_FALSE(write(scene, format).text.empty());
  }
}

// A change to plain_scene() that causes a code, and a similar one that does not.
struct CodeCase {
  const Code& code;
  SceneFormat format;
  std::function<void(Scene&)> give;
  std::function<void(Scene&)> nearly;
};

void add_light(Scene& scene, NodeId node, const Light& added) {
  scene.nodes[node].lights.push_back(added);
}

Light with_id(Light light) {
  light.id = 3;
  return light;
}

std::vector<CodeCase> code_cases() {
  const Light point = with_id(light(LightType::point));
  const auto area_under = [](const Transform& transform) {
    return [transform](Scene& s) {
      Light area = with_id(light(LightType::area));
      area.direction = {0, 0, -1};
      area.width = 1;
      area.height = 2;
      add_light(s, 1, area);
      s.nodes[1].transforms.push_back(transform);
    };
  };
  const auto lights = [point](int count) {
    return [point, count](Scene& s) {
      for (int i = 0; i < count; ++i) {
        Light numbered = point;
        numbered.id = i;
        add_light(s, 0, numbered);
      }
    };
  };
  const auto named = [](const std::string& name) {
    return [name](Scene& s) { s.nodes[1].name = name; };
  };
  const auto mesh_of = [](const std::string& file) {
    return [file](Scene& s) {
      s.nodes[1].primitives[0].shape = Shape::mesh;
      s.nodes[1].primitives[0].mesh_file = file;
    };
  };
  const auto matrix_with = [](float last) {
    return [last](Scene& s) {
      glm::mat4 m(1);
      m[3][3] = last;
      s.nodes[1].transforms.push_back({Matrix(m), {}});
    };
  };
  const auto nested = [](int depth) {
    return [depth](Scene& s) {
      NodeId node = 1;
      for (int i = 0; i < depth; ++i) {
        node = add_child(s, node);
      }
      s.nodes[node].primitives.push_back(primitive(Shape::cube));
    };
  };
  const Transform move = {Translate{{1, 0, 0}}, {}};
  const Transform grow = {Scale{{2, 2, 2}}, {}};
  using enum SceneFormat;
  return {
      {"write.light-moved"_code, xml, [=](Scene& s) { add_light(s, 1, point); },
       [=](Scene& s) { add_light(s, 0, point); }},
      {"write.light-limit"_code, xml, lights(1025), lights(1024)},
      {"write.light-turned"_code, xml, area_under({Rotate{{0, 0, 1}, 30}, {}}),
       area_under({Rotate{{0, 1, 0}, 30}, {}})},
      {"write.light-dark"_code, xml,
       [=](Scene& s) {
         add_light(s, 1, point);
         s.nodes[1].lights[0].type = LightType::directional;
       },
       [=](Scene& s) { add_light(s, 1, with_id(light(LightType::directional))); }},
      {"write.light-id"_code, xml, [=](Scene& s) { add_light(s, 0, light(LightType::point)); },
       [=](Scene& s) { add_light(s, 0, point); }},
      {"write.light-id"_code, json, [=](Scene& s) { add_light(s, 0, point); },
       [=](Scene& s) { add_light(s, 0, light(LightType::point)); }},
      {"write.light-name"_code, xml,
       [=](Scene& s) {
         add_light(s, 0, point);
         s.nodes[0].lights[0].name = "sun";
       },
       [=](Scene& s) { add_light(s, 0, point); }},
      {"write.scene-name"_code, xml, [](Scene& s) { s.name = "desk"; },
       [](Scene& s) { s.name = "root"; }},
      {"write.area-light"_code, json, area_under(move),
       [=](Scene& s) { add_light(s, 1, light(LightType::spot)); }},
      {"write.default-camera"_code, json, [](Scene& s) { s.camera.reset(); }, [](Scene&) {}},
      {"write.transforms-nested"_code, json,
       [=](Scene& s) {
         s.nodes[1].transforms = {grow, move};
       },
       [=](Scene& s) {
         s.nodes[1].transforms = {move, grow};
       }},
      {"write.renamed"_code, json,
       [=](Scene& s) {
         add_template(s, "arm");
         named("arm")(s);
       },
       [=](Scene& s) {
         add_template(s, "arm");
         named("Arm")(s);
       }},
      {"write.renamed"_code, xml, named("root"), named("Root")},
      {"write.empty-group"_code, xml, [](Scene& s) { add_child(s, 1); },
       [=](Scene& s) { add_light(s, add_child(s, 1), point); }},
      {"write.empty-group"_code, json, [](Scene& s) { add_child(s, 1); },
       [=](Scene& s) { add_light(s, add_child(s, 1), point); }},
      {"write.matrix-row"_code, xml, matrix_with(2), matrix_with(1)},
      {"write.character"_code, xml, mesh_of("a\x01.obj"), mesh_of("a\t.obj")},
      {"write.character"_code, json, mesh_of("a\xff.obj"), mesh_of("a\x01.obj")},
      {"write.nesting-limit"_code, json, nested(600), nested(500)},
      {"write.nesting-limit"_code, xml, nested(600), nested(500)},
  };
}

TEST(WriteCodes, EachIsTriggeredByASceneAndNotByASimilarOne) {
  std::vector<const Code*> given;
  for (const CodeCase& c : code_cases()) {
    Scene scene = plain_scene();
    c.give(scene);
    EXPECT_TRUE(write(scene, c.format).gives(c.code)) << c.code.name;
    scene = plain_scene();
    c.nearly(scene);
    EXPECT_FALSE(write(scene, c.format).gives(c.code)) << c.code.name;
    given.push_back(&c.code);
  }
  for (const Code* code : codes_of("write.")) {
    EXPECT_NE(std::find(given.begin(), given.end(), code), given.end()) << code->name;
  }
}

TEST(WriteCodes, APlainSceneIsWrittenWithoutFindings) {
  for (const SceneFormat format : {SceneFormat::xml, SceneFormat::json}) {
    const Written written = write(plain_scene(), format);
    EXPECT_TRUE(written.diagnostics.list().empty());
    EXPECT_TRUE(same_meaning(read(written.text), plain_scene()));
  }
}

}  // namespace
}  // namespace scenefile
