#pragma once
// Changes of a text, in bytes. An edit says only what changes: everything else stays, byte for
// byte.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The bytes [from, to) of a text.
struct TextRange {
  std::uint32_t from = 0;
  std::uint32_t to = 0;

  std::uint32_t size() const { return to - from; }
  friend bool operator==(const TextRange&, const TextRange&) = default;
};

/// Replaces the bytes [at, at + size) by `text`. Without a size it inserts, without a text it
/// removes.
struct TextChange {
  std::uint32_t at = 0;
  std::uint32_t size = 0;
  std::string text;

  friend bool operator==(const TextChange&, const TextChange&) = default;
};

/// Changes of one text, which are made at once: places are those of the text before. They are in
/// ascending order and do not overlap; of two at the same place, an insertion comes first.
struct Edit {
  std::vector<TextChange> changes;
  std::optional<std::uint32_t> select;  ///< where the item to select begins in the text after

  friend bool operator==(const Edit&, const Edit&) = default;
};

/// Puts the changes into the order that Edit asks for.
void sort_changes(std::vector<TextChange>& changes);

/// True if the changes are in order, do not overlap and lie in a text of `size` bytes.
bool fits(const Edit& edit, std::size_t size);

/// The text after an edit that fits.
std::string applied(std::string_view text, const Edit& edit);

/// The edit that undoes `edit`, which was applied to the text `before`:
/// applied(applied(before, edit), inverse(before, edit)) == before.
Edit inverse(std::string_view before, const Edit& edit);

/// Where the byte at `offset` is after an edit. A place in a removed range moves to the end of what
/// replaces it. Text that is inserted at `offset` comes before it.
std::uint32_t moved(std::uint32_t offset, const Edit& edit);

}  // namespace scenefile
