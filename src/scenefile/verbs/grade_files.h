#pragma once
// Matches the files of a class with references, for common folder layouts such as
// student_outputs/illuminate/required/X.png and required_outputs/LIGHT/X.png.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A file below a folder.
struct FoundFile {
  std::string path;  ///< for opening; of the outermost archive, if it is in one
  /// Below the searched folder, outermost first. Archives count as folders.
  std::vector<std::string> folders;
  std::string stem;  ///< name without extension
  /// If it is in an archive: its path there, preceded by those of the archives in archives.
  std::vector<std::string> entries = {};
  bool late = false;  ///< a course system says that it was handed in late
};

/// The last part of its path.
std::string file_name(const FoundFile& file);
/// Its folders and its name.
std::string path_below(const FoundFile& file);

/// The extension of a name in lower case, with the dot; empty if there is none.
std::string ending_of(std::string_view name);

/// A file whose path is one of files_below(folder).
FoundFile found_file(const std::string& folder, const std::string& path);

/// Whether the path refers to the file: it is the whole path, or the last folders and the name,
/// with or without the extension, in upper or lower case.
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

/// Why a picture shows no reference.
struct UnusedPicture {
  std::size_t picture = 0;
  int reference = -1;  ///< that it fits, but for which another picture has the better name
  std::vector<std::size_t> several;  ///< references that it fits equally well
};

struct PictureMatches {
  std::vector<int> pictures;  ///< for each reference an index into the pictures; -1: none
  std::vector<UnusedPicture> unused;
};

/// Of files with the same name, the one with the lowest rank counts: PNG first, JPEG and GIF, which
/// change colors, last.
std::ptrdiff_t format_rank(const FoundFile& file);

/// Finds the picture of each reference. Names match if they are equal, or after adding _gen,
/// _output or _out, or with the folder as a prefix (FOLDER_X). Otherwise, a picture fits the only
/// reference whose name ends with its name (light_2 for test_light_2), or the longest reference
/// name that its name contains (hw2_light_2_final), in whole words. If several references or
/// pictures have the same name, their folders decide, then format_rank(), then the order of the
/// pictures. Pairs in `map` take precedence.
PictureMatches match_pictures(const std::vector<FoundFile>& references,
                              const std::vector<FoundFile>& pictures,
                              const std::vector<NamePair>& map = {});

/// The file that has the name of `file` by these rules, without those for parts of names; -1: none.
int best_named(const FoundFile& file, const std::vector<FoundFile>& files);

/// Unique names of the references: the stem, with its folder if the stem is not unique.
std::vector<std::string> reference_names(const std::vector<FoundFile>& references);

/// Whether a folder with this name is part of a layout (illuminate, required, ...), rather than a
/// student.
bool is_layout_folder(std::string_view name);

/// Whether the file is in a folder for the textures of scenes: textures, image, ...
bool is_in_texture_folder(const FoundFile& file);

}  // namespace scenefile
