#pragma once
// Reads a regular file in pieces.

#include "scenefile/base/result.h"

#include <cstdint>
#include <memory>
#include <string>

namespace scenefile {

class FileReader {
 public:
  /// Rejects the same files as read_file(), without blocking.
  static Result<FileReader> open(const std::string& path);
  FileReader(FileReader&& other) noexcept;
  FileReader& operator=(FileReader&&) = delete;
  ~FileReader();

  /// The size when the file was opened.
  std::uint64_t size() const;
  /// Up to `count` bytes at offset `at`; fewer at the end of the file.
  Result<std::string> read(std::uint64_t at, std::size_t count) const;

 private:
  struct State;
  explicit FileReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scenefile
