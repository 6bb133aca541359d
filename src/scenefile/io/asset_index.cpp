#include "scenefile/io/asset_index.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/io/asset_name.h"
#include "scenefile/io/folder.h"

#include <algorithm>
#include <set>
#include <utility>

namespace scenefile {

namespace {

std::string base_name_of(std::string_view path) {
  return std::string(path.substr(path.rfind('/') + 1));
}

// With its point; empty if there is none.
std::string_view extension_of(std::string_view name) {
  const std::size_t point = name.rfind('.');
  return point == std::string_view::npos ? std::string_view() : name.substr(point);
}

// Visits one folder: adds its files, queues its subfolders. Skips hidden entries, which hold
// version control data rather than assets. Does not follow links to folders.
bool visit(const std::pair<std::string, int>& folder, std::vector<std::string>& files,
           std::vector<std::pair<std::string, int>>& queue, std::size_t& budget) {
  bool within = true;
  visit_entries(folder.first, [&](FolderEntry& entry) {
    within = budget-- != 0;
    if (!within || is_hidden_name(entry.name)) {
      return within;
    }
    if (entry.folder && !entry.link) {
      if (folder.second + 1 < AssetIndex::max_levels) {
        queue.emplace_back(std::move(entry.path), folder.second + 1);
      }
    } else if (entry.file) {
      files.push_back(std::move(entry.path));
    }
    return true;
  });
  return within;
}

bool walk(const std::string& root, std::size_t budget, std::vector<std::string>& files) {
  std::vector<std::pair<std::string, int>> queue{{root == "/" ? "" : root, 0}};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::pair<std::string, int> folder = queue[i];
    if (!visit({folder.first + "/", folder.second}, files, queue, budget)) {
      return false;
    }
  }
  return true;
}

}  // namespace

AssetIndex::AssetIndex(const std::vector<std::string>& roots, std::size_t max_entries) {
  std::set<std::string> seen;
  for (const std::string& root : roots) {
    std::vector<std::string> files;
    if (!walk(root, max_entries, files)) {
      skipped_.push_back(root);
      continue;
    }
    for (const std::string& file : files) {
      if (seen.insert(file).second) {
        by_lower_name_[lower_case(base_name_of(file))].push_back(file);
      }
    }
  }
  for (auto& [name, paths] : by_lower_name_) {
    std::sort(paths.begin(), paths.end());
  }
}

std::vector<std::string> AssetIndex::find_similar(std::string_view base_name) const {
  // Blanks at the end would belong to the extension.
  const std::string wanted =
      lower_case(base_name.substr(0, base_name.find_last_not_of(blanks) + 1));
  const std::string_view extension = extension_of(wanted);
  std::vector<std::string_view> stems;
  for (const auto& [name, paths] : by_lower_name_) {
    if (extension_of(name) == extension) {
      stems.push_back(std::string_view(name).substr(0, name.size() - extension.size()));
    }
  }
  const std::string_view stem =
      nearest_name(std::string_view(wanted).substr(0, wanted.size() - extension.size()), stems);
  return stem.empty() ? std::vector<std::string>() : find(std::string(stem).append(extension));
}

std::vector<std::string> AssetIndex::find(std::string_view base_name) const {
  const auto found = by_lower_name_.find(lower_case(base_name));
  return found == by_lower_name_.end() ? std::vector<std::string>() : found->second;
}

}  // namespace scenefile
