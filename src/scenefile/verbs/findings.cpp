#include "scenefile/verbs/findings.h"

#include "scenefile/format/scene_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

// A limit reported as a warning becomes an ordinary error if its code is denied.
bool is_limit(const Diagnostic& d) {
  return d.code->severity == Severity::error && d.severity == Severity::error &&
         d.code->kind == CodeKind::limit;
}

// Whether the only finding is an error about the whole file, such as that it is not a scene.
bool is_verdict(const std::vector<Diagnostic>& list) {
  return list.size() == 1 && list[0].severity == Severity::error && list[0].file.empty() &&
         !list[0].location.known();
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void apply_policy(const FindingPolicy& policy, Diagnostics& diagnostics) {
  diagnostics.rewrite([&](const Code& code, Severity severity) -> std::optional<Severity> {
    if (severity == Severity::error) {
      return severity;
    }
    if (contains(policy.allowed, code.name)) {
      return std::nullopt;
    }
    const bool strict = policy.deny_warnings || (policy.strict && code.kind == CodeKind::dialect);
    const bool raised =
        (severity == Severity::warning && strict) || contains(policy.denied, code.name);
    return raised ? Severity::error : severity;
  });
}

std::optional<ErrorKind> failure_of(const LoadedScene& scene) {
  if (scene.unreadable) {
    return scene.unreadable->kind;
  }
  const std::vector<Diagnostic>& list = scene.diagnostics.list();
  if (std::any_of(list.begin(), list.end(), is_limit)) {
    return ErrorKind::limit;
  }
  return scene.diagnostics.has_errors() ? std::optional(ErrorKind::input) : std::nullopt;
}

std::string_view verdict_word(SceneVerdict verdict) {
  switch (verdict) {
    case SceneVerdict::fine:
      return "fine";
    case SceneVerdict::warnings:
      return "warnings";
    case SceneVerdict::errors:
      return "errors";
    case SceneVerdict::unreadable:
      return "unreadable";
  }
  return {};
}

SceneVerdict verdict_of(const LoadedScene& scene) {
  if (scene.unreadable) {
    return SceneVerdict::unreadable;
  }
  if (scene.diagnostics.has_errors()) {
    return SceneVerdict::errors;
  }
  return scene.diagnostics.count(Severity::warning) != 0 ? SceneVerdict::warnings
                                                         : SceneVerdict::fine;
}

void VerdictCounts::add(const LoadedScene& scene) {
  ++counts_[static_cast<std::size_t>(verdict_of(scene))];
}

std::string VerdictCounts::text() const {
  static constexpr std::array<std::string_view, scene_verdict_count> words{
      "fine", "with warnings", "with errors", "unreadable"};
  std::size_t total = 0;
  std::string parts;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    total += counts_[i];
    if (counts_[i] != 0) {
      parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", counts_[i], words[i]);
    }
  }
  return fmt::format("{} scenes: {}\n", total, parts);
}

std::string report_text(const LoadedScene& scene, const Diagnostics& shown,
                        const ReportStyle& style) {
  std::string storage;
  Diagnostics ignored;
  const std::string_view text = decode_text(scene.text, storage, ignored).value_or(scene.text);
  return report_text(shown, shown_name(scene.path), text, style);
}

std::string findings_text(const LoadedScene& scene, Verbosity verbosity, bool color) {
  const std::string name = shown_name(scene.path);
  if (scene.unreadable) {
    return "scenefile: " + scene.unreadable->text + "\n";
  }
  Diagnostics shown = scene.diagnostics;
  if (verbosity == Verbosity::errors) {
    shown.rewrite([](const Code&, Severity severity) {
      return severity == Severity::error ? std::optional(severity) : std::nullopt;
    });
  }
  const ReportStyle style{.color = color, .excerpt = true, .notes = verbosity == Verbosity::all};
  std::string text = report_text(scene, shown, style);
  const bool any = shown.count(Severity::error) + shown.count(Severity::warning) != 0;
  if (!is_verdict(shown.list()) &&
      (verbosity == Verbosity::all || (any && verbosity == Verbosity::warnings))) {
    text += verdict_text(shown, name) + "\n";
  }
  if (const auto& list = shown.list(); std::any_of(list.begin(), list.end(), is_limit)) {
    text += "\"scenefile help limits\" says how to raise a limit.\n";
  }
  return text;
}

}  // namespace scenefile
