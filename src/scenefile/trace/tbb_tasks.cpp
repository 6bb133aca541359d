// The only file that includes TBB.

#include "scenefile/trace/no_denormals.h"
#include "scenefile/trace/tasks.h"
#include "scenefile/trace/tsan_handoff.h"

#include <pthread.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/scalable_allocator.h>
#include <tbb/task_arena.h>

#include <memory>
#include <new>

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

// An object of this class exists while this thread runs a task.
struct InTask {
  InTask() { now = true; }
  ~InTask() { now = before_; }
  InTask(const InTask&) = delete;
  InTask& operator=(const InTask&) = delete;

  static inline thread_local bool now = false;

 private:
  bool before_ = now;
};

void delete_arena(void* arena) {
  delete static_cast<tbb::task_arena*>(arena);
}

// Where each thread keeps its arena. Not a thread_local variable: if memory runs out while glibc
// registers the destructor of one, it ends the process.
pthread_key_t arena_key() {
  static const pthread_key_t key = [] {
    pthread_key_t made{};
    if (::pthread_key_create(&made, delete_arena) != 0) {
      throw std::bad_alloc();
    }
    return made;
  }();
  return key;
}

// Kept from loop to loop: with a new arena for each of many short loops, TBB 2021.8 sends no more
// workers. Each thread has its own, so that it never waits for another thread's work.
tbb::task_arena& arena_of_this_thread() {
  const auto threads = static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  auto* const old = static_cast<tbb::task_arena*>(::pthread_getspecific(arena_key()));
  if (old != nullptr && old->max_concurrency() == threads) {
    return *old;
  }
  auto arena = std::make_unique<tbb::task_arena>(threads);
  if (::pthread_setspecific(arena_key(), arena.get()) != 0) {
    throw std::bad_alloc();
  }
  delete old;
  return *arena.release();
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
  const auto task = [&work](std::size_t i) {
    const TsanHandoff handoff;
    const NoDenormals no_denormals;
    const InTask in_task;
    work(i);
  };
  const auto loop = [&] { tbb::parallel_for(std::size_t(0), count, task); };
  TsanHandoff::give();
  if (InTask::now) {
    // Waits for its own tasks alone, and runs no others meanwhile.
    tbb::this_task_arena::isolate(loop);
  } else {
    arena_of_this_thread().execute(loop);
  }
  TsanHandoff::collect();
}

}  // namespace scenefile
