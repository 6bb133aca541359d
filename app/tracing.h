#pragma once
// What the commands share that trace rays.

#include "app/load.h"
#include "scenefile/trace/render.h"

#include <string>

namespace scenefile::app {

/// Loads the scene with the files that such a render looks at, and adds warnings of what only the
/// way of rendering makes doubtful.
LoadedScene load_for_tracing(const Options& options, const RenderOptions& render, Context& context);

/// Nothing went wrong where the error is empty.
struct Outcome {
  ExitCode status = ExitCode::fine;
  std::string error;
};

/// What the tracer's status means to the program.
Outcome judge(RenderStatus status, const Context& context);

}  // namespace scenefile::app
