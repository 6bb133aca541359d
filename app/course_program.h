#pragma once
// Configurations of the course's programs: as the argument of `render FILE.ini`, and as the only
// argument of this program under the names projects_ray and projects_path.

#include "app/command.h"
#include "scenefile/format/read_config.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scenefile::app {

/// Whether a name ends in .ini.
bool is_config_name(std::string_view name);

/// Reads a configuration and adds it to context.files. Errors are printed; warnings are left in
/// `configured.file`.
ExitCode read_configuration(const std::string& path, Context& context, Configured& configured);

/// The course's program that a program of this name replaces: projects_ray or projects_path.
std::optional<ConfigKind> course_program(std::string_view program);

/// Reads the arguments of such a program. If the result is `fine` and `configured` names no scene,
/// there is nothing else to do.
ExitCode read_course_arguments(ConfigKind program, std::span<const char* const> words,
                               Context& context, Configured& configured);

}  // namespace scenefile::app
