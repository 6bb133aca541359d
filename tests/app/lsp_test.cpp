// The program as a language server: messages on standard input and output.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string framed(const std::string& body) {
  return "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

const std::string initialize =
    framed(R"({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {}})");
const std::string shutdown = framed(R"({"jsonrpc": "2.0", "id": 2, "method": "shutdown"})");
const std::string leave = framed(R"({"jsonrpc": "2.0", "method": "exit"})");

TEST(Lsp, AnswersAndLeaves) {
  const ProgramRun run = run_program({"lsp", "--stdio"}, {.input = initialize + shutdown + leave});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(::testing::StartsWith("Content-Length: "), HasSubstr("hoverProvider"),
                             HasSubstr("\"id\": 2")));
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run_program({"lsp"}, {.input = initialize + leave}).status, 1);
  EXPECT_EQ(run_program({"lsp"}, {.input = initialize}).status, 1);
}

TEST(Lsp, LooksForTexturesNextToTheScene) {
  TempFolder folder;
  folder.write("there.png", "not a picture");
  const std::string scene =
      R"(<scenefile><object type='tree' name='root'><transblock><object type='primitive' name='cube'>)"
      R"(<blend v='1'/><texture file='there.png' u='1' v='1'/></object></transblock></object></scenefile>)";
  const std::string uri = "file://" + folder.path() + "/a%20b.xml";
  const std::string document = R"("textDocument": {"uri": ")" + uri + "\"";
  const ProgramRun run = run_program(
      {"lsp"},
      {.input =
           initialize +
           framed(R"({"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {)" + document +
                  R"(, "version": 1, "text": ")" + scene + R"("}}})") +
           // Waits for the findings.
           framed(R"({"jsonrpc": "2.0", "id": 5, "method": "textDocument/hover", "params": {)" +
                  document + R"(}, "position": {"line": 0, "character": 0}}})") +
           shutdown + leave});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("texture.undecodable"), Not(HasSubstr("texture.missing"))));
}

TEST(Lsp, SaysWhatItIsForWithoutAnEditor) {
  const ProgramRun run = run_program({"lsp"}, {.input = "hello\r\n\r\n"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("docs/editors.md"));
  for (const char* const length : {"99999999999999", "-1", "abc", ""}) {
    const ProgramRun wrong =
        run_program({"lsp"}, {.input = std::string("Content-Length: ") + length + "\r\n\r\n{}"});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_THAT(wrong.err,
                HasSubstr("Content-Length that is a number of bytes, up to 256 million"));
  }
}

}  // namespace
}  // namespace scenefile
