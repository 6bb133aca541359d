#pragma once
// Signals and time that end a program. For programs only: all of this is about the whole process.

#include <string>

namespace scenefile {

/// Called once at the start. From then on SIGHUP, SIGINT and SIGTERM end the process at once, in
/// whatever it is doing, with status 129, 130 and 143, after removing the temporary file of a
/// write_file() in progress. Signals that the caller of the program ignores stay ignored. A closed
/// pipe or a file size limit becomes an error of the write instead of a signal.
void handle_signals();

/// Ends the process in the same way, with status 4 and the message (one line) on standard error,
/// when so many seconds have passed.
void end_after(double seconds, const std::string& message);

/// While it lives, the first SIGINT or SIGTERM leaves the process nearly a second to finish what it
/// wants to keep; then, or at a second signal, the process ends as before.
class DeferredSignals {
 public:
  DeferredSignals();
  ~DeferredSignals();
  DeferredSignals(const DeferredSignals&) = delete;
  DeferredSignals& operator=(const DeferredSignals&) = delete;

  /// The signal that came, or 0.
  static int pending();
};

}  // namespace scenefile
