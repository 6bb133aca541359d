#pragma once
// Detects changes of files.

#include "scenefile/io/folder.h"

#include <string>
#include <vector>

namespace scenefile::viewer {

class FileWatch {
 public:
  /// Watches these files from now on, and no others. The current state of those that were not
  /// watched before counts as known.
  void watch(std::vector<std::string> paths);

  /// Whether a file was replaced or modified, and did not change between two consecutive calls.
  /// This gives an editor time to finish writing, or to move the new file into place. Returns true
  /// once for each change.
  bool changed();

 private:
  struct Watched {
    std::string path;
    FileStamp known;  ///< when changed() last returned true, or the file was not watched before
    FileStamp seen;   ///< by the last call
  };
  std::vector<Watched> files_;
};

}  // namespace scenefile::viewer
