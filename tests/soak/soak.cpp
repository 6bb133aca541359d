// scenefile_soak COUNT FOLDER...: a long-running process, like a server, that processes COUNT files
// below the folders, valid and invalid: read, check, load, draw small, write in both formats. After
// every file has been processed once, memory must not grow by more than 1 % and no file may stay
// open.

#include "scenefile/asset/image_file.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/io/file.h"
#include "scenefile/trace/render.h"
#include "support/load_scene.h"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace scenefile;
namespace fs = std::filesystem;

constexpr double max_growth = 0.01;
// Sanitizers keep freed memory to detect its use, so memory cannot be measured.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool memory_counts = false;
#else
constexpr bool memory_counts = true;
#endif
// For fragmentation in the allocator.
constexpr double slack_bytes = 256 * 1024;

std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path().string());
    }
  }
  return files;
}

void draw_and_write(const testing_support::LoadedScene& scene) {
  RenderOptions options;
  options.width = 16;
  options.height = 12;
  options.threads = 2;
  render(scene.ready.scene, scene.assets, options);
  Diagnostics diagnostics;
  write_scene(scene.written, SceneFormat::xml, {}, diagnostics);
  write_scene(scene.written, SceneFormat::json, {}, diagnostics);
}

void decode_alone(const std::string& path) {
  const Limits limits;
  const Result<std::string> bytes = read_file(path, limits.file_bytes);
  if (!bytes) {
    return;
  }
  (void)decode_image(*bytes, limits);
}

void take(const std::string& path) {
  const testing_support::LoadedScene scene = testing_support::load_scene(path, true);
  if (scene.error.empty()) {
    draw_and_write(scene);
  } else {
    decode_alone(path);
  }
}

double resident_bytes() {
  malloc_trim(0);
  std::ifstream statm("/proc/self/statm");
  double pages = 0;
  double resident = 0;
  statm >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// The memory allocated by the library, plus small per-thread caches.
double allocated_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

std::ptrdiff_t open_files() {
  return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> files;
  for (int i = 2; i < argc; ++i) {
    const std::vector<std::string> more = files_below(argv[i]);
    files.insert(files.end(), more.begin(), more.end());
  }
  const auto count = argc > 2 ? std::strtoul(argv[1], nullptr, 10) : 0;
  if (count == 0 || files.empty()) {
    std::fputs("usage: scenefile_soak COUNT FOLDER...\n", stderr);
    return 2;
  }
  // Otherwise the allocator adapts the threshold, and keeps free memory in many arenas.
  mallopt(M_MMAP_THRESHOLD, 128 * 1024);
  mallopt(M_ARENA_MAX, 1);
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) {
    take(file);
  }
  const double memory = resident_bytes();
  const double allocated = allocated_bytes();
  const std::ptrdiff_t handles = open_files();
  std::mt19937 random(1);
  for (unsigned long i = 0; i < count; ++i) {
    take(files[random() % files.size()]);
  }
  const double growth = resident_bytes() - memory;
  const std::ptrdiff_t left_open = open_files() - handles;
  const double more_allocated = allocated_bytes() - allocated;
  std::puts(
      fmt::format(
          "{} files once, then {} in random order: {:.1f} MB resident, {:+.2f} % since; {:.0f} kB "
          "allocated, {:+.0f} kB since; {} files left open",
          files.size(), count, memory * 1e-6, 100 * growth / memory, allocated * 1e-3,
          more_allocated * 1e-3, left_open)
          .c_str());
  const bool grown = memory_counts && growth > std::max(max_growth * memory, slack_bytes);
  return grown || left_open != 0 ? 1 : 0;
}
