#include "app/serve_editor.h"

#include "app/output.h"
#include "scenefile/io/message_reader.h"

#include <algorithm>
#include <optional>

namespace scenefile::app {

namespace {

ExitCode send(const std::vector<std::string>& messages) {
  return messages.empty() ? ExitCode::fine : answer(with_headers(messages));
}

}  // namespace

ExitCode serve_editor(std::unique_ptr<LanguageServer> server) {
  MessageReader input;
  std::string body;
  ExitCode sent = ExitCode::fine;
  while (sent == ExitCode::fine && !server->exit_status()) {
    const std::optional<double> due = server->next_tick();
    const MessageEvent event =
        input.next(due ? std::optional(std::max(*due - seconds_now(), 0.0)) : std::nullopt, body);
    switch (event) {
      case MessageEvent::message:
        sent = send(server->handle(body, seconds_now()));
        break;
      case MessageEvent::timeout:
        sent = send(server->tick(seconds_now()));
        break;
      case MessageEvent::end:
        return ExitCode::findings;  // the client is gone without the notification exit
      case MessageEvent::broken:
        say_no_header();
        return ExitCode::findings;
    }
  }
  return sent != ExitCode::fine || server->exit_status() == 0 ? sent : ExitCode::findings;
}

}  // namespace scenefile::app
