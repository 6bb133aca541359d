// For builds without threads: the caller does all the work.

#include "scenefile/trace/no_denormals.h"
#include "scenefile/trace/tasks.h"

namespace scenefile {

struct ThreadLimit::State {};

ThreadLimit::ThreadLimit(int /*threads*/) {}
ThreadLimit::~ThreadLimit() = default;

void for_each_task(std::size_t count, const std::function<void(std::size_t)>& work) {
  const NoDenormals no_denormals;
  for (std::size_t i = 0; i < count; ++i) {
    work(i);
  }
}

}  // namespace scenefile
