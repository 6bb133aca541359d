#pragma once
// Properties that must hold for every input. A violation aborts like a crash, so that fuzzer and
// replay keep the input.

#include <cstdio>
#include <cstdlib>

namespace scenefile::fuzz {

inline void require(bool holds, const char* law) {
  if (!holds) {
    std::fprintf(stderr, "broken law: %s\n", law);
    std::abort();
  }
}

}  // namespace scenefile::fuzz
