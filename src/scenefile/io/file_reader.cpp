#include "scenefile/io/file_reader.h"

#include "scenefile/io/descriptor.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <utility>

namespace scenefile {

struct FileReader::State {
  std::string path;
  OpenFile file;
};

FileReader::FileReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
FileReader::FileReader(FileReader&& other) noexcept = default;
FileReader::~FileReader() = default;

Result<FileReader> FileReader::open(const std::string& path) {
  Result<OpenFile> file = open_regular(path, true, std::numeric_limits<std::int64_t>::max());
  if (!file) {
    return file.error();
  }
  return FileReader(std::make_unique<State>(State{path, *std::move(file)}));
}

std::uint64_t FileReader::size() const {
  return state_->file.size;
}

Result<std::string> FileReader::read(std::uint64_t at, std::size_t count) const {
  std::string bytes(
      std::min<std::uint64_t>(count, state_->file.size - std::min(at, state_->file.size)), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::pread(state_->file.descriptor.get(), bytes.data() + done,
                                bytes.size() - done, static_cast<off_t>(at + done));
    if (got > 0) {
      done += static_cast<std::size_t>(got);
    } else if (got == 0) {
      bytes.resize(done);
    } else if (errno != EINTR) {
      return system_error(state_->path, "cannot read", errno);
    }
  }
  return bytes;
}

}  // namespace scenefile
