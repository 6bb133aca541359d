#include "scenefile/edit/edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace scenefile {

namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Make = std::function<Result<Edit>(const Document&)>;

std::string after_edit(const std::string& text, const Make& make) {
  const Result<Document> document = Document::open(text, {});
  const Result<Edit> edit = document ? make(*document) : document.error();
  return edit ? applied(text, *edit) : "error: " + edit.error().text;
}

ItemId nth(const Document& document, ItemKind kind, int n = 0) {
  for (ItemId id = 0; id < document.items().size(); ++id) {
    if (document[id].kind == kind && n-- == 0) {
      return id;
    }
  }
  return 0;
}

Make setting(ItemKind kind, const std::string& name, std::size_t part, const std::string& value) {
  return [=](const Document& document) {
    const ItemId item = nth(document, kind);
    for (const FieldView& field : document.fields(item)) {
      if (field.name == name) {
        return set_value(document, item, field, part, value);
      }
    }
    return Result<Edit>(Error{"no such field"});
  };
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

const std::string scene_xml =
    "<scenefile>\r\n"
    "\t<lightdata>\r\n"
    "\t\t<id v='0'/> <type v=\"directional\"/>\r\n"
    "\t\t<color r=\"1\" g=\"1\" b=\"1\"/>\r\n"
    "\t\t<direction x=\"0\" y=\"-1\" z=\"0\"/>\r\n"
    "\t</lightdata>\r\n"
    "\t<object type=\"tree\" name=\"leg\">\r\n"
    "\t\t<transblock><object type=\"primitive\" name=\"cylinder\"/></transblock>\r\n"
    "\t</object>\r\n"
    "\t<object type=\"tree\" name=\"root\">\r\n"
    "\t\t<!-- left -->\r\n"
    "\t\t<transblock>\r\n"
    "\t\t\t<object type=\"master\" name=\"leg\"/>\r\n"
    "\t\t</transblock>\r\n"
    "\t\t<transblock>\r\n"
    "\t\t\t<translate x=\"1\" y=\"0\" z=\"0\"/>\r\n"
    "\t\t\t<object type=\"primitive\" name=\"cube\">\r\n"
    "\t\t\t\t<diffuse r=\"1\" g=\"0\" b=\"0\"/>\r\n"
    "\t\t\t</object>\r\n"
    "\t\t</transblock>\r\n"
    "\t</object>\r\n"
    "</scenefile>\r\n";

const std::string scene_json =
    "{\n"
    "  \"globalData\": {\"ambientCoeff\": 0.5, \"diffuseCoeff\": 0.5, \"specularCoeff\": 0.5},\n"
    "  \"cameraData\": {\"position\": [0, 0, 5], \"up\": [0, 1, 0], \"focus\": [0, 0, 0],\n"
    "                 \"heightAngle\": 45},\n"
    "  \"groups\": [\n"
    "    {\n"
    "      \"lights\": [\n"
    "        {\"type\": \"directional\", \"color\": [1, 1, 1], \"direction\": [0, -1, 0]}\n"
    "      ]\n"
    "    },\n"
    "    {\n"
    "      \"name\": \"ball\",\n"
    "      \"primitives\": [\n"
    "        {\"type\": \"sphere\", \"diffuse\": [1, 0, 0]}\n"
    "      ]\n"
    "    }\n"
    "  ]\n"
    "}\n";

TEST(Edits, AValueChangesNothingElse) {
  EXPECT_EQ(after_edit(scene_xml, setting(ItemKind::light, "direction", 1, "-0.50")),
            with(scene_xml, "y=\"-1\"", "y=\"-0.50\""));
  EXPECT_EQ(after_edit(scene_json, setting(ItemKind::camera, "heightAngle", 0, "60")),
            with(scene_json, "45", "60"));
  EXPECT_EQ(after_edit(scene_xml, setting(ItemKind::light, "color", 0, "red")),
            "error: Color r: \"red\" is not a number; write one like 1.5 or -2e3");
}

TEST(Edits, NewFieldsComeInTheOrderOfTheFormat) {
  EXPECT_EQ(after_edit(with(scene_xml, "name=\"cylinder\"", "name=\"mesh\" filename=\"a.obj\""),
                       [](const Document& document) {
                         const ItemId item = nth(document, ItemKind::primitive, 1);
                         for (const FieldView& field : document.fields(item)) {
                           if (field.name == "texture") {
                             return set_value(document, item, field, 0, "a&b.png");
                           }
                         }
                         return Result<Edit>(Error{"no such field"});
                       }),
            with(with(scene_xml, "name=\"cylinder\"", "name=\"mesh\" filename=\"a.obj\""),
                 "<diffuse r=\"1\" g=\"0\" b=\"0\"/>\r\n",
                 "<diffuse r=\"1\" g=\"0\" b=\"0\"/>\r\n\t\t\t\t<texture file=\"a&amp;b.png\"/>\r\n"
                 "\t\t\t\t<blend v=\"1\"/>\r\n"));
  EXPECT_EQ(after_edit(scene_json, setting(ItemKind::camera, "look", 2, "-2")),
            with(scene_json, "\"focus\": [0, 0, 0]", "\"look\": [-1, -1, -2]"));
}

TEST(Edits, ALightGetsTheFieldsOfItsType) {
  EXPECT_THAT(after_edit(scene_xml, setting(ItemKind::light, "type", 0, "point")),
              HasSubstr("<id v='0'/> <type v=\"point\"/>\r\n\t\t<color r=\"1\" g=\"1\" b=\"1\"/>"
                        "\r\n\t\t<position x=\"2\" y=\"5\" z=\"3\"/>\r\n\t</lightdata>"));
  EXPECT_THAT(
      after_edit(scene_json, setting(ItemKind::light, "type", 0, "point")),
      HasSubstr("{\"type\": \"point\", \"color\": [1, 1, 1], \"attenuationCoeff\": [1, 0, 0]}"));
  EXPECT_THAT(after_edit(scene_xml, setting(ItemKind::light, "type", 0, "sun")),
              HasSubstr("is not one of point, directional, spot, area"));
}

TEST(Edits, ARenamedTemplateKeepsItsInstances) {
  const std::string edited =
      after_edit(scene_xml, setting(ItemKind::master, "name", 0, "a \"leg\""));
  EXPECT_EQ(edited, with(with(scene_xml, "name=\"leg\"", "name=\"a &quot;leg&quot;\""),
                         "name=\"leg\"", "name=\"a &quot;leg&quot;\""));
}

TEST(Edits, NamesThatWouldChangeTheSceneAreRefused) {
  const std::string xml =
      "<scenefile><object type='tree' name='leg'><transblock/></object>"
      "<object type='tree' name='arm'><transblock/></object><object type='tree' name='root'>"
      "<transblock><object type='master' name='leg'/></transblock>"
      "<transblock><object type='tree' name='none'/></transblock></object></scenefile>";
  const std::string json =
      R"({"templateGroups": [{"name": "leg", "primitives": []}, {"name": "arm"}],
          "groups": [{"name": "none", "primitives": []}, {"name": "leg"}]})";
  const auto named = [](const std::string& text, ItemKind kind, const std::string& name) {
    return after_edit(text, setting(kind, "name", 0, name));
  };
  for (const std::string& text : {xml, json}) {
    EXPECT_EQ(named(text, ItemKind::master, ""), "error: a template needs a name");
    EXPECT_EQ(named(text, ItemKind::master, "arm"), "error: the name \"arm\" is taken");
    EXPECT_EQ(named(text, ItemKind::master, "none"), "error: the name \"none\" is taken");
    EXPECT_EQ(named(text, ItemKind::master, "leg"), text);
    EXPECT_EQ(named(text, ItemKind::group, "arm"), "error: the name \"arm\" is taken");
    EXPECT_EQ(named(text, ItemKind::group, "other"), with(text, "none", "other"));
  }
  EXPECT_EQ(named(xml, ItemKind::master, "root"),
            "error: the name \"root\" is reserved for the scene itself");
  EXPECT_EQ(named(json, ItemKind::master, "root"),
            with(with(json, "\"leg\"", "\"root\""), "\"leg\"", "\"root\""));
  // In XML, the names of groups with contents mean nothing.
  const std::string full = with(xml, " name='none'/>", " name='none'><transblock/></object>");
  EXPECT_EQ(named(full, ItemKind::group, "arm"), with(full, "none", "arm"));
}

TEST(Edits, InJsonAnObjectsOwnGroupIsRemovedWithIt) {
  const auto remove = [](const Document& document) {
    return remove_item(document, nth(document, ItemKind::primitive));
  };
  const std::string edited = after_edit(scene_json, remove);
  EXPECT_THAT(edited, Not(HasSubstr("ball")));
  EXPECT_THAT(edited, HasSubstr("directional"));
  const std::string two =
      with(scene_json, "{\"type\": \"sphere\"", "{\"type\": \"cube\"}, {\"type\": \"sphere\"");
  EXPECT_THAT(after_edit(two, remove), HasSubstr("ball")) << "the group has another object";
}

TEST(Edits, InJsonObjectsAreAddedBesideTheGroupOfAnother) {
  const auto add = [](const Document& document) {
    return add_item(document, nth(document, ItemKind::primitive), {ItemKind::primitive, "cone"});
  };
  const std::string tall = with(scene_json, "\"name\": \"ball\"", "\"scale\": [1, 9, 1]");
  const Result<Document> beside = Document::open(after_edit(tall, add), {});
  ASSERT_TRUE(beside);
  const ItemId cone = nth(*beside, ItemKind::primitive, 1);
  ASSERT_EQ((*beside)[cone].name, "cone");
  EXPECT_EQ(handle_of(*beside, cone)->world_from_item[1].y, 1) << "not as tall";
  const Result<Document> shared = Document::open(
      after_edit(with(tall, "{\"type\": \"sphere\"", "{\"type\": \"cube\"}, {\"type\": \"sphere\""),
                 add),
      {});
  ASSERT_TRUE(shared);
  EXPECT_EQ(handle_of(*shared, nth(*shared, ItemKind::primitive, 2))->world_from_item[1].y, 9)
      << "in the group of both";
}

TEST(Edits, AShapeBecomesAMeshWithItsFile) {
  const auto mesh = [](std::string name) {
    return [=](const Document& document) {
      const ItemId item = nth(document, ItemKind::primitive);
      const std::vector<FieldView> fields = document.fields(item);
      const auto shape = std::find_if(fields.begin(), fields.end(),
                                      [&](const FieldView& field) { return field.name == name; });
      const std::vector<std::optional<std::string>> typed{"mesh", "a&b.obj"};
      return set_values(document, item, *shape, typed);
    };
  };
  EXPECT_THAT(after_edit(scene_xml, mesh("name")),
              HasSubstr("type=\"primitive\" name=\"mesh\" filename=\"a&amp;b.obj\""));
  EXPECT_THAT(after_edit(scene_json, mesh("type")),
              HasSubstr("\"type\": \"mesh\", \"meshFile\": \"a&b.obj\""));
}

TEST(Edits, ATemplateInUseStays) {
  EXPECT_THAT(after_edit(scene_xml,
                         [](const Document& document) {
                           return remove_item(document, nth(document, ItemKind::master));
                         }),
              HasSubstr("it is used once"));
}

TEST(Edits, AddedObjectsFollowTheLayout) {
  const auto add = [](const NewItem& what) {
    return [=](const Document& document) {
      return add_item(document, nth(document, ItemKind::root), what);
    };
  };
  EXPECT_EQ(after_edit(scene_xml, add({ItemKind::primitive, "cone"})),
            with(scene_xml, "\t</object>\r\n</scenefile>",
                 "\t\t<transblock>\r\n\t\t\t<translate x=\"-1.2\" y=\"0\" z=\"0\"/>\r\n"
                 "\t\t\t<object type=\"primitive\" name=\"cone\">\r\n"
                 "\t\t\t\t<ambient r=\"0.2\" g=\"0.2\" b=\"0.2\"/>\r\n"
                 "\t\t\t\t<diffuse r=\"1\" g=\"1\" b=\"1\"/>\r\n\t\t\t</object>\r\n"
                 "\t\t</transblock>\r\n\t</object>\r\n</scenefile>"));
  EXPECT_THAT(after_edit(scene_xml, add({ItemKind::primitive, "mesh", "a&b.obj"})),
              HasSubstr("name=\"mesh\" filename=\"a&amp;b.obj\""));
  EXPECT_THAT(after_edit(scene_json,
                         [](const Document& document) {
                           return add_item(document, {}, {ItemKind::primitive, "mesh", "a.obj"});
                         }),
              HasSubstr("\"type\": \"mesh\",\n          \"meshFile\": \"a.obj\""));
  EXPECT_EQ(after_edit("<scenefile/>", add({ItemKind::camera})),
            "<scenefile><cameradata><pos x=\"5\" y=\"5\" z=\"5\"/><look x=\"-1\" y=\"-1\" "
            "z=\"-1\"/><up x=\"0\" y=\"1\" z=\"0\"/><heightangle v=\"45\"/></cameradata>"
            "</scenefile>");
  EXPECT_THAT(after_edit(scene_xml, add({ItemKind::instance, "arm"})), HasSubstr("not declared"));
  EXPECT_THAT(after_edit(scene_xml, add({ItemKind::light, "spot"})),
              HasSubstr("\t<lightdata>\r\n\t\t<type v=\"spot\"/>\r\n\t\t<id v=\"1\"/>"));
}

// A scene with these transblocks, seen from z = 8.
std::string seen_from_the_front(const std::string& blocks) {
  return "<scenefile><cameradata><pos x=\"0\" y=\"1\" z=\"8\"/><focus x=\"0\" y=\"0\" z=\"0\"/>"
         "<up x=\"0\" y=\"1\" z=\"0\"/><heightangle v=\"45\"/></cameradata>"
         "<object type=\"tree\" name=\"root\">" +
         blocks + "</object></scenefile>";
}
constexpr std::string_view cube_block =
    R"(<transblock><object type="primitive" name="cube"/></transblock>)";

TEST(Edits, NewObjectsDoNotOverlapOthers) {
  std::string text = seen_from_the_front(std::string(cube_block));
  for (int i = 0; i < 12; ++i) {
    text = after_edit(text, [&](const Document& document) {
      const auto items = static_cast<ItemId>(document.items().size());
      return add_item(document, i % 2 == 0 ? std::nullopt : std::optional(items - 1),
                      {ItemKind::primitive, i % 3 == 0 ? "sphere" : "cube"});
    });
  }
  const Result<Document> document = Document::open(text, {});
  ASSERT_TRUE(document) << text;
  std::vector<glm::dvec3> places;
  for (ItemId id = 0; id < document->items().size(); ++id) {
    if ((*document)[id].kind == ItemKind::primitive) {
      places.emplace_back(handle_of(*document, id)->world_from_item[3]);
    }
  }
  ASSERT_EQ(places.size(), 13U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_LT(glm::length(places[i]), 5) << "in view";
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec3 apart = glm::abs(places[i] - places[j]);
      EXPECT_GE(std::max({apart.x, apart.y, apart.z}), 1 - 1e-3) << i << " " << j << text;
    }
  }
}

TEST(Edits, NewObjectsStandWhereTheyAreSeen) {
  const auto add = [](const std::string& blocks, const NewItem& what,
                      const std::optional<Viewpoint>& view = {}) {
    return after_edit(seen_from_the_front(blocks), [&](const Document& document) {
      const ItemId group = nth(document, ItemKind::group);
      return add_item(document, group == 0 ? nth(document, ItemKind::root) : group, what, view);
    });
  };
  const NewItem cone{ItemKind::primitive, "cone"};
  EXPECT_THAT(add("", cone, Viewpoint{{0, 0, 8}, {0, 0, 7.5}}),
              HasSubstr(R"(<translate x="0" y="0" z="4"/>)"))
      << "not too near";
  const Result<Document> empty = Document::open("<scenefile></scenefile>", {});
  const Result<Edit> first = add_item(*empty, {}, cone);
  ASSERT_TRUE(first);
  EXPECT_EQ(applied(empty->text(), *first).substr(*first->select, 11), "<transblock");
  EXPECT_THAT(add("", cone), Not(HasSubstr("translate")));
  EXPECT_THAT(add(std::string(cube_block), cone), HasSubstr(R"(<translate x="1.2" y="0" z="0"/>)"));
  EXPECT_THAT(add("", cone, Viewpoint{{20, 0, 8}, {20.1, 0, 0}}),
              HasSubstr(R"(<translate x="20" y="0" z="0"/>)"));
  // From behind, right is -x.
  EXPECT_THAT(add(std::string(cube_block), cone, Viewpoint{{0, 0, -8}, {0, 0, 0}}),
              HasSubstr(R"(<translate x="-1.2" y="0" z="0"/>)"));
  const auto scaled = [](const std::string& translation, const std::string& size) {
    return "<transblock><translate " + translation + "/><scale " + size +
           R"(/><object type="primitive" name="cube"/></transblock>)";
  };
  EXPECT_THAT(add(scaled(R"(x="0" y="-0.1" z="0")", R"(x="9" y="0.2" z="9")"), cone),
              HasSubstr(R"(<translate x="0" y="0.5" z="0"/>)"))
      << "on the ground";
  EXPECT_THAT(add(scaled(R"(x="0" y="-0.1" z="0")", R"(x="9" y="0.2" z="9")") +
                      scaled(R"(x="0" y="2" z="0")", R"(x="0.4" y="4" z="0.4")"),
                  cone),
              HasSubstr(R"(<translate x="0.9" y="0.5" z="0"/>)"))
      << "on the ground, beside what stands there";
  EXPECT_THAT(add(scaled(R"(x="0" y="0" z="0")", R"(x="99" y="99" z="99")"), cone),
              HasSubstr(R"(name="cube"/></transblock><transblock><object)"))
      << "the camera is in this room, too";
  EXPECT_THAT(add(scaled(R"(x="1e308" y="1e308" z="-1e308")", R"(x="1e300" y="1e300" z="1e300")"),
                  cone, Viewpoint{{0, 0, 0}, {1e300, 1e308, 0}}),
              Not(HasSubstr("nan")));
  EXPECT_THAT(add(R"(<transblock><scale x="4" y="4" z="4"/><translate x="0" y="1.5e38" z="0"/>)"
                  R"(<scale x="3e38" y="3e38" z="3e38"/><object type="primitive" name="cube"/>)"
                  "</transblock>",
                  cone, Viewpoint{{0, -1, 8}, {0, 0, 0}}),
              Not(HasSubstr("inf")))
      << "what a float cannot hold";
  EXPECT_THAT(add(R"(<transblock><scale x="0.0001" y="0.0001" z="0.0001"/><object type="tree"/>)"
                  "</transblock>" +
                      scaled(R"(x="0" y="0" z="0")", R"(x="19.99998" y="40" z="19.99998")"),
                  cone, Viewpoint{{0, 0, 50}, {0, 0, 0}}),
              HasSubstr(R"(<translate x="100000.61" y="0" z="0"/>)"))
      << "a gap that is lost when the distance is rounded";
  // In a group, by its units; the center of what it sees is at the edge of the group's cube.
  EXPECT_THAT(add(R"(<transblock><translate x="1" y="0" z="0"/><scale x="2" y="2" z="2"/>)"
                  R"(<object type="tree">)" +
                      std::string(cube_block) + "</object></transblock>",
                  cone),
              HasSubstr(R"(<translate x="-1.2" y="0" z="0"/>)"));
  const std::string lights = add("", {ItemKind::light, "point"});
  EXPECT_THAT(lights, HasSubstr(R"(<position x="2" y="5" z="3"/>)"));
  EXPECT_THAT(after_edit(lights,
                         [](const Document& document) {
                           return add_item(document, {}, {ItemKind::light, "point"});
                         }),
              HasSubstr(R"(<position x="2.6" y="5" z="3"/>)"));
}

TEST(Edits, TheCameraIsNotInATemplate) {
  const std::string text = with(seen_from_the_front(""), R"(<object type="tree" name="root">)",
                                R"(<object type="tree" name="box">)" + std::string(cube_block) +
                                    R"(</object><object type="tree" name="root">)");
  EXPECT_THAT(after_edit(text,
                         [](const Document& document) {
                           return add_item(document, nth(document, ItemKind::master),
                                           {ItemKind::primitive, "cone"},
                                           Viewpoint{{0, 0, 0.2}, {0, 0, 0}});
                         }),
              HasSubstr(R"(<translate x="1.2" y="0" z="0"/>)"));
}

TEST(Edits, CopiesStandBesideTheirOriginals) {
  const auto copy = [](ItemKind kind) {
    return [=](const Document& document) { return duplicate_item(document, nth(document, kind)); };
  };
  const std::string ground =
      R"(<transblock><translate x="0" y="-1" z="0"/><scale x="9" y="1.2" z="9"/>)"
      R"(<object type="primitive" name="sphere"/></transblock>)";
  EXPECT_THAT(
      after_edit(seen_from_the_front(std::string(cube_block) + ground), copy(ItemKind::primitive)),
      HasSubstr(std::string(cube_block) + R"(<transblock><translate x="1.2" y="0" z="0"/>)"))
      << "that it is in the ground does not matter";
  EXPECT_THAT(after_edit(seen_from_the_front(ground), copy(ItemKind::primitive)),
              HasSubstr(R"(<translate x="11" y="-1" z="0"/><scale x="9" y="1.2" z="9"/>)"));
  const std::string leg = after_edit(scene_xml, copy(ItemKind::master));
  EXPECT_THAT(leg, HasSubstr("name=\"leg-2\""));
  EXPECT_THAT(leg, Not(HasSubstr("translate x=\"1.2\""))) << "templates are drawn nowhere";
  // In JSON, the group is the place of its only object; of several, the copy gets one.
  EXPECT_THAT(after_edit(scene_json, copy(ItemKind::primitive)),
              HasSubstr("      \"name\": \"ball\",\n      \"translate\": [1.2, 0, 0],\n"));
  const std::string two =
      with(scene_json, "{\"type\": \"sphere\"", "{\"type\": \"cube\"}, {\"type\": \"sphere\"");
  const Result<Document> document = Document::open(two, {});
  const Result<Edit> edit = duplicate_item(*document, nth(*document, ItemKind::primitive));
  ASSERT_TRUE(edit);
  const std::string edited = applied(two, *edit);
  EXPECT_THAT(edited, HasSubstr("\"groups\": [{\"translate\": [1.2, 0, 0], \"primitives\": "
                                "[{\"type\": \"cube\"}]}]"));
  EXPECT_EQ(edited.substr(*edit->select, 15), "{\"type\": \"cube\"");
  const std::string odd = with(scene_json, "\"ball\"", "\"{ball\"");
  const Result<Document> named = Document::open(odd, {});
  const Result<Edit> copied = duplicate_item(*named, nth(*named, ItemKind::primitive));
  ASSERT_TRUE(copied);
  EXPECT_THAT(applied(odd, *copied).substr(*copied->select), StartsWith("{\"type\": \"sphere\""));
}

TEST(Edits, MeshesHaveTheirOwnSize) {
  const std::string text = seen_from_the_front(
      R"(<transblock><object type="primitive" name="mesh" filename="bar.obj"/></transblock>)");
  Viewpoint view{{0, 1, 8}, {0, 0, 0}};
  const auto add = [&](const NewItem& what) {
    return after_edit(text, [&](const Document& document) {
      return add_item(document, nth(document, ItemKind::root), what, view);
    });
  };
  const auto copy = [&](const Document& document) {
    return duplicate_item(document, nth(document, ItemKind::primitive), view);
  };
  EXPECT_THAT(after_edit(text, copy), HasSubstr(R"(<translate x="1.2" y="0" z="0"/>)"));
  view.meshes["bar.obj"] = {{{-1, 0, -0.1}, {3, 1, 0.1}}};
  EXPECT_THAT(after_edit(text, copy), HasSubstr(R"(<translate x="4.8" y="0" z="0"/>)"));
  const NewItem cube{ItemKind::primitive, "cube"};
  EXPECT_THAT(add(cube), HasSubstr(R"(<translate x="0" y="0" z="-0.8"/>)")) << "behind the bar";
  EXPECT_THAT(add({ItemKind::primitive, "mesh", "bar.obj"}),
              HasSubstr(R"(<translate x="0" y="0" z="-8"/>)"))
      << "all of it is in view";
}

TEST(Edits, AnObjectEntersAndLeavesAGroup) {
  const std::string legs = R"(<transblock><translate x="0" y="1" z="0"/><object type="tree">)" +
                           std::string(cube_block) + "</object></transblock>";
  const auto into = [](bool enters) {
    return [=](const Document& document) -> Result<Edit> {
      const ItemId first = nth(document, ItemKind::primitive);
      const ItemId item = document[first].name == "cone" ? first : first + 1;
      const auto group = enters ? group_to_enter(document, item) : group_outside(document, item);
      return group ? move_into(document, item, *group) : Result<Edit>(Error{"none"});
    };
  };
  const std::string cone =
      R"(<transblock><translate x="2" y="0" z="0"/><object type="primitive" name="cone"/></transblock>)";
  const std::string text = seen_from_the_front(legs + cone);
  const std::string inside = after_edit(text, into(true));
  EXPECT_THAT(inside,
              HasSubstr(std::string(cube_block) +
                        R"(<transblock><translate x="2" y="-1" z="0"/><object type="prim)"));
  EXPECT_EQ(after_edit(inside, into(true)), "error: none");
  EXPECT_EQ(after_edit(inside, into(false)), text);
  EXPECT_EQ(after_edit(text, into(false)), "error: none");
  const std::string part = with(with(text, "name=\"root\"", "name=\"part\""), "</scenefile>",
                                R"(<object type="tree" name="root"/></scenefile>)");
  EXPECT_THAT(after_edit(part, into(true)), HasSubstr(R"(<translate x="2" y="-1" z="0"/>)"));
  EXPECT_EQ(after_edit(after_edit(part, into(true)), into(false)), part) << "within a template";
  // In JSON, the group of a single object is its place: it is none to enter, and goes along.
  const std::string json =
      with(scene_json, "      \"name\": \"ball\",", R"(      "groups": [{}],)");
  const auto enter_json = [](const Document& document) -> Result<Edit> {
    const ItemId item = nth(document, ItemKind::light);
    const std::optional<ItemId> group = group_to_enter(document, item);
    return group ? move_into(document, item, *group) : Result<Edit>(Error{"none"});
  };
  EXPECT_EQ(after_edit(scene_json, enter_json), "error: none");
  EXPECT_THAT(after_edit(json, enter_json), HasSubstr("\"groups\": [{}, {"));
  const std::string two =
      with(scene_json, "{\"type\": \"sphere\"", "{\"type\": \"cube\"}, {\"type\": \"sphere\"");
  EXPECT_EQ(after_edit(two, into(false)),
            "error: it shares its group with others; put it into a new group first");
  const std::string nested =
      with(json, "{\"type\": \"sphere\"", "{\"type\": \"cube\"}, {\"type\": \"sphere\"");
  EXPECT_EQ(after_edit(nested, into(true)), "error: none");
  const Result<Document> instances = Document::open(
      R"({"templateGroups": [{"name": "leg", "primitives": [{"type": "cube"}]}], "groups": [
          {"translate": [1, 0, 0], "groups": [{"name": "leg"}, {"name": "leg"}, {"groups": []}]}]})",
      {});
  ASSERT_TRUE(instances);
  EXPECT_TRUE(targets_for(*instances, nth(*instances, ItemKind::instance)).empty());
}

// As courses read a transblock with several objects.
TEST(Edits, AnObjectEntersOneOfTwoGroupsOfATransblock) {
  const std::string text = R"(<scenefile>
<object type="tree" name="leg"><transblock><object type="primitive" name="cube"/></transblock></object>
<object type="tree" name="root">
<transblock><translate x="2" y="0" z="0"/><object type="tree" name="leg"/><object type="tree" name="more"/></transblock>
<transblock><object type="primitive" name="cone"/></transblock>
</object></scenefile>)";
  ReadOptions options;
  options.compat_course = true;
  const Result<Document> document = Document::open(text, options);
  ASSERT_TRUE(document);
  EXPECT_EQ((*document)[nth(*document, ItemKind::instance)].name, "leg");
  const ItemId group = nth(*document, ItemKind::group);
  EXPECT_EQ((*document)[group].name, "more");
  const Result<Edit> edit = move_into(*document, nth(*document, ItemKind::primitive, 1), group);
  ASSERT_TRUE(edit);
  EXPECT_THAT(applied(text, *edit), HasSubstr(R"(<translate x="-2" y="0" z="0"/>)"));
}

TEST(Edits, ItemsMoveWithTheirComments) {
  const std::string edited = after_edit(scene_xml, [](const Document& document) {
    return reorder_item(document, nth(document, ItemKind::instance), 1);
  });
  EXPECT_THAT(edited, HasSubstr("</transblock>\r\n\t\t<!-- left -->\r\n\t\t<transblock>"));
  EXPECT_EQ(after_edit(edited,
                       [](const Document& document) {
                         return reorder_item(document, nth(document, ItemKind::instance), -1);
                       }),
            scene_xml);
}

TEST(Edits, AGroupCannotBeMovedIntoItself) {
  const std::string text = with(scene_json, "\"primitives\"", "\"groups\": [{}], \"primitives\"");
  EXPECT_THAT(after_edit(text,
                         [](const Document& document) {
                           const ItemId outer = nth(document, ItemKind::group, 1);
                           return move_into(document, outer, nth(document, ItemKind::group, 2));
                         }),
              HasSubstr("choose a group"));
}

TEST(Edits, NoNumberIsWrittenThatAFloatCannotHold) {
  const std::string text = R"(<scenefile><object type="tree" name="root">
<transblock><scale x="1e-20" y="1e-20" z="1e-20"/><object type="tree"/></transblock>
<transblock><scale x="1e20" y="1e20" z="1e20"/><object type="primitive" name="cube"/></transblock>
</object></scenefile>)";
  const std::string moved = after_edit(text, [](const Document& document) {
    return move_into(document, nth(document, ItemKind::primitive), nth(document, ItemKind::group));
  });
  EXPECT_THAT(moved, HasSubstr(R"(<scale x="1e20" y="1e20" z="1e20"/>)"));
  EXPECT_THAT(moved, Not(HasSubstr("inf")));
}

TEST(Edits, WrappingKeepsTheInside) {
  EXPECT_EQ(after_edit(scene_xml,
                       [](const Document& document) {
                         return wrap_in_group(document, nth(document, ItemKind::instance));
                       }),
            with(scene_xml,
                 "\t\t<transblock>\r\n\t\t\t<object type=\"master\" name=\"leg\"/>\r\n"
                 "\t\t</transblock>\r\n",
                 "\t\t<transblock>\r\n\t\t\t<object type=\"tree\">\r\n\t\t\t\t<transblock>\r\n"
                 "\t\t\t\t\t<object type=\"master\" name=\"leg\"/>\r\n\t\t\t\t</transblock>\r\n"
                 "\t\t\t</object>\r\n\t\t</transblock>\r\n"));
}

TEST(Edits, MovingChangesOnlyTheAxis) {
  const auto move = [](const Document& document) {
    const auto handle = handle_of(document, nth(document, ItemKind::primitive, 1));
    return handle ? move_item(document, *handle, {0.5, 0, 0}) : Result<Edit>(Error{"no handle"});
  };
  EXPECT_EQ(after_edit(scene_xml, move),
            with(scene_xml, "x=\"1\" y=\"0\" z=\"0\"/>\r\n\t\t\t<object",
                 "x=\"1.5\" y=\"0\" z=\"0\"/>\r\n\t\t\t<object"));
  EXPECT_EQ(after_edit(scene_json,
                       [](const Document& document) {
                         const auto handle =
                             handle_of(document, nth(document, ItemKind::primitive));
                         return move_item(document, *handle, {0, 2, 0});
                       }),
            with(scene_json, "\"name\": \"ball\",\n",
                 "\"name\": \"ball\",\n      \"translate\": [0, 2, 0],\n"));
}

// A number that cannot be read is not taken for the 0 that it gives.
TEST(Edits, PlacingReplacesNumbersThatCannotBeRead) {
  const std::string text = R"(<scenefile><object type="tree" name="root"><transblock>
<matrix><row a="1" b="0" c="0" d="0"/><row a="0" b="1" c="0" d="0"/><row a="0" b="0" c="1" d="0"/><row a="0" b="e9" c="0" d="1"/></matrix>
<object type="primitive" name="cube"/></transblock></object></scenefile>)";
  EXPECT_EQ(after_edit(text,
                       [](const Document& document) {
                         const auto handle =
                             handle_of(document, nth(document, ItemKind::primitive));
                         return place_item(document, *handle, glm::dmat4(1));
                       }),
            with(text, "e9", "0"));
}

// The reader takes no value of such a matrix.
TEST(Edits, AMatrixWithARowThatCannotBeReadIsWrittenAnew) {
  const std::string text = R"(<scenefile><object type="tree" name="root"><transblock>
<matrix><pos x="1" y="2" z="3"/><row a="0" b="1" c="0" d="0"/><!-- z --><row a="0" b="0" c="1" d="0"/><row a="0" b="0" c="0" d="1"/></matrix>
<object type="primitive" name="cube"/></transblock></object></scenefile>)";
  const std::string edited = after_edit(text, setting(ItemKind::primitive, "matrix", 3, "5"));
  EXPECT_THAT(edited, HasSubstr(R"(<row a="1" b="0" c="0" d="5"/>)"));
  EXPECT_THAT(edited, HasSubstr("<!-- z -->"));
  EXPECT_THAT(edited, Not(HasSubstr("<pos")));
}

TEST(Edits, ALightWithoutValuesGetsATypeWithWhatItNeeds) {
  EXPECT_THAT(after_edit("<scenefile><lightdata/></scenefile>",
                         setting(ItemKind::light, "type", 0, "area")),
              ::testing::ContainsRegex("<type v=\"area\"/>.*<width v=.*</lightdata>"));
}

TEST(Edits, NothingMovesAnObjectOfATemplate) {
  const Result<Document> document = Document::open(scene_xml, {});
  EXPECT_FALSE(handle_of(*document, nth(*document, ItemKind::primitive)));
}

}  // namespace

}  // namespace scenefile
