#include "scenefile/io/asset_name.h"

#include "scenefile/base/text.h"

#include <algorithm>
#include <iterator>

namespace scenefile {

namespace {

constexpr std::size_t max_name_bytes = 4095;  // PATH_MAX of Linux
constexpr std::string_view file_scheme = "file:";

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Length of "http" in "http://..." or "data" in "data:..."; 0 if this is not a URL.
std::size_t scheme_length(std::string_view text) {
  const auto* const end = std::find_if_not(text.begin(), text.end(), [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
  });
  const auto length = static_cast<std::size_t>(end - text.begin());
  if (length < 2 || length == text.size() || text[length] != ':' || !is_letter(text[0])) {
    return 0;
  }
  const std::string scheme = lower_case(text.substr(0, length));
  const bool slashes = text.substr(length + 1).starts_with("//");
  return slashes || scheme == "data" || scheme == "file" ? length : 0;
}

}  // namespace

std::string_view reject_name(std::string_view written) {
  if (written.empty()) {
    return "the file name is empty";
  }
  if (written.size() > max_name_bytes) {
    return "the file name is longer than any path can be";
  }
  if (written.find('\0') != std::string_view::npos) {
    return "the file name contains a zero byte";
  }
  const std::size_t scheme = scheme_length(written);
  if (scheme != 0 && lower_case(written.substr(0, scheme)) != "file") {
    return "it is a URL, and only files are read";
  }
  return {};
}

AssetName parse_name(std::string_view written) {
  std::string text(written.substr(scheme_length(written) == 0 ? 0 : file_scheme.size()));
  std::replace(text.begin(), text.end(), '\\', '/');
  AssetName name;
  name.absolute = text.starts_with('/');
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('/', at), text.size());
    std::string part = text.substr(at, end - at);
    if (!part.empty() && part != ".") {
      name.parts.push_back(std::move(part));
    }
    at = end + 1;
  }
  return name;
}

std::string join_parts(const std::vector<std::string>& parts, std::size_t first) {
  std::string result;
  for (std::size_t i = first; i < parts.size(); ++i) {
    result += (i == first ? "" : "/") + parts[i];
  }
  return result;
}

std::size_t first_plain_part(const AssetName& name) {
  const auto last_up = std::find(name.parts.rbegin(), name.parts.rend(), "..");
  return static_cast<std::size_t>(std::distance(last_up, name.parts.rend()));
}

}  // namespace scenefile
