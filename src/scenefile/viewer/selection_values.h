#pragma once
// The values of what is selected, for the inspector and for copying.

#include "scenefile/viewer/session.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile::viewer {

struct NamedValue {
  std::string name;
  std::string text;
  std::optional<glm::vec3> color{};  ///< for a patch of it
};

/// Of the selected object's material, the light, or the scene's camera; empty if nothing is
/// selected, and for groups.
std::vector<NamedValue> selection_values(const Session& session);

/// Of the window's camera, as the scene file names them.
std::vector<NamedValue> camera_values(const ViewCamera& camera);

/// The text that the key for copying copies, and a name for it: the readout of the clicked pixel,
/// or the selection, or the camera. Lines of text.
struct CopiedText {
  std::string what;
  std::string text;
};
CopiedText text_to_copy(const Session& session);

}  // namespace scenefile::viewer
