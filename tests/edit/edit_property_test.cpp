// Edits of the repository's scenes and fixtures, in several layouts. SCENEFILE_EDIT_SOAK names more
// files and folders, separated by colons; SCENEFILE_EDIT_SERIES says how many random series, of 40
// edits each, are tried.

#include "edit_laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace scenefile::testing {

namespace {

namespace fs = std::filesystem;

struct EditableFile {
  std::string name;
  Document document;
};

void add_text(std::vector<EditableFile>& files, const std::string& name, const std::string& text) {
  for (const bool compat : {false, true}) {
    ReadOptions options;
    options.compat_course = compat;
    if (Result<Document> document = Document::open(text, options)) {
      files.push_back({name + (compat ? " (course)" : ""), *std::move(document)});
    }
    if (name.find("course") == std::string::npos &&
        name.find("after-object") == std::string::npos) {
      break;
    }
  }
}

// The text with other line ends, and without any.
void add_layouts(std::vector<EditableFile>& files, const std::string& name,
                 const std::string& text) {
  std::string crlf;
  std::string line;
  for (const char c : text) {
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
    const bool blank =
        c == '\n' || c == '\r' ||
        ((c == ' ' || c == '\t') && !line.empty() && (line.back() == '>' || line.back() == ' '));
    line += blank ? "" : std::string(1, c);
  }
  add_text(files, name + " with CR LF", crlf);
  add_text(files, name + " in one line", line);
}

std::vector<EditableFile> files_in(const fs::path& path, bool layouts) {
  std::vector<fs::path> paths;
  if (fs::is_directory(path)) {
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
      paths.push_back(entry.path());
    }
  } else {
    paths.push_back(path);
  }
  std::sort(paths.begin(), paths.end());
  std::vector<EditableFile> files;
  for (const fs::path& file : paths) {
    if ((file.extension() != ".xml" && file.extension() != ".json") ||
        fs::file_size(file) > 300'000) {
      continue;
    }
    std::ifstream in(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    add_text(files, file.string(), text);
    if (layouts && text.find('\r') == std::string::npos) {
      add_layouts(files, file.string(), text);
    }
  }
  return files;
}

void report(const EditCounts& counts, std::size_t files) {
  std::string text = std::to_string(files) + " files:";
  for (const auto& [name, count] : counts) {
    text += " " + name + " " + std::to_string(count);
  }
  std::printf("%s\n", text.c_str());
}

fs::path source_folder() {
  return fs::path(SCENEFILE_FIXTURES).parent_path().parent_path();
}

TEST(EditProperties, HoldForFixturesAndScenes) {
  std::mt19937 chance(1);
  EditCounts counts;
  std::size_t count = 0;
  for (const char* const folder : {"scenes", "web/examples", "tests/fixtures"}) {
    for (const EditableFile& file : files_in(source_folder() / folder, true)) {
      EXPECT_EQ(check_edits(file.document, 3, chance, counts), "") << file.name;
      ++count;
    }
  }
  report(counts, count);
  EXPECT_GT(count, 600U);
  EXPECT_GT(counts["set"], 5000U);
  EXPECT_GT(counts["wrap"], 300U);
  EXPECT_GT(counts["place"], 300U);
}

TEST(EditProperties, HoldForSeries) {
  const char* const asked = std::getenv("SCENEFILE_EDIT_SERIES");
  const std::size_t most = asked == nullptr ? 120 : std::strtoul(asked, nullptr, 10);
  std::vector<EditableFile> files = files_in(source_folder() / "scenes", true);
  for (EditableFile& file : files_in(source_folder() / "tests/fixtures/commands", false)) {
    files.push_back(std::move(file));
  }
  std::erase_if(files, [](const EditableFile& f) { return f.document.text().size() >= 20'000; });
  ASSERT_GT(files.size(), 50U);
  EditCounts counts;
  for (std::size_t i = 0; i < most; ++i) {
    const EditableFile& file = files[i % files.size()];
    std::mt19937 chance(static_cast<unsigned>(i));
    ASSERT_EQ(check_series(file.document, 40, chance, counts), "") << file.name << ", series " << i;
  }
  counts["series"] = most;
  report(counts, files.size());
}

TEST(EditProperties, HoldForOtherFiles) {
  const char* const asked = std::getenv("SCENEFILE_EDIT_SOAK");
  if (asked == nullptr) {
    return;
  }
  std::mt19937 chance(2);
  EditCounts counts;
  std::size_t count = 0;
  std::istringstream folders(asked);
  for (std::string folder; std::getline(folders, folder, ':');) {
    for (const EditableFile& file : files_in(folder, true)) {
      EXPECT_EQ(check_edits(file.document, 4, chance, counts).substr(0, 3000), "") << file.name;
      ++count;
    }
  }
  report(counts, count);
}

}  // namespace

}  // namespace scenefile::testing
