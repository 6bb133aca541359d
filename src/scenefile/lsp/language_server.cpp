#include "scenefile/lsp/language_server.h"

#include "scenefile/base/limits.h"
#include "scenefile/base/text.h"
#include "scenefile/edit/fix.h"
#include "scenefile/edit/format_text.h"
#include "scenefile/edit/template_name.h"
#include "scenefile/format/recognize.h"
#include "scenefile/format/write_text.h"
#include "scenefile/lsp/completion.h"
#include "scenefile/lsp/json_message.h"
#include "scenefile/lsp/outline.h"
#include "scenefile/lsp/text_lines.h"
#include "scenefile/scene/codes.h"
#include "scenefile/verbs/json_writer.h"
#include "scenefile/verbs/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace scenefile {

namespace {

constexpr double pause = 0.04;  // seconds without a change before a scene is checked
constexpr std::uint32_t message_nesting = 200;

// Errors of JSON-RPC and of the protocol.
enum class LspError : int {
  parse = -32700,
  invalid_request = -32600,
  unknown_method = -32601,
  invalid_params = -32602,
  not_initialized = -32002,
  request_failed = -32803,
};

struct Failure {
  LspError code;
  std::string text;
};

// The textures and meshes of a scene as they were when it was last checked with them.
struct KnownAssets {
  std::vector<std::string> names;
  Assets assets;
  std::vector<std::pair<Diagnostic, std::size_t>> findings;  // with the index of the name
  bool stale = true;                                         // to be read again
};

struct Document {
  std::string uri;
  std::string path;
  std::string version;  // JSON
  std::string text;
  std::optional<double> due;  // when it is to be checked
  std::vector<Diagnostic> findings;
  std::vector<std::vector<Replacement>> corrections;
  KnownAssets assets;
};

// The text of an editor is UTF-8, whatever encoding it declares: a byte order mark says so.
std::string as_utf8(std::string_view text) {
  return std::string(utf8_mark).append(without_byte_order_mark(text));
}

struct ByteRange {
  std::size_t from = 0;
  std::size_t to = 0;
};

// file:///a%20b.xml is /a b.xml; for other URIs the last part.
std::string path_of(std::string_view uri) {
  constexpr std::string_view file = "file://";
  const bool is_file = uri.starts_with(file);
  const std::size_t start = is_file ? uri.find('/', file.size()) : uri.rfind('/') + 1;
  std::string_view rest = uri.substr(std::min(start, uri.size()));
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'                     ? c - '0'
           : (c | 0x20) >= 'a' && (c | 0x20) <= 'f' ? (c | 0x20) - 'a' + 10
                                                    : -1;
  };
  std::string path;
  while (!rest.empty()) {
    const bool escape =
        rest[0] == '%' && rest.size() > 2 && digit(rest[1]) >= 0 && digit(rest[2]) >= 0;
    path += escape ? static_cast<char>(16 * digit(rest[1]) + digit(rest[2])) : rest[0];
    rest.remove_prefix(escape ? 3 : 1);
  }
  return path;
}

std::vector<const FileReference*> references_of(const LoadedScene& scene) {
  std::vector<const FileReference*> all;
  for (const auto* list : {&scene.ready.scene.texture_files, &scene.ready.scene.mesh_files}) {
    for (const FileReference& file : *list) {
      all.push_back(&file);
    }
  }
  return all;
}

bool is_about_asset(const Diagnostic& d) {
  const std::string_view name = d.code->name;
  return name.starts_with("texture.") || name.starts_with("mesh.") || name.starts_with("mtl.");
}

// Reads and checks the text. Textures and meshes are only read if their names are others than
// before, because that can take long.
LoadedScene checked(Document& document, const FetchFile& fetch) {
  LoadSettings settings;
  settings.depth = LoadDepth::prepared;
  LoadedScene scene = load_scene(document.path, as_utf8(document.text), {}, settings);
  KnownAssets& known = document.assets;
  std::vector<std::string> names;
  for (const FileReference* file : references_of(scene)) {
    names.push_back(file->name);
  }
  if (!fetch || names.empty()) {
    known = {};
  } else if (known.stale || names != known.names) {
    settings.depth = LoadDepth::with_all_assets;
    scene = load_scene(document.path, as_utf8(document.text), fetch, settings);
    known = {std::move(names), scene.assets, {}, false};
    const std::vector<const FileReference*> references = references_of(scene);
    for (const Diagnostic& d : scene.diagnostics.list()) {
      const auto by_place = [&](const FileReference* file) {
        return d.file.empty() ? file->location == d.location : file->name == d.file;
      };
      const auto file = std::find_if(references.begin(), references.end(), by_place);
      if (is_about_asset(d)) {
        known.findings.emplace_back(d, static_cast<std::size_t>(file - references.begin()));
      }
    }
  } else {
    scene.assets = known.assets;
    const std::vector<const FileReference*> references = references_of(scene);
    for (const auto& [finding, index] : known.findings) {
      Diagnostic d = finding;
      d.location =
          d.file.empty() && index < references.size() ? references[index]->location : d.location;
      scene.diagnostics.add(std::move(d));
    }
    if (has_emissive_faces(scene.assets)) {
      scene.diagnostics.rewrite([](const Code& code, Severity severity) {
        return &code == &"scene.no-light"_code ? std::nullopt : std::optional(severity);
      });
    }
  }
  check_picture(scene);
  return scene;
}

// Where an editor shows findings about another file: at the first mention of that.
Location place_in_scene(const Diagnostic& d, const LoadedScene& scene) {
  if (d.file.empty()) {
    return d.location;
  }
  for (const FileReference* file : references_of(scene)) {
    if (file->name == d.file) {
      return file->location;
    }
  }
  return {};
}

void add_position(Json& json, std::string_view name, LspPosition position) {
  json.begin_object(name);
  json.add("line", position.line);
  json.add("character", position.character);
  json.end_object();
}

void add_range(Json& json, std::string_view name, const TextLines& lines, ByteRange range) {
  json.begin_object(name);
  add_position(json, "start", lines.position(range.from));
  add_position(json, "end", lines.position(range.to));
  json.end_object();
}

void add_edit(Json& json, const TextLines& lines, ByteRange range, std::string_view text) {
  json.begin_object();
  add_range(json, "range", lines, range);
  json.add("newText", text);
  json.end_object();
}

ByteRange range_of(const Diagnostic& d, std::string_view text, const TextLines& lines) {
  const std::size_t from = lines.offset(d.location);
  return {from, d.location.known() ? word_end(text, from) : from};
}

void add_diagnostic(Json& json, const Diagnostic& d, std::string_view text,
                    const TextLines& lines) {
  json.begin_object();
  add_range(json, "range", lines, range_of(d, text, lines));
  json.add("severity", d.severity == Severity::error ? 1 : d.severity == Severity::warning ? 2 : 3);
  json.add("code", d.code->name);
  json.add("source", "scenefile");
  std::string message = d.message;
  for (const std::string& note : d.notes) {
    message += "\n" + note;
  }
  json.add("message", message);
  json.end_object();
}

LspPosition position_in(JsonView value) {
  const auto count = [](JsonView number) {
    return static_cast<std::uint32_t>(std::clamp(number.number(), 0.0, 4e9));
  };
  return {count(value["line"]), count(value["character"])};
}

ByteRange range_in(JsonView value, const TextLines& lines) {
  const std::size_t from = lines.offset(position_in(value["start"]));
  return {from, std::max(from, lines.offset(position_in(value["end"])))};
}

int symbol_kind(OutlineKind kind) {
  enum {
    module = 2,
    name_space = 3,
    object = 19,
    event = 24,
    constant = 14,
    interface = 11,
    klass = 5
  };
  switch (kind) {
    case OutlineKind::globals:
      return constant;
    case OutlineKind::camera:
      return interface;
    case OutlineKind::light:
      return event;
    case OutlineKind::tree:
      return klass;
    case OutlineKind::group:
      return name_space;
    case OutlineKind::instance:
      return module;
    case OutlineKind::primitive:
      return object;
  }
  return object;
}

void add_symbols(Json& json, const std::vector<OutlinePart>& parts, const TextLines& lines) {
  json.begin_array();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const OutlinePart& part = parts[i];
    json.begin_object();
    json.add("name", part.name.empty() ? std::string("object") : part.name);
    json.add("detail", part.detail);
    json.add("kind", symbol_kind(part.kind));
    add_range(json, "range", lines, {part.from, part.to});
    add_range(json, "selectionRange", lines, {part.from, part.from});
    json.begin_array("children");
    // Leaves all parts that the next one is not inside.
    const std::uint32_t next = i + 1 < parts.size() ? parts[i + 1].depth : 0;
    for (std::uint32_t depth = part.depth + 1; depth > next; --depth) {
      json.end_array();
      json.end_object();
    }
  }
  json.end_array();
}

}  // namespace

class LanguageServer::Session {
 public:
  explicit Session(FilesOfScene files) : files_(std::move(files)) {}

  std::vector<std::string> handle(std::string_view body, double now) {
    JsonTape tape;
    if (parse_json(body, message_nesting, tape).fault != JsonFault::none || !tape.is_object(0)) {
      reply_error("null", {LspError::parse, "the message is not a JSON object"});
      return std::move(out_);
    }
    const JsonView message(tape, 0);
    const std::string method = message["method"].string();
    const JsonView id = message["id"];
    if (method.empty()) {
      if (!message["result"].exists() && !message["error"].exists()) {
        reply_error(id.exists() ? id.raw() : "null",
                    {LspError::invalid_request, "the message has no method"});
      }
    } else if (id.exists()) {
      request(id.raw(), method, message["params"]);
    } else {
      notification(method, message["params"], now);
    }
    return std::move(out_);
  }

  std::optional<double> next_tick() const {
    std::optional<double> next;
    for (const auto& [uri, document] : documents_) {
      if (document.due && (!next || *document.due < *next)) {
        next = document.due;
      }
    }
    return next;
  }

  std::vector<std::string> tick(double now) {
    for (auto& [uri, document] : documents_) {
      if (document.due && *document.due <= now) {
        publish(document);
      }
    }
    return std::move(out_);
  }

  std::optional<int> exit_status() const { return exit_; }

 private:
  using Answer = std::optional<Failure>;  // nullopt: the result was written

  void send(const Json& json) { out_.push_back(json.text()); }

  void reply_error(std::string_view id, const Failure& failure) {
    Json json;
    json.begin_object();
    json.add("jsonrpc", "2.0");
    json.key("id");
    json.raw(id);
    json.begin_object("error");
    json.add("code", static_cast<int>(failure.code));
    json.add("message", failure.text);
    json.end_object();
    json.end_object();
    send(json);
  }

  void request(std::string_view id, const std::string& method, JsonView params) {
    if (!initialized_ && method != "initialize") {
      reply_error(id, {LspError::not_initialized, "the first request must be initialize"});
      return;
    }
    if (shut_down_) {
      reply_error(id, {LspError::invalid_request, "the server was shut down"});
      return;
    }
    Json json;
    json.begin_object();
    json.add("jsonrpc", "2.0");
    json.key("id");
    json.raw(id);
    json.key("result");
    if (const Answer failure = answer(method, params, json)) {
      reply_error(id, *failure);
      return;
    }
    json.end_object();
    send(json);
  }

  Answer answer(const std::string& method, JsonView params, Json& json) {
    if (method == "initialize") {
      initialized_ = true;
      add_capabilities(json);
      return std::nullopt;
    }
    if (method == "shutdown") {
      shut_down_ = true;
      json.raw("null");
      return std::nullopt;
    }
    struct Row {
      std::string_view method;
      Answer (Session::*function)(Document& document, JsonView params, Json& json);
    };
    static constexpr Row rows[] = {
        {"textDocument/completion", &Session::completion},
        {"textDocument/hover", &Session::hover},
        {"textDocument/codeAction", &Session::code_actions},
        {"textDocument/formatting", &Session::formatting},
        {"textDocument/documentSymbol", &Session::symbols},
        {"textDocument/definition", &Session::definition},
        {"textDocument/references", &Session::references},
        {"textDocument/documentHighlight", &Session::highlights},
        {"textDocument/prepareRename", &Session::prepare_rename},
        {"textDocument/rename", &Session::rename},
        {"textDocument/documentColor", &Session::colors},
        {"textDocument/colorPresentation", &Session::color_presentations},
        {"textDocument/semanticTokens/full", &Session::semantic_tokens},
    };
    const auto* const row = std::find_if(std::begin(rows), std::end(rows),
                                         [&](const Row& r) { return r.method == method; });
    if (row == std::end(rows)) {
      return Failure{LspError::unknown_method, fmt::format("unknown method {}", method)};
    }
    const auto document = documents_.find(params["textDocument"]["uri"].string());
    if (document == documents_.end()) {
      return Failure{LspError::invalid_params, "the document is not open"};
    }
    return (this->*row->function)(document->second, params, json);
  }

  static void add_capabilities(Json& json) {
    json.begin_object();
    json.begin_object("capabilities");
    json.add("positionEncoding", "utf-16");
    json.begin_object("textDocumentSync");
    json.add("openClose", true);
    json.add("change", 2);  // ranges
    json.add("save", true);
    json.end_object();
    for (const std::string_view name :
         {"hoverProvider", "documentFormattingProvider", "documentSymbolProvider",
          "definitionProvider", "referencesProvider", "documentHighlightProvider",
          "colorProvider"}) {
      json.add(name, true);
    }
    json.begin_object("completionProvider");
    json.begin_array("triggerCharacters");
    for (const std::string_view c : {"<", "\"", " ", "/"}) {
      json.value(c);
    }
    json.end_array();
    json.end_object();
    json.begin_object("codeActionProvider");
    json.begin_array("codeActionKinds");
    json.value(std::string_view("quickfix"));
    json.value(std::string_view("source.fixAll"));
    json.end_array();
    json.end_object();
    json.begin_object("semanticTokensProvider");
    json.begin_object("legend");
    json.begin_array("tokenTypes");  // in the order of TokenType
    for (const std::string_view type : {"number", "enumMember", "class"}) {
      json.value(type);
    }
    json.end_array();
    json.begin_array("tokenModifiers");
    json.value(std::string_view("declaration"));
    json.end_array();
    json.end_object();
    json.add("full", true);
    json.end_object();
    json.begin_object("renameProvider");
    json.add("prepareProvider", true);
    json.end_object();
    json.end_object();
    json.begin_object("serverInfo");
    json.add("name", "scenefile");
    json.end_object();
    json.end_object();
  }

  void notification(const std::string& method, JsonView params, double now) {
    const JsonView item = params["textDocument"];
    const std::string uri = item["uri"].string();
    if (method == "exit") {
      exit_ = shut_down_ ? 0 : 1;
    } else if (method == "textDocument/didOpen") {
      Document& document = documents_[uri];
      document = {};
      document.uri = uri;
      document.path = path_of(uri);
      document.text = item["text"].string();
      document.version = item["version"].raw();
      document.due = now;
    } else if (const auto found = documents_.find(uri); found == documents_.end()) {
      return;
    } else if (method == "textDocument/didChange") {
      change(found->second, item, params["contentChanges"], now);
    } else if (method == "textDocument/didSave") {
      // A texture may have been added in the meantime.
      found->second.assets.stale = true;
      found->second.due = now;
    } else if (method == "textDocument/didClose") {
      found->second.findings.clear();
      found->second.version.clear();
      send_findings(found->second, TextLines(found->second.text));
      documents_.erase(found);
    }
  }

  // Most editors send changes from the end of the text to its beginning: places before a change
  // stay what they were.
  static void change(Document& document, JsonView item, JsonView changes, double now) {
    std::string before;
    std::optional<TextLines> lines;  // of `before`
    LspPosition changed;             // the first change since then
    const auto is_unchanged = [&](JsonView position) {
      const LspPosition p = position_in(position);
      return lines && std::pair(p.line, p.character) < std::pair(changed.line, changed.character);
    };
    for (const JsonView& one : changes.elements()) {
      const std::string text = one["text"].string();
      const JsonView place = one["range"];
      if (!place.exists()) {
        document.text = text;
        lines.reset();
        continue;
      }
      if (!is_unchanged(place["start"]) || !is_unchanged(place["end"])) {
        before = document.text;
        lines.emplace(before);
      }
      const ByteRange range = range_in(place, *lines);
      document.text.replace(range.from, range.to - range.from, text);
      changed = lines->position(range.from);
    }
    document.version = item["version"].raw();
    document.due = now + pause;
  }

  void publish(Document& document) {
    document.due.reset();
    document.findings.clear();
    if (has_scene_parts(document.text)) {
      const FetchFile fetch = files_ ? files_(document.uri, document.path) : FetchFile();
      const LoadedScene scene = checked(document, fetch);
      for (const Diagnostic& finding : scene.diagnostics.list()) {
        Diagnostic d = finding;
        d.location = place_in_scene(finding, scene);
        if (!d.file.empty()) {
          d.message = finding.location.known()
                          ? fmt::format("{}:{}: {}", d.file, finding.location.line, d.message)
                          : fmt::format("{}: {}", d.file, d.message);
        }
        document.findings.push_back(std::move(d));
      }
      std::stable_sort(document.findings.begin(), document.findings.end(),
                       [](const Diagnostic& a, const Diagnostic& b) {
                         return std::pair(a.location.line, a.location.column) <
                                std::pair(b.location.line, b.location.column);
                       });
    }
    std::vector<const Diagnostic*> all;
    for (const Diagnostic& d : document.findings) {
      all.push_back(&d);
    }
    document.corrections = replacements(as_utf8(document.text), all);
    send_findings(document, TextLines(document.text));
  }

  void send_findings(const Document& document, const TextLines& lines) {
    Json json;
    json.begin_object();
    json.add("jsonrpc", "2.0");
    json.add("method", "textDocument/publishDiagnostics");
    json.begin_object("params");
    json.add("uri", document.uri);
    if (!document.version.empty()) {
      json.key("version");
      json.raw(document.version);
    }
    json.begin_array("diagnostics");
    for (const Diagnostic& d : document.findings) {
      add_diagnostic(json, d, document.text, lines);
    }
    json.end_array();
    json.end_object();
    json.end_object();
    send(json);
  }

  // Findings for the current text: those that a request is about may be older.
  void catch_up(Document& document) {
    if (document.due) {
      publish(document);
    }
  }

  Answer completion(Document& document, JsonView params, Json& json) {
    const TextLines lines(document.text);
    const std::size_t offset = lines.offset(position_in(params["position"]));
    const Completion found = complete(document.text, offset);
    json.begin_array();
    for (const CompletionItem& item : found.items) {
      constexpr int kinds[] = {7, 10, 12};  // Class, Property, Value
      json.begin_object();
      json.add("label", item.label);
      json.add("kind", kinds[static_cast<int>(item.kind)]);
      if (!item.about.empty()) {
        json.add("documentation", item.about);
      }
      json.add("filterText", item.text);
      json.key("textEdit");
      add_edit(json, lines, {found.from, found.to}, item.text);
      json.end_object();
    }
    json.end_array();
    return std::nullopt;
  }

  Answer hover(Document& document, JsonView params, Json& json) {
    catch_up(document);
    const TextLines lines(document.text);
    const std::size_t offset = lines.offset(position_in(params["position"]));
    const auto tell = [&](std::string_view text, ByteRange range) {
      json.begin_object();
      json.begin_object("contents");
      json.add("kind", "plaintext");
      json.add("value", text);
      json.end_object();
      add_range(json, "range", lines, range);
      json.end_object();
    };
    for (const Diagnostic& d : document.findings) {
      const ByteRange range = range_of(d, document.text, lines);
      if (d.location.known() && range.from <= offset && offset < range.to) {
        tell(fmt::format("{}: {}\n\n{}", d.code->name, d.code->summary, d.code->help), range);
        return std::nullopt;
      }
    }
    if (const std::optional<WordMeaning> word = describe(document.text, offset)) {
      tell(word->about, {word->from, word->to});
    } else {
      json.raw("null");
    }
    return std::nullopt;
  }

  Answer code_actions(Document& document, JsonView params, Json& json) {
    catch_up(document);
    const TextLines lines(document.text);
    const std::uint32_t first = position_in(params["range"]["start"]).line;
    const std::uint32_t last = position_in(params["range"]["end"]).line;
    std::vector<std::string> only;
    for (const JsonView& kind : params["context"]["only"].elements()) {
      only.push_back(kind.string());
    }
    const auto wanted = [&](std::string_view kind) {
      return only.empty() || std::any_of(only.begin(), only.end(),
                                         [&](const std::string& o) { return kind.starts_with(o); });
    };
    json.begin_array();
    for (std::size_t i = 0; i < document.findings.size() && wanted("quickfix"); ++i) {
      const Diagnostic& d = document.findings[i];
      const std::vector<Replacement>& changes = document.corrections[i];
      const std::uint32_t line = lines.position(lines.offset(d.location)).line;
      if (!changes.empty() && first <= line && line <= last) {
        add_correction_action(json, document, d, changes, lines);
      }
    }
    if (!only.empty() && wanted("source.fixAll.scenefile")) {
      const std::string text = as_utf8(document.text);
      const FixedText fixed = fix_text(text, {});
      if (fixed.text != text) {
        begin_action(json, "Fix everything that is certain", "source.fixAll", document);
        add_edit(json, lines, whole(document), without_byte_order_mark(fixed.text));
        end_action(json);
      }
    }
    json.end_array();
    return std::nullopt;
  }

  // The text without its byte order mark.
  static ByteRange whole(const Document& document) {
    const std::size_t size = document.text.size();
    return {size - without_byte_order_mark(document.text).size(), size};
  }

  static void begin_action(Json& json, std::string_view title, std::string_view kind,
                           const Document& document) {
    json.begin_object();
    json.add("title", title);
    json.add("kind", kind);
    json.begin_object("edit");
    json.begin_object("changes");
    json.begin_array(document.uri);
  }

  static void end_action(Json& json) {
    json.end_array();
    json.end_object();
    json.end_object();
    json.end_object();
  }

  static void add_correction_action(Json& json, const Document& document, const Diagnostic& d,
                                    const std::vector<Replacement>& changes,
                                    const TextLines& lines) {
    const Correction& correction = *d.correction;
    const std::string title =
        correction.instead.empty()
            ? fmt::format("Remove {}", correction.written)
            : fmt::format("Change {} to {}", correction.written, changes[0].text);
    json.begin_object();
    json.add("title", title);
    json.add("kind", "quickfix");
    json.add("isPreferred", correction.certain);
    json.begin_array("diagnostics");
    add_diagnostic(json, d, document.text, lines);
    json.end_array();
    json.begin_object("edit");
    json.begin_object("changes");
    json.begin_array(document.uri);
    for (const Replacement& change : changes) {
      add_edit(json, lines, {lines.offset(change.from), lines.offset(change.to)}, change.text);
    }
    end_action(json);
  }

  Answer formatting(Document& document, JsonView /*params*/, Json& json) {
    Diagnostics ignored;
    const std::string before = as_utf8(document.text);
    const std::optional<std::string> text = lay_out(before, {}, ignored);
    json.begin_array();
    if (text && *text != before) {
      add_edit(json, TextLines(document.text), whole(document), without_byte_order_mark(*text));
    }
    json.end_array();
    return std::nullopt;
  }

  Answer symbols(Document& document, JsonView /*params*/, Json& json) {
    const bool scene = has_scene_parts(document.text);
    add_symbols(json, scene ? read_outline(document.text).parts : std::vector<OutlinePart>(),
                TextLines(document.text));
    return std::nullopt;
  }

  // The names in the text, and the one at the position of the request, or null.
  struct Named {
    std::vector<NameUse> all;
    std::vector<std::string> others;
    const NameUse* at = nullptr;
  };
  static Named name_at(const Document& document, JsonView params, const TextLines& lines) {
    Outline outline = read_outline(document.text);
    Named named{std::move(outline.names), std::move(outline.other_names), nullptr};
    const std::size_t offset = lines.offset(position_in(params["position"]));
    for (const NameUse& use : named.all) {
      named.at = use.from <= offset && offset <= use.to ? &use : named.at;
    }
    return named;
  }

  Answer definition(Document& document, JsonView params, Json& json) {
    const TextLines lines(document.text);
    const Named named = name_at(document, params, lines);
    for (const NameUse& use : named.all) {
      if (named.at != nullptr && use.declares && use.name == named.at->name) {
        add_place(json, document, lines, use);
        return std::nullopt;
      }
    }
    json.raw("null");
    return std::nullopt;
  }

  static void add_place(Json& json, const Document& document, const TextLines& lines,
                        const NameUse& use) {
    json.begin_object();
    json.add("uri", document.uri);
    add_range(json, "range", lines, {use.from, use.to});
    json.end_object();
  }

  Answer references(Document& document, JsonView params, Json& json) {
    const TextLines lines(document.text);
    const Named named = name_at(document, params, lines);
    const bool all = params["context"]["includeDeclaration"].is_true();
    json.begin_array();
    for (const NameUse& use : named.all) {
      if (named.at != nullptr && use.name == named.at->name && (all || !use.declares)) {
        add_place(json, document, lines, use);
      }
    }
    json.end_array();
    return std::nullopt;
  }

  Answer highlights(Document& document, JsonView params, Json& json) {
    const TextLines lines(document.text);
    const Named named = name_at(document, params, lines);
    json.begin_array();
    for (const NameUse& use : named.all) {
      if (named.at != nullptr && use.name == named.at->name) {
        json.begin_object();
        add_range(json, "range", lines, {use.from, use.to});
        json.end_object();
      }
    }
    json.end_array();
    return std::nullopt;
  }

  Answer prepare_rename(Document& document, JsonView params, Json& json) {
    const TextLines lines(document.text);
    const Named named = name_at(document, params, lines);
    if (named.at == nullptr) {
      json.raw("null");
      return std::nullopt;
    }
    json.begin_object();
    add_range(json, "range", lines, {named.at->from, named.at->to});
    json.add("placeholder", named.at->name);
    json.end_object();
    return std::nullopt;
  }

  Answer rename(Document& document, JsonView params, Json& json) {
    const TextLines lines(document.text);
    const Named named = name_at(document, params, lines);
    const std::string name = params["newName"].string();
    if (named.at == nullptr) {
      return Failure{LspError::request_failed, "there is no name of a template here"};
    }
    const bool taken =
        std::any_of(named.all.begin(), named.all.end(),
                    [&](const NameUse& use) { return use.name == name; }) ||
        std::find(named.others.begin(), named.others.end(), name) != named.others.end();
    const auto refuse = [](std::string why) {
      return Failure{LspError::request_failed, std::move(why)};
    };
    if (std::string why = why_no_template_name(name, looks_like_xml(document.text),
                                               taken && name != named.at->name);
        !why.empty()) {
      return refuse(std::move(why));
    }
    std::string written;
    if (!append_name(written, name, document.text)) {
      return refuse(
          fmt::format("the name {} has a character that XML cannot contain", quoted(name)));
    }
    if (written.size() > Limits().name_bytes) {
      return refuse(fmt::format("the name {} is longer than the limit of {} bytes", quoted(name),
                                Limits().name_bytes));
    }
    json.begin_object();
    json.begin_object("changes");
    json.begin_array(document.uri);
    for (const NameUse& use : named.all) {
      if (use.name == named.at->name) {
        add_edit(json, lines, {use.from, use.to}, written);
      }
    }
    json.end_array();
    json.end_object();
    json.end_object();
    return std::nullopt;
  }

  Answer colors(Document& document, JsonView /*params*/, Json& json) {
    const TextLines lines(document.text);
    json.begin_array();
    if (has_scene_parts(document.text)) {
      for (const ColorValue& color : read_outline(document.text).colors) {
        json.begin_object();
        add_range(json, "range", lines, {color.from, color.to});
        json.begin_object("color");
        json.add("red", color.rgb[0]);
        json.add("green", color.rgb[1]);
        json.add("blue", color.rgb[2]);
        json.add("alpha", 1);
        json.end_object();
        json.end_object();
      }
    }
    json.end_array();
    return std::nullopt;
  }

  Answer color_presentations(Document& document, JsonView params, Json& json) {
    const TextLines lines(document.text);
    const JsonView color = params["color"];
    const std::string text =
        color_text({color["red"].number(), color["green"].number(), color["blue"].number()},
                   looks_like_xml(document.text));
    json.begin_array();
    json.begin_object();
    json.add("label", text);
    json.key("textEdit");
    add_edit(json, lines, range_in(params["range"], lines), text);
    json.end_object();
    json.end_array();
    return std::nullopt;
  }

  Answer semantic_tokens(Document& document, JsonView /*params*/, Json& json) {
    enum class TokenType { number, word, name };
    struct Token {
      std::size_t from;
      std::size_t to;
      TokenType type;
      bool declares;
    };
    std::vector<Token> tokens;
    if (has_scene_parts(document.text)) {
      const Outline outline = read_outline(document.text);
      for (const PlainValue& value : outline.values) {
        const TokenType type = value.number ? TokenType::number : TokenType::word;
        tokens.push_back({value.from, value.to, type, false});
      }
      for (const NameUse& use : outline.names) {
        tokens.push_back({use.from, use.to, TokenType::name, use.declares});
      }
    }
    // A number may be the name of a template: the name comes first.
    std::sort(tokens.begin(), tokens.end(), [](const Token& a, const Token& b) {
      return std::pair(a.from, b.type) < std::pair(b.from, a.type);
    });
    const TextLines lines(document.text);
    json.begin_object();
    json.begin_array("data");
    LspPosition last;
    std::size_t end = 0;
    for (const Token& token : tokens) {
      const LspPosition from = lines.position(token.from);
      const LspPosition to = lines.position(token.to);
      if (from.line != to.line || token.from < end) {
        continue;
      }
      json.value(from.line - last.line);
      json.value(from.character - (from.line == last.line ? last.character : 0));
      json.value(to.character - from.character);
      json.value(static_cast<std::uint32_t>(token.type));
      json.value(token.declares ? 1U : 0U);
      last = from;
      end = token.to;
    }
    json.end_array();
    json.end_object();
    return std::nullopt;
  }

  // Inside of quotes. Returns whether all of it can be written.
  static bool append_name(std::string& written, std::string_view name, std::string_view text) {
    bool complete = true;
    if (looks_like_xml(text)) {
      complete = append_xml(written, name);
      for (std::size_t at = 0; (at = written.find('\'', at)) != written.npos;) {
        written.replace(at, 1, "&apos;");
      }
    } else {
      complete = append_json(written, name);
      written = written.substr(1, written.size() - 2);
    }
    return complete;
  }

  FilesOfScene files_;
  std::map<std::string, Document> documents_;
  std::vector<std::string> out_;
  bool initialized_ = false;
  bool shut_down_ = false;
  std::optional<int> exit_;
};

LanguageServer::LanguageServer(FilesOfScene files)
    : session_(std::make_unique<Session>(std::move(files))) {}

LanguageServer::~LanguageServer() = default;

std::vector<std::string> LanguageServer::handle(std::string_view body, double now) {
  return session_->handle(body, now);
}

std::optional<double> LanguageServer::next_tick() const {
  return session_->next_tick();
}

std::vector<std::string> LanguageServer::tick(double now) {
  return session_->tick(now);
}

std::optional<int> LanguageServer::exit_status() const {
  return session_->exit_status();
}

}  // namespace scenefile
