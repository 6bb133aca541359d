#include "app/output.h"

#include "scenefile/io/file.h"
#include "scenefile/io/interrupt.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace scenefile::app {

namespace {

// What this process said on standard error, as long as it is not too much.
std::string said_errors;
constexpr std::size_t max_errors_size = 1 << 16;

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool is_smart_terminal(Stream stream) {
  const char* const kind = std::getenv("TERM");
  return ::isatty(static_cast<int>(stream)) == 1 &&
         (kind == nullptr || std::string_view(kind) != "dumb");
}

}  // namespace

bool wants_color(Stream stream) {
  return is_smart_terminal(stream) && !is_set("NO_COLOR");
}

bool wants_swatches(Stream stream) {
  const char* const depth = std::getenv("COLORTERM");
  const std::string_view kind = depth == nullptr ? "" : depth;
  return wants_color(stream) && (kind == "truecolor" || kind == "24bit");
}

bool wants_progress() {
  return is_smart_terminal(Stream::chatter) && !is_set("CI");
}

std::size_t terminal_width(Stream stream) {
  winsize size{};
  return ::ioctl(static_cast<int>(stream), TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

ExitCode answer(const std::string& text) {
  if (const Result<void> written = write_file("-", text); !written) {
    say_error(written.error().text);
    return ExitCode::environment;
  }
  return ExitCode::fine;
}

void say(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void say_error(std::string_view text) {
  say("scenefile: ");
  say(text);
  say("\n");
  keep_error(text);
}

ExitCode fail(ExitCode status, std::string_view text) {
  say_error(text);
  return status;
}

void keep_error(std::string_view text) {
  try {
    if (said_errors.size() + text.size() < max_errors_size) {
      said_errors.reserve(said_errors.size() + 2 + text.size());
      said_errors += said_errors.empty() ? "" : "; ";
      said_errors += text;
    }
  } catch (const std::bad_alloc&) {
    // It was said.
  }
}

void begin_output() {
  said_errors.clear();
  use_standard_output(false);
}

const std::string& kept_errors() {
  return said_errors;
}

}  // namespace scenefile::app
