#pragma once
// Threads: parallel loops, priority.

#include <cstddef>
#include <functional>

namespace scenefile {

/// The number of threads that an option asks for: 0 means one per processor.
int thread_count(int wanted);

/// Calls work(0) to work(count - 1), each once, from at most `threads` threads, including the
/// caller's; 0 means one per processor. Uses fewer if the system does not provide them. Returns
/// when all are done. If a call throws, the exception is rethrown, and calls that have not started
/// are skipped.
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// Lets other threads of the process go before the calling thread and those that it starts. Does
/// nothing where the system only knows priorities of whole processes.
void lower_thread_priority();

}  // namespace scenefile
