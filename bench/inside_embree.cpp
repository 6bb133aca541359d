// libscenefile_bench_inside.so, for preloading: measures the share of a program's CPU time inside
// Embree's ray queries, including our callbacks. A CPU timer samples whether a query is running.
// Writes "SAMPLES INSIDE QUERIES" to the file named by SCENEFILE_BENCH_INSIDE.

#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace {

thread_local volatile int depth = 0;  // nested queries: instances query again
std::atomic<unsigned long> samples{0};
std::atomic<unsigned long> inside{0};
std::atomic<unsigned long> queries{0};

void on_sample(int) {
  samples.fetch_add(1, std::memory_order_relaxed);
  inside.fetch_add(depth > 0 ? 1 : 0, std::memory_order_relaxed);
}

__attribute__((constructor)) void begin() {
  if (std::getenv("SCENEFILE_BENCH_INSIDE") == nullptr) {
    return;
  }
  struct sigaction action {};
  action.sa_handler = on_sample;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPROF, &action, nullptr);
  constexpr itimerval every{{0, 1000}, {0, 1000}};
  setitimer(ITIMER_PROF, &every, nullptr);
}

__attribute__((destructor)) void end() {
  const char* const path = std::getenv("SCENEFILE_BENCH_INSIDE");
  if (path == nullptr) {
    return;
  }
  if (std::FILE* const file = std::fopen(path, "w")) {
    std::fprintf(file, "%lu %lu %lu\n", samples.load(), inside.load(), queries.load());
    std::fclose(file);
  }
}

struct Inside {
  Inside() {
    if (depth == 0) {
      queries.fetch_add(1, std::memory_order_relaxed);
    }
    depth = depth + 1;
  }
  ~Inside() { depth = depth - 1; }
};

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// Embree 3 and 4 have different argument types, but the same number of pointers.
#define QUERY(name)                                                  \
  extern "C" void name(void* a, void* b, void* c) {                  \
    static const auto real = next<void(void*, void*, void*)>(#name); \
    const Inside now;                                                \
    real(a, b, c);                                                   \
  }
#define PACKET_QUERY(name)                                                  \
  extern "C" void name(void* a, void* b, void* c, void* d) {                \
    static const auto real = next<void(void*, void*, void*, void*)>(#name); \
    const Inside now;                                                       \
    real(a, b, c, d);                                                       \
  }

QUERY(rtcIntersect1)
QUERY(rtcOccluded1)
PACKET_QUERY(rtcIntersect4)
PACKET_QUERY(rtcIntersect8)
PACKET_QUERY(rtcIntersect16)
PACKET_QUERY(rtcOccluded4)
PACKET_QUERY(rtcOccluded8)
PACKET_QUERY(rtcOccluded16)
