#pragma once

#include "app/command.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/mistakes/cause.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile::app {

/// The overview of all commands.
std::string overview_text();

/// A command with its options and examples.
std::string command_text(const Command& command);
/// A diagnostic code.
std::string code_text(const Code& code);
std::string cause_text(Cause cause);

/// The command with that name, or null.
const Command* find_command(std::string_view name);
/// The names of all commands.
std::span<const std::string_view> command_names();
/// Commands, lists, codes and causes: what help explains.
std::vector<std::string_view> help_topics();

}  // namespace scenefile::app
