#include "scenefile/scene/check.h"

#include "builders.h"
#include "scenefile/scene/codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>

using namespace scenefile;
using namespace scenefile::test;
using testing::HasSubstr;

namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

using Change = std::function<void(Scene&)>;

// A finding: a change to fine_scene() that causes it, a similar one that does not, and a word in
// its message.
struct Case {
  const Code* code;
  Change gives;
  Change near_miss;
  std::string word;
};

Change camera(const std::function<void(Camera&)>& change) {
  return [change](Scene& s) { change(s.camera.emplace()); };
}

Change light(LightType type, const std::function<void(Light&)>& change) {
  return [type, change](Scene& s) {
    Light& l = s.nodes[0].lights[0];
    l.type = type;
    l.direction = {0, -1, 0};
    l.angle_deg = 30.0f;
    l.penumbra_deg = 5;
    l.width = l.height = 1;
    change(l);
  };
}

Change material(const std::function<void(Material&)>& change) {
  return [change](Scene& s) { change(s.nodes[0].primitives[0].material); };
}

Change texture(const std::function<void(TextureUse&)>& change) {
  return material([change](Material& m) {
    m.blend = 1;
    change(m.texture.emplace(TextureUse{"a.png", 1, 1, {}}));
  });
}

Change placed(const std::vector<Transform>& transforms) {
  return [transforms](Scene& s) { add_primitive(s, 0, transforms); };
}

Change templates(const std::function<void(Scene&, NodeId)>& change) {
  return [change](Scene& s) {
    const NodeId head = add_template(s, "table");
    add_primitive(s, head);
    add_instance(s, 0, "table");
    change(s, head);
  };
}

Change lights(int count) {
  return [count](Scene& s) { s.nodes[0].lights.assign(static_cast<std::size_t>(count), Light{}); };
}

glm::mat4 last_row(glm::vec4 row, glm::vec3 column) {
  glm::mat4 m(1);
  for (int c = 0; c < 4; ++c) {
    m[c].w = row[c];
  }
  m[3] = glm::vec4(column, row.w);
  return m;
}

void add_cases_of_scene(std::vector<Case>& cases) {
  cases.push_back({&"scene.bad-index"_code, [](Scene& s) { s.nodes[0].children = {1}; },
                   [](Scene& s) { add_group(s, 0); }, "node 1"});
  cases.push_back({&"scene.shared-node"_code,
                   [](Scene& s) {
                     s.nodes[0].children = {add_group(s, 0), 1};
                   },
                   [](Scene& s) {
                     add_group(s, 0);
                     s.nodes.emplace_back().children = {1};  // not part of the scene
                   },
                   "node 1"});
  cases.push_back({&"scene.not-finite"_code, camera([](Camera& c) { c.look.x = nan_value; }),
                   camera([](Camera& c) { c.look.x = std::numeric_limits<float>::max(); }),
                   "look"});
  cases.push_back({&"scene.empty"_code, [](Scene& s) { s.nodes[0].primitives.clear(); },
                   [](Scene& s) {
                     s.nodes[0].primitives.clear();
                     add_primitive(s, add_template(s, "t"));
                     add_instance(s, 0, "t");
                   },
                   "empty"});
  cases.push_back({&"scene.no-light"_code, [](Scene& s) { s.nodes[0].lights.clear(); },
                   [](Scene& s) {
                     s.nodes[0].lights.clear();
                     s.nodes[add_template(s, "t")].lights = {point_light()};
                     add_instance(s, 0, "t");
                   },
                   "no light"});
  cases.push_back({&"global.negative"_code, [](Scene& s) { s.global.specular = -0.5f; },
                   [](Scene& s) { s.global.specular = 0; }, "specularcoeff -0.5"});
  cases.push_back({&"global.huge"_code, [](Scene& s) { s.global.diffuse = 1e30f; },
                   [](Scene& s) { s.global.diffuse = 2; }, "diffusecoeff"});
  cases.push_back({&"global.transparent-default"_code, material([](Material& m) {
                     m.transparent = {0.5f, 0, 0};
                   }),
                   [](Scene& s) {
                     s.nodes[0].primitives[0].material.transparent = {0.5f, 0, 0};
                     s.global.transparent = 0;
                   },
                   "transparentcoeff"});
}

void add_cases_of_camera(std::vector<Case>& cases) {
  cases.push_back({&"camera.look-zero"_code, camera([](Camera& c) {
                     c.look = {0, 0, 0};
                   }),
                   camera([](Camera& c) {
                     c.look = {0, 0, -1e-30f};
                   }),
                   "look"});
  cases.push_back({&"camera.up-zero"_code, camera([](Camera& c) {
                     c.up = {0, 0, 0};
                   }),
                   camera([](Camera& c) {
                     c.up = {0, 1e-30f, 0};
                   }),
                   "up"});
  cases.push_back({&"camera.up-parallel-to-look"_code, camera([](Camera& c) {
                     c.look = {0, -3, 0};
                   }),
                   camera([](Camera& c) {
                     c.look = {0, -3, 0.1f};
                   }),
                   "up"});
  cases.push_back({&"camera.up-nearly-parallel"_code, camera([](Camera& c) {
                     c.look = {0, -3, 0.0003f};
                   }),
                   camera([](Camera& c) {
                     c.look = {0, -3, 0.01f};
                   }),
                   "nearly parallel"});
  cases.push_back({&"camera.height-angle"_code, camera([](Camera& c) { c.height_angle_deg = 180; }),
                   camera([](Camera& c) { c.height_angle_deg = 179; }), "heightangle"});
  cases.push_back({&"camera.height-angle"_code, camera([](Camera& c) { c.height_angle_deg = 0; }),
                   camera([](Camera& c) { c.height_angle_deg = 0.001f; }), "heightangle"});
  cases.push_back({&"camera.height-angle"_code,
                   camera([](Camera& c) { c.height_angle_deg = nan_value; }),
                   camera([](Camera&) {}), "heightangle"});
  cases.push_back({&"camera.far-away"_code, camera([](Camera& c) { c.position.z = -1e30f; }),
                   camera([](Camera& c) { c.position.z = -1e6f; }), "pos"});
  cases.push_back({&"camera.lens-negative"_code, camera([](Camera& c) { c.aperture = -1; }),
                   camera([](Camera& c) { c.aperture = 0; }), "aperture"});
  cases.push_back({&"camera.lens-negative"_code, camera([](Camera& c) { c.focal_length = -1; }),
                   camera([](Camera& c) { c.focal_length = 1; }), "focallength"});
  cases.push_back({&"camera.lens-incomplete"_code, camera([](Camera& c) { c.aperture = 0.5f; }),
                   camera([](Camera& c) {
                     c.aperture = 0.5f;
                     c.focal_length = 4;
                   }),
                   "focallength"});
}

void add_cases_of_lights(std::vector<Case>& cases) {
  using enum LightType;
  cases.push_back({&"light.many"_code, lights(9), lights(8), "9 lights"});
  cases.push_back({&"light.count-limit"_code, lights(1025), lights(1024), "1024"});
  cases.push_back({&"light.duplicate-id"_code,
                   [](Scene& s) {
                     lights(2)(s);
                     s.nodes[0].lights[0].id = s.nodes[0].lights[1].id = 3;
                   },
                   lights(2), "id 3"});
  cases.push_back({&"light.id-range"_code, light(point, [](Light& l) { l.id = 8; }),
                   light(point, [](Light& l) { l.id = 7; }), "id 8"});
  cases.push_back({&"light.id-range"_code, light(point, [](Light& l) { l.id = -1; }),
                   light(point, [](Light& l) { l.id = 0; }), "id -1"});
  for (const LightType type : {directional, spot, area}) {
    cases.push_back({&"light.direction-zero"_code,
                     light(type,
                           [](Light& l) {
                             l.direction = {0, 0, 0};
                           }),
                     light(point,
                           [](Light& l) {
                             l.direction = {0, 0, 0};
                           }),
                     "direction"});
  }
  cases.push_back({&"light.function-zero"_code,
                   light(spot,
                         [](Light& l) {
                           l.attenuation = {0, 0, 0};
                         }),
                   light(directional,
                         [](Light& l) {
                           l.attenuation = {0, 0, 0};
                         }),
                   "function"});
  cases.push_back({&"light.function-negative"_code,
                   light(point,
                         [](Light& l) {
                           l.attenuation = {1, -1, 0};
                         }),
                   light(directional,
                         [](Light& l) {
                           l.attenuation = {1, -1, 0};
                         }),
                   "function"});
  cases.push_back({&"light.color-negative"_code,
                   light(point,
                         [](Light& l) {
                           l.color = {1, -1, 0};
                         }),
                   light(point,
                         [](Light& l) {
                           l.color = {1, 0, 0};
                         }),
                   "color 1 -1 0"});
  cases.push_back({&"light.color-huge"_code,
                   light(point,
                         [](Light& l) {
                           l.color = {255, 255, 255};
                         }),
                   light(point,
                         [](Light& l) {
                           l.color = {10, 1, 1};
                         }),
                   "255?"});
  cases.push_back({&"light.color-huge"_code,
                   light(point,
                         [](Light& l) {
                           l.color = {1e6f, 0, 0};
                           l.attenuation = {0, 0, 1};
                         }),
                   light(point,
                         [](Light& l) {
                           l.color = {200, 200, 200};
                           l.attenuation = {0, 0, 1};
                         }),
                   "color"});
  cases.push_back({&"light.color-huge"_code,
                   light(directional,
                         [](Light& l) {
                           l.color = {200, 200, 200};
                           l.attenuation = {0, 0, 1};
                         }),
                   light(directional,
                         [](Light& l) {
                           l.color = {10, 10, 10};
                         }),
                   "color"});
  cases.push_back({&"light.spot-without-angle"_code,
                   light(spot, [](Light& l) { l.angle_deg.reset(); }),
                   light(point, [](Light& l) { l.angle_deg.reset(); }), "penumbra 5"});
  cases.push_back({&"light.spot-without-angle"_code,
                   light(spot,
                         [](Light& l) {
                           l.angle_deg.reset();
                           l.penumbra_deg = 0;
                         }),
                   light(spot, [](Light&) {}), "lights nothing"});
  cases.push_back({&"light.angle-range"_code, light(spot, [](Light& l) { l.angle_deg = 181.0f; }),
                   light(spot, [](Light& l) { l.angle_deg = 180.0f; }), "counts as 180"});
  cases.push_back({&"light.angle-range"_code, light(spot, [](Light& l) { l.angle_deg = 0.0f; }),
                   light(point, [](Light& l) { l.angle_deg = 0.0f; }), "angle 0"});
  cases.push_back({&"light.penumbra-negative"_code,
                   light(spot, [](Light& l) { l.penumbra_deg = -1; }),
                   light(spot, [](Light& l) { l.penumbra_deg = 0; }), "penumbra -1"});
  cases.push_back({&"light.penumbra-over-angle"_code,
                   light(spot, [](Light& l) { l.penumbra_deg = 31; }),
                   light(spot, [](Light& l) { l.penumbra_deg = 30; }), "penumbra 31"});
  cases.push_back({&"light.area-without-size"_code, light(area, [](Light& l) { l.width = 0; }),
                   light(point, [](Light& l) { l.width = 0; }), "width 0"});
  cases.push_back({&"light.area-without-size"_code, light(area, [](Light& l) { l.height = -1; }),
                   light(area, [](Light& l) { l.height = 0.001f; }), "height -1"});
}

void add_cases_of_transforms(std::vector<Case>& cases) {
  cases.push_back({&"transform.axis-zero"_code, placed({rotate({0, 0, 0}, 30)}),
                   placed({rotate({0, 1e-20f, 0}, 30)}), "axis"});
  cases.push_back({&"transform.flat"_code, placed({scale(1, 0, 1)}), placed({scale(1, -0.001f, 1)}),
                   "scale 1 0 1"});
  cases.push_back({&"transform.flat"_code, placed({matrix(glm::mat4(0))}),
                   placed({matrix(glm::mat4(-1))}), "matrix"});
  cases.push_back({&"transform.degenerate"_code,
                   placed(std::vector<Transform>(400, scale(10, 10, 10))),
                   placed(std::vector<Transform>(20, scale(10, 10, 10))), "transforms"});
  cases.push_back({&"transform.degenerate"_code, placed({scale(1e30f, 1, 1)}),
                   placed({scale(1e20f, 1, 1)}), "scale 1e+30 1 1 is too large"});
  cases.push_back({&"transform.degenerate"_code, placed({scale(1, 1e-31f, 1)}),
                   placed({scale(1, 0, 1)}), "scale 1 1e-31 1 is too small"});
  cases.push_back({&"transform.matrix-projective"_code,
                   placed({matrix(last_row({1, 2, 3, 1}, {0, 0, 0}))}),
                   placed({matrix(last_row({0, 0, 0, 1}, {1, 2, 3}))}), "transposed"});
  cases.push_back({&"transform.matrix-projective"_code,
                   placed({matrix(last_row({0, 0, 0, 2}, {1, 2, 3}))}),
                   placed({matrix(glm::mat4(1))}), "0 0 0 2"});
  cases.push_back({&"scene.not-finite"_code, placed({translate(nan_value, 0, 0)}),
                   placed({translate(1e20f, 0, 0)}), "translate"});
}

void add_cases_of_materials(std::vector<Case>& cases) {
  cases.push_back({&"material.color-negative"_code, material([](Material& m) {
                     m.ambient = {-1, 0, 0};
                   }),
                   material([](Material& m) {
                     m.ambient = {0, 0, 0};
                   }),
                   "ambient -1 0 0"});
  cases.push_back({&"material.color-255"_code, material([](Material& m) {
                     m.diffuse = {255, 128, 0};
                   }),
                   material([](Material& m) {
                     m.diffuse = {3.7f, 1, 0};
                   }),
                   "255?"});
  cases.push_back({&"material.color-huge"_code, material([](Material& m) {
                     m.diffuse = {1e30f, 0, 0};
                   }),
                   material([](Material& m) {
                     m.diffuse = {255, 0, 0};
                   }),
                   "diffuse"});
  cases.push_back({&"material.shininess-negative"_code,
                   material([](Material& m) { m.shininess = -1; }),
                   material([](Material& m) { m.shininess = 0; }), "shininess -1"});
  cases.push_back({&"material.shininess-huge"_code,
                   material([](Material& m) { m.shininess = 1e30f; }),
                   material([](Material& m) { m.shininess = 2048; }), "shininess"});
  cases.push_back({&"material.specular-without-shininess"_code, material([](Material& m) {
                     m.specular = {1, 1, 1};
                   }),
                   material([](Material& m) {
                     m.specular = {1, 1, 1};
                     m.shininess = 1;
                   }),
                   "specular"});
  cases.push_back({&"material.ior-negative"_code, material([](Material& m) { m.ior = -1.5f; }),
                   material([](Material& m) { m.ior = 0; }), "ior -1.5"});
  cases.push_back({&"material.ior-unusual"_code, material([](Material& m) { m.ior = 1e10f; }),
                   material([](Material& m) { m.ior = 2.4f; }), "ior"});
  cases.push_back({&"material.ior-unusual"_code, material([](Material& m) { m.ior = 0.01f; }),
                   material([](Material& m) { m.ior = 0.75f; }), "ior"});
  cases.push_back({&"material.blend-range"_code, texture([](TextureUse&) {}), {}, "blend"});
  cases.back().gives = [](Scene& s) { s.nodes[0].primitives[0].material.blend = 1.5f; };
  cases.back().near_miss = texture([](TextureUse&) {});
  cases.push_back({&"material.texture-without-blend"_code, material([](Material& m) {
                     m.texture = TextureUse{"a.png", 1, 1, {}};
                   }),
                   texture([](TextureUse&) {}), "a.png"});
  cases.push_back({&"material.blend-without-texture"_code,
                   material([](Material& m) { m.blend = 0.5f; }), texture([](TextureUse&) {}),
                   "blend 0.5"});
  cases.push_back({&"material.texture-without-file"_code,
                   texture([](TextureUse& t) { t.file.clear(); }), texture([](TextureUse&) {}),
                   "file"});
  cases.push_back({&"material.texture-without-file"_code,
                   material([](Material& m) { m.bump_map.emplace(); }), material([](Material& m) {
                     m.bump_map = TextureUse{"b.png", 1, 1, {}};
                   }),
                   "bumpmap"});
  for (const float repeat : {0.0f, -1.0f, 1e30f, 1e-30f}) {
    cases.push_back({&"material.repeat"_code, texture([=](TextureUse& t) { t.repeat_v = repeat; }),
                     texture([](TextureUse& t) { t.repeat_v = 100; }), "along v"});
  }
  cases.push_back({&"scene.not-finite"_code, texture([](TextureUse& t) { t.repeat_u = nan_value; }),
                   texture([](TextureUse& t) { t.repeat_u = 2; }), "along u"});
  const auto glass = [](float specular, float transparent) {
    return [=](Scene& s) {
      s.global.specular = specular;
      s.global.transparent = transparent;
      s.nodes[0].primitives[0].material.reflective = {1, 0, 0};
      s.nodes[0].primitives[0].material.transparent = {1, 1, 1};
    };
  };
  cases.push_back({&"material.reflective-and-transparent"_code, glass(0.5f, 0.6f),
                   glass(0.5f, 0.5f), "reflective 1 0 0"});
}

void add_cases_of_trees(std::vector<Case>& cases) {
  cases.push_back({&"tree.mesh-without-file"_code,
                   [](Scene& s) { s.nodes[0].primitives[0].shape = Shape::mesh; },
                   [](Scene& s) {
                     s.nodes[0].primitives[0].shape = Shape::mesh;
                     s.nodes[0].primitives[0].mesh_file = "a.obj";
                   },
                   "mesh"});
  cases.push_back({&"tree.template-without-name"_code, [](Scene& s) { add_template(s, ""); },
                   [](Scene& s) { add_template(s, " "); }, "name"});
  cases.push_back({&"tree.duplicate-template"_code,
                   templates([](Scene& s, NodeId) { add_template(s, "table"); }),
                   templates([](Scene& s, NodeId) { add_template(s, "Table"); }), "\"table\""});
  cases.push_back({&"tree.unknown-template"_code,
                   templates([](Scene& s, NodeId) { add_instance(s, 0, "tabel"); }),
                   templates([](Scene&, NodeId) {}), "did you mean \"table\"?"});
  cases.push_back({&"tree.unknown-template"_code, [](Scene& s) { add_instance(s, 0, "root"); },
                   [](Scene&) {}, "the scene itself"});
  cases.push_back(
      {&"tree.loop"_code, templates([](Scene& s, NodeId head) { add_instance(s, head, "table"); }),
       templates([](Scene& s, NodeId) { add_instance(s, 0, "table"); }), "table -> table"});
  cases.push_back({&"tree.loop"_code, templates([](Scene& s, NodeId head) {
                     add_instance(s, head, "leg");
                     add_instance(s, add_template(s, "leg"), "table");
                   }),
                   templates([](Scene& s, NodeId head) {
                     add_instance(s, head, "leg");
                     add_primitive(s, add_template(s, "leg"));
                   }),
                   "table -> leg -> table"});
  cases.push_back(
      {&"tree.used-before-declared"_code, templates([](Scene& s, NodeId head) {
         add_instance(s, head, "late");
         add_primitive(s, add_template(s, "late"));
       }),
       templates([](Scene& s, NodeId) { add_instance(s, add_template(s, "late"), "table"); }),
       "\"late\""});
  cases.push_back(
      {&"tree.instance-with-contents"_code,
       templates([](Scene& s, NodeId) { s.nodes.back().primitives.push_back(primitive()); }),
       templates([](Scene& s, NodeId) { s.nodes.back().transforms.push_back(scale(2, 2, 2)); }),
       "ignored"});
  cases.push_back({&"tree.unused-template"_code, [](Scene& s) { add_template(s, "lonely"); },
                   templates([](Scene&, NodeId) {}), "lonely"});
  cases.push_back({&"tree.nesting-limit"_code, [](Scene& s) { s = bomb(1024, 1, true); },
                   [](Scene& s) { s = bomb(1023, 1, true); }, "1025"});
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_cases_of_scene(cases);
  add_cases_of_camera(cases);
  add_cases_of_lights(cases);
  add_cases_of_transforms(cases);
  add_cases_of_materials(cases);
  add_cases_of_trees(cases);
  return cases;
}

Diagnostics checked(const Scene& scene) {
  Diagnostics diagnostics;
  check(scene, Limits{}, diagnostics);
  return diagnostics;
}

Diagnostics checked(const Change& change) {
  Scene scene = fine_scene();
  change(scene);
  return checked(scene);
}

const Diagnostic* find(const Diagnostics& diagnostics, const Code& code) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.code == &code) {
      return &diagnostic;
    }
  }
  return nullptr;
}

std::string listed(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    text += std::string(diagnostic.code->name) + ": " + diagnostic.message + "\n";
  }
  return text;
}

}  // namespace

TEST(Check, FineScenesHaveNoFindings) {
  EXPECT_EQ(listed(checked(fine_scene())), "");
  // These occur in valid files and are not mistakes.
  EXPECT_EQ(listed(checked(placed({scale(-1, 1, 1)}))), "");
  EXPECT_EQ(listed(checked(material([](Material& m) { m.diffuse = {2, 2, 2}; }))), "");
  EXPECT_EQ(listed(checked(lights(8))), "");
  EXPECT_EQ(listed(checked(camera([](Camera& c) { c.height_angle_deg = 179; }))), "");
}

TEST(Check, EveryCaseTriggersItsFindingAndASimilarOneDoesNot) {
  for (const Case& c : all_cases()) {
    SCOPED_TRACE(std::string(c.code->name) + " with " + c.word);
    const Diagnostics given = checked(c.gives);
    const Diagnostic* found = find(given, *c.code);
    ASSERT_NE(found, nullptr) << listed(given);
    EXPECT_EQ(found->severity, c.code->severity);
    EXPECT_THAT(found->message, HasSubstr(c.word));
    const Diagnostics missed = checked(c.near_miss);
    EXPECT_EQ(find(missed, *c.code), nullptr) << listed(missed);
  }
}

TEST(Check, EveryCodeHasACase) {
  std::set<const Code*> tested;
  for (const Case& c : all_cases()) {
    tested.insert(c.code);
  }
  for (const Code& code : scene_codes) {
    EXPECT_TRUE(tested.contains(&code)) << code.name;
  }
}

TEST(Check, FindingsAreAtThePlaceOfTheValue) {
  Scene scene = fine_scene();
  Primitive& p = scene.nodes[0].primitives[0];
  p.location = {7, 1};
  p.material.shininess = -1;
  p.material.blend = 2;
  scene.field_places = {{{9, 9}, Field::blend, {1, 1}}, {{7, 1}, Field::shininess, {9, 3}}};
  const Diagnostics found = checked(scene);
  EXPECT_EQ(find(found, "material.shininess-negative"_code)->location, (Location{9, 3}));
  EXPECT_EQ(find(found, "material.blend-range"_code)->location, (Location{7, 1}));
}

TEST(Check, NothingFollowsFromValuesThatCouldNotBeRead) {
  const auto global = [](Scene& s) -> FieldSet& { return s.global.unread; };
  const auto camera = [](Scene& s) -> FieldSet& { return s.camera->unread; };
  const auto light = [](Scene& s) -> FieldSet& { return s.nodes[0].lights[0].unread; };
  const auto object = [](Scene& s) -> FieldSet& { return s.nodes[0].primitives[0].unread; };
  const auto change = [&](const auto& edit) {
    Scene scene = fine_scene();
    scene.camera.emplace();
    edit(scene, scene.nodes[0].lights[0], scene.nodes[0].primitives[0].material);
    return scene;
  };
  struct Case {
    const Code* code;
    Scene scene;
    FieldSet& (*owner)(Scene& scene);
    Field unread;
  };
  const Case cases[] = {
      {&"global.negative"_code, change([](Scene& s, Light&, Material&) { s.global.diffuse = -1; }),
       global, Field::diffuse},
      {&"global.transparent-default"_code, change([](Scene&, Light&, Material& m) {
         m.transparent = {0.5f, 0.5f, 0.5f};
       }),
       global, Field::transparent},
      {&"camera.height-angle"_code,
       change([](Scene& s, Light&, Material&) { s.camera->height_angle_deg = 0; }), camera,
       Field::height_angle_deg},
      {&"camera.look-zero"_code, change([](Scene& s, Light&, Material&) {
         s.camera->look = {0, 0, 0};
       }),
       camera, Field::look},
      {&"camera.up-parallel-to-look"_code,
       change([](Scene& s, Light&, Material&) { s.camera->up = s.camera->look; }), camera,
       Field::look},
      {&"light.spot-without-angle"_code, change([](Scene&, Light& l, Material&) {
         l.type = LightType::spot;
         l.direction = {0, -1, 0};
       }),
       light, Field::angle_deg},
      {&"material.reflective-and-transparent"_code, change([](Scene& s, Light&, Material& m) {
         s.global.transparent = 1;
         s.global.specular = 1;
         m.reflective = m.transparent = {1, 1, 1};
       }),
       global, Field::specular},
      {&"material.specular-without-shininess"_code, change([](Scene&, Light&, Material& m) {
         m.specular = {1, 1, 1};
       }),
       object, Field::shininess},
      {&"material.blend-without-texture"_code,
       change([](Scene&, Light&, Material& m) { m.blend = 1; }), object, Field::blend},
  };
  for (const Case& c : cases) {
    EXPECT_NE(find(checked(c.scene), *c.code), nullptr) << c.code->name;
    Scene scene = c.scene;
    c.owner(scene).insert(c.unread);
    EXPECT_EQ(find(checked(scene), *c.code), nullptr) << c.code->name;
  }
}

TEST(Check, FindingsWithoutAPlaceNameTheNode) {
  Scene scene = fine_scene();
  const NodeId arm = add_primitive(scene, 0);
  scene.nodes[arm].name = "arm";
  scene.nodes[arm].primitives[0].material.ior = -1;
  EXPECT_THAT(listed(checked(scene)), HasSubstr("(in root/arm)"));
}

TEST(Check, OneFlatScaleIsOneFinding) {
  Scene scene = fine_scene();
  const NodeId flat = add_group(scene, 0, {scale(1, 0, 1)});
  add_primitive(scene, flat, {scale(2, 2, 2)});
  add_primitive(scene, flat);
  EXPECT_EQ(checked(scene).list().size(), 1u) << listed(checked(scene));
}

TEST(Check, LightsInTemplatesCountOncePerInstance) {
  Scene scene = bomb(40, 10, true);
  scene.nodes[scene.templates[0]].lights = {point_light()};
  EXPECT_NE(find(checked(scene), "light.count-limit"_code), nullptr);
}

TEST(Check, UnusedTemplatesAddNeitherLightsNorObjects) {
  Scene scene;
  const NodeId unused = add_template(scene, "t");
  add_primitive(scene, unused);
  scene.nodes[unused].lights.assign(20, Light{});
  scene.nodes[unused].primitives = {primitive()};
  scene.nodes[unused].primitives[0].material.transparent = {1, 1, 1};
  const Diagnostics found = checked(scene);
  EXPECT_NE(find(found, "scene.empty"_code), nullptr);
  EXPECT_EQ(find(found, "light.many"_code), nullptr);
  EXPECT_EQ(find(found, "global.transparent-default"_code), nullptr);
}

TEST(Check, BombsAreCounted) {
  EXPECT_EQ(checked(bomb(40, 10, true)).list().size(), 0u);
  EXPECT_EQ(checked(bomb(60, 2, false)).list().size(), 0u);
}

TEST(Check, WithoutErrorsNothingIsLostOnBrokenScenes) {
  Scene scene;
  scene.root = 5;
  scene.templates = {0, 0, 77};
  EXPECT_TRUE(checked(scene).has_errors());
  Scene self;
  self.nodes[0].children = {0};
  EXPECT_TRUE(checked(self).has_errors());
}

TEST(Check, ManyFindingsAreBounded) {
  Scene scene = fine_scene();
  for (int i = 0; i < 20'000; ++i) {
    add_instance(scene, 0, "nobody " + numbered(i));
    add_template(scene, "somebody " + numbered(i));
  }
  const Diagnostics found = checked(scene);
  EXPECT_EQ(found.count(Severity::error), 20'000u);
  EXPECT_LE(found.list().size(), 200u);
}
