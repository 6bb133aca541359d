#include "scenefile/asset/mtl_file.h"

#include "asset/sample_files.h"
#include "scenefile/asset/codes.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace scenefile {
namespace {

using test::findings;
using ::testing::HasSubstr;

struct ReadMtl {
  std::vector<MtlMaterial> materials;
  std::uint64_t bytes = 1 << 20;
  Diagnostics diagnostics;
};

ReadMtl read_text(std::string_view text, const Limits& limits = {}) {
  ReadMtl r{{}, 1 << 20, Diagnostics(limits)};
  r.materials = read_mtl(text, "a.mtl", limits, r.bytes, r.diagnostics);
  return r;
}

TEST(ReadMtl, ReadsAllValues) {
  const ReadMtl r = read_text(
      "# a library\n"
      "newmtl first\n"
      "Ka 0.1 0.2 0.3\nKd 1 0 0.5\nKs 0 0.25 1e-1\nKe 17 12 4 # bright\nTf 0.1 0.2 0.3\n"
      "Ns 96.078431\nNi 1.45\nd 0.5\nillum 7\n"
      "map_Kd wood.png\nmap_Ks gloss.png\nmap_Ke glow.png\n"
      "\tnewmtl second wall\n\tKt 1 1 1\n\tTr 0.25\n");
  EXPECT_EQ(findings(r.diagnostics), "");
  ASSERT_EQ(r.materials.size(), 2u);
  const MtlMaterial& m = r.materials[0];
  EXPECT_EQ(m.name, "first");
  EXPECT_EQ(m.location, (Location{2, 1}));
  EXPECT_EQ(m.ambient, glm::vec3(.1f, .2f, .3f));
  EXPECT_EQ(m.diffuse, glm::vec3(1, 0, .5f));
  EXPECT_EQ(m.specular, glm::vec3(0, .25f, .1f));
  EXPECT_EQ(m.emission, glm::vec3(17, 12, 4));
  EXPECT_EQ(m.transmission, glm::vec3(.1f, .2f, .3f));
  EXPECT_EQ(m.shininess, 96.078431f);
  EXPECT_EQ(m.ior, 1.45f);
  EXPECT_EQ(m.opacity, .5f);
  EXPECT_EQ(m.illum, 7);
  EXPECT_EQ(m.diffuse_map.name, "wood.png");
  EXPECT_EQ(m.diffuse_map.location, (Location{12, 8}));
  EXPECT_EQ(m.specular_map.name, "gloss.png");
  EXPECT_EQ(m.emission_map.name, "glow.png");
  EXPECT_EQ(r.materials[1].name, "second wall");
  EXPECT_EQ(r.materials[1].transmission, glm::vec3(1));
  EXPECT_EQ(r.materials[1].opacity, .75f);
  EXPECT_FALSE(r.materials[1].diffuse || r.materials[1].ior || r.materials[1].illum);
}

TEST(ReadMtl, LineEndsAndMarksDoNotMatter) {
  for (const std::string text :
       {"newmtl a b\nKd 1 2 3\nillum 2\n", "newmtl a b\r\nKd 1 2 3\r\nillum 2",
        "\xef\xbb\xbfnewmtl\ta b  \rKd\t1 2\t3\rillum 2\r",
        "newmtl a b # b\nKd 1 \\\n 2 3\n\nillum 2"}) {
    const ReadMtl r = read_text(text);
    EXPECT_EQ(findings(r.diagnostics), "") << text;
    ASSERT_EQ(r.materials.size(), 1u) << text;
    EXPECT_EQ(r.materials[0].name, "a b") << text;
    EXPECT_EQ(r.materials[0].diffuse, glm::vec3(1, 2, 3)) << text;
    EXPECT_EQ(r.materials[0].illum, 2) << text;
  }
}

TEST(ReadMtl, NamesOfMapsFollowTheirOptions) {
  const std::pair<std::string, std::string> cases[] = {
      {"a.png", "a.png"},
      {"my wood.png", "my wood.png"},
      {"textures\\my wood.png  ", "textures\\my wood.png"},
      {"wood#1.png # oak", "wood#1.png"},
      {"wood #2.png #oak", "wood #2.png"},
      {"-s 1 1 1 -o 0 0 0 a b.png", "a b.png"},
      {"-s 1 a.png", "a.png"},
      {"-s 1 1 1.png", "1.png"},
      {"-blendu on -blendv off -mm 0 1 -bm 1 -texres 512 -imfchan m a.png", "a.png"},
      {"-a.png", "-a.png"},
      {"-s 1 1 1 \"a b.png\"", "a b.png"},
  };
  for (const auto& [text, name] : cases) {
    const ReadMtl r = read_text("newmtl m\nmap_Kd " + text + "\n");
    EXPECT_EQ(findings(r.diagnostics), "") << text;
    ASSERT_EQ(r.materials.size(), 1u) << text;
    EXPECT_EQ(r.materials[0].diffuse_map.name, name) << text;
  }
}

TEST(ReadMtl, EachMistakeHasItsPlace) {
  const std::pair<std::string, std::string> cases[] = {
      {"Kd 1 x 0\n", "2:6 mtl.value \"x\" in Kd is not a number; Kd keeps its default\n"},
      {"Kd 1 0.5f 0\n", "2:6 mtl.value \"0.5f\" in Kd"},
      {"Kd nan 0 0\n", "2:4 mtl.value \"nan\" in Kd"},
      {"Kd 1e99 0 0\n", "2:4 mtl.value \"1e99\" in Kd is too large for a number"},
      {"Kd\n", "2:1 mtl.value Kd needs a number; it keeps its default\n"},
      {"Kd 0.5\n", "2:1 mtl.value Kd needs three numbers, r g b; the missing ones"},
      {"Kd spectral a.rfl 1\n", "2:4 mtl.value \"spectral\" in Kd"},
      {"Ke 1 -2 0\n", "2:6 mtl.range Ke -2 is negative; 0 is used\n"},
      {"Ns -5\n", "2:4 mtl.range Ns -5 is negative; 0 is used\n"},
      {"Ni 0\n", "2:4 mtl.range Ni 0 is not above 0; it keeps its default\n"},
      {"d 2\n", "2:3 mtl.range d 2 is above 1; 1 is used\n"},
      {"illum 2.5\n", "2:7 mtl.value illum 2.5 is not the number of a model"},
      {"illum 1e9\n", "2:7 mtl.value illum 1e9 is not the number of a model"},
      {"map_Kd\n", "2:1 mtl.value map_Kd needs the name of a file\n"},
      {"map_Kd -s 1 1 1\n", "2:1 mtl.value map_Kd needs the name of a file\n"},
      {"map_Kd -o 0 1 a.png\n", "2:8 mtl.map-option -o of map_Kd is not applied"},
      {"map_Kd -clamp on a.png\n", "2:8 mtl.map-option -clamp of map_Kd is not applied"},
      {"kd 1 0 0\nkd 1 0 0\n",
       "2:1 mtl.unknown-keyword unknown keyword \"kd\" is skipped; did you mean Kd?\n"},
      {"newmtl m\nKd 1 1 1\n",
       "2:1 mtl.duplicate the material \"m\" is already defined; this definition is not used\n"},
      {"Kd \xc3\xa9 0 0\n", "2:4 mtl.value"},
  };
  for (const auto& [text, finding] : cases) {
    const ReadMtl r = read_text("newmtl m\n" + text);
    EXPECT_THAT(findings(r.diagnostics), HasSubstr(finding)) << text;
    EXPECT_EQ(r.diagnostics.list().size(), 1u) << text;
    EXPECT_EQ(r.materials.size(), 1u) << text;
    EXPECT_EQ(r.diagnostics.list()[0].file, "a.mtl");
    EXPECT_FALSE(r.diagnostics.has_errors());
  }
}

TEST(ReadMtl, MistakesLeaveTheDefault) {
  const ReadMtl r = read_text(
      "newmtl m\nKd 1 x 0\nNs five\nNi -1\nillum two\nKe -1 2 3\nKs 0.5\nKd 0.1 0.2 0.3\n"
      "newmtl m\nKd 1 1 1\n");
  ASSERT_EQ(r.materials.size(), 1u);
  const MtlMaterial& m = r.materials[0];
  EXPECT_EQ(m.diffuse, glm::vec3(.1f, .2f, .3f));
  EXPECT_EQ(m.emission, glm::vec3(0, 2, 3));
  EXPECT_EQ(m.specular, glm::vec3(.5f));
  EXPECT_FALSE(m.shininess || m.ior || m.illum);
}

TEST(ReadMtl, OpacityIsThatOfD) {
  EXPECT_EQ(read_text("newmtl m\nd 0.25\nTr 1\n").materials[0].opacity, .25f);
  EXPECT_EQ(read_text("newmtl m\nTr 1\nd 0.25\n").materials[0].opacity, .25f);
  EXPECT_EQ(read_text("newmtl m\nd -halo 0.5\n").materials[0].opacity, .5f);
  EXPECT_EQ(read_text("newmtl a\nd 0.25\nnewmtl b\nTr 1\n").materials[1].opacity, 0);
}

TEST(ReadMtl, ValuesBeforeTheFirstMaterialHaveNoEffect) {
  const ReadMtl r = read_text("Ka 1 1 1\nKd 1 0 0\nnewmtl a\nKs 1 1 1\n");
  EXPECT_EQ(findings(r.diagnostics),
            "1:1 mtl.before-newmtl \"Ka\" comes before any newmtl and belongs to no material\n");
  EXPECT_FALSE(r.materials.at(0).diffuse);
}

TEST(ReadMtl, OtherFilesAreNotLibraries) {
  EXPECT_THAT(findings(read_text("").diagnostics),
              HasSubstr("mtl.no-material the material library is"));
  EXPECT_THAT(findings(read_text("v 0 0 0\nf 1 2 3\n").diagnostics),
              HasSubstr("mtl.no-material this is not a material library"));
  EXPECT_THAT(findings(read_text(test::fixture("rgb.png")).diagnostics),
              HasSubstr("mtl.no-material"));
}

TEST(ReadMtl, MaterialsCountTowardTheLimit) {
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    text += fmt::format("newmtl m{}\n", i);
  }
  Diagnostics diagnostics;
  std::uint64_t bytes = 100'000;
  const std::size_t kept = read_mtl(text, "a.mtl", {}, bytes, diagnostics).size();
  EXPECT_LT(kept * sizeof(MtlMaterial), 100'000u);
  EXPECT_GT(kept, 50u);
  EXPECT_THAT(findings(diagnostics), HasSubstr("mtl.limit"));
}

TEST(ReadMtl, FindingsAreBounded) {
  std::string text = "newmtl a\n";
  for (int i = 0; i < 5000; ++i) {
    text += fmt::format("word{} 1\n", i);
  }
  Limits limits;
  limits.messages_per_code = 7;
  EXPECT_EQ(read_text(text, limits).diagnostics.list().size(), 7u);
}

// Any values, written with any number of digits, blanks and line ends, are read back.
TEST(ReadMtl, ReadsBackWhatIsWritten) {
  EXPECT_TRUE(rc::check([] {
    const auto number = [] { return static_cast<float>(*rc::gen::inRange(0, 100000)) / 97; };
    const auto blank = [] { return *rc::gen::element<std::string>(" ", "\t", "  ", " \\\n "); };
    const auto end = [] { return *rc::gen::element<std::string>("\n", "\r\n", "\r", " # x\n"); };
    const int count = *rc::gen::inRange(1, 6);
    std::string text;
    std::vector<glm::vec3> colors;
    for (int i = 0; i < count; ++i) {
      colors.emplace_back(number(), number(), number());
      text += fmt::format("newmtl{}m {}{}", blank(), i, end());
      text += *rc::gen::element<std::string>("", "Ka 1 1 1\n", "bump a.png\r\n");
      text += fmt::format("Ke{}{}{}{}{}{}{}", blank(), colors[i].x, blank(), colors[i].y, blank(),
                          colors[i].z, end());
    }
    const ReadMtl r = read_text(text);
    RC_ASSERT(findings(r.diagnostics).empty());
    RC_ASSERT(r.materials.size() == colors.size());
    for (std::size_t i = 0; i < colors.size(); ++i) {
      RC_ASSERT(r.materials[i].name == fmt::format("m {}", i));
      RC_ASSERT(*r.materials[i].emission == colors[i]);
    }
  }));
}

}  // namespace
}  // namespace scenefile
