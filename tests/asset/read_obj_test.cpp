#include "asset/sample_files.h"
#include "scenefile/asset/codes.h"
#include "support/cpu_time.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace scenefile {
namespace {

using test::findings;
using test::read;
using test::ReadObj;
using Corners = std::array<std::uint32_t, 3>;
using ::testing::HasSubstr;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string square = triangle + "v 1 1 0\n";

TEST(ReadObj, PositionsUvsNormalsAndEveryFormOfCorner) {
  const ReadObj r = read(triangle +
                         "vt 0.25 0.5\nvt 1\nvt 0 1 0.5\nvn 0 0 2\nvn 1 0 0\nvn 0 1 0\n"
                         "f 1 2 3\nf 1/3 2/2 3/1\nf 1//2 2//1 3//3\nf 1/1/3 2/2/2 3/3/1\n");
  EXPECT_EQ(findings(r.diagnostics), "");
  EXPECT_EQ(r.mesh.positions[1], glm::vec3(1, 0, 0));
  EXPECT_EQ(r.mesh.uvs[0], glm::vec2(0.25, 0.5));
  EXPECT_EQ(r.mesh.uvs[1], glm::vec2(1, 0));
  EXPECT_EQ(r.mesh.uvs[2], glm::vec2(0, 1));
  EXPECT_EQ(r.mesh.normals[0], glm::vec3(0, 0, 2));
  const Corners none = {mesh_no_index, mesh_no_index, mesh_no_index};
  EXPECT_EQ(r.mesh.triangles, (std::vector<Corners>(4, {0, 1, 2})));
  EXPECT_EQ(r.mesh.triangle_uvs, (std::vector<Corners>{none, {2, 1, 0}, none, {0, 1, 2}}));
  EXPECT_EQ(r.mesh.triangle_normals, (std::vector<Corners>{none, none, {1, 0, 2}, {2, 1, 0}}));
}

TEST(ReadObj, PolygonsAreFans) {
  const ReadObj r = read(square + "v 2 0 5\nf 1 2 4 3 5\n");
  EXPECT_EQ(r.mesh.triangles, (std::vector<Corners>{{0, 1, 3}, {0, 3, 2}, {0, 2, 4}}));
}

TEST(ReadObj, NegativeIndicesCountFromTheLastSoFar) {
  const ReadObj r = read(triangle + "f -3 -2 -1\nv 5 5 5\nf -4 -3 -1\n");
  EXPECT_EQ(findings(r.diagnostics), "");
  EXPECT_EQ(r.mesh.triangles, (std::vector<Corners>{{0, 1, 2}, {0, 1, 3}}));
  EXPECT_THAT(findings(read(triangle + "f -1 -2 -4\nv 9 9 9\n").diagnostics),
              HasSubstr("4:9 mesh.index there is no vertex -4: 3 come before this face"));
}

TEST(ReadObj, FacesMayPrecedeTheirVertices) {
  const ReadObj r = read("f 1/1 2/1 3/1\n" + triangle + "vt 0 0\n");
  EXPECT_EQ(findings(r.diagnostics), "");
  EXPECT_EQ(r.mesh.triangles.size(), 1u);
}

TEST(ReadObj, SpellingsOfTheSameFile) {
  const std::string files[] = {
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
      "\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
      "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
      "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
      "  v\t0 0  0 \n\n\v\f\nv 1 0 0\nv 0 1 0\nf\v1\v2\v3\n",
      "# one\nv 0 0 0 # two\nv 1 0 0#three\n  # four \\\nv 0 1 0\nf 1 2 3 #",
      "v 0 0 0\nv 1 \\\n0 \\\r\n0\nv 0 1 0\nf 1 2\\\n 3\n",
      "v 0 0 0 1 0 0\nv 1 0 0 0.5\nv +0 1. 0e5 0 1 0 1\nf 1 2 3\n",
      "mtllib a b\\c.mtl\no x\ng\ns off\nusemtl y\nv 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 9\np 7\nf 1 2 "
      "3\n",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/ 2// +3\n",
  };
  for (const std::string& file : files) {
    const ReadObj r = read(file);
    EXPECT_EQ(findings(r.diagnostics), "") << file;
    EXPECT_EQ(r.mesh.triangles, (std::vector<Corners>{{0, 1, 2}})) << file;
    EXPECT_EQ(r.mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << file;
    EXPECT_TRUE(r.mesh.triangle_uvs.empty() && r.mesh.triangle_normals.empty()) << file;
  }
}

TEST(ReadObj, ErrorsNameTheirPlace) {
  const std::pair<std::string, const char*> cases[] = {
      {triangle + "f 1 2 4\n", "4:7 mesh.index there is no vertex 4: the file has 3"},
      {triangle + "f 0 1 2\n", "4:3 mesh.index there is no vertex 0: numbers start at 1"},
      {triangle + "f 1 2 3.5\n", "4:7 mesh.index \"3.5\" is not the number of a vertex"},
      {triangle + "f 1 two 3\n", "4:5 mesh.index \"two\" is not the number of a vertex"},
      {triangle + "f 1 2 +-1\n", "4:7 mesh.index \"+-1\" is not the number of a vertex"},
      {triangle + "f 1 2 -0\n", "4:7 mesh.index there is no vertex 0: numbers start at 1"},
      {triangle + "f 1 2 99999999999999999999\n", "4:7 mesh.index there is no vertex 9999999"},
      {triangle + "f 1 2 -9223372036854775808\n", "4:7 mesh.index there is no vertex -92233"},
      {triangle + "f 1 2 2147483648\n", "4:7 mesh.index there is no vertex 2147483648"},
      {triangle + "f 1 2 4294967299\n", "4:7 mesh.index there is no vertex 4294967299"},
      {triangle + "f / 2 3\n",
       "4:3 mesh.index in the corner \"/\": the number of the vertex is missing"},
      {triangle + "f 1///1 2 3\n", "4:3 mesh.index \"1///1\" is not a corner"},
      {triangle + "f 1/2 2 3\n", "4:3 mesh.index in the corner \"1/2\": there is no uv 2: "},
      {triangle + "f 1//1 2 3\n", "4:3 mesh.index in the corner \"1//1\": there is no normal 1"},
      {triangle + "f 1//x 2 3\n", "4:3 mesh.index in the corner \"1//x\": \"x\" is not the number"},
      {triangle + "f 1 \\\n 2 \\\n x\n", "6:2 mesh.index \"x\" is not"},
      {"v 0 0\n", "1:1 mesh.number v needs 3 numbers and has 2"},
      {"v 0 nan 0\n", "1:5 mesh.number \"nan\" in v is not a finite number"},
      {"v 0 0 inf\n", "1:7 mesh.number \"inf\" in v is not a finite number"},
      {"v 0 1e99 0\n", "1:5 mesh.number \"1e99\" in v is too large"},
      {"v 0 0 0 red\n", "1:9 mesh.number \"red\" in v is not a finite number"},
      {"v 0 0 0\nvn 0 0x1 0\n", "2:6 mesh.number \"0x1\" in vn is not"},
      {"vn 1 2\n", "1:1 mesh.number vn needs 3 numbers and has 2"},
      {"vt\n", "1:1 mesh.number vt needs 1 numbers and has 0"},
      {"# \xc3\xa9\xc3\xa9\n\tv 0 0 \xc3\xa9 0\n", "2:8 mesh.number"},
  };
  for (const auto& [text, finding] : cases) {
    EXPECT_THAT(findings(read(text).diagnostics), HasSubstr(finding)) << text;
  }
}

TEST(ReadObj, AllErrorsOfAFileAreReported) {
  const ReadObj r = read("v 0 0\nv nan 0 0\nf 1 2 9\nf x 1 2\n");
  EXPECT_EQ(r.diagnostics.count(Severity::error), 4u);
}

TEST(ReadObj, DegenerateTrianglesAreLeftOutAndCounted) {
  const ReadObj r =
      read(square + "f 1 2 3\nf 1 1 2\nf 1 2 2 4\nv 2 0 0\nf 1 2 5\nvt 0 0\n" + "f 4/1 3/1 2/1\n");
  EXPECT_EQ(findings(r.diagnostics),
            "0:0 mesh.degenerate 3 degenerate triangles without area are left out\n");
  EXPECT_EQ(r.mesh.triangles, (std::vector<Corners>{{0, 1, 2}, {0, 1, 3}, {3, 2, 1}}));
  EXPECT_EQ(r.mesh.triangle_uvs.size(), 3u);
  EXPECT_EQ(r.mesh.triangle_uvs[2], (Corners{0, 0, 0}));
}

TEST(ReadObj, ZeroNormalsShadeFlat) {
  const ReadObj r = read(square + "vn 0 0 1\nvn 0 0 0\nf 1//1 2//1 3//1\nf 2//1 4//1 3//2\n");
  EXPECT_THAT(findings(r.diagnostics), HasSubstr("6:1 mesh.zero-normal 1 normal of length zero"));
  EXPECT_EQ(r.mesh.triangle_normals[0], (Corners{0, 0, 0}));
  EXPECT_EQ(r.mesh.triangle_normals[1][0], mesh_no_index);
}

TEST(ReadObj, MissingNormalsShadeFlat) {
  const ReadObj r = read(square + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 3//7 4//-2\nf 1//0 2 3\n");
  EXPECT_EQ(
      findings(r.diagnostics),
      "7:8 mesh.index in the corner \"3//7\": there is no normal 7: the file has 1; 3 corners "
      "are without their normal: the triangles are shaded flat\n");
  EXPECT_EQ(r.diagnostics.count(Severity::warning), 1u);
  EXPECT_EQ(r.mesh.triangles.size(), 3u);
  constexpr Corners none = {mesh_no_index, mesh_no_index, mesh_no_index};
  EXPECT_EQ(r.mesh.triangle_normals, (std::vector<Corners>{{0, 0, 0}, none, none}));
}

struct WithMaterials {
  Mesh mesh;
  ObjMaterials materials;
  std::uint64_t bytes = 0;  // left of the limit
  Diagnostics diagnostics;
};

WithMaterials read_materials(std::string_view text, std::uint64_t mesh_bytes = 1 << 20) {
  WithMaterials r;
  Limits limits;
  std::uint64_t triangles = limits.mesh_triangles;
  r.bytes = mesh_bytes;
  r.mesh = read_obj(text, "test.obj", limits, triangles, r.bytes, r.diagnostics, &r.materials);
  return r;
}

// As 3ds Max names materials. Comments rarely begin with a digit.
TEST(ReadObj, NamesMayHaveNumbers) {
  const WithMaterials r = read_materials(
      square + "usemtl Material #1\nf 1 2 3\nusemtl Material #25 b # 3\nf 1 2 3 4\n" +
      "usemtl Material #x\nf 1 2 3\n");
  ASSERT_EQ(r.materials.names.size(), 3u);
  EXPECT_EQ(r.materials.names[0].name, "Material #1");
  EXPECT_EQ(r.materials.names[1].name, "Material #25 b");
  EXPECT_EQ(r.materials.names[2].name, "Material");
}

TEST(ReadObj, NamesTheMaterialOfEachTriangle) {
  const WithMaterials r =
      read_materials(square + "f 1 2 3\nusemtl white\nf 1 2 3 4\nusemtl  red  wall#2 # not this\n" +
                     "f 1 1 2\nf 2 3 4\nusemtl white\nf 4 3 2\nusemtl\nf 4 3 1\n");
  ASSERT_EQ(r.materials.names.size(), 2u);
  EXPECT_EQ(r.materials.names[0].name, "white");
  EXPECT_EQ(r.materials.names[0].location, (Location{6, 8}));
  EXPECT_EQ(r.materials.names[1].name, "red  wall#2");
  EXPECT_EQ(r.materials.of_triangle,
            (std::vector<std::uint32_t>{mesh_no_index, 0, 0, 1, 0, mesh_no_index}));
  EXPECT_EQ(r.mesh.triangles.size(), 6u);
}

TEST(ReadObj, ListsTheLibrariesOfEachLine) {
  const WithMaterials r =
      read_materials("mtllib a.mtl\r\nmtllib b.mtl c.mtl\nmtllib\n" + triangle + "f 1 2 3\n");
  ASSERT_EQ(r.materials.libraries.size(), 2u);
  EXPECT_EQ(r.materials.libraries[0].size(), 1u);
  EXPECT_EQ(r.materials.libraries[0][0].name, "a.mtl");
  ASSERT_EQ(r.materials.libraries[1].size(), 3u);
  EXPECT_EQ(r.materials.libraries[1][1].name, "c.mtl");
  EXPECT_EQ(r.materials.libraries[1][2].name, "b.mtl c.mtl");
  EXPECT_TRUE(r.materials.of_triangle.empty());
}

TEST(ReadObj, MaterialsCountTowardTheLimit) {
  std::string text = triangle + "f 1 2 3\n";
  EXPECT_FALSE(read_materials(text, 100).diagnostics.has_errors());
  for (int i = 0; i < 100; ++i) {
    text += "usemtl m" + std::to_string(i) + "      with    blanks\nf 1 2 3\n";
  }
  const WithMaterials fits = read_materials(text, 100'000);
  EXPECT_EQ(findings(fits.diagnostics), "");
  EXPECT_LT(fits.bytes, 100'000u - 100 * 4);
  EXPECT_THAT(findings(read_materials(text, 5000).diagnostics), HasSubstr("mesh.limit"));
}

TEST(ReadObj, UnknownKeywordsAreReportedOnce) {
  const ReadObj r = read("frob 1\nFROB\nfrob 2\nV 1 2 3\ncurv 0 1 1\n" + triangle + "f 1 2 3\n");
  EXPECT_EQ(findings(r.diagnostics),
            "1:1 mesh.unknown-keyword unknown keyword \"frob\" is skipped\n"
            "2:1 mesh.unknown-keyword unknown keyword \"FROB\" is skipped\n"
            "4:1 mesh.unknown-keyword unknown keyword \"V\" is skipped; did you mean v?\n"
            "5:1 mesh.unknown-keyword curv is skipped: curves and surfaces are not drawn\n");
  EXPECT_EQ(r.mesh.triangles.size(), 1u);
}

TEST(ReadObj, OtherFilesAreRejected) {
  const std::string files[] = {
      test::fixture("rgb.png"),
      test::fixture("rgb.jpg"),
      "<?xml version=\"1.0\"?>\n<scenefile>\n</scenefile>\n",
      "ply\nformat ascii 1.0\nelement vertex 3\n",
      "solid cube\nfacet normal 0 0 1\n",
      std::string(1000, '\0'),
      "\x7f"
      "ELF",
      "{\n}\n",
  };
  for (const std::string& file : files) {
    const ReadObj r = read(file);
    EXPECT_THAT(findings(r.diagnostics), HasSubstr("mesh.not-obj")) << file.substr(0, 20);
    EXPECT_EQ(r.diagnostics.list().size(), 1u);
  }
}

TEST(ReadObj, NothingToDrawIsAWarning) {
  for (const char* text : {"", "\n\n", "# nothing\n", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "o x\n"}) {
    const ReadObj r = read(text);
    EXPECT_THAT(findings(r.diagnostics), HasSubstr("mesh.empty")) << text;
    EXPECT_FALSE(r.diagnostics.has_errors()) << text;
  }
}

TEST(ReadObj, LimitsAreCheckedBeforeReading) {
  const std::string text = square + "f 1 2 4 3\n";
  Limits limits;
  limits.mesh_triangles = 1;
  EXPECT_EQ(findings(read(text, limits).diagnostics),
            "0:0 mesh.limit 2 triangles, and 1 are left of the limit for all meshes\n");
  limits.mesh_triangles = 2;
  EXPECT_EQ(findings(read(text, limits).diagnostics), "");
  limits.mesh_bytes = 4 * 12 + 2 * 12;
  EXPECT_EQ(findings(read(text, limits).diagnostics), "");
  limits.mesh_bytes -= 1;
  EXPECT_THAT(findings(read(text, limits).diagnostics), HasSubstr("mesh.limit it takes"));
}

TEST(ReadObj, ManyErrorsEndTheReading) {
  std::string text = triangle;
  for (int i = 0; i < 100000; ++i) {
    text += "f 1 2 9\n";
  }
  EXPECT_EQ(read(text).diagnostics.count(Severity::error), 100u);
  text = triangle;
  for (int i = 0; i < 1000; ++i) {
    text += "v x 0 0\n";
  }
  EXPECT_EQ(read(text).diagnostics.count(Severity::error), 100u);
}

TEST(ReadObj, UnusedUvsAndNormalsHaveNoIndices) {
  const ReadObj r = read(triangle + "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3\n");
  EXPECT_TRUE(r.mesh.triangle_uvs.empty());
  EXPECT_TRUE(r.mesh.triangle_normals.empty());
  EXPECT_EQ(r.mesh.triangles.size(), 2u);
}

TEST(ReadObj, ManyDistinctUnknownKeywords) {
  std::string text = triangle + "f 1 2 3\n";
  for (int i = 0; i < 100000; ++i) {
    text += fmt::format("k{} 1\n", i);
  }
  EXPECT_EQ(read(text).diagnostics.count(Severity::warning), 100u);
}

double seconds_of(const std::string& text) {
  const double start = cpu_seconds();
  const ReadObj r = read(text);
  EXPECT_FALSE(r.diagnostics.has_errors()) << findings(r.diagnostics);
  return cpu_seconds() - start;
}

std::string grid(int side) {
  std::string text;
  for (int i = 0; i < side * side; ++i) {
    text += fmt::format("v {} {} 0.125\n", i % side, i / side);
  }
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const int a = y * side + x + 1;
      text += fmt::format("f {} {} {} {}\n", a, a + 1, a + side + 1, a + side);
    }
  }
  return text;
}

// A tenth of the limit, because test machines can be slow; quadratic behavior would still fail.
TEST(ReadObj, TimeIsLinear) {
  EXPECT_LT(seconds_of(grid(224)), 2) << "100,000 triangles";
  std::string line = triangle + "f";
  for (int i = 0; i < 300000; ++i) {
    line += " 1 2 3";
  }
  EXPECT_LT(seconds_of(line), 2) << "one face of 900,000 corners";
  std::string errors = triangle + "f";
  for (int i = 0; i < 300000; ++i) {
    errors += " 9";
  }
  const double start = cpu_seconds();
  EXPECT_EQ(read(errors).diagnostics.count(Severity::error), 100u);
  EXPECT_LT(cpu_seconds() - start, 2);
}

// Finding a column far to the right must not scan the line.
TEST(ReadObj, FindingsInALongLine) {
  std::string text = triangle + "f";
  text.append(40'000'000, ' ');
  for (int i = 0; i < 100; ++i) {
    text += " 9";
  }
  const double start = cpu_seconds();
  const ReadObj r = read(text);
  EXPECT_LT(cpu_seconds() - start, 2);
  EXPECT_EQ(r.diagnostics.list().front().location, (Location{4, 40'000'003}));
}

// Reading what was written gives the same mesh.
RC_GTEST_PROP(ReadObjLaw, InvertsWriting, ()) {
  const auto vertices = *rc::gen::inRange(3, 30);
  std::string text;
  std::vector<glm::vec3> positions;
  for (int i = 0; i < vertices; ++i) {
    const auto x = static_cast<float>(*rc::gen::inRange(-1000, 1000)) / 7;
    positions.emplace_back(x, i * i, i);
    text += fmt::format("v {} {} {}\n", x, i * i, i);
  }
  std::vector<Corners> triangles;
  for (int i = 0; i < *rc::gen::inRange(1, 40); ++i) {
    const auto at = [&] { return static_cast<std::uint32_t>(*rc::gen::inRange(0, vertices)); };
    const Corners c = {at(), at(), at()};
    if (c[0] == c[1] || c[1] == c[2] || c[0] == c[2]) {
      continue;
    }
    triangles.push_back(c);
    const bool backwards = *rc::gen::arbitrary<bool>();
    const auto number = [&](std::uint32_t index) {
      return backwards ? static_cast<int>(index) - vertices : static_cast<int>(index) + 1;
    };
    text += fmt::format("f {} {} {}\n", number(c[0]), number(c[1]), number(c[2]));
  }
  const ReadObj r = read(text);
  RC_ASSERT(!r.diagnostics.has_errors());
  RC_ASSERT(r.mesh.positions == positions);
  RC_ASSERT(r.mesh.triangles == triangles);  // y = i * i: no three are collinear
}

}  // namespace
}  // namespace scenefile
