#include "scenefile/io/descriptor.h"

#include "scenefile/base/text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace scenefile {

Descriptor::~Descriptor() {
  close();
}

void Descriptor::reset(int fd) {
  close();
  fd_ = fd;
}

int Descriptor::close() {
  const int fd = std::exchange(fd_, -1);
  // On Linux the descriptor is closed even after EINTR.
  return fd < 0 || ::close(fd) == 0 || errno == EINTR ? 0 : errno;
}

Error io_error(std::string_view path, std::string_view what) {
  return Error{fmt::format("{}: {}", escaped(path, 4096), what)};
}

Error system_error(std::string_view path, std::string_view what, int error) {
  return io_error(path, fmt::format("{}: {}", what, std::generic_category().message(error)));
}

std::string_view kind_of(const struct stat& status) {
  switch (status.st_mode & S_IFMT) {
    case S_IFDIR:
      return "a directory";
    case S_IFCHR:
    case S_IFBLK:
      return "a device";
    case S_IFIFO:
      return "a pipe";
    case S_IFSOCK:
      return "a socket";
    default:
      return "a file";
  }
}

int own_descriptor(const std::string& path, int dash) {
  static constexpr std::array<std::pair<std::string_view, int>, 3> names{
      {{"/dev/stdin", STDIN_FILENO},
       {"/dev/stdout", STDOUT_FILENO},
       {"/dev/stderr", STDERR_FILENO}}};
  if (path == "-") {
    return dash;
  }
  for (const auto& [name, number] : names) {
    if (path == name) {
      return number;
    }
  }
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (path.starts_with(folder)) {
      int number = -1;
      const char* const end = path.data() + path.size();
      const auto [rest, error] = std::from_chars(path.data() + folder.size(), end, number);
      return error == std::errc() && rest == end ? number : -1;
    }
  }
  return -1;
}

std::string follow_links(std::string path) {
  constexpr int max_links = 40;
  for (int i = 0; i < max_links; ++i) {
    std::error_code error;
    const std::filesystem::path link = std::filesystem::read_symlink(path, error);
    if (error) {
      break;
    }
    path = (std::filesystem::path(path).parent_path() / link).string();
  }
  return path;
}

namespace {

Error too_large(std::string_view path, std::uint64_t max_bytes) {
  Error error = io_error(path, fmt::format("larger than the limit of {} bytes", max_bytes));
  error.kind = ErrorKind::limit;
  return error;
}

// Succeeds if the file may be read.
Result<void> judge(const std::string& path, const struct stat& status, std::uint64_t max_bytes) {
  if (!S_ISREG(status.st_mode)) {
    return io_error(path, fmt::format("is {}, not a regular file", kind_of(status)));
  }
  if (std::cmp_greater(status.st_size, max_bytes)) {
    return too_large(path, max_bytes);
  }
  return {};
}

// Some kernel files look regular, but block until something happens.
bool is_regular(int fd) {
  struct stat status {};
  return ::fstat(fd, &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

Result<OpenFile> open_regular(const std::string& path, bool follow, std::uint64_t max_bytes) {
  // Checked before opening, because opening a device can already have an effect, and again
  // afterwards, because only the opened file counts.
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    return system_error(path, "cannot open", errno);
  }
  if (const Result<void> readable = judge(path, status, max_bytes); !readable) {
    return readable.error();
  }
  Descriptor file(::open(path.c_str(),
                         O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY | (follow ? 0 : O_NOFOLLOW)));
  if (!file.open() || ::fstat(file.get(), &status) != 0) {
    return system_error(path, "cannot open", errno);
  }
  if (const Result<void> readable = judge(path, status, max_bytes); !readable) {
    return readable.error();
  }
  return OpenFile{std::move(file), static_cast<std::uint64_t>(status.st_size)};
}

Result<std::string> read_all(int fd, std::string_view path, std::uint64_t expected,
                             std::uint64_t max_bytes) {
  std::string bytes;
  constexpr std::uint64_t step = 1 << 16;
  std::size_t used = 0;
  bytes.resize(std::min(expected, max_bytes) + 1);  // one more, to detect the end
  while (true) {
    if (used == bytes.size()) {
      bytes.resize(
          std::min<std::uint64_t>(used + std::max<std::uint64_t>(used, step), max_bytes + 1));
    }
    const ssize_t got = ::read(fd, bytes.data() + used, bytes.size() - used);
    if (got == 0) {
      bytes.resize(used);
      return bytes;
    }
    if (got > 0) {
      used += static_cast<std::size_t>(got);
    } else if (errno == EAGAIN && !is_regular(fd)) {
      pollfd wait{fd, POLLIN, 0};
      ::poll(&wait, 1, -1);
    } else if (errno != EINTR) {
      return system_error(path, "cannot read", errno);
    }
    if (used > max_bytes) {
      return too_large(path, max_bytes);
    }
  }
}

int write_all(int fd, std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::write(fd, bytes.data() + done, bytes.size() - done);
    if (written >= 0) {
      done += static_cast<std::size_t>(written);
    } else if (errno == EAGAIN) {
      pollfd wait{fd, POLLOUT, 0};
      ::poll(&wait, 1, -1);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace scenefile
