#pragma once

#include "scenefile/base/diagnostics.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// The known word that `word` was probably meant to be, for "did you mean": the same ignoring case,
/// or the one with the fewest edits (insert, delete, replace, swap neighbors), at most a third of
/// its length; a prefix of five or more letters counts as one edit. Empty if nothing is close.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> known);

/// The correction of `word` to `instead`, which nearest_name() found in `known`; nullopt if that is
/// empty. It is not certain if another known word is as near, or if only digits differ.
std::optional<Correction> correction(std::string_view word, std::string_view instead,
                                     std::span<const std::string_view> known = {});

/// The number that `text`, which parse_number() rejects, was probably meant to be, in the notation
/// of JSON and XML. Knows decimal commas, digit separators, other minus signs, quotes, hexadecimal,
/// fractions, percentages, Fortran exponents, and units after a number. Empty if ambiguous.
std::string nearest_number(std::string_view text);

/// The correction of `text` to the number that nearest_number() found; nullopt if that is empty. It
/// is not certain if other numbers are possible: 1,000 and --5, or 3O, with a letter for a digit.
std::optional<Correction> number_correction(std::string_view text, std::string_view number);

}  // namespace scenefile
