#pragma once
// What the tracer's status means to who asked for a picture.

#include "scenefile/base/result.h"
#include "scenefile/trace/render.h"

#include <optional>

namespace scenefile {

/// Nothing for RenderStatus::complete. A picture that was cancelled is no error of the input, so
/// that whoever cancelled it says what it means.
std::optional<Error> render_error(RenderStatus status);

}  // namespace scenefile
