#pragma once
// Long work that Python can watch and stop.

#include <pybind11/pybind11.h>

#include <functional>

namespace scenefile::python {

/// Does `work` in a thread of its own, without the interpreter's lock. Meanwhile this thread
/// handles signals and calls `progress`, unless it is None, with the share that is done. When one
/// of them raises, the work is told to stop, and the exception goes on after it has. `work` gets a
/// function to call now and then, from any one thread at a time, which returns false to stop it.
void run_interruptible(const std::function<void(const std::function<bool(double)>&)>& work,
                       const pybind11::object& progress);

}  // namespace scenefile::python
