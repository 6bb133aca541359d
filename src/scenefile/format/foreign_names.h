#pragma once
// Translates names of other formats and programs. Internal to format.

#include <span>
#include <string_view>

namespace scenefile {

/// For "did you mean": translates a foreign name, such as "box", to the name in `known` with the
/// same meaning, such as "cube". Empty if there is none.
std::string_view translated_name(std::string_view word, std::span<const std::string_view> known);

/// For a key that is valid in JSON, but not in `object` (such as "a light"): advice on where it
/// belongs, as the end of a sentence. Empty if the key is unknown.
std::string_view json_key_advice(std::string_view object, std::string_view key);

}  // namespace scenefile
