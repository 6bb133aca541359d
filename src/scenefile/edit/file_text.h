#pragma once
// A scene file as its readers see it, and where each of its characters is in the bytes of the file.
// Internal to edit.

#include "scenefile/base/location.h"
#include "scenefile/edit/text_edit.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Why files in UTF-16 cannot be changed.
inline constexpr std::string_view utf16_refusal = "the file is in UTF-16; save it as UTF-8 first";

class FileText {
 public:
  /// `bytes` in any encoding; the text is empty if it cannot be read, or is UTF-16.
  explicit FileText(std::string_view bytes);
  FileText(const FileText&) = delete;
  FileText& operator=(const FileText&) = delete;

  /// UTF-8, without a byte order mark.
  std::string_view text() const { return text_; }
  bool is_xml() const { return is_xml_; }

  /// The offset of a place in text(); nullopt if there is no such place.
  std::optional<std::size_t> offset(Location location) const;
  /// The offset in the bytes of an offset in text().
  std::uint32_t in_bytes(std::size_t offset) const;
  /// The place of an offset in the bytes.
  Location location(std::uint32_t at) const;

  /// Changes an edit of text() to one of the bytes. Returns false if the encoding lacks a
  /// character.
  bool to_bytes(Edit& edit) const;

 private:
  std::string_view bytes_;
  std::string storage_;
  std::string_view text_;
  bool is_xml_ = false;
  std::vector<std::size_t> lines_;  ///< where each begins
};

}  // namespace scenefile
