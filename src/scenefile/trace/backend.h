#pragma once
// The libraries and instruction set used for tracing, for bug reports and benchmarks.

#include <string>
#include <string_view>

namespace scenefile {

struct TraceBackend {
  std::string embree;      ///< version such as "4.3.3"; empty: unknown; "none": built without
  std::string_view lanes;  ///< instruction set in use, such as "AVX2"
};

TraceBackend trace_backend();

}  // namespace scenefile
