#pragma once
// What the commands make of the findings about a scene.

#include "app/load.h"

#include <string>

namespace scenefile::app {

/// --strict, --deny warnings, --allow CODE.
void apply_policy(const Options& options, Diagnostics& diagnostics);

/// The exit status that the scene has earned so far.
ExitCode status_of(const LoadedScene& scene);

enum class Verbosity {
  errors,    ///< errors alone
  warnings,  ///< and warnings, with a verdict when there are any
  all,       ///< and notes, always with a verdict
};

/// Findings with excerpts, and the verdict.
std::string findings_text(const LoadedScene& scene, Verbosity verbosity, bool color);

}  // namespace scenefile::app
