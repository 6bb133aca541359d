#include "scenefile/lsp/language_server.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/pointer.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace scenefile {
namespace {

std::string quoted_json(const std::string& text) {
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  writer.String(text.c_str());
  return buffer.GetString();
}

// In few characters.
std::string compact(const rapidjson::Value& value) {
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  value.Accept(writer);
  return buffer.GetString();
}

std::string compact(const std::string& json) {
  rapidjson::Document document;
  document.Parse(json.c_str());
  return document.HasParseError() ? json : compact(document);
}

const std::string scene = R"(<scenefile>
<globaldata><diffusecoeff v="0.5"/><ambientcoeff v="0.5"/><specularcoeff v="0.5"/></globaldata>
<cameradata><pos x="0" y="0" z="5"/><look x="0" y="0" z="-1"/><up x="0" y="1" z="0"/><heightangle v="45"/></cameradata>
<lightdata><id v="0"/><type v="directional"/><color r="1" g="1" b="1"/><direction x="0" y="0" z="-1"/></lightdata>
<object type="tree" name="leg"><transblock><object type="primitive" name="cube"/></transblock></object>
<object type="tree" name="root"><transblock><object type="master" name="leg"/></transblock></object>
</scenefile>
)";

// A client with one document, s.
struct Client : ::testing::Test {
  rapidjson::Document request(const std::string& method, const std::string& params) {
    const auto replies = server.handle(
        R"({"jsonrpc": "2.0", "id": 7, "method": ")" + method + R"(", "params": )" + params + "}",
        now);
    EXPECT_FALSE(replies.empty());
    rapidjson::Document reply;
    reply.Parse(replies.back().c_str());  // findings may come first
    EXPECT_FALSE(reply.HasParseError()) << replies.back();
    EXPECT_EQ(reply["id"].GetInt(), 7);
    return reply;
  }
  std::string result(const std::string& method, const std::string& params) {
    const rapidjson::Document reply = request(method, params);
    return compact(reply.HasMember("result") ? reply["result"] : reply["error"]);
  }
  std::string at(int line, int character, const std::string& more = {}) {
    return R"({"textDocument": {"uri": "s"}, "position": {"line": )" + std::to_string(line) +
           R"(, "character": )" + std::to_string(character) + "}" + more + "}";
  }
  std::vector<std::string> notify(const std::string& method, const std::string& params) {
    return server.handle(
        R"({"jsonrpc": "2.0", "method": ")" + method + R"(", "params": )" + params + "}", now);
  }
  void open(const std::string& text) {
    EXPECT_TRUE(
        notify("textDocument/didOpen",
               R"({"textDocument": {"uri": "s", "version": 1, "text": )" + quoted_json(text) + "}}")
            .empty());
  }
  // The findings that are sent, after the pause.
  std::string findings() {
    now += 1;
    const auto sent = server.tick(now);
    return sent.size() == 1 ? compact(sent[0]) : std::to_string(sent.size()) + " messages";
  }
  void initialize() { request("initialize", "{}"); }

  double now = 100;
  std::vector<std::string> fetched;
  LanguageServer server{[this](const std::string&, const std::string&) {
    return [this](const std::string& name) -> Result<std::string> {
      fetched.push_back(name);
      return Error{"it is not there"};
    };
  }};
};

TEST_F(Client, LivesAndEnds) {
  EXPECT_NE(result("textDocument/hover", at(0, 0)).find("-32002"), std::string::npos);
  initialize();
  EXPECT_NE(result("foo/bar", "{}").find("-32601"), std::string::npos);
  EXPECT_NE(result("textDocument/hover", at(0, 0)).find("-32602"), std::string::npos);
  EXPECT_TRUE(notify("$/cancelRequest", R"({"id": 1})").empty());
  EXPECT_NE(server.handle("[", now).at(0).find("-32700"), std::string::npos);
  EXPECT_NE(server.handle("{}", now).at(0).find("-32600"), std::string::npos);
  EXPECT_EQ(result("shutdown", "null"), "null");
  EXPECT_NE(result("textDocument/hover", at(0, 0)).find("-32600"), std::string::npos);
  EXPECT_FALSE(server.exit_status());
  notify("exit", "null");
  EXPECT_EQ(server.exit_status(), 0);
}

TEST_F(Client, ExitWithoutShutdownIsAFailure) {
  initialize();
  notify("exit", "null");
  EXPECT_EQ(server.exit_status(), 1);
}

TEST_F(Client, FindingsComeAfterAPause) {
  initialize();
  EXPECT_FALSE(server.next_tick());
  open(scene);
  EXPECT_NE(findings().find(R"("diagnostics":[])"), std::string::npos);
  const auto insert = [&](int line, int character, const std::string& text) {
    EXPECT_TRUE(notify("textDocument/didChange",
                       R"({"textDocument": {"uri": "s", "version": 2}, "contentChanges": [{"range":
                       {"start": {"line": )" +
                           std::to_string(line) + R"(, "character": )" + std::to_string(character) +
                           R"(}, "end": {"line": )" + std::to_string(line) + R"(, "character": )" +
                           std::to_string(character) + R"(}}, "text": ")" + text + R"("}]})")
                    .empty());
  };
  insert(1, 13, "x");  // <xdiffusecoeff
  EXPECT_NEAR(*server.next_tick(), now + 0.04, 1e-9);
  EXPECT_TRUE(server.tick(now + 0.03).empty());
  now += 0.03;
  insert(1, 13, "y");
  EXPECT_TRUE(server.tick(now + 0.03).empty());
  const std::string found = findings();
  EXPECT_NE(found.find("did you mean <diffusecoeff>"), std::string::npos) << found;
  EXPECT_NE(found.find(R"("version":2)"), std::string::npos);
  EXPECT_NE(found.find(R"("start":{"line":1,"character":12})"), std::string::npos);
  const auto closed = notify("textDocument/didClose", R"({"textDocument": {"uri": "s"}})");
  EXPECT_NE(compact(closed.at(0)).find(R"("diagnostics":[])"), std::string::npos);
}

// One change, as JSON; a position is a line and a character.
std::string change_of(std::pair<int, int> from, std::pair<int, int> to, const std::string& text) {
  const auto position = [](std::pair<int, int> p) {
    return R"({"line": )" + std::to_string(p.first) + R"(, "character": )" +
           std::to_string(p.second) + "}";
  };
  return R"({"range": {"start": )" + position(from) + R"(, "end": )" + position(to) +
         R"(}, "text": )" + quoted_json(text) + "}";
}

// Changes that come together are made one after the other.
TEST_F(Client, ChangesTogetherAreLikeChangesOneByOne) {
  initialize();
  std::mt19937 random(7);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto random_text = [&](int most) {
    const std::vector<std::string> parts{"a", "b", "\u00e9", "\U0001F600", "\n", "\r", "\r\n"};
    std::string text;
    for (int n = below(most); n > 0; --n) {
      text += parts[static_cast<std::size_t>(below(7))];
    }
    return text;
  };
  const auto send = [&](const std::string& changes) {
    notify("textDocument/didChange",
           R"({"textDocument": {"uri": "s", "version": 2}, "contentChanges": [)" + changes + "]}");
  };
  const std::string start = "<scenefile><object type=\"tree\" name=\"";
  const auto column = static_cast<int>(start.size());
  // The text, seen as a name.
  const auto text_now = [&] {
    send(change_of({0, 0}, {0, 0}, start));
    send(change_of({999, 0}, {999, 0}, "\"/></scenefile>"));
    return result("textDocument/prepareRename", at(0, column));
  };
  for (int round = 0; round < 2000; ++round) {
    const std::string text = random_text(20);
    std::vector<std::string> changes;
    std::pair<int, int> last{6, 6};
    for (int n = 1 + below(6); n > 0; --n) {
      std::pair<int, int> from{below(6), below(6)};
      from = below(4) == 0 ? from : std::min(from, last);  // most from the end to the beginning
      const std::pair<int, int> to{from.first + below(2), below(6)};
      changes.push_back(below(20) == 0 ? R"({"text": )" + quoted_json(random_text(20)) + "}"
                                       : change_of(from, to, random_text(4)));
      last = from;
    }
    open(text);
    std::string together;
    for (const std::string& change : changes) {
      together += (together.empty() ? "" : ", ") + change;
      send(change);
    }
    const std::string one_by_one = text_now();
    open(text);
    send(together);
    ASSERT_EQ(text_now(), one_by_one) << quoted_json(text) << " " << together;
  }
}

TEST_F(Client, OtherFilesHaveNoFindings) {
  initialize();
  open("<html><body>");
  EXPECT_NE(findings().find(R"("diagnostics":[])"), std::string::npos);
  EXPECT_EQ(result("textDocument/documentSymbol", at(0, 0)), "[]");
}

TEST_F(Client, CorrectionsAreActions) {
  initialize();
  std::string wrong = scene;
  wrong.replace(wrong.find("name=\"leg\"/>"), 12, "name=\"lge\"/>");
  wrong.replace(wrong.find("diffusecoeff v=\"0.5\""), 20, "diffusecoeff v=\"0,5\"");
  open(wrong);
  const std::string ask = R"({"textDocument": {"uri": "s"}, "range": {"start": {"line": 1,
      "character": 0}, "end": {"line": 1, "character": 0}}, "context": {"diagnostics": [])";
  const std::string one = result("textDocument/codeAction", ask + "}}");
  EXPECT_NE(one.find("Change 0,5 to 0.5"), std::string::npos) << one;
  EXPECT_EQ(one.find("leg"), std::string::npos);
  const std::string all =
      result("textDocument/codeAction", ask + R"(, "only": ["source.fixAll"]}})");
  EXPECT_NE(all.find(quoted_json(scene)), std::string::npos) << all;
}

// The text of an editor is decoded already.
TEST_F(Client, DeclaredEncodingsMeanNothing) {
  initialize();
  for (const std::string encoding : {"ISO-8859-1", "UTF-16", "klingon"}) {
    SCOPED_TRACE(encoding);
    const std::string right = "<?xml version=\"1.0\" encoding=\"" + encoding + "\"?>\n" + scene;
    std::string wrong = right;
    wrong.replace(wrong.find("<object type=\"master\""), 0,
                  "<!-- \u00e9\u20ac --><scale x=\"1,5\" y=\"1\" z=\"1\"/>");
    std::string fixed = wrong;
    fixed.replace(fixed.find("1,5"), 3, "1.5");
    open(wrong);
    const std::string found = findings();
    EXPECT_NE(found.find(R"("start":{"line":6,"character":62})"), std::string::npos) << found;
    const std::string ask = R"({"textDocument": {"uri": "s"}, "range": {"start": {"line": 6,
        "character": 0}, "end": {"line": 6, "character": 0}}, "context": {"diagnostics": [])";
    const std::string one = result("textDocument/codeAction", ask + "}}");
    EXPECT_NE(one.find(R"("start":{"line":6,"character":65})"), std::string::npos) << one;
    const std::string all =
        result("textDocument/codeAction", ask + R"(, "only": ["source.fixAll"]}})");
    EXPECT_NE(all.find(quoted_json(fixed)), std::string::npos) << all;
    const std::string formatted = result("textDocument/formatting", at(0, 0));
    EXPECT_NE(formatted.find("<!-- \u00e9\u20ac -->"), std::string::npos) << formatted;
  }
}

TEST_F(Client, WordsAreCompletedAndExplained) {
  initialize();
  open(scene);
  EXPECT_NE(result("textDocument/hover", at(2, 3)).find("amera"), std::string::npos);
  EXPECT_EQ(result("textDocument/hover", at(2, 19)), "null");
  open("<scenefile><camera");
  const std::string found = result("textDocument/completion", at(0, 18));
  EXPECT_NE(found.find(R"("newText":"cameradata></cameradata>")"), std::string::npos) << found;
  EXPECT_NE(found.find(R"("start":{"line":0,"character":12})"), std::string::npos);
}

TEST_F(Client, TemplatesAreFoundAndRenamed) {
  initialize();
  open(scene);
  const std::size_t line = scene.find("<object type=\"tree\" name=\"root\"");
  const auto use = static_cast<int>(scene.find("leg", line) - line);
  const std::string place = result("textDocument/definition", at(5, use));
  EXPECT_NE(place.find(R"("start":{"line":4,"character":26})"), std::string::npos) << place;
  const std::string edits =
      result("textDocument/rename", at(5, use, R"(, "newName": "l & \"r\"")"));
  EXPECT_NE(edits.find(R"(l &amp; &quot;r&quot;)"), std::string::npos) << edits;
  EXPECT_NE(edits.find(R"("line":5)"), std::string::npos);
  EXPECT_NE(result("textDocument/rename", at(5, use, R"(, "newName": "root")")).find("-32803"),
            std::string::npos);
  EXPECT_NE(result("textDocument/rename", at(0, 0, R"(, "newName": "a")")).find("-32803"),
            std::string::npos);
  EXPECT_EQ(result("textDocument/prepareRename", at(0, 0)), "null");
}

TEST_F(Client, NamesThatCannotBeWrittenAreRefused) {
  initialize();
  const auto renamed = [&](int character, const std::string& name) {
    return result("textDocument/rename", at(0, character, R"(, "newName": ")" + name + "\""));
  };
  const std::string xml = R"(<scenefile><object type="tree" name="leg"/></scenefile>)";
  open(xml);
  const int leg = static_cast<int>(xml.find("leg"));
  EXPECT_NE(renamed(leg, "root").find("reserved"), std::string::npos);
  EXPECT_NE(renamed(leg, "a\\u0000b").find("XML cannot contain"), std::string::npos);
  EXPECT_NE(renamed(leg, std::string(5000, 'x')).find("longer than the limit of 4096 bytes"),
            std::string::npos);
  open(R"({"groups": [{"name": "t"}], "templateGroups": [{"name": "t"}]})");
  EXPECT_EQ(renamed(22, "root").find("-32803"), std::string::npos);
  EXPECT_EQ(renamed(22, "a\\u0000b").find("-32803"), std::string::npos);
  EXPECT_NE(renamed(22, std::string(5000, 'x')).find("-32803"), std::string::npos);
}

// A group with the new name would become an instance of the template.
TEST_F(Client, TemplatesAreNotRenamedToNamesOfGroups) {
  initialize();
  open(R"({"groups": [{"name": "t"}, {"name": "g"}], "templateGroups": [{"name": "t"}]})");
  EXPECT_NE(result("textDocument/rename", at(0, 22, R"(, "newName": "g")")).find("-32803"),
            std::string::npos);
  EXPECT_EQ(result("textDocument/rename", at(0, 22, R"(, "newName": "h")")).find("-32803"),
            std::string::npos);
}

TEST_F(Client, SymbolsNest) {
  initialize();
  open(scene);
  const rapidjson::Document reply = request("textDocument/documentSymbol", at(0, 0));
  const auto& all = reply["result"];
  ASSERT_EQ(all.Size(), 5U);
  EXPECT_STREQ(all[3]["name"].GetString(), "leg");
  EXPECT_STREQ(all[3]["children"][0]["name"].GetString(), "cube");
}

TEST_F(Client, TexturesAreReadOnlyIfTheirNamesChange) {
  initialize();
  std::string textured = scene;
  textured.replace(
      textured.find("name=\"cube\"/>"), 13,
      "name=\"cube\"><blend v=\"1\"/><texture file=\"a.png\" u=\"1\" v=\"1\"/></object>");
  open(textured);
  EXPECT_NE(findings().find("texture.missing"), std::string::npos);
  EXPECT_EQ(fetched.size(), 1U);
  const auto insert = [&](const std::string& what) {
    notify("textDocument/didChange",
           R"({"textDocument": {"uri": "s", "version": 3}, "contentChanges": [{"range": {"start":
           {"line": 0, "character": 0}, "end": {"line": 0, "character": 0}}, "text": ")" +
               what + R"("}]})");
  };
  insert("\\n");
  const std::string moved = findings();
  EXPECT_NE(moved.find("texture.missing"), std::string::npos);
  EXPECT_NE(moved.find(R"("line":5)"), std::string::npos) << moved;
  EXPECT_EQ(fetched.size(), 1U);
  notify("textDocument/didSave", R"({"textDocument": {"uri": "s"}})");
  EXPECT_NE(findings().find("texture.missing"), std::string::npos);
  EXPECT_EQ(fetched.size(), 2U);
}

TEST_F(Client, FormatsAndColors) {
  initialize();
  open(scene);
  EXPECT_NE(result("textDocument/formatting", at(0, 0)).find("newText"), std::string::npos);
  EXPECT_NE(result("textDocument/documentColor", at(0, 0)).find(R"("red":1)"), std::string::npos);
  const std::string label = result(
      "textDocument/colorPresentation",
      R"({"textDocument": {"uri": "s"}, "color": {"red": 0.12345, "green": 1, "blue": 0, "alpha": 1},
      "range": {"start": {"line": 3, "character": 0}, "end": {"line": 3, "character": 1}}})");
  EXPECT_NE(label.find(R"(r=\"0.123\" g=\"1\" b=\"0\")"), std::string::npos) << label;
}

// Messages that are cut off or changed get an answer, or none.
TEST_F(Client, BrokenMessagesAreSafe) {
  initialize();
  open(scene);
  const std::string message =
      R"({"jsonrpc": "2.0", "id": 1, "method": "textDocument/rename", "params": {"textDocument":
      {"uri": "s"}, "position": {"line": 5, "character": -4}, "newName": "x"}})";
  for (std::size_t i = 0; i < message.size(); ++i) {
    std::string broken = message;
    broken[i] = '7';
    server.handle(broken, now);
    server.handle(message.substr(0, i), now);
  }
  findings();
  for (const std::string uri : {"file://", "file://x", "file:", "%", "a%2", ""}) {
    notify("textDocument/didOpen",
           R"({"textDocument": {"uri": ")" + uri + R"(", "text": ")" + R"(<scenefile/>"}})");
    EXPECT_EQ(server.tick(now + 1).size(), 1U);
  }
  server.handle(R"({"id": {}, "method": "textDocument/hover"})", now);
  for (const std::string method : {"completion", "hover", "codeAction", "definition", "references",
                                   "documentHighlight", "colorPresentation", "rename"}) {
    request("textDocument/" + method, R"({"textDocument": {"uri": "s"}})");
  }
}

TEST_F(Client, SaysWhatValuesAre) {
  initialize();
  const std::string use = R"({"textDocument": {"uri": "s"}})";
  open(
      "<scenefile><!-- \U0001F600 --><lightdata>\n<id v='1'/><type v='spot'/></lightdata>\n"
      "<object type='tree' name='7'/></scenefile>");
  // Lines and columns after the token before, length, type, whether it declares.
  EXPECT_EQ(result("textDocument/semanticTokens/full", use),
            R"({"data":[1,7,1,0,0,0,13,4,1,0,1,14,4,1,0,0,12,1,2,1]})");
  open(R"({"name": "root", "templateGroups": [{"name": "a"}], "groups": [{"name": "a"}]})");
  EXPECT_EQ(result("textDocument/semanticTokens/full", use), R"({"data":[0,46,1,2,1,0,27,1,2,0]})");
  open("<project><a v='1'/></project>");
  EXPECT_EQ(result("textDocument/semanticTokens/full", use), R"({"data":[]})");
}

}  // namespace
}  // namespace scenefile
