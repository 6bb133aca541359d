#pragma once
// Manual pages, in the language of man(7), from the same tables as the help.

#include <string>

namespace scenefile::app {

struct Command;

/// The page scenefile(1): what the program is, and its commands.
std::string manual_page();

/// The page of a command, such as scenefile-render(1).
std::string manual_page(const Command& command);

}  // namespace scenefile::app
