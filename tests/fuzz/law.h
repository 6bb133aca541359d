#pragma once
// What must hold for every input. A broken law ends the process the way a crash does, so that a
// fuzzer and the replay both keep the input that broke it.

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
