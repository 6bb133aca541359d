#include "app/command.h"
#include "app/output.h"
#include "app/serve_editor.h"
#include "scenefile/io/asset_roots.h"
#include "scenefile/io/message_reader.h"
#include "scenefile/verbs/load_file.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace scenefile::app {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string with_headers(const std::vector<std::string>& messages) {
  std::string text;
  for (const std::string& message : messages) {
    text += fmt::format("Content-Length: {}\r\n\r\n{}", message.size(), message);
  }
  return text;
}

void say_no_header() {
  say_error(fmt::format(
      "a message without a header Content-Length that is a number of bytes, up to {} million; "
      "\"scenefile lsp\" is for editors: docs/editors.md",
      max_message_bytes / 1'000'000));
}

ExitCode run_lsp(const Options& options, Context& context) {
  context.phase = "serving an editor";
  return serve_editor(std::make_unique<LanguageServer>(
      [access = options.access, limits = options.load.limits](
          const std::string& uri, const std::string& path) -> FetchFile {
        if (!uri.starts_with("file:")) {
          return {};
        }
        const auto roots = std::make_shared<AssetRoots>(asset_roots_options(path, access, limits));
        return [roots](const std::string& name) { return roots->read(name); };
      }));
}

}  // namespace scenefile::app
