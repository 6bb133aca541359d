#pragma once
// Items of a store: files that contain the key of what they were made from, and a checksum of all
// their bytes. Interrupted and divided work continues with the items that exist.
//
// A key is a line of words `name=value`, separated by spaces, such as `scene=1f3a samples=16`. A
// file of any format is an item if it contains item_text() anywhere as plain text.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The text for a file with this key, before seal_item(): one line of printable ASCII without
/// quotes and backslashes, if the key is.
std::string item_text(std::string_view key);

/// Puts the checksum into the first item_text() in the bytes, which are then complete, except the
/// CRC of the text in a PNG file, which is not part of the checksum: see renew_png_text().
void seal_item(std::string& bytes);

/// A value that differs between two keys; empty in a key that lacks it.
struct KeyDifference {
  std::string name;
  std::string found;
  std::string wanted;
};
/// All differences, in the order of `wanted`, followed by the values that only `found` has. Empty
/// only if the keys are equal: of others with the same values, `key` differs.
std::vector<KeyDifference> compare_keys(std::string_view found, std::string_view wanted);

enum class ItemState : std::uint8_t {
  intact,   ///< sealed and unchanged since; it may have another key
  damaged,  ///< there is an item_text(), or a part of it, but the checksum is wrong
  none,     ///< not an item, or the text itself is damaged
};
struct Item {
  ItemState state = ItemState::none;
  std::string key;  ///< if intact
};
Item read_item(std::string_view bytes);

}  // namespace scenefile
