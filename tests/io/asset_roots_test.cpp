#include "scenefile/io/asset_roots.h"

#include "io/temp_folder.h"
#include "scenefile/io/asset_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace scenefile {

namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing_support::TempFolder;

// The roots of a scene at home/scenes/s.xml; `given` are folders below home.
AssetRoots roots_of(const TempFolder& home, const std::vector<std::string>& given = {}) {
  AssetRootsOptions options;
  options.scene_path = home.path("scenes/s.xml");
  for (const std::string& root : given) {
    options.asset_roots.push_back(home.path(root));
  }
  return AssetRoots(std::move(options));
}

struct Layout : ::testing::Test {
  Layout() { home.write("scenes/s.xml"); }

  // Expects the name to resolve to the file by the rule.
  void finds(AssetRoots& roots, const std::string& name, const std::string& file, AssetRule rule) {
    const ResolvedAsset asset = roots.resolve(name);
    EXPECT_EQ(asset.path, home.path(file)) << name << ": " << asset.error;
    EXPECT_EQ(rule_text(asset.rule), rule_text(rule)) << name;
    EXPECT_EQ(asset.error, "");
    const Result<std::string> bytes = roots.read(name);
    ASSERT_EQ(error_text(bytes), "");
    EXPECT_EQ(*bytes, home.read(file));
  }
  void finds(const std::string& name, const std::string& file, AssetRule rule) {
    AssetRoots roots = roots_of(home);
    finds(roots, name, file, rule);
  }
  // Expects that nothing is found; returns the reason.
  std::string misses(AssetRoots& roots, const std::string& name) {
    const ResolvedAsset asset = roots.resolve(name);
    EXPECT_EQ(asset.path, "") << name;
    EXPECT_EQ(asset.rule, AssetRule::not_found) << name;
    EXPECT_THAT(asset.error, Not(IsEmpty())) << name;
    EXPECT_EQ(error_text(roots.read(name)), asset.error);
    std::string lines = asset.error;
    for (const std::string& note : asset.notes) {
      lines += "\n" + note;
    }
    return lines;
  }
  std::string misses(const std::string& name) {
    AssetRoots roots = roots_of(home);
    return misses(roots, name);
  }

  TempFolder home;
};

TEST_F(Layout, NextToTheScene) {
  home.write("scenes/a.png", "a");
  home.write("scenes/sub/b.png", "b");
  finds("a.png", "scenes/a.png", AssetRule::scene_folder);
  finds("./sub/b.png", "scenes/sub/b.png", AssetRule::scene_folder);
  finds("sub/../a.png", "scenes/a.png", AssetRule::scene_folder);
}

TEST_F(Layout, InTheParentOnlyInTheCoursesFolders) {
  for (const std::string folder :
       {"image", "images", "texture", "textures", "mesh", "meshes", "model", "models"}) {
    home.write(folder + "/" + folder + ".png", folder);
    finds(folder + "/" + folder + ".png", folder + "/" + folder + ".png", AssetRule::scene_parent);
  }
  home.write("secret/key.pem");
  home.write("loose.png");
  misses("secret/key.pem");
  misses("loose.png");
}

TEST_F(Layout, UpAndIntoASiblingFolder) {
  home.write("image/a.png");
  home.write("secret/key.pem");
  finds("../image/a.png", "image/a.png", AssetRule::scene_folder);
  misses("../secret/key.pem");
  misses("../image/../secret/key.pem");
}

TEST_F(Layout, AbsoluteOnlyInsideARoot) {
  const std::string inside = home.write("scenes/a.png");
  const std::string outside = home.write("secret/key.pem");
  finds(inside, "scenes/a.png", AssetRule::absolute);
  misses(outside);
  misses("/etc/passwd");
}

TEST_F(Layout, TheEndOfAWrittenPath) {
  home.write("scenes/image/a.png");
  home.write("textures/b.png");
  home.write("given/deep/c.png");
  finds("/course/cs123/data/image/a.png", "scenes/image/a.png", AssetRule::path_suffix);
  finds("scenefiles/illuminate/textures/b.png", "textures/b.png", AssetRule::path_suffix);
  AssetRoots roots = roots_of(home, {"given"});
  finds(roots, "/Users/me/deep/c.png", "given/deep/c.png", AssetRule::path_suffix);
  finds(roots, "file:src/../../../deep/c.png", "given/deep/c.png", AssetRule::path_suffix);
}

TEST_F(Layout, TheLongestEndWins) {
  home.write("scenes/a.png", "short");
  home.write("scenes/image/a.png", "long");
  finds("/course/image/a.png", "scenes/image/a.png", AssetRule::path_suffix);
}

TEST_F(Layout, SpellingsOfOtherSystems) {
  home.write("scenes/Resources/marble.png");
  finds("Resources\\marble.png", "scenes/Resources/marble.png", AssetRule::scene_folder);
  finds("D:\\Projects\\Resources\\marble.png", "scenes/Resources/marble.png",
        AssetRule::path_suffix);
  finds("C:/Resources/marble.png", "scenes/Resources/marble.png", AssetRule::path_suffix);
  finds("\\\\server\\share\\Resources\\marble.png", "scenes/Resources/marble.png",
        AssetRule::path_suffix);
  finds(":/Resources/marble.png", "scenes/Resources/marble.png", AssetRule::path_suffix);
  finds("file:Resources/marble.png", "scenes/Resources/marble.png", AssetRule::scene_folder);
  finds("file://" + home.path("scenes/Resources/marble.png"), "scenes/Resources/marble.png",
        AssetRule::absolute);
}

TEST_F(Layout, AssetRootsInTheirOrder) {
  home.write("one/a.png", "1");
  home.write("two/a.png", "2");
  home.write("two/b.png", "3");
  AssetRoots roots = roots_of(home, {"nosuch", "one", "two"});
  finds(roots, "a.png", "one/a.png", AssetRule::asset_root);
  finds(roots, "b.png", "two/b.png", AssetRule::asset_root);
}

TEST_F(Layout, OnlyTheNameIfUnique) {
  home.write("scenes/x/y/a.png");
  home.write("image/deep/b.png");
  finds("elsewhere/a.png", "scenes/x/y/a.png", AssetRule::base_name);
  finds("b.png", "image/deep/b.png", AssetRule::base_name);
  home.write("scenes/z/a.png");
  EXPECT_THAT(misses("elsewhere/a.png"), HasSubstr("2 files have its name"));
}

TEST_F(Layout, IgnoringCaseIsTriedLast) {
  home.write("scenes/image/Wood.PNG", "upper");
  finds("image/wood.png", "scenes/image/Wood.PNG", AssetRule::path_suffix);
  finds("other/WOOD.png", "scenes/image/Wood.PNG", AssetRule::base_name);
  home.write("scenes/image/wood.png", "exact");
  finds("image/wood.png", "scenes/image/wood.png", AssetRule::scene_folder);
  finds("other/wood.png", "scenes/image/wood.png", AssetRule::base_name);
}

TEST_F(Layout, TheSearchIsFourLevelsDeepAndSkipsHiddenFolders) {
  home.write("scenes/1/2/3/near.png");
  home.write("scenes/1/2/3/4/far.png");
  home.write("scenes/.git/hidden.png");
  finds("q/near.png", "scenes/1/2/3/near.png", AssetRule::base_name);
  misses("q/far.png");
  misses("q/hidden.png");
}

TEST_F(Layout, ALargeFolderIsNotSearched) {
  for (const std::string name : {"a", "b", "x/c", "x/d"}) {
    home.write("large/" + name);
  }
  home.write("small/a");
  const std::vector<std::string> roots{home.path("large"), home.path("small")};
  const AssetIndex all(roots, 5);  // four files and a folder
  EXPECT_EQ(all.find("a").size(), 2U);
  EXPECT_THAT(all.skipped(), IsEmpty());
  const AssetIndex some(roots, 4);
  EXPECT_THAT(some.find("a"), ::testing::ElementsAre(home.path("small/a")));
  EXPECT_THAT(some.skipped(), ::testing::ElementsAre(home.path("large")));
}

TEST_F(Layout, LinksAreCheckedByTheirTarget) {
  home.write("secret/key.pem");
  home.write("scenes/sub/a.png");
  ASSERT_EQ(::symlink("../secret/key.pem", home.path("scenes/link.png").c_str()), 0);
  ASSERT_EQ(::symlink("../secret", home.path("scenes/folder").c_str()), 0);
  ASSERT_EQ(::symlink("sub/a.png", home.path("scenes/inner.png").c_str()), 0);
  ASSERT_EQ(::symlink("secret", home.path("image").c_str()), 0);
  misses("link.png");
  misses("folder/key.pem");
  misses("image/key.pem");
  finds("inner.png", "scenes/sub/a.png", AssetRule::scene_folder);
}

// The links are in the roots, and following them would reveal what is outside.
TEST_F(Layout, ALinkThatLeadsOutIsNamedWhetherOrNotItsTargetExists) {
  home.write("secret/key.pem");
  const auto link = [&](const char* target, const char* at) {
    ASSERT_EQ(::symlink(target, home.path("scenes/" + std::string(at)).c_str()), 0);
  };
  link("../secret/key.pem", "there");
  link("../secret/gone.pem", "gone");
  link("/none/at/all", "none");
  link("../secret", "folder");
  link("there", "chain");
  link("missing", "inside");
  link("loop", "loop");
  const std::string says =
      " is a link that leads out of the folders that may be read\n"
      "files elsewhere need --asset-root DIR or --allow-outside";
  for (const std::string name : {"there", "gone", "none"}) {
    EXPECT_EQ(misses(name), name + says);
  }
  EXPECT_EQ(misses("chain"), "there" + says);
  EXPECT_EQ(misses("folder/key.pem"), "folder" + says);
  EXPECT_EQ(misses("folder/gone.pem"), "folder" + says);
  EXPECT_THAT(misses("inside"), HasSubstr("no such file\nlooked for inside\n"));
  EXPECT_THAT(misses("loop"), HasSubstr("no such file\nlooked for loop\n"));
}

TEST_F(Layout, OnlyRegularFiles) {
  std::filesystem::create_directories(home.path("scenes/dir.png"));
  ASSERT_EQ(::mkfifo(home.path("scenes/pipe.png").c_str(), 0600), 0);
  ASSERT_EQ(::symlink("/dev/zero", home.path("scenes/zero.png").c_str()), 0);
  EXPECT_THAT(misses("dir.png"), HasSubstr("is a directory"));
  EXPECT_THAT(misses("pipe.png"), HasSubstr("is a pipe"));
  misses("zero.png");
  misses("/dev/stdin");
}

TEST_F(Layout, InvalidFileNames) {
  EXPECT_THAT(misses(""), HasSubstr("empty"));
  EXPECT_THAT(misses("http://example.com/a.png"), HasSubstr("URL"));
  EXPECT_THAT(misses("HTTPS://example.com/a.png"), HasSubstr("URL"));
  EXPECT_THAT(misses("data:image/png;base64,AAAA"), HasSubstr("URL"));
  EXPECT_THAT(misses(std::string("a\0b", 3)), HasSubstr("zero byte"));
  EXPECT_THAT(misses(std::string(5000, 'a')), HasSubstr("longer"));
  misses("..");
  misses("/");
  misses("file:");
}

TEST_F(Layout, ANameWithAColonIsAName) {
  home.write("scenes/odd:name.png");
  finds("odd:name.png", "scenes/odd:name.png", AssetRule::scene_folder);
}

TEST_F(Layout, OutsideOnDemand) {
  home.write("secret/key.pem");
  home.write("loose.png");
  AssetRootsOptions options;
  options.scene_path = home.path("scenes/s.xml");
  options.allow_outside = true;
  AssetRoots roots(options);
  finds(roots, home.path("secret/key.pem"), "secret/key.pem", AssetRule::absolute);
  finds(roots, "../secret/key.pem", "secret/key.pem", AssetRule::scene_folder);
  finds(roots, "loose.png", "loose.png", AssetRule::scene_parent);
}

TEST_F(Layout, TheLikeliestOfSeveralFilesWithTheName) {
  home.write("scenes/x/image/Wood.png", "tail");
  home.write("scenes/y/wood.png", "exact");
  finds("old/Image/wood.png", "scenes/x/image/Wood.png", AssetRule::path_suffix);
  finds("old/other/wood.png", "scenes/y/wood.png", AssetRule::base_name);
  home.write("scenes/z/IMAGE/Wood.png");
  EXPECT_THAT(misses("old/Image/wood.png"), HasSubstr("2 files have its name"));
}

TEST_F(Layout, StandardInputHasOnlyTheGivenRoots) {
  home.write("given/a.png");
  AssetRootsOptions options;
  options.scene_path = "-";
  AssetRoots none(options);
  EXPECT_THAT(misses(none, "a.png"), HasSubstr("no folder to search"));
  options.asset_roots = {home.path("given")};
  AssetRoots roots(options);
  finds(roots, "a.png", "given/a.png", AssetRule::asset_root);
}

TEST_F(Layout, TheMessageDoesNotRevealFilesOutside) {
  home.write("secret/key.pem");
  const std::string there = misses(home.path("secret/key.pem"));
  std::string absent = misses(home.path("secret/kex.pem"));
  for (std::size_t at = 0; (at = absent.find("kex", at)) != std::string::npos;) {
    absent.replace(at, 3, "key");
  }
  EXPECT_EQ(there, absent);
}

TEST_F(Layout, AMissNamesTheFileThatWasProbablyMeant) {
  home.write("scenes/parts/Roof.obj");
  home.write("scenes/walls.png");
  EXPECT_THAT(misses("models/rof.obj"), HasSubstr("no such file\ndid you mean parts/Roof.obj?\n"));
  EXPECT_THAT(misses("walls.png "), HasSubstr("no such file\ndid you mean walls.png?\n"));
  for (const char* const other : {"rof.png", "a.obj", "roofs-and-walls.obj"}) {
    EXPECT_THAT(misses(other), Not(HasSubstr("did you mean"))) << other;
  }
}

TEST_F(Layout, ProbableFilesAreInsideTheRoots) {
  home.write("secret/roof.obj");
  home.write("secret/wall.obj");
  ASSERT_EQ(::symlink(home.path("secret/wall.obj").c_str(), home.path("scenes/wall.obj").c_str()),
            0);
  EXPECT_THAT(misses("rof.obj"), Not(HasSubstr("did you mean")));
  EXPECT_THAT(misses("wal.obj"), Not(HasSubstr("did you mean")));
  AssetRoots roots = roots_of(home, {"secret"});
  EXPECT_THAT(misses(roots, "rof.obj"), HasSubstr("did you mean ../secret/roof.obj?"));
}

TEST_F(Layout, ListsTheSearchedPlaces) {
  const ResolvedAsset asset = roots_of(home).resolve("image/no.png");
  EXPECT_THAT(asset.tried, ::testing::Contains(home.path("scenes/image/no.png")));
  EXPECT_THAT(asset.tried, ::testing::Contains(home.path("image/no.png")));
  EXPECT_EQ(asset.error, "no such file");
  EXPECT_THAT(asset.notes,
              ::testing::IsSupersetOf({"looked for image/no.png", "looked for ../image/no.png"}));
  EXPECT_EQ(asset.notes.back(), "files elsewhere need --asset-root DIR or --allow-outside");
}

TEST_F(Layout, TheSizeIsBounded) {
  home.write("scenes/a.png", "12345");
  AssetRootsOptions options;
  options.scene_path = home.path("scenes/s.xml");
  options.max_bytes = 4;
  const Result<std::string> bytes = AssetRoots(options).read("a.png");
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().kind, ErrorKind::limit);
}

TEST_F(Layout, AMissNamesAllPlacesAsSeenFromTheScene) {
  home.write("data/a.png");
  home.write("far/away/data/a.png");
  AssetRoots roots = roots_of(home, {"data", "far/away/data"});
  EXPECT_EQ(misses(roots, "image/deep/no.png"),
            "no such file\nlooked for image/deep/no.png\nlooked for ../image/deep/no.png\n"
            "looked for ../data/image/deep/no.png\nlooked for ../far/away/data/image/deep/no.png\n"
            "looked for deep/no.png\nlooked for ../deep/no.png\nlooked for ../data/deep/no.png\n"
            "looked for ../far/away/data/deep/no.png\nlooked for no.png\nlooked for ../no.png\n"
            "looked for ../data/no.png\nlooked for ../far/away/data/no.png\n"
            "files elsewhere need --asset-root DIR or --allow-outside");
}

}  // namespace

}  // namespace scenefile
