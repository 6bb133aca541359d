#pragma once
// Shell completion, from the same tables as the help.

#include <array>
#include <string>
#include <string_view>

namespace scenefile::app {

enum class Shell : unsigned char { bash, zsh, fish };

/// Indexed by Shell.
inline constexpr std::array<std::string_view, 3> shell_words{"bash", "zsh", "fish"};

/// The script that completes commands, options and their values.
std::string completion_script(Shell shell);

}  // namespace scenefile::app
