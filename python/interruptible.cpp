#include "interruptible.h"

#include <cxxabi.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace scenefile::python {

namespace py = pybind11;

void run_interruptible(const std::function<void(const std::function<bool(double)>&)>& work,
                       const py::object& progress) {
  constexpr auto pause = std::chrono::milliseconds(30);
  std::atomic<double> done = 0;
  std::atomic<bool> stop = false;
  std::exception_ptr failed;
  std::mutex mutex;
  std::condition_variable changed;
  bool finished = false;
  std::optional<py::error_already_set> raised;
  {
    const py::gil_scoped_release release;
    std::thread worker([&] {
      try {
        work([&](double share) {
          done = share;
          return !stop;
        });
      } catch (...) {
        failed = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      finished = true;
      changed.notify_one();
    });
    std::unique_lock lock(mutex);
    while (!changed.wait_for(lock, pause, [&] { return finished; })) {
      if (stop) {
        continue;
      }
      lock.unlock();
      try {
        const py::gil_scoped_acquire acquire;
        try {
          if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
          }
          if (!progress.is_none()) {
            progress(done.load());
          }
        } catch (py::error_already_set& error) {
          raised.emplace(std::move(error));
          stop = true;
        }
      } catch (const abi::__forced_unwind&) {
        // The interpreter ends, and nothing here may use it again: wait for the end of the process,
        // as threads do since Python 3.14.
        stop = true;
        worker.join();
        while (true) {
          std::this_thread::sleep_for(std::chrono::hours(1));
        }
      }
      lock.lock();
    }
    lock.unlock();
    worker.join();
  }
  if (raised) {
    throw std::move(*raised);
  }
  if (failed) {
    std::rethrow_exception(failed);
  }
  if (!progress.is_none()) {
    progress(1.0);
  }
}

}  // namespace scenefile::python
