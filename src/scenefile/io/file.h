#pragma once
// Files: bounded reading, and atomic writing.

#include <cstdint>
#include <span>
#include <string>

namespace scenefile {

/// An error message for people.
struct IoError {
  std::string text;         ///< one line with path and reason; empty: success
  bool over_limit = false;  ///< the file is larger than allowed

  bool empty() const { return text.empty(); }
};

/// Reads a whole regular file. "-" and the system's names for it (/dev/stdin) mean standard input,
/// of any type. Rejects directories, devices, sockets and pipes without blocking, and files larger
/// than `max_bytes` without reading them. On failure `bytes` is empty.
IoError read_file(const std::string& path, std::uint64_t max_bytes, std::string& bytes);

/// Why writing `path` would fail: its folder is missing or not writable, or it is a folder or
/// write-protected. Call it before long work starts.
IoError check_writable(const std::string& path);

/// Writes a temporary file next to the target, syncs and renames it: the target is the old file or
/// the complete new one, and no temporary file remains. Keeps the mode of an existing file; follows
/// symbolic links. "-" and /dev/stdout write to standard output; devices and pipes are written
/// directly.
IoError write_file(const std::string& path, const std::string& bytes);

/// A file to write.
struct OutputFile {
  std::string path;
  const std::string* bytes = nullptr;
};

/// Writes files that belong together, each as write_file() does, but renames none before all are
/// written. Files are renamed in order, so put the one that refers to the others last. If a rename
/// fails, the new files renamed before it are removed again.
IoError write_files(std::span<const OutputFile> files);

/// Whether write_file() would write to standard output.
bool is_standard_output(const std::string& path);

/// Whether both paths lead to the same file, or would if it existed. False for standard input and
/// output.
bool same_file(const std::string& a, const std::string& b);

}  // namespace scenefile
