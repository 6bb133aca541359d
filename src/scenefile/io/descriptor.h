#pragma once
// Private to the io room: an open file.

#include "scenefile/io/file.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

struct stat;  // of <sys/stat.h>

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
  /// Closes now. Returns 0 or the errno of a failed close.
  int close();

 private:
  int fd_;
};

/// "PATH: what: the system's text for `error`", the path escaped.
IoError system_error(std::string_view path, std::string_view what, int error);
/// "PATH: what".
IoError io_error(std::string_view path, std::string_view what);

/// "a folder", "a device", ... for what is not a regular file.
std::string_view kind_of(const struct stat& status);

/// Number of the process's own descriptor that the path means ("-" means `dash`; /dev/stdin,
/// /dev/stdout, /dev/stderr, /dev/fd/N), or -1.
int own_descriptor(const std::string& path, int dash);

/// Opens a regular file for reading without blocking and says how long it is. With `follow` false
/// a symbolic link in the last place is refused.
Descriptor open_regular(const std::string& path, bool follow, std::uint64_t max_bytes,
                        std::uint64_t& size, IoError& error);

/// Reads to the end, at most `max_bytes`. `expected` is a hint.
IoError read_all(int fd, std::string_view path, std::uint64_t expected, std::uint64_t max_bytes,
                 std::string& bytes);

/// Writes everything. Returns 0 or an errno.
int write_all(int fd, const std::string& bytes);

}  // namespace scenefile
