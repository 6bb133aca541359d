#pragma once
// Converts the tracer's status to an error.

#include "scenefile/base/result.h"
#include "scenefile/trace/render.h"

#include <optional>

namespace scenefile {

/// nullopt for RenderStatus::complete. Cancellation is not an error of the input, so callers handle
/// it.
std::optional<Error> render_error(RenderStatus status);

}  // namespace scenefile
