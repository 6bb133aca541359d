#include "scenefile/asset/load_assets.h"

#include "asset/sample_files.h"
#include "scenefile/asset/codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

namespace scenefile {
namespace {

using test::findings;
using ::testing::HasSubstr;

// An in-memory folder that counts how often each file is opened.
class Folder {
 public:
  std::map<std::string, std::string> files;
  std::map<std::string, int> opened;

  FetchFile fetch() {
    return [this](const std::string& name) -> Result<std::string> {
      ++opened[name];
      const auto found = files.find(name);
      if (found == files.end()) {
        return Error{"no such file in scenes, scenes/image"};
      }
      return found->second;
    };
  }
};

const std::string good_mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(LoadAssets, WithoutAWayToOpenFilesAllAreMissing) {
  Diagnostics diagnostics;
  const std::vector<FileReference> textures = {{"a.png", {1, 2}}};
  const std::vector<FileReference> meshes = {{"m.obj", {3, 4}}};
  const Assets assets = load_assets(textures, meshes, {}, {}, diagnostics);
  EXPECT_EQ(assets.textures.size(), 1U);
  EXPECT_EQ(diagnostics.count(Severity::warning), 1U);
  EXPECT_EQ(diagnostics.count(Severity::error), 1U);
}

TEST(LoadAssets, AFileLargerThanAllowedIsALimit) {
  const FetchFile fetch = [](const std::string&) { return Error{"larger", ErrorKind::limit}; };
  Diagnostics diagnostics;
  load_assets(std::vector<FileReference>{{"a.png", {1, 2}}},
              std::vector<FileReference>{{"m.obj", {3, 4}}}, fetch, {}, diagnostics);
  ASSERT_EQ(diagnostics.list().size(), 2u);
  EXPECT_EQ(diagnostics.list()[0].code, &"texture.limit"_code);
  EXPECT_EQ(diagnostics.list()[1].code, &"mesh.limit"_code);
}

TEST(LoadAssets, EachFileOnceAtItsIndex) {
  Folder folder;
  folder.files = {{"a.png", test::fixture("rgb.png")},
                  {"b.jpg", test::fixture("gray.jpg")},
                  {"m.obj", good_mesh},
                  {"n.obj", good_mesh + "f 1 3 2\n"}};
  const std::vector<FileReference> textures = {{"a.png", {3, 4}}, {"b.jpg", {5, 6}}};
  const std::vector<FileReference> meshes = {{"m.obj", {7, 8}}, {"n.obj", {9, 1}}};
  Diagnostics diagnostics;
  const Assets assets = load_assets(textures, meshes, folder.fetch(), {}, diagnostics);
  EXPECT_EQ(findings(diagnostics), "");
  ASSERT_EQ(assets.textures.size(), 2u);
  ASSERT_EQ(assets.meshes.size(), 2u);
  EXPECT_EQ(test::color_at(assets.textures[0], 1, 0)[2], 255);
  EXPECT_EQ(assets.meshes[1].triangles.size(), 2u);
  for (const auto& [name, times] : folder.opened) {
    EXPECT_EQ(times, 1) << name;
  }
}

TEST(LoadAssets, ATextureThatCannotBeUsedIsAWarning) {
  Folder folder;
  folder.files = {{"bad.png", "this is not an image"}, {"good.png", test::fixture("rgb.png")}};
  const std::vector<FileReference> textures = {
      {"gone.png", {3, 4}}, {"bad.png", {5, 6}}, {"good.png", {7, 8}}};
  Diagnostics diagnostics;
  const Assets assets = load_assets(textures, {}, folder.fetch(), {}, diagnostics);
  EXPECT_EQ(findings(diagnostics),
            "3:4 texture.missing texture \"gone.png\": no such file in scenes, scenes/image; "
            "shading with the diffuse color\n"
            "5:6 texture.undecodable texture \"bad.png\": cannot decode: this is not a PNG, JPEG, "
            "GIF, TGA or BMP image; shading with the diffuse color\n");
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_TRUE(assets.textures[0].empty());
  EXPECT_TRUE(assets.textures[1].empty());
  EXPECT_FALSE(assets.textures[2].empty());
}

TEST(LoadAssets, TheTextureLimitAppliesToTheTotal) {
  Folder folder;
  folder.files = {{"a.png", test::fixture("rgb.png")}, {"b.png", test::fixture("rgba.png")}};
  LoadOptions options;
  options.limits.texture_bytes = 3 * 17 * 11 + 100;
  Diagnostics diagnostics;
  const std::vector<FileReference> textures = {{"a.png", {1, 1}}, {"b.png", {2, 1}}};
  const Assets assets = load_assets(textures, {}, folder.fetch(), options, diagnostics);
  EXPECT_FALSE(assets.textures[0].empty());
  EXPECT_TRUE(assets.textures[1].empty());
  EXPECT_THAT(findings(diagnostics), HasSubstr("2:1 texture.limit texture \"b.png\""));
}

// Textures and findings with a limit, decoded sequentially or not.
std::pair<std::vector<Texture>, std::string> load_with(std::uint64_t limit,
                                                       const ForEach& for_each) {
  Folder folder;
  folder.files = {{"a.png", test::fixture("rgb.png")},
                  {"bad.png", "this is not an image"},
                  {"cut.png", test::fixture("rgb.png").substr(0, 200)},
                  {"b.png", test::fixture("rgba.png")},
                  {"c.jpg", test::fixture("gray.jpg")}};
  const std::vector<FileReference> textures = {{"a.png", {1, 1}},   {"gone.png", {2, 1}},
                                               {"bad.png", {3, 1}}, {"cut.png", {4, 1}},
                                               {"b.png", {5, 1}},   {"c.jpg", {6, 1}}};
  LoadOptions options;
  options.limits.texture_bytes = limit;
  options.for_each = for_each;
  Diagnostics diagnostics;
  Assets assets = load_assets(textures, {}, folder.fetch(), options, diagnostics);
  return {std::move(assets.textures), findings(diagnostics)};
}

TEST(LoadAssets, TheOrderOfDecodingShowsNowhere) {
  std::size_t together = 0;
  const ForEach backward = [&](std::size_t count, const std::function<void(std::size_t)>& work) {
    together = std::max(together, count);
    for (std::size_t i = count; i-- > 0;) {
      work(i);
    }
  };
  for (const std::uint64_t limit : {100, 600, 1100, 1200, 1700, 2300, 100'000'000}) {
    const auto [expected, expected_findings] = load_with(limit, {});
    const auto [textures, found] = load_with(limit, backward);
    EXPECT_EQ(found, expected_findings) << limit;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(textures[i].rgb, expected[i].rgb) << limit << ' ' << i;
    }
  }
  EXPECT_EQ(together, 6u);
}

TEST(LoadAssets, AMeshThatCannotBeUsedIsAnErrorOrAWarning) {
  Folder folder;
  folder.files = {{"bad.obj", good_mesh + "f 1 2 9\nf 1 2 x\n"}};
  const std::vector<FileReference> meshes = {{"gone.obj", {3, 4}}, {"bad.obj", {5, 6}}};
  for (const bool allowed : {false, true}) {
    LoadOptions options;
    options.allow_missing = allowed;
    Diagnostics diagnostics;
    const Assets assets = load_assets({}, meshes, folder.fetch(), options, diagnostics);
    EXPECT_EQ(diagnostics.has_errors(), !allowed);
    ASSERT_EQ(diagnostics.list().size(), 4u) << findings(diagnostics);
    const Severity severity = allowed ? Severity::warning : Severity::error;
    for (const Diagnostic& finding : diagnostics.list()) {
      EXPECT_EQ(finding.severity, severity);
    }
    const Diagnostic& inside = diagnostics.list()[1];
    EXPECT_EQ(inside.file, "bad.obj");
    EXPECT_EQ(inside.location, (Location{5, 7}));
    const Diagnostic& summary = diagnostics.list()[3];
    EXPECT_EQ(summary.code, &"mesh.unusable"_code);
    EXPECT_EQ(summary.file, "");
    EXPECT_EQ(summary.location, (Location{5, 6}));
    EXPECT_THAT(summary.message, HasSubstr("mesh \"bad.obj\": 2 errors in the file"));
    EXPECT_TRUE(assets.meshes[1].triangles.empty());
  }
}

TEST(LoadAssets, WarningsInsideAMeshDoNotSpoilIt) {
  Folder folder;
  folder.files = {{"m.obj", good_mesh + "f 1 2\n"}};
  const std::vector<FileReference> meshes = {{"m.obj", {3, 4}}};
  Diagnostics diagnostics;
  const Assets assets = load_assets({}, meshes, folder.fetch(), {}, diagnostics);
  EXPECT_EQ(assets.meshes[0].triangles.size(), 1u);
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].file, "m.obj");
}

TEST(LoadAssets, TheMeshLimitAppliesToTheTotal) {
  Folder folder;
  folder.files = {{"m.obj", good_mesh}, {"n.obj", good_mesh}};
  LoadOptions options;
  options.limits.mesh_triangles = 1;
  const std::vector<FileReference> meshes = {{"m.obj", {3, 4}}, {"n.obj", {5, 6}}};
  Diagnostics diagnostics;
  const Assets assets = load_assets({}, meshes, folder.fetch(), options, diagnostics);
  EXPECT_EQ(assets.meshes[0].triangles.size(), 1u);
  EXPECT_TRUE(assets.meshes[1].triangles.empty());
  EXPECT_THAT(findings(diagnostics), HasSubstr("mesh.limit 1 triangles, and 0 are left"));
}

TEST(LoadAssets, WithoutTexturesNothingIsOpened) {
  Folder folder;
  LoadOptions options;
  options.textures = false;
  const std::vector<FileReference> textures = {{"gone.png", {3, 4}}};
  Diagnostics diagnostics;
  const Assets assets = load_assets(textures, {}, folder.fetch(), options, diagnostics);
  EXPECT_EQ(assets.textures.size(), 1u);
  EXPECT_TRUE(folder.opened.empty());
  EXPECT_TRUE(diagnostics.list().empty());
}

// A file name cannot forge a line or send an escape sequence to the terminal.
TEST(LoadAssets, NamesAreEscaped) {
  Folder folder;
  const std::vector<FileReference> textures = {{"a\n\x1b[31m.png", {3, 4}}};
  Diagnostics diagnostics;
  load_assets(textures, {}, folder.fetch(), {}, diagnostics);
  EXPECT_EQ(diagnostics.list()[0].message.find('\n'), std::string::npos);
  EXPECT_EQ(diagnostics.list()[0].message.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace scenefile
