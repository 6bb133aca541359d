#pragma once
// The program as the course's own ray tracer: `projects_ray CONFIG.ini`.

#include "app/command.h"

#include <span>
#include <string_view>

namespace scenefile::app {

/// Whether the program was started under the name of the course's.
bool is_projects_ray(std::string_view program);

/// Draws what the configuration says, with the profile `course`, to where it says. `words`: the
/// arguments.
ExitCode run_projects_ray(std::span<const char* const> words, Context& context);

}  // namespace scenefile::app
