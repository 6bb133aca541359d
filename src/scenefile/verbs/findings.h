#pragma once
// What to make of the findings about a scene: whether it can be used, and the report for people.
// For programs: scene_json.h and sarif.h.

#include "scenefile/verbs/load_scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scenefile {

/// How strict to be.
struct FindingPolicy {
  bool strict = false;               ///< spellings that only some programs read are errors
  bool deny_warnings = false;        ///< every warning is an error
  std::vector<std::string> denied;   ///< names of codes whose findings are errors
  std::vector<std::string> allowed;  ///< names of codes whose findings, unless errors, do not count
};

/// Rewrites severities, drops what is allowed.
void apply_policy(const FindingPolicy& policy, Diagnostics& diagnostics);

/// Why the scene cannot be used, nothing where it can: it was not readable, is larger than the
/// limits allow, or has errors.
std::optional<ErrorKind> failure_of(const LoadedScene& scene);

enum class SceneVerdict : std::uint8_t { fine, warnings, errors, unreadable };
inline constexpr std::size_t scene_verdict_count = 4;
/// The word for programs: "fine", "warnings", "errors", "unreadable".
std::string_view verdict_word(SceneVerdict verdict);
SceneVerdict verdict_of(const LoadedScene& scene);

/// How many scenes earned which verdict.
class VerdictCounts {
 public:
  void add(const LoadedScene& scene);
  /// "4 scenes: 1 fine, 2 with warnings, 1 with errors", and the end of the line.
  std::string text() const;

 private:
  std::array<std::size_t, scene_verdict_count> counts_{};
};

enum class Verbosity : std::uint8_t {
  errors,    ///< errors alone
  warnings,  ///< and warnings, with a verdict when there are any
  all,       ///< and notes, always with a verdict
};

/// Findings with excerpts, and the verdict. Of a scene that is not readable the reason.
std::string findings_text(const LoadedScene& scene, Verbosity verbosity = Verbosity::warnings,
                          bool color = false);

}  // namespace scenefile
