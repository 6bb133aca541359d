#pragma once
// Private to the io room: a file name as scenes write it.

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The parts of a written name: `\` separates like `/`, a leading `:/` (a resource of Qt) and
/// `file:` are dropped, and so is a drive letter.
struct AssetName {
  bool absolute = false;
  std::vector<std::string> parts;  ///< without empty ones and "."
};

/// Why no file can bear the name: it is empty, too long, holds a zero byte, or is a URL that is
/// not of a file. Empty: the name is fine.
std::string_view reject_name(std::string_view written);

AssetName parse_name(std::string_view written);

/// The parts from `first` on, joined by '/'.
std::string join_parts(const std::vector<std::string>& parts, std::size_t first);

/// First part of the longest ending of the name that goes nowhere up: behind the last "..".
std::size_t first_plain_part(const AssetName& name);

}  // namespace scenefile
