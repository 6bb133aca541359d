// Each finding says the exact line and column.

#include "format/reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

TEST(XmlPlaces, OfAnElement) {
  EXPECT_THAT(found(with_transforms("  <frob/>")), ElementsAre("4:3 warning xml.unknown-element"));
}

TEST(XmlPlaces, OfEachAttribute) {
  EXPECT_THAT(found(with_transforms("<translate x=\"a\" y=\"0\" z = 'b'/>")),
              ElementsAre("4:12 error xml.number", "4:24 error xml.number"));
}

TEST(XmlPlaces, OfAttributesOnSeparateLines) {
  EXPECT_THAT(found(with_transforms("<translate\n  x=\"0\"\n\n\ty=\"q\"\n  z=\"\"\n/>")),
              ElementsAre("7:2 error xml.number", "8:3 warning xml.empty-number"));
}

TEST(XmlPlaces, CountCharactersNotBytes) {
  EXPECT_THAT(found(with_transforms(
                  "<!-- \u00e9\u20ac\U0001F600 --><translate x=\"1\" y=\"\u00bd\" z=\"x\"/>")),
              ElementsAre("4:30 error xml.number", "4:36 error xml.number"));
}

TEST(XmlPlaces, CountTabsAsOneCharacter) {
  EXPECT_THAT(found(with_transforms("\t\t<frob/>")),
              ElementsAre("4:3 warning xml.unknown-element"));
}

TEST(XmlPlaces, IgnoreTheByteOrderMark) {
  EXPECT_THAT(
      found(
          "\xEF\xBB\xBF<scenefile version=\"2\"><object type=\"tree\" name=\"root\"/></scenefile>"),
      ElementsAre("1:12 warning xml.unknown-attribute"));
}

TEST(XmlPlaces, AreTheSameWithAllLineEndings) {
  const std::string unix_text =
      with_transforms("<!-- \n -->\n<translate\nx=\"a\" y=\"0\" z=\"0\"/>\n<frob/>");
  std::string dos;
  std::string mac;
  for (const char c : unix_text) {
    dos += c == '\n' ? "\r\n" : std::string(1, c);
    mac += c == '\n' ? '\r' : c;
  }
  const std::vector<std::string> expected = found(unix_text);
  EXPECT_THAT(expected, ElementsAre("7:1 error xml.number", "8:1 warning xml.unknown-element"));
  EXPECT_EQ(found(dos), expected);
  EXPECT_EQ(found(mac), expected);
}

TEST(XmlPlaces, AreTheSameInAllEncodings) {
  const std::string text =
      with_transforms("<!-- \u00e9 --><translate x=\"\u00e9\" y=\"0\" z=\"0\"/>");
  const std::string declaration = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>";
  std::string latin = declaration;
  std::string utf16 = "\xFE\xFF";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool accent = static_cast<unsigned char>(text[i]) == 0xC3;
    const char c = accent ? static_cast<char>(0xE9) : text[i];
    i += accent;
    latin += c;
    utf16 += '\0';
    utf16 += c;
  }
  EXPECT_THAT(found(text), ElementsAre("4:22 error xml.number"));
  EXPECT_EQ(found(utf16), found(text));
  EXPECT_EQ(found(latin), found(text));
}

TEST(XmlPlaces, AreTheSameInOneLongLine) {
  std::string blocks;
  for (int i = 0; i < 3000; ++i) {
    blocks += "<transblock><object type=\"primitive\" name=\"cube\"/></transblock>";
  }
  const std::string text =
      "<scenefile><object type=\"tree\" name=\"root\">" + blocks + "<frob/></object></scenefile>";
  const std::size_t column = text.find("<frob") + 1;
  EXPECT_THAT(found(text), ElementsAre(fmt::format("1:{} warning xml.unknown-element", column)));
}

TEST(XmlPlaces, OfText) {
  EXPECT_THAT(found(in_root("   stray")), ElementsAre("3:4 warning xml.text"));
}

TEST(XmlPlaces, OfValuesAreKeptForLaterChecks) {
  const Scene scene =
      read(with_top("<lightdata>\n  <id v=\"0\"/>\n  <position x=\"1\" y=\"2\" z=\"3\"/>\n"
                    "  <color r=\"-1\" g=\"0\" b=\"0\"/>\n</lightdata>"))
          .scene;
  ASSERT_EQ(scene.nodes[scene.root].lights.size(), 1u);
  const Location owner = scene.nodes[scene.root].lights[0].location;
  EXPECT_EQ(owner, (Location{2, 1}));
  bool color_found = false;
  for (const FieldPlace& place : scene.field_places) {
    if (place.owner == owner && place.field == Field::color) {
      color_found = true;
      EXPECT_EQ(place.location, (Location{5, 3}));
    }
  }
  EXPECT_TRUE(color_found);
}

TEST(XmlPlaces, OfUnusualColorsAreKept) {
  const Scene scene =
      read(with_material("<diffuse r=\"1\" g=\"1\" b=\"1\"/><ambient r=\"255\" g=\"0\" b=\"0\"/>"))
          .scene;
  ASSERT_EQ(scene.field_places.size(), 1u);
  EXPECT_EQ(scene.field_places[0].field, Field::ambient);
  EXPECT_EQ(scene.field_places[0].owner, (Location{4, 1}));
  EXPECT_EQ(scene.field_places[0].location, (Location{5, 29}));
}

TEST(XmlPlaces, ValuesThatCouldNotBeReadAreListed) {
  const auto material = [](std::string_view inside) {
    return read(with_material(inside)).scene.nodes[1].primitives.at(0);
  };
  const Primitive primitive = material("<shininess v=\"x\"/><reflective r=\"1\" g=\"q\" b=\"0\"/>");
  EXPECT_EQ(primitive.unread, (FieldSet{Field::shininess, Field::reflective}));
  EXPECT_EQ(primitive.material, Material{});
  EXPECT_EQ(material("<shininess v=\"3\"/>").unread, FieldSet{});
}

TEST(XmlPlaces, TheLastOfTwoValuesDecidesWhetherItCouldBeRead) {
  const auto material = [](std::string_view inside) {
    return read(with_material(inside)).scene.nodes[1].primitives.at(0);
  };
  const Primitive last_good = material("<shininess v=\"x\"/><shininess v=\"3\"/>");
  EXPECT_EQ(last_good.unread, FieldSet{});
  EXPECT_EQ(last_good.material.shininess, 3);
  const Primitive last_bad = material("<shininess v=\"3\"/><shininess v=\"x\"/>");
  EXPECT_EQ(last_bad.unread, FieldSet{Field::shininess});
  EXPECT_EQ(last_bad.material.shininess, 0);
}

TEST(XmlPlaces, ASecondBlockOfGlobalsDoesNotMakeALostValueKnown) {
  const Scene scene = read(with_top("<globaldata><specularcoeff v=\"x\"/></globaldata>\n"
                                    "<globaldata><diffusecoeff v=\"1\"/></globaldata>"))
                          .scene;
  EXPECT_EQ(scene.global.unread, FieldSet{Field::specular});
}

TEST(XmlPlaces, ALookThatFollowsFromALostValueIsUnread) {
  const auto unread = [](const std::string& inside) {
    return read(with_top("<cameradata>" + inside +
                         "<up x=\"0\" y=\"1\" z=\"0\"/><heightangle v=\"45\"/></cameradata>"))
        .scene.camera->unread;
  };
  const std::string good = "<pos x=\"1\" y=\"2\" z=\"3\"/>";
  for (const std::string& inside :
       {good + "<focus x=\"q\" y=\"0\" z=\"0\"/>", good + "<focus x=\"1\" y=\"2\" z=\"3\"/>",
        good + "<look x=\"0\" y=\"0\" z=\"1\"/><focus x=\"0\" y=\"0\" z=\"0\"/>"}) {
    EXPECT_EQ(unread(inside), FieldSet{Field::look}) << inside;
  }
  EXPECT_EQ(unread("<pos x=\"q\" y=\"0\" z=\"0\"/><focus x=\"1\" y=\"0\" z=\"0\"/>"),
            (FieldSet{Field::position, Field::look}));
  EXPECT_EQ(unread(good + "<focus x=\"0\" y=\"0\" z=\"0\"/>"), FieldSet{});
}

TEST(XmlPlaces, OfNodesAndTheirParts) {
  const Scene scene = read(with_transforms("  <scale x=\"1\" y=\"1\" z=\"1\"/>")).scene;
  ASSERT_EQ(scene.nodes.size(), 2u);
  EXPECT_EQ(scene.nodes[0].location, (Location{2, 1}));
  EXPECT_EQ(scene.nodes[1].location, (Location{3, 1}));
  EXPECT_EQ(scene.nodes[1].transforms.at(0).location, (Location{4, 3}));
  EXPECT_EQ(scene.nodes[1].primitives.at(0).location, (Location{5, 1}));
}

}  // namespace
}  // namespace scenefile::testing
