#pragma once
// Internal to io: an open file.

#include "scenefile/io/file.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

struct stat;  // from <sys/stat.h>

namespace scenefile {

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : fd_(other.fd_) { other.fd_ = -1; }
  Descriptor& operator=(Descriptor&&) = delete;

  int get() const { return fd_; }
  bool open() const { return fd_ >= 0; }
  /// Closes the current descriptor and takes over another.
  void reset(int fd);
  /// Closes now. Returns 0, or errno if it failed.
  int close();

 private:
  int fd_;
};

/// "PATH: what: strerror(error)", with the path escaped.
Error system_error(std::string_view path, std::string_view what, int error);
/// "PATH: what".
Error io_error(std::string_view path, std::string_view what);

/// "a folder", "a device", ... if it is not a regular file.
std::string_view kind_of(const struct stat& status);

/// The file descriptor of this process that the path means ("-" means `dash`; /dev/stdin,
/// /dev/stdout, /dev/stderr, /dev/fd/N), or -1.
int own_descriptor(const std::string& path, int dash);

/// The file that a chain of symbolic links leads to, whether or not it exists.
std::string follow_links(std::string path);

struct OpenFile {
  Descriptor descriptor;
  std::uint64_t size = 0;  ///< in bytes, when it was opened
};

/// Opens a regular file for reading, without blocking. If `follow` is false, rejects a symbolic
/// link as the last component.
Result<OpenFile> open_regular(const std::string& path, bool follow, std::uint64_t max_bytes);

/// Reads until the end of the file, at most `max_bytes`. `expected` is a size hint.
Result<std::string> read_all(int fd, std::string_view path, std::uint64_t expected,
                             std::uint64_t max_bytes);

/// Writes all bytes. Returns 0 or errno.
int write_all(int fd, std::string_view bytes);

}  // namespace scenefile
