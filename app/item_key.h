#pragma once
// Keys (io/item.h) of what the program makes in many pieces: bands, frames and results of students.

#include "app/load.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace scenefile::app {

/// `program=...`: the bytes of the program file, because the version number does not change during
/// development.
std::string program_word();

/// All options that affect pixels, as words.
std::string option_words(const Options& options);

/// The key of a picture of the scene.
std::string picture_key_of(const Options& options, const LoadedScene& scene);

/// How the item with the key `found` differs, as a phrase that follows "it was made". Empty if it
/// does not.
std::string key_mismatch(std::string_view found, std::string_view wanted);

/// The refusal of a store that contains a file of something else: `why` says what it is.
Outcome foreign_item(const std::string& path, std::string_view why);
/// Makes the folder of --store, if necessary.
Outcome make_store(const std::string& folder);
/// Prints the numbers of the shares that are still to make; status 1 if there are any.
ExitCode answer_missing(std::span<const std::uint32_t> shares);

}  // namespace scenefile::app
