#pragma once
// Places in a text that is being edited: offsets in bytes and in UTF-16 units, the positions of the
// protocol (lines and UTF-16 units from 0), and those of findings (lines and characters from 1).
// Internal to lsp and the web page. A byte that is not UTF-8 counts as one character.

#include "scenefile/base/location.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace scenefile {

/// Offsets in bytes and in UTF-16 units, those of JavaScript. One inside a character means its
/// beginning in units, and its end in bytes.
class Utf16Offsets {
 public:
  explicit Utf16Offsets(std::string_view text = {});

  std::size_t unit(std::size_t byte) const;
  std::size_t byte(std::size_t unit) const;

 private:
  std::vector<std::uint32_t> before_;  // the units before each byte; empty if both are the same
};

/// A position of the protocol.
struct LspPosition {
  std::uint32_t line = 0;
  std::uint32_t character = 0;  ///< UTF-16 units
};

/// Lines end with LF, CR or CR LF. A position outside of the text means its nearest place, as the
/// protocol demands.
class TextLines {
 public:
  /// The text, UTF-8, must outlive this.
  explicit TextLines(std::string_view text);

  std::size_t offset(LspPosition position) const;
  std::size_t offset(Location location) const;
  LspPosition position(std::size_t offset) const;

 private:
  std::string_view line(std::size_t line) const;  // without its end

  std::string_view text_;
  Utf16Offsets units_;
  std::vector<std::size_t> starts_;
};

}  // namespace scenefile
