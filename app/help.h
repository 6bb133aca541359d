#pragma once

#include "app/command.h"
#include "scenefile/base/diagnostics.h"

#include <string>

namespace scenefile::app {

/// What the program can do.
std::string overview_text();
/// A command with its options and examples.
std::string command_text(const Command& command);
/// A code of a finding.
std::string code_text(const Code& code);

/// The command of that name, or null.
const Command* find_command(std::string_view name);
/// Names of all commands.
std::span<const std::string_view> command_names();

}  // namespace scenefile::app
