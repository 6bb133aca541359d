#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string untidy =
    "<scenefile><!-- it -->\n<object type='tree'  name=\"root\"/></scenefile>";
const std::string tidy =
    "<scenefile> <!-- it -->\n  <object type='tree' name=\"root\"/>\n</scenefile>\n";

struct Format : ProgramFolder {};

TEST_F(Format, FormatsInPlace) {
  const std::string a = folder.write("a.xml", untidy);
  const std::string b = folder.write("b.json", "{\"groups\":[]}");
  const std::string c = folder.write("c.xml", tidy);
  ASSERT_EQ(::chmod(a.c_str(), 0640), 0);
  const ProgramRun run = run_program({"format", a, b, c});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, a + ": formatted\n" + b + ": formatted\n");
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(folder.read("a.xml"), tidy);
  EXPECT_EQ(folder.read("b.json"), "{\n  \"groups\": []\n}\n");
  struct stat status {};
  ASSERT_EQ(::stat(a.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  EXPECT_EQ(folder.list().size(), 3U);
}

TEST_F(Format, CheckDoesNotChangeFiles) {
  folder.write("a.xml", untidy);
  folder.write("c.xml", tidy);
  const auto in_folder = [&](const std::vector<std::string>& words) { return program(words); };
  const ProgramRun run = in_folder({"format", "--check", "a.xml", "c.xml"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "a.xml\n");
  EXPECT_EQ(folder.read("a.xml"), untidy);
  EXPECT_EQ(in_folder({"format", "--check", "c.xml"}).status, 0);
  const rapidjson::Document document =
      parse_json(in_folder({"format", "--check", "--json", "a.xml", "c.xml"}).out);
  EXPECT_TRUE(document["files"][0]["changed"].GetBool());
  EXPECT_FALSE(document["files"][1]["changed"].GetBool());
  EXPECT_FALSE(document["files"][0]["scene"].HasMember("verdict"));  // format does not check
  EXPECT_FALSE(document["files"][0]["scene"].HasMember("warnings"));
}

TEST_F(Format, BrokenFilesAreNotChanged) {
  const std::string bad = folder.write("bad.xml", "<scenefile>\n<a></scenefile>");
  const std::string good = folder.write("good.xml", untidy);
  const ProgramRun run = run_program({"format", bad, good});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("bad.xml:2:1: error: <a> is not closed"),
                             HasSubstr("good.xml: formatted")));
  EXPECT_EQ(folder.read("bad.xml"), "<scenefile>\n<a></scenefile>");
  EXPECT_EQ(folder.read("good.xml"), tidy);
  EXPECT_EQ(run_program({"format", folder.path("none.xml")}).status, 3);
}

TEST_F(Format, OnlyScenesInAFolderAreChanged) {
  const std::string package = R"({"name":"tool","version":"1"})";
  const std::string results = "<testsuites><testsuite/></testsuites>";
  folder.write("in/a.xml", untidy);
  folder.write("in/deep/b.json", "{\"groups\":[]}");
  folder.write("in/package.json", package);
  folder.write("in/results.xml", results);
  folder.write("in/.hidden.xml", untidy);
  folder.write("in/mesh.obj", untidy);
  const auto in_folder = [&](const std::vector<std::string>& words) { return program(words); };
  const ProgramRun check = in_folder({"format", "--check", "in"});
  EXPECT_EQ(check.status, 1);
  EXPECT_EQ(check.out, "in/a.xml\nin/deep/b.json\n");
  const ProgramRun run = in_folder({"format", "in/"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, AllOf(HasSubstr("in/a.xml: formatted\nin/deep/b.json: formatted\n"),
                             HasSubstr("skipped 2 files that are not scenes")));
  EXPECT_EQ(folder.read("in/a.xml"), tidy);
  EXPECT_EQ(folder.read("in/package.json"), package);
  EXPECT_EQ(folder.read("in/results.xml"), results);
  EXPECT_EQ(folder.read("in/.hidden.xml"), untidy);
  EXPECT_EQ(folder.read("in/mesh.obj"), untidy);
  EXPECT_EQ(in_folder({"format", "--check", "-q", "in"}).status, 0);
}

TEST_F(Format, StandardInputGoesToStandardOutput) {
  for (const std::string& text : {untidy, tidy}) {
    const ProgramRun run = run_program({"format", "-"}, {.input = text});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out, tidy);
    EXPECT_EQ(run.err, "");
  }
  const ProgramRun check = run_program({"format", "--check", "-"}, {.input = untidy});
  EXPECT_EQ(check.status, 1);
  EXPECT_EQ(check.out, "<stdin>\n");
  EXPECT_EQ(run_program({"format", "--json", "-"}, {.input = tidy}).status, 2);
  const ProgramRun bad = run_program({"format", "-"}, {.input = "<scenefile>"});
  EXPECT_EQ(bad.status, 1);
  EXPECT_EQ(bad.out, "");
  EXPECT_THAT(bad.err, Not(HasSubstr("formatted")));
}

}  // namespace

}  // namespace scenefile
