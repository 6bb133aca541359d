#pragma once
// What traces rays on this machine, for reports of defects and of times.

#include <string>
#include <string_view>

namespace scenefile {

struct TraceBackend {
  std::string embree;      ///< version of the library that is loaded, "4.3.3"; empty: unknown; "none": not built with it
  std::string_view lanes;  ///< instruction set in use, "AVX2"
};

TraceBackend trace_backend();

}  // namespace scenefile
