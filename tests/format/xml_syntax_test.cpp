// Texts that are not well-formed, too large, or unsafe.

#include "format/reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> said(std::string_view text) {
  return messages(read(text).diagnostics);
}

TEST(XmlSyntax, CrossedTagsNameBoth) {
  EXPECT_THAT(said("<scenefile>\n<object type=\"tree\" name=\"root\">\n</scenefile>"),
              ElementsAre("3:1 </scenefile> cannot close <object>, opened at line 2; </object> is "
                          "missing before it"));
  EXPECT_THAT(
      said(with_transforms("<scale x=\"1\" y=\"1\" z=\"1\">1 2 3")).back(),
      HasSubstr("</scale> is missing before it, or a / in front of the > that ends its tag"));
}

TEST(XmlSyntax, ASurplusClosingTagIsBlamed) {
  EXPECT_THAT(said("<scenefile>\n<object type=\"tree\" name=\"root\">\n</object>\n</object>"),
              Contains("4:1 </object> has no opening tag <object>"));
  EXPECT_THAT(said("<scenefile>\n<object type=\"tree\" name=\"root\">\n</scenfile>"),
              Contains(HasSubstr("3:1 </scenfile> cannot close <object>")));
}

TEST(XmlSyntax, ValuesThatAreNotClosedAreNamed) {
  const std::string not_closed =
      "4:1 <scale> is not closed before </transblock>; a tag without contents ends with />";
  const std::string scale = "<scale x=\"1\" y=\"1\" z=\"1\">";
  EXPECT_EQ(said(with_transforms(scale)).back(), not_closed);
  EXPECT_EQ(said(with_transforms(scale + "<scale x=\"1\">\n<scale/>")).back(), not_closed);
  EXPECT_THAT(said(with_transforms(scale + "</scael>")).back(), HasSubstr("did you mean </scale>"));
}

TEST(XmlSyntax, MisspelledClosingTagsAreSuggested) {
  for (const std::string closing : {"tranblock", "transblok"}) {
    EXPECT_THAT(said(in_root("<transblock>\n</" + closing + ">")),
                ElementsAre("4:1 </" + closing +
                            "> cannot close <transblock>, opened at line 3; did you mean "
                            "</transblock>?"));
  }
}

TEST(XmlSyntax, MisspelledOpeningTagsAreSuggested) {
  EXPECT_EQ(said(in_root("<transblock>\n<objct type=\"primitive\" name=\"cube\">\n</object>\n"
                         "</transblock>"))
                .back(),
            "4:1 <objct> is closed by </object> of line 5; did you mean <object>?");
}

TEST(XmlSyntax, AFileThatEndsInAnElement) {
  EXPECT_THAT(said("<scenefile>\n<object type=\"tree\" name=\"root\">\n"),
              ElementsAre(HasSubstr("the file ends inside <object>, opened at line 2")));
}

TEST(XmlSyntax, AFileThatEndsInATag) {
  EXPECT_THAT(said("<scenefile>\n<object type=\"tr"),
              ElementsAre("2:1 the file ends inside a tag inside <scenefile>, opened at line 1"));
  EXPECT_THAT(said("<scenefi"), ElementsAre("1:1 the file ends inside a tag"));
}

TEST(XmlSyntax, AFileThatEndsInAComment) {
  EXPECT_THAT(said("<scenefile>\n <!-- and so on"),
              ElementsAre("2:2 the file ends inside a comment; --> is missing"));
}

TEST(XmlSyntax, OtherFaultsAreNamed) {
  const auto one = [](std::string_view inside) { return said(with_transforms(inside)).back(); };
  EXPECT_EQ(one("<scale x=\"1\" x=\"2\"/>"), "4:14 attribute \"x\" is given twice");
  EXPECT_EQ(one("<scale x=1,y=2/>"), "4:10 \"1,y\" must be in quotation marks");
  EXPECT_EQ(one("<scale x=\u201C1\"/>"),
            "4:10 a typographic quotation mark, as word processors insert it; use \" or '");
  EXPECT_EQ(one("<a b=\"x<y\"/>"), "4:8 < is not allowed here; inside a value write &lt;");
  EXPECT_EQ(one("<a b=\"x\"\n<c/>"), "5:1 the tag <a> of line 4 is missing its > or />");
  EXPECT_EQ(one("<a b=\"x & y\"/>"), "4:9 a bare & is not allowed; write &amp;");
  EXPECT_EQ(one("<a b=\"&nbsp;\"/>"),
            "4:7 the entity \"nbsp\" is not defined; for a bare & write &amp;");
  EXPECT_EQ(one("<a b=\"&#xD800;\"/>"), "4:7 \"&#xD800;\" is not a valid character reference");
  EXPECT_THAT(one("<!-- a -- b -->"), HasSubstr("-- is not allowed inside a comment"));
  EXPECT_EQ(one("a\x01"), "4:2 the character \"\\u{1}\" is not allowed in XML");
  EXPECT_THAT(one("a \xFF"), HasSubstr("is not valid UTF-8"));
  EXPECT_EQ(one("< scale/>"), "4:2 a name must directly follow <");
  EXPECT_EQ(one("<--> note -->"), "4:1 a comment starts with <!--, not with <--");
  EXPECT_EQ(one("<a b=\"R&D\"/>"), "4:8 a bare & is not allowed; write &amp;");
  EXPECT_EQ(one("<a b=\"salt&pepper-1.obj\"/>"), "4:11 a bare & is not allowed; write &amp;");
  EXPECT_EQ(one("<a b=\"1\", c=\"2\"/>"), "4:9 attributes are separated by spaces, not by commas");
  EXPECT_THAT(one("<a b=\"1\"; c=\"2\"/>"), HasSubstr("not by semicolons"));
  EXPECT_EQ(one("<a b='x & y'/>"), "4:9 a bare & is not allowed; write &amp;");
  EXPECT_EQ(one("<a&b c='1'/>"), "4:3 \"&\" is not expected here");
  EXPECT_THAT(one("<a <!-- c --> b=\"1\"/>"), HasSubstr("4:4 a comment cannot be inside a tag"));
  EXPECT_EQ(one("<a b=\"1\"/ >"), "4:10 the / that ends a tag must be directly followed by >");
  EXPECT_THAT(one("<a b=\"1\"\\>"), HasSubstr("or with /> where nothing is inside"));
  EXPECT_EQ(one("<<a/>"), "4:2 two < in a row; one is enough");
  EXPECT_EQ(one("<a\u00A0b=\"1\"/>"),
            "4:3 a special space character, U+00A0; use an ordinary space");
  EXPECT_THAT(one("<a b=\"1 2c\"3\"/>"), HasSubstr("4:12 \"3\" right after a quotation mark"));
}

// The rest of the file is read as if the quotation marks were there.
TEST(XmlSyntax, ReadingGoesOnAfterUnquotedValues) {
  const auto in_scale = [](std::string_view tag) { return said(with_transforms(tag)); };
  EXPECT_THAT(in_scale("<scale x=1 y='2' z=3/>"),
              ElementsAre("4:10 \"1\" must be in quotation marks; write x=\"1\"",
                          "4:20 \"3\" must be in quotation marks; write z=\"3\""));
  EXPECT_THAT(in_scale("<scale x=1 y=\"1\" z=\"q\" w=\"0\"/>"),
              ElementsAre("4:10 \"1\" must be in quotation marks; write x=\"1\"",
                          HasSubstr("4:24 unknown attribute w of <scale>"),
                          HasSubstr("4:18 attribute z of <scale>: \"q\" is not a number")));
  EXPECT_THAT(in_scale("<scale x=1\" y=\"1\" z=\"1\"/>"),
              ElementsAre("4:10 \"1\" is missing its opening quotation mark; write x=\"1\""));
  EXPECT_THAT(in_scale("<scale x=\"1 y=\"1\" z=\"1/>"),
              ElementsAre("4:10 \"1\" is missing its closing quotation mark; write x=\"1\"",
                          "4:21 \"1\" is missing its closing quotation mark; write z=\"1\""));
  EXPECT_THAT(
      said(in_root("<transblock><object type='primitive' name=\"two words filename=\"mesh\"/>"
                   "</transblock>"))
          .front(),
      HasSubstr("\"two words\" is missing its closing quotation mark"));
  EXPECT_THAT(in_scale("<scale x=\u201C1\u201D y = \n\u2018 1\u2019 z=\"1\"/>"),
              ElementsAre(HasSubstr("4:10 a typographic quotation mark, as word processors insert "
                                    "it; write x=\"1\""),
                          HasSubstr("5:1 a typographic quotation mark")));
  EXPECT_THAT(said(in_root("<transblock><object type=primitive name=mesh filename=../\u00e4/b.obj/>"
                           "</transblock>")),
              ElementsAre(HasSubstr("write type=\"primitive\""), HasSubstr("write name=\"mesh\""),
                          HasSubstr("write filename=\"../\u00e4/b.obj\"")));
  const Reading reading = read(
      "<scenefile><globaldata><diffusecoeff v=.25></diffusecoeff>"
      "</globaldata><object type=tree name='root'></object></scenefile>");
  EXPECT_EQ(reading.scene.global.diffuse, 0.25f);
  EXPECT_TRUE(reading.scene.incomplete);
}

TEST(XmlSyntax, ValuesWithoutAClearEndStopReading) {
  for (const std::string_view tag :
       {"<scale x= y=\"1\"/>", "<scale x=1,y=2/>", "<scale x=/>", "<scale x=1/ >", "<scale x=1;/>",
        "<scale x=1\\/>", "<scale x=1\"2\"/>", "<scale x=a&b/>", "<scale x=1 x=2/>",
        "<scale x=1 y=\"2 3/>", "<scale x=1 y=\"/>", "<scale x=1 y=\"2/>3",
        "<scale y=\"1=2 z=\"3\"/>", "<scale x=1</scale>", "<scale x=\u201C1/>",
        "<scale x=1y=\"1\"/>", "<scale x"}) {
    const Reading reading = read(with_transforms(tag) + "<frob/>");
    ASSERT_EQ(reading.diagnostics.list().size(), 1u) << tag;
    EXPECT_EQ(reading.diagnostics.list()[0].code->name, "xml.syntax") << tag;
  }
}

TEST(XmlSyntax, NothingIsReadAfterAnotherMistake) {
  EXPECT_THAT(said(with_transforms("<scale x=1 y=\"1\" z=\"1\"/>\n<a b=\"<\"/>\n<scale x=1/>")),
              ElementsAre(HasSubstr("4:10 \"1\" must be in"), HasSubstr("5:7 < is not allowed")));
}

TEST(XmlSyntax, ReadingGoesOnAfterEndTagsInTheWrongCase) {
  EXPECT_THAT(said(in_root("<transblock>\n</TransBlock>\n<frob/>")),
              ElementsAre("4:1 </TransBlock> cannot close <transblock>, opened at line 3; did you "
                          "mean </transblock>?",
                          HasSubstr("3:1 the transblock has no object"),
                          HasSubstr("5:1 unknown element <frob>")));
  EXPECT_THAT(said("<scenefile>\n<object type=\"tree\" name=\"root\">\n</Scenefile>"),
              ElementsAre(HasSubstr("3:1 </Scenefile> cannot close <object>")));
}

TEST(XmlSyntax, ManyRepairedMistakesAreCounted) {
  std::string scales;
  for (int i = 0; i < 100000; ++i) {
    scales += "<scale x=1 y='1' z='1'></Scale>\n";
  }
  Limits limits;
  limits.messages_per_code = 3;
  const Reading reading = read(with_transforms(scales), {.limits = limits});
  EXPECT_EQ(reading.diagnostics.list().size(), 3u);
  EXPECT_EQ(reading.diagnostics.count(Severity::error), 200000u);
}

TEST(XmlSyntax, ColumnsAfterRepairedValuesAreThoseOfTheFile) {
  EXPECT_THAT(
      said(with_transforms("<scale x=\u201C\u00E91\u201D y=\"1\" z=\"1\"/><<scale/>")).back(),
      HasSubstr("4:29 two < in a row"));
}

TEST(XmlSyntax, MistakesAreNamedWhereTheyBegin) {
  const auto one = [](std::string_view inside) { return said(with_transforms(inside)).back(); };
  EXPECT_EQ(one("<scale x=\"1\" y=\"1\" z=\"1 1/>\n<a/>"),
            "4:22 the value that begins here, in <scale>, is missing its closing quotation mark");
  EXPECT_EQ(one("<a b='1 1/>\n<c/>"),
            "4:6 the value that begins here, in <a>, is missing its closing quotation mark");
  EXPECT_EQ(one("<a b=\"x<y\"/>"), "4:8 < is not allowed here; inside a value write &lt;");
  EXPECT_EQ(one("<scale x=\"1\" y=\"1\" z=\"1\"/></scale>"),
            "4:27 </scale> has no opening tag: <scale> is already closed by its />; remove it");
  EXPECT_EQ(one("<!- note -->"), "4:1 a comment starts with <!-- and ends with -->");
  EXPECT_EQ(one("<! note -->"), "4:1 a comment starts with <!-- and ends with -->");
  EXPECT_EQ(said("<?xml version=\"1.0\">\n<scenefile/>"),
            std::vector<std::string>{"1:1 <?xml is missing its end ?>: write ? in front of the >"});
  EXPECT_EQ(said("<scenefile>\n<globaldata>\n</globaldata\n</scenefile>").back(),
            "4:1 the tag </globaldata> of line 3 is missing its >");
  EXPECT_EQ(
      said("<scenefile>\nglobaldata>\n</globaldata>\n</scenefile>").back(),
      "2:1 the tag globaldata> is missing its <; </globaldata> of line 3 has nothing to close");
}

TEST(XmlSyntax, ValuesBetweenTagsAreShownAsAttributes) {
  const auto last = [](std::string_view inside) { return said(with_material(inside)).back(); };
  EXPECT_THAT(
      last("<diffuse>1 0 0</diffuse>"),
      HasSubstr("the text \"1 0 0\" has no effect; write <diffuse r=\"1\" g=\"0\" b=\"0\"/>"));
  EXPECT_THAT(last("<blend> 1 </blend>"), HasSubstr("write <blend v=\"1\"/>"));
  EXPECT_THAT(last("<texture>a.png</texture>"), HasSubstr("write <texture file=\"a.png\"/>"));
  EXPECT_THAT(said(with_transforms("<rotate>0 1 0 30</rotate>")).back(),
              HasSubstr("write <rotate x=\"0\" y=\"1\" z=\"0\" angle=\"30\"/>"));
  EXPECT_THAT(said(in_root("<transblock>sphere</transblock>")).front(),
              HasSubstr("values are attributes"));
}

TEST(XmlSyntax, ShapesAreObjects) {
  EXPECT_THAT(said(in_root("<transblock><Sphere/></transblock>")),
              Contains(HasSubstr("it was ignored: write <object type=\"primitive\" "
                                 "name=\"sphere\"/>")));
}

TEST(XmlSyntax, TheEndOfACommentHasNoSpaces) {
  const std::string gap = "4:8 a comment ends with -->, without spaces in it; remove them";
  EXPECT_THAT(said(with_transforms("<!-- a -- >")), ElementsAre(gap));
  EXPECT_THAT(said(with_transforms("<!-- a -- >\n<!-- b -->")), ElementsAre(gap));
  EXPECT_THAT(found(with_transforms("<!-- a -- >")), ElementsAre("4:8 error xml.comment"));
}

TEST(XmlSyntax, ADeclarationMustComeFirst) {
  EXPECT_THAT(
      said("\n<?xml version=\"1.0\"?><scenefile/>"),
      ElementsAre(
          "2:1 <?xml ...?> must be the very first thing in the file; remove everything before it"));
}

TEST(XmlSyntax, NothingFollowsTheScene) {
  EXPECT_THAT(
      said(in_root("") + "<transblock/>"),
      ElementsAre("6:1 nothing may follow the closing tag of the scene; found \"<transblock/>\""));
}

TEST(XmlSyntax, ConflictMarkersAreReportedAnywhere) {
  EXPECT_THAT(said(in_root("<<<<<<< HEAD\n<transblock/>\n=======\n>>>>>>> theirs")),
              ElementsAre("3:1 an unresolved git conflict: \"<<<<<<< HEAD\""));
  // Here the first < of the marker is taken as part of the tag before it.
  EXPECT_THAT(said(in_root("<transblock>\n<<<<<<< HEAD\n</transblock>")),
              ElementsAre("4:1 an unresolved git conflict: \"<<<<<<< HEAD\""));
}

TEST(XmlSyntax, MessagesCannotBeForged) {
  const std::vector<std::string> lines = said(with_transforms("<\u202Efrob\u202C/>"));
  for (const std::string& line : lines) {
    EXPECT_EQ(line.find("\u202E"), std::string::npos) << line;
  }
  const std::vector<std::string> shape = said(
      in_root("<transblock><object type=\"primitive\" name=\"a&#10;b\u202E\x1f\"/></transblock>"));
  ASSERT_FALSE(shape.empty());
  EXPECT_EQ(shape[0].find('\n'), std::string::npos);
}

TEST(XmlEntities, AreRejectedAndNothingIsOpened) {
  const std::string scene =
      in_root("<transblock><object type=\"primitive\" name=\"&e;\"/></transblock>");
  EXPECT_THAT(found("<!DOCTYPE scenefile [<!ENTITY e \"cube\">]>" + scene),
              ElementsAre("1:22 error xml.entity"));
  EXPECT_THAT(found("<!DOCTYPE scenefile [<!ENTITY e SYSTEM \"/etc/hostname\">]>" + scene),
              ElementsAre("1:22 error xml.entity"));
  EXPECT_THAT(found("<!DOCTYPE scenefile [<!ENTITY % e \"x\"> %e;]>" + in_root("")),
              ElementsAre("1:22 error xml.entity"));
  EXPECT_THAT(found("<!DOCTYPE scenefile [<!ATTLIST translate x CDATA \"7\">]>" + in_root("")),
              ElementsAre("1:22 error xml.entity"));
  EXPECT_THAT(found("<!DOCTYPE scenefile SYSTEM \"x.dtd\">" + scene),
              ElementsAre("1:1 warning xml.external-dtd", "3:44 error xml.entity"));
  EXPECT_THAT(found("<!DOCTYPE scenefile SYSTEM \"x.dtd\">" + in_root("&e;")),
              ElementsAre("1:1 warning xml.external-dtd", "3:1 error xml.entity"));
  EXPECT_THAT(found("<!DOCTYPE scenefile SYSTEM \"x.dtd\">" +
                    in_root("<!-- &e; --><transblock><object type=\"primitive\" "
                            "name=\"c&#x75;be\"/></transblock>")),
              ElementsAre("1:1 warning xml.external-dtd"));
}

TEST(XmlEntities, CharactersByNumberAreRead) {
  const Reading reading = read(
      in_root("<transblock><object type=\"&#116;ree\" name=\"a&lt;&quot;b\"><transblock><object "
              "type=\"tree\"/></transblock></object></transblock>"));
  EXPECT_FALSE(reading.diagnostics.has_errors());
  EXPECT_EQ(reading.scene.nodes.at(1).name, "a<\"b");
}

std::string nested(int depth) {
  std::string text = "<scenefile>";
  for (int i = 1; i < depth; ++i) {
    text += i % 2 == 1 ? "<object type=\"tree\" name=\"root\">" : "<transblock>";
  }
  for (int i = depth - 1; i >= 1; --i) {
    text += i % 2 == 1 ? "</object>" : "</transblock>";
  }
  return text + "</scenefile>";
}

TEST(XmlLimits, NestingUpToTheLimit) {
  const Limits limits;
  EXPECT_FALSE(read(nested(static_cast<int>(limits.nesting))).diagnostics.has_errors());
  const Reading reading = read(nested(static_cast<int>(limits.nesting) + 1));
  EXPECT_THAT(messages(reading.diagnostics).back(), HasSubstr("deeper than the limit of 1024"));
}

TEST(XmlLimits, NestingOfElementsThatAreIgnoredCountsToo) {
  std::string text = "<scenefile>";
  for (int i = 0; i < 200'000; ++i) {
    text += "<a>";
  }
  EXPECT_THAT(found(text).back(), HasSubstr("error xml.nesting-limit"));
}

TEST(XmlLimits, ALongTagIsRejectedBeforeItsEnd) {
  Limits limits;
  // These tags do not end: only the limit can stop the reader early.
  EXPECT_THAT(found("<scenefile><a b=\"" + std::string(2'000'000, 'x'), limits),
              ElementsAre("1:12 error xml.length-limit"));
  EXPECT_THAT(found("<scenefile><" + std::string(2'000'000, 'x'), limits),
              ElementsAre("1:12 error xml.length-limit"));
  std::string many = "<scenefile><a";
  for (int i = 0; i < 100'000; ++i) {
    many += fmt::format(" a{}=\"\"", i);
  }
  EXPECT_THAT(found(many, limits), ElementsAre("1:12 error xml.attribute-limit"));
  std::string comment = "<scenefile><!-- ";
  comment.append(40'000'000, 'x');
  EXPECT_THAT(found(comment, limits), ElementsAre("1:12 error xml.length-limit"));
}

TEST(XmlLimits, LongButAllowed) {
  const std::string name(4096, 'n');
  const Reading reading =
      read(in_root("<transblock><object type=\"tree\" name=\"" + name +
                   "\"><transblock><object type=\"tree\"/></transblock></object></transblock>"));
  EXPECT_FALSE(reading.diagnostics.has_errors());
  EXPECT_EQ(reading.scene.nodes.at(1).name, name);
  EXPECT_THAT(
      found(in_root("<transblock><object type=\"master\" name=\"" + name + "n\"/></transblock>")),
      ElementsAre("3:35 error xml.length-limit"));
  EXPECT_THAT(found(with_material("<texture file=\"" + name + "x\"/>")),
              ElementsAre("5:10 error xml.length-limit"));
  EXPECT_TRUE(found(in_root("<!--" + std::string(5'000'000, 'x') + "-->")).empty());
}

TEST(XmlLimits, MessagesNameLongThingsInShort) {
  for (const std::string& message :
       said("<scenefile><" + std::string(100'000, 'x') + "/></scenefile>")) {
    EXPECT_LT(message.size(), 200u);
  }
  for (const std::string& message : said(with_transforms(
           "<translate x=\"" + std::string(60'000, 'x') + "\" y=\"0\" z=\"0\"/>"))) {
    EXPECT_LT(message.size(), 200u);
  }
}

const char* const small_scene = R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE scenefile [<!ELEMENT x ANY>]>
<!-- small -->
<scenefile>
  <globaldata><ambientcoeff v="0.5"/></globaldata>
  <cameradata><pos x="0" y="0" z="5"/><focus x="0" y="0" z="0"/><up x="0" y="1" z="0"/><heightangle v="45"/></cameradata>
  <lightdata><id v="0"/><type v="spot"/><color r="1" g="1" b="1"/><position x="1" y="2" z="3"/><direction x="0" y="-1" z="0"/><penumbra v="5"/><angle v="30"/></lightdata>
  <object type="tree" name="a"><transblock><object type="primitive" name="cone"/></transblock></object>
  <object type="tree" name="root">
    <transblock>
      <rotate x="0" y="1" z="0" angle="&#51;0"/>
      <matrix><row a="1" b="0" c="0" d="0"/><row a="0" b="1" c="0" d="0"/><row a="0" b="0" c="1" d="0"/><row a="0" b="0" c="0" d="1"/></matrix>
      <object type="primitive" name="mesh" filename="a.obj"><texture file="a.png" u="1" v="2"/></object>
    </transblock>
    <transblock><object type="master" name="a"/></transblock>
    <![CDATA[]]><?pi x?>
  </object>
</scenefile>)";

TEST(XmlDamage, TheSmallSceneIsFine) {
  EXPECT_TRUE(found(small_scene).empty());
}

TEST(XmlDamage, EveryPrefixEndsWithAnError) {
  const std::string_view text = small_scene;
  for (std::size_t length = 0; length < text.size(); ++length) {
    const Reading reading = read(text.substr(0, length));
    EXPECT_TRUE(reading.diagnostics.has_errors()) << length;
    const bool is_scene = text.substr(0, length).find("<scene") != std::string_view::npos;
    EXPECT_EQ(reading.diagnostics.list().back().location.known(), is_scene) << length;
  }
}

// The outcome does not matter, but there must be one, and an error if the text is not well-formed.
// Sanitizers check the rest.
TEST(XmlDamage, EveryChangedByteIsSurvived) {
  std::string text = small_scene;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char good = text[at];
    for (const char bad : {'\0', '<', '>', '"', '&', '/', 'z', '\xFF', '\xC3', '\n'}) {
      text[at] = bad;
      const Reading reading = read(text);
      EXPECT_FALSE(reading.scene.nodes.empty());
    }
    text[at] = good;
  }
}

TEST(XmlEncoding, DamagedUtf16IsAnError) {
  using namespace std::string_literals;
  EXPECT_THAT(found("\xFF\xFE<"s + '\0' + '\x00' + '\xD8'),
              ElementsAre("0:0 error format.encoding"));
  EXPECT_THAT(found("\xFF\xFE<"s), ElementsAre("0:0 error format.encoding"));
  EXPECT_THAT(found("<?xml version=\"1.0\" encoding=\"UTF-16\"?><scenefile/>"),
              ElementsAre("1:1 error format.encoding"));
}

TEST(XmlEncoding, Utf32IsNamed) {
  using namespace std::string_literals;
  for (const std::string& start : {"\xFF\xFE\0\0<\0\0\0"s, "\0\0\xFE\xFF\0\0\0<"s, "<\0\0\0"s}) {
    EXPECT_THAT(said(start), ElementsAre("0:0 the file is UTF-32; save it as UTF-8"));
  }
}

TEST(XmlEncoding, NamesInOtherEncodings) {
  const auto name_in = [](std::string_view encoding, std::string_view e) {
    const Reading reading = read(fmt::format(
        "<?xml version=\"1.0\" encoding=\"{}\"?><scenefile><object type=\"tree\" name=\"caf{}\">"
        "</object><object type=\"tree\" name=\"root\"/></scenefile>",
        encoding, e));
    return reading.scene.nodes.at(1).name;
  };
  EXPECT_EQ(name_in("utf-8", "\u00e9"), "caf\u00e9");
  EXPECT_EQ(name_in("ISO-8859-1", "\xE9"), "caf\u00e9");
  EXPECT_EQ(name_in("windows-1252", "\x80"), "caf\u20ac");
  EXPECT_THAT(
      found("<?xml version=\"1.0\" encoding=\"big5\"?><scenefile><!-- \xE9 --></scenefile>"),
      ElementsAre("1:1 error format.encoding"));
}

TEST(XmlEncoding, Utf16OutsideTheBasicPlane) {
  const std::u16string text =
      u"<scenefile><object type='tree' name='\U0001F600'/><object type='tree' "
      u"name='root'/></scenefile>";
  std::string little;
  std::string big;
  for (const char16_t c : text) {
    little += {static_cast<char>(c & 0xFF), static_cast<char>(c >> 8)};
    big += {static_cast<char>(c >> 8), static_cast<char>(c & 0xFF)};
  }
  EXPECT_EQ(read(little).scene.nodes.at(1).name, "\U0001F600");
  EXPECT_EQ(read(big).scene.nodes.at(1).name, "\U0001F600");
}

TEST(FormatDispatch, OtherTextIsNamed) {
  EXPECT_THAT(found(""), ElementsAre("0:0 error format.empty"));
  EXPECT_THAT(found("\xEF\xBB\xBF"), ElementsAre("0:0 error format.empty"));
  EXPECT_THAT(found(" \r\n \t x"), ElementsAre("0:0 error format.unknown"));
  EXPECT_THAT(found("\x89PNG\r\n"), ElementsAre("0:0 error format.unknown"));
}

}  // namespace
}  // namespace scenefile::testing
