#include "app/command.h"
#include "app/output.h"
#include "scenefile/io/asset_roots.h"
#include "scenefile/io/message_reader.h"
#include "scenefile/lsp/language_server.h"
#include "scenefile/verbs/load_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ExitCode send(const std::vector<std::string>& messages) {
  std::string text;
  for (const std::string& message : messages) {
    text += fmt::format("Content-Length: {}\r\n\r\n{}", message.size(), message);
  }
  return text.empty() ? ExitCode::fine : answer(text);
}

}  // namespace

ExitCode run_lsp(const Options& options, Context& context) {
  context.phase = "serving an editor";
  LanguageServer server([&](const std::string& uri, const std::string& path) -> FetchFile {
    if (!uri.starts_with("file:")) {
      return {};
    }
    const auto roots = std::make_shared<AssetRoots>(
        asset_roots_options(path, options.access, options.load.limits));
    return [roots](const std::string& name) { return roots->read(name); };
  });
  MessageReader input;
  std::string body;
  ExitCode sent = ExitCode::fine;
  while (sent == ExitCode::fine && !server.exit_status()) {
    const std::optional<double> due = server.next_tick();
    const MessageEvent event =
        input.next(due ? std::optional(std::max(*due - seconds_now(), 0.0)) : std::nullopt, body);
    switch (event) {
      case MessageEvent::message:
        sent = send(server.handle(body, seconds_now()));
        break;
      case MessageEvent::timeout:
        sent = send(server.tick(seconds_now()));
        break;
      case MessageEvent::end:
        return ExitCode::findings;  // the client is gone without the notification exit
      case MessageEvent::broken:
        say_error(
            "a message without the header Content-Length; \"scenefile lsp\" is for editors: "
            "docs/editors.md");
        return ExitCode::findings;
    }
  }
  return sent != ExitCode::fine || server.exit_status() == 0 ? sent : ExitCode::findings;
}

}  // namespace scenefile::app
