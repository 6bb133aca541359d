#pragma once
// Compares the meanings of two scenes: whether they are drawn alike, and otherwise how the lines of
// their canonical texts (format/write_scene.h) differ; as text and JSON.

#include "scenefile/base/location.h"
#include "scenefile/verbs/load_scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace scenefile {

/// Lines of the canonical texts in a row that differ.
struct SceneDifference {
  std::string where;  ///< the object, such as "root/arm/#2: sphere"
  std::string a;      ///< the lines of the first scene; empty: only the second has some
  std::string b;      ///< the same for the second scene
  Location in_a;      ///< place of the object or light
  Location in_b;
};

/// The result of comparing two scenes.
struct SceneDiff {
  bool equal = false;                        ///< equal structure and values
  bool same_meaning = false;                 ///< drawn alike, however they are written
  std::vector<SceneDifference> differences;  ///< empty if the scenes have the same meaning
  std::size_t left_out = 0;                  ///< how many more there are
  std::string text;                          ///< the differences with lines around them
};

/// Compares two usable scenes. Both are written as JSON if both are JSON, otherwise as XML; if
/// they are grouped in different ways, without groups. Notes at most `most` differences.
SceneDiff compare_scenes(const LoadedScene& a, const LoadedScene& b, std::size_t most = 10'000);

/// "root/arm/#2: sphere", and its lines with "-" and "+" before them.
std::string difference_text(const SceneDifference& difference);

/// The differences as by `diff -u`, and a verdict. With ANSI colors if `color`.
std::string compare_scenes_text(const LoadedScene& a, const LoadedScene& b, const SceneDiff& diff,
                                bool color = false);

/// If `diff` is null because one of the scenes is not usable, `error` says so.
std::string compare_scenes_json(const LoadedScene& a, const LoadedScene& b, const SceneDiff* diff,
                                const std::string& error = {});

}  // namespace scenefile
