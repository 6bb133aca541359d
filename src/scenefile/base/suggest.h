#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// The known word that `word` was probably meant to be: another case of it, or the fewest edits
/// (insert, delete, replace, swap neighbours) away, at most a third of its length; the first five
/// or more letters of a name count as one edit. Empty when nothing is near. For "did you mean".
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> known);

/// The number that `text`, which parse_number() does not take, was probably meant to be, as JSON
/// and XML write it: a decimal comma, separated digits, other minus signs, quotes, hexadecimal,
/// fractions, percentages, the exponents of Fortran, and units behind a number. Empty when that is
/// a guess.
std::string nearest_number(std::string_view text);

}  // namespace scenefile
