#pragma once
// Names of features: `shadows reflect refract texture texture-filter super-sample depthoffield`, as
// spelled in the course's configuration files.

#include "scenefile/trace/render.h"

#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// The seven names, in the order of the fields of Features.
std::span<const std::string_view> feature_words();

/// Parses a comma-separated list of names, or `all`, or `none` (or an empty list). Returns the
/// first unknown name; empty on success, when `features` is complete.
std::string_view parse_features(std::string_view list, Features& features);

/// The same for a list that may also be a project of the course: `intersect`, which also sets the
/// mode, or `illuminate`.
std::string_view parse_features(std::string_view list, RenderOptions& options);

/// The shortest list that gives these features: a word that stands alone, if there is one.
std::string feature_list(const Features& features);

/// All words of such lists: the seven names, and the words that stand alone.
std::span<const std::string_view> feature_list_words();

/// The field for a name; null if unknown.
bool* find_feature(Features& features, std::string_view word);

}  // namespace scenefile
