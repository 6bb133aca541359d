// The only file that includes TBB.

#include "scenefile/trace/hand_over.h"
#include "scenefile/trace/no_denormals.h"
#include "scenefile/trace/tasks.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/scalable_allocator.h>
#include <tbb/task_arena.h>

namespace scenefile {

namespace {

// Registers this thread with TBB. If memory runs out during that, TBB counts the thread when it
// enters but not when it leaves, and destroying a global_control would wait forever; so none may
// exist yet.
void join_tbb() {
  // Refers to TBB's allocator, so that it is linked. Otherwise TBB would load it now, and dlopen of
  // glibc 2.36 crashes if memory runs out.
  scalable_free(nullptr);
  tbb::parallel_for(0, 1, [](int) {});
}

}  // namespace

struct ThreadLimit::State {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
  join_tbb();
  if (threads > 0) {
    state_.reset(new State{
        {tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)}});
  }
}

ThreadLimit::~ThreadLimit() = default;

void for_each_task(std::size_t count, const std::function<void(std::size_t)>& work) {
  const auto threads =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::task_arena arena(static_cast<int>(threads));
  const auto piece = [&work](std::size_t i) {
    const HandOver hand_over;
    const NoDenormals no_denormals;
    work(i);
  };
  HandOver::give();
  arena.execute([&] { tbb::parallel_for(std::size_t(0), count, piece); });
  HandOver::collect();
}

}  // namespace scenefile
