#pragma once
// Folders, and whether files have changed.

#include "scenefile/io/file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// What tells one version of a file from the next, also where an editor puts a new file in the
/// place of the old one. Behind links, of what they lead to.
struct FileStamp {
  bool exists = false;
  std::int64_t modified_ns = 0;
  std::uint64_t size = 0;
  std::uint64_t inode = 0;
  std::uint64_t device = 0;

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
FileStamp stamp_of(const std::string& path);

bool is_folder(const std::string& path);

/// The folder that a path names a file in: "." where it has none.
std::string folder_of(const std::string& path);
/// The last part of a path.
std::string file_name_of(const std::string& path);

/// Names of the regular files in a folder, links followed, at most `most` of them, sorted; none
/// where it cannot be read.
std::vector<std::string> files_in(const std::string& folder, std::size_t most = 10000);

/// Whether a name comes before another in the order of people: numbers by their value, letters
/// without regard to case.
bool natural_less(const std::string& first, const std::string& second);

/// Regular files in a folder and in all folders below it, links to files followed, links to folders
/// not: whole paths, a folder's files before its folders, both in natural order. Left out, with all
/// below them: names with a dot in front, and __MACOSX, which macOS puts into ZIP archives. What
/// cannot be listed goes to `errors`.
std::vector<std::string> files_below(const std::string& folder, std::vector<IoError>& errors);

/// Makes the folder and those above it that are missing, for the user alone.
IoError make_folder(const std::string& path);

}  // namespace scenefile
