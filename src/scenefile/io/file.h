#pragma once
// Files of the operating system: bounded reading, whole-or-nothing writing.

#include <cstdint>
#include <span>
#include <string>

namespace scenefile {

/// What went wrong, for a person.
struct IoError {
  std::string text;         ///< the path and why, in one line; empty: nothing went wrong
  bool over_limit = false;  ///< the file is larger than allowed

  bool empty() const { return text.empty(); }
};

/// Reads a regular file whole. "-" and the system's names for it (/dev/stdin) mean standard input,
/// whatever that is. Directories, devices, sockets and pipes are refused without blocking, files of
/// more than `max_bytes` without reading. On failure `bytes` is empty.
IoError read_file(const std::string& path, std::uint64_t max_bytes, std::string& bytes);

/// Why writing `path` would fail: its folder is missing or not writable, it is a folder or
/// protected. Called before long work starts.
IoError check_writable(const std::string& path);

/// Writes through a temporary name beside the target, fsync and rename: the target is the old file
/// or the whole new one, and no other file stays behind. An existing file keeps its mode; behind a
/// symbolic link the file itself is replaced. "-" and /dev/stdout write to standard output; a
/// device or pipe is written directly.
IoError write_file(const std::string& path, const std::string& bytes);

/// A file to be written.
struct OutputFile {
  std::string path;
  const std::string* bytes = nullptr;
};

/// Writes files that belong together, each as write_file() does, but none gets its name before all
/// are written. Names are given in order: put the file that leads to the others last. When a name
/// cannot be given, the files before it that are new are removed again.
IoError write_files(std::span<const OutputFile> files);

/// Whether write_file() would write to standard output.
bool is_standard_output(const std::string& path);

/// Whether both paths lead to one file, or would if it existed. Standard input and output are none.
bool same_file(const std::string& a, const std::string& b);

}  // namespace scenefile
