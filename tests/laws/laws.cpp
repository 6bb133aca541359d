// scenefile_laws FOLDER...: tests the laws on every scene file below the folders, read both
// normally and with compat_course. Prints violations and a summary line.

#include "laws/law.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace {

using namespace scenefile;

std::vector<std::string> scene_files(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (entry.is_regular_file() && (extension == ".xml" || extension == ".json")) {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

struct Totals {
  std::size_t files = 0;
  std::size_t scenes = 0;  // counts each reading
  std::size_t broken = 0;
};

void try_file(const std::string& path, Totals& totals) {
  const Result<std::string> read = read_file(path, Limits{}.file_bytes);
  if (!read) {
    return;
  }
  const std::string& text = *read;
  laws::Breaches breaches;
  laws::try_text_laws(text, breaches);
  for (const bool compat : {false, true}) {
    totals.scenes +=
        laws::try_scene_laws(path, text, {.compat_course = compat, .limits = {}}, breaches);
  }
  ++totals.files;
  totals.broken += !breaches.empty();
  for (const std::string& breach : breaches) {
    std::puts(fmt::format("{}: {}", path, breach).c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  Totals totals;
  for (int i = 1; i < argc; ++i) {
    for (const std::string& path : scene_files(argv[i])) {
      try_file(path, totals);
    }
  }
  std::puts(fmt::format("{} files, {} readings without errors, {} files break a law", totals.files,
                        totals.scenes, totals.broken)
                .c_str());
  return totals.broken == 0 && totals.scenes != 0 ? 0 : 1;
}
