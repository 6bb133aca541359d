#pragma once
// Converts the tracer's status to an error.

#include "scenefile/base/result.h"
#include "scenefile/trace/render.h"

#include <optional>

namespace scenefile {

/// Nullopt for RenderStatus::complete. A canceled picture is not an error of the input, so the
/// caller decides what it means.
std::optional<Error> render_error(RenderStatus status);

}  // namespace scenefile
