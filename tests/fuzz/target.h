#pragma once
// What libFuzzer and the replay call. Returns 0, or -1 for an input that is another target's.

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
