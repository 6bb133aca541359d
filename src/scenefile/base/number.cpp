#include "scenefile/base/number.h"

#include "scenefile/base/ascii.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#if !defined(__cpp_lib_to_chars)
#include <cstdlib>
#include <string>
#if defined(__APPLE__)
#include <xlocale.h>
#else
#include <locale.h>
#endif
#endif

namespace scenefile {

namespace {

std::size_t skip_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) {
    ++at;
  }
  return at;
}

// End of the longest number that starts at 0 (after a sign), or 0. Checked by hand because the
// standard parsers also accept "inf", "nan" and hexadecimal.
std::size_t number_end(std::string_view text) {
  std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t whole = at;
  at = skip_digits(text, at);
  std::size_t digits = at - whole;
  if (at < text.size() && text[at] == '.') {
    const std::size_t end = skip_digits(text, at + 1);
    digits += end - (at + 1);
    at = end;
  }
  if (digits == 0) {
    return 0;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t exponent = at + 1;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) {
      ++exponent;
    }
    const std::size_t end = skip_digits(text, exponent);
    if (end > exponent) {
      at = end;
    }
  }
  return at;
}

// Whether a number outside the range of double is too large rather than too small: decided by the
// power of ten of its first nonzero digit.
bool is_huge(std::string_view text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) {
    return false;
  }
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const long long power = static_cast<long long>(point) - static_cast<long long>(first);
  long long exponent = 0;
  for (const char c : text.substr(e)) {
    exponent = is_digit(c) ? std::min(exponent * 10 + (c - '0'), 1'000'000'000LL) : exponent;
  }
  const bool negative = e + 1 < text.size() && text[e + 1] == '-';
  return power + (negative ? -exponent : exponent) > 0;
}

// `text` is a valid number without a leading plus. Outside the range of double: infinity or 0.
double convert(std::string_view text) {
#if defined(__cpp_lib_to_chars)
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool overflow = result.ec == std::errc::result_out_of_range;
#else
  // libc++ 14 has no from_chars for floating point. Streams are avoided because they make the
  // WebAssembly module larger.
  static const locale_t classic = newlocale(LC_ALL_MASK, "C", nullptr);
  const double value = strtod_l(std::string(text).c_str(), nullptr, classic);
  const bool overflow = std::isinf(value);
#endif
  if (!overflow) {
    return value;
  }
  const double huge = std::numeric_limits<double>::infinity();
  return is_huge(text) ? (text[0] == '-' ? -huge : huge) : 0;
}

// Fast path for most numbers in scene files: up to 15 digits with or without a point, and nothing
// else. The digits and the power of ten are then exact doubles, so their quotient is the nearest
// double, the same as the general path gives.
bool parse_short(std::string_view text, double& value) {
  constexpr double powers[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool minus = text[0] == '-';
  std::uint64_t digits = 0;
  std::size_t fraction = text.size();
  for (std::size_t i = minus; i < text.size(); ++i) {
    if (is_digit(text[i])) {
      digits = digits * 10 + static_cast<std::uint64_t>(text[i] - '0');
    } else if (text[i] == '.' && fraction == text.size()) {
      fraction = i + 1;
    } else {
      return false;
    }
  }
  value = static_cast<double>(digits) / powers[text.size() - fraction];
  value = minus ? -value : value;
  return true;
}

}  // namespace

ParsedNumber parse_number(std::string_view text) {
  constexpr std::size_t with_a_digit = 3;
  constexpr std::size_t exact = 15;
  double value_of_short = 0;
  if (text.size() >= with_a_digit && text.size() <= exact && parse_short(text, value_of_short)) {
    return {value_of_short, NumberError::none, text.size()};
  }
  const std::size_t start = text.find_first_not_of(blanks);
  if (start == std::string_view::npos) {
    return {0, NumberError::empty, 0};
  }
  std::string_view body = text.substr(start);
  const std::size_t end = number_end(body);
  if (end == 0) {
    return {0, NumberError::malformed, 0};
  }
  const bool plus = body[0] == '+';
  const double value = convert(body.substr(plus, end - plus));
  const bool whole = body.find_first_not_of(blanks, end) == std::string_view::npos;
  // Half a step above the largest float: from there on, rounding to float gives infinity.
  constexpr double too_large = 0x1.ffffffp127;
  if (!(std::abs(value) < too_large)) {
    return {0, whole ? NumberError::out_of_range : NumberError::malformed, start + end};
  }
  return {value, whole ? NumberError::none : NumberError::malformed, start + end};
}

bool underflows(std::string_view text, float value) {
  return value == 0 &&
         text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != text.npos;
}

std::string number_text(float value) {
  return fmt::format("{}", value);
}

}  // namespace scenefile
