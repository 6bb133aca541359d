#include "scenefile/viewer/file_watch.h"

#include <utility>

namespace scenefile::viewer {

std::vector<FileStamp> FileWatch::stamps() const {
  std::vector<FileStamp> result;
  result.reserve(paths_.size());
  for (const std::string& path : paths_) {
    result.push_back(stamp_of(path));
  }
  return result;
}

void FileWatch::watch(std::vector<std::string> paths) {
  paths_ = std::move(paths);
  known_ = stamps();
  seen_ = known_;
}

bool FileWatch::changed() {
  std::vector<FileStamp> now = stamps();
  const bool at_rest = now == seen_;
  seen_ = std::move(now);
  if (!at_rest || seen_ == known_) {
    return false;
  }
  known_ = seen_;
  return true;
}

}  // namespace scenefile::viewer
