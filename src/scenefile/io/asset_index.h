#pragma once
// Internal to io: an index of files in some folders, by base name.

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A bounded walk through the roots. A root with more entries than allowed is left out completely:
/// a partial walk cannot prove that a name is unique, and would depend on the order of directory
/// entries.
class AssetIndex {
 public:
  static constexpr int max_levels = 4;

  AssetIndex(const std::vector<std::string>& roots, std::size_t max_entries);

  /// Paths of files with this base name, ignoring case.
  std::vector<std::string> find(std::string_view base_name) const;
  /// Paths of the files whose name, with this extension, is most like this one; empty if none is.
  std::vector<std::string> find_similar(std::string_view base_name) const;
  /// Roots that were too large to search.
  const std::vector<std::string>& skipped() const { return skipped_; }

 private:
  std::map<std::string, std::vector<std::string>, std::less<>> by_lower_name_;
  std::vector<std::string> skipped_;
};

}  // namespace scenefile
