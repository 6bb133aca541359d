#pragma once
// The function that libFuzzer and the replay call. Returns 0, or -1 for inputs that belong to
// another target.

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
