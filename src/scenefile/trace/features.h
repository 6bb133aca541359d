#pragma once
// Features as words: `shadows reflect refract texture texture-filter super-sample depthoffield`,
// the spelling of the course's configuration files.

#include "scenefile/trace/render.h"

#include <span>
#include <string_view>

namespace scenefile {

/// The seven words, in the order of the fields of Features.
std::span<const std::string_view> feature_words();

/// Reads a comma-separated list of the words, or `all`, or `none` (which an empty list means too).
/// Returns the first word that is none of them, empty when all are; `features` is then complete.
std::string_view parse_features(std::string_view list, Features& features);

/// The field behind a word; null for any other word.
bool* find_feature(Features& features, std::string_view word);

}  // namespace scenefile
