#include "scenefile/io/interrupt.h"

#include "scenefile/io/temporary.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstring>
#include <initializer_list>
#include <string_view>

namespace scenefile {

namespace {

constexpr int limit_status = 4;
constexpr double grace_seconds = 0.7;

// State shared with the signal handlers; all of it can be read at any time.
std::atomic<bool> deferring = false;
std::atomic<int> pending_signal = 0;
std::atomic<bool> standard_output_used = false;
std::array<char, 256> timeout_message;
std::array<char, 512> timeout_answer;
static_assert(std::atomic<int>::is_always_lock_free);

[[noreturn]] void end_process(int status) {
  remove_temporaries();
  ::_exit(status);
}

void write_text(int descriptor, std::string_view text) {
  // There is nowhere to report a failure.
  [[maybe_unused]] const ssize_t written = ::write(descriptor, text.data(), text.size());
}

// A real-time interval timer is not affected by changes of the clock.
void start_timer(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
      std::max<suseconds_t>(1, static_cast<suseconds_t>((seconds - std::floor(seconds)) * 1e6));
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

// A closed terminal (SIGHUP) is treated like SIGTERM.
void end_by_signal(int number) {
  const int signal = number == SIGHUP ? SIGTERM : number;
  if (deferring) {
    int none = 0;
    if (pending_signal.compare_exchange_strong(none, signal)) {
      start_timer(grace_seconds);
      return;
    }
  }
  end_process(128 + signal);
}

// The grace period after a signal, or the time limit, has ended.
void end_by_timer(int /*signal*/) {
  if (const int signal = pending_signal; signal != 0) {
    end_process(128 + signal);
  }
  write_text(STDERR_FILENO, timeout_message.data());
  if (!standard_output_used) {
    write_text(STDOUT_FILENO, timeout_answer.data());
  }
  end_process(limit_status);
}

// The soft limit on CPU time; the system kills the process a little later.
void end_by_cpu_limit(int /*signal*/) {
  write_text(STDERR_FILENO, "scenefile: stopped: the system's limit on CPU time was reached\n");
  end_process(limit_status);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigfillset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

// Lowers the soft limit on CPU time if it equals the hard one, which kills without SIGXCPU.
void ask_for_warning() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_CPU, &limit) == 0 && limit.rlim_cur == limit.rlim_max &&
      limit.rlim_max != RLIM_INFINITY && limit.rlim_max > 1) {
    --limit.rlim_cur;
    ::setrlimit(RLIMIT_CPU, &limit);
  }
}

// The parent process may have blocked signals.
void let_through(std::initializer_list<int> signals) {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : signals) {
    sigaddset(&set, signal);
  }
  ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace

void handle_signals() {
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    struct sigaction old {};
    if (sigaction(signal, nullptr, &old) != 0 || old.sa_handler != SIG_IGN) {
      handle(signal, end_by_signal);
    }
  }
  handle(SIGALRM, end_by_timer);
  handle(SIGXCPU, end_by_cpu_limit);
  let_through({SIGALRM, SIGXCPU});
  ask_for_warning();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void end_after(double seconds, const std::string& message, const std::string& answer) {
  answer.copy(timeout_answer.data(), timeout_answer.size() - 1);
  const std::string line = message.substr(0, timeout_message.size() - 2) + "\n";
  std::copy_n(line.c_str(), line.size() + 1, timeout_message.data());
  start_timer(seconds);
}

bool used_standard_output() {
  return standard_output_used;
}

void use_standard_output(bool used) {
  standard_output_used = used;
}

DeferredSignals::DeferredSignals() : deferring_before_(deferring.exchange(true)) {}

DeferredSignals::~DeferredSignals() {
  deferring = deferring_before_;
}

int DeferredSignals::pending() {
  return pending_signal;
}

}  // namespace scenefile
