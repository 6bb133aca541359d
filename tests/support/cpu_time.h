#pragma once

#include <ctime>

namespace scenefile {

/// CPU time of the test process, all threads; not affected by other processes.
inline double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace scenefile
