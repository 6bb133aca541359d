#include "scenefile/io/descriptor.h"
#include "scenefile/io/file_writer.h"
#include "scenefile/io/folder.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/io/temporary.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <deque>
#include <memory>
#include <system_error>
#include <utility>

namespace scenefile {

namespace {

// The file that is finally written.
struct Target {
  std::string path;    ///< with symbolic links resolved, even if the file does not exist
  std::string folder;  ///< of `path`
  bool exists = false;
  struct stat status {};
};

Result<void> find_target(const std::string& path, Target& target) {
  target.path = follow_links(path);
  target.folder = folder_of(target.path);
  target.exists = ::stat(target.path.c_str(), &target.status) == 0;
  if (path.empty() || (!target.exists && errno != ENOENT)) {
    return system_error(path, "cannot write", path.empty() ? ENOENT : errno);
  }
  if (target.exists && S_ISDIR(target.status.st_mode)) {
    return io_error(path, "cannot write: it is a directory");
  }
  if (target.exists && ::faccessat(AT_FDCWD, target.path.c_str(), W_OK, AT_EACCESS) != 0) {
    return system_error(path, "cannot write", errno);
  }
  return {};
}

Result<void> check_folder(const std::string& path, const Target& target) {
  struct stat status {};
  if (::stat(target.folder.c_str(), &status) != 0) {
    return system_error(path, fmt::format("cannot write: the directory {}", target.folder), errno);
  }
  if (!S_ISDIR(status.st_mode)) {
    return io_error(path, fmt::format("cannot write: {} is not a directory", target.folder));
  }
  if (::faccessat(AT_FDCWD, target.folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    return system_error(path, fmt::format("cannot write to the directory {}", target.folder),
                        errno);
  }
  return {};
}

Result<void> write_error(std::string_view path, int error) {
  return error == 0 ? Result<void>() : system_error(path, "cannot write", error);
}

// Devices and pipes cannot be replaced, so they are written directly.
Result<void> write_special(const std::string& path, const Target& target,
                           const std::string& bytes) {
  Descriptor file(::open(target.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
  if (!file.open()) {
    return system_error(path, "cannot write", errno);
  }
  const int error = write_all(file.get(), bytes);
  return write_error(path, error != 0 ? error : file.close());
}

// Copies owner and mode of the old file, as far as permitted.
int copy_mode(int fd, const Target& target) {
  if (!target.exists) {
    return 0;
  }
  if (::fchown(fd, target.status.st_uid, target.status.st_gid) != 0 && errno != EPERM) {
    return errno;
  }
  return ::fchmod(fd, target.status.st_mode & 07777) == 0 ? 0 : errno;
}

// Makes a written file durable and closes it. Returns 0 or an errno.
int finish(Descriptor& file, const Target& target) {
  int error = copy_mode(file.get(), target);
  if (error == 0 && ::fsync(file.get()) != 0) {
    error = errno;
  }
  const int close_error = file.close();
  return error != 0 ? error : close_error;
}

// Creates the file and makes it durable. Returns 0 or an errno.
int write_temporary(const std::string& path, const Target& target, const std::string& bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!file.open()) {
    return errno;
  }
  const int error = write_all(file.get(), bytes);
  return error != 0 ? error : finish(file, target);
}

// Makes the rename durable. A failure here does not fail the write: the new file is complete and in
// place.
void sync_folder(const std::string& folder) {
  const Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (file.open()) {
    ::fsync(file.get());
  }
}

Result<void> replace(const std::string& path, const Target& target, const std::string& bytes) {
  // Otherwise a signal between the rename and the end of the program would report a completed write
  // as failed.
  const DeferredSignals deferred;
  Temporary temporary;
  temporary.choose(target.folder);
  int error = write_temporary(temporary.path(), target, bytes);
  if (error == 0 && std::rename(temporary.path().c_str(), target.path.c_str()) != 0) {
    error = errno;
  }
  if (error != 0) {
    return write_error(path, error);
  }
  temporary.keep();
  sync_folder(target.folder);
  return {};
}

// A file that is written but not yet renamed.
struct Pending {
  Target target;
  Temporary temporary;
};

}  // namespace

Result<void> check_writable(const std::string& path) {
  if (const int own = own_descriptor(path, STDOUT_FILENO); own >= 0) {
    const int flags = ::fcntl(own, F_GETFL);
    if (flags < 0) {
      return system_error(path, "cannot write", errno);
    }
    return (flags & O_ACCMODE) == O_RDONLY ? system_error(path, "cannot write", EBADF)
                                           : Result<void>();
  }
  Target target;
  if (const Result<void> found = find_target(path, target); !found) {
    return found;
  }
  if (target.exists && !S_ISREG(target.status.st_mode)) {
    return {};
  }
  return check_folder(path, target);
}

Result<void> write_file(const std::string& path, const std::string& bytes) {
  if (const int own = own_descriptor(path, STDOUT_FILENO); own >= 0) {
    if (own == STDOUT_FILENO) {
      use_standard_output();
    }
    return write_error(own == STDOUT_FILENO ? "standard output" : path, write_all(own, bytes));
  }
  Target target;
  if (const Result<void> found = find_target(path, target); !found) {
    return found;
  }
  if (target.exists && !S_ISREG(target.status.st_mode)) {
    return write_special(path, target, bytes);
  }
  if (const Result<void> checked = check_folder(path, target); !checked) {
    return checked;
  }
  return replace(path, target, bytes);
}

Result<void> write_files(std::span<const OutputFile> files) {
  if (files.size() == 1) {
    return write_file(files[0].path, *files[0].bytes);
  }
  const DeferredSignals deferred;
  std::deque<Pending> pending;
  for (const OutputFile& file : files) {
    Pending& next = pending.emplace_back();
    if (const Result<void> found = find_target(file.path, next.target); !found) {
      return found;
    }
    if (next.target.exists && !S_ISREG(next.target.status.st_mode)) {
      return io_error(file.path, "cannot write: it is not a regular file");
    }
    if (const Result<void> checked = check_folder(file.path, next.target); !checked) {
      return checked;
    }
    next.temporary.choose(next.target.folder);
    if (const int error = write_temporary(next.temporary.path(), next.target, *file.bytes);
        error != 0) {
      return write_error(file.path, error);
    }
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (std::rename(pending[i].temporary.path().c_str(), pending[i].target.path.c_str()) != 0) {
      const int error = errno;
      for (std::size_t k = 0; k < i; ++k) {
        if (!pending[k].target.exists) {
          ::unlink(pending[k].target.path.c_str());
        }
      }
      return write_error(files[i].path, error);
    }
    pending[i].temporary.keep();
  }
  for (const Pending& file : pending) {
    sync_folder(file.target.folder);
  }
  return {};
}

struct FileWriter::State {
  std::string path;  // as given
  Pending pending;
  Descriptor file;
  bool replaces = true;   // else all bytes go there at the end
  std::string collected;  // for that

  explicit State(std::string p) : path(std::move(p)) {}
};

FileWriter::FileWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
FileWriter::FileWriter(FileWriter&& other) noexcept = default;
FileWriter::~FileWriter() = default;

Result<FileWriter> FileWriter::create(const std::string& path) {
  auto state = std::make_unique<State>(path);
  Target& target = state->pending.target;
  if (own_descriptor(path, STDOUT_FILENO) >= 0) {
    state->replaces = false;
    return FileWriter(std::move(state));
  }
  if (const Result<void> found = find_target(path, target); !found) {
    return found.error();
  }
  if (target.exists && !S_ISREG(target.status.st_mode)) {
    state->replaces = false;
    return FileWriter(std::move(state));
  }
  if (const Result<void> writable = check_folder(path, target); !writable) {
    return writable.error();
  }
  Temporary& temporary = state->pending.temporary;
  temporary.choose(target.folder);
  state->file.reset(
      ::open(temporary.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!state->file.open()) {
    return system_error(path, "cannot write", errno);
  }
  return FileWriter(std::move(state));
}

Result<void> FileWriter::append(std::string_view bytes) {
  if (!state_->replaces) {
    state_->collected += bytes;
    return {};
  }
  const int error = write_all(state_->file.get(), bytes);
  return write_error(state_->path, error);
}

Result<void> FileWriter::replace(std::uint64_t at, std::string_view bytes) {
  if (!state_->replaces) {
    state_->collected.replace(at, bytes.size(), bytes);
    return {};
  }
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(state_->file.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written >= 0) {
      at += static_cast<std::uint64_t>(written);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return system_error(state_->path, "cannot write", errno);
    }
  }
  return {};
}

Result<void> FileWriter::commit() {
  if (!state_->replaces) {
    return write_file(state_->path, state_->collected);
  }
  Pending& pending = state_->pending;
  int error = finish(state_->file, pending.target);
  if (error == 0 &&
      std::rename(pending.temporary.path().c_str(), pending.target.path.c_str()) != 0) {
    error = errno;
  }
  if (error != 0) {
    return write_error(state_->path, error);
  }
  pending.temporary.keep();
  sync_folder(pending.target.folder);
  return {};
}

bool is_standard_output(const std::string& path) {
  return own_descriptor(path, STDOUT_FILENO) == STDOUT_FILENO;
}

}  // namespace scenefile
