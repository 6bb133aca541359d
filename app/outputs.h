#pragma once
// The files that a command writes, checked before the work starts.

#include "app/command.h"

#include <span>
#include <string>
#include <string_view>

namespace scenefile::app {

struct NamedFile {
  std::string_view role;  ///< for messages: "output", "scene"
  std::string path;       ///< empty: not requested
};

/// Reports the first output that would replace an input or an earlier output (ExitCode::usage), or
/// that cannot be written (ExitCode::environment).
ExitCode check_outputs(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs);

}  // namespace scenefile::app
