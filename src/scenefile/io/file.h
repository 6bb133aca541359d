#pragma once
// Files: bounded reading, and atomic writing.

#include "scenefile/base/result.h"

#include <cstdint>
#include <span>
#include <string>

namespace scenefile {

/// Reads a whole regular file. "-" and the system's names for it (/dev/stdin) mean standard input,
/// of any type. Rejects directories, devices, sockets and pipes without blocking, and files larger
/// than `max_bytes` without reading them (ErrorKind::limit).
Result<std::string> read_file(const std::string& path, std::uint64_t max_bytes);

/// Why writing `path` would fail: its folder is missing or not writable, or it is a folder or
/// write-protected. Call it before long work starts.
Result<void> check_writable(const std::string& path);

/// Writes a temporary file next to the target, syncs and renames it: the target is the old file or
/// the complete new one, and no temporary file remains. Keeps the mode of an existing file; follows
/// symbolic links. "-" and /dev/stdout write to standard output; devices and pipes are written
/// directly.
Result<void> write_file(const std::string& path, const std::string& bytes);

/// A file to write.
struct OutputFile {
  std::string path;
  const std::string* bytes = nullptr;
};

/// Writes files that belong together, each as write_file() does, but renames none before all are
/// written. Files are renamed in order, so put the one that refers to the others last. If a rename
/// fails, the new files renamed before it are removed again.
Result<void> write_files(std::span<const OutputFile> files);

/// Whether write_file() would write to standard output.
bool is_standard_output(const std::string& path);

}  // namespace scenefile
