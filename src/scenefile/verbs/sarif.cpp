#include "scenefile/verbs/sarif.h"

#include "scenefile/base/hash.h"
#include "scenefile/base/report.h"
#include "scenefile/verbs/codes.h"
#include "scenefile/verbs/json_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace scenefile {

namespace {

// A path as a URI reference (RFC 3986): all but unreserved characters are percent-encoded.
std::string uri_of(std::string_view path) {
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    if (plain.find(c) != std::string_view::npos) {
      uri += c;
    } else {
      fmt::format_to(std::back_inserter(uri), "%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return uri;
}

std::string_view level_of(Severity severity) {
  return severity_name(severity);  // SARIF uses the same three words
}

void add_text(Json& json, std::string_view name, std::string_view text) {
  json.begin_object(name);
  json.add("text", text);
  json.end_object();
}

void add_rule(Json& json, const Code& code) {
  json.begin_object();
  json.add("id", code.name);
  add_text(json, "shortDescription", code.summary);
  add_text(json, "fullDescription", code.help);
  add_text(json, "help", code.help);
  json.begin_object("defaultConfiguration");
  json.add("level", level_of(code.severity));
  json.end_object();
  json.end_object();
}

void add_artifact(Json& json, const std::string& path) {
  json.begin_object("artifactLocation");
  json.add("uri", path == "-" ? "stdin" : uri_of(path));
  if (!path.starts_with('/')) {
    json.add("uriBaseId", "%SRCROOT%");
  }
  json.end_object();
}

void add_fixes(Json& json, const std::string& path, const std::vector<Replacement>& replacements) {
  if (replacements.empty()) {
    return;
  }
  json.begin_array("fixes");
  json.begin_object();
  json.begin_array("artifactChanges");
  json.begin_object();
  add_artifact(json, path);
  json.begin_array("replacements");
  for (const Replacement& replacement : replacements) {
    json.begin_object();
    json.begin_object("deletedRegion");
    json.add("startLine", replacement.from.line);
    json.add("startColumn", replacement.from.column);
    json.add("endLine", replacement.to.line);
    json.add("endColumn", replacement.to.column);
    json.end_object();
    add_text(json, "insertedContent", replacement.text);
    json.end_object();
  }
  json.end_array();
  json.end_object();
  json.end_array();
  json.end_object();
  json.end_array();
}

// Code hosts ignore findings without a line, so those without a place are put on the first line.
void add_place(Json& json, const std::string& path, Location location) {
  json.begin_object("physicalLocation");
  add_artifact(json, path);
  json.begin_object("region");
  json.add("startLine", location.known() ? location.line : 1u);
  if (location.known() && location.column != 0) {
    json.add("startColumn", location.column);
  }
  json.end_object();
  json.end_object();
}

void add_locations(Json& json, const std::string& scene, const std::string& file, Location location,
                   Location used_at) {
  json.begin_array("locations");
  json.begin_object();
  add_place(json, file.empty() ? scene : file, location);
  json.end_object();
  json.end_array();
  if (!file.empty()) {
    json.begin_array("relatedLocations");
    json.begin_object();
    add_place(json, scene, used_at);
    add_text(json, "message", "the scene names the file here");
    json.end_object();
    json.end_array();
  }
}

// Where the scene refers to a file.
Location used_at(const RenderScene& scene, const std::string& name) {
  for (const auto* references : {&scene.texture_files, &scene.mesh_files}) {
    for (const FileReference& reference : *references) {
      if (reference.name == name) {
        return reference.location;
      }
    }
  }
  return {};
}

// Findings inside a mesh name the mesh and its line.
std::string message_of(const Diagnostic& d) {
  std::string text = d.message;
  if (!d.file.empty()) {
    text = d.location.known() ? fmt::format("{}:{}: {}", d.file, d.location.line, d.message)
                              : fmt::format("{}: {}", d.file, d.message);
  }
  for (const std::string& note : d.notes) {
    text += "\n" + note;
  }
  return text;
}

// Iterates over the lines of a text.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  // The line, trimmed. `line` counts from 1 and must not decrease.
  std::string_view at(std::uint32_t line) {
    while (line_ < line && !rest_.empty()) {
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size() - 1) + 1);
      ++line_;
    }
    constexpr std::string_view blanks = " \t\r";
    constexpr std::size_t longest = 400;
    std::string_view text = rest_.substr(0, std::min(rest_.find('\n'), longest));
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
  }

 private:
  std::string_view rest_;
  std::uint32_t line_ = 1;
};

// Depends on the code and the text of the line, not on its number.
std::string fingerprint_of(const Diagnostic& d, Lines& lines) {
  Hash hash;
  hash.add(d.code->name);
  hash.add(d.file.empty() && d.location.known() ? lines.at(d.location.line) : message_of(d));
  return fmt::format("{:016x}", hash.value());
}

void add_driver(Json& json, const std::map<std::string_view, const Code*>& rules) {
  json.begin_object("tool");
  json.begin_object("driver");
  json.add("name", "scenefile");
  json.add("version", SCENEFILE_VERSION);
  json.begin_array("rules");
  for (const auto& [name, code] : rules) {
    add_rule(json, *code);
  }
  json.end_array();
  json.end_object();
  json.end_object();
}

void add_invocation(Json& json, const std::vector<std::string>& unreadable, int exit_status) {
  json.begin_array("invocations");
  json.begin_object();
  json.add("executionSuccessful", unreadable.empty());
  json.add("exitCode", exit_status);
  json.begin_array("toolExecutionNotifications");
  for (const std::string& text : unreadable) {
    json.begin_object();
    json.add("level", "error");
    add_text(json, "message", text);
    json.end_object();
  }
  json.end_array();
  json.end_object();
  json.end_array();
}

}  // namespace

void SarifLog::add(const LoadedScene& scene) {
  if (scene.unreadable) {
    unreadable_.push_back(scene.unreadable->text);
  }
  Lines lines(scene.text);
  std::map<std::string, int> seen;
  const std::vector<const Diagnostic*> findings = by_place(scene.diagnostics);
  std::vector<std::vector<Replacement>> fixes = replacements(scene.text, findings);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Diagnostic* const d = findings[i];
    const std::string fingerprint = fingerprint_of(*d, lines);
    entries_.push_back(
        {scene.path, d->path, d->path.empty() ? Location{} : used_at(scene.ready.scene, d->file),
         *d, fmt::format("{}:{}", fingerprint, ++seen[fingerprint]), std::move(fixes[i])});
    rules_.emplace(d->code->name, d->code);
  }
}

std::string SarifLog::text(int exit_status) const {
  Json json;
  json.begin_object();
  json.add("$schema", "https://json.schemastore.org/sarif-2.1.0.json");
  json.add("version", "2.1.0");
  json.begin_array("runs");
  json.begin_object();
  add_driver(json, rules_);
  add_invocation(json, unreadable_, exit_status);
  json.add("columnKind", "unicodeCodePoints");
  json.begin_array("results");
  for (const Entry& result : entries_) {
    const std::string_view name = result.finding.code->name;
    json.begin_object();
    json.add("ruleId", name);
    json.add("ruleIndex", std::distance(rules_.begin(), rules_.find(name)));
    json.add("level", level_of(result.finding.severity));
    add_text(json, "message", message_of(result.finding));
    // Findings in a file that is no longer found are put on the first line of the scene.
    const bool placed = result.finding.file.empty() || !result.file.empty();
    add_locations(json, result.scene, result.file, placed ? result.finding.location : Location{},
                  result.used_at);
    json.begin_object("partialFingerprints");
    json.add("codeAndLine/v1", result.fingerprint);
    json.end_object();
    add_fixes(json, result.scene, result.fixes);
    json.end_object();
  }
  json.end_array();
  json.end_object();
  json.end_array();
  json.end_object();
  return json.text();
}

}  // namespace scenefile
