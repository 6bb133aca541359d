#pragma once
// Runs other programs.

#include "scenefile/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Whether a folder in PATH contains the program.
bool has_program(std::string_view name);

/// Runs a program and waits for it. `words`: its name, looked up in PATH, and its arguments.
/// Standard input is empty, standard output is redirected to standard error. Returns an error if
/// the program cannot be started or fails.
Result<void> run_child(const std::vector<std::string>& words);

}  // namespace scenefile
