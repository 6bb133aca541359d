#pragma once
// How the meanings of two scenes differ (scene/diff.h), for people and for programs.

#include "scenefile/scene/diff.h"
#include "scenefile/verbs/load_scene.h"

#include <string>

namespace scenefile {

/// Compares two scenes that can be used.
SceneDiff compare_scenes(const LoadedScene& a, const LoadedScene& b);

/// A line for each difference, and the verdict.
std::string compare_scenes_text(const LoadedScene& a, const LoadedScene& b, const SceneDiff& diff);

/// `diff`: null where one of the scenes cannot be used.
std::string compare_scenes_json(const LoadedScene& a, const LoadedScene& b, const SceneDiff* diff);

}  // namespace scenefile
