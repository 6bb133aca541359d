// Replaces view.cpp in the main program: starts the separate program that has the window.

#include "app/command.h"
#include "app/output.h"
#include "app/program_folder.h"

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace scenefile::app {

namespace {

constexpr const char* window_program = "scenefile-window";

}  // namespace

ExitCode run_view(const Options& /*options*/, Context& context) {
  const std::string folder = program_folder();
  const std::string path = folder.empty() ? folder : folder + "/" + window_program;
  // Timers survive exec, but their handlers do not; the new program sets its own timer.
  const itimerval no_timer{};
  ::setitimer(ITIMER_REAL, &no_timer, nullptr);
  if (path.empty()) {
    ::execvp(window_program, context.command_line);
  } else {
    ::execv(path.c_str(), context.command_line);
  }
  const std::error_code error(errno, std::generic_category());
  return fail(ExitCode::environment,
              fmt::format("view: {}, the program with the window, cannot be started: {}{}",
                          path.empty() ? window_program : path.c_str(), error.message(),
                          error == std::errc::no_such_file_or_directory
                              ? "; in a clone, 'make build' builds it"
                              : ""));
}

}  // namespace scenefile::app
