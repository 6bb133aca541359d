#include "scenefile/viewer/file_watch.h"

#include <algorithm>
#include <utility>

namespace scenefile::viewer {

void FileWatch::watch(std::vector<std::string> paths) {
  std::vector<Watched> files;
  for (std::string& path : paths) {
    const auto before = std::find_if(files_.begin(), files_.end(),
                                     [&](const Watched& file) { return file.path == path; });
    const FileStamp stamp = before != files_.end() ? FileStamp() : stamp_of(path);
    files.push_back(before != files_.end() ? *before : Watched{std::move(path), stamp, stamp});
  }
  files_ = std::move(files);
}

bool FileWatch::changed() {
  bool at_rest = true;
  bool differs = false;
  for (Watched& file : files_) {
    const FileStamp stamp = stamp_of(file.path);
    at_rest = at_rest && stamp == file.seen;
    differs = differs || stamp != file.known;
    file.seen = stamp;
  }
  for (Watched& file : files_) {
    file.known = at_rest ? file.seen : file.known;
  }
  return at_rest && differs;
}

}  // namespace scenefile::viewer
