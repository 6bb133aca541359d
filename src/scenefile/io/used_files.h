#pragma once
// The files that a command reads and writes. One rule for all commands: no output replaces an input
// or another output.

#include "scenefile/base/result.h"

#include <compare>
#include <cstdint>
#include <map>
#include <string>

namespace scenefile {

/// Which file a path leads to, through links and with any spelling. A file that does not exist is
/// identified by the nearest folder that exists and by the path below it.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::string below;  ///< empty: the file exists

  friend std::strong_ordering operator<=>(const FileIdentity&, const FileIdentity&) = default;
};

/// A file and what messages call it, such as `the texture image/bricks.png of the scene`.
struct UsedFile {
  std::string path;
  std::string what;
};

/// Paths that write_file() would not replace have no effect: an empty one, standard output,
/// folders, devices and pipes. Standard input is the file that it comes from.
class UsedFiles {
 public:
  /// Adds an input. If it is an output, returns an error (ErrorKind::usage) that names both.
  Result<void> read(const UsedFile& input);
  /// Adds an output. The same error if it is an input or another output. Repeating an output under
  /// the same name has no effect.
  Result<void> write(const UsedFile& output);

 private:
  struct Use {
    std::string what;
    bool written = false;
  };
  std::map<FileIdentity, Use> uses_;  // the first use of each file
};

}  // namespace scenefile
