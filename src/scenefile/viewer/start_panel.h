#pragma once
// The panel that opens scenes: recent files, and a folder. Plain data, without its appearance.

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile::viewer {

enum class ChoiceKind : std::uint8_t { folder, scene, picture };

/// A line of the panel.
struct Choice {
  ChoiceKind kind = ChoiceKind::scene;
  std::string name;
  std::string path;
};

struct StartPanel {
  bool open = false;
  std::string folder;               ///< absolute
  std::vector<Choice> choices;      ///< the contents of the folder: folders, scenes, pictures
  std::vector<std::string> recent;  ///< absolute paths
  bool appears = false;             ///< was opened since the last frame
  std::string typed;                ///< the path in the field
  bool opening = false;             ///< closes when the requested scene can be drawn
};

/// The contents of a folder: folders, scenes and pictures, each in natural order. Names that start
/// with a dot are left out.
std::vector<Choice> list_choices(const std::string& folder);

/// Lists this folder; an empty path is the working directory.
void go_to_folder(StartPanel& panel, const std::string& folder);

/// The path for a typed text: absolute, or below the panel's folder, or below `home` if it
/// starts with "~/".
std::string typed_path(const StartPanel& panel, const char* home);

}  // namespace scenefile::viewer
