#pragma once
// What can be written at a place of a scene file, and what a word there means. Works on text that
// is being typed, which need not be well-formed. Internal to lsp.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class WordKind : std::uint8_t { element, attribute, value };

struct CompletionItem {
  std::string label;
  WordKind kind = WordKind::element;
  std::string_view about;
  std::string text;  ///< to insert
};

/// The words that may replace the bytes [from, to).
struct Completion {
  std::size_t from = 0;
  std::size_t to = 0;
  std::vector<CompletionItem> items;
};

Completion complete(std::string_view text, std::size_t offset);

struct WordMeaning {
  std::size_t from = 0;
  std::size_t to = 0;
  std::string_view about;
};

/// What the name at the offset means; nullopt if it is not a name of the format.
std::optional<WordMeaning> describe(std::string_view text, std::size_t offset);

/// Whether the first character of the text is that of XML.
bool looks_like_xml(std::string_view text);

/// The end of the name, the string or the character at the offset.
std::size_t word_end(std::string_view text, std::size_t offset);

}  // namespace scenefile
