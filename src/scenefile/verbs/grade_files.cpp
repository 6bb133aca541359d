#include "scenefile/verbs/grade_files.h"

#include "scenefile/base/text.h"
#include "scenefile/verbs/load_file.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace scenefile {

namespace {

constexpr std::size_t most_files = 20000;
constexpr int most_folders = 8;

// Only letters and digits, small.
std::string plain(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return result;
}

// Folders that mean the same in layouts in use.
std::string meaning(std::string_view folder) {
  std::string word = plain(folder);
  static constexpr std::array<std::array<std::string_view, 2>, 12> same{
      {{"light", "illuminate"},
       {"lights", "illuminate"},
       {"lighting", "illuminate"},
       {"illumination", "illuminate"},
       {"intersection", "intersect"},
       {"ray", "intersect"},
       {"requiredoutputs", "required"},
       {"optionaloutputs", "optional"},
       {"extracredit", "optional"},
       {"extra", "optional"},
       {"extracreditoutputs", "optional"},
       {"studentoutputs", ""}}};
  for (const auto& [from, to] : same) {
    if (word == from) {
      return std::string(to);
    }
  }
  return word;
}

// The part of a file name from its last point on, in lower case; empty without one.
std::string ending_of(std::string_view name) {
  const std::size_t point = name.rfind('.');
  return point == std::string_view::npos ? std::string() : lower_case(name.substr(point));
}

void add_files(const std::string& folder, const std::vector<std::string_view>& endings,
               const std::vector<std::string>& above, std::vector<FoundFile>& files) {
  for (const FolderEntry& entry : entries_of(folder)) {
    if (files.size() >= most_files) {
      return;
    }
    if (entry.folder && !entry.link) {
      if (above.size() < most_folders) {
        std::vector<std::string> inside = above;
        inside.push_back(entry.name);
        add_files(entry.path, endings, inside, files);
      }
      continue;
    }
    const std::string ending = ending_of(entry.name);
    if (std::find(endings.begin(), endings.end(), ending) != endings.end()) {
      files.push_back({entry.path, above, entry.name.substr(0, entry.name.size() - ending.size())});
    }
  }
}

// How surely the names mean the same; 0: they do not.
int name_score(const FoundFile& reference, const FoundFile& picture) {
  if (reference.stem == picture.stem) {
    return 8;
  }
  const std::string r = plain(reference.stem);
  const std::string p = plain(picture.stem);
  if (r == p) {
    return 7;
  }
  for (const char* ending : {"gen", "output", "out", "student", "result"}) {
    if (p == r + ending || r == p + ending) {
      return 6;
    }
  }
  for (const std::string& folder : reference.folders) {
    if (p == plain(folder) + r) {
      return 5;
    }
  }
  for (const std::string& folder : picture.folders) {
    if (r == plain(folder) + p) {
      return 5;
    }
  }
  return 0;
}

int folder_score(const FoundFile& reference, const FoundFile& picture) {
  int score = 0;
  for (const std::string& folder : reference.folders) {
    const std::string word = meaning(folder);
    score += !word.empty() && std::any_of(picture.folders.begin(), picture.folders.end(),
                                          [&](const std::string& f) { return meaning(f) == word; })
                 ? 1
                 : 0;
  }
  return score;
}

}  // namespace

std::vector<FoundFile> files_below(const std::string& folder,
                                   const std::vector<std::string_view>& endings) {
  std::vector<FoundFile> files;
  add_files(folder, endings, {}, files);
  return files;
}

std::vector<int> match_pictures(const std::vector<FoundFile>& references,
                                const std::vector<FoundFile>& pictures) {
  struct Pair {
    int score;
    std::size_t reference;
    std::size_t picture;
  };
  std::vector<Pair> pairs;
  for (std::size_t r = 0; r < references.size(); ++r) {
    for (std::size_t p = 0; p < pictures.size(); ++p) {
      if (const int name = name_score(references[r], pictures[p]); name > 0) {
        const int folders = folder_score(references[r], pictures[p]);
        pairs.push_back(
            {100 * folders + 10 * name - static_cast<int>(pictures[p].folders.size()), r, p});
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.score > b.score; });
  std::vector<int> result(references.size(), -1);
  std::vector<bool> taken(pictures.size());
  for (const Pair& pair : pairs) {
    if (result[pair.reference] < 0 && !taken[pair.picture]) {
      result[pair.reference] = static_cast<int>(pair.picture);
      taken[pair.picture] = true;
    }
  }
  return result;
}

std::vector<std::string> reference_names(const std::vector<FoundFile>& references) {
  std::map<std::string, int> count;
  for (const FoundFile& file : references) {
    ++count[file.stem];
  }
  std::vector<std::string> names;
  for (const FoundFile& file : references) {
    std::string name;
    if (count[file.stem] > 1) {
      for (const std::string& folder : file.folders) {
        name += folder + "/";
      }
    }
    names.push_back(name + file.stem);
  }
  return names;
}

bool is_layout_folder(std::string_view name) {
  static constexpr std::array<std::string_view, 12> words{
      "illuminate", "intersect", "required", "optional", "output",  "outputs",
      "images",     "image",     "results",  "render",   "renders", "lightscamera"};
  const std::string word = meaning(name);
  return word.empty() || std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace scenefile
