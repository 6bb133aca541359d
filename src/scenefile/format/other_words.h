#pragma once
// What other formats and programs call the things of this format. Internal to the room.

#include <span>
#include <string_view>

namespace scenefile {

/// The one of `known` that is meant by `word`, a name from elsewhere: "box" means a cube. Empty
/// when it is not known or none of `known`. For "did you mean".
std::string_view in_our_words(std::string_view word, std::span<const std::string_view> known);

/// Where in JSON that belongs which `key` says, when it is known but not in `object` ("a light", as
/// the vocabularies call them): an advice that ends a sentence, or nothing.
std::string_view json_key_advice(std::string_view object, std::string_view key);

}  // namespace scenefile
