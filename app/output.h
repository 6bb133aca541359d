#pragma once
// What the program prints. Results go to standard output, everything else to standard error.

#include "app/command.h"

#include <cstddef>
#include <new>
#include <string>
#include <string_view>

namespace scenefile::app {

enum class Stream : int { answer = 1, chatter = 2 };

/// Whether to use colors: a terminal that supports them, and NO_COLOR is not set.
bool wants_color(Stream stream);
/// Whether the terminal supports 24-bit colors, according to COLORTERM.
bool wants_swatches(Stream stream);
/// Whether to show a progress bar: standard error is a terminal, and not in a CI job.
bool wants_progress();

/// The width of the terminal in characters; 0: not a terminal, or unknown.
std::size_t terminal_width(Stream stream);

/// Writes to standard output immediately. A failure (closed, full) is reported and returned as
/// ExitCode::environment.
ExitCode answer(const std::string& text);

/// Writes to standard error.
void say(std::string_view text);

/// Prints "scenefile: " and the text on one line, and keeps the text.
void say_error(std::string_view text);
/// The same, for a command that ends with this status.
ExitCode fail(ExitCode status, std::string_view text);
/// Keeps the text of an error that is printed in another way, or not at all.
void keep_error(std::string_view text);
/// Forgets what an earlier main() in this process wrote and kept.
void begin_output();
/// The errors that were kept, separated by "; ".
const std::string& kept_errors();

/// Prints the result of `text` after the work is done. Running out of memory here is not a failure.
template <typename Text>
void say_afterwards(const Text& text) {
  try {
    say(text());
  } catch (const std::bad_alloc&) {
    // Prints nothing if memory runs out, because a remark is not worth a failure.
  }
}

}  // namespace scenefile::app
