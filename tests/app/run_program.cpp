#include "app/run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>
#include <thread>

namespace scenefile::testing_support {

namespace {

void redirect(const std::string& path, int to, int flags) {
  const int fd = ::open(path.c_str(), flags, 0600);
  ::dup2(fd, to);
  ::close(fd);
}

// A pseudo-terminal: output that programs write to `name` can be read here.
class Terminal {
 public:
  Terminal() : fd_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    ::grantpt(fd_);
    ::unlockpt(fd_);
  }
  ~Terminal() { ::close(fd_); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void set_columns(unsigned short columns) const {
    const winsize size{24, columns, 0, 0};
    ::ioctl(fd_, TIOCSWINSZ, &size);
  }

  std::string name() const { return ::ptsname(fd_); }

  // Reads until the last program has closed it.
  std::string read_all() const {
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t n = 0; (n = ::read(fd_, part.data(), part.size())) > 0;) {
      text.append(part.data(), static_cast<std::size_t>(n));
    }
    return text;
  }

 private:
  int fd_;
};

[[noreturn]] void become_program(const std::vector<std::string>& arguments,
                                 const RunSettings& settings, const TempFolder& folder,
                                 const Terminal& terminal) {
  redirect(folder.path("in"), STDIN_FILENO, O_RDONLY);
  redirect(settings.out_file.empty() ? folder.path("out") : settings.out_file, STDOUT_FILENO,
           O_WRONLY);
  redirect(folder.path("err"), STDERR_FILENO, O_WRONLY);
  if (settings.terminal) {
    redirect(terminal.name(), STDOUT_FILENO, O_RDWR | O_NOCTTY);
    redirect(terminal.name(), STDERR_FILENO, O_RDWR | O_NOCTTY);
  }
  if (!settings.folder.empty() && ::chdir(settings.folder.c_str()) != 0) {
    ::_exit(127);
  }
  if (settings.megabytes != 0) {
    const rlimit limit{settings.megabytes << 20, settings.megabytes << 20};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  if (settings.stack_kilobytes != 0) {
    const rlimit limit{settings.stack_kilobytes << 10, settings.stack_kilobytes << 10};
    ::setrlimit(RLIMIT_STACK, &limit);
  }
  for (const std::string& variable : settings.environment) {
    ::putenv(const_cast<char*>(variable.c_str()));
  }
  const char* const program =
      settings.program.empty() ? SCENEFILE_PROGRAM : settings.program.c_str();
  std::vector<char*> words{const_cast<char*>(program)};
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  ::execv(program, words.data());
  ::_exit(127);
}

}  // namespace

const char* const good_scene = R"(<scenefile>
  <globaldata>
    <ambientcoeff v="0.5"/> <diffusecoeff v="0.5"/> <specularcoeff v="0.5"/>
  </globaldata>
  <cameradata>
    <pos x="0" y="0" z="3"/> <look x="0" y="0" z="-1"/> <up x="0" y="1" z="0"/>
    <heightangle v="40"/>
  </cameradata>
  <lightdata>
    <id v="0"/> <type v="directional"/> <color r="1" g="1" b="1"/> <direction x="-1" y="-1" z="-1"/>
  </lightdata>
  <object type="tree" name="root">
    <transblock>
      <object type="primitive" name="sphere">
        <diffuse r="1" g="0.5" b="0"/>
      </object>
    </transblock>
  </object>
</scenefile>
)";

std::string scene_with(const std::string& material) {
  std::string text = good_scene;
  const std::string line = R"(<diffuse r="1" g="0.5" b="0"/>)";
  text.replace(text.find(line), line.size(), material);
  return text;
}

namespace {

// Whether a process handles the signal, or has ended.
bool handles(pid_t process, int signal) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("State:\tZ", 0) == 0) {
      return true;
    }
    if (line.rfind("SigCgt:", 0) == 0) {
      return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
    }
  }
  return true;
}

// Seconds of CPU time that a process has used.
double cpu_time(pid_t process) {
  clockid_t clock{};
  timespec used{};
  return ::clock_getcpuclockid(process, &clock) == 0 && ::clock_gettime(clock, &used) == 0
             ? static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec)
             : 0;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& arguments, const RunSettings& settings) {
  const TempFolder folder;
  folder.write("in", settings.input);
  folder.write("out", "");
  folder.write("err", "");
  const Terminal terminal;
  terminal.set_columns(settings.columns);
  const pid_t child = ::fork();
  if (child == 0) {
    become_program(arguments, settings, folder, terminal);
  }
  double before_signal = 0;
  if (settings.signal != 0) {
    // On a busy machine, a program may take long to start.
    while (!handles(child, settings.signal)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(settings.delay_ms));
    before_signal = cpu_time(child);
    ::kill(child, settings.signal);
  }
  ProgramRun run;
  if (settings.terminal) {
    run.out = terminal.read_all();
  }
  int status = 0;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  run.cpu_to_stop = seconds(used.ru_utime) + seconds(used.ru_stime) - before_signal;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  run.out += folder.read("out");
  run.err = folder.read("err");
  return run;
}

rapidjson::Document parse_json(const std::string& text) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseValidateEncodingFlag>(text.data(), text.size());
  EXPECT_FALSE(document.HasParseError()) << text;
  return document;
}

}  // namespace scenefile::testing_support
