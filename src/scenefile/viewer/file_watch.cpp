#include "scenefile/viewer/file_watch.h"

#include <algorithm>
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
  std::vector<FileStamp> known;
  std::vector<FileStamp> seen;
  for (const std::string& path : paths) {
    const auto before = std::find(paths_.begin(), paths_.end(), path);
    const std::size_t i = std::size_t(before - paths_.begin());
    known.push_back(before != paths_.end() ? known_[i] : stamp_of(path));
    seen.push_back(before != paths_.end() ? seen_[i] : known.back());
  }
  paths_ = std::move(paths);
  known_ = std::move(known);
  seen_ = std::move(seen);
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
