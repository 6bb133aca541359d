#pragma once
// Completion of the command line in shells, from the same tables as the help.

#include <array>
#include <string>
#include <string_view>

namespace scenefile::app {

enum class Shell : unsigned char { bash, zsh, fish };

/// In the order of the enumerators.
inline constexpr std::array<std::string_view, 3> shell_words{"bash", "zsh", "fish"};

/// The script that the shell reads to complete commands, options and their values.
std::string completion_script(Shell shell);

}  // namespace scenefile::app
