#pragma once
// What `scenefile diff` compares: options.arguments holds the two names.

#include "app/command.h"

namespace scenefile::app {

/// Two scenes, by meaning.
ExitCode diff_scenes(const Options& options, Context& context);

/// Two pictures, the reference first.
ExitCode diff_images(const Options& options, Context& context);

}  // namespace scenefile::app
