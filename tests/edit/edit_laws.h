#pragma once
// What must hold for every edit of every scene file. Used by the unit tests and the soak.

#include "scenefile/edit/edits.h"

#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <string_view>

namespace scenefile::testing {

/// How often each kind of edit was made.
using EditCounts = std::map<std::string, std::size_t>;

/// Tries edits of at most `most` items of a document, each on its own: undo, values, there and
/// back, wrapping and placing. Returns what does not hold; empty if all does.
std::string check_edits(const Document& document, std::size_t most, std::mt19937& chance,
                        EditCounts& counts);

/// Makes `length` random edits one after another, and takes them back. Returns what does not hold.
std::string check_series(const Document& document, std::size_t length, std::mt19937& chance,
                         EditCounts& counts);

}  // namespace scenefile::testing
