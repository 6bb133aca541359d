#pragma once
// Changes to the text of a scene that keep it one: random bytes seldom get behind the parser.

#include <cstdint>
#include <random>
#include <string>

namespace scenefile::fuzz {

using Random = std::minstd_rand;

/// The text with one change: an element (JSON: object, array or member) left out, doubled, swapped
/// with another, replaced by it or put into it, or a number replaced by one that is hard to bear.
std::string restructured(const std::string& text, Random& random);

}  // namespace scenefile::fuzz
