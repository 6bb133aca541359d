#pragma once
// Recognizes files that are not scenes, to explain the mistake. Internal to the room.

#include <string_view>

namespace scenefile {

/// Says what a text is if it is not a scene, and what to do; completes the sentence "the file is".
/// Empty if unknown. `text` must not start with white space.
std::string_view other_file(std::string_view text);

}  // namespace scenefile
