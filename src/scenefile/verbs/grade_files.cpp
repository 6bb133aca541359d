#include "scenefile/verbs/grade_files.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"
#include "scenefile/io/archive.h"
#include "scenefile/verbs/load_file.h"

#include <algorithm>
#include <array>

namespace scenefile {

namespace {

// The bytes of the letter or digit at `i`; 0: there is none. Not a Latin letter with an accent,
// which may be written as one character, or as two, where the second is a combining one (U+0300 to
// U+036F): file systems use both forms.
std::size_t letter_at(std::string_view name, std::size_t i) {
  const CodePoint c = first_code_point(name.substr(i));
  if (c.value < 0x80) {
    const char32_t next = first_code_point(name.substr(i + 1)).value;
    const bool accented = next >= 0x300 && next <= 0x36F;
    const char letter = lower(name[i]);
    return (is_digit(letter) || (letter >= 'a' && letter <= 'z')) && !accented ? 1 : 0;
  }
  // Greek and all that follows, except Latin letters with accents, and punctuation.
  const bool letter = c.value >= 0x370 && (c.value < 0x1E00 || c.value > 0x1EFF) &&
                      (c.value < 0x2000 || c.value > 0x303F);
  return letter ? c.bytes : 0;
}

// Only letters and digits, those of ASCII in lower case.
std::string plain(std::string_view name) {
  std::string result;
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t bytes = letter_at(name, i);
    result += lower_case(name.substr(i, bytes));
    i += std::max<std::size_t>(1, bytes);
  }
  return result;
}

// Maps folder names of different layouts to a common name.
std::string meaning(std::string_view folder) {
  std::string word = plain(without_archive_ending(folder));
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

// Without what file managers add to copies: "ball (1)", "ball copy".
std::string_view without_copy_mark(std::string_view stem) {
  if (stem.ends_with(" copy")) {
    return stem.substr(0, stem.size() - 5);
  }
  const std::size_t open = stem.rfind(" (");
  const bool mark = open != std::string_view::npos && stem.ends_with(')') &&
                    stem.size() > open + 3 &&
                    stem.substr(open + 2, stem.size() - open - 3).find_first_not_of("0123456789") ==
                        std::string_view::npos;
  return mark ? stem.substr(0, open) : stem;
}

// What programs of the course add to names.
constexpr std::array<std::string_view, 5> endings_of_programs{"gen", "output", "out", "student",
                                                              "result"};

// The confidence that the names match; 0 if they do not.
int name_score(const FoundFile& reference, const FoundFile& picture) {
  if (reference.stem == picture.stem) {
    return 8;
  }
  const std::string r = plain(reference.stem);
  const std::string p = plain(picture.stem);
  if (r.empty() || p.empty()) {
    return 0;
  }
  if (r == p) {
    return 7;
  }
  for (const std::string_view ending : endings_of_programs) {
    if (p == r + std::string(ending) || r == p + std::string(ending)) {
      return 6;
    }
  }
  if (plain(without_copy_mark(picture.stem)) == r) {
    return 4;
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

// The stem's words: where each starts and ends.
std::vector<std::array<std::size_t, 2>> words_of(std::string_view stem) {
  std::vector<std::array<std::size_t, 2>> words;
  for (std::size_t i = 0; i < stem.size();) {
    const std::size_t bytes = letter_at(stem, i);
    if (bytes == 0) {
      ++i;
      continue;
    }
    if (words.empty() || words.back()[1] != i) {
      words.push_back({i, i});
    }
    i += bytes;
    words.back()[1] = i;
  }
  return words;
}

constexpr std::size_t max_words = 24;

// Whether `stem` ends with `part`, in whole words. One without letters says too little.
bool ends_with_words(std::string_view stem, std::string_view part) {
  const std::string wanted = plain(part);
  if (wanted.find_first_not_of("0123456789") == std::string::npos) {
    return false;
  }
  const auto words = words_of(stem);
  return words.size() <= max_words && plain(stem).ends_with(wanted) &&
         std::any_of(words.begin(), words.end(),
                     [&](const auto& w) { return plain(stem.substr(w[0])) == wanted; });
}

// Whether `stem` contains `part`, in whole words.
bool contains_words(std::string_view stem, std::string_view part) {
  const auto words = words_of(stem);
  return words.size() <= max_words && plain(stem).find(plain(part)) != std::string::npos &&
         std::any_of(words.begin(), words.end(),
                     [&](const auto& w) { return ends_with_words(stem.substr(0, w[1]), part); });
}

// Without "_gen" and the like at the end.
std::string_view without_added_word(std::string_view stem) {
  for (const std::string_view ending : endings_of_programs) {
    const std::size_t start = stem.size() - std::min(stem.size(), ending.size());
    if (start <= 1 || lower_case(stem.substr(start)) != ending) {
      continue;
    }
    if (const auto words = words_of(stem.substr(0, start));
        words.empty() || words.back()[1] < start) {
      return stem.substr(0, start - 1);
    }
  }
  return stem;
}

// The references that a picture fits by a part of a name; `score` says how well. Several: unclear.
std::vector<std::size_t> fitting(const std::vector<FoundFile>& references, const FoundFile& picture,
                                 int& score) {
  std::vector<std::size_t> found;
  if (is_in_texture_folder(picture)) {
    return found;
  }
  const std::string_view stem = without_added_word(without_copy_mark(picture.stem));
  // As it is, or without what was added.
  for (const std::string_view name : {std::string_view(picture.stem), stem}) {
    score = name == picture.stem ? 3 : 2;
    for (std::size_t r = 0; r < references.size(); ++r) {
      if (ends_with_words(references[r].stem, name)) {
        found.push_back(r);
      }
    }
    if (!found.empty()) {
      return found;
    }
  }
  score = 1;
  std::size_t longest = 0;
  for (std::size_t r = 0; r < references.size(); ++r) {
    if (contains_words(picture.stem, references[r].stem)) {
      found.push_back(r);
      longest = std::max(longest, plain(references[r].stem).size());
    }
  }
  const auto is_longest = [&](std::size_t r) {
    return plain(references[r].stem).size() == longest;
  };
  const auto best = std::find_if(found.begin(), found.end(), is_longest);
  if (best == found.end()) {
    return found;
  }
  // Shorter names in the longest one are not a second choice.
  const std::string_view whole = references[*best].stem;
  std::vector<std::size_t> others;
  std::copy_if(found.begin(), found.end(), std::back_inserter(others), [&](std::size_t r) {
    return is_longest(r) || !contains_words(whole, references[r].stem);
  });
  return others;
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

FoundFile found_file(const std::string& folder, const std::string& path) {
  FoundFile file{path, {}, {}};
  // "." is not part of the paths below it.
  std::string_view rest(path);
  rest.remove_prefix(folder == "." ? 0 : folder.size());
  rest.remove_prefix(std::min(rest.find_first_not_of('/'), rest.size()));
  for (std::size_t slash = rest.find('/'); slash != std::string_view::npos;
       slash = rest.find('/')) {
    file.folders.emplace_back(rest.substr(0, slash));
    rest.remove_prefix(slash + 1);
  }
  file.stem = rest.substr(0, rest.size() - ending_of(rest).size());
  return file;
}

std::string ending_of(std::string_view name) {
  const std::size_t point = name.rfind('.');
  return point == std::string_view::npos ? std::string() : lower_case(name.substr(point));
}

std::string file_name(const FoundFile& file) {
  const std::string& path = file.entries.empty() ? file.path : file.entries.back();
  return path.substr(path.rfind('/') + 1);
}

std::string path_below(const FoundFile& file) {
  std::string path;
  for (const std::string& folder : file.folders) {
    path += folder + "/";
  }
  return path + file_name(file);
}

namespace {

std::string trimmed(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r");
  const std::size_t end = text.find_last_not_of(" \t\r");
  return start == std::string_view::npos ? std::string()
                                         : std::string(text.substr(start, end - start + 1));
}

// The fields of a line of CSV (RFC 4180), or of a line with tabs.
std::vector<std::string> fields_of(std::string_view line) {
  const char separator = line.find('\t') != std::string_view::npos ? '\t' : ',';
  std::vector<std::string> fields;
  for (bool more = true; more;) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    std::string field;
    std::size_t at = 0;
    if (line.starts_with('"')) {
      for (at = 1; at < line.size() && (line[at] != '"' || line.substr(at, 2) == "\"\""); ++at) {
        at += line[at] == '"' ? 1 : 0;
        field += line[at];
      }
    }
    const std::size_t end = std::min(line.find(separator, at), line.size());
    fields.push_back(at > 0 ? field : trimmed(line.substr(0, end)));
    more = end < line.size();
    line.remove_prefix(more ? end + 1 : end);
  }
  return fields;
}

}  // namespace

bool is_named(const FoundFile& file, const std::string& name) {
  std::string folders;
  for (const std::string& folder : file.folders) {
    folders += folder + "/";
  }
  const std::string wanted = lower_case(name);
  const auto ends = [&](const std::string& path) {
    const std::string whole = lower_case(path);
    return whole == wanted || whole.ends_with("/" + wanted);
  };
  const std::string written = file_name(file);
  return ends(folders + file.stem) || ends(folders + file.stem + ending_of(written)) ||
         ends(folders + written);
}

std::vector<NamePair> read_name_map(std::string_view text, std::string& wrong) {
  text = without_byte_order_mark(text);
  std::vector<NamePair> map;
  std::size_t number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string line = trimmed(text.substr(start, end - start));
    start = end + 1;
    ++number;
    if (line.empty() || line.front() == '#') {
      continue;
    }
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() != 2 || fields[0].empty() || fields[1].empty()) {
      wrong = "line " + std::to_string(number) +
              ": expected the name handed in, a comma, and the name of the reference" +
              (fields.size() > 2 ? "; put names that contain a comma in double quotes" : "");
      return {};
    }
    map.push_back({fields[0], fields[1]});
  }
  return map;
}

std::ptrdiff_t format_rank(const FoundFile& file) {
  std::vector<PictureFormat> formats = picture_formats();
  std::stable_partition(formats.begin(), formats.end(), [](const PictureFormat& format) {
    return format.name != "JPEG" && format.name != "GIF";
  });
  const std::string ending = ending_of(file_name(file));
  return std::find_if(formats.begin(), formats.end(),
                      [&](const PictureFormat& format) {
                        return format.extensions.find(ending) != std::string_view::npos;
                      }) -
         formats.begin();
}

PictureMatches match_pictures(const std::vector<FoundFile>& references,
                              const std::vector<FoundFile>& pictures,
                              const std::vector<NamePair>& map) {
  struct Pair {
    int score;
    std::ptrdiff_t format;
    std::size_t reference;
    std::size_t picture;
  };
  std::vector<Pair> pairs;
  std::vector<std::vector<std::size_t>> several(pictures.size());
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    const auto depth = static_cast<int>(pictures[p].folders.size());
    const std::ptrdiff_t format = format_rank(pictures[p]);
    bool named = false;
    for (std::size_t r = 0; r < references.size(); ++r) {
      if (const int name = name_score(references[r], pictures[p]); name > 0) {
        const int folders = folder_score(references[r], pictures[p]);
        pairs.push_back({100 * folders + 10 * name - depth, format, r, p});
        named = true;
      }
    }
    if (!named) {
      int name = 0;
      std::vector<std::size_t> fits = fitting(references, pictures[p], name);
      if (fits.size() == 1) {
        // Never better than a whole name.
        pairs.push_back({10 * name - depth - 100, format, fits.front(), p});
      } else {
        several[p] = std::move(fits);
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.score != b.score ? a.score > b.score : a.format < b.format;
  });
  PictureMatches matches;
  std::vector<int>& result = matches.pictures;
  result.assign(references.size(), -1);
  std::vector<bool> taken(pictures.size());
  for (const NamePair& named : map) {
    for (std::size_t r = 0; r < references.size(); ++r) {
      for (std::size_t p = 0; p < pictures.size(); ++p) {
        if (result[r] < 0 && !taken[p] && is_named(references[r], named.reference) &&
            is_named(pictures[p], named.handed_in)) {
          result[r] = static_cast<int>(p);
          taken[p] = true;
        }
      }
    }
  }
  for (const Pair& pair : pairs) {
    if (result[pair.reference] < 0 && !taken[pair.picture]) {
      result[pair.reference] = static_cast<int>(pair.picture);
      taken[pair.picture] = true;
    }
  }
  std::vector<int> best_reference(pictures.size(), -1);
  for (const Pair& pair : pairs) {
    int& best = best_reference[pair.picture];
    best = best < 0 ? static_cast<int>(pair.reference) : best;
  }
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    if (!taken[p]) {
      matches.unused.push_back({p, best_reference[p], std::move(several[p])});
    }
  }
  return matches;
}

int best_named(const FoundFile& file, const std::vector<FoundFile>& files) {
  int best = -1;
  int best_score = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (const int name = name_score(file, files[i]); name > 0) {
      const int score = 100 * folder_score(file, files[i]) + 10 * name -
                        static_cast<int>(files[i].folders.size());
      if (best < 0 || score > best_score) {
        best = static_cast<int>(i);
        best_score = score;
      }
    }
  }
  return best;
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
  static constexpr std::array<std::string_view, 14> words{
      "illuminate", "intersect", "required", "optional", "output",       "outputs", "images",
      "image",      "results",   "render",   "renders",  "lightscamera", "action",  "realtime"};
  const std::string word = meaning(name);
  // Of the empty ones only that of student_outputs.
  return word.empty() ? !plain(name).empty()
                      : std::find(words.begin(), words.end(), word) != words.end();
}

bool is_in_texture_folder(const FoundFile& file) {
  return std::any_of(file.folders.begin(), file.folders.end(), [](const std::string& name) {
    return name == "textures" || name == "texture" || name == "image";
  });
}

}  // namespace scenefile
