#include "scenefile/edit/text_edit.h"

#include <algorithm>

namespace scenefile {

void sort_changes(std::vector<TextChange>& changes) {
  std::stable_sort(changes.begin(), changes.end(), [](const TextChange& a, const TextChange& b) {
    return a.at != b.at ? a.at < b.at : a.size == 0 && b.size != 0;
  });
}

bool fits(const Edit& edit, std::size_t size) {
  std::size_t end = 0;
  for (const TextChange& change : edit.changes) {
    if (change.at < end || change.at > size || change.size > size - change.at) {
      return false;
    }
    end = std::size_t{change.at} + change.size;
  }
  return true;
}

std::string applied(std::string_view text, const Edit& edit) {
  std::string after;
  std::size_t end = 0;
  for (const TextChange& change : edit.changes) {
    after.append(text, end, change.at - end).append(change.text);
    end = std::size_t{change.at} + change.size;
  }
  return after.append(text, end, text.size() - end);
}

Edit inverse(std::string_view before, const Edit& edit) {
  Edit back;
  std::size_t grown = 0;  // modulo 2^64: may be negative
  for (const TextChange& change : edit.changes) {
    back.changes.push_back({static_cast<std::uint32_t>(change.at + grown),
                            static_cast<std::uint32_t>(change.text.size()),
                            std::string(before.substr(change.at, change.size))});
    grown += change.text.size() - change.size;
  }
  return back;
}

std::uint32_t moved(std::uint32_t offset, const Edit& edit) {
  std::size_t grown = 0;
  for (const TextChange& change : edit.changes) {
    if (change.at > offset) {
      break;
    }
    if (change.size > offset - change.at) {  // removed
      return static_cast<std::uint32_t>(change.at + grown + change.text.size());
    }
    grown += change.text.size() - change.size;
  }
  return static_cast<std::uint32_t>(offset + grown);
}

}  // namespace scenefile
