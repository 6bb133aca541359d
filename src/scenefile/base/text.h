#pragma once
// Words of messages, and text from a file that is safe to show in one.

#include <cstddef>
#include <string>
#include <string_view>

namespace scenefile {

/// Makes text safe to show: control characters, bidirectional overrides and other invisible
/// characters become \n, \t or \u{...}, bytes that are not UTF-8 become \x.., at most
/// `max_characters` characters of it, then "...". No input can forge a line or an escape sequence.
std::string escaped(std::string_view text, std::size_t max_characters = 400);

/// escaped() in double quotes.
std::string quoted(std::string_view text, std::size_t max_characters = 40);

/// "1 picture", "2 pictures": for nouns that add an s.
std::string counted(std::size_t count, std::string_view what);

/// One character of UTF-8.
struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 0;  ///< 0: the text does not start with valid UTF-8, or is empty
};

/// Whether a byte of UTF-8 is not the first one of its character.
constexpr bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

/// The byte order mark of UTF-8.
inline constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

/// The first character of the text: strict UTF-8, no overlong forms, no surrogates.
CodePoint first_code_point(std::string_view text);

/// The text without a byte order mark of UTF-8 at its start.
std::string_view without_byte_order_mark(std::string_view text);

/// The text with \x.. for each byte that is not UTF-8, as escaped() shows them: different names of
/// files stay different.
std::string valid_utf8(std::string_view text);

/// A word of a POSIX shell's command line: in single quotes if it has special characters.
std::string shell_word(std::string_view word);

/// The word with its indefinite article: "a point", "an area".
std::string with_article(std::string_view word);

/// ASCII letters to lower case.
std::string lower_case(std::string_view text);

/// The extension of a file in lower case: ".xml" for "a/B.XML"; empty if there is none.
std::string lower_case_extension(std::string_view path);

/// Whether the texts are equal, ignoring the case of ASCII letters.
bool equal_ignoring_case(std::string_view a, std::string_view b);

/// The number of characters; a byte that is not UTF-8 counts as one.
std::size_t count_code_points(std::string_view text);

/// Whether a character looks blank or is invisible, but is not white space in XML or JSON: such
/// characters come from web pages and word processors.
bool is_odd_blank(char32_t c);

/// Whether a character must be escaped: control, format and bidirectional characters.
bool is_invisible(char32_t c);

}  // namespace scenefile
