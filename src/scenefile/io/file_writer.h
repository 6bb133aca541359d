#pragma once
// Writes a file in pieces, for contents too large for memory.

#include "scenefile/base/result.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace scenefile {

/// Atomic like write_file() (file.h): until commit(), the bytes are in a temporary file next to the
/// target, which the destructor removes. Keep a DeferredSignals (interrupt.h) alive as long as the
/// writer, so that this also happens if a signal ends the program. A target that cannot be
/// replaced, such as standard output, receives all bytes at the end.
class FileWriter {
 public:
  static Result<FileWriter> create(const std::string& path);
  FileWriter(FileWriter&& other) noexcept;
  FileWriter& operator=(FileWriter&&) = delete;
  ~FileWriter();

  Result<void> append(std::string_view bytes);
  /// Replaces appended bytes, starting at offset `at` in the file.
  Result<void> replace(std::uint64_t at, std::string_view bytes);
  /// Syncs and renames the file. Must be the last call.
  Result<void> commit();

 private:
  struct State;
  explicit FileWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scenefile
