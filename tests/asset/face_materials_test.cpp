// Materials of mesh faces, as load_assets() finds them.

#include "asset/sample_files.h"
#include "scenefile/asset/codes.h"
#include "scenefile/asset/load_assets.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <utility>

namespace scenefile {
namespace {

using test::findings;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Files = std::map<std::string, std::string>;

struct Loaded {
  Assets assets;
  Diagnostics diagnostics;
  std::vector<std::string> opened;

  const MeshMaterials& mesh(std::size_t i = 0) const { return assets.mesh_materials.at(i); }
};

Loaded load(Files files, const std::vector<std::string>& meshes = {"models/a.obj"},
            LoadOptions options = {}, const std::vector<FileReference>& textures = {}) {
  Loaded loaded;
  std::vector<FileReference> references;
  for (const std::string& mesh : meshes) {
    references.push_back({mesh, {1, 1}});
  }
  options.materials = true;
  const FetchFile fetch = [&](const std::string& name) -> Result<std::string> {
    loaded.opened.push_back(name);
    const auto found = files.find(name);
    return found == files.end() ? Result<std::string>(Error{"no such file"}) : found->second;
  };
  loaded.assets = load_assets(textures, references, fetch, options, loaded.diagnostics);
  return loaded;
}

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string mesh_of(const std::string& head, const std::vector<std::string>& names) {
  std::string text = head + corners;
  for (const std::string& name : names) {
    text += "usemtl " + name + "\nf 1 2 3\n";
  }
  return text;
}

std::string finding(const Diagnostic& d) {
  return d.file + ":" + std::to_string(d.location.line) + " " + std::string(d.code->name);
}

TEST(FaceMaterials, AreFoundByName) {
  const Loaded r = load({{"models/a.obj", "mtllib lib/a.mtl\n" + corners + "f 3 2 1\n" +
                                              "usemtl lamp\nf 1 2 3\nusemtl glass\nf 2 3 1\n" +
                                              "usemtl lamp\nf 3 1 2\n"},
                         {"models/lib/a.mtl",
                          "newmtl unused\nKd 1 1 1\nnewmtl glass\nillum 7\nNi 1.5\nTf 0.5 1 1\n"
                          "newmtl lamp\nKe 17 12 4\nKd 0.5 0.5 0.5\nNs 10\n"}});
  EXPECT_EQ(findings(r.diagnostics), "");
  ASSERT_EQ(r.mesh().materials.size(), 2u);
  const FaceMaterial& lamp = r.mesh().materials[0];
  EXPECT_EQ(lamp.name, "lamp");
  EXPECT_EQ(lamp.emission, glm::vec3(17, 12, 4));
  EXPECT_EQ(lamp.diffuse, glm::vec3(.5f));
  EXPECT_EQ(lamp.specular, glm::vec3(0));
  EXPECT_EQ(lamp.shininess, 10);
  EXPECT_EQ(lamp.diffuse_map, no_map);
  EXPECT_EQ(lamp.file, "models/lib/a.mtl");
  EXPECT_EQ(lamp.location, (Location{7, 1}));
  const FaceMaterial& glass = r.mesh().materials[1];
  EXPECT_EQ(glass.illum, 7);
  EXPECT_EQ(glass.ior, 1.5f);
  EXPECT_EQ(glass.transmission, glm::vec3(.5f, 1, 1));
  EXPECT_EQ(glass.diffuse, glm::vec3(0));
  EXPECT_EQ(glass.shininess, 1);
  EXPECT_THAT(r.mesh().of_triangle, ElementsAre(mesh_no_index, 0, 1, 0));
  EXPECT_THAT(triangles_of_materials(r.mesh()), ElementsAre(2, 1));
  EXPECT_TRUE(has_emissive_faces(r.assets));
}

TEST(FaceMaterials, AreReadOnlyIfWanted) {
  const Files files{{"a.obj", mesh_of("mtllib a.mtl\n", {"red"})}};
  int opened = 0;
  const FetchFile fetch = [&](const std::string& name) -> Result<std::string> {
    ++opened;
    return files.at(name);
  };
  Diagnostics diagnostics;
  const Assets assets =
      load_assets({}, std::vector<FileReference>{{"a.obj", {1, 1}}}, fetch, {}, diagnostics);
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(findings(diagnostics), "");
  EXPECT_TRUE(assets.mesh_materials.empty());
  EXPECT_FALSE(has_emissive_faces(assets));
}

TEST(FaceMaterials, EachLibraryIsReadAndJudgedOnce) {
  const Loaded r = load({{"m/a.obj", mesh_of("mtllib l.mtl\n", {"red", "red"})},
                         {"m/b.obj", mesh_of("mtllib l.mtl\nmtllib l.mtl\n", {"red"})},
                         {"m/l.mtl", "newmtl red\nKd 1 0 0\nKs 1 0 0\nfrob 1\n"}},
                        {"m/a.obj", "m/b.obj"});
  EXPECT_THAT(r.opened, ElementsAre("m/a.obj", "m/l.mtl", "m/b.obj"));
  ASSERT_EQ(r.diagnostics.list().size(), 2u);
  EXPECT_EQ(finding(r.diagnostics.list()[0]), "m/l.mtl:4 mtl.unknown-keyword");
  EXPECT_EQ(finding(r.diagnostics.list()[1]), "m/l.mtl:1 mtl.energy");
  EXPECT_EQ(r.mesh(0).materials.size(), 1u);
  EXPECT_EQ(r.mesh(1).materials.size(), 1u);
  ASSERT_EQ(r.assets.mesh_references.size(), 1u);
  EXPECT_EQ(r.assets.mesh_references[0].kind, AssetKind::library);
  EXPECT_EQ(r.assets.mesh_references[0].file.name, "m/l.mtl");
  EXPECT_EQ(r.assets.mesh_references[0].from, "m/a.obj");
}

TEST(FaceMaterials, FilesOfAMeshAreFoundWithoutReadingIt) {
  const FetchFile fetch = [](const std::string& name) -> Result<std::string> {
    return name == "m/a.mtl" ? Result<std::string>("newmtl a\nmap_Kd a.png\nmap_Ke b.png\n")
                             : Result<std::string>(Error{"no such file"});
  };
  // Each name once; words of comments and of other statements are none. Linear in the text: this
  // would take minutes otherwise.
  std::string obj = "# mtllib c.mtl\no mtllib\n  mtllib \\\n a.mtl b.mtl\nv 0 0 0\nmtllib a.mtl\n";
  for (int i = 0; i < 200'000; ++i) {
    obj += "mtllib \\\n";
  }
  std::vector<std::string> names;
  for (const MeshReference& file : files_named_by_mesh("m/m.obj", obj, fetch, {})) {
    names.push_back(fmt::format("{} {}", word_of(file.kind), file.file.name));
  }
  ASSERT_GE(names.size(), 4u);
  names.resize(4);  // then the last statement, read as names
  EXPECT_THAT(names, ElementsAre("library m/a.mtl", "texture m/a.png", "texture m/b.png",
                                 "library m/b.mtl"));
}

TEST(FaceMaterials, TheFirstReadableNameOfALineCounts) {
  const Files files{
      {"a.obj", mesh_of("mtllib no.mtl b.mtl c.mtl\nmtllib d.mtl\nmtllib my lib.mtl\n",
                        {"b", "c", "d", "spaced"})},
      {"b.mtl", "newmtl b\nKd 0.25 0 0\n"},
      {"c.mtl", "newmtl c\n"},
      {"d.mtl", "newmtl b\nKd 0.75 0 0\nnewmtl d\n"},
      {"my lib.mtl", "newmtl spaced\n"}};
  const Loaded r = load(files, {"a.obj"});
  ASSERT_EQ(r.diagnostics.list().size(), 1u);
  EXPECT_EQ(finding(r.diagnostics.list()[0]), "a.obj:9 mtl.unknown-material");
  EXPECT_THAT(r.mesh().of_triangle, ElementsAre(0, mesh_no_index, 1, 2));
  EXPECT_EQ(r.mesh().materials[0].diffuse.x, .25f);
}

TEST(FaceMaterials, WithoutALibraryFacesHaveTheMaterialOfTheObject) {
  for (const std::string head : {"mtllib no.mtl\n", "\n"}) {
    const Loaded r = load({{"models/a.obj", mesh_of(head, {"red", "blue"})}});
    ASSERT_EQ(r.diagnostics.list().size(), 1u);
    const Diagnostic& d = r.diagnostics.list()[0];
    EXPECT_EQ(d.code, &"mtl.missing"_code);
    EXPECT_EQ(d.severity, Severity::warning);
    EXPECT_EQ(d.file, "models/a.obj");
    EXPECT_EQ(d.location.line, head == "\n" ? 5u : 1u);
    EXPECT_TRUE(r.mesh().materials.empty());
    EXPECT_TRUE(r.mesh().of_triangle.empty());
    EXPECT_EQ(r.assets.meshes[0].triangles.size(), 2u);
  }
}

TEST(FaceMaterials, AnUnusedLibraryIsNotMissed) {
  const Loaded r = load({{"models/a.obj", "mtllib no.mtl\n" + corners + "f 1 2 3\nusemtl red\n"}});
  EXPECT_EQ(findings(r.diagnostics), "");
  EXPECT_TRUE(r.mesh().of_triangle.empty());
}

TEST(FaceMaterials, AnUnknownNameIsReportedOnce) {
  const Loaded r = load({{"a.obj", mesh_of("mtllib a.mtl\n", {"whit", "red", "whit"})},
                         {"a.mtl", "newmtl white\nnewmtl red\n"}},
                        {"a.obj"});
  EXPECT_EQ(findings(r.diagnostics),
            "5:8 mtl.unknown-material no library defines the material \"whit\"; its faces have the "
            "material of the object; did you mean \"white\"?\n");
  EXPECT_THAT(r.mesh().of_triangle, ElementsAre(mesh_no_index, 0, mesh_no_index));
}

TEST(FaceMaterials, LibrariesMayComeAfterTheFaces) {
  const Loaded r = load(
      {{"a.obj", mesh_of("", {"red"}) + "mtllib a.mtl\n"}, {"a.mtl", "newmtl red\nKd 1 0 0\n"}},
      {"a.obj"});
  EXPECT_EQ(findings(r.diagnostics), "");
  EXPECT_EQ(r.mesh().materials.size(), 1u);
}

TEST(FaceMaterials, NamesAreRelativeToTheMesh) {
  const std::pair<std::string, std::string> cases[] = {
      {"a.mtl", "x/y/a.mtl"},           {"./z/a.mtl", "x/y/./z/a.mtl"},
      {"..\\a.mtl", "x/y/..\\a.mtl"},   {"/etc/a.mtl", "/etc/a.mtl"},
      {"C:\\m\\a.mtl", "C:\\m\\a.mtl"}, {":/a.mtl", ":/a.mtl"}};
  for (const auto& [written, name] : cases) {
    const Loaded r = load({{"x/y/a.obj", mesh_of("mtllib " + written + "\n", {"red"})},
                           {name, "newmtl red\nmap_Kd " + written + "\n"}},
                          {"x/y/a.obj"});
    EXPECT_EQ(r.mesh().materials.size(), 1u) << written;
    ASSERT_EQ(r.assets.mesh_references.size(), 2u) << written;
    EXPECT_EQ(r.assets.mesh_references[1].file.name, name);
  }
  const Loaded here =
      load({{"a.obj", mesh_of("mtllib a.mtl\n", {"red"})}, {"a.mtl", "newmtl red"}}, {"a.obj"});
  EXPECT_EQ(here.mesh().materials.size(), 1u);
}

TEST(FaceMaterials, MapsFollowTheTexturesOfTheScene) {
  const Files files{{"m/a.obj", mesh_of("mtllib a.mtl\n", {"wood", "glow", "lost"})},
                    {"m/a.mtl",
                     "newmtl wood\nmap_Kd rgb.png\nnewmtl glow\nKe 2 2 2\nmap_Ke gray.png\n"
                     "map_Kd rgb.png\nKd 0.5 0 0\nnewmtl lost\nmap_Ks no.png\n"},
                    {"m/rgb.png", test::fixture("rgb.png")},
                    {"m/gray.png", test::fixture("gray.png")},
                    {"t.png", test::fixture("rgb.png")}};
  const std::vector<FileReference> textures{{"t.png", {1, 1}}, {"m/gray.png", {2, 1}}};
  const Loaded r = load(files, {"m/a.obj"}, {}, textures);
  ASSERT_EQ(r.assets.textures.size(), 4u);
  const std::vector<FaceMaterial>& m = r.mesh().materials;
  EXPECT_EQ(m[0].diffuse_map, 2u);
  EXPECT_EQ(m[0].diffuse, glm::vec3(1)) << "the texture alone";
  EXPECT_EQ(m[1].diffuse_map, 2u);
  EXPECT_EQ(m[1].diffuse, glm::vec3(.5f, 0, 0));
  EXPECT_EQ(m[1].emission_map, 1u) << "the scene has it too";
  EXPECT_EQ(m[2].specular_map, 3u);
  EXPECT_FALSE(r.assets.textures[2].empty());
  EXPECT_TRUE(r.assets.textures[3].empty());
  ASSERT_EQ(r.diagnostics.list().size(), 1u);
  const Diagnostic& d = r.diagnostics.list()[0];
  EXPECT_EQ(finding(d), "m/a.mtl:9 texture.missing");
  EXPECT_EQ(d.location.column, 8u);
  EXPECT_THAT(d.message, HasSubstr("texture \"m/no.png\": no such file; shading with the color"));

  LoadOptions without;
  without.textures = false;
  const Loaded bare = load(files, {"m/a.obj"}, without, textures);
  EXPECT_EQ(bare.assets.textures.size(), 4u);
  EXPECT_EQ(findings(bare.diagnostics), "");
}

TEST(FaceMaterials, ABrokenMeshHasNone) {
  const Loaded r = load({{"models/a.obj", mesh_of("mtllib a.mtl\n", {"red"}) + "f 1 2 9\n"}});
  EXPECT_TRUE(r.diagnostics.has_errors());
  EXPECT_TRUE(r.mesh().materials.empty());
  EXPECT_EQ(r.opened.size(), 1u);
}

TEST(FaceMaterials, CountTowardTheLimitOfMeshes) {
  std::vector<std::string> names;
  std::string library;
  for (int i = 0; i < 50; ++i) {
    names.push_back(fmt::format("m{}", i));
    library += "newmtl " + names.back() + "\n";
  }
  const Files files{{"a.obj", mesh_of("mtllib a.mtl\n", names)}, {"a.mtl", library}};
  LoadOptions options;
  options.limits.mesh_bytes = 25'000;
  const Loaded r = load(files, {"a.obj"}, options);
  EXPECT_FALSE(r.diagnostics.has_errors());
  EXPECT_THAT(findings(r.diagnostics), HasSubstr("mtl.limit"));
  EXPECT_LT(r.mesh().materials.size(), 50u);
  EXPECT_EQ(r.assets.meshes[0].triangles.size(), 50u);
}

}  // namespace
}  // namespace scenefile
