#pragma once
// What the commands make of the findings about a scene.

#include "app/load.h"

#include <array>
#include <cstddef>
#include <string>

namespace scenefile::app {

/// --strict, --deny, --allow CODE.
void apply_policy(const Options& options, Diagnostics& diagnostics);

/// The exit status that the scene has earned so far.
ExitCode status_of(const LoadedScene& scene);

enum class Verdict { fine, warnings, errors, unreadable };
Verdict verdict_of(const LoadedScene& scene);

/// How many scenes earned which verdict.
class Tally {
 public:
  void add(const LoadedScene& scene);
  /// "4 scenes: 1 fine, 2 with warnings, 1 with errors", and the end of the line.
  std::string text() const;

 private:
  std::array<std::size_t, 4> counts_{};
};

enum class Verbosity {
  errors,    ///< errors alone
  warnings,  ///< and warnings, with a verdict when there are any
  all,       ///< and notes, always with a verdict
};

/// Findings with excerpts, and the verdict.
std::string findings_text(const LoadedScene& scene, Verbosity verbosity, bool color);

}  // namespace scenefile::app
