#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace scenefile {

/// Treats denormal numbers as zero in this thread during its lifetime: they are slow, and Embree
/// requires it. Used around all ray tracing.
class NoDenormals {
 public:
#if defined(__SSE2__)
  NoDenormals() : saved_(_mm_getcsr()) {
    _mm_setcsr(saved_ | _MM_FLUSH_ZERO_ON | 0x0040u);  // 0x0040: denormal operands are zero
  }
  ~NoDenormals() {
    _mm_setcsr(saved_);
  }
#else
  NoDenormals() = default;
#endif
  NoDenormals(const NoDenormals&) = delete;
  NoDenormals& operator=(const NoDenormals&) = delete;

#if defined(__SSE2__)
 private:
  unsigned saved_;
#endif
};

}  // namespace scenefile
