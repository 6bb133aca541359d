#pragma once
// Wraps text to the width of the terminal.

#include <cstddef>
#include <string>
#include <string_view>

namespace scenefile::app {

/// The width of the help in characters: COLUMNS, else the width of the terminal at standard output,
/// else 80; clamped to [40, 100], because longer lines are hard to read.
std::size_t help_width();

/// Wraps text at spaces to lines of at most `width`, unless a single word is longer; indents all
/// lines but the first. `column`: where the first line starts. `joint`, such as " \" for a shell,
/// is appended to each line that continues.
std::string wrapped(std::string_view text, std::size_t column, std::size_t indent,
                    std::size_t width, std::string_view joint = {});

}  // namespace scenefile::app
