// Which file of a class belongs to which student, and why others are ignored.

#include "scenefile/verbs/class_files.h"

#include "io/temp_folder.h"
#include "support/write_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace scenefile {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing_support::TempFolder;
using testing_support::write_archive;
using testing_support::WrittenEntry;
using Kind = WrittenEntry::Kind;

std::vector<FoundFile> references(const std::vector<std::string>& names) {
  std::vector<FoundFile> files;
  for (const std::string& name : names) {
    files.push_back({"refs/" + name + ".png", {}, name});
  }
  return files;
}

const std::vector<std::string> usual{"ball", "test_light_point_light_2", "test_fun_robot"};

// The path of each file below `folder`, with "STUDENT/STEM" or "(STUDENT) REASON".
std::map<std::string, std::string> found_in(
    const std::string& folder, const std::vector<FoundFile>& files = references(usual)) {
  std::map<std::string, std::string> table;
  const ClassFiles found = find_class_files(folder, files);
  const auto ignore = [&](const IgnoredFile& file) {
    table[file.path] = "(" + file.student + ") " + file.reason;
  };
  for (const IgnoredFile& file : found.ignored) {
    ignore(file);
  }
  for (const StudentFiles& student : found.students) {
    for (const FoundFile& file : student.pictures) {
      std::string path = file.path.substr(std::min(file.path.size(), folder.size() + 1));
      for (const std::string& entry : file.entries) {
        path += (path.empty() ? "" : "/") + entry;
      }
      table[path] = student.name + "/" + file.stem;
    }
    for (const IgnoredFile& file : student.ignored) {
      ignore(file);
    }
  }
  return table;
}

struct Row {
  std::string path;      // below the class; in archives, too
  std::string expected;  // of found_in(); empty: not mentioned
};

void expect_rows(const std::map<std::string, std::string>& table, const std::vector<Row>& rows) {
  std::size_t mentioned = 0;
  for (const Row& row : rows) {
    mentioned += row.expected.empty() ? 0 : 1;
    const auto at = table.find(row.path);
    EXPECT_EQ(at == table.end() ? "" : at->second, row.expected) << row.path;
  }
  EXPECT_EQ(table.size(), mentioned);
}

TEST(ClassFiles, FoldersArchivesAndNamesOfCourseSystems) {
  const TempFolder folder;
  const auto pack = [&](const std::string& name, const std::vector<WrittenEntry>& entries,
                        const std::string& password = {}) {
    folder.write(name, write_archive(name, entries, password));
  };
  const std::string inner = write_archive("b.zip", {{"images/ball.png"}, {"main.cpp"}});
  pack("gina.zip", {{"ball.png"}, {"__MACOSX/._ball.png"}, {"gina/notes.txt"}});
  pack("hal.tar.gz", {{"hal/ball.png"}, {"hal/link.png", "/etc/passwd", Kind::symbolic_link}});
  pack("ida.tgz", {{"../ball.png"}, {"ball.png", "1"}, {"ball.png", "2"}});
  pack("jon.tar", {{"work.zip", inner}});
  pack("kim.zip", {{"ball.png"}}, "secret");
  folder.write("lea.zip", "not an archive");
  folder.write("ann.zip", "PK\5\6" + std::string(18, '\0'));
  folder.write("bea/hw/empty.zip", "PK\5\6" + std::string(18, '\0'));
  folder.write("max.rar");
  folder.write("ned/hw.zip", inner);
  folder.write("ned/.DS_Store");
  folder.write("ned/ball.webp");
  folder.write("gina/robot.png");
  std::filesystem::create_directories(folder.path("olga"));
  folder.write("smithjohn_123_456_test_fun_robot.png");
  folder.write("smithjohn_LATE_123_470_point_light_2.png");
  folder.write("smithjohn_777_480_ball.png");
  pack("leeann_124_459_hw2.zip", {{"ball.png"}});
  pack("leeann_124_460_hw2-1.zip", {{"ball.png"}});
  folder.write("roepia_125_500_ball-2.png");
  folder.write("typed_126_text.html");
  folder.write("hw2_jsmith_attempt_2024-03-01-12-00-00_ball.png");
  folder.write("hw2_jsmith_attempt_2024-03-02-09-00-00_ball.png");
  folder.write("hw2_a_doe_attempt_2024-03-02-09-00-00.txt");
  folder.write("Ann Lee_99_assignsubmission_file_/ball.png");
  folder.write("ball.png");
  folder.write("picture_of_me.png");
  folder.write("Screenshot_2024_11_12_ball.png");
  folder.write("IMG_20241112_134500_ball.png");
  folder.write("list.pdf");
  expect_rows(found_in(folder.path()),
              {{"gina.zip/ball.png", "gina/ball"},
               {"gina/robot.png", "gina/robot"},
               {"gina.zip/gina/notes.txt", "(gina) not a picture"},
               {"gina.zip/__MACOSX/._ball.png", ""},
               {"hal.tar.gz/hal/ball.png", "hal/ball"},
               {"hal.tar.gz/hal/link.png", "(hal) a symbolic link, not a file"},
               {"ida.tgz/../ball.png", "(ida) its path leads out of the archive"},
               {"ida.tgz/ball.png", "(ida) a later entry of the archive has the same name"},
               {"jon.tar/work.zip/images/ball.png", "jon/ball"},
               {"jon.tar/work.zip/main.cpp", "(jon) not a picture"},
               {"kim.zip/ball.png", "(kim) protected by a password"},
               {"lea.zip", "(lea) it cannot be read as an archive: Unrecognized archive format"},
               {"ann.zip", "(ann) it contains no files"},
               {"bea/hw/empty.zip", "(bea) it contains no files"},
               {"max.rar", "(max) archives of this kind are not read: use .zip, .tar or .tar.gz"},
               {"ned/hw.zip/images/ball.png", "ned/ball"},
               {"ned/hw.zip/main.cpp", "(ned) not a picture"},
               {"ned/ball.webp", "(ned) pictures of this kind are not read: use .png"},
               {"ned/.DS_Store", ""},
               {"smithjohn_123_456_test_fun_robot.png", "smithjohn (123)/test_fun_robot"},
               {"smithjohn_LATE_123_470_point_light_2.png", "smithjohn (123)/point_light_2"},
               {"smithjohn_777_480_ball.png", "smithjohn (777)/ball"},
               {"leeann_124_459_hw2.zip", "(leeann) leeann_124_460_hw2-1.zip replaces it"},
               {"leeann_124_460_hw2-1.zip/ball.png", "leeann/ball"},
               {"roepia_125_500_ball-2.png", "roepia/ball"},
               {"typed_126_text.html", "(typed) not a picture"},
               {"hw2_jsmith_attempt_2024-03-01-12-00-00_ball.png",
                "(jsmith) superseded by a later attempt"},
               {"hw2_jsmith_attempt_2024-03-02-09-00-00_ball.png", "jsmith/ball"},
               {"hw2_a_doe_attempt_2024-03-02-09-00-00.txt", "(a_doe) not a picture"},
               {"Ann Lee_99_assignsubmission_file_/ball.png", "Ann Lee/ball"},
               {"ball.png", "() its name does not say whose picture it is"},
               {"picture_of_me.png", "() its name does not say whose picture it is"},
               {"Screenshot_2024_11_12_ball.png", "() its name does not say whose picture it is"},
               {"IMG_20241112_134500_ball.png", "() its name does not say whose picture it is"},
               {"list.pdf", "() pictures of this kind are not read: use .png"}});
  std::vector<std::string> names;
  for (const StudentFiles& student : find_class_files(folder.path(), references(usual)).students) {
    names.push_back(student.name);
  }
  EXPECT_THAT(names, ElementsAre("Ann Lee", "a_doe", "ann", "bea", "gina", "hal", "ida", "jon",
                                 "jsmith", "kim", "lea", "leeann", "max", "ned", "olga", "roepia",
                                 "smithjohn (123)", "smithjohn (777)", "typed"));
}

TEST(ClassFiles, OtherFoldersAreNoStudents) {
  const TempFolder folder;
  for (const char* name : {"class/ada/ball.png", "class/bob/ball.png", "class/right/ball.png",
                           "class/out/pages/ada.html", "away/ada.json"}) {
    folder.write(name);
  }
  std::filesystem::create_directory_symlink(folder.path("away"), folder.path("class/graded"));
  const ClassFiles found = find_class_files(
      folder.path("class"), references(usual),
      {"", folder.path("away"), folder.path("class/right/"), folder.path("class/out/pages"),
       folder.path("class/none"), folder.path("class")});
  std::vector<std::string> names;
  for (const StudentFiles& student : found.students) {
    names.push_back(student.name);
  }
  EXPECT_THAT(names, ElementsAre("ada", "bob"));
  names.clear();
  for (const IgnoredFile& file : found.ignored) {
    names.push_back(file.path);
    EXPECT_THAT(file.reason, HasSubstr("it is, or contains, the folder of references"));
  }
  EXPECT_THAT(names, ElementsAre("graded", "out", "right"));
}

TEST(ClassFiles, NamesOfStudentsMayContainDots) {
  const TempFolder folder;
  folder.write("john/ball.png");
  for (const char* name : {"john.doe.7z", "john.smith.rar", "john.roe.tar.xz", "john.tar.zip"}) {
    folder.write(name);
  }
  std::vector<std::string> names;
  for (const StudentFiles& student : find_class_files(folder.path(), references(usual)).students) {
    names.push_back(student.name);
  }
  EXPECT_THAT(names, ElementsAre("john", "john.doe", "john.roe", "john.smith", "john.tar"));
}

TEST(FoundFiles, FoldersAreThoseBelowTheSearchedOne) {
  for (const auto& [folder, path] : {std::pair("refs", "refs/a/b/c.d.png"),
                                     {"refs/", "refs/a/b/c.d.png"},
                                     {".", "a/b/c.d.png"},
                                     {"/", "/a/b/c.d.png"}}) {
    const FoundFile file = found_file(folder, path);
    EXPECT_EQ(file.path, path);
    EXPECT_THAT(file.folders, ElementsAre("a", "b"));
    EXPECT_EQ(file.stem, "c.d");
  }
  EXPECT_TRUE(found_file("refs", "refs/a.png").folders.empty());
}

TEST(ClassFiles, GradescopeNamesItsFolders) {
  const TempFolder folder;
  folder.write("submission_metadata.yml",
               "---\nsubmission_11:\n  :submitters:\n  - :name: Ann Lee\n    :sid: '7'\n  - :name: "
               "'Pat O''Hara'\n  :created_at: 2024\n  :results:\n    tests:\n    - :name: no\n"
               "submission_12:\n  :submitters:\n  - :name: \"\\u00e9\"\n");
  folder.write("submission_11/ball.png");
  folder.write("submission_12/ball.png");
  folder.write("submission_13/ball.png");
  expect_rows(found_in(folder.path()), {{"submission_11/ball.png", "Ann Lee, Pat O'Hara/ball"},
                                        {"submission_12/ball.png", "submission_12/ball"},
                                        {"submission_13/ball.png", "submission_13/ball"}});
}

TEST(ClassFiles, AnArchiveOfTheClass) {
  const TempFolder folder;
  const std::string outside = "() its path leads out of the archive";
  folder.write("class.zip", write_archive("a.zip", {{"export/ada/ball.png"},
                                                    {"export/bob/ball.png"},
                                                    {"export/bob/a.txt"},
                                                    {"../eve/ball.png"},
                                                    {"C:/eve.png"}}));
  expect_rows(found_in(folder.path("class.zip")), {{"export/ada/ball.png", "ada/ball"},
                                                   {"export/bob/ball.png", "bob/ball"},
                                                   {"export/bob/a.txt", "(bob) not a picture"},
                                                   {"../eve/ball.png", outside},
                                                   {"C:/eve.png", outside}});
  // As downloaded from Canvas, next to a student's folder.
  folder.write("all/submissions.zip",
               write_archive("a.zip", {{"lee_1_2_ball.png"}, {"roe_3_4_ball.png"}}));
  folder.write("all/zoe/ball.png");
  expect_rows(found_in(folder.path("all")), {{"submissions.zip/lee_1_2_ball.png", "lee/ball"},
                                             {"submissions.zip/roe_3_4_ball.png", "roe/ball"},
                                             {"zoe/ball.png", "zoe/ball"}});
}

// Also if they are nobody's file.
TEST(ClassFiles, TheArchiveOfAClassHasTheStudentsOfItsFolder) {
  const TempFolder folder;
  const std::vector<WrittenEntry> entries{{"ada/ball.png"},    {"bob/", "", Kind::folder},
                                          {"cyd/.DS_Store"},   {"dan/.git/HEAD"},
                                          {".cache/ball.png"}, {"__MACOSX/ada/._ball.png"}};
  std::vector<WrittenEntry> wrapped{{"export/", "", Kind::folder}};
  for (const WrittenEntry& entry : entries) {
    wrapped.push_back({"export/" + entry.path, entry.bytes, entry.kind});
    entry.kind == Kind::folder
        ? void(std::filesystem::create_directories(folder.path("class/" + entry.path)))
        : void(folder.write("class/" + entry.path));
  }
  folder.write("class.zip", write_archive("class.zip", entries));
  folder.write("wrapped.tgz", write_archive("wrapped.tgz", wrapped));
  for (const char* name : {"class", "class.zip", "wrapped.tgz"}) {
    SCOPED_TRACE(name);
    const ClassFiles found = find_class_files(folder.path(name), references(usual));
    std::vector<std::string> names;
    for (const StudentFiles& student : found.students) {
      names.push_back(student.name);
    }
    EXPECT_THAT(names, ElementsAre("ada", "bob", "cyd", "dan"));
    ASSERT_EQ(found.ignored.size(), 1U);
    EXPECT_EQ(found.ignored[0].reason, "hidden: its name begins with a dot");
  }
}

TEST(ClassFiles, OneStudent) {
  const TempFolder folder;
  folder.write("mine/ball.png");
  folder.write("mine/old/notes.png");
  EXPECT_EQ(found_in(folder.path("mine")).at("old/notes.png"), "mine/notes");
  EXPECT_EQ(find_class_files(folder.path("mine"), references(usual)).one_student, "");
  // As many as in a folder: still one student, but it may be meant otherwise; more: a class.
  folder.write("mine/old/ball.png");
  EXPECT_EQ(found_in(folder.path("mine")).at("ball.png"), "mine/ball");
  EXPECT_THAT(find_class_files(folder.path("mine"), references(usual)).one_student,
              HasSubstr("as in its folders (1)"));
  folder.write("mine/bob/ball.png");
  EXPECT_EQ(found_in(folder.path("mine")).at("bob/ball.png"), "bob/ball");
  EXPECT_EQ(found_in(folder.path("mine")).at("ball.png"),
            "() its name does not say whose picture it is");
  folder.write("gina.zip", write_archive("a.zip", {{"images/ball.png"}}));
  EXPECT_EQ(found_in(folder.path("gina.zip")).at("images/ball.png"), "gina/ball");
  // Numbers in the name of a reference are not those of Canvas.
  folder.write("work/a_1_2_b.png");
  EXPECT_EQ(found_in(folder.path("work"), references({"a_1_2_b"})).at("a_1_2_b.png"),
            "work/a_1_2_b");
  // Nor is a size.
  folder.write("sized/ball_640_480_final.png");
  folder.write("sized/robot.png");
  EXPECT_EQ(found_in(folder.path("sized")).at("robot.png"), "sized/robot");
  EXPECT_EQ(found_in(folder.path("sized")).at("ball_640_480_final.png"),
            "sized/ball_640_480_final");
  // A link to the archive of a class.
  std::filesystem::create_symlink(folder.path("gina.zip"), folder.path("latest.zip"));
  EXPECT_EQ(found_in(folder.path("latest.zip")).at("images/ball.png"), "latest/ball");
}

TEST(ClassFiles, WhatIsInArchivesIsRead) {
  const TempFolder folder;
  const std::string inner = write_archive("b.zip", {{"a.png", "first"}, {"b.png", "second"}});
  folder.write("a.tgz",
               write_archive("a.tgz", {{"in.zip", inner}, {"c.png", "1"}, {"c.png", "2"}}));
  const std::string path = folder.path("a.tgz");
  const std::vector<Result<std::string>> bytes =
      read_archived({{path, {}, "b", {"in.zip", "b.png"}},
                     {path, {}, "c", {"c.png"}},
                     {path, {}, "d", {"d.png"}},
                     {folder.path("none.zip"), {}, "a", {"a.png"}}});
  EXPECT_EQ(*bytes[0], "second");
  EXPECT_EQ(*bytes[1], "2");
  EXPECT_FALSE(bytes[2]);
  EXPECT_FALSE(bytes[3]);
}

// Damage that ends libarchive's reading costs only the damaged picture.
TEST(ClassFiles, PicturesAfterADamagedOneAreRead) {
  const TempFolder folder;
  std::string zip = write_archive("a.zip", {{"a.png", std::string(300, 'a')}, {"b.png", "b"}});
  const auto number = [&](std::size_t at) {
    return static_cast<unsigned char>(zip[at]) + 256U * static_cast<unsigned char>(zip[at + 1]);
  };
  zip[30 + number(26) + number(28)] = '\xff';  // not a block of deflate
  const std::string path = folder.write("a.zip", zip);
  const std::vector<Result<std::string>> bytes =
      read_archived({{path, {}, "a", {"a.png"}}, {path, {}, "b", {"b.png"}}});
  ASSERT_FALSE(bytes[0]);
  EXPECT_THAT(bytes[0].error().text, HasSubstr("it is damaged: "));
  ASSERT_TRUE(bytes[1]) << bytes[1].error().text;
  EXPECT_EQ(*bytes[1], "b");
}

// Its code does not make a class of it.
TEST(ClassFiles, TheRepositoryOfOneStudent) {
  const TempFolder folder;
  folder.write("sub/student_outputs/illuminate/required/ball.png");
  folder.write("sub/src/main.cpp");
  folder.write("sub/scenefiles/ball.xml");
  folder.write("sub/CMakeLists.txt");
  std::filesystem::create_directories(folder.path("sub/build"));
  expect_rows(found_in(folder.path("sub")),
              {{"student_outputs/illuminate/required/ball.png", "sub/ball"},
               {"src/main.cpp", "(sub) not a picture"},
               {"scenefiles/ball.xml", "(sub) not a picture"},
               {"CMakeLists.txt", "(sub) not a picture"}});
  // Other folders with pictures do, unless it is said that there is one student.
  folder.write("sub/textures/ball.png");
  EXPECT_EQ(found_in(folder.path("sub")).at("textures/ball.png"), "textures/ball");
  EXPECT_EQ(find_class_files(folder.path("sub"), references(usual), {}, true).students.size(), 1U);
}

// For each reference, the name of the picture that is taken.
std::vector<std::string> matches(const std::vector<std::string>& names,
                                 const std::vector<std::string>& pictures) {
  const std::vector<FoundFile> files = references(pictures);
  std::vector<std::string> taken;
  for (const int match : match_pictures(references(names), files).pictures) {
    taken.push_back(match < 0 ? "" : files[static_cast<std::size_t>(match)].stem);
  }
  return taken;
}

TEST(MatchPictures, ByPartsOfNames) {
  EXPECT_THAT(matches(usual, {"ball", "point_light_2", "robot"}),
              ElementsAre("ball", "point_light_2", "robot"));
  EXPECT_THAT(matches(usual, {"hw2_ball_final", "PointLight2", "fun-robot_gen"}),
              ElementsAre("hw2_ball_final", "PointLight2", "fun-robot_gen"));
  // Not in whole words, not without letters, not if unclear.
  EXPECT_THAT(matches(usual, {"football", "2", "bot"}), ElementsAre("", "", ""));
  EXPECT_THAT(matches({"a_light_2", "b_light_2"}, {"light_2"}), ElementsAre("", ""));
  EXPECT_THAT(matches({"light", "point_light"}, {"my_point_light"}),
              ElementsAre("", "my_point_light"));
  EXPECT_THAT(matches({"ball", "cube"}, {"ball_and_cube"}), ElementsAre("", ""));
}

// macOS writes a letter and its accent as two characters.
TEST(MatchPictures, BothFormsOfAccentsAreAlike) {
  EXPECT_THAT(matches({"t\xC3\xA4st"}, {"ta\xCC\x88st"}), ElementsAre("ta\xCC\x88st"));
  EXPECT_THAT(matches({"ta\xCC\x88st"}, {"hw2_t\xC3\xA4st"}), ElementsAre("hw2_t\xC3\xA4st"));
  EXPECT_THAT(matches({"t\xC3\xA4st"}, {"tast"}), ElementsAre(""));
}

TEST(MatchPictures, OtherScriptsAreLettersToo) {
  const std::string ball = "\xD1\x88\xD0\xB0\xD1\x80";
  const std::string cube = "\xD0\xBA\xD1\x83\xD0\xB1";
  const std::string sphere = "\xE7\x90\x83";
  const std::vector<std::string> names{ball, cube, sphere};
  EXPECT_THAT(matches(names, names), ElementsAre(ball, cube, sphere));
  EXPECT_THAT(matches(names, {"cube", "\xE7\x90\x84", "\xC3\xA9", "\xFF"}),
              ElementsAre("", "", ""));
  EXPECT_THAT(matches(names, {cube + "_gen", "hw2_" + sphere + "_final",
                              ball + "\xE2\x80\x93"
                                     "out"}),
              ElementsAre(ball + "\xE2\x80\x93"
                                 "out",
                          cube + "_gen", "hw2_" + sphere + "_final"));
  EXPECT_THAT(matches({"test_" + ball, "1" + ball}, {ball + "1"}), ElementsAre("", ""));
  // Names of which nothing remains match nothing else.
  EXPECT_THAT(matches({"\xFE", "gen"}, {"\xFF", "\xC3\xA9"}), ElementsAre("", ""));
  EXPECT_THAT(matches({"\xFE"}, {"\xFE"}), ElementsAre("\xFE"));
  for (const std::string& name : {ball, std::string("\xC3\xA9"), std::string("\xFF")}) {
    EXPECT_FALSE(is_layout_folder(name)) << name;
  }
  EXPECT_TRUE(is_layout_folder("student_outputs"));
}

TEST(MatchPictures, MapsMayBeginWithAByteOrderMark) {
  std::string wrong;
  const std::vector<NamePair> map = read_name_map(
      "\xEF\xBB\xBF"
      "a.png,b\n",
      wrong);
  ASSERT_EQ(map.size(), 1U) << wrong;
  EXPECT_EQ(map[0].handed_in, "a.png");
}

// They come in alphabetical order.
TEST(MatchPictures, OfSeveralFormatsThoseThatChangeColorsComeLast) {
  const auto taken = [](const std::vector<std::string>& names) {
    std::vector<FoundFile> pictures;
    for (const std::string& name : names) {
      pictures.push_back(found_file("mine", "mine/" + name));
    }
    return names.at(
        static_cast<std::size_t>(match_pictures(references({"ball"}), pictures).pictures[0]));
  };
  EXPECT_EQ(taken({"ball.bmp", "ball.exr", "ball.gif", "ball.jpg", "ball.PNG"}), "ball.PNG");
  EXPECT_EQ(taken({"ball.gif", "ball.jpeg", "ball.tga"}), "ball.tga");
  EXPECT_EQ(taken({"ball.jpg", "ball_gen.png"}), "ball.jpg");  // the better name
}

TEST(MatchPictures, TheBetterNameIsTaken) {
  EXPECT_THAT(matches({"ball"}, {"my_ball", "ball", "ball_gen"}), ElementsAre("ball"));
  const PictureMatches found = match_pictures(references({"ball", "a_x", "b_x"}),
                                              references({"ball_gen", "ball", "other", "x"}));
  ASSERT_EQ(found.unused.size(), 3U);
  EXPECT_EQ(found.unused[0].picture, 0U);
  EXPECT_EQ(found.unused[0].reference, 0);
  EXPECT_EQ(found.unused[1].reference, -1);
  EXPECT_THAT(found.unused[1].several, ElementsAre());
  EXPECT_THAT(found.unused[2].several, ElementsAre(1U, 2U));
}

}  // namespace
}  // namespace scenefile
