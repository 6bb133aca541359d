#include "app/outputs.h"

#include "app/output.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile::app {

ExitCode check_outputs(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const NamedFile& output = outputs[i];
    if (output.path.empty()) {
      continue;
    }
    for (const std::span<const NamedFile> files : {inputs, outputs.first(i)}) {
      const auto same = std::find_if(files.begin(), files.end(), [&](const NamedFile& other) {
        return !other.path.empty() && same_file(output.path, other.path);
      });
      if (same != files.end()) {
        say_error(fmt::format("the {} would replace the {}; choose another name", output.role,
                              same->role));
        return ExitCode::usage;
      }
    }
    if (const Result<void> writable = check_writable(output.path); !writable) {
      say_error(writable.error().text);
      return ExitCode::environment;
    }
  }
  return ExitCode::fine;
}

}  // namespace scenefile::app
