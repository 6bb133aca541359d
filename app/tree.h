#pragma once

#include "scenefile/scene/scene.h"

#include <string>

namespace scenefile::app {

/// The scene graph as an indented list: templates first, then the root.
std::string tree_text(const Scene& scene);

}  // namespace scenefile::app
