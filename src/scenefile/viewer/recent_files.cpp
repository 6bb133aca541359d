#include "scenefile/viewer/recent_files.h"

#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"

#include <algorithm>
#include <sstream>

namespace scenefile::viewer {

std::vector<std::string> load_recent_files(const std::string& path) {
  constexpr std::uint64_t most = 1 << 16;
  if (path.empty() || !stamp_of(path).exists) {
    return {};
  }
  const Result<std::string> text = read_file(path, most);
  if (!text) {
    return {};
  }
  std::vector<std::string> files;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('/') || line.find('\0') != std::string::npos ||
        files.size() == max_recent_files) {
      return {};
    }
    files.push_back(line);
  }
  return files;
}

std::string add_recent_file(const std::string& path, const std::string& scene) {
  if (path.empty() || !scene.starts_with('/') || scene.find('\n') != std::string::npos) {
    return {};
  }
  std::vector<std::string> files = load_recent_files(path);
  std::erase(files, scene);
  files.insert(files.begin(), scene);
  files.resize(std::min(files.size(), max_recent_files));
  std::string text;
  for (const std::string& file : files) {
    text += file + '\n';
  }
  if (const Result<void> made = make_folder(folder_of(path)); !made) {
    return made.error().text;
  }
  return error_text(write_file(path, text));
}

}  // namespace scenefile::viewer
