#pragma once
// Matches the files of a class with references, for common folder layouts such as
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

/// The files below `folder` with suitable names, sorted by name; at most 8 folders deep. Skips
/// files that archivers and operating systems add (`__MACOSX`, names that start with a dot). Does
/// not follow links to folders.
std::vector<FoundFile> files_below(const std::string& folder,
                                   bool (*wanted)(std::string_view name));

/// Whether the path refers to the file: it is the whole path, or the last folders and the name,
/// with or without the extension.
bool is_named(const FoundFile& file, const std::string& name);

/// Assigns a submitted picture to a reference. Names may include folders and extensions.
struct NamePair {
  std::string handed_in;
  std::string reference;
};

/// One pair per line: the submitted name, a comma or a tab, and the name of the reference. Names
/// that contain a comma are in double quotes, or a tab separates them. Empty lines and lines that
/// start with # are ignored. `wrong`: an error text with the line number; empty on success.
std::vector<NamePair> read_name_map(std::string_view text, std::string& wrong);

/// For each reference, the matching picture as an index into `pictures`; -1 if there is none. Names
/// match if they are equal, or after adding _gen, _output or _out, or with the folder as a prefix
/// (FOLDER_X). If several references or pictures have the same name, their folders decide. Pairs in
/// `map` take precedence.
std::vector<int> match_pictures(const std::vector<FoundFile>& references,
                                const std::vector<FoundFile>& pictures,
                                const std::vector<NamePair>& map = {});

/// Unique names of the references: the stem, with its folder if the stem is not unique.
std::vector<std::string> reference_names(const std::vector<FoundFile>& references);

/// Whether a folder with this name is part of a layout (illuminate, required, ...), rather than a
/// student.
bool is_layout_folder(std::string_view name);

/// Whether the file is in a folder for the textures of scenes: textures, image, ...
bool is_in_texture_folder(const FoundFile& file);

}  // namespace scenefile
