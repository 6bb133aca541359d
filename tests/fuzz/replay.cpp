// Runs files through a fuzz target without a fuzzer, so that every build replays known inputs:
//
//     scenefile_replay_obj 96 tests/fuzz/seeds/obj tests/fuzz/findings/obj
//
// Also tests each file truncated and with single bytes damaged, at up to so many places each, and
// for scenes as many structural mutations.

#include "structure.h"
#include "target.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

void run(const std::string& bytes) {
  // An exact-size copy, so that sanitizers detect reads past the end.
  const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  LLVMFuzzerTestOneInput(copy.data(), copy.size());
}

void run_damaged(const std::string& bytes, std::size_t max_places) {
  const std::size_t step = std::max<std::size_t>(1, bytes.size() / max_places);
  for (std::size_t at = 0; at < bytes.size(); at += step) {
    run(bytes.substr(0, at));
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    run(damaged);
  }
}

// The same mutations in every build and run.
void run_restructured(const std::string& bytes, std::size_t max_places) {
  scenefile::fuzz::Random random(1);
  std::string changed = bytes;
  for (std::size_t i = 0; i < max_places; ++i) {
    changed = scenefile::fuzz::restructured(i % 4 == 0 ? bytes : changed, random);
    run(changed);
  }
}

bool is_scene(const std::string& bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != bytes.npos && (bytes[first] == '<' || bytes[first] == '{');
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t max_places = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0;
  if (max_places == 0) {
    std::fprintf(stderr, "usage: %s PLACES FOLDER...\n", argv[0]);
    return 2;
  }
  std::size_t count = 0;
  for (int i = 2; i < argc; ++i) {
    if (!std::filesystem::is_directory(argv[i])) {
      continue;
    }
    for (const std::filesystem::path& file : files_of(argv[i])) {
      // Printed before it runs, in case it crashes.
      std::printf("%s\n", file.c_str());
      std::fflush(stdout);
      const std::string bytes = contents(file);
      run(bytes);
      run_damaged(bytes, max_places);
      if (is_scene(bytes)) {
        run_restructured(bytes, max_places);
      }
      ++count;
    }
  }
  std::printf("%zu files\n", count);
  return count == 0 ? 1 : 0;
}
