#pragma once
// What the program says. Answers go to standard output, everything else to standard error.

#include "app/command.h"

#include <cstddef>
#include <new>
#include <string>
#include <string_view>

namespace scenefile::app {

enum class Stream : int { answer = 1, chatter = 2 };

/// Whether a person looks on: a terminal that understands colors, and NO_COLOR is not set.
bool wants_color(Stream stream);
/// Whether it shows colors of 24 bits as well: COLORTERM says so.
bool wants_swatches(Stream stream);
/// Whether a progress bar makes sense: standard error is a terminal, and no CI job's.
bool wants_progress();

/// How many characters a line of the terminal holds; 0: it is none, or does not say.
std::size_t terminal_width(Stream stream);

/// Writes to standard output at once. A failure (closed, full) is said and is
/// ExitCode::environment.
ExitCode answer(const std::string& text);

/// Writes to standard error.
void say(std::string_view text);

/// "scenefile: " and the text, as one line.
void say_error(std::string_view text);

/// Says what `text` makes after the work is done: no lack of memory may turn that into a failure.
template <typename Text>
void say_afterwards(const Text& text) {
  try {
    say(text());
  } catch (const std::bad_alloc&) {
    // The work is worth more than the remark.
  }
}

}  // namespace scenefile::app
