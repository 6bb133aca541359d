#pragma once

#include <ctime>

namespace scenefile {

/// Processor time of the test's process, all threads: what others do on the machine does not count.
inline double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace scenefile
