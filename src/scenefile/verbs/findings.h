#pragma once
// Evaluates the findings about a scene: whether it is usable, and the human-readable report. For
// JSON and SARIF, see scene_json.h and sarif.h.

#include "scenefile/base/report.h"
#include "scenefile/verbs/load_scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scenefile {

/// How strictly to treat findings.
struct FindingPolicy {
  bool strict = false;               ///< spellings that only some programs accept are errors
  bool deny_warnings = false;        ///< every warning is an error
  std::vector<std::string> denied;   ///< names of codes whose findings are errors
  std::vector<std::string> allowed;  ///< names of codes whose findings are ignored, except errors
};

/// Changes severities, and removes allowed findings.
void apply_policy(const FindingPolicy& policy, Diagnostics& diagnostics);

/// Why the scene is not usable (it could not be read, exceeds a limit, or has errors); nullopt if
/// it is usable.
std::optional<ErrorKind> failure_of(const LoadedScene& scene);

enum class SceneVerdict : std::uint8_t { fine, warnings, errors, unreadable };
inline constexpr std::size_t scene_verdict_count = 4;
/// The word in JSON output: "fine", "warnings", "errors", "unreadable".
std::string_view verdict_word(SceneVerdict verdict);
SceneVerdict verdict_of(const LoadedScene& scene);

/// Counts scenes by verdict.
class VerdictCounts {
 public:
  void add(const LoadedScene& scene);
  /// "4 scenes: 1 fine, 2 with warnings, 1 with errors", with a line end.
  std::string text() const;

 private:
  std::array<std::size_t, scene_verdict_count> counts_{};
};

enum class Verbosity : std::uint8_t {
  errors,    ///< only errors
  warnings,  ///< also warnings; a verdict if there are any
  all,       ///< also notes; always a verdict
};

/// The findings `shown`, with excerpts of the scene file, whatever its encoding; see report.h.
std::string report_text(const LoadedScene& scene, const Diagnostics& shown,
                        const ReportStyle& style);

/// Findings with excerpts, and the verdict. For a scene that could not be read, the reason.
std::string findings_text(const LoadedScene& scene, Verbosity verbosity = Verbosity::warnings,
                          bool color = false);

}  // namespace scenefile
