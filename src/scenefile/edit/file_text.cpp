#include "scenefile/edit/file_text.h"

#include "scenefile/base/text.h"
#include "scenefile/format/scene_text.h"

#include <algorithm>

namespace scenefile {

namespace {

std::size_t count_characters(std::string_view text) {
  return text.size() -
         static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

}  // namespace

FileText::FileText(std::string_view bytes) : bytes_(bytes) {
  Diagnostics ignored;
  const std::optional<SceneText> opened = open_text(bytes, storage_, ignored);
  // Each character of an encoding other than UTF-8 is one byte, or the text cannot be edited.
  if (!opened || (!storage_.empty() && count_characters(storage_) != bytes.size())) {
    return;
  }
  text_ = opened->text;
  is_xml_ = opened->syntax == SceneFormat::xml;
  lines_.push_back(0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    const bool cr_lf = text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n';
    if (text_[i] == '\n' || (text_[i] == '\r' && !cr_lf)) {
      lines_.push_back(i + 1);
    }
  }
}

std::optional<std::size_t> FileText::offset(Location location) const {
  if (location.line == 0 || location.line > lines_.size() || location.column == 0) {
    return std::nullopt;
  }
  const bool last = location.line == lines_.size();
  const std::size_t end = last ? text_.size() : lines_[location.line];
  std::size_t at = lines_[location.line - 1];
  for (std::uint32_t column = 1; column < location.column; ++column) {
    do {
      ++at;
    } while (at < end && continues_character(text_[at]));
    if (at > end) {
      return std::nullopt;
    }
  }
  return at;
}

std::uint32_t FileText::in_bytes(std::size_t offset) const {
  return static_cast<std::uint32_t>(
      storage_.empty() ? offset + static_cast<std::size_t>(text_.data() - bytes_.data())
                       : count_characters(text_.substr(0, offset)));
}

Location FileText::location(std::uint32_t at) const {
  std::size_t offset = at;
  if (storage_.empty()) {
    offset -= std::min<std::size_t>(at, static_cast<std::size_t>(text_.data() - bytes_.data()));
  } else {
    for (offset = 0; offset < text_.size() && (at != 0 || continues_character(text_[offset]));
         ++offset) {
      at -= continues_character(text_[offset]) ? 0 : 1;
    }
  }
  if (lines_.empty()) {
    return {};
  }
  const auto after = std::upper_bound(lines_.begin(), lines_.end(), offset);
  const std::size_t start = *(after - 1);
  return {static_cast<std::uint32_t>(after - lines_.begin()),
          static_cast<std::uint32_t>(
              count_characters(text_.substr(start, offset - std::min(start, offset))) + 1)};
}

bool FileText::to_bytes(Edit& edit) const {
  for (TextChange& change : edit.changes) {
    const bool ascii = std::all_of(change.text.begin(), change.text.end(),
                                   [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    if (!storage_.empty() && !ascii) {
      return false;
    }
    const std::uint32_t end = in_bytes(std::size_t{change.at} + change.size);
    change.at = in_bytes(change.at);
    change.size = end - change.at;
  }
  return true;
}

}  // namespace scenefile
