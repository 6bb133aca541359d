#pragma once
// The whole answer of reading a text, as lines that a person can check.

#include "scenefile/format/read_scene.h"

#include <string>
#include <string_view>

namespace scenefile::testing {

/// Each finding as "4:18 error xml.number: message", with the correction that it knows as
/// {written -> instead}; then each part of the scene with its place, and the values that differ
/// from their defaults. A value is followed by its own place if the scene has it, and is `unread`
/// if the text gives one that is no value. With `checked`, the findings of check() follow those of
/// the reader.
std::string answer(std::string_view text, const ReadOptions& options, bool checked);

}  // namespace scenefile::testing
