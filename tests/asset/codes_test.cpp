// For every code of the room: an input that causes it, and a similar one that does not.

#include "scenefile/asset/codes.h"

#include "asset/sample_files.h"
#include "scenefile/asset/load_assets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace scenefile {
namespace {

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

enum class Kind { texture, mesh, library };

struct Case {
  const Code* code;
  Kind kind;
  std::string gives;
  std::string near_miss;
};

Diagnostics load(Kind kind, const std::string& bytes, bool missing) {
  LoadOptions options;
  options.limits.mesh_triangles = 3;
  options.limits.mesh_bytes = 2000;
  options.limits.texture_side = 17;
  options.materials = kind == Kind::library;
  const std::vector<FileReference> file = {{"name", {1, 1}}};
  const std::vector<FileReference> none;
  Diagnostics diagnostics;
  load_assets(
      kind == Kind::texture ? file : none, kind == Kind::texture ? none : file,
      [&](const std::string& name) -> Result<std::string> {
        if (kind == Kind::library && name == "name") {
          return three_points + "mtllib a.mtl\nusemtl red\nf 1 2 3\n";
        }
        return missing ? Result<std::string>(Error{"no such file"}) : bytes;
      },
      options, diagnostics);
  return diagnostics;
}

bool gives(const Diagnostics& diagnostics, const Code& code) {
  return std::any_of(diagnostics.list().begin(), diagnostics.list().end(),
                     [&](const Diagnostic& d) { return d.code == &code; });
}

std::vector<Case> cases() {
  const std::string png = test::fixture("rgb.png");
  std::string wide(9, '\0');
  const std::string row(18 * 3, 'x');
  std::string many_materials;
  for (int i = 0; i < 100; ++i) {
    many_materials += "newmtl red" + std::to_string(i) + "\n";
  }
  constexpr Kind lib = Kind::library;
  return {
      {&"texture.undecodable"_code, Kind::texture, png.substr(0, png.size() - 20), png},
      {&"texture.limit"_code, Kind::texture, test::make_png(18, 1, 8, 2, false, {row}), png},
      {&"mesh.unusable"_code, Kind::mesh, three_points + "f 1 2 4\n", three_points + "f 1 2\n"},
      {&"mesh.not-obj"_code, Kind::mesh, png, "# not much\n"},
      {&"mesh.number"_code, Kind::mesh, "v 0 0\n", "v 0 0 0\n"},
      {&"mesh.index"_code, Kind::mesh, three_points + "f 1 2 4\n", three_points + "f 1 2 -3\n"},
      {&"mesh.limit"_code, Kind::mesh, three_points + "f 1 2 3 1 2 3\n",
       three_points + "f 1 2 3 1 2\n"},
      {&"mesh.short-face"_code, Kind::mesh, three_points + "f 1 2\n", three_points + "l 1 2\n"},
      {&"mesh.degenerate"_code, Kind::mesh, three_points + "f 1 2 2\n", three_points + "f 1 2 3\n"},
      {&"mesh.zero-normal"_code, Kind::mesh, "vn 0 0 0\n", "vn 0 0 1e-30\n"},
      {&"mesh.unknown-keyword"_code, Kind::mesh, three_points + "face 1 2 3\n",
       three_points + "g face 1 2 3\n"},
      {&"mesh.empty"_code, Kind::mesh, three_points, three_points + "f 1 2 3\n"},
      {&"mtl.no-material"_code, lib, "Kd 1 0 0\n", "newmtl red\n"},
      {&"mtl.unknown-material"_code, lib, "newmtl Red\n", "newmtl red\n"},
      {&"mtl.duplicate"_code, lib, "newmtl red\nnewmtl red\n", "newmtl red\nnewmtl Red\n"},
      {&"mtl.before-newmtl"_code, lib, "Kd 1 0 0\nnewmtl red\n", "newmtl red\nKd 1 0 0\n"},
      {&"mtl.unknown-keyword"_code, lib, "newmtl red\nkd 1 0 0\n", "newmtl red\nmap_bump 1 0 0\n"},
      {&"mtl.value"_code, lib, "newmtl red\nKd 1 0,5 0\n", "newmtl red\nKd 1 5e-1 0\n"},
      {&"mtl.range"_code, lib, "newmtl red\nKe 1 -1 0\n", "newmtl red\nKe 1 -0 1e9\n"},
      {&"mtl.limit"_code, lib, many_materials, "newmtl red\n"},
      {&"mtl.energy"_code, lib, "newmtl red\nKd .5 .5 .5\nKs .51 0 0\n",
       "newmtl red\nKd .5 .5 .5\nKs .5 0 0\n"},
      {&"mtl.illum"_code, lib, "newmtl red\nillum 3\n", "newmtl red\nillum 7\n"},
      {&"mtl.mirror-ior"_code, lib, "newmtl red\nillum 5\n", "newmtl red\nillum 5\nNi 1.5\n"},
      {&"mtl.opacity"_code, lib, "newmtl red\nd .5\n", "newmtl red\nd 1\nTr 0\n"},
      {&"mtl.map-option"_code, lib, "newmtl red\nmap_Kd -s 2 2 2 a.png\n",
       "newmtl red\nmap_Kd -s 1 1 1 -clamp off a.png\n"},
      {&"mtl.leading-point"_code, lib, "newmtl red\nKd .5 0 0\n", "newmtl red\nKd 0.5 0 0\n"},
  };
}

TEST(AssetCodes, EachIsTriggeredByAnInputAndNotByASimilarOne) {
  std::set<const Code*> seen = {&"texture.missing"_code, &"mesh.missing"_code, &"mtl.missing"_code};
  for (const Case& c : cases()) {
    EXPECT_TRUE(gives(load(c.kind, c.gives, false), *c.code)) << c.code->name;
    EXPECT_FALSE(gives(load(c.kind, c.near_miss, false), *c.code)) << c.code->name;
    seen.insert(c.code);
  }
  for (const auto& [kind, code] : {std::pair(Kind::texture, &"texture.missing"_code),
                                   {Kind::mesh, &"mesh.missing"_code},
                                   {Kind::library, &"mtl.missing"_code}}) {
    EXPECT_TRUE(gives(load(kind, "", true), *code));
    EXPECT_FALSE(gives(load(kind, "", false), *code)) << "an empty file is there";
  }
  for (const Code& code : asset_codes) {
    EXPECT_TRUE(seen.contains(&code)) << code.name;
  }
}

}  // namespace
}  // namespace scenefile
