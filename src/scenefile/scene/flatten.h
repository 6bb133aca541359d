#pragma once
// A scene without groups.

#include "scenefile/scene/scene.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace scenefile {

/// Lists of transforms by their product.
using Spellings = std::map<std::array<float, 12>, std::vector<Transform>>;

/// The same objects, lights and instances in the same order, each a child of the head of its tree,
/// with all transforms above it. Transforms whose product is in `spellings` are written as there;
/// others are added. Nullopt if there would be hundreds of thousands.
std::optional<Scene> flattened(const Scene& scene, Spellings& spellings);

}  // namespace scenefile
