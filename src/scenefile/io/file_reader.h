#pragma once
// A regular file that is read in pieces.

#include "scenefile/base/result.h"

#include <cstdint>
#include <memory>
#include <string>

namespace scenefile {

class FileReader {
 public:
  /// Refuses what read_file() refuses, without blocking.
  static Result<FileReader> open(const std::string& path);
  FileReader(FileReader&& other) noexcept;
  FileReader& operator=(FileReader&&) = delete;
  ~FileReader();

  /// Length of the file when it was opened.
  std::uint64_t size() const;
  /// `count` bytes from the place `at`; fewer where the file ends before.
  Result<std::string> read(std::uint64_t at, std::size_t count) const;

 private:
  struct State;
  explicit FileReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scenefile
