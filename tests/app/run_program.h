#pragma once
// Runs the program like a user.

#include "io/temp_folder.h"

#include <rapidjson/document.h>

#include <string>
#include <vector>

namespace scenefile::testing_support {

/// Arguments of the program.
using Words = std::vector<std::string>;

inline Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct ProgramRun {
  int status = -1;  ///< exit status, or 1000 + the signal that killed it
  std::string out;
  std::string err;
  double cpu_to_stop = 0;  ///< seconds of CPU time of all threads, from the signal to the end
};

struct RunSettings {
  std::string input{};                     ///< standard input
  std::vector<std::string> environment{};  ///< "NAME=value", added
  std::string out_file{};                  ///< standard output goes there instead
  std::string folder{};                    ///< working directory
  std::string program{};                   ///< a link to the program to start instead of it
  int signal = 0;  ///< sent `delay_ms` after the program has begun to handle it
  int delay_ms = 0;
  unsigned short columns = 0;         ///< of the terminal; 0: not reported
  bool terminal = false;              ///< standard output and error are a terminal; read as `out`
  unsigned long megabytes = 0;        ///< of address space; 0: no limit
  unsigned long stack_kilobytes = 0;  ///< of the first thread; 0: no limit of ours
};

ProgramRun run_program(const std::vector<std::string>& arguments, const RunSettings& settings = {});

/// A test in a folder of its own, where the program runs.
struct ProgramFolder : ::testing::Test {
  ProgramRun program(const Words& words, const std::string& input = {}) const {
    return run_program(words, {.input = input, .folder = folder.path()});
  }

  TempFolder folder;
};

/// Parses the document, and checks that it is valid and complete.
rapidjson::Document parse_json(const std::string& text);

/// A valid scene: a lit sphere. 19 lines.
extern const char* const good_scene;
/// The same with the sphere's diffuse color, line 15, replaced.
std::string scene_with(const std::string& material);

}  // namespace scenefile::testing_support
