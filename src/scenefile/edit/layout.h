#pragma once
// Changes of a file's syntax that follow the layout around them: indentation, line ends, spaces
// after colons and commas. Internal to edit.

#include "scenefile/edit/syntax.h"
#include "scenefile/edit/text_edit.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

/// An element or a JSON value to write.
struct Fresh {
  enum class Type : std::uint8_t { element, object, list, literal };

  Type type = Type::element;
  std::string text;  ///< name of an element; a literal as it is written
  std::vector<std::pair<std::string, std::string>> attributes{};  ///< values are escaped already
  std::vector<Fresh> children{};
  std::string key{};  ///< of a member of an object
};

/// What to insert: something new, or text of the file, whose lines are indented anew.
struct Piece {
  std::optional<Fresh> fresh;
  std::string moved;
  std::string_view indent{};  ///< of the first line of `moved`
};

/// A change, and where what it inserts begins in its text.
struct Insertion {
  TextChange change;
  std::size_t lead = 0;
};

/// The result of several changes at once, of which one leaves an item to select: `lead` bytes into
/// the text of `selected`.
Edit edit_of(std::vector<TextChange> changes, const TextChange* selected = nullptr,
             std::size_t lead = 0);

class Layout {
 public:
  explicit Layout(const Syntax& syntax);

  const std::string& unit() const { return unit_; }
  const std::string& line_end() const { return line_end_; }
  bool one_line() const { return one_line_; }
  std::string_view indent_at(std::size_t at) const;
  Piece piece_of(TextRange range) const;
  std::string text_of(const Piece& piece, const std::string& indent, bool broad) const;

  // XML.
  /// Inserts pieces into an element, one after another, after its child `previous`; no_part: as the
  /// first.
  Insertion insert_children(PartId element, PartId previous, std::span<const Piece> pieces) const;
  /// Removes a range, and its whole line if nothing else is on it.
  TextChange remove_element(TextRange range) const;
  /// The range of an element with the comments that belong to it: after it on its last line if it
  /// begins a line, and on the lines directly above, but not before `limit`.
  TextRange with_comments(TextRange range, std::size_t limit) const;
  /// Sets an attribute to an escaped value; `after`: the attributes that come before it.
  TextChange set_attribute(PartId element, std::string_view name, std::string_view value,
                           std::span<const std::string_view> after) const;

  // JSON.
  /// Inserts a piece at an index of an array, or, with a key, of an object.
  Insertion insert_entry(PartId list, std::size_t index, const Piece& piece,
                         std::string_view key = {}) const;
  /// Removes entries with their commas. `gone`: ascending indexes.
  std::vector<TextChange> remove_entries(PartId list, std::span<const std::size_t> gone) const;

 private:
  std::size_t line_start(std::size_t at) const;
  bool starts_line(std::size_t at) const;
  std::size_t after_comments(std::size_t at) const;
  std::size_t line_end_at(std::size_t at) const;
  std::string_view gap_before(PartId list, std::size_t index) const;
  std::string colon_of(PartId object) const;
  void write_element(std::string& out, const Fresh& fresh, const std::string& indent,
                     bool broad) const;
  void write_json(std::string& out, const Fresh& fresh, const std::string& indent,
                  bool broad) const;

  const Syntax& syntax_;
  std::string_view text_;
  std::string unit_;
  std::string line_end_;
  bool one_line_;
  bool minified_;
};

/// `"key"`, escaped.
std::string json_quoted(std::string_view text);

}  // namespace scenefile
