#pragma once
// Work for several threads.

#include <cstddef>
#include <functional>

namespace scenefile {

/// Calls work(0) to work(count - 1), each once, from so many threads at most, the caller's
/// included; 0: one a processor. Fewer where the system gives no more. Returns when all are done;
/// what a call throws is thrown on, and calls that had not begun then are left out.
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace scenefile
