#pragma once
// Signals and time that end a program. For programs only: all of this is about the whole process.

#include <string>

namespace scenefile {

/// Called once at the start. From then on SIGINT, SIGTERM and SIGHUP end the process at once, in
/// whatever it is doing, with status 130, 143 and 143; a write_file() in progress is finished
/// first, or its temporary file removed if it takes long. SIGXCPU, the limit of RLIMIT_CPU, does so
/// with status 4 and a message. Signals that the caller of the program ignores stay ignored. A
/// closed pipe or a file size limit becomes an error of the write instead of a signal.
void handle_signals();

/// Ends the process in the same way, with status 4 and the message (one line) on standard error,
/// when so many seconds have passed.
void end_after(double seconds, const std::string& message);

/// While it lives, the first SIGINT, SIGTERM or SIGHUP leaves the process nearly a second to finish
/// what it wants to keep; then, or at a second signal, the process ends as before. One may live
/// inside another: write_file() has one, so that a program whose last output is in place ends well.
class DeferredSignals {
 public:
  DeferredSignals();
  ~DeferredSignals();
  DeferredSignals(const DeferredSignals&) = delete;
  DeferredSignals& operator=(const DeferredSignals&) = delete;

  /// SIGINT or SIGTERM when one came (for SIGHUP the latter), or 0.
  static int pending();

 private:
  bool deferring_before_;
};

}  // namespace scenefile
