#pragma once
// Lines that fit a terminal.

#include <cstddef>
#include <string>
#include <string_view>

namespace scenefile::app {

/// How wide the help may be, in characters: COLUMNS, else the terminal at standard output, else 80;
/// 40 at least, and 100 at most, beyond which lines are hard to read.
std::size_t help_width();

/// Breaks text at blanks so that no line is longer than `width`, where its words allow; all lines
/// but the first are indented. `column`: where the first line starts. `joint` ends each line that
/// goes on, such as " \" for a shell.
std::string wrapped(std::string_view text, std::size_t column, std::size_t indent,
                    std::size_t width, std::string_view joint = {});

}  // namespace scenefile::app
