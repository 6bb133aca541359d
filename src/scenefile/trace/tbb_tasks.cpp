// The only file that knows TBB.

#include "scenefile/trace/hand_over.h"
#include "scenefile/trace/no_denormals.h"
#include "scenefile/trace/tasks.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/scalable_allocator.h>
#include <tbb/task_arena.h>

namespace scenefile {

namespace {

// TBB gets to know the thread that asks for work. Where memory runs out in that, it counts the
// thread in but never out, and the end of a global_control waits for ever: so none may live yet.
void join_tbb() {
  // Names its allocator, so that it comes with the program: else TBB opens it now, and where memory
  // runs out in that, dlopen of glibc 2.36 crashes.
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
