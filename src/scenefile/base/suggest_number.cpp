#include "scenefile/base/ascii.h"
#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

// Longer texts are not mistyped numbers.
constexpr std::size_t longest_number = 40;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string_view trimmed(std::string_view text, std::string_view away = blanks) {
  const std::size_t first = text.find_first_not_of(away);
  return first == std::string_view::npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(away) - first + 1);
}

// Replaces characters that look like those of numbers.
std::string in_ascii(std::string_view text) {
  constexpr std::pair<std::string_view, char> looks[] = {
      {"\u2212", '-'}, {"\u2010", '-'}, {"\u2011", '-'}, {"\u2012", '-'},
      {"\u2013", '-'}, {"\u2014", '-'}, {"\u00A0", ' '}, {"\u2009", ' '},
      {"\u202F", ' '}, {"\u201C", '"'}, {"\u201D", '"'}, {"\u2019", '\''}};
  std::string result;
  while (!text.empty()) {
    const auto* const look = std::find_if(std::begin(looks), std::end(looks),
                                          [&](const auto& l) { return text.starts_with(l.first); });
    const bool found = look != std::end(looks);
    result += found ? look->second : text[0];
    text.remove_prefix(found ? look->first.size() : 1);
  }
  return result;
}

// 1_000, 1'000. Not spaces, which more likely separate two numbers.
void join_digits(std::string& text) {
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if ((text[i] == '_' || text[i] == '\'') && is_digit(text[i - 1]) && is_digit(text[i + 1])) {
      text.erase(i, 1);
    }
  }
}

// A single comma is a decimal point. If there are both, as in 1,000.5 and 1.000,5, the last mark is
// the decimal point, and those before it must separate thousands: 1,0.5 is two numbers.
void place_point(std::string& text) {
  const std::size_t first = text.find_first_of(".,");
  const std::size_t last = text.find_last_of(".,");
  if (text.find('.') == std::string::npos) {
    if (first == last && first != std::string::npos) {
      text[first] = '.';
    }
    return;
  }
  const char separator = text[first];
  const std::size_t digits = text.find_first_not_of("+-");
  bool grouped = separator != text[last] && is_digit(text[digits]) && text[digits] != '0' &&
                 first - digits <= 3;
  for (std::size_t mark = first; grouped && mark != last; mark += 4) {
    grouped = text[mark] == separator && text.find_first_of(".,", mark + 1) == mark + 4;
  }
  if (grouped) {
    text[last] = '.';
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(last);
    text.erase(std::remove(begin, end, separator), end);
  }
}

// "--5" and "- 5".
void fix_sign(std::string& text) {
  const bool twice = text.size() > 1 && (text[1] == '-' || text[1] == '+');
  if (twice && (text[0] == '-' || text[0] == '+')) {
    text.erase(0, 1);
  }
  while (text.size() > 1 && text[0] == '-' && text[1] == ' ') {
    text.erase(1, 1);
  }
}

std::optional<double> plain_value(std::string_view text) {
  const ParsedNumber number = parse_number(text);
  return number.error == NumberError::none ? std::optional(number.value) : std::nullopt;
}

std::optional<double> hexadecimal_value(std::string_view text) {
  const bool minus = text.starts_with('-');
  text.remove_prefix(minus ? 1 : 0);
  if (text.size() < 3 || text.size() > 10 || text[0] != '0' || (text[1] != 'x' && text[1] != 'X')) {
    return std::nullopt;
  }
  double value = 0;
  for (const char c : lower_case(text.substr(2))) {
    if (!is_digit(c) && !(c >= 'a' && c <= 'f')) {
      return std::nullopt;
    }
    value = 16 * value + (is_digit(c) ? c - '0' : c - 'a' + 10);
  }
  return minus ? -value : value;
}

std::optional<double> fraction_value(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    return std::nullopt;
  }
  const std::optional<double> above = plain_value(text.substr(0, slash));
  const std::optional<double> below = plain_value(text.substr(slash + 1));
  return above && below && *below != 0 ? std::optional(*above / *below) : std::nullopt;
}

// "1d5".
std::optional<double> fortran_value(std::string text) {
  std::replace(text.begin(), text.end(), 'd', 'e');
  std::replace(text.begin(), text.end(), 'D', 'e');
  return plain_value(text);
}

// A number followed by a redundant suffix, or by a percent sign.
std::optional<double> value_before_unit(std::string_view text) {
  const ParsedNumber number = parse_number(text);
  if (number.used == 0 || number.error != NumberError::malformed) {
    return std::nullopt;
  }
  const std::string_view rest = trimmed(text.substr(number.used));
  if (rest == "%") {
    return number.value / 100;
  }
  const bool hexadecimal = number.value == 0 && lower_case(rest).starts_with('x');
  const bool unit =
      rest == "\u00B0" || std::all_of(rest.begin(), rest.end(), [](char c) {
        return is_letter(c) || std::string_view("'`\";:.,)]}+-").find(c) != std::string_view::npos;
      });
  // The format's angles are degrees, so dropping the unit would be wrong.
  const bool radians = lower_case(rest).starts_with("rad");
  return unit && !hexadecimal && !radians ? std::optional(number.value) : std::nullopt;
}

// Whether only one number can be meant.
bool is_certain(std::string_view text) {
  constexpr std::string_view signs = "+-";
  const std::size_t comma = text.find(',');
  const bool thousands =
      comma != std::string_view::npos && text.find('.') == text.npos && text.size() - comma == 4 &&
      std::all_of(text.begin() + static_cast<std::ptrdiff_t>(comma) + 1, text.end(), is_digit);
  const bool signed_twice =
      text.size() > 1 && signs.find(text[0]) != signs.npos && signs.find(text[1]) != signs.npos;
  // A mark instead of a digit: the backtick is next to 1.
  const std::size_t mark = text.find_first_of("`:;)]}");
  const bool stray =
      mark != text.npos && !(text[mark] == ';' && mark > 0 && is_digit(text[mark - 1]));
  // 1.000,5: or two numbers.
  const bool comma_after_point = comma != text.npos && text.find('.') < comma &&
                                 comma + 1 < text.size() && is_digit(text[comma + 1]);
  if (thousands || signed_twice || stray || comma_after_point) {
    return false;
  }
  std::string letters;
  std::copy_if(text.begin(), text.end(), std::back_inserter(letters), is_letter);
  constexpr std::string_view harmless[] = {"", "e", "d", "f", "ef", "deg", "degree", "degrees"};
  return std::find(std::begin(harmless), std::end(harmless), lower_case(letters)) !=
             std::end(harmless) ||
         hexadecimal_value(text);
}

}  // namespace

std::optional<Correction> number_correction(std::string_view text, std::string_view number) {
  return number.empty() ? std::nullopt
                        : std::optional(Correction{std::string(text), std::string(number),
                                                   is_certain(trimmed(text))});
}

std::string nearest_number(std::string_view text) {
  if (text.size() > longest_number) {
    return {};
  }
  std::string plain(trimmed(in_ascii(text), " \t\r\n\"'`"));
  join_digits(plain);
  place_point(plain);
  fix_sign(plain);
  for (const std::optional<double>& value :
       {plain_value(plain), hexadecimal_value(plain), fraction_value(plain), fortran_value(plain),
        value_before_unit(plain)}) {
    if (value && std::abs(*value) <= double{std::numeric_limits<float>::max()}) {
      return number_text(static_cast<float>(*value));
    }
  }
  return {};
}

}  // namespace scenefile
