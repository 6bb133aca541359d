#pragma once
// Places in a text that is being edited: offsets in bytes, the positions of the protocol (lines and
// UTF-16 units from 0), and those of findings (lines and characters from 1). Internal to lsp.

#include "scenefile/base/location.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace scenefile {

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
  std::vector<std::size_t> starts_;
};

}  // namespace scenefile
