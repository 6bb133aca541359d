// scenefile_bench_memory [COUNT]: the memory of a drawable scene of COUNT cubes with different
// colors, by part and in bytes per primitive: heap and mapped memory in use (mallinfo2), and what
// Embree reports.

#include "generated_scene.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/trace/accelerator.h"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>

namespace {

using namespace scenefile;

// Bytes of the process: allocated by malloc, and resident.
struct Use {
  double allocated = 0;
  double resident = 0;
};

Use use() {
  malloc_trim(0);
  const struct mallinfo2 heap = mallinfo2();
  long pages = 0;
  long resident = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) {
      resident = 0;
    }
    std::fclose(file);
  }
  return {static_cast<double>(heap.uordblks + heap.hblkhd),
          static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE))};
}

RenderScene ready_scene(std::size_t count) {
  Diagnostics diagnostics;
  const Scene scene = read_scene(bench::xml_scene(count), {}, diagnostics);
  return prepare(scene, {}).scene;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const auto say = [&](const char* what, const Use& from, const Use& to) {
    const double n = static_cast<double>(count);
    fmt::print("{:<36}{:8.1f} allocated {:8.1f} resident\n", what,
               (to.allocated - from.allocated) / n, (to.resident - from.resident) / n);
  };
  const Use empty = use();
  RenderScene scene = ready_scene(count);
  const Use ready = use();
  const std::optional<Accelerator> accelerator(std::in_place, scene, Assets{});
  const Use built = use();
  say("ready scene", empty, ready);
  say("acceleration structure", ready, built);
  scene.groups = {};
  const Use left = use();
  say("ready scene's objects, given back", built, left);
  say("while it is drawn", empty, left);
}
