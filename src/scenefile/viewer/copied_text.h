#pragma once
// The text that Ctrl+C copies.

#include "scenefile/viewer/session.h"

#include <string>

namespace scenefile::viewer {

/// Lines of text, and a name for them. Empty without a scene.
struct CopiedText {
  std::string what;
  std::string text;
};

/// The readout of the clicked pixel, or the selection and its fields, or the window's camera with
/// the names of a scene file.
CopiedText text_to_copy(Session& session);

}  // namespace scenefile::viewer
