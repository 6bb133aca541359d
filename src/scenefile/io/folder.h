#pragma once
// Folders, and detecting changes of files.

#include "scenefile/io/file.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace scenefile {

/// Identifies a version of a file, even if an editor replaces the file. Links are followed.
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

/// The folder part of a path: "." if there is none.
std::string folder_of(const std::string& path);
/// The last part of a path.
std::string file_name_of(const std::string& path);

/// The path from the root, whether or not the file exists.
std::string absolute_path(const std::string& path);

/// The folder of a path, from the root and without links, as far as it exists.
std::string real_folder_of(const std::string& path);
/// The path from a folder to a file, both from the root: "../image/a.png".
std::string path_from(const std::string& folder, const std::string& path);

/// Removes a file; it is not an error if there is none.
Result<void> remove_file(const std::string& path);

/// An entry of a folder.
struct FolderEntry {
  std::string name;
  std::string path;  ///< the folder's, and the name
  bool link = false;
  // Of what links lead to; none of them for devices and the like.
  bool folder = false;
  bool file = false;     ///< a regular one
  bool missing = false;  ///< a link that leads nowhere, or cannot be followed
};
/// Visits the entries of a folder, in any order, until `visit` returns false. Returns why the
/// folder cannot be read, if it cannot; throws std::bad_alloc if memory runs out.
std::error_code visit_entries(const std::string& folder,
                              const std::function<bool(FolderEntry&)>& visit);
/// The entries of a folder, sorted by name, without junk, but with hidden ones. If it cannot be
/// read, those until then; `problem` says why.
std::vector<FolderEntry> entries_of(const std::string& folder, std::string* problem = nullptr);

/// Whether the name starts with a dot.
bool is_hidden_name(std::string_view name);

/// Whether archivers, operating systems, editors and version control add files and folders with
/// this name, such as __MACOSX, Thumbs.db, .DS_Store, ._NAME and .git.
bool is_junk_name(std::string_view name);

/// Whether the path is a symbolic link.
bool is_link(const std::string& path);

/// Natural order: compares numbers by value, and letters ignoring case.
bool natural_less(const std::string& first, const std::string& second);

/// Paths of the regular files in a folder and its subfolders, in natural order, files before
/// folders. Follows links to files, but not to folders; those that lead nowhere are among the
/// files, to be reported by whoever opens them. Skips junk and hidden ones. Folders that cannot be
/// listed are added to `errors`.
std::vector<std::string> files_below(const std::string& folder, std::vector<Error>& errors);

/// Creates the folder and missing parents, accessible only to the user.
Result<void> make_folder(const std::string& path);

/// A new, empty folder in TMPDIR or /tmp, accessible only to the user. The destructor removes it
/// with its contents; a signal that ends the process does not.
class TemporaryFolder {
 public:
  static Result<TemporaryFolder> create();
  TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  const std::string& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;  // empty: moved
};

}  // namespace scenefile
