// `scenefile lsp` of the program for Node.js: main() starts the server and returns; then JavaScript
// passes what arrives at standard input, calls when time is due, and writes the answers.

#include "app/serve_editor.h"

#include "scenefile/io/message_reader.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace scenefile::app {

namespace {

struct Served {
  std::unique_ptr<LanguageServer> server;
  MessageReader input;
  std::string answer;
  std::optional<ExitCode> status;
};

Served& served() {
  static Served instance;
  return instance;
}

}  // namespace

ExitCode serve_editor(std::unique_ptr<LanguageServer> server) {
  served().server = std::move(server);
  return ExitCode::fine;
}

extern "C" {

/// Takes bytes of the input, or none because time has passed. Returns what is to be written, of
/// lsp_answer_size() bytes.
const char* lsp_take(const char* bytes, std::size_t size) {
  Served& s = served();
  s.input.add({bytes, size});
  s.answer.clear();
  std::string body;
  while (!s.status) {
    const std::optional<MessageEvent> event = s.input.take(body);
    if (event == MessageEvent::message) {
      s.answer += with_headers(s.server->handle(body, seconds_now()));
    } else if (event) {
      say_no_header();
      s.status = ExitCode::findings;
    } else {
      break;
    }
    if (const std::optional<int> status = s.server->exit_status()) {
      s.status = *status == 0 ? ExitCode::fine : ExitCode::findings;
    }
  }
  if (!s.status) {
    s.answer += with_headers(s.server->tick(seconds_now()));
  }
  return s.answer.data();
}

std::size_t lsp_answer_size() {
  return served().answer.size();
}

/// Milliseconds until lsp_take() has something to do; -1: not before more input.
double lsp_wait() {
  const std::optional<double> due = served().server->next_tick();
  return due ? std::max(0.0, 1000 * (*due - seconds_now())) : -1;
}

/// Whether main() has started a server, and it was not asked to exit.
int lsp_serves() {
  return served().server && !served().status ? 1 : 0;
}

/// The exit status of the program.
int lsp_status() {
  return static_cast<int>(served().status.value_or(ExitCode::findings));
}
}

}  // namespace scenefile::app
