#pragma once
// Matches the files of a class with references, despite common folder layouts, such as
// student_outputs/illuminate/required/X.png and required_outputs/LIGHT/X.png.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A file below a folder.
struct FoundFile {
  std::string path;                  ///< for opening
  std::vector<std::string> folders;  ///< below the searched folder, outermost first
  std::string stem;                  ///< name without extension
};

/// The files below `folder` whose names are wanted, in the order of their names. What systems and
/// archives leave behind (`__MACOSX`, names that begin with a point) is passed over, links to
/// folders are not followed; at most 8 folders deep.
std::vector<FoundFile> files_below(const std::string& folder,
                                   bool (*wanted)(std::string_view name));

/// Whether the name ends like that of a picture: .png, .jpg, ...
bool is_picture_name(std::string_view name);

/// Which picture handed in is which reference, by names that may begin with folders and may have an
/// ending.
struct NamePair {
  std::string handed_in;
  std::string reference;
};

/// A line for each pair: the name handed in, a comma or a tab, and the name of the reference; empty
/// lines and those that begin with # say nothing. `wrong`: what is wrong, with the line's number;
/// empty: nothing.
std::vector<NamePair> read_name_map(std::string_view text, std::string& wrong);

/// For each reference the picture that is meant, by index into `pictures`; none: -1. Of the same
/// name, with `_gen`, `_output` or `_out` behind it, or with its folder before it (FOLDER_X); where
/// several references or pictures bear a name, their folders decide. What `map` names goes first.
std::vector<int> match_pictures(const std::vector<FoundFile>& references,
                                const std::vector<FoundFile>& pictures,
                                const std::vector<NamePair>& map = {});

/// Unique names of the references: the stem, with its folder if the stem is not unique.
std::vector<std::string> reference_names(const std::vector<FoundFile>& references);

/// Whether a folder with this name is part of a layout (illuminate, required, ...), rather than a
/// student.
bool is_layout_folder(std::string_view name);

}  // namespace scenefile
