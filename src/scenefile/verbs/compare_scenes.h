#pragma once
// Compares the meanings of two scenes (scene/diff.h); as text and JSON.

#include "scenefile/scene/diff.h"
#include "scenefile/verbs/load_scene.h"

#include <string>

namespace scenefile {

/// Compares two usable scenes.
SceneDiff compare_scenes(const LoadedScene& a, const LoadedScene& b);

/// A line for each difference, and a verdict.
std::string compare_scenes_text(const LoadedScene& a, const LoadedScene& b, const SceneDiff& diff);

/// `diff`: null if one of the scenes is not usable.
std::string compare_scenes_json(const LoadedScene& a, const LoadedScene& b, const SceneDiff* diff);

}  // namespace scenefile
