#pragma once
// Files of the operating system: bounded reading, whole-or-nothing writing.

#include <cstdint>
#include <string>

namespace scenefile {

/// What went wrong, in words for a person, with the path and the system's text; empty: nothing.
using IoError = std::string;

/// Reads a regular file whole, or standard input for "-". Directories, devices, pipes and files of
/// more than `max_bytes` are refused without blocking. On failure `bytes` is empty.
IoError read_file(const std::string& path, std::uint64_t max_bytes, std::string& bytes);

/// Why writing `path` would fail: its folder is missing or not writable, it is a folder. Called
/// before long work starts.
IoError check_writable(const std::string& path);

/// Writes through a temporary name beside the target, fsync and rename: the target is the old file
/// or the whole new one, and no other file stays behind. "-" writes to standard output. A device
/// such as /dev/stdout is written directly.
IoError write_file(const std::string& path, const std::string& bytes);

}  // namespace scenefile
