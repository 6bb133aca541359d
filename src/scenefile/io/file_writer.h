#pragma once
// A file that is written piece by piece, for what is too large to lie in memory whole.

#include "scenefile/base/result.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace scenefile {

/// As write_file() (file.h): the target is the old file or the whole new one. Until commit() the
/// bytes lie under another name beside it, and go away with the writer. Whoever holds one holds a
/// DeferredSignals (interrupt.h) too, so that this also happens when a signal ends the program.
/// What cannot be replaced, as standard output, gets all bytes at the end.
class FileWriter {
 public:
  static Result<FileWriter> create(const std::string& path);
  FileWriter(FileWriter&& other) noexcept;
  FileWriter& operator=(FileWriter&&) = delete;
  ~FileWriter();

  Result<void> append(std::string_view bytes);
  /// Replaces bytes that were appended, from the place `at`, counted from the first of all.
  Result<void> replace(std::uint64_t at, std::string_view bytes);
  /// Makes what was written durable and gives it its name. The last call.
  Result<void> commit();

 private:
  struct State;
  explicit FileWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scenefile
