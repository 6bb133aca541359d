#pragma once
// All files that a class handed in: in folders and in archives. Internal to verbs.

#include "scenefile/verbs/grade_files.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

inline constexpr std::string_view not_a_picture = "not a picture";

/// A file in the class.
struct ClassItem {
  FoundFile file;        ///< its folders are those below the class
  std::string reason;    ///< why it is not a picture; empty: it is one
  bool outside = false;  ///< of an archive whose folders do not contain it
};

struct ClassListing {
  std::vector<ClassItem> items;
  /// Folders that may be empty: directly in the class, or in an archive, below the class.
  std::vector<std::vector<std::string>> folders;
  std::string gradescope;  ///< the contents of its table
  std::string gradescope_path;
};

/// Lists a folder or an archive. What is directly in the folder and is, or contains, one of the
/// `other_folders` is left out with a reason.
ClassListing list_class(const std::string& folder, const std::vector<std::string>& other_folders);

/// The archives that are not read.
bool is_other_archive(std::string_view name);

/// A file by its path, with its stem.
FoundFile file_of(std::string path, std::vector<std::string> folders,
                  std::vector<std::string> entries = {});

}  // namespace scenefile
