#pragma once
// Internal to io: file names as written in scenes.

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The components of a written name. `\` counts as `/`. A leading `file:` is dropped.
struct AssetName {
  bool absolute = false;
  std::vector<std::string> parts;  ///< without empty ones and "."
};

/// Why no file can have this name: it is empty, too long, contains a zero byte, or is a URL other
/// than file:. Empty if the name is valid.
std::string_view reject_name(std::string_view written);

AssetName parse_name(std::string_view written);

/// The components from `first` on, joined by '/'.
std::string join_parts(const std::vector<std::string>& parts, std::size_t first);

/// The index of the first component after the last "..".
std::size_t first_plain_part(const AssetName& name);

}  // namespace scenefile
