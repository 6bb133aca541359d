#include "scenefile/io/folder.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

namespace scenefile {

namespace fs = std::filesystem;

FileStamp stamp_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    return {};
  }
  FileStamp stamp;
  stamp.exists = true;
  stamp.modified_ns = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
  stamp.size = static_cast<std::uint64_t>(status.st_size);
  stamp.inode = status.st_ino;
  stamp.device = status.st_dev;
  return stamp;
}

bool is_folder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string file_name_of(const std::string& path) {
  return fs::path(path).filename().string();
}

std::vector<std::string> files_in(const std::string& folder, std::size_t most) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator i(folder, error), end; !error && i != end && names.size() < most;
       i.increment(error)) {
    std::error_code unknown;
    if (i->is_regular_file(unknown)) {
      names.push_back(i->path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

IoError make_folder(const std::string& path) {
  std::error_code error;
  fs::path made;
  for (const fs::path& part : fs::path(path)) {
    made /= part;
    if (!fs::exists(made, error) && fs::create_directory(made, error)) {
      fs::permissions(made, fs::perms::owner_all, error);
    }
  }
  if (!is_folder(path)) {
    return {path + ": the folder cannot be made: " + error.message()};
  }
  return {};
}

}  // namespace scenefile
