#pragma once
// Other programs.

#include "scenefile/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Whether one of the folders of PATH holds such a program.
bool has_program(std::string_view name);

/// Runs a program and waits for its end. `words`: its name, looked for in PATH, and its arguments.
/// Its standard input is empty, its standard output goes to standard error. An error where it
/// cannot be started or fails.
Result<void> run_child(const std::vector<std::string>& words);

}  // namespace scenefile
