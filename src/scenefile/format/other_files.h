#pragma once
// Files that are given for scenes by mistake. Internal to the room.

#include <string_view>

namespace scenefile {

/// What a text that is no scene is instead, and what to do; ends a sentence that starts with "the
/// file is". Empty: unknown. `text` starts with no white space.
std::string_view other_file(std::string_view text);

}  // namespace scenefile
