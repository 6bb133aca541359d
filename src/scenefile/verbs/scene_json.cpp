#include "scenefile/verbs/scene_json.h"

#include "scenefile/base/report.h"
#include "scenefile/edit/fix.h"
#include "scenefile/trace/layers.h"
#include "scenefile/trace/visit_options.h"
#include "scenefile/verbs/codes.h"
#include "scenefile/verbs/findings.h"

#include <array>
#include <optional>
#include <type_traits>

namespace scenefile {

namespace {

void add_correction(Json& json, const Correction& correction,
                    const std::vector<Replacement>& changes) {
  json.begin_object("correction");
  json.add({{"written", correction.written}, {"instead", correction.instead}});
  if (!changes.empty()) {
    json.add_objects("changes", changes, [&](const Replacement& change) {
      add_location(json, change.from);
      json.add(
          {{"end_line", change.to.line}, {"end_column", change.to.column}, {"text", change.text}});
    });
  }
  json.end_object();
}

void add_finding(Json& json, const Diagnostic& d, const std::vector<Replacement>& changes = {}) {
  json.add(
      {{"code", d.code->name}, {"severity", severity_name(d.severity)}, {"message", d.message}});
  if (!d.notes.empty()) {
    json.add("notes", d.notes);
  }
  if (!d.file.empty()) {
    json.add("file", d.file);
    if (!d.path.empty()) {
      json.add("path", d.path);
    }
  }
  add_location(json, d.location);
  if (d.correction) {
    add_correction(json, *d.correction, changes);
  }
}

void add_path(Json& json, const LoadedScene& scene) {
  json.add("file", scene.path);
  if (scene.unreadable) {
    json.add("error", scene.unreadable->text);
  }
}

void add_findings(Json& json, const LoadedScene& scene) {
  json.add("not_listed", scene.diagnostics.dropped());
  const std::vector<const Diagnostic*> findings = by_place(scene.diagnostics);
  const std::vector<std::vector<Replacement>> changes = replacements(scene.text, findings);
  json.add_objects("findings", findings, [&, i = std::size_t{0}](const Diagnostic* d) mutable {
    add_finding(json, *d, changes[i++]);
  });
}

// The value of an option.
template <typename T>
requires std::is_arithmetic_v<T>
void add_option(Json& json, T value) {
  json.value(value);
}
void add_option(Json& json, Profile profile) {
  json.value(profile_word(profile));
}
void add_option(Json& json, Mode mode) {
  json.value(mode_word(mode));
}
void add_option(Json& json, Convention convention) {
  json.value(convention_word(convention));
}
void add_option(Json& json, const Features& features) {
  json.begin_array();
  visit_options(features, [&](const OptionField& field, bool on) {
    if (on) {
      json.value(field.name);
    }
  });
  json.end_array();
}
void add_option(Json& json, const std::optional<PixelRegion>& crop) {
  json.begin_array();
  visit_options(*crop, [&](const OptionField&, int side) { json.value(side); });
  json.end_array();
}
void add_option(Json& json, const std::vector<Layer>& layers) {
  json.begin_array();
  for (const Layer& layer : layers) {
    json.value(layer_name(layer));
  }
  json.end_array();
}

bool is_set(bool value) {
  return value;
}
bool is_set(const std::optional<PixelRegion>& crop) {
  return crop.has_value();
}
bool is_set(const std::vector<Layer>& layers) {
  return !layers.empty();
}
template <typename T>
bool is_set(const T&) {
  return true;
}

}  // namespace

void begin_document(Json& json, std::string_view command) {
  json.begin_object();
  json.add({{"scenefile", SCENEFILE_VERSION}, {"command", command}});
}

void add_location(Json& json, Location location) {
  if (location.known()) {
    json.add({{"line", location.line}, {"column", location.column}});
  }
}

void add_scene(Json& json, const LoadedScene& scene, const FixReport* fixes) {
  json.begin_object();
  add_path(json, scene);
  json.add({{"verdict", verdict_word(verdict_of(scene))},
            {"errors", scene.diagnostics.count(Severity::error)},
            {"warnings", scene.diagnostics.count(Severity::warning)},
            {"notes", scene.diagnostics.count(Severity::note)}});
  add_findings(json, scene);
  if (fixes != nullptr) {
    json.add_objects("fixed", fixes->made, [&](const Diagnostic& d) { add_finding(json, d); });
    if (!fixes->error.empty()) {
      json.add("write_error", fixes->error);
    }
  }
  json.end_object();
}

std::string scene_json(const LoadedScene& scene, const FixReport* fixes) {
  Json json;
  add_scene(json, scene, fixes);
  return json.text();
}

std::string parsed_file_json(const LoadedScene& file) {
  Json json;
  json.begin_object();
  add_path(json, file);
  add_findings(json, file);
  json.end_object();
  return json.text();
}

std::string check_json(const std::vector<std::string>& scenes) {
  Json json;
  begin_document(json, "check");
  json.begin_array("scenes");
  for (const std::string& scene : scenes) {
    json.raw(scene);
  }
  json.end_array();
  json.end_object();
  return json.text();
}

void add_render_options(Json& json, const RenderOptions& options) {
  visit_options(options, [&](const OptionField& field, const auto& value) {
    const bool said = field.answers == InAnswers::always ||
                      (field.answers == InAnswers::when_set && is_set(value));
    if (said && supports_option(options.profile, field.support) &&
        supports_option(options.mode, field.support)) {
      json.key(field.name);
      add_option(json, value);
    }
  });
}

void add_realtime_options(Json& json, const RealtimeOptions& options) {
  const auto& [parameter1, parameter2] = options.tessellation;
  json.add({{"milestone", word_of(options.milestone)},
            {"parameters", std::array{parameter1, parameter2}},
            {"near", options.near},
            {"far", options.far},
            {"filter", word_of(options.filter)}});
}

}  // namespace scenefile
