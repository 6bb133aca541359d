#pragma once
// Long tasks that Python can monitor and stop.

#include <pybind11/pybind11.h>

#include <functional>

namespace scenefile::python {

/// Runs `work` in another thread, without the interpreter's lock. Meanwhile the calling thread
/// handles signals and calls `progress`, unless it is None, with the finished fraction. If one of
/// these raises an exception, `work` is asked to stop, and the exception propagates after it has
/// ended. `work` receives a function to call occasionally, from one thread at a time, which returns
/// false to stop it.
void run_interruptible(const std::function<void(const std::function<bool(double)>&)>& work,
                       const pybind11::object& progress);

}  // namespace scenefile::python
