#include "app/run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace scenefile::testing_support {

namespace {

void redirect(const std::string& path, int to, int flags) {
  const int fd = ::open(path.c_str(), flags, 0600);
  ::dup2(fd, to);
  ::close(fd);
}

[[noreturn]] void become_program(const std::vector<std::string>& arguments,
                                 const RunSettings& settings, const TempFolder& folder) {
  redirect(folder.path("in"), STDIN_FILENO, O_RDONLY);
  redirect(settings.out_file.empty() ? folder.path("out") : settings.out_file, STDOUT_FILENO,
           O_WRONLY);
  redirect(folder.path("err"), STDERR_FILENO, O_WRONLY);
  if (!settings.folder.empty() && ::chdir(settings.folder.c_str()) != 0) {
    ::_exit(127);
  }
  if (settings.megabytes != 0) {
    const rlimit limit{settings.megabytes << 20, settings.megabytes << 20};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  for (const std::string& variable : settings.environment) {
    ::putenv(const_cast<char*>(variable.c_str()));
  }
  std::vector<char*> words{const_cast<char*>(SCENEFILE_PROGRAM)};
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  ::execv(SCENEFILE_PROGRAM, words.data());
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

ProgramRun run_program(const std::vector<std::string>& arguments, const RunSettings& settings) {
  const TempFolder folder;
  folder.write("in", settings.input);
  folder.write("out", "");
  folder.write("err", "");
  const pid_t child = ::fork();
  if (child == 0) {
    become_program(arguments, settings, folder);
  }
  if (settings.signal != 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(settings.delay_ms));
    ::kill(child, settings.signal);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ProgramRun run;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  run.out = folder.read("out");
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
