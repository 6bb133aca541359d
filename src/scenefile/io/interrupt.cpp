#include "scenefile/io/interrupt.h"

#include "scenefile/io/temporary.h"

#include <unistd.h>

#include <csignal>

namespace scenefile {

namespace {

void end_process(int signal) {
  remove_guarded_temporary();
  ::_exit(128 + signal);
}

}  // namespace

void handle_signals() {
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) {
      continue;
    }
    action = {};
    action.sa_handler = end_process;
    sigfillset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace scenefile
