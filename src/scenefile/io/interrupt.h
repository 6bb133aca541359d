#pragma once
// Signals and time limits that end a program. Only for programs: all of this affects the whole
// process.

#include <string>

namespace scenefile {

/// Call once at the start. From then on SIGINT, SIGTERM and SIGHUP end the process immediately with
/// status 130, 143 and 143. A write_file() in progress is completed first, or its temporary file
/// removed if that takes long. SIGXCPU, from RLIMIT_CPU, ends it with status 4 and a message.
/// Signals that the parent process ignores stay ignored. A closed pipe or a file size limit becomes
/// a write error instead of a signal.
void handle_signals();

/// After that many seconds, ends the process in the same way, with status 4 and the message (one
/// line) on standard error. `answer` then goes to standard output, if nothing else was written
/// there (at most 511 bytes).
void end_after(double seconds, const std::string& message, const std::string& answer = {});

/// Whether writing to standard output has begun.
bool used_standard_output();
/// To be called before writing to standard output, as write_file() does. `used`: false where main()
/// begins, which can run more than once in a process under WebAssembly.
void use_standard_output(bool used = true);

/// While an object of this class exists, the first SIGINT, SIGTERM or SIGHUP gives the process
/// nearly a second to save its state; after that, or at a second signal, it ends as usual. Can be
/// nested: write_file() uses one, so that a program that has written its last output ends
/// successfully.
class DeferredSignals {
 public:
  DeferredSignals();
  ~DeferredSignals();
  DeferredSignals(const DeferredSignals&) = delete;
  DeferredSignals& operator=(const DeferredSignals&) = delete;

  /// SIGINT or SIGTERM if one is pending (SIGTERM also for SIGHUP), or 0.
  static int pending();

 private:
  bool deferring_before_;
};

}  // namespace scenefile
