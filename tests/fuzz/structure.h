#pragma once
// Structural mutations of scene texts, because random bytes rarely get past the parser.

#include <cstdint>
#include <random>
#include <string>

namespace scenefile::fuzz {

using Random = std::minstd_rand;

/// Mutates the text once: an element (JSON: object, array or member) is removed, duplicated,
/// swapped with another, replaced by it or inserted into it, or a number is replaced by an extreme
/// one.
std::string restructured(const std::string& text, Random& random);

}  // namespace scenefile::fuzz
