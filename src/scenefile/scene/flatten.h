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
/// with all transforms above it. Lists of transforms with the same product become the one that
/// `spellings` has for it; new products are added there. nullopt if there would be hundreds of
/// thousands of objects.
std::optional<Scene> flattened(const Scene& scene, Spellings& spellings);

}  // namespace scenefile
