// For every code of the room: an input that causes it, and a similar one that does not.

#include "scenefile/asset/codes.h"

#include "asset/sample_files.h"
#include "scenefile/asset/load_assets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace scenefile {
namespace {

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

struct Case {
  const Code* code;
  bool mesh;
  std::string gives;
  std::string near_miss;
};

// A texture with empty `bytes` means a missing file.
Diagnostics load(bool mesh, const std::string& bytes, bool missing) {
  LoadOptions options;
  options.limits.mesh_triangles = 3;
  options.limits.texture_side = 17;
  const std::vector<FileReference> file = {{"name", {1, 1}}};
  const std::vector<FileReference> none;
  Diagnostics diagnostics;
  load_assets(
      mesh ? none : file, mesh ? file : none,
      [&](const std::string&) {
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
  return {
      {&texture_undecodable, false, png.substr(0, png.size() - 20), png},
      {&texture_limit, false, test::make_png(18, 1, 8, 2, false, {row}), png},
      {&mesh_unusable, true, three_points + "f 1 2 4\n", three_points + "f 1 2\n"},
      {&mesh_not_obj, true, png, "# not much\n"},
      {&mesh_number, true, "v 0 0\n", "v 0 0 0\n"},
      {&mesh_index, true, three_points + "f 1 2 4\n", three_points + "f 1 2 -3\n"},
      {&mesh_limit, true, three_points + "f 1 2 3 1 2 3\n", three_points + "f 1 2 3 1 2\n"},
      {&mesh_short_face, true, three_points + "f 1 2\n", three_points + "l 1 2\n"},
      {&mesh_degenerate, true, three_points + "f 1 2 2\n", three_points + "f 1 2 3\n"},
      {&mesh_zero_normal, true, "vn 0 0 0\n", "vn 0 0 1e-30\n"},
      {&mesh_unknown_keyword, true, three_points + "face 1 2 3\n", three_points + "g face 1 2 3\n"},
      {&mesh_empty, true, three_points, three_points + "f 1 2 3\n"},
  };
}

TEST(AssetCodes, EachIsTriggeredByAnInputAndNotByASimilarOne) {
  std::set<const Code*> seen = {&texture_missing, &mesh_missing};
  for (const Case& c : cases()) {
    EXPECT_TRUE(gives(load(c.mesh, c.gives, false), *c.code)) << c.code->name;
    EXPECT_FALSE(gives(load(c.mesh, c.near_miss, false), *c.code)) << c.code->name;
    seen.insert(c.code);
  }
  for (const bool mesh : {false, true}) {
    const Code& code = mesh ? mesh_missing : texture_missing;
    EXPECT_TRUE(gives(load(mesh, "", true), code));
    EXPECT_FALSE(gives(load(mesh, "", false), code)) << "an empty file is there";
  }
  for (const Code* code : asset_codes()) {
    EXPECT_EQ(seen.count(code), 1u) << code->name;
  }
  EXPECT_EQ(seen.size(), asset_codes().size());
}

TEST(AssetCodes, AreFitForThePageOfCodes) {
  std::set<std::string_view> names;
  for (const Code* code : asset_codes()) {
    EXPECT_TRUE(names.insert(code->name).second) << code->name;
    EXPECT_TRUE(code->name.substr(0, 8) == "texture." || code->name.substr(0, 5) == "mesh.");
    EXPECT_LT(code->summary.size(), 80u) << code->name;
    EXPECT_FALSE(code->help.empty()) << code->name;
    EXPECT_EQ(code->help.back(), '.') << code->name;
  }
}

}  // namespace
}  // namespace scenefile
