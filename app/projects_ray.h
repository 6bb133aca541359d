#pragma once
// A replacement for the course's ray tracer: `projects_ray CONFIG.ini`.

#include "app/command.h"

#include <span>
#include <string_view>

namespace scenefile::app {

/// Whether the program was started under the name of the course's program.
bool is_projects_ray(std::string_view program);

/// Renders according to the configuration, with the profile `course`, to the output that it names.
/// `words`: the arguments.
ExitCode run_projects_ray(std::span<const char* const> words, Context& context);

}  // namespace scenefile::app
