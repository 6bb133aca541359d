#pragma once
// Whether files have changed since someone looked.

#include "scenefile/io/folder.h"

#include <string>
#include <vector>

namespace scenefile::viewer {

class FileWatch {
 public:
  /// From now on these files; what they are now counts as known.
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
