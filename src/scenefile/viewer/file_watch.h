#pragma once
// Detects changes of files.

#include "scenefile/io/folder.h"

#include <string>
#include <vector>

namespace scenefile::viewer {

class FileWatch {
 public:
  /// Starts watching these files; their current state counts as known.
  void watch(std::vector<std::string> paths);

  /// Whether one of them is another file or has other contents, and has been the same at two
  /// questions in a row: an editor that is still writing, or has moved the old file away and not
  /// yet put the new one in its place, is given time. Answers yes once for each change.
  bool changed();

 private:
  std::vector<FileStamp> stamps() const;

  std::vector<std::string> paths_;
  std::vector<FileStamp> known_;
  std::vector<FileStamp> seen_;
};

}  // namespace scenefile::viewer
