#pragma once
// `scenefile diff`; options.arguments contains the two paths.

#include "app/command.h"

namespace scenefile::app {

/// Compares two scenes by meaning.
ExitCode diff_scenes(const Options& options, Context& context);

/// Compares two pictures, the reference first.
ExitCode diff_images(const Options& options, Context& context);

}  // namespace scenefile::app
