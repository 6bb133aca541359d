#include "scenefile/io/used_files.h"

#include "scenefile/io/descriptor.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <system_error>

namespace scenefile {

namespace {

namespace fs = std::filesystem;

// `standard`: the descriptor that "-" means.
std::optional<FileIdentity> identity_of(const std::string& path, int standard) {
  if (path.empty()) {
    return std::nullopt;
  }
  const int own = own_descriptor(path, standard);
  struct stat status {};
  if (own >= 0 ? ::fstat(own, &status) == 0 : ::stat(path.c_str(), &status) == 0) {
    // The shell has already opened, and emptied, what standard output leads to.
    return S_ISREG(status.st_mode) && (own < 0 || standard == STDIN_FILENO)
               ? std::optional(FileIdentity{status.st_dev, status.st_ino, {}})
               : std::nullopt;
  }
  std::error_code error;
  const fs::path target = fs::weakly_canonical(fs::absolute(follow_links(path), error), error);
  for (fs::path folder = target.parent_path(); !error; folder = folder.parent_path()) {
    if (::stat(folder.c_str(), &status) == 0) {
      return FileIdentity{status.st_dev, status.st_ino, target.lexically_relative(folder).string()};
    }
    if (folder == folder.parent_path()) {
      break;
    }
  }
  return std::nullopt;
}

Error conflict(std::string_view output, std::string_view other) {
  return {fmt::format("{} would replace {}; choose another name", output, other), ErrorKind::usage};
}

}  // namespace

Result<void> UsedFiles::read(const UsedFile& input) {
  if (std::optional<FileIdentity> identity = identity_of(input.path, STDIN_FILENO)) {
    const auto [use, is_new] = uses_.try_emplace(*std::move(identity), Use{input.what, false});
    if (use->second.written) {
      return conflict(use->second.what, input.what);
    }
  }
  return {};
}

Result<void> UsedFiles::write(const UsedFile& output) {
  if (std::optional<FileIdentity> identity = identity_of(output.path, STDOUT_FILENO)) {
    const auto [use, is_new] = uses_.try_emplace(*std::move(identity), Use{output.what, true});
    if (!is_new && !(use->second.written && use->second.what == output.what)) {
      return conflict(output.what, use->second.what);
    }
  }
  return {};
}

}  // namespace scenefile
